"""Pictures of a plotter's view of any size, and whether they could be drawn."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from ..checks import half_of_memory
from ..vtk_tools import window_of

if TYPE_CHECKING:
    from collections.abc import Generator, Iterator, Sequence

    from ..backend import vtkRenderWindow

_LARGEST_PIECE = 4096
"""Side in pixels of what is drawn in one piece."""
_TILE = 2135
"""Side of a tile in pixels; its square needs some 300 MB with VTK's supersampling."""
_STEP = 2046
"""Pixels from one tile to the next.

A filter over the picture may reach as far as half of what tiles overlap. VTK's supersampling draws
the square root of 5 times as many pixels along each side, and times this tile and step are within
0.01 of integers: the samples of all tiles are on one grid.
"""
_SUPERSAMPLING = 5.0**0.5


@contextmanager
def drawing_checked(window: vtkRenderWindow) -> Iterator[None]:
    """Raise a RuntimeError after the block if the window could not draw what it was asked for.

    Parameters
    ----------
    window : vtkRenderWindow
        The window.

    Examples
    --------
    >>> import pyvista as pv
    >>> from spherepacking.draw.picture import drawing_checked
    >>> plotter = pv.Plotter(off_screen=True, window_size=(200, 150))
    >>> with drawing_checked(plotter.render_window):
    ...     plotter.render()
    >>> plotter.close()
    """
    from ..backend import vtkSpherePackingWindowCheck

    # In C++: VTK ends the process when Ctrl-C comes while an observer in Python runs.
    check = vtkSpherePackingWindowCheck()
    check.Begin(window)
    try:
        yield
    finally:
        problem = check.End()
    if problem:
        raise RuntimeError(f"the picture cannot be drawn: {problem}")


def check_drawn_size(name: str, size: tuple[int, int], channels: int) -> None:
    """Raise a ValueError unless half of the memory holds a picture, before it is drawn.

    Parameters
    ----------
    name : str
        What to call the size.
    size : tuple[int, int]
        Width and height in pixels.
    channels : int
        Bytes of a pixel.
    """
    room = half_of_memory() // channels
    if size[0] * size[1] > room:
        raise ValueError(
            f"{name}: found {size[0]} x {size[1]}, which takes more than half of the memory, "
            f"expected at most {room} pixels"
        )


def check_one_piece(plotter: pv.BasePlotter, window_size: Sequence[int] | None) -> None:
    """Raise a ValueError unless a picture of the plotter's window can be drawn in one piece.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        The plotter.
    window_size : sequence of int, optional
        Width and height that the window is going to have, if not those that it has.
    """
    width, height = plotter.window_size if window_size is None else window_size
    if max(width, height) * plotter.image_scale > _LARGEST_PIECE:
        scaled = f" times {plotter.image_scale}" if plotter.image_scale > 1 else ""
        raise ValueError(
            f"window_size: found {width} x {height}{scaled}, expected at most {_LARGEST_PIECE} "
            "pixels along a side; plotter.packing.screenshot makes larger pictures"
        )


def strips(
    plotter: pv.BasePlotter, size: tuple[int, int], *, transparent: bool, scale: int = 1
) -> Generator[np.ndarray]:
    """Draw a plotter's view, strip by strip from the top.

    Pictures that are too large for one framebuffer are drawn in tiles. A view looks as if it was
    drawn in one piece, but for rounding at edges of triangles and the places of VTK's
    supersampling.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        The plotter; it is as it was when the generator ends or is closed.
    size : tuple[int, int]
        Width and height in pixels.
    transparent : bool
        Whether pixels have an alpha channel.
    scale : int, default: 1
        How many times as large as usual texts are.

    Yields
    ------
    numpy.ndarray
        Pixels (rows, width, 3 or 4), uint8, the upper row first.

    Raises
    ------
    RuntimeError
        If the picture cannot be drawn.
    """
    window = window_of(plotter)
    before = window.GetActualSize()
    if max(before) > _LARGEST_PIECE:
        # Only to ask what OpenGL has would need the memory of the whole window.
        window.SetSize(_TILE, _TILE)
    try:
        if max(size) <= _piece(window):
            yield _in_one_piece(plotter, size, transparent, scale)
        else:
            yield from _in_tiles(plotter, size, transparent, scale, *_tile_and_step(window))
    finally:
        window.SetSize(*before)


