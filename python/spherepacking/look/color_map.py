"""How scalars become colours, checked before the plotter changes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import pyvista as pv

from ..checks import color_of, count_of, number_of, numbers_of, shown

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pyvista.plotting._typing import ColorLike
    from pyvista.plotting.themes import Theme

    from .scalars import Scalars


@dataclass(frozen=True, eq=False)
class ColorMap:
    """A colour map, checked: the attributes are arguments of ``DataSetMapper.set_scalars``.

    Attributes
    ----------
    clim : tuple[float, float] or None
        Range of the scalars; None for that of the values.
    n_colors : int
        Length of the colour map.
    categories : bool or int
        Whether it has a colour for each different value, or for how many.
    cmap, component, log_scale, annotations, flip_scalars
        As ``plotter.packing.add`` was given them.
    nan_color : pyvista.Color
        Colour of NaN, with its opacity.
    below_color, above_color : pyvista.Color or bool or None
        Colours of what is outside `clim`; True for the theme's, None for the ends of the map.
    """

    cmap: str | list[ColorLike] | pv.LookupTable | None
    clim: tuple[float, float] | None
    n_colors: int
    categories: bool | int
    component: int | None
    log_scale: bool
    annotations: dict[float, str] | None
    nan_color: pv.Color
    below_color: pv.Color | bool | None
    above_color: pv.Color | bool | None
    flip_scalars: bool

    def kwargs(self) -> dict[str, Any]:
        """The attributes as keyword arguments."""
        return vars(self).copy()


def color_map_of(
    scalars: Scalars,
    theme: Theme,
    *,
    cmap: str | list[ColorLike] | pv.LookupTable | None,
    clim: Sequence[float] | float | None,
    log_scale: bool,
    component: int | None = None,
    n_colors: int = 256,
    categories: bool | int = False,
    flip_scalars: bool = False,
    annotations: dict[float, str] | None = None,
    nan_color: ColorLike | None = None,
    nan_opacity: float = 1.0,
    below_color: ColorLike | bool | None = None,
    above_color: ColorLike | bool | None = None,
) -> ColorMap:
    """Check what describes the colour map; the arguments are those of ``plotter.packing.add``.

    Returns
    -------
    ColorMap
        The colour map.

    Raises
    ------
    TypeError
        If a number is not an integer where it has to be, or the annotations are not a dict.
    ValueError
        If an argument is out of its range, or the scalars are out of that of the colour map.
    """
    limits = _limits(clim)
    n_colors = count_of("n_colors", n_colors)
    if isinstance(categories, bool | np.bool_):
        categories = bool(categories)
    else:
        n_colors = categories = count_of("categories", categories)
    if cmap is not None and not isinstance(cmap, pv.LookupTable):
        _check_cmap(cmap)
    _check_annotations(annotations)
    if scalars.values is not None and scalars.mapped:
        values = _one_component(scalars.values, component)
        kind = values.dtype.kind
        if kind in "bSU" and log_scale:
            raise ValueError(f"log_scale: found scalars of {values.dtype}, expected numbers")
        if kind in "iuf" and not isinstance(cmap, pv.LookupTable):
            limits = _checked_limits(values, limits, log_scale)
        if categories is True or (categories is False and kind in "SU"):
            n_colors = len(np.unique(values))
        elif categories is False and kind == "b":
            n_colors = 2
    nan_opacity = number_of("nan_opacity", nan_opacity, 0.0, 1.0)
    nan = color_of("nan_color", nan_color)
    return ColorMap(
        cmap=cmap,
        clim=limits,
        n_colors=n_colors,
        categories=categories,
        component=component,
        log_scale=log_scale,
        annotations=annotations,
        nan_color=pv.Color(nan, opacity=nan_opacity, default_color=theme.nan_color),
        below_color=color_of("below_color", below_color),
        above_color=color_of("above_color", above_color),
        flip_scalars=flip_scalars,
    )


def _limits(clim: Sequence[float] | float | None) -> tuple[float, float] | None:
    """The range that was asked for, or a ValueError."""
    if clim is None:
        return None
    values = numbers_of(clim)
    if values is None:
        values = np.empty(0)
    elif values.ndim == 0:
        values = np.array([-values, values])
    if values.shape != (2,) or not np.isfinite(values).all() or values[0] > values[1]:
        raise ValueError(
            f"clim: found {shown(clim)}, "
            "expected two finite numbers, the smaller one first, or one "
            "that is not negative"
        )
    return float(values[0]), float(values[1])


def _check_cmap(cmap: str | list[ColorLike]) -> None:
    if not isinstance(cmap, list) or cmap:
        try:
            pv.LookupTable(cmap=cmap)
        except (TypeError, ValueError):
            pass
        else:
            return
    raise ValueError(
        f"cmap: found {shown(cmap)}, "
        "expected the name of a colour map, a list of names of colours or a "
        "LookupTable"
    )


def _check_annotations(annotations: dict[float, str] | None) -> None:
    if not isinstance(annotations, dict | None):
        raise TypeError(
            f"annotations: found {shown(annotations)}, expected a dict of numbers to texts"
        )
    for value, text in (annotations or {}).items():
        number_of("annotations", value, -np.inf, np.inf)
        if not isinstance(text, str):
            raise TypeError(f"annotations: found {shown(text)} beside {value}, expected a text")


def _one_component(values: np.ndarray, component: int | None) -> np.ndarray:
    """Return the values (n,) that the colour map spans: a component, or the magnitude of all."""
    columns = 1 if values.ndim == 1 else values.shape[1]
    if component is not None and not (
        isinstance(component, int | np.integer) and 0 <= component < columns
    ):
        raise ValueError(
            f"component: found {shown(component)}, expected an integer from 0 to {columns - 1}"
        )
    if values.ndim == 1:
        return values
    if component is not None:
        return values[:, component]
    with np.errstate(over="ignore"):
        return np.linalg.norm(values, axis=1)


def _checked_limits(
    values: np.ndarray, limits: tuple[float, float] | None, log_scale: bool
) -> tuple[float, float] | None:
    """Check the range of the colour map: None, the range of the values, stays if that is one."""
    found, known = "a clim", np.asarray(limits)
    if limits is None:
        found, known = "scalars", values[~np.isnan(values)]
        if not known.size:
            # A range of nothing is not defined, and all spheres have the colour of NaN.
            return 1.0, 2.0
    low, high = np.min(known), np.max(known)
    if not np.isfinite(low) or not np.isfinite(high):
        raise ValueError(
            f"scalars: found values from {low:g} to {high:g}, expected finite ones or a clim"
        )
    if log_scale and low <= 0.0:
        raise ValueError(
            f"log_scale: found {found} from {low:g} to {high:g}, expected numbers above 0"
            + ("" if limits else " or a clim above 0")
        )
    return limits


def widened(values: np.ndarray, color_map: ColorMap) -> tuple[float, float] | None:
    """Range of the colour map of scalars, never of a single value.

    Upstream: PyVista 0.49's set_scalars divides by the length of the range where each sphere has an
    opacity of its own.
    """
    limits = color_map.clim
    values = _one_component(values, color_map.component)
    if values.dtype.kind not in "iuf":
        return limits
    low, high = limits or (float(np.nanmin(values)), float(np.nanmax(values)))
    return limits if low < high else (low, low + (abs(low) or 1.0))
