"""Hashes of what every technique makes of scenes, hard ones among them, to compare two builds.

    python benchmarks/outputs.py > before.json
    python benchmarks/outputs.py --against before.json

A change that is to change no result, such as moving code, has to leave every hash as it was. The
second form prints what differs and exits with status 1 when anything does. ``scripts/compare``
builds two commits and runs this with both. Only what users see is used, so that older commits run
it, too: the accessor, the plotter component, the functions of the package and the command line.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import io
import json
import os
import re
import sys
import tempfile
import warnings
from pathlib import Path

import numpy as np
import pyvista as pv
import spherepacking
from spherepacking.__main__ import main as command

if sys.platform.startswith("linux"):
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkOSOpenGLRenderWindow")

VIEW = [(3.1, 2.9, 2.2), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]
# Seconds and bytes are not results; boxes are compared under names of their own.
CLOCKS = re.compile(r"seconds|memory_bytes")


# --- scenes ---------------------------------------------------------------------------------------


def packing_of(centers: np.ndarray, radii: np.ndarray) -> pv.PolyData:
    packing = pv.PolyData()
    packing.points = np.asarray(centers)
    packing["radius"] = np.asarray(radii)
    packing.set_active_scalars("radius", preference="point")
    return packing


def cloud(count: int, seed: int, kind: type = float) -> pv.PolyData:
    rng = np.random.default_rng(seed)
    radii = 0.35 * np.arange(1, count + 1) ** -0.36
    return packing_of(rng.uniform(-1, 1, (count, 3)).astype(kind), radii.astype(kind))


def scenes() -> dict[str, pv.PolyData]:
    """Packings about 2 wide around the origin, but for those that are hard because they are not."""
    rng = np.random.default_rng(7)
    shells = packing_of(np.tile([0.1, 0.2, -0.1], (40, 1)), np.linspace(0.02, 0.9, 40))
    twice = cloud(300, 1)
    twice = packing_of(np.repeat(twice.points, 2, 0), np.repeat(twice["radius"], 2))
    spiral = np.arange(60)[:, None]
    deep = 0.5**spiral * np.column_stack([np.cos(spiral), np.sin(spiral), 0.3 * spiral / 60])
    lattice = np.stack(np.meshgrid(*[np.linspace(-1, 1, 25)] * 2, [0.0]), -1).reshape(-1, 3)
    zeros = cloud(400, 3)
    zeros["radius"][::3] = 0.0
    integers = packing_of(rng.integers(-9, 9, (200, 3)).astype(np.float32) / 9, np.ones(200, int))
    integers["radius"] = rng.integers(0, 2, 200)
    integers.points *= 5.0
    arrays = cloud(700, 4)
    arrays["height"] = arrays.points[:, 2].copy()
    arrays["height"][::9] = np.nan
    arrays.set_active_scalars("height", preference="point")
    far, small, large = cloud(500, 5), cloud(500, 5), cloud(500, 5)
    far.points += [1e7, -2e7, 5e6]
    small.points *= 1e-12
    small["radius"] *= 1e-12
    large.points *= 1e12
    large["radius"] *= 1e12
    return {
        "many, single precision": cloud(20_000, 0, np.float32),
        "many, double precision": cloud(6000, 0),
        "apollonian": spherepacking.apollonian(5),
        "concentric": shells,
        "every sphere twice": twice,
        "sizes that fall exponentially": packing_of(deep, 0.3 * 0.5 ** spiral[:, 0]),
        "a lattice in a plane": packing_of(lattice, np.full(len(lattice), 0.04)),
        "radii of 0": zeros,
        "integer radii": integers,
        "NaN among the scalars": arrays,
        "far from the origin": far,
        "tiny": small,
        "huge": large,
        "one sphere": packing_of(np.zeros((1, 3)), np.ones(1)),
        "one sphere of radius 0": packing_of(np.zeros((1, 3)), np.zeros(1)),
        "none": packing_of(np.empty((0, 3)), np.empty(0)),
    }


def view_of(packing: pv.PolyData) -> list[np.ndarray]:
    """The same direction for each, from a distance that suits."""
    if not packing.n_points:
        return VIEW
    box = np.reshape(packing.packing.bounds, (3, 2))
    middle, size = box.mean(axis=1), float(np.ptp(box, axis=1).max()) or 1.0
    return [middle + size * np.array(VIEW[0]) / 2, middle, np.array(VIEW[2])]


# --- hashes ---------------------------------------------------------------------------------------


def hash_of(*arrays: object) -> str:
    """Of values, types and shapes; NaN is NaN whatever its bits."""
    digest = hashlib.sha256()
    for array in arrays:
        values = np.ascontiguousarray(array)
        if values.dtype.kind == "f":
            values = np.where(np.isnan(values), np.array(np.nan, values.dtype), values)
        digest.update(f"{values.dtype} {values.shape} ".encode())
        digest.update(values.tobytes())
    return digest.hexdigest()[:16]


def hash_of_data(data: pv.DataSet) -> str:
    """Of points, cells and all arrays, but for clocks."""
    parts: list[object] = [data.dimensions, data.origin, data.spacing] if is_image(data) else []
    if isinstance(data, pv.PolyData):
        parts += [data.points, data.faces, data.lines, data.verts]
    for fields in (data.point_data, data.cell_data, data.field_data):
        for name in sorted(fields.keys()):
            if not CLOCKS.search(name):
                parts += [name, fields[name]]
    return hash_of(*parts)


def is_image(data: pv.DataSet) -> bool:
    return isinstance(data, pv.ImageData)


class Outputs:
    """Collects hashes by name; what is raised is a result, too."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.hashes: dict[str, str] = {}

    def add(self, name: str, make: object) -> None:
        try:
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                made = make()
        except (KeyError, OSError, RuntimeError, TypeError, ValueError) as error:
            self.hashes[name] = f"{type(error).__name__}: {error}".replace(str(self.folder), "")
            return
        self.hashes[name] = hash_of_data(made) if isinstance(made, pv.DataSet) else hash_of(made)
        if caught:
            self.hashes[name] += f" {caught[0].category.__name__}: {caught[0].message}"


