"""The command ``spherepacking bench``."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from rich.console import Console

from ..files.image import check_output
from ..files.replace import check_replaceable, replace_file
from ..printable import printable
from ..testing.accuracy import LARGEST_COUNT
from . import fields
from .catalog import everything
from .chart import write_chart
from .measure import measure
from .table import csv_of, table_of

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from .measure import Row
    from .technique import Technique


def chosen(only: Sequence[str] | None) -> tuple[list[Technique], list[str]]:
    """Return the techniques, and the labels of metaballs, whose label has one of the words.

    Raises
    ------
    ValueError
        If a word is part of no label.
    """
    techniques = everything()
    if not only:
        return techniques, list(fields.LABELS)
    labels = [*(technique.label for technique in techniques), *fields.LABELS]
    for word in only:
        if not any(word.lower() in label.lower() for label in labels):
            raise ValueError(f"--only: found {word!r}, expected a part of: {'; '.join(labels)}")

    def named(label: str) -> bool:
        return any(word.lower() in label.lower() for word in only)

    return [t for t in techniques if named(t.label)], [
        label for label in fields.LABELS if named(label)
    ]


def _check(counts: Sequence[int], size: tuple[int, int], turns: int, limit: float) -> None:
    if not counts or not all(100 <= count <= LARGEST_COUNT for count in counts):
        raise ValueError(
            f"--counts: found {list(counts)}, expected numbers from 100 to {LARGEST_COUNT}"
        )
    if min(size) < 1 or max(size) > 8192:
        raise ValueError(
            f"--size: found {size[0]} {size[1]}, expected numbers of pixels from 1 to 8192"
        )
    if turns < 1:
        raise ValueError(f"--turns: found {turns}, expected 1 or more")
    if not 0.0 < limit < math.inf:
        raise ValueError(f"--limit: found {limit}, expected a finite number of seconds above 0")


def run(
    counts: Sequence[int],
    only: Sequence[str] | None,
    size: tuple[int, int],
    turns: int,
    limit: float,
    csv: Path,
    png: Path,
) -> list[Row]:
    """Measure, print the table and write both files; see the command's own help.

    Returns
    -------
    list of Row
        What was measured.

    Raises
    ------
    KeyboardInterrupt
        If Ctrl-C was pressed; what was done by then is printed and written.
    OSError, ValueError
        If an argument is invalid or a file cannot be written.
    """
    _check(counts, size, turns, limit)
    check_output(png)
    check_replaceable(csv)
    techniques, labels = chosen(only)
    balls_csv = csv.with_stem(f"{csv.stem}_metaballs")
    check_replaceable(balls_csv)
    rows: list[Row] = []
    balls: list[fields.FieldRow] = []
    counts = sorted(set(counts))
    stopped = None
    with Console(stderr=True).status("starting") as status:
        try:
            for row in fields.measure(counts, labels, turns, limit, status.update):
                balls.append(row)
                replace_file(balls_csv, fields.csv_of(balls))
            seen = counts if techniques else []
            for more in measure(techniques, seen, size, turns, limit, status.update):
                rows += more
                # Written at once, whatever comes after.
                replace_file(csv, csv_of(rows))
        except KeyboardInterrupt as error:
            stopped = error
    # Wide enough for all columns, also where the output is no terminal.
    console = Console(width=max(Console().width, 126))
    if balls:
        console.print(fields.table_of(balls))
        console.print(printable(f"written: {balls_csv}"), markup=False)
    if rows:
        write_chart(rows, png)
        console.print(table_of(rows, size))
        console.print(printable(f"written: {csv}, {png}"), markup=False)
    if stopped is not None:
        raise stopped
    return rows
