#!/usr/bin/env bash
# OVITO 3.17.2 exports tilted cells to GSD with another box: it writes the lengths of the vectors as Lx,
# Ly, Lz, where GSD (HOOMD-blue's box) has b = (xy Ly, Ly, 0), c = (xz Lz, yz Lz, Lz). OVITO itself then
# reads a cell of another volume back. Cells along the axes are right. Fails when that changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"${PYTHON:-python3}" -m venv venv
venv/bin/pip install -q ovito==3.17.2 gsd==5.0.1
cat >run.py <<'PY'
import gsd.hoomd
import numpy as np
import ovito
from ovito.data import DataCollection
from ovito.io import export_file, import_file

cell = np.array([[4, 0.5, 0.75], [0, 5, 1], [0, 0, 6.0]])  # columns: vectors a, b, c
data = DataCollection()
particles = data.create_particles(count=1)
particles.create_property("Position", data=[[0.4, 2.4, 0]])
data.create_cell(np.column_stack([cell, cell @ np.full(3, -0.5)]), pbc=(True, True, True))
export_file(data, "out.gsd", "gsd/hoomd")
with gsd.hoomd.open("out.gsd") as file:
    print(ovito.version_string, "box:", np.round(file[0].configuration.box.astype(float), 4).tolist())
print("expected box: [4, 5, 6, 0.1, 0.125, 0.1667], volume", round(np.linalg.det(cell), 4))
read = import_file("out.gsd").compute().cell[:, :3]
print("read back by OVITO:", np.round(read, 4).tolist(), "volume", round(float(np.linalg.det(read)), 4))
PY
venv/bin/python run.py >seen
cat seen
diff seen - <<'SEEN'
3.17.2 box: [4.0, 5.0249, 6.1288, 0.0995, 0.1224, 0.1632]
expected box: [4, 5, 6, 0.1, 0.125, 0.1667], volume 120.0
read back by OVITO: [[4.0, 0.5, 0.75], [0.0, 5.0249, 1.0], [0.0, 0.0, 6.1288]] volume 123.1879
SEEN