# --- techniques -----------------------------------------------------------------------------------


def cast(outputs: Outputs, name: str, packing: pv.PolyData) -> None:
    spheres, view, size = packing.packing, view_of(packing), (150, 120)
    for structure in ("bvh", "grid", "none"):
        if structure != "none" or packing.n_points < 1000:
            how = {"structure": structure, "samples": 2}
            outputs.add(
                f"{name}/ray cast/{structure}", lambda h=how: spheres.ray_cast(view, size, **h)
            )
    camera = pv.Camera()
    camera.position, camera.focal_point, camera.up = view
    camera.enable_parallel_projection()
    camera.parallel_scale = 0.6 * float(np.linalg.norm(np.subtract(view[0], view[1])))
    outputs.add(f"{name}/ray cast/parallel", lambda: spheres.ray_cast(camera, size, tile=37))
    inside = [view[1], view[0], view[2]]
    outputs.add(f"{name}/ray cast/inside", lambda: spheres.ray_cast(inside, size))
    outputs.add(
        f"{name}/ray cast/random colours", lambda: spheres.ray_cast(view, size, random_colors=True)
    )

    def picks() -> list[float]:
        numbers: list[float] = []
        for x, y in np.random.default_rng(2).uniform(0, 1, (40, 2)) * size:
            found = spheres.pick(view, size, x, y)
            numbers += [-1.0] if found is None else [found.sphere_id, *found.point, *found.normal]
        return numbers

    outputs.add(f"{name}/pick", picks)


