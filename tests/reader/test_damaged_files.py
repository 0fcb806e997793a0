"""Files of which any one byte is another: no sphere and no step goes without a word."""

import pytest
from whole_files import (
    ATOM,
    ATOMS,
    DOCK,
    DUMP,
    GEO,
    HOLE,
    LAMMPS,
    LATER,
    MDPA,
    TREE,
    VELOCITIES,
    WHOLE,
)

# Where # begins a comment, the row behind it is one.
WITH_COMMENTS = {
    *("table", "csv", "csv of ParaView", "Voronota", "MSMS", "Voro++", "SWC", "YADE", "IMD"),
    *("YADE, SpherePack", "PQR between blanks"),
}
# A row that has lost the line end before it is a part of the comment or remark there.
AFTER_COMMENTS = {"SWC", "IMD", "PQR in columns"}


@pytest.mark.parametrize("case", WHOLE)
@pytest.mark.parametrize("new", "7x \n#", ids=["digit", "letter", "blank", "lf", "hash"])
def test_any_byte_is_another(read_steps, reader_for, tmp_path, case, new):
    name, text, options = WHOLE[case]
    path = tmp_path / name

    def read_all():
        times, steps = read_steps(path, **options)
        if not times:
            reader = reader_for(path, **options)
            reader.AddObserver("ErrorEvent", lambda *_: None)
            reader.Update()
            steps = [reader.GetErrorMessage() or reader.GetOutput()]
        return steps

    path.write_text(text)
    whole = sum(packing.GetNumberOfPoints() for packing in read_all())
    for at in range(len(text)):
        path.write_text(text[:at] + new + text[at + 1 :])
        steps = read_all()
        if any(isinstance(step, str) for step in steps):
            continue
        begin = text.rfind("\n", 0, at) + 1
        is_comment = case in WITH_COMMENTS and new == "#"
        is_after = case in AFTER_COMMENTS and text[at] == "\n" and text[begin] in "#R"
        if not is_comment and not is_after:
            found = sum(step.GetNumberOfPoints() for step in steps)
            assert found >= whole, (at, text[max(0, at - 20) : at + 20])


BAD = {
    # A title of a later or the first step.
    "step": (
        "p.dump",
        DUMP + LATER.replace("TIMESTEP", "TIMESTEQ"),
        17,
        "'ITEM: TIMESTEQ' where a",
    ),
    "no colon": ("p.dump", DUMP + LATER.replace("ITEM: TIMES", "ITEN: TIMES"), 19, "'ITEM: NUMBER"),
    "first step": (
        "p.dump",
        DUMP.replace("ITEM: TIMES", "ITEN: TIMES") + LATER,
        7,
        "'ITEM: NUMBER OF ATOMS' where a step begins",
    ),
    "atoms twice": ("p.dump", DUMP + DUMP[DUMP.find("ITEM: ATOMS") :], 16, "'ITEM: ATOMS id type"),
    "a title after the atoms": ("p.dump", DUMP + "ITEM: WALLS\n1\n", 16, "'ITEM: WALLS' where"),
    "nan": ("p.dump", DUMP.replace("\n100\n", "\nnan\n"), 6, "'nan'"),
    "infinite": ("p.dump", DUMP.replace("\n100\n", "\n1e400\n"), 6, "'1e400'"),
    "two numbers": ("p.dump", DUMP.replace("\n100\n", "\n5 6\n"), 6, "'5 6'"),
    "time nan": ("p.dump", DUMP.replace("\n0.125\n", "\nnan\n"), 4, "'nan'"),
    "two times": ("p.dump", DUMP.replace("\n0.125\n", "\n5 6\n"), 4, "'5 6'"),
    # Records of atoms.
    **{
        f"record {name!r}": (
            "p.pqr",
            ATOMS[: len(ATOM)] + name + ATOMS[len(ATOM) + 6 :],
            2,
            name.strip()[:2],
        )
        for name in ("AT0M  ", "xETATM", "AT OM ", "HET TM", "HET7TM")
    },
    "whole numbers": ("p.pqr", "ATOM 1 N A 1 1 2 3 0 1\nATAM 2 N A 1 1 2 3 0 2\n", 2, "'ATAM 2"),
    "before an element": (
        "p.pqr",
        "ATOM 1 N A 1 1 2 3 0 1 N\nATAM 2 N A 1 1 2 3 0 2 N\n",
        2,
        "'ATAM",
    ),
    "after TER": ("p.pqr", ATOMS + "TER7" + ATOMS, 4, "'TER7ATOM"),
    # Titles of clusters and blocks, rows that have lost their line end.
    "DOCK": ("p.sph", DOCK.replace("cluster ", "cluxter ", 1), 4, "'7   1.25000"),
    "HOLE": ("p.sph", HOLE.replace("ATOM", "ATxM", 1), 1, "'ATxM"),
    "HOLE, two rows": ("p.sph", HOLE.replace("\n", " ", 1), 1, "QSS SPH S   0"),
    "LAMMPS": ("p.data", LAMMPS + VELOCITIES.replace("Velo", "Vela"), 14, "'Velacities'"),
    "Kratos, RADIUS": (
        "p.mdpa",
        MDPA.replace("RADIUS", "RADIUZ", 1),
        13,
        "'Begin NodalData RADIUZ'",
    ),
    "Kratos, Nodes": ("p.mdpa", MDPA.replace("Begin Nodes", "Begin Nodez", 1), 5, "'Begin Nodez'"),
    "Kratos, a node": ("p.mdpa", MDPA.replace("2 0 0.427\n", ""), 11, "particle at node 2"),
    "YADE": ("p.txt", "#format x_y_z_r 1 2 3 4\n5 6 7 8\n", 1, "'#format x_y_z_r 1 2"),
    "YADE, cell": ("p.txt", "##PERIODIC:: 1 2 3#1 2 3 4\n5 6 7 8\n", 1, "three edges"),
}


