#!/usr/bin/env bash
# Open Babel 3.1.1, writing PDB or PQR: if a coordinate is below -999 the whole molecule is moved, without
# a word, so that the lowest becomes -900, although PDB's columns hold -999.999; and the molecule in memory
# stays moved, so what is written next in any format is moved, too. Fails when that changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"${PYTHON:-python3}" -m venv venv
venv/bin/pip install -q openbabel-wheel==3.1.1.23
cat >run.py <<'PY'
from openbabel import pybel
for x in (-999.0, -999.125, -1234.5):
    molecule = pybel.readstring("xyz", f"2\n\nN {x} 0 0\nC 5 0 0\n")
    before = molecule.atoms[0].coords[0], molecule.atoms[1].coords[0]
    written = [l[30:38].strip() for l in molecule.write("pqr").splitlines() if l.startswith("HETATM")]
    print(*before, "->", *written, "in memory:", molecule.atoms[0].coords[0], molecule.atoms[1].coords[0])
PY
venv/bin/python run.py >seen
cat seen
diff seen - <<'SEEN'
-999.0 5.0 -> -999.000 5.000 in memory: -999.0 5.0
-999.125 5.0 -> -900.000 104.125 in memory: -900.0 104.125
-1234.5 5.0 -> -900.000 339.500 in memory: -900.0 339.5
SEEN
