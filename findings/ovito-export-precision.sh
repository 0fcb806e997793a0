#!/usr/bin/env bash
# OVITO 3.17.2, export_file(precision=…): numbers of properties in single precision (Radius, or any
# float32 property) get WORSE with a higher precision, and one digit may be lost: with precision=12 a
# radius of 0.1 is written as 0.99999997952. precision=8 is right; the default of 10 writes 1.75 as
# 1.7500000256. Double precision properties (Position, Mass) are written correctly.
# Fails when that changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"${PYTHON:-python3}" -m venv venv
venv/bin/pip install -q ovito==3.17.2
cat >run.py <<'PY'
import ovito
from ovito.data import DataCollection
from ovito.io import export_file

data = DataCollection()
particles = data.create_particles(count=4)
particles.create_property("Position", data=[[0.1, 0, 0], [0.5, 0, 0], [1.75, 0, 0], [0.25, 0, 0]])
particles.create_property("Radius", data=[0.1, 0.5, 1.75, 0.25])
print(ovito.version_string, particles["Radius"].dtype)
for precision in (8, 10, 12, 17):
    export_file(data, "out.xyz", "xyz", columns=["Position.X", "Radius"], precision=precision)
    print(precision, *open("out.xyz").read().splitlines()[2:], sep=" | ")
PY
venv/bin/python run.py >seen
cat seen
diff seen - <<'SEEN'
3.17.2 float32
8 | 0.1 0.1 | 0.5 0.5 | 1.75 1.75 | 0.25 0.25
10 | 0.1 0.1 | 0.5 0.5 | 1.75 1.7500000256 | 0.25 0.25
12 | 0.1 0.99999997952 | 0.5 0.499999997952 | 1.75 1.750000013312 | 0.25 0.249999998976
17 | 0.1 0.10000000272564224 | 0.5 0.49999999215337472 | 1.75 1.74999998823006208 | 0.25 0.24999999607668736
SEEN
