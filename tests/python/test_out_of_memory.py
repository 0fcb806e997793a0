"""Allocations that fail become an exception with a sentence, wherever they fail."""

import os
import subprocess
import sys

import pytest

# Each process does one thing again and again with a little more memory, until it succeeds.
SCRIPT = """
import re, resource, sys
from pathlib import Path

import numpy as np
import pyvista as pv
import spherepacking
from spherepacking.accessor import PackingAccessor

VIEW = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]
path = Path(sys.argv[2])
rng = np.random.default_rng(0)


def make(count):
    packing = pv.PolyData()
    packing.points = rng.uniform(-1, 1, (count, 3))
    packing["radius"] = rng.uniform(0.001, 0.01, count)
    return packing


CALLS = {
    "pick": lambda p: PackingAccessor(p).pick(VIEW, (100, 100), 50, 50),
    "ray_cast": lambda p: PackingAccessor(p).ray_cast(VIEW, (500, 500), color="white"),
    "grid": lambda p: PackingAccessor(p).ray_cast(
        VIEW, (90, 90), color="white", structure="grid"
    ),
    "path_trace": lambda p: PackingAccessor(p).path_trace(VIEW, (300, 300), samples=1),
    "metaballs": lambda p: PackingAccessor(p).metaballs(1.0, dimensions=48, weights=[1, 2]),
    "metaball_field": lambda p: PackingAccessor(p).metaball_field(48, threshold=1.0),
    "bvh_boxes": lambda p: PackingAccessor(p).bvh_boxes(5000),
    "read": lambda p: spherepacking.read(path),
    "write": lambda p: spherepacking.write(p, path),
}
call = CALLS[sys.argv[1]]
spherepacking.write(make(200_000), path)
call(make(100))  # imports, and threads
for room in (0.5, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96):
    packing = make(200_000)
    size = 1024 * int(re.search(r"VmSize:\\s+(\\d+)", Path("/proc/self/status").read_text())[1])
    limit = size + int(room * 2**20)
    resource.setrlimit(resource.RLIMIT_AS, (limit, resource.RLIM_INFINITY))
    try:
        call(packing)
        told = "done"
    except (ValueError, MemoryError) as error:
        told = f"{type(error).__name__}: {error}"
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    print(told, flush=True)
    if told == "done":
        break
"""

# So that memory that was freed is given back, and what is asked for is asked of the system.
MALLOC = {
    "MALLOC_ARENA_MAX": "1",
    "MALLOC_MMAP_THRESHOLD_": "65536",
    "MALLOC_TRIM_THRESHOLD_": "65536",
    "MALLOC_TOP_PAD_": "0",
}


@pytest.mark.skipif(sys.platform != "linux", reason="the limit is Linux's")
@pytest.mark.parametrize(
    "call",
    [
        "pick",
        "ray_cast",
        "grid",
        "path_trace",
        "metaballs",
        "metaball_field",
        "bvh_boxes",
        "read",
        "write",
    ],
)
def test_what_does_not_fit_is_an_exception(call, tmp_path):
    run = subprocess.run(
        [sys.executable, "-c", SCRIPT, call, str(tmp_path / "packing.spheres")],
        env=os.environ | MALLOC,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr[-2000:]
    told = run.stdout.splitlines()
    assert told[-1] == "done"
    # Those that come from Python's own arrays are MemoryErrors.
    ours = [line for line in told if line.startswith("ValueError: ")]
    ours += [line for line in told if line.startswith("PackingFileError: ")]
    assert ours
    assert all("memory" in line for line in ours)


DEVELOP = """
import re, resource
from pathlib import Path

import numpy as np
import pyvista as pv
import spherepacking
from spherepacking.vtkSpherePackingCore import vtkSpherePackingPathTracer

tracer = vtkSpherePackingPathTracer()
tracer.SetInputData(spherepacking.apollonian(3))
camera = pv.Camera()
camera.position, camera.focal_point = (3, 2.5, 2), (0, 0, 0)
tracer.SetCamera(camera)
tracer.SetNumberOfSamples(1)
tracer.SetWindowSize(900, 700)
tracer.Update()
radiance = pv.convert_array(np.ones((900 * 700, 3), np.float32))
color = pv.convert_array(np.zeros((900 * 700, 4), np.uint8))
assert tracer.Develop(radiance, color)
tracer.GetOutput().Initialize()
size = 1024 * int(re.search(r"VmSize:\\s+(\\d+)", Path("/proc/self/status").read_text())[1])
resource.setrlimit(resource.RLIMIT_AS, (size + 2**25, resource.RLIM_INFINITY))
tracer.SetWindowSize(5000, 5000)
tracer.Update()
resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
assert "memory" in tracer.GetErrorMessage()
assert not tracer.Develop(radiance, color)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the limit is Linux's")
def test_a_picture_that_does_not_fit_leaves_nothing_to_develop():
    run = subprocess.run(
        [sys.executable, "-c", DEVELOP],
        env=os.environ | MALLOC,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr[-2000:]
