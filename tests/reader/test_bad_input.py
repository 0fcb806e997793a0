"""Every bad input: one message with file, line, what was found, what was expected; no output."""

import os
import struct

import numpy as np
import pytest
import pyvista as pv

NOT_FOUND, CANNOT_OPEN, END_OF_FILE, FORMAT = 20001, 20002, 20004, 20005

# name of the case: (file name, content, line, found, expected)
TEXTS = {
    "words": ("p.spheres", "hello big wide world\n", 1, "'hello big wide world'", "lines of x y z"),
    "one word": ("p.spheres", "hello\n", 1, "'hello', which is neither", "# before remarks"),
    "words later": (
        "p.spheres",
        "0 0 0 1\n\n# c\n1 2 three 4\n",
        4,
        "'three' as z in column 3",
        "a number",
    ),
    "three columns": (
        "p.spheres",
        "# c\n0 1 2\n",
        2,
        "3 columns '0 1 2'",
        "at least 4: x y z radius",
    ),
    "three columns later": (
        "p.spheres",
        "0 0 0 1\n0 1 2\n",
        2,
        "3 columns '0 1 2'",
        "4 columns: x y z radius",
    ),
    "five columns later": (
        "p.spheres",
        "0 0 0 1\n0 1 2 3 4\n",
        2,
        "5 columns '0 1 2 3 4'",
        "4 columns",
    ),
    "nan centre": (
        "p.spheres",
        "0 0 0 1\r\n0 nan 0 1\r\n",
        2,
        "'nan' as y in column 2",
        "a finite number",
    ),
    "nan radius": ("p.spheres", "0 0 0 NaN\n", 1, "'NaN' as radius in column 4", "a finite number"),
    "infinite centre": ("p.spheres", "0 0 -inf 1\n", 1, "'-inf' as z", "a finite number"),
    "infinite radius": (
        "p.spheres",
        "0 0 0 Infinity\n",
        1,
        "'Infinity' as radius",
        "a finite number",
    ),
    "too large": ("p.spheres", "0 0 0 1\n1e400 0 0 1\n", 2, "'1e400' as x", "a finite number"),
    "negative radius": (
        "p.spheres",
        "0 0 0 1\r0 0 0 -0.5\r",
        2,
        "'-0.5' as radius",
        "not negative",
    ),
    "number and letters": ("p.spheres", "0 0 0 1mm\n", 1, "'1mm' as radius", "a number"),
    "two signs": ("p.spheres", "0 +-1 0 1\n", 1, "'+-1' as y", "a number"),
    "unfinished exponent": ("p.spheres", "0 1e 0 1\n", 1, "'1e' as y", "a number"),
    "hexadecimal": ("p.spheres", "0 0x10 0 1\n", 1, "'0x10' as y", "a number"),
    "decimal commas": (
        "p.spheres",
        "0,5 1,0 -2,0 0,1\n",
        1,
        "decimal commas in '0,5 1,0 -2,0 0,1'",
        "decimal points",
    ),
    "decimal commas after semicolons": (
        "p.spheres",
        "1,5;2,5;3,5;1\n",
        1,
        "decimal commas",
        "decimal points",
    ),
    "two separators": ("p.spheres", "1,,2,3,4\n", 1, "'' as y", "a number"),
    "zero byte": ("p.spheres", "0 0 0 1\n0 0 0\0 1\n", 2, r"'0\x00' as z", "a number"),
    "long rubbish": (
        "p.spheres",
        "0 0 0 " + "9" * 5000 + "x\n",
        1,
        "'" + "9" * 40 + "...'",
        "a number",
    ),
    "utf-16, cut": (
        "p.spheres",
        "0 0 0 1\n".encode("utf-16")[:-1],
        None,
        "UTF-16 with no character at byte 17",
        "UTF-8",
    ),
    "only comments": ("p.spheres", "# nothing\n\n", None, "no sphere", "lines of x y z radius"),
    "only blanks": ("p.spheres", "\n \t\n", None, "no sphere", "lines of x y z radius"),
    "only a header": ("p.spheres", "x y z r\n", None, "no sphere", "lines of x y z radius"),
    "xyzr, three numbers": (
        "p.xyzr",
        "A N 1 2 3\n",
        1,
        "3 numeric columns 'A N 1 2 3'",
        "at least 4",
    ),
    "xyzr, text for a number": (
        "p.xyzr",
        "A 1 2 3 4\nA 1 2 B 4\n",
        2,
        "'B' as z in column 4",
        "a number",
    ),
    "yade, no radius": ("p.txt", "#format x_y_z\n1 2 3\n", 2, "#format 'x_y_z'", "x_y_z_r"),
    "yade, too few": (
        "p.txt",
        "#format x_y_z_r_matId\n1 2 3 4\n",
        2,
        "4 columns '1 2 3 4'",
        "5 columns: x y z r matId",
    ),
    "csv, no header": (
        "p.csv",
        "1,2,3,4\n",
        1,
        "'1,2,3,4'",
        "a header that names x, y, z and one of r, radius, d, diameter",
    ),
    "csv, no radius": (
        "p.csv",
        "x,y,z,mass\n1,2,3,4\n",
        1,
        "'x,y,z,mass'",
        "one of r, radius, d, diameter",
    ),
    "a header that its delimiter does not split": (
        "p.spheres",
        "x,y z;r\n1,2,3;4\n",
        1,
        "the columns 'x,y z;r'",
        "a header that names x, y, z and one of r, radius, d, diameter",
    ),
    "csv, no centre": ("p.csv", "x,y,r\n1,2,3\n", 1, "'x,y,r'", "a header that names x, y, z"),
    "csv, twice": ("p.csv", "x,y,z,r,Rad\n1,2,3,4,5\n", 1, "'r' and 'Rad'", "each name once"),
    "csv, array twice": ("p.csv", "x,y,z,r,m,m\n1,2,3,4,5,6\n", 1, "'m' and 'm'", "each name once"),
    "csv, empty value": (
        "p.csv",
        "x,y,z,r\n1,2,3,4\n1,,3,4\n",
        3,
        "'' as y in column 2",
        "a number",
    ),
    "csv, empty radius": ("p.csv", "x,y,z,r\n1,2,3,\n", 2, "'' as radius in column 4", "a number"),
    "csv, too few": ("p.csv", "x,y,z,r\n1,2,3\n", 2, "3 columns '1,2,3'", "4 columns: x y z r"),
    "csv, too many": (
        "p.csv",
        "x,y,z,r\n1,2,3,4,5\n",
        1,
        "the 4 names 'x,y,z,r' over rows of 5 columns",
        "a name for each column",
    ),
    "csv, decimal commas": ("p.csv", "x;y;z;r\n1,5;2;3;4\n", 2, "'1,5' as x", "a number"),
    "csv, two in one": ("p.csv", "x,y,z,r\n1 2,3,4,5\n", 2, "'1 2' as x", "a number"),
    "csv, open quote": ("p.csv", 'x,y,z,r\n1,2,3,"4\n', 2, "'\"4' as radius", "a number"),
    "csv, negative diameter": (
        "p.csv",
        "x,y,z,d\n1,2,3,-4\n",
        2,
        "'-4' as diameter",
        "not negative",
    ),
    "csv, no row": ("p.csv", "x,y,z,r\n", None, "no sphere", "lines"),
    "pqr, no atom": ("p.pqr", "REMARK 1\nEND\n", None, "no sphere", "ATOM or HETATM records"),
    "pqr, no radius": ("p.pqr", "ATOM 1 N GLY 1 1 2 3 0.5\n", 1, "9 columns", "10 to 13"),
    "pqr, chain but no radius": (
        "p.pqr",
        "ATOM 1 N GLY A 12 1.0 2.0 3.0 0.5\n",
        1,
        "10 columns 'ATOM 1 N GLY A 12 1.0 2.0 3.0 0.5'",
        "the last of them to be the number of the residue, x y z charge radius",
    ),
    "pqr, short": ("p.pqr", "REMARK\nATOM 1 2\n", 2, "3 columns 'ATOM 1 2'", "10 to 13"),
    "diameter in a comment of another length": (
        "p.spheres",
        "# x y z d and so on\n1 2 3 4 5\n",
        1,
        "the names '# x y z d and so on' over rows of 5 columns",
        'a name for each column, or columns="id x y z r" (--columns)',
    ),
    "text as xyzd": ("p.xyzd", "1 2 3 4\n" * 4, None, "text", "x y z diameter as float64"),
    "pqr, negative": (
        "p.pqr",
        "ATOM 1 N GLY 1 1 2 3 0.5 -1\n",
        1,
        "'-1' as radius",
        "not negative",
    ),
    "sph, few": (
        "p.sph",
        "1 2\n1\n2\n0 0 0 1\n",
        4,
        "end of the file after 1 spheres in level 1",
        "2 as its count says",
    ),
    "sph, many": (
        "p.sph",
        "1 2\n1\n1\n0 0 0 1\n0 0 0 2\n",
        5,
        "'0 0 0 2' after the last level",
        "1 levels",
    ),
    "sph, count between": (
        "p.sph",
        "1 2\n2\n1\n0 0 0 1\n0 0 0 2\n",
        5,
        "'0 0 0 2'",
        "number of spheres in level 2",
    ),
    "sph, count wrong": ("p.sph", "1 2\n2\n1.5\n", 3, "'1.5'", "number of spheres in level 1"),
    "sph, count negative": ("p.sph", "1 2\n2\n-1\n", 3, "'-1'", "not negative"),
    "sph, no levels": ("p.sph", "1 2\n", 1, "end of the file", "the number of levels"),
    "sph, no radii": ("p.sph", "3\n1\n", 1, "'3'", "the smallest and the largest radius"),
    "sph, three columns": (
        "p.sph",
        "1 2\n1\n2\n0 0 0 1\n0 0 1\n",
        5,
        "3 columns '0 0 1'",
        "4 columns: x y z radius",
    ),
    "sph, no spheres": ("p.sph", "1 2\n1\n0\n", None, "no sphere", "at least one"),
    "sph, huge count": (
        "p.sph",
        "1 2\n1\n9000000000000000\n0 0 0 1\n",
        4,
        "end of the file",
        "9000000000000000",
    ),
    "sph, huge levels": (
        "p.sph",
        "1 2\n9000000000000000\n1\n0 0 0 1\n",
        4,
        "end of the file",
        "level 2",
    ),
}