def _piece(window: vtkRenderWindow) -> int:
    """Side of what can be drawn in one piece."""
    return min(_LARGEST_PIECE, _largest_side(window))


def _tile_and_step(window: vtkRenderWindow) -> tuple[int, int]:
    """Side of a tile, and pixels to the next."""
    largest = _largest_side(window)
    return (_TILE, _STEP) if largest >= _TILE else (largest, max(1, largest - 64))


def _largest_side(window: vtkRenderWindow) -> int:
    """The largest side that OpenGL has, supersampled."""
    from ..backend import vtkSpherePackingWindowCheck

    side = vtkSpherePackingWindowCheck.GetLargestSide(window)
    return int(side / _SUPERSAMPLING) if side > 0 else _LARGEST_PIECE


def _in_one_piece(
    plotter: pv.BasePlotter, size: tuple[int, int], transparent: bool, scale: int
) -> np.ndarray:
    """Let PyVista draw."""
    window_size = (size[0] // scale, size[1] // scale)
    with drawing_checked(window_of(plotter)):
        # Upstream: PyVista 0.49's screenshot does not render again, and would miss what has changed
        # since the last rendering.
        plotter.render()
        pixels = plotter.screenshot(
            None,
            return_img=True,
            transparent_background=transparent,
            window_size=None if window_size == tuple(plotter.window_size) else window_size,
            scale=scale,
        )
    return np.asarray(pixels)


def _in_tiles(
    plotter: pv.BasePlotter,
    size: tuple[int, int],
    transparent: bool,
    scale: int,
    tile: int,
    step: int,
) -> Generator[np.ndarray]:
    """Draw rows of tiles."""
    from ..backend import vtkSpherePackingTiles

    window = window_of(plotter)
    sides = [min(tile, side) for side in size]
    columns, rows = (_starts(*pair, step) for pair in zip(size, sides, strict=True))
    tiles = vtkSpherePackingTiles()
    if not tiles.Begin(window, size, sides, scale):
        raise RuntimeError(
            "the picture cannot be drawn: found a camera with an off-axis projection or a window "
            f"in stereo, expected neither, or at most {_piece(window)} pixels along a side"
        )
    try:
        # Places the cameras of a scene that has not been shown, for a window of the picture's size.
        with drawing_checked(window):
            plotter.screenshot(None, return_img=True)
        for row, above in reversed(list(zip(rows, [*rows[1:], None], strict=True))):
            top = size[1] if above is None else above + _overlap(sides[1], step)
            bottom = row + _overlap(sides[1], step) if row else 0
            strip = np.empty((top - bottom, size[0], 4 if transparent else 3), np.uint8)
            for column in columns:
                left = column + _overlap(sides[0], step) if column else 0
                with drawing_checked(window):
                    tiles.Render(column, row)
                pixels = _pixels_of(window, sides, transparent)
                part = pixels[bottom - row : top - row, left - column :]
                strip[:, left : column + sides[0]] = part
            yield strip[::-1]
    finally:
        tiles.End()


def _overlap(tile: int, step: int) -> int:
    """Pixels at the lower and left edge of a tile that are left to the tile before."""
    return max(0, tile - step) // 2


def _starts(length: int, tile: int, step: int) -> list[int]:
    """First pixels of tiles along one axis; the last one ends where the picture does."""
    starts = [0]
    while starts[-1] + tile < length:
        starts.append(min(starts[-1] + step, length - tile))
    return starts


def _pixels_of(window: vtkRenderWindow, size: Sequence[int], transparent: bool) -> np.ndarray:
    """What the window holds, the lower row first."""
    from ..backend import vtkUnsignedCharArray

    values = vtkUnsignedCharArray()
    width, height = size
    # The front buffer, which has been resolved as PyVista's pictures are.
    if transparent:
        window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 1, values, 0)
    else:
        window.GetPixelData(0, 0, width - 1, height - 1, 1, values, 0)
    return pv.convert_array(values).reshape(height, width, -1)
