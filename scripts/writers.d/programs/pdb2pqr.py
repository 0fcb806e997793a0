"""PDB2PQR: PQR files of a short peptide and a water whose coordinates touch."""

from __future__ import annotations

from typing import TYPE_CHECKING

from truth import Written, table

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

# Four alanines with ideal bonds, far along x.
PEPTIDE = """\
ATOM   9991  N   ALA A   1    1000.000  10.000  10.000  1.00 20.00           N
ATOM   9992  CA  ALA A   1    1001.458  10.000  10.000  1.00 20.00           C
ATOM   9993  C   ALA A   1    1002.008  11.420  10.000  1.00 20.00           C
ATOM   9994  O   ALA A   1    1002.908  11.741  10.776  1.00 20.00           O
ATOM   9995  CB  ALA A   1    1001.990   9.230   8.790  1.00 20.00           C
ATOM   9996  N   ALA A   2    1001.467  12.268   9.131  1.00 20.00           N
ATOM   9997  CA  ALA A   2    1001.909  13.654   9.036  1.00 20.00           C
ATOM   9998  C   ALA A   2    1001.777  14.363  10.380  1.00 20.00           C
ATOM   9999  O   ALA A   2    1002.703  15.043  10.821  1.00 20.00           O
ATOM  10000  CB  ALA A   2    1001.107  14.399   7.967  1.00 20.00           C
ATOM  10001  N   ALA A   3    1000.627  14.202  11.026  1.00 20.00           N
ATOM  10002  CA  ALA A   3    1000.381  14.830  12.319  1.00 20.00           C
ATOM  10003  C   ALA A   3    1001.441  14.420  13.336  1.00 20.00           C
ATOM  10004  O   ALA A   3    1001.988  15.265  14.044  1.00 20.00           O
ATOM  10005  CB  ALA A   3     998.988  14.463  12.835  1.00 20.00           C
ATOM  10006  N   ALA A   4    1001.728  13.124  13.407  1.00 20.00           N
ATOM  10007  CA  ALA A   4    1002.723  12.609  14.340  1.00 20.00           C
ATOM  10008  C   ALA A   4    1004.076  13.279  14.120  1.00 20.00           C
ATOM  10009  O   ALA A   4    1004.721  13.711  15.075  1.00 20.00           O
ATOM  10010  CB  ALA A   4    1002.858  11.092  14.195  1.00 20.00           C
ATOM  10011  OXT ALA A   4    1004.483  13.363  12.941  1.00 20.00           O
HETATM99999  O   HOH A1001    -999.125-100.250-103.125  1.00 20.00           O
END
"""
# The columns of x, y and z in PDB files, which PQR files without --whitespace keep.
_COLUMNS = ((30, 38), (38, 46), (46, 54))


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    (folder / "in.pdb").write_text(PEPTIDE)
    runs = {
        "parse.pqr": ["--ff=PARSE", "--keep-chain"],
        "amber.pqr": ["--ff=AMBER"],
        "blanks.pqr": ["--ff=PARSE", "--whitespace"],
    }
    for name, options in runs.items():
        installed.run_python(_SCRIPT, folder, *options, "in.pdb", name)
    version = installed.run_python("import pdb2pqr; print(pdb2pqr.__version__)", folder).split()[-1]
    files = []
    for name in runs:
        atoms = [
            line
            for line in (folder / name).read_text().splitlines()
            if line.startswith(("ATOM", "HETATM"))
        ]
        if name == "blanks.pqr":
            rows = [line.split()[-5:] for line in atoms]
        else:
            rows = [[*(line[a:b] for a, b in _COLUMNS), *line[54:].split()] for line in atoms]
        files.append(Written(name, [table(rows, "x y z q r")]))
    return version, files


_SCRIPT = "from pdb2pqr.main import main; main()"
