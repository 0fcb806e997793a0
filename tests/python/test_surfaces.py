"""Surfaces from files: what is read of each format, and what is refused."""

import time
import warnings

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from mutations import mutated, surfaces
from spherepacking.cli.main import main
from spherepacking.files import vtk_surfaces
from spherepacking.files.errors import SurfaceFileError
from spherepacking.files.surfaces import read_surface

FOUR = ["0 0 0", "1 0 0", "0 1 0", "0 0 1", "3 0 2 1", "3 0 1 3", "3 1 2 3", "3 2 0 3"]
POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
FACES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]


def written(tmp_path, name, lines):
    path = tmp_path / name
    path.write_bytes(lines if isinstance(lines, bytes) else ("\n".join(lines) + "\n").encode())
    return path


def refusal(path):
    with pytest.raises(SurfaceFileError) as raised:
        read_surface(path)
    return str(raised.value)


def corners(mesh):
    return np.asarray(mesh.points, float)[mesh.regular_faces]


# --- what is right -------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["blob.obj", "cubes.ply"])
def test_the_packing_is_that_of_vtks_reader(data_file, name):
    path = data_file(name)
    mesh, theirs = read_surface(path), pv.read(path)
    assert mesh.points.dtype == theirs.points.dtype
    np.testing.assert_array_equal(mesh.points, theirs.points)
    np.testing.assert_array_equal(mesh.faces, theirs.faces)
    ours, theirs = spherepacking.pack(mesh, 50), spherepacking.pack(theirs, 50)
    np.testing.assert_array_equal(ours.points, theirs.points)
    np.testing.assert_array_equal(ours["radius"], theirs["radius"])


@pytest.mark.parametrize(
    ("name", "options"),
    [
        *(("a.stl", {}), ("a.stl", {"binary": False}), ("a.obj", {})),
        *(("a.ply", {}), ("a.ply", {"binary": False}), ("a.vtp", {}), ("a.vtk", {})),
        ("a.vtu", {}),
    ],
)
def test_what_pyvista_writes(tmp_path, name, options):
    ball = pv.Icosphere(nsub=2, center=(0.1, 0.2, 0.3))
    ball.clear_data()
    ball.points = ball.points.astype(np.float32)
    saved = ball.cast_to_unstructured_grid() if name == "a.vtu" else ball
    saved.save(tmp_path / name, **options)
    np.testing.assert_array_equal(corners(read_surface(tmp_path / name)), corners(ball))


@pytest.mark.parametrize(
    "lines",
    [
        ["OFF", "4 4 6", *FOUR],
        ["# a comment", "", "OFF # and another", "4 4 0", *FOUR, "# the end"],
        ["OFF 4 4 0", *FOUR],
        ["OFF4 4 0", *FOUR],
        ["COFF", "4 4 0", *(line + " 255 0 0 255" for line in FOUR)],
        ["NOFF", "4 4 0", *(line + " 0 0 1" for line in FOUR[:4]), *FOUR[4:]],
        ["OFF", "4 4 0", " ".join(FOUR[:4]), *FOUR[4:]],
        ["OFF", "4 4 0", "0 0 0 1", "0 0 0 1 0", "0 0 1", *(f"{f} 0.5 0.5 1" for f in FOUR[4:])],
        ["\ufeffOFF", "4 4 0", *FOUR],
    ],
)
def test_off(tmp_path, lines):
    mesh = read_surface(written(tmp_path, "four.off", lines))
    np.testing.assert_array_equal(mesh.points, POINTS)
    assert mesh.regular_faces.tolist() == FACES


