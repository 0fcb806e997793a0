"""What ``plotter.packing.add`` is given, checked before anything is drawn.

Every check raises one exception whose message starts with the name of the argument.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import pyvista as pv

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


def packing_of(packing: object) -> pv.PolyData:
    """`packing` as a PolyData, or a TypeError."""
    wrapped = pv.wrap(packing) if hasattr(packing, "IsA") else packing
    if not isinstance(wrapped, pv.PolyData):
        raise TypeError(
            f"packing: found a {type(packing).__name__}, expected a PolyData whose points are the "
            "centres of the spheres"
        )
    return wrapped


def _per_sphere(name: str, values: ArrayLike, count: int) -> np.ndarray:
    """`values` as an array whose first axis runs over the spheres, or a ValueError."""
    array = np.asarray(values)
    if array.ndim == 0 or len(array) != count:
        found = "a single value" if array.ndim == 0 else f"{len(array)} values"
        raise ValueError(f"{name}: found {found}, expected one for each of {count} spheres")
    return array


def _no_such_array(argument: str, name: str, packing: pv.PolyData) -> KeyError:
    there = ", ".join(packing.point_data.keys()) or "none"
    hint = " (there is a cell array of that name)" if name in packing.cell_data else ""
    return KeyError(
        f"{argument}: the packing has no point array {name!r}{hint}, its point arrays are: {there}"
    )


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
    from ._backend import vtkSpherePackingInput

    name = radius
    if not isinstance(radius, str):
        values = np.asarray(radius)
        if values.dtype.kind not in "iuf":
            raise TypeError(
                f"radius: found {values.dtype} values, expected real numbers or the name of a "
                "point array"
            )
        if values.ndim == 0:
            values = np.full(packing.n_points, float(values))
        values = _per_sphere("radius", values, packing.n_points)
        name = "radius"
        packing = packing.copy(deep=False)
        packing.point_data[name] = values
    elif packing.n_points and radius not in packing.point_data:
        raise _no_such_array("radius", radius, packing)
    check = vtkSpherePackingInput()
    if check.FindRadii(packing, name) is None and (message := check.GetMessage()):
        numeric = packing.point_data[name].dtype.kind in "iuf"
        raise (ValueError if numeric else TypeError)(f"radius: {message}")
    return packing, name


def scalars_of(
    packing: pv.PolyData, scalars: str | ArrayLike | None
) -> tuple[np.ndarray | None, str]:
    """Look up the values to colour by, one row a sphere, and the name of their array.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3).
    scalars : str or array_like, optional
        Name of a point array, or n values or rows.

    Returns
    -------
    tuple[numpy.ndarray or None, str]
        None for None.

    Raises
    ------
    KeyError
        If there is no array of that name.
    ValueError
        If there is not one value or row a sphere.
    """
    if scalars is None:
        return None, pv.DEFAULT_SCALARS_NAME
    if isinstance(scalars, str):
        if scalars not in packing.point_data:
            raise _no_such_array("scalars", scalars, packing)
        return np.asarray(packing.point_data[scalars]), scalars
    values = _per_sphere("scalars", scalars, packing.n_points)
    taken = packing.point_data.keys()
    names = (f"{pv.DEFAULT_SCALARS_NAME}{suffix}" for suffix in ["", *range(2, len(taken) + 3)])
    return values, next(name for name in names if name not in taken)


class Colouring(NamedTuple):
    """What gives the spheres their colours.

    Attributes
    ----------
    scalars : numpy.ndarray or None
        One value or row a sphere.
    name : str
        Name of the scalars; a free one if they came as an array.
    rgb : bool
        Whether the scalars are colours.
    opacity : float
        Opacity of the actor.
    opacities : numpy.ndarray or None
        Opacity of each sphere (n,) in [0, 1].
    transfer : numpy.ndarray or None
        Opacities along the colour map (n_colors,) in [0, 255].
    attached : bool
        Whether drawing needs an array that the packing does not have.
    """

    scalars: np.ndarray | None
    name: str
    rgb: bool
    opacity: float
    opacities: np.ndarray | None
    transfer: np.ndarray | None
    attached: bool


def colouring_of(
    packing: pv.PolyData,
    scalars: str | ArrayLike | None,
    rgb: bool | None,
    opacity: float | str | ArrayLike | None,
    n_colors: int,
) -> Colouring:
    """Check what ``add`` was given to colour by.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3).
    scalars : str or array_like, optional
        Name of a point array, or n values or rows.
    rgb : bool, optional
        Whether the scalars are colours; by default if their name says so.
    opacity : float, str, array_like or None
        See :func:`opacity_of`.
    n_colors : int
        Length of the colour map.

    Returns
    -------
    Colouring
        The arguments, checked and sorted out.

    Raises
    ------
    KeyError
        If there is no array of that name.
    ValueError
        If a shape or a value is not what it has to be.
    """
    values, name = scalars_of(packing, scalars)
    if rgb is None:
        rgb = isinstance(scalars, str) and scalars.endswith(("_rgb", "_rgba"))
    if rgb and (values is None or values.ndim != 2 or values.shape[1] not in (3, 4)):
        found = "no scalars" if values is None else f"scalars of shape {values.shape}"
        raise ValueError(f"rgb: found {found}, expected shape ({packing.n_points}, 3 or 4)")
    mapped = values is not None and not rgb
    whole, each, transfer = opacity_of(packing, opacity, n_colors, mapped=mapped)
    # The mapper makes an array of its own of vectors, texts and truth values.
    derived = mapped and (values.ndim != 1 or values.dtype.kind not in "iuf")
    unnamed = values is not None and not isinstance(scalars, str)
    attached = each is not None or unnamed or derived
    return Colouring(values, name, rgb, 1.0 if whole is None else whole, each, transfer, attached)


def opacity_of(
    packing: pv.PolyData,
    opacity: float | str | ArrayLike | None,
    n_colors: int,
    *,
    mapped: bool,
) -> tuple[float | None, np.ndarray | None, np.ndarray | None]:
    """Split `opacity` into what it can mean; all but one of the returned values are None.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3).
    opacity : float, str, array_like or None
        One opacity, the name of a point array or of a transfer function, one opacity a sphere, or
        a transfer function along the colour map.
    n_colors : int
        Length of a transfer function.
    mapped : bool
        Whether the spheres are coloured through a colour map.

    Returns
    -------
    tuple[float or None, numpy.ndarray or None, numpy.ndarray or None]
        Opacity of the actor; opacities of the spheres (n,) in [0, 1]; transfer function
        (n_colors,) in [0, 255].

    Raises
    ------
    ValueError
        If an opacity is not in [0, 1], or there is a transfer function and no colour map.
    """
    if opacity is None:
        opacity = 1.0
    if isinstance(opacity, str) and opacity in packing.point_data:
        opacity = np.asarray(packing.point_data[opacity])
    per_sphere = not isinstance(opacity, str) and np.shape(opacity) == (packing.n_points,)
    if (np.ndim(opacity) == 0 and not isinstance(opacity, str)) or per_sphere:
        values = np.asarray(opacity, dtype=float)
        if not np.all((values >= 0.0) & (values <= 1.0)):
            raise ValueError(f"opacity: found {opacity}, expected values from 0 to 1")
        return (None, values, None) if per_sphere else (float(values), None, None)
    if not mapped:
        raise ValueError(
            "opacity: a transfer function needs scalars on a colour map, expected one number or "
            f"one for each of {packing.n_points} spheres"
        )
    return None, None, pv.opacity_transfer_function(opacity, n_colors)