@pytest.mark.parametrize("case", TEXTS, ids=[case.replace(" ", "-") for case in TEXTS])
@pytest.mark.parametrize("single", [False, True], ids=["double", "single"])
def test_bad_text(read_error, tmp_path, case, single):
    name, content, line, found, expected = TEXTS[case]
    path = tmp_path / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    message, code = read_error(path, single=single)
    assert message.startswith(f"{path}, line {line}: found " if line else f"{path}: ")
    assert found in message
    assert expected in message[message.index("expected") :]
    assert code == FORMAT


def test_too_large_for_single_precision_only(read_error, read_text, tmp_path):
    path = tmp_path / "p.spheres"
    path.write_text("1e39 0 0 1\n")
    message, _ = read_error(path, single=True)
    assert "found '1e39' as x in column 1, expected a finite number" in message
    assert read_text("1e39 0 0 1\n").points[0, 0] == 1e39


def test_no_file_name(read_error):
    from spherepacking.vtkSpherePackingCore import vtkSpherePackingReader

    reader = vtkSpherePackingReader()
    events = []
    reader.AddObserver("ErrorEvent", lambda *_: events.append(1))
    reader.Update()
    assert len(events) == 1
    assert "FileName: found none, expected" in reader.GetErrorMessage()


@pytest.mark.parametrize(
    "name", ["p.spheres", "p.xyzr", "p.csv", "p.xyzd", "p.dump", "p.pqr", "p.sph", "p.txt", "p"]
)
class TestFiles:
    def test_missing(self, read_error, tmp_path, name):
        message, code = read_error(tmp_path / name)
        assert message == f"{tmp_path / name}: found no such file, expected a sphere packing"
        assert code == NOT_FOUND

    def test_empty(self, read_error, tmp_path, name):
        (tmp_path / name).touch()
        message, code = read_error(tmp_path / name)
        assert message == f"{tmp_path / name}: the file is empty, expected spheres"
        assert code == END_OF_FILE

    def test_directory(self, read_error, tmp_path, name):
        (tmp_path / name).mkdir()
        message, code = read_error(tmp_path / name)
        assert message == f"{tmp_path / name}: found a directory, expected a file"
        assert code == CANNOT_OPEN

    def test_unreadable(self, read_error, tmp_path, name):
        (tmp_path / name).write_text("0 0 0 1\n")
        (tmp_path / name).chmod(0)
        if os.access(tmp_path / name, os.R_OK):
            pytest.skip("this user reads files that nobody may")
        message, code = read_error(tmp_path / name)
        assert "cannot open the file" in message
        assert code == CANNOT_OPEN


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
@pytest.mark.parametrize("name", ["p.spheres", "p.xyzd", "p.txt"])
def test_a_pipe_is_not_waited_for(read_error, tmp_path, name):
    os.mkfifo(tmp_path / name)
    message, code = read_error(tmp_path / name)
    assert message == f"{tmp_path / name}: found a pipe or a device, expected a regular file"
    assert code == CANNOT_OPEN