@pytest.mark.parametrize("case", BAD)
def test_the_line_of_the_damage(read_error, tmp_path, case):
    name, text, line, found = BAD[case]
    (tmp_path / name).write_text(text)
    message, _ = read_error(tmp_path / name)
    assert message.startswith(f"{tmp_path / name}, line {line}: ")
    assert found in message


@pytest.mark.parametrize("name", ["ATOM", "atom", " ATOM", "ATOm", "  hetatm"])
def test_records_in_any_letter_case_and_indented(read_text, name):
    text = "ATOM 1 N GLY 1 1 2 3 0.5 1\n" + name + " 2 N GLY 1 4 5 6 0.5 2\n"
    assert read_text(text, "p.pqr")["radius"].tolist() == [1, 2]


LEVELS = WHOLE["cellPACK"][1]
BLANKS = WHOLE["medial axis without letters"][1]
STEP = WHOLE["MercuryDPM"][1]
SPHERE = DOCK.splitlines(True)[3]
# A text with one count and where it stands, and a row.
COUNTED = {
    "dump": ("p.dump", DUMP, "\n{}\nITEM: BOX", 2, "1 1 1.25 2.25 3.25 0.339\n"),
    "extended XYZ": ("p.xyz", WHOLE["extended XYZ"][1], "{}\nProp", 2, "A 1.25 2.25 3.25 0.339\n"),
    "LAMMPS data": ("p.data", LAMMPS, "{} atoms", 2, "1 1 0.875 2.5 1.25 2.25 3.255\n"),
    "cellPACK": ("p.sph", LEVELS, "{}\n1.25 2.25 3.25 0.39", 2, "1.25 2.25 3.25 0.39\n"),
    "cellPACK, levels": ("p.sph", LEVELS, "{}\n# n\n", 2, None),
    "tree of the toolkit": ("p.sph", TREE, "{} 2\n", 2, "0.5 0 0 0.625 0.895\n"),
    "DOCK": ("p.sph", DOCK, "cluster     {}\n    7", 2, SPHERE),
    "GenGeo": ("p.geo", GEO, "Simple\n{}\n", 2, "1.25 2.25 3.25 0.339 1 7\n"),
    "medial axis": ("p.ma", WHOLE["medial axis"][1], "{} 1 0\n", 2, "v 1.25 2.25 3.25 0.339\n"),
    "medial axis without letters": (
        "p.ma",
        BLANKS,
        "{} 1 1\n",
        2,
        "1.25 2.25 3.25 0.339\n",
    ),
    "PackLSD": ("p.dat", WHOLE["PackLSD"][1], "{}\n1.5 0 0", 2, "0.25 0.25 0.25 0.339\n"),
    "PackLSD, all": ("p.dat", WHOLE["PackLSD"][1], "{} 1\n2\n", 2, None),
    "PackLSD, species": ("p.dat", WHOLE["PackLSD"][1], "2 {}\n2\n", 1, None),
    "MercuryDPM": ("p.data", STEP, "{} 0.5 ", 2, STEP.splitlines(True)[1]),
}


@pytest.mark.parametrize("case", COUNTED)
def test_counts_and_rows_that_do_not_agree(read_text, read_error, tmp_path, case):
    name, text, place, count, row = COUNTED[case]
    assert text.count(place.format(count)) == 1
    assert read_text(text, name).n_points >= 2
    bad = [text.replace(place.format(count), place.format(count + d)) for d in (-1, 1)]
    if row is not None:
        assert text.count(row) == 1
        bad += [text.replace(row, ""), text.replace(row, row + row)]
    for damaged in bad:
        (tmp_path / name).write_text(damaged)
        message, _ = read_error(tmp_path / name)
        assert message.startswith(f"{tmp_path / name}, line ")
