"""The options of the command line that say what is read."""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

from cyclopts import Parameter

from ..printable import printable
from .options import Whole

if TYPE_CHECKING:
    from pathlib import Path

    import pyvista as pv

    from ..files.steps import PackingSteps
    from ..radii import RadiusLike


@Parameter(name="*")
@dataclass(frozen=True)
class InputOptions:
    """Which step of a file is read, and how.

    Parameters
    ----------
    step
        Index of the step, negative from the end; the first by default.
    time
        Instead of the index, the time that the file gives the step.
    radius
        Radii, for files without: a number, the name of a column or array, or one number for each
        type, such as 1=0.5,2=0.3 or C=1.7,H=1.1.
    columns
        Names of the columns of a table in text, such as "id x y z r".
    """

    step: Whole | None = None
    time: float | None = None
    radius: str | None = None
    columns: str | None = None


def open_steps(path: Path, options: InputOptions) -> PackingSteps:
    """Find the steps of a file, or of those that fit a pattern."""
    from ..files.steps import steps

    radius = None if options.radius is None else radius_of(options.radius)
    return steps(path, radius=radius, columns=options.columns, progress=sys.stderr.isatty())


def read_step(steps: PackingSteps, path: Path, options: InputOptions) -> pv.PolyData:
    """Read the step that was asked for; which one was taken is said if none was.

    Parameters
    ----------
    steps : PackingSteps
        Steps of the file.
    path : pathlib.Path
        File, for messages.
    options : InputOptions
        Which step was asked for.

    Returns
    -------
    pyvista.PolyData
        The packing.

    Raises
    ------
    ValueError
        If there is no such step.
    """
    try:
        index = steps.index_of(options.step, options.time)
    except (TypeError, ValueError) as error:
        raise ValueError(f"--{error}") from None
    packing = steps[index]
    if options.step is None and options.time is None and len(steps) > 1:
        times = steps[index : index + 1].times
        at = f", of time {times[0]:g}" if times else ""
        print(
            f"spherepacking: {printable(str(path))} has {len(steps)} steps, this is the first{at}; "
            "--step takes another",
            file=sys.stderr,
        )
    return packing


def radius_of(text: str) -> RadiusLike:
    """What the text of ``--radius`` stands for.

    Parameters
    ----------
    text : str
        A number, a name, or pairs TYPE=NUMBER.

    Returns
    -------
    float, str or dict
        The argument `radius` of :func:`spherepacking.read`.

    Raises
    ------
    ValueError
        If it is none of these.
    """
    if "=" not in text:
        try:
            return float(text)
        except ValueError:
            return text
    found: dict[str, float] = {}
    for pair in re.split(r"[,;\s]+", text.strip(" ,;")):
        kind, _, number = pair.partition("=")
        try:
            found[kind] = float(number)
        except ValueError:
            raise ValueError(
                f"--radius: found {pair}, expected a type and its radius, such as 1=0.5"
            ) from None
    if all(re.fullmatch(r"[+-]?\d+", kind) for kind in found):
        return {int(kind): number for kind, number in found.items()}
    return found
