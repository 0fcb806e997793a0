"""Damaged files of VTK, which VTK's own readers believe until they end the process."""

import base64
import lzma
import re
import struct
import subprocess
import sys
import zlib

import numpy as np
import pytest
import pyvista as pv
import spherepacking

POINTS = np.array([[0.5, 0.25, 0.0], [2.0, 0.0, 0.75], [1.0, 1.0, 1.0]])
RADII = np.array([0.5, 0.125, 0.25])
TEXTS = b"glass\0steel\0x\0"
COMPRESSORS = {
    "vtkZLibDataCompressor": zlib.compress,
    "vtkLZMADataCompressor": lzma.compress,
    # A block that holds the bytes as they are: how many there are, then these.
    "vtkLZ4DataCompressor": lambda data: (
        bytes([min(len(data), 15) << 4, *([len(data) - 15] if len(data) >= 15 else [])]) + data
    ),
}


def array(data, word, order, compressor, block=32, last=None, sizes=None):
    """Head and body of an array in a file in XML, as VTK's documentation describes them."""

    def pack(*numbers):
        return struct.pack(f"{order}{len(numbers)}{word}", *numbers)

    if compressor is None:
        return pack(len(data) if last is None else last), data
    parts = [data[i : i + block] for i in range(0, len(data), block)]
    packed = [COMPRESSORS[compressor](part) for part in parts]
    partial = len(parts[-1]) % block if last is None else last
    head = pack(len(parts), block, partial, *map(len, packed))
    return head, b"".join(packed)


class XmlFile:
    """Writes a small file in XML, without any of VTK's code."""

    def __init__(self, mode, word="I", order="<", compressor=None, **wrong):
        self.mode, self.word, self.order, self.compressor = mode, word, order, compressor
        self.wrong = wrong
        self.appended = b""

    def _array(self, name, kind, data, components=1):
        wrong = self.wrong.get(name, {})
        head, body = array(data, self.word, self.order, self.compressor, **wrong)
        coded = (
            base64.b64encode(head) + base64.b64encode(body)
            if self.compressor
            else base64.b64encode(head + body)
        )
        tag = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" '
        if self.mode == "binary":
            return f'{tag}format="binary">\n{coded.decode()}\n</DataArray>\n'
        offset = len(self.appended)
        self.appended += head + body if self.mode == "raw" else coded
        return f'{tag}format="appended" offset="{offset}"/>\n'

    def bytes(self, texts=TEXTS, count=3):
        real = f"{self.order}f8"
        header = {"I": "UInt32", "Q": "UInt64"}[self.word]
        compressor = f' compressor="{self.compressor}"' if self.compressor else ""
        order = {"<": "Little", ">": "Big"}[self.order]
        text = (
            f'<VTKFile type="PolyData" version="1.0" byte_order="{order}Endian" '
            f'header_type="{header}"{compressor}>\n<PolyData>\n<Piece NumberOfPoints="{count}" '
            'NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">\n<PointData>'
            + self._array("radius", "Float64", RADII.astype(real).tobytes())
            + self._array("species", "String", texts)
            + "</PointData><Points>"
            + self._array("Points", "Float64", POINTS.astype(real).tobytes(), 3)
            + "</Points></Piece></PolyData>\n"
        )
        if self.mode == "binary":
            return f"{text}</VTKFile>\n".encode()
        encoding = "raw" if self.mode == "raw" else "base64"
        head = f'{text}<AppendedData encoding="{encoding}">\n_'.encode()
        return head + self.appended + b"\n</AppendedData></VTKFile>\n"


LAYOUTS = [
    (mode, word, order, compressor)
    for mode in ("raw", "base64", "binary")
    for word in "IQ"
    for order in "<>"
    for compressor in (None, *COMPRESSORS)
]


