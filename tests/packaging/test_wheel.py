"""What the wheel carries: our libraries and stubs for every Python they serve, nothing of VTK's."""

import email
import importlib.util
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
MODULES = ("vtkSpherePackingCore", "vtkSpherePackingRendering")

pytestmark = pytest.mark.skipif(
    importlib.util.find_spec("cvista") is None, reason="the wheel is for cvista only"
)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """Return the wheel that scripts/test has just built, or one built for this test."""
    named = os.environ.get("SPHEREPACKING_WHEEL")
    if named:
        return Path(named)
    folder = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "pip", "wheel", "--no-deps", "-w", str(folder), str(ROOT)]
    subprocess.run(command, check=True)
    (path,) = folder.glob("*.whl")
    return path


@pytest.fixture(scope="module")
def names(wheel):
    with zipfile.ZipFile(wheel) as archive:
        return set(archive.namelist())


def read(wheel, suffix):
    with zipfile.ZipFile(wheel) as archive:
        (name,) = [name for name in archive.namelist() if name.endswith(suffix)]
        return archive.read(name).decode()


def test_one_wheel_serves_every_cpython_from_3_12(wheel):
    assert wheel.name.split("-")[2:4] == ["cp312", "abi3"]
    tags = email.message_from_string(read(wheel, ".dist-info/WHEEL")).get_all("Tag")
    assert all(tag.startswith("cp312-abi3-linux") or "manylinux" in tag for tag in tags), tags


def test_the_only_libraries_are_ours(names):
    libraries = {name for name in names if ".so" in Path(name).name}
    expected = {f"spherepacking/lib/lib{module}.so" for module in MODULES}
    expected |= {f"spherepacking/{module}.abi3.so" for module in MODULES}
    assert libraries == expected


def test_everything_lies_in_our_package_and_its_metadata(names):
    tops = {name.split("/")[0] for name in names}
    (info,) = tops - {"spherepacking"}
    assert info.startswith("spherepacking-")
    assert info.endswith(".dist-info")


def test_stubs_and_their_mark_are_there(names):
    assert {f"spherepacking/{module}.pyi" for module in MODULES} <= names
    assert "spherepacking/py.typed" in names


def test_libraries_look_for_vtk_only_in_the_cvista_package(wheel, names, tmp_path):
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path)
    for name in names:
        if not name.endswith(".so"):
            continue
        paths = run_path(tmp_path / name)
        folder = "$ORIGIN/../../cvista" if "/lib/" in name else "$ORIGIN/../cvista"
        assert folder in paths, name
        assert all(path.startswith("$ORIGIN") for path in paths), (name, paths)


def run_path(library):
    """Return the folders of the library's RUNPATH."""
    command = ["readelf", "-d", str(library)]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    (line,) = [line for line in text.splitlines() if "(RUNPATH)" in line or "(RPATH)" in line]
    return line.split("[")[1].rstrip("]").split(":")


def test_metadata(wheel):
    metadata = email.message_from_string(read(wheel, ".dist-info/METADATA"))
    assert metadata["Requires-Python"] == ">=3.12"
    assert metadata["License-Expression"] == "BSD-3-Clause"
    cmake = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    assert f"project(vtkSpherePacking VERSION {metadata['Version']} " in cmake
    pins = [line for line in metadata.get_all("Requires-Dist") if line.startswith("cvista")]
    # The libraries are linked to one build of VTK: build, run and development name the same.
    assert len({pin.split("==")[1].split(";")[0].strip() for pin in pins}) == 1