def trace(outputs: Outputs, name: str, packing: pv.PolyData) -> None:
    spheres, view, size = packing.packing, view_of(packing), (70, 50)
    image = np.random.default_rng(3).gamma(0.3, 2.0, (16, 32, 3)).astype(np.float32)
    sun = spherepacking.Sun((1, 0.4, 0.7), (3.0, 2.5, 2.0), 4.0)
    skies = {"white": {}, "sun": {"sun": sun, "sky": (0.1, 1.0)}, "image": {"sky": image}}
    for kind, light in skies.items():
        for structure in ("bvh", "grid") if kind == "sun" else ("bvh",):
            # Another seed, so that it does not go on with the picture of the other structure.
            how = {"samples": 6, "max_bounces": 7, "structure": structure, "filmic": True} | light
            how["seed"] = len(structure)
            outputs.add(
                f"{name}/path trace/{kind}, {structure}",
                lambda h=how: spheres.path_trace(view, size, scalars="radius", **h),
            )
    # Goes on with the picture of before.
    outputs.add(
        f"{name}/path trace/more",
        lambda: spheres.path_trace(
            view, size, scalars="radius", seed=3, samples=11, max_bounces=7, sky=image, filmic=True
        ),
    )
    outputs.add(
        f"{name}/path trace/noise target",
        lambda: spheres.path_trace(
            view, size, samples=64, noise_target=0.05, sky=image, sky_visible=False, exposure=0.5
        ),
    )


def metaballs(outputs: Outputs, name: str, packing: pv.PolyData) -> None:
    spheres = packing.packing
    for kernel in ("inverse", "inverse_square", "gaussian", "wyvill"):
        wanted = {"gradient": True, "strongest": True, "blend": True, "kernel": kernel}
        outputs.add(f"{name}/field/{kernel}", lambda w=wanted: spheres.metaball_field(24, **w))
        outputs.add(
            f"{name}/surface/{kernel}",
            lambda k=kernel: spheres.metaballs(0.9, dimensions=28, kernel=k, coloring="strongest"),
        )
    outputs.add(f"{name}/field/sum by sum", lambda: spheres.metaball_field(20, relative_error=0.0))
    outputs.add(f"{name}/field/tight", lambda: spheres.metaball_field(40, relative_error=3e-5))
    outputs.add(
        f"{name}/field/weights",
        lambda: spheres.metaball_field((30, 20, 9), weights=[1, 0, 3], count=60, threshold=1.1),
    )
    outputs.add(f"{name}/field/large grid", lambda: spheres.metaball_field(72))


def boxes(outputs: Outputs, name: str, packing: pv.PolyData) -> None:
    spheres = packing.packing
    outputs.add(f"{name}/boxes/bvh", lambda: spheres.bvh_boxes(40, leaves_only=False))
    outputs.add(f"{name}/boxes/bvh by depth", lambda: spheres.bvh_boxes(depth=5))
    outputs.add(f"{name}/boxes/grid", lambda: spheres.grid_boxes(9, as_lines=True))


def draw(outputs: Outputs, name: str, packing: pv.PolyData) -> None:
    def window(add: object, **kwargs: object) -> np.ndarray:
        plotter = pv.Plotter(off_screen=True, window_size=(160, 120), **kwargs)
        plotter.render_window.SetMultiSamples(0)
        try:
            add(plotter)
            plotter.camera_position = [tuple(map(float, point)) for point in view_of(packing)]
            plotter.renderer.ResetCameraClippingRange()
            return plotter.screenshot(return_img=True)
        finally:
            plotter.close()

    def peel(plotter: pv.Plotter) -> None:
        plotter.enable_depth_peeling(8)
        plotter.packing.add(packing, opacity=0.4, show_scalar_bar=False, specular=0.4)

    outputs.add(f"{name}/window/lit", lambda: window(lambda p: p.packing.add(packing)))
    outputs.add(f"{name}/window/peeled", lambda: window(peel))
    outputs.add(
        f"{name}/window/headlight, parallel",
        lambda: window(
            lambda p: (p.packing.add(packing, color="red"), p.enable_parallel_projection()),
            lighting="none",
        ),
    )
    if packing.n_points and packing.n_points < 1000:
        outputs.add(
            f"{name}/window/path traced",
            lambda: window(lambda p: p.packing.path_trace(packing, samples=3)),
        )
        outputs.add(
            f"{name}/window/metaballs",
            lambda: window(lambda p: p.packing.add_metaballs(packing, dimensions=24)),
        )