def refused(path, match):
    """The file is refused, in a process of its own in case that VTK ends it."""
    code = (
        "import sys, spherepacking\n"
        "try: spherepacking.read(sys.argv[1])\n"
        "except spherepacking.PackingFileError as error: print(error)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, path], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done
    assert re.search(match, done.stdout), done.stdout
    assert done.stdout.count("\n") == 1


@pytest.mark.parametrize("layout", LAYOUTS)
def test_whole_files_of_every_layout(tmp_path, layout):
    path = tmp_path / "a.vtp"
    path.write_bytes(XmlFile(*layout).bytes())
    packing = spherepacking.read(path)
    assert packing.points.tolist() == POINTS.tolist()
    assert packing["radius"].tolist() == RADII.tolist()
    assert packing["species"].tolist() == ["glass", "steel", "x"]


@pytest.mark.parametrize("layout", [layout for layout in LAYOUTS if layout[3]])
@pytest.mark.parametrize("last", [2**31 - 1, 33, 31])
def test_the_size_of_the_last_block(tmp_path, layout, last):
    """Larger than a block, or not what the points need."""
    path = tmp_path / "b.vtp"
    path.write_bytes(XmlFile(*layout, radius={"last": last}).bytes())
    with pytest.raises(spherepacking.PackingFileError, match=r"b\.vtp: array 'radius': found \d"):
        spherepacking.read(path)


@pytest.mark.parametrize("layout", [layout for layout in LAYOUTS if not layout[3]])
@pytest.mark.parametrize("size", [0, 16, 23, 25, 32, 2**31 - 1])
def test_the_size_of_an_array(tmp_path, layout, size):
    path = tmp_path / "b.vtp"
    path.write_bytes(XmlFile(*layout, radius={"last": size}).bytes())
    with pytest.raises(spherepacking.PackingFileError, match=r"'radius': found [\d,]+ bytes"):
        spherepacking.read(path)


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("texts", [TEXTS[:-2], TEXTS[:-1], TEXTS + b"y\0", b"abc", TEXTS + b"y"])
def test_texts_of_another_number(tmp_path, layout, texts):
    path = tmp_path / "b.vtp"
    path.write_bytes(XmlFile(*layout).bytes(texts))
    with pytest.raises(
        spherepacking.PackingFileError, match=r"'species': found \d texts, expected 3"
    ):
        spherepacking.read(path)


@pytest.mark.parametrize("layout", [layout for layout in LAYOUTS if layout[3]])
def test_texts_in_a_block_that_is_damaged(tmp_path, layout):
    """Its last byte: a checksum where there is one."""
    _, body = array(TEXTS, *layout[1:])
    data = XmlFile(*layout).bytes()
    code = bytes if layout[0] == "raw" else base64.b64encode
    wrong = body[:-1] + bytes([body[-1] ^ 1])
    assert code(body) in data
    path = tmp_path / "b.vtp"
    path.write_bytes(data.replace(code(body), code(wrong)))
    with pytest.raises(spherepacking.PackingFileError, match=r"'species': found (a block|\d text)"):
        spherepacking.read(path)


@pytest.mark.parametrize("word", [0, 1, 3])
@pytest.mark.parametrize("layout", [layout for layout in LAYOUTS if layout[3] and layout[1] == "I"])
def test_heads_that_claim_too_much(tmp_path, layout, word):
    """The number of blocks, the size of each, and that of the first in the file."""
    mode, _, order, _ = layout
    data = XmlFile(*layout).bytes()
    head, _ = array(RADII.astype(f"{order}f8").tobytes(), *layout[1:])
    wrong = bytearray(head)
    wrong[4 * word : 4 * word + 4] = struct.pack(f"{order}I", 2**31 - 1)
    code = bytes if mode == "raw" else base64.b64encode
    assert code(head) in data
    path = tmp_path / "b.vtp"
    path.write_bytes(data.replace(code(head), code(bytes(wrong)), 1))
    with pytest.raises(
        spherepacking.PackingFileError, match=r"'radius': found [\d,]+ b(ytes|locks)"
    ):
        spherepacking.read(path)


def test_letters_that_base64_has_not(tmp_path):
    """VTK leaves the values behind them as they were in memory."""
    data = XmlFile("base64").bytes()
    radii = base64.b64encode(struct.pack("<I", 24) + RADII.tobytes())
    assert radii in data
    path = tmp_path / "b.vtp"
    path.write_bytes(data.replace(radii, radii[:12] + b"####" + radii[16:]))
    with pytest.raises(spherepacking.PackingFileError, match="'radius': found b'####' in base64"):
        spherepacking.read(path)


@pytest.mark.parametrize("kind", ["PolyData", "UnstructuredGrid"])
@pytest.mark.parametrize("last", ["1000000000", "2", "-1"])
def test_offsets_of_cells_that_lie(tmp_path, kind, last):
    mesh = pv.PolyData(POINTS)
    mesh["radius"] = RADII
    extension = ".vtp" if kind == "PolyData" else ".vtu"
    mesh = mesh if kind == "PolyData" else mesh.cast_to_unstructured_grid()
    mesh.save(tmp_path / f"a{extension}", binary=False)
    text = (tmp_path / f"a{extension}").read_text()
    wrong = re.sub(r'(Name="offsets"[^>]*>\s*1 2 )3', rf"\g<1>{last}", text)
    assert wrong != text
    path = tmp_path / f"b{extension}"
    path.write_text(wrong)
    refused(path, r"b\.vt[pu]: ")


def test_files_that_name_damaged_ones(tmp_path):
    part = pv.PolyData(POINTS)
    part["radius"] = RADII
    part["species"] = ["glass", "steel", "x"]
    pv.MultiBlock([part, part]).save(tmp_path / "a.vtm")
    file = tmp_path / "a" / "a_1.vtp"
    assert file.exists()
    file.write_bytes(XmlFile("raw").bytes(b"glass\0"))
    refused(tmp_path / "a.vtm", r"a_1\.vtp: array 'species': found 1 texts")


def test_files_that_name_each_other(tmp_path):
    text = '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>{}</vtkMulti'
    text += "BlockDataSet></VTKFile>"
    for name, other in (("a", "b"), ("b", "a")):
        part = f'<DataSet index="0" file="{other}.vtm"/>'
        (tmp_path / f"{name}.vtm").write_text(text.format(part))
    refused(tmp_path / "a.vtm", r"b\.vtm: found .*a\.vtm in it, which names it")


LEGACY = b"""# vtk DataFile Version 4.2
made up
%s
DATASET POLYDATA
FIELD FieldData 1
units 1 2 string
mm
kg
POINTS 3 double
%s
VERTICES 3 6
%s
POINT_DATA 3
SCALARS radius double
LOOKUP_TABLE default
%s
"""


def legacy(path, binary, cells=(1, 0, 1, 1, 1, 2)):
    numbers = (POINTS.ravel(), np.array(cells), RADII)
    if binary:
        parts = [
            a.astype(kind).tobytes() for a, kind in zip(numbers, (">f8", ">i4", ">f8"), strict=True)
        ]
        text = LEGACY.replace(b"mm\nkg\n", b"\xc2mm\xc2kg\n") % (b"BINARY", *parts)
    else:
        parts = [" ".join(map(str, a.tolist())).encode() for a in numbers]
        text = LEGACY % (b"ASCII", *parts)
    path.write_bytes(text)
    return text


@pytest.mark.parametrize("binary", [False, True])
def test_a_whole_legacy_file(tmp_path, binary):
    legacy(tmp_path / "a.vtk", binary)
    packing = spherepacking.read(tmp_path / "a.vtk")
    assert packing["radius"].tolist() == RADII.tolist()
    assert packing.field_data["units"].tolist() == ["mm", "kg"]


@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize(
    "cells", [(2000000, 0, 1, 1, 1, 2), (1, 0, 1, 1, -5, 2), (2, 0, 1, 1, 1, 2)]
)
def test_lengths_of_cells_in_legacy_files(tmp_path, binary, cells):
    legacy(tmp_path / "b.vtk", binary, cells)
    refused(tmp_path / "b.vtk", r"b\.vtk(, line 12| at byte \d+): found lengths of cells")


def test_texts_that_a_legacy_file_calls_numbers(tmp_path):
    text = legacy(tmp_path / "a.vtk", False)
    (tmp_path / "b.vtk").write_bytes(text.replace(b"2 string", b"2 double"))
    refused(tmp_path / "b.vtk", r"b\.vtk, line 7: found 'mm', expected a number")


@pytest.mark.parametrize("wrong", [b"0.5x", b"0.5.5", b"--1", b"e"])
def test_words_that_are_no_numbers(tmp_path, wrong):
    text = legacy(tmp_path / "a.vtk", False)
    (tmp_path / "b.vtk").write_bytes(text.replace(b"0.5 0.125", wrong + b" 0.125"))
    with pytest.raises(
        spherepacking.PackingFileError, match=f"line 16: found '{wrong.decode()}', expected a n"
    ):
        spherepacking.read(tmp_path / "b.vtk")


@pytest.mark.parametrize(("old", "new"), [(b"kg", b"k\xe9"), (b"radius", b"radi\xe9s")])
def test_texts_that_are_no_utf8(tmp_path, old, new):
    text = legacy(tmp_path / "a.vtk", False)
    (tmp_path / "b.vtk").write_bytes(text.replace(old, new))
    with pytest.raises(spherepacking.PackingFileError, match=r"found the (bytes|name).*xe9"):
        spherepacking.read(tmp_path / "b.vtk")


@pytest.mark.parametrize("size", [5, 200, 4096, 2**40])
def test_a_heap_of_texts_in_hdf5_that_has_no_end(tmp_path, size):
    """HDF5 walks on by sizes of 0 for ever."""
    writer = pytest.importorskip(f"{pv.PolyData.__mro__[-2].__module__.partition('.')[0]}.vtkIOHDF")
    mesh = pv.PolyData(POINTS)
    mesh["radius"] = RADII
    mesh.field_data["units"] = ["mm", "a longer text"]
    writer = writer.vtkHDFWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(str(tmp_path / "a.vtkhdf"))
    assert writer.Write()
    assert spherepacking.read(tmp_path / "a.vtkhdf").field_data["units"][1] == "a longer text"
    data = (tmp_path / "a.vtkhdf").read_bytes()
    whole = struct.pack("<Q", len("a longer text")) + b"a longer text"
    assert data.count(whole) == 1
    path = tmp_path / "b.vtkhdf"
    path.write_bytes(data.replace(whole, struct.pack("<Q", size) + whole[8:]))
    with pytest.raises(spherepacking.PackingFileError, match=r"b\.vtkhdf: found texts at byte \d+"):
        spherepacking.read(path)


@pytest.mark.parametrize("version", [b"18446744073709551616.1", b"5", b"x"])
def test_versions_that_vtk_cannot_read(tmp_path, version):
    text = legacy(tmp_path / "a.vtk", True)
    (tmp_path / "b.vtk").write_bytes(text.replace(b"4.2", version))
    with pytest.raises(spherepacking.PackingFileError, match=r"b\.vtk, line 1: found '# vtk D"):
        spherepacking.read(tmp_path / "b.vtk")


def test_a_version_with_a_full_stop(tmp_path):
    """YADE writes one."""
    text = legacy(tmp_path / "a.vtk", False)
    (tmp_path / "b.vtk").write_bytes(text.replace(b"4.2", b"4.2."))
    assert spherepacking.read(tmp_path / "b.vtk")["radius"].tolist() == RADII.tolist()


def test_blanks_hold_no_number(tmp_path):
    """Even where nothing says how many there are."""
    mesh = pv.PolyData(POINTS)
    mesh["radius"] = RADII
    mesh.save(tmp_path / "a.vtp", binary=False)
    text = (tmp_path / "a.vtp").read_text()
    blank, count = re.subn(r'(Name="radius"[^>]*>)[^<]*<', r"\1  \n <", text)
    assert count == 1
    (tmp_path / "b.vtp").write_text(blank)
    with pytest.raises(
        spherepacking.PackingFileError, match="'radius': found 0 values, expected 3"
    ):
        spherepacking.read(tmp_path / "b.vtp")
    (tmp_path / "c.vtp").write_text(
        text.replace("</PointData>", "</PointData>\n<CellData>\n</CellData>")
    )
    assert spherepacking.read(tmp_path / "c.vtp").n_points == 3