@pytest.mark.parametrize(
    ("lines", "found"),
    [
        ([], "found an empty file, expected an OFF file in text"),
        (["4 4 0", *FOUR], "found '4' at its begin, expected an OFF file in text"),
        (["4OFF", "4 4 0", *FOUR], "found '4OFF' at its begin"),
        (["OFF BINARY", "4 4 0"], "line 1: found 'OFF BINARY'"),
        (["OFF", "4 x", *FOUR], "line 2: found '4 x', expected how many points"),
        (
            ["OFF", "4 4", *FOUR[:-1]],
            "found 7 lines after that with the numbers, expected 4 points",
        ),
        (["OFF", "4 3", *FOUR], "found 8 lines after that with the numbers, expected 4 points"),
        (["OFF", "4 4 0", *FOUR, "3 0 1 2"], "found 9 lines"),
        (["OFF", "4 4", "1 2", *FOUR[1:]], "line 3: found '1 2', expected three coordinates"),
        (["OFF", "4 4", *FOUR[:3], "0 0 1 1", *FOUR[4:]], "line 6: found '0 0 1 1'"),
        (["OFF", "4 4", "1_0 0 0", *FOUR[1:]], "line 3: found '1_0 0 0'"),
        (["OFF", "4 4", "\u0661 0 0", *FOUR[1:]], "line 3: found '\u0661 0 0'"),
        (["OFF", "4 4", "nan 0 0", *FOUR[1:]], "line 3: found 'nan 0 0'"),
        (["OFF", "4 4", "1e999 0 0", *FOUR[1:]], "found the coordinates inf, 0, 0 of point 0"),
        (["OFF", "4 4", *FOUR[:-1], "3 0 1 4"], "line 10: found '3 0 1 4', expected how many"),
        (["OFF", "4 4", *FOUR[:-1], "3 0 1 2 3 0 1 2 3"], "line 10: "),
        (["OFF", "4 4", *FOUR[:-1], "3 0 1 2 red"], "line 10: "),
        (["OFF", "4 4", *FOUR[:-1], "-3 0 1 2"], "line 10: "),
        (["OFF", "4 4", *FOUR[:-1], "3 0 1"], "line 10: "),
        (["OFF", "4 4", *FOUR[:-1], "3 0 1 99999999999999999999"], "line 10: "),
        (["OFF", "4 4", *FOUR[:-1], "99999999999999999999 0 1"], "line 10: "),
        (["OFF", "9" * 5000 + " 4", *FOUR], "line 2: "),
        (["OFF", "9" * 30 + " 4", *FOUR], "found 8 lines"),
        (["OFF", "4 4", *FOUR[:-1], "2 0 1"], "line 10: "),
        (["OFF", "99999999999 99999999999", *FOUR], "found 8 lines"),
        (["OFF", "-4 12", *FOUR], "line 2: "),
        (["OFF", "4 4", "\x1b[31m 0 0", *FOUR[1:]], r"line 3: found '\x1b[31m 0 0'"),
    ],
)
def test_bad_off(tmp_path, lines, found):
    assert found in refusal(written(tmp_path, "four.off", lines))


def stl(triangles, count):
    head = b"solid, though it is not text".ljust(80) + count.to_bytes(4, "little")
    rows = np.zeros(len(triangles), [("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")])
    rows["v"] = triangles
    return head + rows.tobytes()


def test_binary_stl(tmp_path):
    mesh = read_surface(written(tmp_path, "a.stl", stl(POINTS[FACES], 4)))
    np.testing.assert_array_equal(corners(mesh), POINTS[FACES])


def test_the_count_of_a_binary_stl_is_believed_only_if_it_is_right(tmp_path):
    # Two cubes, cut after the first: what VTK reads is a cube.
    data = stl(POINTS[FACES], 8)
    assert "found 200 bytes after a head that counts 8 triangles, expected 400, 50 for each" in (
        refusal(written(tmp_path, "a.stl", data))
    )
    assert "counts 3 triangles" in refusal(written(tmp_path, "a.stl", stl(POINTS[FACES], 3)))
    assert "found 78 bytes" in refusal(written(tmp_path, "a.stl", data[:83].replace(b"solid", b"")))
    nans = np.where(POINTS[FACES] == 1, np.nan, POINTS[FACES])
    assert "found the coordinates 0, nan, 0 of point 1" in refusal(
        written(tmp_path, "a.stl", stl(nans, 4))
    )


FACET = ["facet normal 0 0 1", "outer loop", *(f"vertex {row}" for row in FOUR[:3]), "endloop"]


@pytest.mark.parametrize(
    ("lines", "found"),
    [
        (["solid", *FACET, "endfacet"], "line 8: found the end of the file, expected endsolid"),
        (["solid", *FACET, "endsolid"], "line 8: found 'endsolid', expected endfacet"),
        (
            ["solid", *FACET[1:], "endfacet", "endsolid"],
            "line 2: found 'outer loop', expected facet",
        ),
        (["solid a", *FACET[:4], "endloop"], "line 6: found 'endloop', expected vertex and three"),
        (["solid a", *FACET[:4], "vertex 1 2"], "line 6: found 'vertex 1 2', expected vertex"),
        (
            ["solid a", *FACET[:4], "vertex 1 2 x"],
            "line 6: found 'vertex 1 2 x', expected three coord",
        ),
        (
            ["solid a", *FACET, "endfacet", "endsolid a", "more"],
            "line 10: found 'more', expected solid",
        ),
    ],
)
def test_bad_stl_in_text(tmp_path, lines, found):
    assert found in refusal(written(tmp_path, "a.stl", lines))


