"""What ``plotter.packing.add`` is given, checked before the plotter changes: spheres and actor.

Every check raises one exception whose message starts with the name of the argument.
"""

from __future__ import annotations

import numbers
import operator
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike
    from pyvista.plotting._typing import ColorLike
    from pyvista.plotting.themes import Theme

# Within these the mapper's squares are finite and not zero.
_SCALES = (1e-150, 1e150)


def number_of(name: str, value: float, low: float, high: float) -> float:
    """`value` as a float from `low` to `high`, or a ValueError; texts and truth values are none."""
    real = isinstance(value, numbers.Real) and not isinstance(value, bool)
    try:
        number = float(value) if real else np.nan
    except OverflowError:
        number = np.nan
    if not low <= number <= high:
        raise ValueError(f"{name}: found {value!r}, expected a number from {low:g} to {high:g}")
    return number


def above_zero(name: str, value: float) -> float:
    """`value` as a float above 0, which may be infinite, or a ValueError."""
    try:
        return number_of(name, value, np.finfo(float).tiny, np.inf)
    except ValueError:
        raise ValueError(f"{name}: found {value!r}, expected a number above 0") from None


def count_of(name: str, value: int, least: int = 1, most: int = 2**31 - 1) -> int:
    """`value` as an integer from `least` to `most`, or a TypeError or ValueError."""
    try:
        count = None if isinstance(value, bool) else operator.index(value)
    except TypeError:
        count = None
    if count is None or not least <= count <= most:
        raise (TypeError if count is None else ValueError)(
            f"{name}: found {value!r}, expected an integer from {least} to {most}"
        )
    return count


def flag_of(name: str, value: bool) -> bool:
    """`value` as a truth value, or a TypeError."""
    if not isinstance(value, bool | np.bool_):
        raise TypeError(f"{name}: found {value!r}, expected True or False")
    return bool(value)


def size_of(name: str, value: Sequence[int], most: int) -> tuple[int, int]:
    """`value` as width and height of at most `most` pixels, or a TypeError or ValueError."""
    try:
        width, height = value
    except (TypeError, ValueError):
        raise ValueError(f"{name}: found {value!r}, expected width and height in pixels") from None
    return count_of(name, width, most=most), count_of(name, height, most=most)


def color_of(name: str, value: ColorLike | bool | None) -> pv.Color | bool | None:
    """`value` as a colour, or a ValueError; None and truth values stay as they are."""
    if value is None or isinstance(value, bool):
        return value
    try:
        return pv.Color(value)
    except (TypeError, ValueError):
        raise ValueError(
            f"{name}: found {value!r}, expected a colour: a name, #rrggbb or three or four numbers"
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
    # PyVista would swap the bytes of the caller's array.
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def per_sphere(name: str, values: ArrayLike, count: int) -> np.ndarray:
    """`values` as an array whose first axis runs over the spheres, or a ValueError."""
    array = np.asarray(values)
    if array.ndim == 0 or len(array) != count:
        found = "a single value" if array.ndim == 0 else f"{len(array)} values"
        raise ValueError(f"{name}: found {found}, expected one for each of {count} spheres")
    return array


def no_such_array(argument: str, name: str, packing: pv.PolyData) -> KeyError:
    """Make the error that says which arrays there are."""
    there = ", ".join(packing.point_data.keys()) or "none"
    hint = " (there is a cell array of that name)" if name in packing.cell_data else ""
    return KeyError(
        f"{argument}: the packing has no point array {name!r}{hint}, its point arrays are: {there}"
    )


def packing_of(packing: object) -> pv.PolyData:
    """`packing` as a PolyData, or a TypeError."""
    wrapped = pv.wrap(packing) if hasattr(packing, "IsA") else packing
    if not isinstance(wrapped, pv.PolyData):
        raise TypeError(
            f"packing: found a {type(packing).__name__}, expected a PolyData whose points are the "
            "centres of the spheres"
        )
    return wrapped


def radii_of(packing: pv.PolyData, radius: str | ArrayLike) -> tuple[pv.PolyData, str]:
    """Check the radii and return the packing to draw and the name of its radius array.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3).
    radius : str or array_like
        Name of a point array, n radii, or one radius for all spheres.

    Returns
    -------
    tuple[pyvista.PolyData, str]
        `packing` itself when `radius` is a name, else a shallow copy that has the array.

    Raises
    ------
    KeyError
        If there is no array of that name.
    TypeError
        If the radii are no real numbers.
    ValueError
        If there is not one radius a sphere, or one is negative, infinite or NaN, or so is a centre.
    """
    from .backend import vtkSpherePackingInput

    name = radius
    if not isinstance(radius, str):
        values = np.asarray(radius)
        if values.dtype.kind not in "iuf":
            raise TypeError(
                f"radius: found {values.dtype} values, expected real numbers or the name of a "
                "point array"
            )
        values = storable("radius", values)
        if values.ndim == 0:
            values = np.full(packing.n_points, float(values))
        values = per_sphere("radius", values, packing.n_points)
        name = "radius"
        packing = packing.copy(deep=False)
        packing.point_data[name] = values
    elif packing.n_points and radius not in packing.point_data:
        raise no_such_array("radius", radius, packing)
    check = vtkSpherePackingInput()
    if check.FindRadii(packing, name) is None and (message := check.GetMessage()):
        numeric = packing.point_data[name].dtype.kind in "iuf"
        raise (ValueError if numeric else TypeError)(f"radius: {message}")
    return packing, name


def similarity_of(matrix: object) -> np.ndarray:
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
    low, high = _SCALES
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


def property_of(
    theme: Theme,
    lighting: bool | None,
    ambient: float | None,
    diffuse: float | None,
    specular: float | None,
    specular_power: float | None,
) -> pv.Property:
    """Make the material of spheres, or a ValueError; what is None is the theme's."""
    shares = {"ambient": ambient, "diffuse": diffuse, "specular": specular}
    for name, value in shares.items():
        if value is not None:
            number_of(name, value, 0.0, 1.0)
    if not (lighting is None or isinstance(lighting, (bool, np.bool_))):
        raise ValueError(f"lighting: found {lighting!r}, expected True, False or None")
    if specular_power is not None:
        number_of("specular_power", specular_power, 0.0, 128.0)
    return pv.Property(
        theme=theme,
        style="surface",
        interpolation="Phong",
        show_edges=False,
        lighting=lighting,
        specular_power=specular_power,
        **shares,
    )


def check_scene(plotter: pv.BasePlotter, name: str | None) -> None:
    """Raise a ValueError if the plotter cannot show spheres or `name` is no name of an actor."""
    scale = plotter.renderer.scale
    if len(set(scale)) > 1:
        raise ValueError(f"the plotter's scale: found {scale}, expected the same for all axes")
    if name is not None and not (isinstance(name, str) and name):
        raise ValueError(f"name: found {name!r}, expected a text that is not empty, or None")
