"""The scalar bar that ``plotter.packing.add`` shows, checked before the plotter changes."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING

import pyvista as pv

if TYPE_CHECKING:
    from .scalars import Scalars

# What `add` itself says: where the colours come from, and when the scene is drawn.
_GIVEN = {"self", "mapper", "lookup_table", "cmap", "clim", "render"}


def scalar_bar_of(
    plotter: pv.BasePlotter,
    scalars: Scalars,
    n_colors: int,
    shown: bool | None,
    args: dict | None,
) -> dict[str, object] | None:
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
        If `args` is no dict.
    ValueError
        If there is no such argument, or the plotter cannot show such a bar.
    """
    if args is not None:
        _check_names(args)
    if shown is None:
        shown = (plotter.theme.show_scalar_bar or args) and not scalars.rgb
    if not shown or scalars.values is None or not len(scalars.values):
        return None
    words = {"n_colors": n_colors} if args is None else dict(args)
    if scalars.named:
        words.setdefault("title", scalars.name)
    if args:
        _try(plotter, words)
    placed = {"position_x", "position_y"} <= words.keys()
    bars = plotter.scalar_bars
    if not placed and words.get("title", "") not in bars and len(bars) >= pv.MAX_N_COLOR_BARS:
        raise ValueError(
            f"scalar_bar_args: found {len(bars)} scalar bars already, expected position_x and "
            "position_y for another one"
        )
    return words


def _check_names(args: dict) -> None:
    if not isinstance(args, dict):
        raise TypeError(f"scalar_bar_args: found {args!r}, expected a dict")
    known = inspect.signature(pv.plotting.scalar_bars.ScalarBars.add_scalar_bar).parameters
    expected = sorted(known.keys() - _GIVEN)
    for name in args:
        if name not in expected:
            raise ValueError(
                f"scalar_bar_args: found {name!r}, expected one of {', '.join(expected)}"
            )


def _try(plotter: pv.BasePlotter, words: dict[str, object]) -> None:
    """Raise a ValueError if PyVista takes no such values.

    It finds out while it adds the bar, so another plotter, which is thrown away, adds one.
    """
    if words.get("interactive") and plotter.shape != (1, 1):
        raise ValueError(
            f"scalar_bar_args: found interactive in a plotter of shape {plotter.shape}, expected "
            "one view"
        )
    trial = pv.Plotter(off_screen=True, theme=plotter.theme)
    try:
        trial.add_scalar_bar(mapper=pv.DataSetMapper(), render=False, **words)
    except (TypeError, ValueError, AttributeError) as error:
        reason = " ".join(str(error).split())
        raise ValueError(
            f"scalar_bar_args: found {words!r}, which PyVista does not take: {reason}"
        ) from error
    finally:
        trial.close()
