"""What a file says, or is called, does not steer the terminal that shows it."""

import subprocess
import sys
import unicodedata

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.cli.main import main
from spherepacking.files.errors import PackingFileError, SurfaceFileError
from spherepacking.printable import printable, quoted

# Escape sequences in both forms, erasing, and the order of letters: U+009B is a CSI of one letter.
ODD = "a\x1b[31m\x9b2J\x7f\u202e\u2066\u200f\u061c\x07z"
SHOWN = r"a\x1b[31m\xc2\x9b2J\x7f\xe2\x80\xae\xe2\x81\xa6\xe2\x80\x8f\xd8\x9c\x07z"


TURNING = ("LRE", "LRO", "RLE", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI")


def test_printable():
    assert printable(ODD) == SHOWN
    assert printable("Größe – 球 é\u0301 🧪") == "Größe – 球 é\u0301 🧪"
    assert printable(b"\xff\xfea") == r"\xff\xfea"
    assert printable("\udcff") == r"\xff"
    assert printable("one\ttwo\nthree") == "one two three"
    assert printable(printable(ODD)) == printable(ODD)
    long = printable("x" * 30000, 100)
    assert long == f"{'x' * 50} … (29900 more characters) … {'x' * 50}"
    assert quoted("\x1b" * 100, 3) == r"'\x1b\x1b\x1b...'"


def test_every_control_and_every_sign_that_turns_the_order_is_hidden():
    for code in range(sys.maxunicode + 1):
        character = chr(code)
        turns = unicodedata.bidirectional(character) in TURNING
        if turns or unicodedata.category(character) in ("Cc", "Zl", "Zp", "Cs"):
            assert printable(character) != character, hex(code)
    for mark in "\u200e\u200f\u061c":
        assert printable(mark) != mark


def test_cpp_and_python_hide_the_same(tmp_path):
    """Names of columns are shown as C++ writes them."""
    characters = [
        *(chr(code) for code in range(0xA0, 0x10000) if not 0xD800 <= code < 0xE000),
        *map(chr, (0x7F, 0x80, 0x9B, 0x1F9EA, 0xE0001, 0xE007F, 0xE0100, 0x10FFFF)),
    ]
    # Not what separates names, nor what has no meaning.
    characters = [
        c for c in characters if not c.isspace() and (c.isprintable() or printable(c) != c)
    ]
    path = tmp_path / "a.csv"
    for i in range(0, len(characters), 20000):
        part = characters[i : i + 20000]
        names = [f"n{ord(c)}{c}n" for c in part]
        path.write_text(f"x,y,z,radius,{','.join(names)}\n1,2,3,4{',5' * len(names)}\n")
        found = [name for name in spherepacking.read(path).point_data if name != "radius"]
        assert found == [printable(name) for name in names]


def safe(text):
    return all(c.isprintable() for line in text.splitlines() for c in line)


@pytest.mark.parametrize("name", [f"{ODD}.spheres", f"{ODD}.off", f"{ODD}.csv", f"{ODD}.vtp"])
@pytest.mark.parametrize("command", ["info", "pack", "convert", "render"])
def test_names_of_files(tmp_path, capfd, name, command):
    path = tmp_path / name
    arguments = {
        "info": [str(path)],
        "pack": [str(path), str(tmp_path / "out.spheres")],
        "convert": [str(path), str(tmp_path / "out.spheres")],
        "render": [str(path), "-o", str(tmp_path / "out.png")],
    }[command]
    for content in (None, "OFF \x1b[31mred 1 0\n", "\x1b]0;title\x07,\u202e\n1,2\n"):
        if content is not None:
            path.write_text(content)
        assert main([command, *arguments]) == 2
        out, err = capfd.readouterr()
        assert safe(out + err), ascii(out + err)
        assert SHOWN in err


@pytest.mark.parametrize("extension", ["png", "spheres", "vtp", "csv", "docx"])
def test_names_of_targets(tmp_path, capfd, extension):
    spherepacking.write(spherepacking.apollonian(1), tmp_path / "a.spheres")
    target = tmp_path / f"{ODD}.{extension}"
    target.mkdir()
    source = tmp_path / "a.spheres"
    for command in (["convert", source, target], ["render", source, "-o", target]):
        assert main(list(map(str, command))) == 2
        out, err = capfd.readouterr()
        assert safe(out + err), ascii(out + err)


def test_names_of_arrays(tmp_path, capfd):
    path = tmp_path / "a.csv"
    path.write_text(f"x,y,z,radius,{ODD}\n1,2,3,4,5\n1,2,3,4,5\n")
    mesh = spherepacking.apollonian(2)
    in_xml = ODD.replace("\x1b", "").replace("\x07", "")  # XML has no place for these
    mesh[in_xml] = np.arange(mesh.n_points)
    mesh.save(tmp_path / "a.vtp")
    for name, shown in (("a.csv", SHOWN), ("a.vtp", printable(in_xml))):
        file = str(tmp_path / name)
        assert main(["info", file]) == 0
        assert main(["convert", file, str(tmp_path / "b.spheres")]) == 0
        assert main(["render", file, "-o", str(tmp_path / "a.png"), "--scalars", ODD]) in (0, 2)
        assert main(["info", file, "--radius", "none"]) == 2
        out, err = capfd.readouterr()
        assert shown in out
        assert safe(out + err), ascii(out + err)


def test_arguments(capfd):
    one = ["render", "a", "--size", ODD]
    for arguments in ([ODD], ["info", ODD], ["info", "a", f"--{ODD}"], one):
        assert main(arguments) == 2
        out, err = capfd.readouterr()
        assert safe(out + err), ascii(out + err)


@pytest.mark.parametrize("kind", [PackingFileError, SurfaceFileError])
def test_errors_that_python_shows(kind):
    assert str(kind(ODD)) == SHOWN
    assert len(str(kind("x" * 10**6))) < 1100


def test_messages_are_bounded(tmp_path, capsys):
    names = [f"name_{i}" for i in range(30000)]
    path = tmp_path / "a.csv"
    for header in (",".join(names), "x,y,z,radius," + "n" * 200_000, "x,y,z," + ",".join(names)):
        path.write_text(f"{header}\n1,2,3\n")
        with pytest.raises(PackingFileError) as raised:
            spherepacking.read(path)
        assert len(str(raised.value)) < 1100 + len(str(path))
    mesh = pv.PolyData(np.zeros((1, 3)))
    for name in names[:3000]:
        mesh[name] = [1.0]
    with pytest.raises(PackingFileError) as raised:
        spherepacking.write(mesh, path)
    assert len(str(raised.value)) < 1100 + len(str(path))
    assert "more characters" in str(raised.value) or len(str(raised.value)) < 500


def test_a_traceback_is_harmless(tmp_path):
    """An exception that nobody catches is printed by Python as it is."""
    path = tmp_path / f"{ODD}.spheres"
    code = "import spherepacking, sys; spherepacking.{}"
    for call in (
        "read(sys.argv[1])",
        "write(spherepacking.apollonian(1), sys.argv[1] + '/a.csv')",
        "read_image(sys.argv[1])",
        "write_image(sys.argv[1], [[1.0]])",
        "write_image(sys.argv[1] + '/a.png', [[1.0]])",
    ):
        done = subprocess.run(
            [sys.executable, "-c", code.format(call), path],
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 1
        assert safe(done.stderr), ascii(done.stderr)


def test_names_in_a_progress_bar(tmp_path, monkeypatch, capfd):
    """Rich takes what stands in brackets for markup."""
    path = tmp_path / f"[bold]{ODD}.spheres"
    path.write_text("0 0 0 1\n" * 100_000)
    monkeypatch.setattr("spherepacking.files.packing_file._BAR_DELAY", 0.0)
    assert spherepacking.read(path, progress=True).n_points == 100_000
    out, err = capfd.readouterr()
    assert "\x1b[31m" not in out + err and "\u202e" not in out + err
    assert "[bold]a" in err
