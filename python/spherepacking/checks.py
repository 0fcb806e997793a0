"""Checks of arguments.

Every check returns the argument in the form that is used, or raises one exception whose message
starts with the argument's name and says what was found and what was expected.
"""

from __future__ import annotations

import numbers
import operator
import os
from typing import TYPE_CHECKING, NamedTuple, overload

import numpy as np
import pyvista as pv

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from numpy.typing import ArrayLike
    from pyvista.plotting._typing import ColorLike


class Limits(NamedTuple):
    """The least and the largest value that is taken."""

    low: float
    high: float


# The limits of all numbers that have any but those of their meaning or type, and why.

SCALE_LIMITS = Limits(1e-150, 1e150)
"""Scale of a transformation: the mapper squares it, in double precision."""
EXTENT_LIMITS = Limits(1e-15, 1e15)
"""Length of a packing, and distance of the camera, on the command line: OpenGL squares them."""
FINEST_EXTENT = 1e-13
"""Length of a packing over its distance from the origin: double precision has 16 digits."""
RADIANCE_LIMITS = Limits(0.0, 1e15)
"""Radiance of sky and sun: the variance squares it, in single precision."""
LARGEST_SKY = 2**29
"""Pixels of the image of a sky: more than 24576 x 12288, which is large for one."""
EXPOSURE_LIMITS = Limits(-100.0, 100.0)
"""Exposure: 2 to this power is a number in single precision."""
WEIGHT_LIMITS = Limits(0.0, 1e20)
"""Weights of metaballs: sums of many are numbers in single precision."""
RELATIVE_ERROR_LIMITS = Limits(2e-5, 0.5)
"""Relative error of a field, if not 0: single precision alone makes one of 1e-5."""
ENDLESS = 1e290
"""A time budget or noise target from which on there is none: VTK cuts infinity off at 1e299."""
LARGEST_INT = 2**31 - 1
"""Any count: an int of C++."""
LARGEST_SEED = 2**32 - 1
"""Seed of the path tracer: an unsigned int of C++."""
LARGEST_TRACED_SIDE = 65536
"""Side of a traced picture, in pixels: far more than any use, so that a slip is refused."""
LARGEST_DRAWN_SIDE = 32768
"""Side of a drawn picture, in pixels: drawn in tiles, far more than is printed on a wall."""
LARGEST_SPECULAR_POWER = 128.0
"""Specular power: as in VTK."""
LARGEST_RAY_SAMPLES = 16
"""Rays along a side of a pixel: more than 16 x 16 make no difference that 8 bits show."""
STEP_LIMITS = Limits(0.001, 60.0)
"""Seconds between two steps of a live picture: a shorter one shows nothing new."""


def half_of_memory() -> int:
    """Half of the machine's memory in bytes, the most that one result may take."""
    return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") // 2


def kind_of(value: object) -> str:
    """Name of the class of a value with its article, for messages: "an ImageData"."""
    name = type(value).__name__
    return f"{'an' if name[0] in 'AEIOaeio' else 'a'} {name}"


def shown(value: object) -> str:
    """`value` as it stands in a message: on one line, and not longer than 80 characters."""
    if isinstance(value, np.ndarray) and value.ndim:
        return f"an array of shape {value.shape}"
    if hasattr(value, "GetClassName"):
        return kind_of(value)
    text = " ".join(repr(value).split())
    return text if len(text) <= 80 else f"{text[:77]}..."


def some_of(values: Iterable[object], most: int = 10) -> str:
    """The first of `values` as they stand in a message, and how many there are if not all."""
    every = list(values)
    text = ", ".join(" ".join(str(value).split())[:80] for value in every[:most])
    return text if len(every) <= most else f"{text}, ... ({len(every)} in all)"


def numbers_of(value: object) -> np.ndarray | None:
    """`value` as an array of floats of any shape, or None if it is not made of numbers."""
    if isinstance(value, str | bytes) or value is None:
        return None
    try:
        array = np.asarray(value)
        return array.astype(float) if array.dtype.kind in "iufO" else None
    except (TypeError, ValueError, OverflowError):
        return None


def one_of(name: str, value: str, choices: Sequence[str]) -> str:
    """`value` if it is one of the texts, or a ValueError."""
    if not isinstance(value, str) or value not in choices:
        raise ValueError(f"{name}: found {shown(value)}, expected one of {', '.join(choices)}")
    return value


def number_of(name: str, value: float, low: float, high: float) -> float:
    """`value` as a float from `low` to `high`, or a ValueError; neither text nor truth value."""
    real = isinstance(value, numbers.Real) and not isinstance(value, bool)
    try:
        number = float(value) if real else np.nan
    except OverflowError:
        number = np.nan
    if not low <= number <= high:
        raise ValueError(
            f"{name}: found {shown(value)}, expected a number from {low:g} to {high:g}"
        )
    return number


def above_zero(name: str, value: float) -> float:
    """`value` as a float above 0, which may be infinite, or a ValueError."""
    try:
        return number_of(name, value, np.finfo(float).tiny, np.inf)
    except ValueError:
        raise ValueError(f"{name}: found {shown(value)}, expected a number above 0") from None


def _index_of(value: int) -> int | None:
    """`value` as an integer; None for truth values and what is none."""
    try:
        return None if isinstance(value, bool) else operator.index(value)
    except TypeError:
        return None


