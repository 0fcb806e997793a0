"""Metaballs: time of a field beside its error, and how far a surface is from the true one."""

from __future__ import annotations

import csv
import dataclasses
import io
import statistics
import time
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from rich import box
from rich.table import Table

from ..accessor import PackingAccessor
from ..testing.fields import POINTS, distances, field_error
from ..testing.scenes import knot_tube

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence


TOLERANCES = (1e-1, 1e-2, 1e-3, 1e-4, 2e-5, 0.0)
"""Relative errors that are asked for; 0 sums sphere by sphere."""
GRID = 64
"""Points along each axis of the fields."""
GRIDS = (16, 32, 64, 128, 256)
"""Points along each axis of the surfaces."""
THRESHOLD = 10.0
_SPHERES = 2000  # of the surfaces
_PAIRS = 3e9  # of spheres and points a second, about
LABELS = ("metaballs, field", "metaballs, surface")


@dataclasses.dataclass(frozen=True)
class FieldRow:
    """What a field or a surface took, and its error."""

    what: str
    spheres: int
    grid: int
    """Points along each axis."""
    relative_error: float
    """That was asked for."""
    seconds: float
    """The median."""
    field_error: float = np.nan
    """The largest relative error that was found, at random points, against float64."""
    distance: float = np.nan
    """Root mean square of the surface's distance from the true one, in spacings of the grid."""
    farthest: float = np.nan
    """The largest distance that was found."""


def _timed[Made](work: Callable[[], Made], turns: int) -> tuple[float, Made]:
    """Median time of some turns after one that does not count, and what the last one made."""
    seconds = []
    for _ in range(turns + 1):
        start = time.perf_counter()
        made = work()
        seconds.append(time.perf_counter() - start)
        if seconds[0] > 10.0:
            break
    return statistics.median(seconds[1:] or seconds), made


def measure(
    counts: Sequence[int],
    labels: Sequence[str],
    turns: int,
    limit: float,
    tick: Callable[[str], None],
) -> Iterator[FieldRow]:
    """Measure fields of packings of each size, then surfaces on each grid.

    Parameters
    ----------
    counts : sequence of int
        Numbers of spheres.
    labels : sequence of str
        Which of `LABELS`.
    turns : int
        How many of each are timed.
    limit : float
        Seconds that a sum sphere by sphere may be expected to take, else it is left out.
    tick : callable
        Called with what is being measured.

    Yields
    ------
    FieldRow
        One measurement.
    """
    for count in counts if LABELS[0] in labels else ():
        packing = knot_tube(count)
        spheres = PackingAccessor(packing)
        for tolerance in TOLERANCES:
            if tolerance == 0.0 and count * GRID**3 / _PAIRS > limit:
                continue
            tick(f"{count} spheres: field to {tolerance:g}")
            work = partial(spheres.metaball_field, GRID, relative_error=tolerance)
            seconds, image = _timed(work, turns)
            error = field_error(packing, image)
            yield FieldRow("field", count, GRID, tolerance, seconds, field_error=error)
    if LABELS[1] not in labels:
        return
    packing = knot_tube(_SPHERES)
    spheres = PackingAccessor(packing)
    contour = partial(spheres.metaballs, THRESHOLD, kernel="inverse_square", coloring=None)
    for grid in GRIDS:
        tick(f"surface on a grid of {grid}")
        seconds, surface = _timed(partial(contour, dimensions=grid), turns)
        spacing = max(
            spheres.metaball_field(
                grid, kernel="inverse_square", threshold=THRESHOLD, relative_error=0.1
            ).spacing
        )
        away = distances(packing, surface, THRESHOLD) / spacing
        yield FieldRow(
            "surface",
            _SPHERES,
            grid,
            1e-3,
            seconds,
            distance=float(np.sqrt(np.mean(away**2))),
            farthest=float(away.max()),
        )


def table_of(rows: Sequence[FieldRow]) -> Table:
    """Make a table of what was measured."""
    table = Table(
        title="Metaballs: fields of r / d, and surfaces of (r / d)² at 10",
        caption="asked: relative error of the field; found: the largest at "
        f"{POINTS} random points, against float64; distance: of random points of the surface from "
        "the true one, in spacings of the grid, root mean square and largest",
        box=box.SIMPLE,
    )
    for name in ("", "spheres", "grid", "asked", "ms", "found", "distance", "largest"):
        table.add_column(name, justify="right" if name else "left")
    for row in rows:
        table.add_row(
            row.what,
            str(row.spheres),
            f"{row.grid}³",
            f"{row.relative_error:g}",
            f"{1e3 * row.seconds:.1f}",
            "" if np.isnan(row.field_error) else f"{row.field_error:.1e}",
            "" if np.isnan(row.distance) else f"{row.distance:.4f}",
            "" if np.isnan(row.farthest) else f"{row.farthest:.4f}",
        )
    return table


def csv_of(rows: Sequence[FieldRow]) -> bytes:
    """Write rows as CSV with a header, numbers with all digits, empty where there is none."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([field.name for field in dataclasses.fields(FieldRow)])
    for row in rows:
        writer.writerow(["" if value != value else value for value in dataclasses.astuple(row)])
    return text.getvalue().encode()
