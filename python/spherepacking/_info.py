"""What ``spherepacking info`` prints about a packing."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .accessor import PackingAccessor

if TYPE_CHECKING:
    import pyvista as pv

_BINS = 10
_BAR = 40
# Radii that spread over more than this ratio are binned by their logarithm.
_WIDE = 20.0


def _histogram(radii: np.ndarray) -> list[str]:
    """Lines `from … to  count  bar` for radii (n,) that are not negative, n > 0."""
    low, high = radii.min(), radii.max()
    positive = radii[radii > 0.0]
    lines = []
    if high == 0.0 or low == high:
        edges = np.array([low, high])
    elif high > _WIDE * positive.min():
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
    # Not packing.packing: before 0.49, PyVista kept a dataset alive whose accessor had been used.
    spheres = PackingAccessor(packing)
    lines = [f"spheres  {spheres.n_spheres:,}"]
    if spheres.n_spheres:
        box = np.reshape(spheres.bounds, (3, 2))
        radii = np.asarray(spheres.radii, dtype=float)
        lines += [
            f"{axis}        {low:.6g} .. {high:.6g}"
            for axis, (low, high) in zip("xyz", box, strict=True)
        ]
        lines += [
            f"radius   {radii.min():.6g} .. {radii.max():.6g}, median {np.median(radii):.6g}",
            f"volume   {spheres.volume:.6g} (sum over the spheres)",
        ]
        others = [name for name in packing.point_data if name != "radius"]
        if others:
            lines.append(f"arrays   {', '.join(others)}")
        lines += ["", "radii", *_histogram(radii)]
    return "\n".join(lines)
