"""The light of path-traced pictures: what may be given as sky and sun."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import pyvista as pv

from ..checks import LARGEST_SKY, RADIANCE_LIMITS, number_of, numbers_of, shown
from ..files.image import read_small_image

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

    from ..backend import vtkSpherePackingPathTracer

    SkyLike = float | ArrayLike | str | os.PathLike[str]

_PIXEL_BYTES = 64
"""Memory for a pixel: in the file's type, linear, as the tracer has it, and its distribution."""
_ROWS = 256
"""Rows that are made linear at a time, which is done in double precision."""
_PIXEL_TYPES = ("float16", "float32", "float64", "uint8", "uint16")


class Sun(NamedTuple):
    """A disc in the sky that lights spheres and casts shadows, and is not seen itself.

    Attributes
    ----------
    direction : sequence of float
        Towards the sun (3,), of any length but 0.
    radiance : float or sequence of float, default: 1.0
        Radiance of a white surface that faces the sun, by its light alone: one number, or red,
        green and blue, linear.
    diameter : float, default: 0.53
        Angle in degrees, from 0 to 180; the larger, the softer the shadows' edges.

    Examples
    --------
    >>> import spherepacking
    >>> spherepacking.Sun((1, 0, 2), radiance=2.0).diameter
    0.53
    """

    direction: Sequence[float]
    radiance: float | Sequence[float] = 1.0
    diameter: float = 0.53


class Sky(NamedTuple):
    """The light from all directions, checked.

    Attributes
    ----------
    bottom, top : (float, float, float)
        Radiance at -z and +z, linear red, green and blue.
    pixels : numpy.ndarray or None
        (height, width, 3), float32: instead of these, an equirectangular image.
    """

    bottom: tuple[float, float, float] = (1.0, 1.0, 1.0)
    top: tuple[float, float, float] = (1.0, 1.0, 1.0)
    pixels: np.ndarray | None = None


def sky_of(sky: SkyLike) -> Sky:
    """`sky` as the light of a sky, or an exception that starts with its name.

    Parameters
    ----------
    sky : float, array_like, str or os.PathLike
        See ``packing.packing.path_trace``.
    """
    if isinstance(sky, str | os.PathLike):
        image = read_small_image(sky, bytes_per_pixel=_PIXEL_BYTES, most=LARGEST_SKY)
        return Sky(pixels=_checked(_linear(image), str(sky)))
    if isinstance(sky, list | tuple) and len(sky) == 2:
        bottom, top = (_radiance_of("sky", value) for value in sky)
        return Sky(bottom, top)
    try:
        values = np.asarray(sky)
        numeric = values.dtype.kind in "iuf"
    except ValueError:
        numeric = False
    if numeric and values.shape in ((2,), (2, 3)):
        bottom, top = (_radiance_of("sky", value) for value in values.tolist())
        return Sky(bottom, top)
    if numeric and values.ndim == 3 and values.dtype not in _PIXEL_TYPES:
        raise TypeError(
            f"sky: found an image of {values.dtype}, expected floats, or uint8 or uint16 over "
            "their whole range"
        )
    if numeric and values.ndim == 3 and values.shape[2] >= 3 and values.size:
        return Sky(pixels=_checked(_linear(values), "an array"))
    if numeric and values.shape in ((), (3,)):
        color = _radiance_of("sky", sky)
        return Sky(color, color)
    raise TypeError(
        f"sky: found {shown(sky)}, "
        "expected a number, red, green and blue, two of either for the bottom "
        "and the top, an image (height, width, 3) or the file of one"
    )


def sun_of(sun: Sun | Sequence[float] | None) -> Sun | None:
    """`sun` as a Sun, or an exception that starts with its name; None stays None."""
    if sun is None:
        return None
    direction, radiance, diameter = sun if isinstance(sun, Sun) else Sun(sun)
    numbers = numbers_of(direction)
    if numbers is None or numbers.shape != (3,):
        raise TypeError(
            f"sun: found {shown(direction)}, expected its direction, three numbers, or a Sun"
        )
    x, y, z = numbers.tolist()
    largest = max(abs(x), abs(y), abs(z))
    if not 0.0 < largest < np.inf:
        raise ValueError(
            f"sun: found the direction {shown(direction)}, expected a finite one but 0"
        )
    return Sun(
        (x / largest, y / largest, z / largest),
        _radiance_of("sun", radiance),
        number_of("sun's diameter", diameter, 0.0, 180.0),
    )


def _radiance_of(name: str, value: ArrayLike) -> tuple[float, float, float]:
    low, high = RADIANCE_LIMITS
    found = numbers_of(value)
    values = np.full(3, np.nan)
    if found is not None and found.shape in ((), (1,), (3,)):
        values = np.broadcast_to(found, 3)
    if not ((values >= low) & (values <= high)).all():
        raise ValueError(
            f"{name}: found {shown(value)}, "
            f"expected a number from {low:g} to {high:g}, or three of "
            "them for red, green and blue"
        )
    red, green, blue = values.tolist()
    return red, green, blue


def _linear(pixels: np.ndarray) -> np.ndarray:
    """Floats as they are; integers are sRGB over their whole range (IEC 61966-2-1)."""
    if pixels.shape[2] < 3:
        pixels = pixels[..., :1].repeat(3, axis=2)
    pixels = pixels[..., :3]
    if pixels.dtype.kind == "f":
        return pixels.astype(np.float32)
    linear = np.empty(pixels.shape, np.float32)
    for row in range(0, len(pixels), _ROWS):
        encoded = pixels[row : row + _ROWS] / np.iinfo(pixels.dtype).max
        linear[row : row + _ROWS] = np.where(
            encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4
        )
    return linear


def _checked(pixels: np.ndarray, where: str) -> np.ndarray:
    low, high = RADIANCE_LIMITS
    for row in range(0, len(pixels), _ROWS):
        rows = pixels[row : row + _ROWS]
        wrong = rows[~((rows >= low) & (rows <= high))]
        if wrong.size:
            raise ValueError(
                f"sky: found {wrong[0]} in {where}, expected numbers from {low:g} to {high:g}"
            )
    return pixels


def set_sky(tracer: vtkSpherePackingPathTracer, sky: Sky) -> None:
    """Set the light of a tracer; its picture starts again if that is another one."""
    tracer.SetSkyBottom(sky.bottom)
    tracer.SetSkyTop(sky.top)
    if sky.pixels is None:
        tracer.SetSkyImage(None)
        return
    height, width, _ = sky.pixels.shape
    before = tracer.GetSkyImage()
    values = sky.pixels[::-1].reshape(-1, 3)
    if before is not None and before.GetDimensions() == (width, height, 1):
        radiance = pv.convert_array(before.GetPointData().GetScalars())
        if np.array_equal(radiance, values):
            return
    image = pv.ImageData(dimensions=(width, height, 1))
    image.point_data["radiance"] = values
    image.set_active_scalars("radiance")
    tracer.SetSkyImage(image)


def set_sun(tracer: vtkSpherePackingPathTracer, sun: Sun | None) -> None:
    """Set the sun of a tracer, or take it away."""
    if sun is None:
        tracer.SetSunRadiance(0.0, 0.0, 0.0)
        return
    tracer.SetSunDirection(sun.direction)
    tracer.SetSunRadiance(np.broadcast_to(sun.radiance, 3).tolist())
    tracer.SetSunDiameter(sun.diameter)
