"""The command ``spherepacking``."""

from __future__ import annotations

import os
import signal
import sys
from pathlib import Path
from typing import Annotated

from cyclopts import App, CycloptsError, Parameter

from ..printable import printable
from .input import InputOptions
from .options import RenderOptions, Whole

_READ_BY_DEFAULT = InputOptions()
_LONGEST = 2000  # characters of an error


def _version() -> str:
    from .. import __version__

    return f"spherepacking {__version__}"


app = App(
    name="spherepacking",
    help="See sphere packings: exact ray-cast spheres.",
    version=_version,
    version_format="plaintext",
    suppress_keyboard_interrupt=False,
)


def _load(*, drawing: bool = False) -> None:
    """Import what takes long; Ctrl-C waits for it.

    Upstream: VTK 9.7 crashes when KeyboardInterrupt comes while one of its modules is imported, and
    PyVista 0.49 makes an ImportError of it. PyVista imports what draws when it is asked for, and
    some of that by the first plotter.
    """
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        import pyvista as pv

        from .. import backend  # noqa: F401
        from ..files import image, steps, writers  # noqa: F401

        if drawing:
            pv.Plotter(off_screen=True).close()
    finally:
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


@app.command
def render(
    packing: Path, /, *, options: RenderOptions, source: InputOptions = _READ_BY_DEFAULT
) -> None:
    """Draw a packing and save the picture, or draw the steps of a run.

    Parameters
    ----------
    packing
        File with the packing, or a quoted pattern of files, such as "run_*.vtu".
    """
    from ..draw.offscreen import choose_window

    choose_window()
    _load(drawing=True)

    from .render import render as draw

    draw(packing, options, source)


@app.command
def info(packing: Path, /, *, source: InputOptions = _READ_BY_DEFAULT) -> None:
    """Print count, bounds, radii and volume of a packing, and the steps of a run.

    Parameters
    ----------
    packing
        File with the packing, or a quoted pattern of files, such as "run_*.vtu".
    """
    _load()

    from .info import describe, describe_steps
    from .input import open_steps, read_step

    steps = open_steps(packing, source)
    text = describe(read_step(steps, packing, source))
    print("\n".join([*describe_steps(steps), text]))


@app.command
def convert(packing: Path, target: Path, /, *, source: InputOptions = _READ_BY_DEFAULT) -> None:
    """Write a packing in another format, and say what that cannot hold.

    Parameters
    ----------
    packing
        File with the packing.
    target
        File to write; its extension decides about the format.
    """
    _load()

    from ..files.writers import check_writable, left_out, write
    from .input import open_steps, read_step

    packing, target = packing.expanduser(), target.expanduser()
    if target.exists() and packing.exists() and target.samefile(packing):
        raise ValueError(f"{target}: found the source as the target, expected another file")
    check_writable(target)
    read = read_step(open_steps(packing, source), packing, source)
    write(read, target)
    if lost := left_out(read, target):
        print(f"spherepacking: {lost}", file=sys.stderr)


@app.command
def pack(
    mesh: Path,
    target: Path,
    /,
    *,
    count: Whole = 1000,
    seed: Whole = 0,
    min_radius: float | None = None,
    fraction: float | None = None,
) -> None:
    """Fill a closed surface with spheres and write the packing.

    Ctrl-C ends it and writes the spheres that are there.

    Parameters
    ----------
    mesh
        File with the surface: .off, .stl, .ply, .obj, .vtp, .vtu or .vtk. No other file that it
        names is read.
    target
        File to write; its extension decides about the format.
    count
        How many spheres at most, whatever else is asked for.
    seed
        Another number gives another packing.
    min_radius
        Radii are above this, in the unit of the surface. For all such spheres, give a large count.
    fraction
        Part of the volume that is enough, above 0 and up to 1, if the count allows it.
    """
    _load()

    from .pack import pack_file

    if not pack_file(
        mesh.expanduser(),
        target.expanduser(),
        count=count,
        seed=seed,
        min_radius=min_radius,
        fraction=fraction,
    ):
        raise KeyboardInterrupt


@app.command
def bench(
    *,
    counts: Annotated[tuple[int, ...], Parameter(consume_multiple=True, negative=())] = (
        5_000,
        50_000,
        100_000,
        200_000,
        300_000,
        1_000_000,
    ),
    only: Annotated[list[str] | None, Parameter(consume_multiple=True, negative=())] = None,
    size: tuple[int, int] = (1000, 1000),
    turns: Whole = 5,
    limit: float = 20.0,
    csv: Path = Path("bench.csv"),
    png: Path = Path("bench.png"),
) -> None:
    """Measure speed beside error on this machine, of this package and of others that are there.

    Every technique makes pictures of polydisperse packings in a knotted tube, seen from (3, 3, 3);
    they take turns. What it shows is compared with float64 rays. Fields of metaballs are compared
    with float64 sums. Ctrl-C keeps the counts that are done.

    Parameters
    ----------
    counts
        Numbers of spheres, each from 100 on.
    only
        Measure techniques with one of these words in their name alone: ray, opengl, metaballs, ...
    size
        Width and height of the pictures in pixels.
    turns
        How many pictures of each are timed, after one that is not.
    limit
        Seconds that a technique may take for its pictures of one packing; the first picture of the
        smallest packing is always made.
    csv
        File to write all numbers to; those of metaballs go to one whose name ends in _metaballs.
    png
        Picture to write the charts to.
    """
    from ..draw.offscreen import choose_window

    choose_window()
    _load(drawing=True)

    from ..bench.command import run

    run(counts, only, size, turns, limit, csv, png)


def _flush() -> None:
    """Write out what was printed; at the interpreter's end a failure could not be reported."""
    try:
        # None when the process was started without.
        if sys.stdout is not None:
            sys.stdout.flush()
    except OSError:
        # The interpreter flushes again when it ends.
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)
        raise


def main(arguments: list[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments : list[str], optional
        Arguments without the name of the program, by default those of the process.

    Returns
    -------
    int
        Exit status: 0, 2 after an error, which is printed as one line on stderr, or 128 and the
        number of the signal that the shell knows the ending by.
    """
    try:
        app(arguments, exit_on_error=False, print_error=False, result_action="return_value")
        _flush()
    except BrokenPipeError:
        # Whoever reads the output has seen enough, as `head` does.
        return 128 + signal.SIGPIPE
    except (CycloptsError, OSError, ValueError, ImportError) as error:
        text = printable(" ".join(str(error).split()), _LONGEST)
        print(f"spherepacking: {text}", file=sys.stderr)
        return 2
    except MemoryError as error:
        print(f"spherepacking: not enough memory: {error}".rstrip(": "), file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("spherepacking: stopped", file=sys.stderr)
        return 128 + signal.SIGINT
    return 0