@pytest.mark.parametrize("name", ["p.spheres", "p.xyzd", "p.dump"])
def test_a_link_to_itself(read_error, tmp_path, name):
    (tmp_path / name).symlink_to(name)
    message, code = read_error(tmp_path / name)
    assert message.startswith(f"{tmp_path / name}: cannot open the file (")
    assert message.endswith("), expected a readable one")
    assert code == CANNOT_OPEN


def test_truncated_xyzd(read_error, tmp_path):
    path = tmp_path / "p.xyzd"
    path.write_bytes(struct.pack("<4d", 0, 0, 0, 1) + b"1234567")
    message, code = read_error(path)
    assert message.startswith(f"{path}: found 39 bytes, which end within sphere 2")
    assert "expected a multiple of 32" in message
    assert code == END_OF_FILE


@pytest.mark.parametrize(
    ("sphere", "found"),
    [
        ((float("nan"), 0, 0, 1), "found nan as x"),
        ((0, float("inf"), 0, 1), "found inf as y"),
        ((0, 0, float("-inf"), 1), "found -inf as z"),
        ((0, 0, 0, -1e-300), "found -1e-300 as diameter"),
        ((0, 0, 0, float("nan")), "found nan as diameter"),
    ],
)
def test_bad_xyzd(read_error, tmp_path, sphere, found):
    path = tmp_path / "p.xyzd"
    good = struct.pack("<4d", 0, 0, 0, 1)
    path.write_bytes(good * 100000 + struct.pack("<4d", *sphere) + good * 100000 + b"\xff" * 32)
    message, _ = read_error(path)
    assert message.startswith(f"{path}, sphere 100001: {found}, expected a finite number")


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("Final Porosity: 0.3\n", ": found no such line for 'Theoretical Porosity:'"),
        ("Theoretical Porosity: 0.3\n", ": found no such line for 'Final Porosity:'"),
        ("Theoretical Porosity: 1.5\nFinal Porosity: 0.3\n", ", line 1: found '1.5' for 'Theo"),
        ("Theoretical Porosity: 0\nFinal Porosity: many\n", ", line 2: found 'many' for 'Final"),
        ("Theoretical Porosity: 0.3\nFinal Porosity: nan\n", ", line 2: found 'nan' for 'Final"),
        ("Theoretical Porosity: 0\n\nFinal Porosity: 0,36", ", line 3: found '0,36' for 'Final"),
        ("Theoretical Porosity: 0.3foo\nFinal Porosity: 0\n", ", line 1: found '0.3foo' for 'The"),
        ("Theoretical Porosity: 0.3\nFinal Porosity:", ", line 2: found '' for 'Final Porosity:'"),
    ],
)
def test_bad_nfo(read_error, tmp_path, text, found):
    (tmp_path / "p.xyzd").write_bytes(struct.pack("<4d", 0, 0, 0, 1))
    (tmp_path / "p.nfo").write_text(text)
    message, _ = read_error(tmp_path / "p.xyzd")
    assert message.startswith(f"{tmp_path / 'p.nfo'}{found}")
    assert "expected a number from 0 to below 1" in message


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("N: 2\n{}", ", line 1: found '2' as the number of spheres, expected 1"),
        ("{}N: 1.5\n", ", line 3: found '1.5' as the number of spheres"),
        ("N: 1\n{}N: 1\n", ", line 4: found a second line N:"),
        ("{0}{0}", ", line 4: found a second line Final Porosity:"),
        ("Theoretical Porosity: 0.25\n{}", ", line 2: found a second line Theoretical Porosity:"),
        ("Theoretical Porosity: 0.3\nFinal Porosity: 0.4", ", line 2: found the end of the file"),
    ],
)
def test_an_nfo_that_contradicts_itself_or_the_file(read_error, tmp_path, text, found):
    (tmp_path / "p.xyzd").write_bytes(struct.pack("<4d", 0, 0, 0, 1))
    (tmp_path / "p.nfo").write_text(
        text.format(" Theoretical Porosity: 0.3\nFinal Porosity: 0.4 (Tolerance: 1)\n")
    )
    message, _ = read_error(tmp_path / "p.xyzd")
    assert message.startswith(f"{tmp_path / 'p.nfo'}{found}")


