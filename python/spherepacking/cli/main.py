"""The command ``spherepacking``."""

from __future__ import annotations

import os
import signal
import sys
from inspect import signature
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import App, CycloptsError, Parameter

if TYPE_CHECKING:
    from collections.abc import Sequence

    from cyclopts import Token

Vector = tuple[float, float, float]
Technique = Literal["opengl", "raycast", "pathtrace", "metaballs", "bvh", "grid"]
Kernel = Literal["inverse", "inverse_square", "gaussian", "wyvill"]
Output = Annotated[Path, Parameter(alias="-o")]


def _whole(_: type, tokens: Sequence[Token]) -> int:
    """Not rounded, as cyclopts would do."""
    (token,) = tokens
    try:
        return int(token.value)
    except ValueError:
        raise ValueError(f"found {token.value}, expected an integer") from None


Whole = Annotated[int, Parameter(converter=_whole)]


def _version() -> str:
    from .. import __version__

    return f"spherepacking {__version__}"


app = App(
    name="spherepacking",
    help="See sphere packings: exact ray-cast spheres.",
    version=_version,
    version_format="plaintext",
    suppress_keyboard_interrupt=False,
)


def _load(*, drawing: bool = False) -> None:
    """Import what takes long. Ctrl-C waits, since libraries may crash when it comes then.

    PyVista imports what draws when it is asked for, and some of that by the first plotter.
    """
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        import pyvista as pv

        from .. import backend  # noqa: F401
        from ..files import image, readers, writers  # noqa: F401

        if drawing:
            pv.Plotter(off_screen=True).close()
    finally:
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


def _read(path: Path) -> object:
    from ..files.readers import read

    return read(path, progress=sys.stderr.isatty())


