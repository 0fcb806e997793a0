"""The scripts of examples/ run alone and leave what they say."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import spherepacking

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
GALLERY = [path.name for path in sorted(EXAMPLES.glob("plot_*.py"))]
# pytest only skips what has no parameters.
assert GALLERY, f"no plot_*.py in {EXAMPLES}"


def run(script, *arguments, cwd):
    return subprocess.run(
        [sys.executable, "-W", "error", str(EXAMPLES / script), *map(str, arguments)],
        cwd=cwd,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


def test_the_saved_packing_is_what_the_script_makes(tmp_path):
    result = run("make_apollonian.py", tmp_path / "new.spheres", cwd=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    saved = EXAMPLES / "apollonian.spheres"
    assert (tmp_path / "new.spheres").read_bytes() == saved.read_bytes()
    assert saved.stat().st_size < 300_000


def test_the_saved_packing_is_exact():
    packing = spherepacking.read(EXAMPLES / "apollonian.spheres")
    made = spherepacking.apollonian(6)
    assert np.array_equal(packing.points, made.points)
    assert np.array_equal(packing["radius"], made["radius"])


@pytest.mark.parametrize("script", GALLERY)
def test_gallery_scripts_leave_a_picture(tmp_path, script):
    result = run(script, cwd=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    pictures = list(tmp_path.iterdir())
    assert len(pictures) == 1
    assert spherepacking.read_image(pictures[0]).std() > 20
