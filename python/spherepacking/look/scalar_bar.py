"""The scalar bar, checked before the plotter changes."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any

import pyvista as pv

from ..checks import shown

if TYPE_CHECKING:
    from .scalars import Scalars

# What `add` itself says: where the colours come from, and when the scene is drawn.
_GIVEN = {"self", "mapper", "lookup_table", "cmap", "clim", "render"}


def scalar_bar_of(
    plotter: pv.BasePlotter,
    scalars: Scalars,
    n_colors: int,
    shown: bool | None,
    args: dict[str, Any] | None,
) -> dict[str, Any] | None:
    """Check the scalar bar.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        The plotter to show it; not changed.
    scalars : Scalars
        What it shows.
    n_colors : int
        Number of its colours if `args` are not given, as in PyVista.
    shown : bool, optional
        Whether to show it; by default as the theme says, and not for colours.
    args : dict, optional
        Arguments of :meth:`pyvista.Plotter.add_scalar_bar`; not changed.

    Returns
    -------
    dict or None
        All arguments of :meth:`pyvista.Plotter.add_scalar_bar`; None if there is to be no bar.

    Raises
    ------
    TypeError
        If `args` is not a dict.
    ValueError
        If there is no such argument, or the plotter cannot show such a bar.
    """
    if args is not None:
        _check_names(args)
    if shown is None:
        shown = bool(plotter.theme.show_scalar_bar or args) and not scalars.rgb
    if not shown or scalars.values is None or not len(scalars.values):
        return None
    kwargs: dict[str, Any] = {"n_colors": n_colors} if args is None else dict(args)
    if scalars.named:
        kwargs.setdefault("title", scalars.name)
    if args:
        _try(plotter, kwargs)
    positioned = {"position_x", "position_y"} <= kwargs.keys()
    bars = plotter.scalar_bars
    title = kwargs.get("title", "")
    if not positioned and title not in bars and len(bars) >= pv.MAX_N_COLOR_BARS:
        raise ValueError(
            f"scalar_bar_args: found {len(bars)} scalar bars already, expected position_x and "
            "position_y for another one"
        )
    return kwargs


def _check_names(args: dict[str, Any]) -> None:
    if not isinstance(args, dict):
        raise TypeError(f"scalar_bar_args: found {shown(args)}, expected a dict")
    known = inspect.signature(pv.plotting.scalar_bars.ScalarBars.add_scalar_bar).parameters
    expected = sorted(known.keys() - _GIVEN)
    for name in args:
        if name not in expected:
            raise ValueError(
                f"scalar_bar_args: found {name!r}, expected one of {', '.join(expected)}"
            )


def _try(plotter: pv.BasePlotter, kwargs: dict[str, Any]) -> None:
    """Raise a ValueError if PyVista does not take the values.

    Upstream: PyVista 0.49's add_scalar_bar finds out when it has changed the plotter, so another
    one, which is thrown away, adds a bar first.
    """
    if kwargs.get("interactive") and plotter.shape != (1, 1):
        raise ValueError(
            f"scalar_bar_args: found interactive in a plotter of shape {plotter.shape}, expected "
            "one view"
        )
    trial = pv.Plotter(off_screen=True, theme=plotter.theme)
    try:
        trial.add_scalar_bar(mapper=pv.DataSetMapper(), render=False, **kwargs)
    except (TypeError, ValueError, AttributeError) as error:
        reason = " ".join(str(error).split())
        raise ValueError(
            f"scalar_bar_args: found {shown(kwargs)}, which PyVista does not take: {reason}"
        ) from error
    finally:
        trial.close()