@app.command
def render(
    packing: Path,
    /,
    *,
    output: Output,
    scalars: str | None = None,
    cmap: str | None = None,
    clim: tuple[float, float] | None = None,
    log_scale: bool | None = None,
    color: str | None = None,
    opacity: float = 1.0,
    scalar_bar: bool = True,
    size: tuple[int, int] = (1000, 1000),
    camera: Vector | None = None,
    focal: Vector | None = None,
    up: Vector | None = None,
    view_angle: float | None = None,
    zoom: float = 1.0,
    parallel: bool = False,
    background: str | None = None,
    transparent: bool = False,
    anti_aliasing: bool = True,
    technique: Technique = "opengl",
    structure: Literal["bvh", "grid", "none"] = "bvh",
    samples: Whole | None = None,
    boxes: Whole = 15,
    cuts: Whole = 6,
    max_bounces: Whole = 4,
    albedo: float = 0.8,
    sky: Annotated[list[str] | None, Parameter(consume_multiple=True, negative=())] = None,
    sun: Vector | None = None,
    sun_radiance: float = 1.0,
    sun_diameter: float = 0.53,
    seed: Whole = 0,
    time_budget: float | None = None,
    noise_target: float | None = None,
    exposure: float = 0.0,
    filmic: bool = False,
    denoise: bool = False,
    threshold: float = 1.0,
    kernel: Kernel = "inverse",
    weights: Annotated[list[float] | None, Parameter(consume_multiple=True, negative=())] = None,
    count: Whole | None = None,
    dimensions: Whole = 128,
) -> None:
    """Draw a packing and save the picture.

    Parameters
    ----------
    packing
        File with the packing.
    output
        Picture to write; its extension decides about the format (.png, .exr, .tif, .jpg, ...).
    scalars
        Array to colour by; the radii, unless all are equal, if neither this nor --color is given.
    cmap
        Colour map, for example viridis.
    clim
        Range of the scalars that the colour map spans.
    log_scale
        Map the scalars logarithmically; by default for radii that span more than a factor of 20.
    color
        One colour for all spheres, a name or #rrggbb.
    opacity
        From 0 to 1.
    scalar_bar
        Show a scalar bar.
    size
        Width and height of the picture in pixels.
    camera
        Position of the camera; by default the packing fills the picture, seen along (-1, -1, -1).
    focal
        Point that the camera looks at; by default the middle of the packing.
    up
        Direction that is up in the picture, by default z.
    view_angle
        Angle of view from bottom to top in degrees.
    zoom
        Enlarge by this factor.
    parallel
        Parallel instead of perspective projection.
    background
        Colour behind the spheres, a name or #rrggbb.
    transparent
        Leave the background transparent.
    anti_aliasing
        Smooth edges, by drawing a larger picture and averaging it, or with opacity below 1 by a
        filter over the picture.
    technique
        opengl draws as in a window; raycast casts rays on the processor, lit from the camera, and
        pathtrace follows paths of light to a sky and a sun, both without a scalar bar; metaballs
        draws the surface on which what all spheres add has a value; bvh and grid draw the boxes of
        these structures around the spheres.
    structure
        How raycast and pathtrace find spheres; it makes a difference to the time only.
    samples
        n for n x n rays a pixel with raycast, by default 2 with anti-aliasing, else 1; or paths a
        pixel with pathtrace, by default 16.
    boxes
        Number of boxes with bvh.
    cuts
        How often grid cuts each axis.
    max_bounces
        How many spheres a path may visit; 1 for direct light alone.
    albedo
        What part of the light a white sphere reflects.
    sky
        Radiance of the sky with pathtrace: a number; two for the bottom and the top; red, green and
        blue; or an equirectangular image. It is seen behind the spheres, unless --background or
        --transparent is given; the light in an EXR file always has it.
    sun
        Direction towards a sun with pathtrace.
    sun_radiance
        What it lends to a white surface that faces it.
    sun_diameter
        Its diameter in degrees.
    seed
        Seed of the random numbers with pathtrace.
    time_budget
        Seconds that pathtrace may take.
    noise_target
        Relative error at which a part of the picture gets no more samples with pathtrace.
    exposure
        Light counts 2 to this power times with pathtrace.
    filmic
        A filmic curve with pathtrace instead of cutting light off at white.
    denoise
        Take the noise out of what pathtrace made, by Open Image Denoise.
    threshold
        Value of the surface of metaballs; at 1 a sphere alone is its own surface.
    kernel
        What a sphere of radius r adds at the distance d with metaballs: r / d, its square, a
        Gaussian, or Wyvill's polynomial, which ends at 2 r.
    weights
        Weights with metaballs, each for an equal share of the spheres from large to small.
    count
        Use this many of the largest spheres with metaballs.
    dimensions
        Points of the grid along each axis with metaballs.
    """
    given = dict(locals())
    from ..draw.offscreen import choose_window

    choose_window()
    _load(drawing=True)

    from ..files.image import check_output
    from .camera import aim, check_extent, fit
    from .options import (
        SCALAR_BAR,
        check_technique,
        check_view,
        look_of,
        set_background,
        set_quality,
    )
    from .techniques import add_boxes, add_metaballs, light_of, save_path_trace, save_ray_cast

    defaults = {name: found.default for name, found in signature(render).parameters.items()}
    check_technique(given, defaults)
    check_output(output)
    check_view(size, zoom, view_angle, anti_aliasing)
    cast = technique in ("raycast", "pathtrace")
    if cast and opacity != 1.0:
        raise ValueError(f"--opacity: found {opacity}, expected 1 with --technique {technique}")

    import pyvista as pv

    spheres = _read(packing)
    check_extent(str(packing), spheres)
    plotter = pv.Plotter(off_screen=True, window_size=list(size))
    try:
        set_background(plotter, background)
        set_quality(plotter, opacity, anti_aliasing)
        look = look_of(plotter, spheres, scalars, cmap, clim, log_scale, color)
        shine = {"opacity": opacity, "specular": 0.3, "specular_power": 20.0}
        shown = spheres
        if technique == "metaballs":
            words = {"threshold": threshold, "kernel": kernel, "weights": weights}
            words |= {"count": count, "dimensions": dimensions}
            shown = add_metaballs(plotter, spheres, words | look | shine)
        else:
            bar = scalar_bar and not cast
            plotter.packing.add(
                spheres, **look, **shine, show_scalar_bar=bar, scalar_bar_args=SCALAR_BAR
            )
        if technique in ("bvh", "grid"):
            shown = add_boxes(plotter, spheres, technique, boxes, cuts)
        aim(plotter.camera, camera, focal, up)
        if view_angle is not None:
            plotter.camera.view_angle = view_angle
        elif camera is None and focal is None and spheres.n_points:
            # The scalar bar needs room at the bottom, in pixels, since its letters do.
            room = 110.0 / size[1] if len(plotter.scalar_bars) else 0.04
            fit(plotter.camera, shown, size, max(1.0 - 2.0 * room, 0.5))
        if parallel:
            plotter.enable_parallel_projection()
        plotter.camera.zoom(zoom)
        if technique == "raycast":
            samples = (2 if anti_aliasing else 1) if samples is None else samples
            words = {"window_size": size, "structure": structure, "samples": samples}
            save_ray_cast(plotter, spheres, output, transparent, words | look)
            return
        if technique == "pathtrace":
            behind = "nothing" if transparent else "sky" if background is None else "background"
            words = {
                "window_size": size,
                "structure": structure,
                "samples": 16 if samples is None else samples,
                "max_bounces": max_bounces,
                "albedo": albedo,
                "seed": seed,
                "time_budget": time_budget,
                "noise_target": noise_target,
                "exposure": exposure,
                "filmic": filmic,
                "denoise": denoise,
            }
            if look["scalars"] is None and look["color"] is None:
                look["scalars"] = spheres.point_data.active_scalars_name
            light = light_of(sky, sun, sun_radiance, sun_diameter)
            save_path_trace(plotter, spheres, output, behind, words | light | look)
            return
        plotter.renderer.ResetCameraClippingRange()
        plotter.packing.screenshot(output, transparent_background=transparent)
    finally:
        plotter.close()