@pytest.mark.parametrize(
    ("make", "found"),
    [
        (
            lambda path: path.symlink_to(path.with_name("gone")),
            ": found a link that leads to no file",
        ),
        (lambda path: path.symlink_to(path), ": found a link that leads to no file"),
        (lambda path: path.mkdir(), ": found a directory, expected a file"),
        (os.mkfifo, ": found a pipe or a device"),
    ],
    ids=["dangling", "loop", "folder", "pipe"],
)
def test_an_nfo_that_cannot_be_read(read_error, write, tmp_path, make, found):
    (tmp_path / "p.xyzd").write_bytes(struct.pack("<4d", 0, 0, 0, 1))
    make(tmp_path / "p.nfo")
    message, _ = read_error(tmp_path / "p.xyzd")
    assert message.startswith(f"{tmp_path / 'p.nfo'}{found}")
    packing = pv.PolyData(np.zeros((1, 3)))
    packing["radius"] = [0.5]
    good, message = write(packing, tmp_path / "p.xyzd")
    assert not good and message.startswith(f"{tmp_path / 'p.nfo'}{found}")


def test_an_nfo_that_nobody_may_read(read_error, tmp_path):
    (tmp_path / "p.xyzd").write_bytes(struct.pack("<4d", 0, 0, 0, 1))
    path = tmp_path / "p.nfo"
    path.write_text("Theoretical Porosity: 0.3\nFinal Porosity: 0.4\n")
    path.chmod(0)
    if os.access(path, os.R_OK):
        pytest.skip("this user reads files that nobody may")
    message, _ = read_error(tmp_path / "p.xyzd")
    assert message.startswith(f"{path}: cannot open the file (Permission denied)")


