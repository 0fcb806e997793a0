#!/usr/bin/env bash
# MDAnalysis 2.11.0 reads tilted boxes of GSD wrong: it takes acos(xy), acos(xz), acos(yz) for alpha,
# beta, gamma and Ly, Lz for the lengths of b, c; HOOMD-blue's box has b = (xy Ly, Ly, 0),
# c = (xz Lz, yz Lz, Lz). Fails when that changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"${PYTHON:-python3}" -m venv venv
venv/bin/pip install -q MDAnalysis==2.11.0 gsd==5.0.1
cat >run.py <<'PY'
import warnings
import gsd.hoomd
import MDAnalysis
import numpy as np
from MDAnalysis.lib.mdamath import triclinic_box

warnings.simplefilter("ignore")
frame = gsd.hoomd.Frame()
frame.configuration.box = lx, ly, lz, xy, xz, yz = [4, 5, 6, 0.1, 0.2, 0.3]
frame.particles.N = 1
frame.particles.position = [[0, 0, 0]]
with gsd.hoomd.open("in.gsd", "w") as file:
    file.append(frame)
vectors = np.float32([[lx, 0, 0], [xy * ly, ly, 0], [xz * lz, yz * lz, lz]])
print(MDAnalysis.__version__, np.round(MDAnalysis.Universe("in.gsd").dimensions.astype(float), 3).tolist())
print("expected", np.round(triclinic_box(*vectors).astype(float), 3).tolist())
PY
venv/bin/python run.py >seen
cat seen
diff seen - <<'SEEN'
2.11.0 [4.0, 5.0, 6.0, 84.261, 78.463, 72.542]
expected [4.0, 5.025, 6.378, 72.57, 79.156, 84.289]
SEEN