def test_several_solids(tmp_path):
    solid = ["solid of 2 words", *FACET, "endfacet", "endsolid of 2 words"]
    mesh = read_surface(written(tmp_path, "a.stl", [*solid, "", *map(str.upper, solid)]))
    np.testing.assert_array_equal(corners(mesh), [POINTS[:3], POINTS[:3]])


PLY = [
    *("ply", "format ascii 1.0", "comment one", "element vertex 4"),
    *(f"property float {axis}" for axis in "xyz"),
    *("element face 4", "property list uchar int vertex_indices", "end_header"),
]


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_ply_in_text(tmp_path, end):
    data = end.join([*PLY, *FOUR, ""]).encode()
    mesh = read_surface(written(tmp_path, "four.ply", data))
    np.testing.assert_array_equal(corners(mesh), POINTS[FACES])
    assert mesh.points.dtype == np.float32


@pytest.mark.parametrize("order", "<>")
@pytest.mark.parametrize("mixed", [False, True])
def test_binary_ply_with_more_than_a_surface(tmp_path, order, mixed):
    """Faces come before points here, and there are colours, lists, and another element."""
    faces = [*FACES[:3], [2, 0, 3, 1]] if mixed else FACES
    name = {"<": "little", ">": "big"}[order]
    head = [
        *("ply", f"format binary_{name}_endian 1.0", "obj_info of no use"),
        *("element face 4", "property uchar red", "property list uchar float texcoord"),
        *("property list int uint vertex_index", "element vertex 4", "property double x"),
        *("property short quality", "property double y", "property double z"),
        *("element edge 1", "property int vertex1", "end_header"),
    ]
    body = b"".join(
        b"\x09\x02"
        + np.array([0.5, 0.25], order + "f4").tobytes()
        + np.array([len(ids), *ids], order + "i4").tobytes()
        for ids in faces
    )
    for x, y, z in POINTS + 0.1:
        body += np.array(x, order + "f8").tobytes() + np.array(7, order + "i2").tobytes()
        body += np.array([y, z], order + "f8").tobytes()
    body += np.array(1, order + "i4").tobytes()
    path = written(tmp_path, "four.ply", ("\n".join(head) + "\n").encode() + body)
    mesh = read_surface(path)
    np.testing.assert_array_equal(mesh.points, (POINTS + 0.1).astype(np.float32))
    assert mesh.faces.tolist() == [i for ids in faces for i in [len(ids), *ids]]
    for size in range(path.stat().st_size):
        path.write_bytes((("\n".join(head) + "\n").encode() + body)[:size])
        refusal(path)