@app.command
def info(packing: Path, /) -> None:
    """Print count, bounds, radii and volume of a packing.

    Parameters
    ----------
    packing
        File with the packing.
    """
    _load()

    from .info import describe

    print(describe(_read(packing)))


@app.command
def convert(source: Path, target: Path, /) -> None:
    """Write a packing in another format.

    Parameters
    ----------
    source
        File with the packing.
    target
        File to write; its extension decides about the format.
    """
    _load()

    from ..files.writers import write

    source, target = source.expanduser(), target.expanduser()
    if target.exists() and source.exists() and target.samefile(source):
        raise ValueError(f"{target}: found the source as the target, expected another file")
    write(_read(source), target)


@app.command
def pack(
    mesh: Path,
    target: Path,
    /,
    *,
    count: Whole = 1000,
    seed: Whole = 0,
    min_radius: float | None = None,
    fraction: float | None = None,
) -> None:
    """Fill a closed surface with spheres and write the packing.

    Ctrl-C ends it and writes the spheres that are there.

    Parameters
    ----------
    mesh
        File with the surface, of any format that PyVista reads, or .off.
    target
        File to write; its extension decides about the format.
    count
        How many spheres at most, whatever else is asked for.
    seed
        Another number gives another packing.
    min_radius
        Radii are above this, in the unit of the surface. For all such spheres, give a large count.
    fraction
        Part of the volume that is enough, above 0 and up to 1, if the count allows it.
    """
    _load()

    from .pack import pack_file

    if not pack_file(
        mesh.expanduser(),
        target.expanduser(),
        count=count,
        seed=seed,
        min_radius=min_radius,
        fraction=fraction,
    ):
        raise KeyboardInterrupt


@app.command
def bench(
    *,
    counts: Annotated[tuple[int, ...], Parameter(consume_multiple=True, negative=())] = (
        5_000,
        50_000,
        100_000,
        200_000,
        300_000,
        1_000_000,
    ),
    only: Annotated[list[str] | None, Parameter(consume_multiple=True, negative=())] = None,
    size: tuple[int, int] = (1000, 1000),
    turns: Whole = 5,
    limit: float = 20.0,
    csv: Path = Path("bench.csv"),
    png: Path = Path("bench.png"),
) -> None:
    """Measure speed beside error on this machine, of this package and of others that are there.

    Every technique makes pictures of polydisperse packings in a knotted tube, seen from (3, 3, 3);
    they take turns. What it shows is compared with float64 rays. Fields of metaballs are compared
    with float64 sums. Ctrl-C keeps the counts that are done.

    Parameters
    ----------
    counts
        Numbers of spheres, each from 100 on.
    only
        Measure techniques with one of these words in their name alone: ray, opengl, metaballs, ...
    size
        Width and height of the pictures in pixels.
    turns
        How many pictures of each are timed, after one that is not.
    limit
        Seconds that a technique may take for its pictures of one packing; the first picture of the
        smallest packing is always made.
    csv
        File to write all numbers to; those of metaballs go to one whose name ends in _metaballs.
    png
        Picture to write the charts to.
    """
    from ..draw.offscreen import choose_window

    choose_window()
    _load(drawing=True)

    from ..bench.command import run

    run(counts, only, size, turns, limit, csv, png)


def _flush() -> None:
    """Write out what was printed; at the interpreter's end nobody could be told of a failure."""
    try:
        # None when the process was started without.
        if sys.stdout is not None:
            sys.stdout.flush()
    except OSError:
        # The interpreter flushes again when it ends.
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)
        raise


def main(arguments: list[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments : list[str], optional
        Arguments without the name of the program, by default those of the process.

    Returns
    -------
    int
        Exit status: 0, 2 after an error, which is told in one line on stderr, or 128 and the
        number of the signal that the shell knows the ending by.
    """
    try:
        app(arguments, exit_on_error=False, print_error=False, result_action="return_value")
        _flush()
    except BrokenPipeError:
        # Whoever reads the output has seen enough, as `head` does.
        return 128 + signal.SIGPIPE
    except (CycloptsError, OSError, ValueError, ImportError) as error:
        print(f"spherepacking: {' '.join(str(error).split())}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("spherepacking: stopped", file=sys.stderr)
        return 128 + signal.SIGINT
    return 0
