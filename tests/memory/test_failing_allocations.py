"""The n-th allocation of a call fails, for n = 1, 2, 3, …: a sentence each time, and no crash."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent
CALLS = [
    *("read", "steps", "write", "pack", "pick", "ray_cast", "ray_cast_grid", "path_trace"),
    *("metaball_field", "strongest", "multilevel", "metaballs", "contacts"),
    *("bvh_boxes", "grid_boxes", "draw"),
]


@pytest.fixture(scope="module")
def shim(tmp_path_factory):
    library = tmp_path_factory.mktemp("shim") / "failing.so"
    subprocess.run(
        ["g++", "-std=c++17", "-O1", "-fPIC", "-shared", HERE / "failing.cxx", "-o", library],
        check=True,
    )
    return library


@pytest.mark.skipif(sys.platform != "linux", reason="preloading is Linux's")
@pytest.mark.parametrize("call", CALLS)
def test_every_allocation_may_fail(call, shim, tmp_path):
    run = subprocess.run(
        [sys.executable, HERE / "calls.py", call, tmp_path],
        env=os.environ | {"LD_PRELOAD": str(shim)},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    said = run.stdout.splitlines()
    assert run.returncode == 0, f"{said[-1:]}\n{run.stderr[-3000:]}"
    done, tries, last = said[-1].split()
    assert done == "done"
    assert int(tries) > 0, "nothing has been made to fail"
    print(f"\n{call}: {tries} tries, up to the {last}th allocation")
