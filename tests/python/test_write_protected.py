"""Files and folders that the user may not write to stay as they are, whatever the format."""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

# Nothing is protected from root, so root becomes nobody once all is imported.
CODE = """
import os, sys
import numpy as np, pyvista as pv, spherepacking
packing = spherepacking.apollonian(2)
spherepacking.write(packing, sys.argv[2])
spherepacking.write_image(sys.argv[3], np.zeros((2, 2)))
if os.getuid() == 0:
    os.setresuid(65534, 65534, 65534)
try:
    if sys.argv[1].endswith("png"):
        spherepacking.write_image(sys.argv[1], np.zeros((2, 2)))
    else:
        spherepacking.write(packing, sys.argv[1])
except (OSError, ValueError) as error:
    print(error)
"""


@pytest.fixture
def folder():
    """A folder that everybody may write to; those of pytest are private."""
    path = Path(tempfile.mkdtemp())
    path.chmod(0o777)
    yield path
    path.chmod(0o777)
    shutil.rmtree(path)


def write(path, scratch):
    done = subprocess.run(
        [sys.executable, "-c", CODE, path, scratch / "a.csv", scratch / "a.png"],
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout


@pytest.mark.parametrize("name", ["a.png", "a.spheres", "a.csv", "a.vtp"])
def test_a_write_protected_file_is_not_replaced(folder, tmp_path, name):
    path = folder / name
    path.write_text("earlier work")
    path.chmod(0o444)
    assert write(path, tmp_path).startswith(f"{path}: found a file that is write-protected")
    assert path.read_text() == "earlier work"
    assert os.listdir(folder) == [name]


@pytest.mark.parametrize("name", ["a.png", "a.spheres", "a.csv", "a.vtp"])
def test_a_write_protected_folder(folder, tmp_path, name):
    folder.chmod(0o555)
    message = write(folder / name, tmp_path)
    assert message.startswith(f"{folder / name}: ")
    assert "expected a folder that can be written to" in message or "found a folder" in message
    assert os.listdir(folder) == []


@pytest.mark.parametrize("name", ["a.png", "a.spheres", "a.csv", "a.vtp"])
def test_what_may_be_written_is(folder, tmp_path, name):
    assert write(folder / name, tmp_path) == ""
    assert os.listdir(folder) == [name]
