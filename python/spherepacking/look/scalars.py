"""The values that spheres are coloured by, and their opacities, checked."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import pyvista as pv

from ..checks import flag_of, per_sphere, storable
from ..packing import no_such_array

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class Scalars(NamedTuple):
    """What the spheres are coloured by.

    Attributes
    ----------
    values : numpy.ndarray or None
        One value or row per sphere: real numbers, truth values or texts.
    name : str
        Name of the array; a free one if there is none yet.
    rgb : bool
        Whether the values are colours.
    named : bool
        Whether the packing has the array.
    """

    values: np.ndarray | None
    name: str
    rgb: bool
    named: bool

    @property
    def mapped(self) -> bool:
        """Whether they go through a colour map."""
        return self.values is not None and not self.rgb

    @property
    def adds_array(self) -> bool:
        """Whether PyVista's mapper adds an array to the packing to draw them.

        It does for values that are not there, and for those that it maps before VTK does: vectors,
        texts and truth values.
        """
        if self.values is None:
            return False
        derived = self.mapped and (self.values.ndim > 1 or self.values.dtype.kind not in "iuf")
        return derived or not self.named


def scalars_of(
    packing: pv.PolyData,
    scalars: str | ArrayLike | None,
    rgb: bool | None,
    *,
    active: bool,
) -> Scalars:
    """Look up and check the values to colour by.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3).
    scalars : str or array_like, optional
        Name of a point array, or n values or rows.
    rgb : bool, optional
        Whether the scalars are colours; by default if their name says so.
    active : bool
        Whether None means the active scalars.

    Returns
    -------
    Scalars
        The values, and how to draw them.

    Raises
    ------
    KeyError
        If there is no array of that name.
    TypeError
        If the values are neither real numbers nor truth values nor texts.
    ValueError
        If there is not one value or row per sphere, or `rgb` and they are not colours.
    """
    if scalars is None and active and packing.n_points:
        scalars = packing.point_data.active_scalars_name
    values: np.ndarray | None = None
    name = pv.DEFAULT_SCALARS_NAME
    if isinstance(scalars, str):
        if scalars not in packing.point_data:
            raise no_such_array("scalars", scalars, packing)
        values, name = np.asarray(packing.point_data[scalars]), scalars
    elif scalars is not None:
        values = per_sphere("scalars", scalars, packing.n_points)
        name = _free_name(packing)
    if values is not None:
        values = _checked(values)
    if rgb is not None:
        rgb = flag_of("rgb", rgb)
    else:
        rgb = isinstance(scalars, str) and means_colors(scalars)
    if rgb:
        _check_colors(values, packing.n_points)
    return Scalars(values, name, rgb, isinstance(scalars, str))


def means_colors(name: str) -> bool:
    """Whether an array of that name holds colours, as readers and PyVista call them."""
    return name in ("rgb", "rgba") or name.endswith(("_rgb", "_rgba"))


def _free_name(packing: pv.PolyData) -> str:
    taken = packing.point_data.keys()
    names = (f"{pv.DEFAULT_SCALARS_NAME}{suffix}" for suffix in ["", *range(2, len(taken) + 3)])
    return next(name for name in names if name not in taken)


def _checked(values: np.ndarray) -> np.ndarray:
    """Values of a type and shape that the mapper can draw, else a TypeError or ValueError."""
    kind = values.dtype.kind
    if kind not in "iufbSU":
        raise TypeError(
            f"scalars: found {values.dtype} values, expected real numbers, truth values or texts"
        )
    if values.ndim > (1 if kind in "SU" else 2) or 0 in values.shape[1:]:
        raise ValueError(
            f"scalars: found the shape {values.shape}, expected one value or one row of numbers "
            f"for each of {len(values)} spheres"
        )
    if kind in "SU" and not all(text.isascii() for text in np.unique(values)):
        raise ValueError("scalars: found texts with letters beyond ASCII, which VTK does not hold")
    return values if kind in "SU" else storable("scalars", values)


def _check_colors(values: np.ndarray | None, count: int) -> None:
    if values is None or values.ndim != 2 or values.shape[1] not in (3, 4):
        found = "no scalars" if values is None else f"scalars of shape {values.shape}"
        raise ValueError(f"rgb: found {found}, expected shape ({count}, 3 or 4)")
    if values.dtype.kind not in "iuf":
        raise TypeError(f"rgb: found {values.dtype} values, expected numbers")
    white = 1.0 if values.dtype.kind == "f" else 255
    wrong = values[~((values >= 0) & (values <= white))]
    if wrong.size:
        raise ValueError(
            f"rgb: found {wrong[0]} as {values.dtype}, expected integers from 0 to 255 or floats "
            "from 0 to 1"
        )


class Opacity(NamedTuple):
    """What makes spheres transparent; all but one are None.

    Attributes
    ----------
    whole : float or None
        Opacity of the actor.
    each : numpy.ndarray or None
        Opacity of each sphere (n,) in [0, 1].
    transfer : numpy.ndarray or None
        Opacities along the colour map (n_colors,) in [0, 255].
    """

    whole: float | None
    each: np.ndarray | None
    transfer: np.ndarray | None


def opacity_of(
    packing: pv.PolyData,
    opacity: float | str | ArrayLike | None,
    n_colors: int,
    scalars: Scalars,
) -> Opacity:
    """Find out what `opacity` means.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3).
    opacity : float, str, array_like or None
        One opacity, the name of a point array or of a transfer function, one opacity per sphere, or
        a transfer function along the colour map.
    n_colors : int
        Length of a transfer function.
    scalars : Scalars
        What the spheres are coloured by.

    Returns
    -------
    Opacity
        Of the actor, of each sphere, or along the colour map.

    Raises
    ------
    TypeError
        If it is not a real number.
    ValueError
        If an opacity is not in [0, 1], there is one per sphere beside colours, or there is a
        transfer function and no colour map, or it has no values, too many, or such that are not
        finite.
    """
    if opacity is None:
        opacity = 1.0
    if isinstance(opacity, str) and opacity in packing.point_data:
        opacity = per_sphere("opacity", packing.point_data[opacity], packing.n_points)
    if not isinstance(opacity, str):
        opacity = np.asarray(opacity)
        if opacity.dtype.kind not in "iufb":
            raise TypeError(f"opacity: found {opacity.dtype} values, expected numbers from 0 to 1")
        opacity = opacity.astype(float)
        if opacity.shape in ((), (packing.n_points,)):
            return _without_map(opacity, scalars)
    if not scalars.mapped:
        raise ValueError(
            "opacity: a transfer function needs scalars on a colour map, expected one number or "
            f"one for each of {packing.n_points} spheres"
        )
    if not isinstance(opacity, str):
        opacity = _along_map(opacity, n_colors, packing.n_points)
    try:
        transfer = pv.opacity_transfer_function(opacity, n_colors)
    except ValueError as error:
        raise ValueError(f"opacity: {error}") from None
    return Opacity(None, None, transfer)


def _without_map(values: np.ndarray, scalars: Scalars) -> Opacity:
    wrong = values[~((values >= 0.0) & (values <= 1.0))]
    if wrong.size:
        raise ValueError(f"opacity: found {wrong[0]:g}, expected values from 0 to 1")
    if values.ndim == 0:
        return Opacity(float(values), None, None)
    if scalars.rgb:
        raise ValueError(
            "opacity: found one for each sphere beside rgb, expected it as the fourth column of "
            "the scalars"
        )
    return Opacity(None, values, None)


def _along_map(values: np.ndarray, n_colors: int, count: int) -> np.ndarray:
    if values.ndim != 1 or not 0 < values.size <= n_colors or not np.isfinite(values).all():
        raise ValueError(
            f"opacity: found an array of shape {values.shape}, expected one number, one for each "
            f"of {count} spheres or up to {n_colors} finite ones along the colour map"
        )
    if values.size < n_colors:
        return values
    # Upstream: PyVista 0.49's opacity_transfer_function scales values from 0 to 1 unless there are
    # as many as colours; those become bytes as they are.
    table = np.round(255.0 * values) if values.max() <= 1.0 else values
    if table.min() < 0.0 or table.max() > 255.0:
        raise ValueError(
            f"opacity: found {values.min():g} to {values.max():g} along the colour map, expected "
            "values from 0 to 1 or from 0 to 255"
        )
    return table
