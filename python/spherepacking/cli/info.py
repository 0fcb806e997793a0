"""What ``spherepacking info`` prints about a packing."""

from __future__ import annotations

from decimal import Decimal
from math import isnan
from typing import TYPE_CHECKING

import numpy as np

from ..accessor import PackingAccessor
from ..printable import printable

if TYPE_CHECKING:
    import pyvista as pv

    from ..files.steps import PackingSteps

_BINS = 10
_BAR = 40
# Radii that spread over more than this ratio are binned by their logarithm.
_WIDE = 20.0
_TINY, _HUGE = Decimal("1e-300"), Decimal("1e300")


def _histogram(radii: np.ndarray) -> list[str]:
    """Lines `from … to  count  bar` for radii (n,) that are not negative, n > 0."""
    low, high = radii.min(), radii.max()
    positive = radii[radii > 0.0]
    lines = []
    if high == 0.0 or low == high:
        edges = np.array([low, high])
    elif high / _WIDE > positive.min():
        edges = np.geomspace(positive.min(), high, _BINS + 1)
        if zeros := len(radii) - len(positive):
            lines.append((0.0, 0.0, zeros))
    else:
        edges = np.linspace(low, high, _BINS + 1)
    inside = radii[(radii > 0.0) | (edges[0] == 0.0)]
    # Rounding of the outermost edges must not lose the smallest and the largest radius.
    edges[0], edges[-1] = inside.min() if inside.size else low, high
    cells = np.searchsorted(edges[1:-1], inside, side="right")
    counts = np.bincount(cells, minlength=len(edges) - 1)
    lines += zip(edges[:-1], edges[1:], counts, strict=True)
    most = max(count for *_, count in lines)
    return [
        f"  {a:>11.5g} .. {b:<11.5g} {count:>9,}  {'#' * round(_BAR * count / most)}".rstrip()
        for a, b, count in lines
    ]


def _median(radii: np.ndarray) -> float:
    # The mean of the middle two may be infinite before it is halved.
    half = 0.5 if radii.max() > 1e300 else 1.0
    return float(np.median(half * radii) / half)


def _volume(radii: np.ndarray) -> str:
    """Sum of the volumes of spheres with radii (n,), n > 0, also where no float holds it."""
    largest = radii.max()
    if largest == 0.0:
        return "0"
    relative = 4.0 / 3.0 * np.pi * np.sum((radii / largest) ** 3)
    volume = Decimal(float(relative)) * Decimal(float(largest)) ** 3
    # Numbers are shown alike wherever a float holds them.
    inside = _TINY < volume < _HUGE
    return f"{float(volume):.6g}" if inside else f"{volume:.5e}"


def _named(packing: pv.PolyData, name: str) -> str:
    """Name of an array, and what it holds if that is not one number per sphere."""
    values = packing.point_data[name]
    name = printable(name)
    if values.dtype.kind in "US":
        return f"{name} (text)"
    return f"{name} ({values.shape[1]} components)" if values.ndim > 1 else name


def _cell(packing: pv.PolyData) -> list[str]:
    """Lines about the simulation cell, if there is one."""
    data = packing.field_data
    if "cell_vectors" not in data:
        return []
    rows = [*np.asarray(data["cell_vectors"]).reshape(3, 3)]
    names = ["a", "b", "c"]
    if "cell_origin" in data:
        rows, names = [np.ravel(data["cell_origin"]), *rows], ["origin", *names]
    text = ", ".join(
        f"{name} {' '.join(f'{value:.6g}' for value in row)}"
        for name, row in zip(names, rows, strict=True)
    )
    lines = [f"cell     {text}"]
    if "cell_periodic" in data:
        periodic = np.ravel(data["cell_periodic"])
        along = " ".join(name for name, p in zip("abc", periodic, strict=True) if p)
        lines.append(f"periodic {'along ' + along if along else 'along none'}")
    return lines


def describe_steps(steps: PackingSteps) -> list[str]:
    """Number and times of the steps of a run as text.

    Parameters
    ----------
    steps : PackingSteps
        The steps.

    Returns
    -------
    list[str]
        A line, or none for a file of one packing.
    """
    times = steps.times
    if not times:
        return [f"steps    {len(steps)}"] if len(steps) > 1 else []
    shown = ["-" if isnan(time) else f"{time:.10g}" for time in times]
    if len(shown) > 6:
        shown = [*shown[:3], "...", *shown[-2:]]
    word = "time" if len(times) == 1 else "times"
    return [f"steps    {len(steps):,}, {word} {' '.join(shown)}"]


def describe(packing: pv.PolyData) -> str:
    """Count, bounds, radii, volume and a histogram of the radii as text.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).

    Returns
    -------
    str
        Several lines, ASCII only.
    """
    # Upstream: PyVista before 0.49 keeps a dataset alive whose accessor packing.packing has been
    # used: https://github.com/pyvista/pyvista/pull/8925.
    spheres = PackingAccessor(packing)
    lines = [f"spheres  {spheres.n_spheres:,}", *_cell(packing)]
    if spheres.n_spheres:
        box = np.reshape(spheres.bounds, (3, 2))
        radii = np.asarray(spheres.radii, dtype=float)
        lines += [
            f"{axis}        {low:.6g} .. {high:.6g}"
            for axis, (low, high) in zip("xyz", box, strict=True)
        ]
        lines += [
            f"radius   {radii.min():.6g} .. {radii.max():.6g}, median {_median(radii):.6g}",
            f"volume   {_volume(radii)} (sum over the spheres)",
        ]
        others = [_named(packing, name) for name in packing.point_data if name != "radius"]
        if others:
            lines.append(f"arrays   {', '.join(others)}")
        lines += ["", "radii", *_histogram(radii)]
    return "\n".join(lines)
