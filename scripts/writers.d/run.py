"""Lets programs write, reads what they wrote, and prints a table; see scripts/writers."""

from __future__ import annotations

import importlib
import pkgutil
import re
import shutil
import sys
from pathlib import Path

import numpy as np
import programs
import spherepacking
from installed import Installed
from truth import Cell, Step, Written

_LAYOUT = "{:14} {:14} {:24} {:8} {:>7} {:9} {:6} {:5}"
_RIGHT = ("=", "none", "")  # "none": the file has no radii, and none were made up


def _read(path: Path, written: Written) -> list:
    if len(written.steps) == 1:
        return [spherepacking.read(path, **written.options)]
    steps = range(len(written.steps))
    return [spherepacking.read(path, step=step, **written.options) for step in steps]


def _same_cell(packing, cell: Cell) -> bool:
    values = {"cell_vectors": cell.vectors, "cell_origin": cell.origin}
    if cell.periodic is not None:
        values["cell_periodic"] = cell.periodic
    return all(
        name in packing.field_data
        and np.allclose(np.ravel(packing.field_data[name]), np.ravel(value), rtol=1e-12, atol=0)
        for name, value in values.items()
    )


def _differences(packing, step: Step) -> tuple[str, str, str]:
    """Return what differs in positions, radii and cell: "=" where nothing does."""
    points = np.asarray(packing.points, dtype=float).reshape(-1, 3)
    if points.shape != step.positions.shape:
        count = f"{len(points)}≠{len(step.positions)}"
        return count, count, ""
    off = float(np.max(np.abs(points - step.positions), initial=0.0))
    positions = "=" if off <= step.slack else f"{off:.1e}"
    if step.radii is None:
        radii = "none" if "radius" not in packing.point_data else "made"
    else:
        off = float(np.max(np.abs(packing["radius"] - step.radii), initial=0.0))
        radii = "=" if off == 0 else f"{off:.1e}"
    cell = "" if step.cell is None else "=" if _same_cell(packing, step.cell) else "≠"
    return positions, radii, cell


def _check(path: Path, written: Written) -> tuple[list[str], str]:
    """Return the cells of the table for a file, and what to say of it below."""
    try:
        packings = _read(path, written)
    except Exception as error:  # whatever a reader raises is what a user would see
        # Without radii, a file is refused with a sentence that says so.
        if written.steps[0].radii is None and re.search("radi|diameter", str(error)):
            return ["refused", "", "", "none"], ""
        return ["no"], f"{type(error).__name__}: {error}".replace(f"{path.parent}/", "")
    results = [_differences(p, s) for p, s in zip(packings, written.steps, strict=True)]
    columns = zip(*results, strict=True)
    worst = [max(column, key=lambda cell: cell not in _RIGHT) for column in columns]
    spheres = sum(len(step.positions) for step in written.steps)
    return ["yes", str(spheres), *worst], ""


def main() -> int:
    installed = Installed(Path(sys.argv[1]).resolve())
    known = sorted(module.name for module in pkgutil.iter_modules(programs.__path__))
    names = sys.argv[2:] or known
    if unknown := set(names) - set(known):
        raise SystemExit(f"found {', '.join(sorted(unknown))}, expected some of {', '.join(known)}")
    print(
        _LAYOUT.format(
            "program", "version", "file", "read", "spheres", "positions", "radii", "cell"
        )
    )
    failures = []
    for name in names:
        program = importlib.import_module(f"programs.{name}")
        folder = installed.folder / "written" / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        try:
            version, files = program.write(installed, folder)
        except (OSError, RuntimeError) as error:
            failures.append(f"{name}: {error}")
            continue
        for written in files:
            cells, note = _check(folder / written.name, written)
            cells += [""] * (5 - len(cells))
            print(_LAYOUT.format(name, version, written.name, *cells), flush=True)
            if cells[0] == "no" or any(cell not in _RIGHT for cell in cells[2:]):
                failures.append(f"{name}, {written.name}: {note or 'differs'}")
    print("", *failures, f"{len(failures)} failed", sep="\n")
    return bool(failures)


if __name__ == "__main__":
    sys.exit(main())
