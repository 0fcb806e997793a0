"""Measured rows as a table on the terminal and as CSV."""

from __future__ import annotations

import csv
import dataclasses
import io
import math
from typing import TYPE_CHECKING

from rich import box
from rich.table import Table

from .measure import Row

if TYPE_CHECKING:
    from collections.abc import Sequence


def _number(value: float, form: str) -> str:
    return "" if math.isnan(value) else format(value, form)


def table_of(rows: Sequence[Row], size: tuple[int, int]) -> Table:
    """Make a table, grouped by the number of spheres.

    Parameters
    ----------
    rows : sequence of Row
        What was measured.
    size : (int, int)
        Width and height of the pictures in pixels.

    Returns
    -------
    rich.table.Table
        One line per row.
    """
    table = Table(
        title=f"Frame of {size[0]} × {size[1]} pixels, and its error against float64 rays",
        caption="ms: a frame; build: the structure's, in ms; bytes: of the structure, per sphere; "
        "wrong: fraction of the hit pixels that show another sphere, or none; depth, most: median "
        "and largest of the relative errors; colour: RMS difference from 256 rays per pixel, white "
        "is 1; relMSE and FLIP: of the light, against 4096 paths per pixel",
        box=box.SIMPLE,
    )
    for name in ("spheres", "technique", "ms", "build", "bytes"):
        table.add_column(name, justify="left" if name == "technique" else "right", no_wrap=True)
    for name in ("wrong", "depth", "most", "colour", "relMSE", "FLIP"):
        table.add_column(name, justify="right")
    before = None
    for row in rows:
        if before not in (None, row.spheres):
            table.add_section()
        table.add_row(
            "" if row.spheres == before else f"{row.spheres}",
            row.label,
            f"{1e3 * row.seconds:.1f}",
            _number(1e3 * row.build_seconds, ".1f"),
            _number(row.bytes_per_sphere, ".1f"),
            f"{row.wrong_pixels / max(row.hit_pixels, 1):.1e}" if row.wrong_pixels else "0",
            _number(row.depth_median, ".1e"),
            _number(row.depth_most, ".1e"),
            _number(row.color_error, ".4f"),
            _number(row.relative_mse, ".1e"),
            _number(row.flip, ".4f"),
        )
        before = row.spheres
    return table


def csv_of(rows: Sequence[Row]) -> bytes:
    """Write rows as CSV with a header, numbers with all digits, empty where there is none."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    names = [field.name for field in dataclasses.fields(Row)]
    writer.writerow(names)
    for row in rows:
        values = [getattr(row, name) for name in names]
        writer.writerow(
            ["" if isinstance(value, float) and math.isnan(value) else value for value in values]
        )
    return text.getvalue().encode()