def integer_of(name: str, value: int) -> int:
    """`value` as an integer, or a TypeError; neither text nor truth value."""
    index = _index_of(value)
    if index is None:
        raise TypeError(f"{name}: found {shown(value)}, expected an integer")
    return index


def index_in(indices: range, name: str, value: int) -> int:
    """The one of `indices` at `value`, negative from the end, or a TypeError or IndexError."""
    index = integer_of(name, value)
    if not -len(indices) <= index < len(indices):
        there = f"0 to {len(indices) - 1}" if indices else "none, since there is none"
        raise IndexError(f"{name}: found {index}, expected {there}")
    return indices[index]


def count_of(name: str, value: int, least: int = 1, most: int = LARGEST_INT) -> int:
    """`value` as an integer from `least` to `most`, or a TypeError or ValueError."""
    count = _index_of(value)
    if count is None or not least <= count <= most:
        raise (TypeError if count is None else ValueError)(
            f"{name}: found {shown(value)}, expected an integer from {least} to {most}"
        )
    return count


def flag_of(name: str, value: bool) -> bool:
    """`value` as a truth value, or a TypeError."""
    if not isinstance(value, bool | np.bool_):
        raise TypeError(f"{name}: found {shown(value)}, expected True or False")
    return bool(value)


def size_of(name: str, value: Sequence[int], most: int) -> tuple[int, int]:
    """`value` as width and height of at most `most` pixels, or a TypeError or ValueError."""
    try:
        width, height = value
    except (TypeError, ValueError, KeyError):
        raise ValueError(
            f"{name}: found {shown(value)}, expected width and height in pixels"
        ) from None
    return count_of(name, width, most=most), count_of(name, height, most=most)


@overload
def color_of(name: str, value: ColorLike) -> pv.Color: ...
@overload
def color_of(name: str, value: ColorLike | None) -> pv.Color | None: ...
def color_of(name: str, value: ColorLike | None) -> pv.Color | None:
    """`value` as a colour, or a ValueError; None stays."""
    if value is None:
        return value
    try:
        if isinstance(value, bool):
            raise TypeError
        return pv.Color(value)
    except (TypeError, ValueError):
        raise ValueError(
            f"{name}: found {shown(value)}, "
            "expected a colour: a name, #rrggbb or three or four numbers"
        ) from None


def storable(name: str, values: ArrayLike) -> np.ndarray:
    """`values` in the machine's byte order and, for floats, in a width that VTK has."""
    array = np.asarray(values)
    if array.dtype.kind == "f" and array.dtype.itemsize > 8:
        with np.errstate(over="ignore"):
            double = array.astype(float)
        if not np.array_equal(double, array, equal_nan=True):
            raise ValueError(
                f"{name}: found {array.dtype} values that double precision does not hold exactly, "
                "expected float64; astype(float) rounds them"
            )
        return double
    if array.dtype == np.float16:
        return array.astype(np.float32)
    # Upstream: PyVista 0.49's DataSetAttributes swaps the bytes of a big-endian array in place, in
    # the caller's memory.
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def per_sphere(name: str, values: ArrayLike, count: int) -> np.ndarray:
    """`values` as an array whose first axis runs over the spheres, or a ValueError."""
    array = np.asarray(values)
    if array.ndim == 0 or len(array) != count:
        found = "a single value" if array.ndim == 0 else f"{len(array)} values"
        raise ValueError(f"{name}: found {found}, expected one for each of {count} spheres")
    return array


def similarity_of(matrix: ArrayLike | None) -> np.ndarray:
    """Check a transformation: rotation, mirroring, translation and one scale keep spheres round.

    Parameters
    ----------
    matrix : array_like or vtkMatrix4x4 or vtkTransform or None
        What :class:`pyvista.Transform` takes; None changes nothing.

    Returns
    -------
    numpy.ndarray
        The transformation (4, 4); its last row is 0, 0, 0, 1.

    Raises
    ------
    ValueError
        If it is no such transformation.
    """
    if matrix is None:
        return np.eye(4)
    try:
        array = pv.Transform(matrix).matrix
    except (TypeError, ValueError) as error:
        raise ValueError(f"user_matrix: {' '.join(str(error).split())}") from None
    *shear, unit = array[3]
    if any(shear) or unit == 0.0:
        raise ValueError(f"user_matrix: found {array[3]} as its last row, expected 0 0 0 1")
    # The mapper takes the last row for granted.
    with np.errstate(over="ignore", invalid="ignore"):
        array = array / unit
    finite = np.isfinite(array).all()
    scales = np.linalg.svd(array[:3, :3], compute_uv=False) if finite else np.full(3, np.inf)
    low, high = SCALE_LIMITS
    if not low <= scales[-1] <= scales[0] <= high:
        raise ValueError(
            f"user_matrix: found a scale of {scales[-1]:g}, expected {low:g} to {high:g}"
        )
    # Stricter than the mapper, which allows 1e-6 between the squares and has to round as well.
    if scales[0] - scales[-1] > 2e-7 * scales[0]:
        factors = ", ".join(f"{scale:.6g}" for scale in scales)
        raise ValueError(
            f"user_matrix: found the scales {factors}, expected one in all directions: spheres "
            "allow rotation, translation and uniform scale"
        )
    return array
