"""Charts of measured rows: time over the number of spheres, and error over time."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from pathlib import Path

    from .measure import Row

SIZE = (3000, 1500)
_COLORS = ("#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17becf", "#e377c2", "#8c564b")
_MARKERS = ("o", "s", "d", "x", "+")


def _looks(rows: Sequence[Row]) -> dict[str, tuple[str, str]]:
    """A colour for each technique and a marker for each of its variants, by label."""
    looks: dict[str, tuple[str, str]] = {}
    techniques: dict[str, int] = {}
    for row in rows:
        if row.label in looks:
            continue
        color = list(dict.fromkeys(r.technique for r in rows)).index(row.technique)
        variant = techniques.get(row.technique, 0)
        techniques[row.technique] = variant + 1
        looks[row.label] = (
            _COLORS[color % len(_COLORS)],
            _MARKERS[variant % len(_MARKERS)],
        )
    return looks


def _wrong(row: Row) -> float:
    """Fraction of wrong pixels; none are drawn as half a pixel, since 0 has no logarithm."""
    return max(row.wrong_pixels, 0.5) / max(row.hit_pixels, 1)


# Title, and what is along x and y.
_CHARTS: tuple[tuple[str, str, str, Callable[[Row], float], Callable[[Row], float]], ...] = (
    (
        "Time by number of spheres",
        "spheres",
        "seconds per frame",
        lambda row: row.spheres,
        lambda row: row.seconds,
    ),
    (
        "Silhouette and sphere: error by time",
        "seconds per frame",
        "fraction of wrong pixels (none: at half a pixel)",
        lambda row: row.seconds,
        _wrong,
    ),
    (
        "Depth: error by time",
        "seconds per frame",
        "median of the relative error",
        lambda row: row.seconds,
        lambda row: row.depth_median,
    ),
    (
        "Smoothness: error by time",
        "seconds per frame",
        "RMS colour difference from 256 rays per pixel",
        lambda row: row.seconds,
        lambda row: row.color_error,
    ),
    (
        "Light: error by time",
        "seconds per frame",
        "relative MSE against 4096 paths per pixel",
        lambda row: row.seconds,
        lambda row: row.relative_mse,
    ),
    (
        "Light: visible error by time",
        "seconds per frame",
        "mean FLIP error against 4096 paths per pixel",
        lambda row: row.seconds,
        lambda row: row.flip,
    ),
)


def write_chart(rows: Sequence[Row], path: Path) -> None:
    """Draw the charts and save them as a picture.

    Parameters
    ----------
    rows : sequence of Row
        What was measured, one row at least.
    path : pathlib.Path
        Picture to write, in any format of OpenImageIO.

    Raises
    ------
    OSError
        If the picture cannot be written.
    """
    from ..files.image import write_image

    looks = _looks(rows)
    plotter = pv.Plotter(off_screen=True, shape=(2, 3), window_size=list(SIZE), border=False)
    try:
        for i, description in enumerate(_CHARTS):
            plotter.subplot(i // 3, i % 3)
            plotter.background_color = pv.Color("white")
            plotter.add_chart(_chart(rows, looks, *description, legend=i == 0))
        pixels = plotter.screenshot(None, return_img=True, transparent_background=False)
    finally:
        plotter.close()
    write_image(path, np.asarray(pixels))


def _chart(
    rows: Sequence[Row],
    looks: dict[str, tuple[str, str]],
    title: str,
    x_label: str,
    y_label: str,
    x_of: Callable[[Row], float],
    y_of: Callable[[Row], float],
    legend: bool,
) -> pv.Chart2D:
    chart = pv.Chart2D(x_label=x_label, y_label=y_label)
    chart.title = title
    drawn = []
    for label, (color, marker) in looks.items():
        pairs = [(x_of(row), y_of(row)) for row in rows if row.label == label]
        points = np.array([p for p in pairs if all(math.isfinite(v) and v > 0.0 for v in p)])
        if not len(points):
            continue
        drawn.append(points)
        x, y = points.T
        chart.line(x, y, color=color, width=1.5)
        chart.scatter(x, y, color=color, size=12.0, style=marker, label=label)
    for axis, values in zip((chart.x_axis, chart.y_axis), _columns(drawn), strict=True):
        axis.log_scale = True
        axis.range = values.min() / 1.5, values.max() * 1.5
        axis.label_size, axis.tick_label_size = 20, 16
    chart.GetTitleProperties().SetFontSize(24)
    chart.legend_visible = legend
    if legend:
        chart.GetLegend().SetLabelSize(18)
        # The legend is beside the lines.
        low, high = chart.x_axis.range
        chart.x_axis.range = low, high * (high / low) ** 0.6
    return chart


def _columns(points: list[np.ndarray]) -> np.ndarray:
    """All x in the first and all y in the second row; a stand-in where there are no points."""
    return np.concatenate(points).T if points else np.ones((2, 1))
