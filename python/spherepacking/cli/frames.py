"""Pictures of many steps: one by one into numbered files, or into a movie."""

from __future__ import annotations

import re
import shutil
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from ..files.image import check_output, read_image
from ..files.replace import check_replaceable, replacing

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

MOVIES = (".mp4", ".gif", ".avi", ".mkv", ".mov", ".webm")
_NUMBER = re.compile(r"%(0\d+)?d")


def slice_of(text: str) -> slice:
    """Indices that ``--steps`` stands for, as in Python.

    Parameters
    ----------
    text : str
        ``FIRST:END:STRIDE``, of which each may be left out, or one index.

    Returns
    -------
    slice
        The indices.

    Raises
    ------
    ValueError
        If it is none.
    """
    parts = text.split(":")
    try:
        numbers = [int(part) if part.strip() else None for part in parts]
        if len(parts) > 3 or (len(parts) == 3 and numbers[2] == 0) or not text.strip():
            raise ValueError
    except ValueError:
        raise ValueError(
            f"--steps: found {text}, expected FIRST:END:STRIDE as in Python, such as 0:100:2 or :"
        ) from None
    if len(numbers) == 1:
        (index,) = numbers
        return slice(index, None if index == -1 else (index or 0) + 1)
    return slice(*numbers)


def is_movie(output: Path) -> bool:
    """Whether the extension is one of movies."""
    return output.suffix.lower() in MOVIES


def has_number(output: Path) -> bool:
    """Whether the name has a place for the number of a step."""
    return _NUMBER.search(output.name) is not None


def check_frames(output: Path, size: tuple[int, int]) -> None:
    """Raise unless the pictures of several steps could be written.

    Parameters
    ----------
    output : pathlib.Path
        Name with a ``%d`` or ``%04d``, or that of a movie.
    size : tuple[int, int]
        Width and height of the pictures in pixels.

    Raises
    ------
    ImportError
        If the library that writes movies is not installed.
    OSError
        If it cannot be written.
    ValueError
        If there is no number in the name, no such format, or a movie cannot have that size.
    """
    if not is_movie(output):
        if len(_NUMBER.findall(output.name)) != 1 or "%" in _NUMBER.sub("", output.name):
            raise ValueError(
                f"--output: found {output}, expected a number in the name, such as f_%04d.png, or "
                f"a movie ({', '.join(MOVIES)})"
            )
        check_output(output.with_name(output.name % 0))
        return
    try:
        import imageio  # noqa: F401

        if output.suffix.lower() != ".gif":
            import imageio_ffmpeg  # noqa: F401
    except ImportError:
        raise ImportError(
            f"--output: found the movie {output}, which imageio writes, expected that to be "
            "installed: pip install 'spherepacking[movies]'; or a name such as f_%04d.png"
        ) from None
    if output.suffix.lower() != ".gif" and (size[0] % 2 or size[1] % 2):
        raise ValueError(f"--size: found {size[0]} {size[1]}, expected even numbers for a movie")
    check_replaceable(output)


@contextmanager
def frame_writer(
    output: Path, fps: float
) -> Iterator[Callable[[int, Callable[[Path], Any]], None]]:
    """Write pictures one after the other.

    Parameters
    ----------
    output : pathlib.Path
        As in :func:`check_frames`.
    fps : float
        Pictures a second in a movie.

    Yields
    ------
    callable
        Takes the number of a picture and a function that draws it into a file. A movie appears
        under its name when it is complete.
    """
    if not is_movie(output):
        yield lambda number, draw: draw(output.with_name(output.name % number))
        return
    from imageio.v2 import get_writer

    # Not beside the movie, where it would be left if the process was killed.
    with TemporaryDirectory(prefix="spherepacking-") as folder:
        part = Path(folder) / output.name
        frame = Path(folder) / "frame.png"
        gif = output.suffix.lower() == ".gif"
        options: dict[str, Any] = (
            {"duration": 1000.0 / fps, "loop": 0}
            if gif
            else {"fps": fps, "quality": 8, "macro_block_size": 2}
        )
        writer: Any
        with get_writer(part, **options) as writer:

            def append(_: int, draw: Callable[[Path], Any]) -> None:
                draw(frame)
                writer.append_data(read_image(frame)[..., :3])

            yield append
        with part.open("rb") as whole, replacing(output) as file:
            shutil.copyfileobj(whole, file)