def files(outputs: Outputs, name: str, packing: pv.PolyData) -> None:
    for extension in ("spheres", "xyzr", "txt", "csv", "xyzd"):
        path = outputs.folder / f"packing.{extension}"

        def bytes_of(path: Path = path) -> np.ndarray:
            spherepacking.write(packing, path)
            return np.frombuffer(path.read_bytes(), np.uint8)

        outputs.add(f"{name}/file/{extension}", bytes_of)
        if path.exists():
            outputs.add(f"{name}/read/{extension}", lambda p=path: spherepacking.read(p))
            outputs.add(
                f"{name}/read single/{extension}",
                lambda p=path: spherepacking.read(p, precision="single"),
            )
            path.unlink()


def packings(outputs: Outputs) -> None:
    star = pv.Icosphere(radius=1.0, nsub=3)
    star.points *= 1.0 + 0.5 * (np.arange(star.n_points) % 5 == 0)[:, None]
    shells = pv.Sphere(radius=1.0).merge(pv.Sphere(radius=0.5)).merge(pv.Cube(center=(0.9, 0, 0)))
    surfaces = {
        "cube": pv.Cube(),
        "spikes": star,
        "shells": shells.extract_surface(algorithm=None),
        "thin": pv.Cube(x_length=1, y_length=1, z_length=1e-3),
        "far": pv.Cube().translate((1e6, 0, 0)),
        "ant": pv.read(pv.examples.antfile),
        "open": pv.Plane(),
    }
    for name, mesh in surfaces.items():
        outputs.add(f"pack/{name}", lambda m=mesh: spherepacking.pack(m, 300, seed=2))


def lines(outputs: Outputs) -> None:
    """The command line: what it prints, and the pixels that it writes."""
    folder = outputs.folder
    source = folder / "packing.csv"
    spherepacking.write(spherepacking.apollonian(4), source)

    def run(*words: str) -> np.ndarray:
        picture = folder / "picture.exr"
        out = io.StringIO()
        arguments = [str(source) if word == "PACKING" else word for word in words]
        draws = words[0] == "render" and "--help" not in words
        if draws:
            arguments += ["-o", str(picture), "--size", "140", "100"]
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            sys.argv = ["spherepacking", *arguments]
            status = command()
        text = out.getvalue().replace(str(folder), "")
        pixels = spherepacking.read_image(picture) if draws else np.empty(0)
        return np.array([hash_of(text), hash_of(status), hash_of(pixels)])

    for words in (
        "info PACKING",
        "info nothing.csv",
        "--help",
        "render --help",
        "render PACKING",
        "render PACKING --technique raycast --background white",
        "render PACKING --technique pathtrace --samples 4 --sun 1 0 1",
        "render PACKING --technique metaballs --dimensions 40 --kernel wyvill",
        "render PACKING --technique bvh --opacity 0.5",
        "render PACKING --technique grid --parallel",
    ):
        outputs.add(f"command/{words}", lambda w=words: run(*w.split()))


def everything() -> dict[str, str]:
    pv.OFF_SCREEN = True
    with tempfile.TemporaryDirectory() as name:
        outputs = Outputs(Path(name))
        for title, packing in scenes().items():
            print(title, file=sys.stderr)
            for technique in (cast, trace, metaballs, boxes, draw, files):
                technique(outputs, title, packing)
        # So many that the field's smooth part is summed on grids.
        crowd = cloud(100_000, 8, np.float32).packing
        outputs.add("crowd/field", lambda: crowd.metaball_field(128))
        packings(outputs)
        lines(outputs)
        return outputs.hashes


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--against", type=Path, help="what another build printed")
    before = parser.parse_args().against
    now = everything()
    if before is None:
        json.dump(now, sys.stdout, indent=1)
        return 0
    then = json.loads(before.read_text())
    other = [name for name in sorted(then.keys() | now.keys()) if then.get(name) != now.get(name)]
    for name in other:
        print(f"{name}\n  was {then.get(name)}\n  is  {now.get(name)}")
    print(f"{len(now) - len(other)} of {len(now)} results of {len(scenes())} scenes are the same")
    return 1 if other else 0


if __name__ == "__main__":
    sys.exit(main())
