"""What a file holds, parsed without the package: by ``float`` of its text, in rational numbers."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

# What may be lost where a file holds fractions of a box: the last bits of sums of box lengths.
_ROUNDINGS = 4


@dataclass(frozen=True)
class Cell:
    """A box: the rows of `vectors` are its edges; `periodic` is None where a file does not say."""

    vectors: list[list[float]]
    origin: list[float]
    periodic: list[bool] | None = None


@dataclass(frozen=True)
class Step:
    """The spheres of one time step; `radii` is None where the file has none."""

    positions: np.ndarray
    radii: np.ndarray | None
    cell: Cell | None = None
    slack: float = 0.0  # by how much a position may differ


@dataclass(frozen=True)
class Written:
    """A file that a program has written, and how a user has to ask for it."""

    name: str
    steps: list[Step]
    options: dict[str, Any] = field(default_factory=dict)


def table(rows: Iterable[list[str]], names: str, cell: Cell | None = None) -> Step:
    """Return what rows of words hold in columns with these names.

    Names are ``x y z`` or fractions ``xs ys zs``, ``r`` or a diameter ``d``, and any others.
    """
    columns = {name: number for number, name in enumerate(names.split())}
    rows = list(rows)

    def numbers(name: str) -> list[float]:
        return [float(row[columns[name]]) for row in rows]

    slack = 0.0
    if "xs" in columns:
        assert cell is not None
        fractions = np.array([numbers(name) for name in ("xs", "ys", "zs")]).T.reshape(-1, 3)
        positions = _in_box(fractions, cell)
        slack = _ROUNDINGS * np.spacing(max(abs(v) for row in cell.vectors for v in row))
    else:
        positions = np.array([numbers(name) for name in ("x", "y", "z")]).T.reshape(-1, 3)
    radii = None
    if "r" in columns:
        radii = np.array(numbers("r"))
    elif "d" in columns:
        radii = 0.5 * np.array(numbers("d"))
    return Step(positions, radii, cell, slack)


def _in_box(fractions: np.ndarray, cell: Cell) -> np.ndarray:
    """Return origin + fractions · vectors, rounded once."""
    exact = [
        [
            Fraction(cell.origin[axis])
            + sum(Fraction(s) * Fraction(v[axis]) for s, v in zip(row, cell.vectors, strict=True))
            for axis in range(3)
        ]
        for row in fractions.tolist()
    ]
    return np.array([[float(value) for value in row] for row in exact]).reshape(-1, 3)


def dump(text: str, cell: Cell) -> list[Step]:
    """Return the steps of a LAMMPS or LIGGGHTS dump."""
    same = {"xu": "x", "yu": "y", "zu": "z", "radius": "r", "diameter": "d"}
    steps = []
    for section in text.split("ITEM: TIMESTEP\n")[1:]:
        head, body = section.split("ITEM: ATOMS", 1)
        words = [line.split() for line in body.split("ITEM:", 1)[0].splitlines()]
        rows = [row for row in words[1:] if row]
        assert len(rows) == int(head.split("NUMBER OF ATOMS\n")[1].split()[0])
        steps.append(table(rows, " ".join(same.get(name, name) for name in words[0]), cell))
    return steps


def with_and_without_radius(name: str, steps: list[Step], radius: float = 0.5) -> list[Written]:
    """Return a file without radii as it is, and as asked for with one radius for all spheres."""
    given = [replace(step, radii=np.full(len(step.positions), radius)) for step in steps]
    return [Written(name, steps), Written(name, given, {"radius": radius})]


def lines(path: Path, skip: str = "#") -> list[list[str]]:
    """Return the words of a file's lines that are not blank and do not begin with `skip`."""
    text = path.read_text().splitlines()
    return [line.split() for line in text if line.strip() and not line.startswith(skip)]


def told(path: Path) -> list[Written]:
    """Return what a program's own interface says of its files, from a JSON file."""
    return [
        Written(
            name,
            [
                Step(
                    np.array(step["positions"], float).reshape(-1, 3),
                    None if step["radii"] is None else np.array(step["radii"], float),
                    Cell(**step["cell"]) if step.get("cell") else None,
                )
                for step in steps
            ],
        )
        for name, steps in json.loads(path.read_text()).items()
    ]
