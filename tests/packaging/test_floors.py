"""The checks of scripts/lint find what they are for."""

import importlib.util
import json
import shutil
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def script(name):
    """Return a script of the folder scripts as a module."""
    spec = importlib.util.spec_from_file_location(name, ROOT / "scripts" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def write(folder, files):
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def test_the_plan_holds(capsys):
    assert script("check_includes").main(ROOT / "vtkSpherePacking") == 0
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("Core/base/Low.h", '#include "trace/High.h"\n', "Low.h:1: found trace/High.h in base/"),
        ("Core/packer/Side.h", '\n#include "trace/High.h"\n', "Side.h:2: found trace/High.h"),
        ("Core/trace/Vtk.h", '#include "vtkPolyData.h"\n', "expected no VTK in trace/"),
        ("Core/bridge/Up.cxx", '#include "vtkOwn.h"\n', "found vtkOwn.h in bridge/"),
        ("Core/base/Low.h", "#include <trace/High.h>\n", "Low.h:1: found trace/High.h in base/"),
        ("Core/trace/Vtk.h", "#include <vtkPolyData.h>\n", "expected no VTK in trace/"),
        ("Core/base/Low.hpp", '#include "trace/High.h"\n', "Low.hpp:1: found trace/High.h"),
        ("Core/base/Low.h", '/* x */ # include "trace/High.h"\n', "Low.h:1: found trace/High.h"),
        ("Core/bridge/Up.cxx", '#include "vtkMapper.h"\n', "found vtkMapper.h of Rendering"),
        ("Core/attic/Old.h", "", "found the room attic"),
        ("Rendering/impostor/Up.h", '#include "vtkMapper.h"\n', "found vtkMapper.h in impostor/"),
        ("Rendering/Other.h", '#include "trace/High.h"\n', "expected a wrapped class"),
        ("Core/trace/Round.h", '#include "trace/High.h"\n', "a circle of includes"),
    ],
)
def test_an_include_against_the_plan(tmp_path, capsys, name, text, told):
    good = {
        "Core/base/Sphere.h": "",
        "Core/trace/High.h": '#include "base/Sphere.h"\n#include "trace/Round.h"\n',
        "Core/trace/Round.h": "",
        "Core/vtkOwn.h": '#include "trace/High.h"\n#include "vtkPolyData.h"\n',
        "Rendering/vtkMapper.h": '#include "vtkOwn.h"\n',
    }
    write(tmp_path, good)
    check = script("check_includes")
    assert check.main(tmp_path) == 0
    write(tmp_path, {name: text})
    assert check.main(tmp_path) == 1
    assert told in capsys.readouterr().out


def test_no_import_goes_through_the_root(capsys):
    assert script("check_imports").main(ROOT / "python" / "spherepacking") == 0
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("checks.py", "from spherepacking import pack\n", "an import of pack from"),
        ("checks.py", "def f():\n    import spherepacking\n", "checks.py:2: found"),
        ("trace/sky.py", "from .. import read, __version__\n", "an import of read from"),
        ("trace/sky.py", "import importlib\nimportlib.import_module('x.cli')\n", "sky.py:2: found"),
    ],
)
def test_an_import_through_the_root(tmp_path, capsys, name, text, told):
    folder = tmp_path / "spherepacking"
    good = {
        "__init__.py": "import importlib\nimportlib.import_module('.checks')\n",
        "checks.py": "from spherepacking import __version__\n",
        "trace/sky.py": "from .. import __version__, checks\nfrom . import rays\n",
        "trace/rays.py": "",
    }
    write(folder, good)
    check = script("check_imports")
    assert check.main(folder) == 0
    write(folder, {name: text})
    assert check.main(folder) == 1
    assert told in capsys.readouterr().out


@pytest.mark.skipif(
    not shutil.which("c++") or sys.platform != "linux", reason="needs a compiler and nm"
)
@pytest.mark.parametrize("shared", [False, True])
def test_a_symbol_that_others_could_take(tmp_path, capsys, shared):
    inner = "inline int shared(int x) { return x + 1; }"
    scope = inner if shared else f"namespace Avx2 {{ {inner} }} using Avx2::shared;"
    # Through a pointer, so that it is not inlined.
    text = f"{scope}\nint (*pointer)(int) = &shared;\n"
    source = tmp_path / "SumAvx2.cxx"
    source.write_text(text)
    entry = {"file": str(source), "command": f"c++ -fPIC -o x.o -c {source}", "directory": "/"}
    (tmp_path / "compile_commands.json").write_text(json.dumps([entry]))
    assert script("check_symbols").main(tmp_path) == int(shared)
    assert ("found shared(int)" in capsys.readouterr().out) == shared