@pytest.mark.parametrize(
    ("old", "new", "found"),
    [
        ("ply\n", "plY\n", "found no line ply at its begin"),
        ("end_header", "end_headr", "found no line end_header"),
        ("ascii 1.0", "ascii 1.1", "line 2: found 'format ascii 1.1', expected format"),
        ("comment", "coment", "line 3: found 'coment one', expected element NAME COUNT"),
        ("element vertex 4", "element vertex -4", "line 4: found 'element vertex -4'"),
        ("element vertex 4", "element vertex 5", "line 15: found '3 0 2 1', expected 3 numbers"),
        (
            "element vertex 4",
            "element vertex 3",
            "line 14: found '0 0 1', expected what the header",
        ),
        ("element vertex 4", "element vertex 99999999999", "line 15: "),
        (
            "element face 4",
            "element face 3",
            "line 18: found '3 2 0 3', expected nothing after all",
        ),
        ("element face 4", "element face 5", "line 18: found the end of the file"),
        ("float x", "float y", "found the same name twice in its header"),
        ("float x", "float w", "found no three properties x, y and z"),
        ("float x", "floot x", "line 5: found 'property floot x'"),
        ("uchar int vertex_indices", "uchar float vertex_indices", "one of integers"),
        ("uchar int vertex_indices", "float int vertex_indices", "line 9: found 'property list fl"),
        ("vertex_indices", "vertices", "found no list vertex_indices"),
        ("3 2 0 3", "3 2 0 4", "found a polygon of point 4, expected points from 0 to 3"),
        ("3 2 0 3", "3 2 0 -1", "found a polygon of point -1"),
        ("3 2 0 3", "3 2 0 99999999999999999999", "line 18: "),
        ("3 2 0 3", "3 2 0 -99999999999999999999", "line 18: "),
        ("3 2 0 3", "99999999999999999999 2 0 3", "line 18: "),
        ("element face 4", "element face " + "9" * 5000, "line 8: "),
        ("3 2 0 3", "2 2 0", "line 18: found '2 2 0'"),
        ("3 2 0 3", "3 2 0 3 1", "line 18: found '3 2 0 3 1'"),
        ("3 2 0 3", "-1 2 0 3", "line 18: found '-1 2 0 3'"),
        ("3 2 0 3", "3 2 0 1_0", "line 18: found '3 2 0 1_0'"),
        ("1 0 0\n", "1 nan 0\n", "line 12: found '1 nan 0'"),
    ],
)
def test_bad_ply(tmp_path, old, new, found):
    text = "\n".join([*PLY, *FOUR, ""])
    assert old in text
    assert found in refusal(written(tmp_path, "four.ply", text.replace(old, new, 1).encode()))


OBJ = [*(f"v {row}" for row in FOUR[:4]), *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in FACES)]


@pytest.mark.parametrize(
    "lines",
    [
        OBJ,
        ["# one", "mtllib /etc/passwd", "o Ant 1", "g a b", "usemtl m_1", "s off", *OBJ, "l 1 2"],
        [*(f"{line} 1" for line in OBJ[:4]), *OBJ[4:]],
        [*(f"{line} 0.5 1 0" for line in OBJ[:4]), *OBJ[4:]],
        [
            *OBJ[:4],
            "vt 0 0",
            "vn 0 0 1",
            *(f"f {a + 1}/1/1 {b + 1}/1/1 {c + 1}/1/1" for a, b, c in FACES),
        ],
        [*OBJ[:4], "vn 0 0 1", *(f"f {a + 1}//1 {b + 1}//1 {c + 1}//1" for a, b, c in FACES)],
        [*OBJ[:4], *(f"f {a - 4} {b - 4} {c - 4}" for a, b, c in FACES)],
        [*OBJ[:4], *(f"f {a + 1} \\\n{b + 1} \\\r\n{c + 1}" for a, b, c in FACES)],
    ],
)
def test_obj(tmp_path, lines):
    mesh = read_surface(written(tmp_path, "four.obj", lines))
    np.testing.assert_array_equal(mesh.points, POINTS)
    assert mesh.regular_faces.tolist() == FACES


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("v 1 2", "line 9: found 'v 1 2', expected v and three coordinates"),
        ("v 1 2 3 4 5", "line 9: "),
        ("v 1 2 x", "line 9: found 'v 1 2 x', expected three coordinates"),
        ("f 1 2", "line 9: found 'f 1 2', expected three or more points"),
        ("f 1 2 0", "line 9: "),
        ("f 1 2 -5", "line 9: "),
        ("f 1 2 99999999999999999999", "line 9: "),
        ("f 1 2 -99999999999999999999", "line 9: "),
        ("f 1 2 " + "9" * 5000, "line 9: "),
        ("f 1 2 5", "found a polygon of point 4, expected points from 0 to 3"),
        ("f 1/1/1/1 2/1/1/1 3/1/1/1", "line 9: "),
        ("f 1/x 2/1 3/1", "line 9: "),
        ("f 1.5 2 3", "line 9: "),
        ("g 1 2 3", "line 9: found 'g 1 2 3', expected names after g, or a polygon"),
        ("o 1/1 2/1 3/1", "line 9: "),
        ("s 1 2 3", "line 9: "),
        ("l 0.5 1", "line 9: "),
        ("vn 1 2", "line 9: found 'vn 1 2', expected vn and its numbers"),
        ("curv 0 1 1 2", "line 9: found 'curv 0 1 1 2', expected v, vt, vn, f"),
        ("surf 0 1 0 1 1", "no free-form surfaces"),
        ("# \\\nf 1 2 3\nx", "line 11: found 'x'"),
    ],
)
def test_bad_obj(tmp_path, line, found):
    assert found in refusal(written(tmp_path, "four.obj", [*OBJ, line]))


