"""The options of ``spherepacking render``."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

if TYPE_CHECKING:
    from collections.abc import Sequence

    from cyclopts import Token

Vector = tuple[float, float, float]
Technique = Literal["opengl", "raycast", "pathtrace", "metaballs", "bvh", "grid"]
Kernel = Literal["inverse", "inverse_square", "gaussian", "wyvill"]
Output = Annotated[Path, Parameter(alias="-o")]


def _whole(_: type, tokens: Sequence[Token]) -> int:
    """An integer, or a ValueError. Upstream: cyclopts 5 rounds 1.5 to 2."""
    (token,) = tokens
    try:
        return int(token.value)
    except ValueError:
        raise ValueError(f"found {token.value}, expected an integer") from None


Whole = Annotated[int, Parameter(converter=_whole)]


@Parameter(name="*")
@dataclass(frozen=True)
class RenderOptions:
    """What is drawn, from where, and how.

    Parameters
    ----------
    output
        Picture to write; its extension decides about the format (.png, .exr, .tif, .jpg, ...).
        With --steps a name with a number, such as f_%04d.png, or a movie, such as run.mp4.
    steps
        Draw these steps, FIRST:END:STRIDE as in Python, such as 0:100:2 or : for all; colours,
        camera and scale are the same in all pictures.
    fps
        Pictures a second of a movie.
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
    cell
        Draw the edges of the simulation cell, which the file must have.
    size
        Width and height of the picture in pixels, up to 32768 each.
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

    output: Output
    steps: str | None = None
    fps: float = 24.0
    scalars: str | None = None
    cmap: str | None = None
    clim: tuple[float, float] | None = None
    log_scale: bool | None = None
    color: str | None = None
    opacity: float = 1.0
    scalar_bar: bool = True
    cell: bool = False
    size: tuple[int, int] = (1000, 1000)
    camera: Vector | None = None
    focal: Vector | None = None
    up: Vector | None = None
    view_angle: float | None = None
    zoom: float = 1.0
    parallel: bool = False
    background: str | None = None
    transparent: bool = False
    anti_aliasing: bool = True
    technique: Technique = "opengl"
    structure: Literal["bvh", "grid", "none"] = "bvh"
    samples: Whole | None = None
    boxes: Whole = 15
    cuts: Whole = 6
    max_bounces: Whole = 4
    albedo: float = 0.8
    sky: Annotated[list[str] | None, Parameter(consume_multiple=True, negative=())] = None
    sun: Vector | None = None
    sun_radiance: float = 1.0
    sun_diameter: float = 0.53
    seed: Whole = 0
    time_budget: float | None = None
    noise_target: float | None = None
    exposure: float = 0.0
    filmic: bool = False
    denoise: bool = False
    threshold: float = 1.0
    kernel: Kernel = "inverse"
    weights: Annotated[list[float] | None, Parameter(consume_multiple=True, negative=())] = None
    count: Whole | None = None
    dimensions: Whole = 128


# Options that only some techniques have a use for.
_TECHNIQUES: dict[str, tuple[Technique, ...]] = {
    "samples": ("raycast", "pathtrace"),
    "structure": ("raycast", "pathtrace"),
    "cell": ("opengl", "bvh", "grid"),
    "boxes": ("bvh",),
    "cuts": ("grid",),
    **dict.fromkeys(
        ("max_bounces", "albedo", "sky", "sun", "sun_radiance", "sun_diameter", "seed"),
        ("pathtrace",),
    ),
    **dict.fromkeys(
        ("time_budget", "noise_target", "exposure", "filmic", "denoise"), ("pathtrace",)
    ),
    **dict.fromkeys(("threshold", "kernel", "weights", "count", "dimensions"), ("metaballs",)),
}


def check_technique(options: RenderOptions) -> None:
    """Refuse options that the technique has no use for.

    Raises
    ------
    ValueError
        If there is such an option.
    """
    defaults = {field.name: field.default for field in fields(RenderOptions)}
    for name, techniques in _TECHNIQUES.items():
        given = getattr(options, name) != defaults[name]
        if given and options.technique not in techniques:
            raise ValueError(
                f"--{name.replace('_', '-')}: found with --technique {options.technique}, "
                f"expected --technique {' or '.join(techniques)}"
            )
    for name in ("sun_radiance", "sun_diameter"):
        if options.sun is None and getattr(options, name) != defaults[name]:
            raise ValueError(f"--{name.replace('_', '-')}: found no --sun, expected one")


def check_view(options: RenderOptions) -> None:
    """Raise a ValueError if there is no such picture."""
    from ..checks import LARGEST_DRAWN_SIDE

    size, largest = options.size, LARGEST_DRAWN_SIDE
    if min(size) < 1 or max(size) > largest:
        raise ValueError(
            f"--size: found {size[0]} {size[1]}, expected numbers of pixels from 1 to {largest}"
        )
    if not 0.0 < options.zoom < math.inf:
        raise ValueError(f"--zoom: found {options.zoom}, expected a finite number above 0")
    angle = options.view_angle
    if angle is not None and not 0.0 < angle < 180.0:
        raise ValueError(f"--view-angle: found {angle}, expected degrees from 0 to 180")