def test_an_empty_nfo(read_error, tmp_path):
    (tmp_path / "p.xyzd").write_bytes(struct.pack("<4d", 0, 0, 0, 1))
    (tmp_path / "p.nfo").touch()
    message, _ = read_error(tmp_path / "p.xyzd")
    assert message == f"{tmp_path / 'p.nfo'}: the file is empty, expected two porosities"


def test_rubbish_never_passes_nor_crashes(tmp_path):
    """Good files with bytes changed at random: a packing or one message, nothing between."""
    import numpy as np
    from spherepacking.vtkSpherePackingCore import vtkSpherePackingReader

    seeds = {
        "p.spheres": b"# x y z r\n0.5 1e3 -2 1\n1 2 3 0\n",
        "p.csv": b'x,y,z,r,m\n1,2,3,4,\n5,6,7,8,"a"\n',
        "p.txt": b"#format x_y_z_r_attrs\n1 2 3 4 5\n5 6 7 8 9\n",
        "p.xyzr": b"A 3 N 6.444 3.101 48.834 1.7\nB 4 CA 7 8 9 2\n",
        "p.pqr": b"REMARK\nATOM 1 N GLY 1 1 2 3 0.5 2\nEND\n",
        "p.sph": b"1 2\n2\n1\n0 0 0 1\n2\n0 0 0 1\n1 1 1 1",
        "p.dump": b"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n"
        b"0 1\n0 1\n0 1\nITEM: ATOMS id xs ys zs radius\n1 0.5 0.5 0.5 1\n",
        "p.xyzd": struct.pack("<8d", 0, 1, 2, 3, 4, 5, 6, 7),
    }
    rng = np.random.default_rng(11)
    alphabet = np.frombuffer(b'\0\n\r\t ,;#"-+.eE019naxITEM:\xff', np.uint8)
    outcomes = set()
    for name, seed in seeds.items():
        for _ in range(150):
            data = np.frombuffer(seed, np.uint8).copy()
            for _ in range(rng.integers(1, 6)):
                data[rng.integers(data.size)] = rng.choice(alphabet)
            data = data[: rng.integers(1, data.size + 1)] if rng.random() < 0.3 else data
            (tmp_path / name).write_bytes(data.tobytes())
            reader = vtkSpherePackingReader()
            reader.SetFileName(str(tmp_path / name))
            reader.SetChunkSize(int(rng.integers(1, 40)))
            reader.AddObserver("ErrorEvent", lambda *_: None)
            reader.Update()
            count = reader.GetOutput().GetNumberOfPoints()
            message = reader.GetErrorMessage()
            assert (count == 0) == (message != "") == (reader.GetErrorCode() != 0)
            assert str(tmp_path / name) in message or not message
            outcomes.add(bool(message))
    assert outcomes == {True, False}