def test_points_of_no_polygon_are_told(tmp_path):
    """A file in OBJ has no counts, but one that is cut has points that nothing uses."""
    path = written(tmp_path, "four.obj", [*OBJ[:4], *OBJ[:4], *OBJ[4:]])
    with pytest.warns(UserWarning, match=r"four\.obj: found 4 points of no polygon"):
        read_surface(path)


def test_the_command_tells_them(tmp_path, capsys):
    path = written(tmp_path, "four.obj", [*OBJ[:4], *OBJ[:4], *OBJ[4:]])
    assert main(["pack", str(path), str(tmp_path / "four.spheres"), "--count", "4"]) == 0
    assert "found 4 points of no polygon" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "text"),
    [
        *(("a.obj", b"\\\n"), ("a.obj", b"v 1 2 3 "), ("a.obj", b"f 1 2 3\n"), ("a.obj", b"\\")),
        *(("a.obj", b"f 1//"), ("a.obj", b"#"), ("a.obj", b"\r"), ("a.obj", b"g 1 2 3\n")),
        *(("a.off", b"OFF "), ("a.off", b"OFF\n1 1 1\n"), ("a.off", b"1 "), ("a.off", b"\n")),
        *(("a.stl", b"solid\n"), ("a.stl", b"solid "), ("a.stl", b"solid\nfacet normal 1 ")),
        *(("a.ply", b"ply\n"), ("a.ply", b"ply\nformat ascii 1.0\nelement vertex 1\n")),
        *(("a.ply", b"ply\nformat ascii 1.0\nelement a 1\nproperty int b\n"), ("a.ply", b"\x03")),
    ],
)
def test_any_repetition_is_read_in_time(tmp_path, name, text):
    """At most 2 s for 100 kB, however lines and words are repeated; as a rule it is 0.1 s."""
    for begin in (b"", text):
        path = written(tmp_path, name, begin + b"\n" + text * (400_000 // len(text)))
        start = time.perf_counter()
        refusal(path)
        assert time.perf_counter() - start < 8


# --- files of VTK ---------------------------------------------------------------------------------


def test_a_crash_of_vtks_reader_is_an_error(tmp_path, monkeypatch):
    monkeypatch.setattr(
        "spherepacking.files.vtk_child._CODE", "import os; os.kill(os.getpid(), 11)"
    )
    path = written(tmp_path, "a.vtk", ["# vtk DataFile Version 5.1"])
    assert refusal(path) == (
        f"{path}: found a file on which VTK's reader crashes or runs out of memory, expected a "
        "whole one"
    )


def test_a_reader_that_never_ends_is_an_error(tmp_path, monkeypatch):
    path = written(tmp_path, "a.vtk", ["# vtk DataFile Version 5.1"])
    monkeypatch.setattr(
        "spherepacking.files.vtk_child._CODE",
        "from spherepacking.files import vtk_child as c; c._SECONDS = 0.3;"
        "c.hand_over_arrays(lambda path: [None for _ in iter(int, 1)])",
    )
    assert "found a file that VTK's reader does not come to an end with" in refusal(path)
    monkeypatch.setattr("spherepacking.files.vtk_child._CODE", "import time; time.sleep(99)")
    monkeypatch.setattr("spherepacking.files.vtk_child._SECONDS", 0.3)
    monkeypatch.setattr("spherepacking.files.vtk_child._WAITING", 0.0)
    assert "found a file that VTK's reader has not read in 0 s" in refusal(path)


def test_memory_of_the_child_is_limited(tmp_path, monkeypatch):
    monkeypatch.setattr(
        "spherepacking.files.vtk_child._CODE",
        "from spherepacking.files import vtk_child as c; import numpy as np;"
        "c.hand_over_arrays(lambda path: {'points': np.ones(1 << 28)})",
    )
    assert "runs out of memory" in refusal(written(tmp_path, "a.vtk", ["x"]))


def test_cells_that_are_not_there(tmp_path):
    """A filter of VTK, and its packer, would look for them."""
    mesh = pv.PolyData(POINTS.astype(float), faces=[3, 0, 1, 7])
    path = tmp_path / "a.vtp"
    mesh.save(path)
    assert "found a cell of point 7, expected points from 0 to 3" in refusal(path)
    grid = pv.UnstructuredGrid([3, 0, 1, 2], [pv.CellType.TRIANGLE], POINTS.astype(float))
    grid.save(tmp_path / "a.vtu", binary=False)
    text = (tmp_path / "a.vtu").read_text()
    kind = int(pv.CellType.HEXAHEDRON)
    text = text.replace("\n          5\n", f"\n          {kind}\n")
    (tmp_path / "a.vtu").write_text(text)
    assert "found a cell of kind 12 with 3 to 3 points" in refusal(tmp_path / "a.vtu")


def test_a_version_that_is_none(tmp_path):
    """VTK takes the cells of such a file for those of an old one, and crashes."""
    path = tmp_path / "a.vtk"
    pv.Cube().save(path)
    path.write_bytes(path.read_bytes().replace(b"Version 5", b"Version o", 1))
    assert "found '# vtk DataFile Version o.1 vtk" in refusal(path)
    with pytest.raises(spherepacking.PackingFileError, match=r"Version o\.1"):
        spherepacking.read(path)


# --- others, and damage ---------------------------------------------------------------------------


@pytest.mark.parametrize("extension", ["vtm", "pvd", "case", "xdmf", "gltf", "series", "vtpd", ""])
def test_no_file_makes_the_command_read_another(tmp_path, capsys, extension):
    """What is named there may be somebody's secret."""
    pv.Cube().save(tmp_path / "secret.vtp")
    path = (tmp_path / "upload").with_suffix(f".{extension}" if extension else "")
    if extension == "vtm":
        pv.MultiBlock([pv.read(tmp_path / "secret.vtp")]).save(path)
    else:
        path.write_text('<VTKFile><Collection><DataSet file="secret.vtp"/></Collection></VTKFile>')
    target = tmp_path / "out.spheres"
    assert main(["pack", str(path), str(target)]) == 2
    assert "expected .off, .stl, .ply, .obj, .vtp, .vtu or .vtk" in capsys.readouterr().err
    assert not target.exists()


def check_sentence(sentence, path):
    assert sentence.startswith(str(path))
    assert sentence.isprintable()
    assert len(sentence) < 700


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    return surfaces(tmp_path_factory.mktemp("surfaces"))


@pytest.mark.parametrize(
    "name",
    [
        *("binary.stl", "text.stl", "triangles.ply", "mixed.ply", "text.ply"),
        *("triangles.obj", "mixed.obj", "mixed.off"),
    ],
)
def test_damage_is_refused_or_harmless(tmp_path, good, rng, name):
    """300 damaged copies: a sentence, or a surface of as many points and polygons.

    OBJ has no counts. What is lost there leaves a surface open, or points without polygons.
    """
    path = tmp_path / f"a.{name.rpartition('.')[2]}"
    path.write_bytes(good[name])
    whole = read_surface(path)
    tally = {"refused": 0, "read": 0}
    for _ in range(300):
        path.write_bytes(mutated(good[name], rng))
        try:
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                mesh = read_surface(path)
        except SurfaceFileError as error:
            tally["refused"] += 1
            check_sentence(str(error), path)
            continue
        tally["read"] += 1
        if (mesh.n_points, mesh.n_cells) != (whole.n_points, whole.n_cells):
            assert name.endswith(".obj")
            if not told:
                with pytest.raises(ValueError, match=r"open edges|found no|found a volume"):
                    spherepacking.pack(mesh, 1)
    assert min(tally.values()) > 30


@pytest.mark.parametrize("name", ["binary.vtk", "text.vtk", "binary.vtp", "binary.vtu"])
def test_damaged_files_of_vtk(tmp_path, good, rng, name):
    """Each takes a process of its own, so there are few."""
    path = tmp_path / f"a{name[-4:]}"
    for _ in range(2):
        path.write_bytes(mutated(good[name], rng))
        try:
            read_surface(path)
        except SurfaceFileError as error:
            check_sentence(str(error), path)


def test_vtks_files_are_read_in_another_process(tmp_path, monkeypatch):
    monkeypatch.setattr(vtk_surfaces.pv, "get_reader", None)
    pv.Cube().clean().save(tmp_path / "a.vtp")
    assert read_surface(tmp_path / "a.vtp").n_cells == 6
