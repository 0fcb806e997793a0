"""The part of the plotter component ``packing`` that makes pictures of the scene."""

from __future__ import annotations

from contextlib import closing
from typing import TYPE_CHECKING

import numpy as np

from . import checks

if TYPE_CHECKING:
    import os
    from collections.abc import Generator

    import pyvista as pv

    from .trace.live import LivePicture


class PicturesOfPlotter:
    """Makes pictures of the view, of any size, and says when spheres could not be drawn."""

    _pictures: list[LivePicture]

    @property
    def plotter(self) -> pv.BasePlotter:
        """The plotter whose view it is."""
        raise NotImplementedError

    def screenshot(
        self,
        filename: str | os.PathLike[str],
        *,
        transparent_background: bool | None = None,
        window_size: tuple[int, int] | None = None,
        scale: int | None = None,
    ) -> np.ndarray:
        """Save the view as a picture through OpenImageIO.

        Parameters
        ----------
        filename : str or os.PathLike
            The extension decides about the format: ``.png``, ``.tif``, ``.exr``, ``.jpg``, …
        transparent_background : bool, optional
            Save an alpha channel, 0 where there is nothing; by default as the theme says.
        window_size : tuple[int, int], optional
            Width and height in pixels.
        scale : int, optional
            Factor by which the picture is larger than the window.

        Returns
        -------
        numpy.ndarray
            Pixels (height, width, 3 or 4), uint8.

        Raises
        ------
        OSError
            If the file cannot be written.
        RuntimeError
            If the spheres cannot be drawn in this view; nothing is written.
        TypeError, ValueError
            If the format is unknown, or the picture's size is invalid, above 32768 along a side, or
            more than half of the memory.
        """
        from .draw.picture import check_drawn_size
        from .files.image import check_output, write_image

        check_output(filename)
        if transparent_background is None:
            transparent_background = bool(self.plotter.theme.transparent_background)
        factor, size = self._drawn_size(window_size, scale)
        channels = 4 if transparent_background else 3
        check_drawn_size("window_size", size, channels)
        pixels = np.empty((size[1], size[0], channels), np.uint8)
        row = 0
        with closing(self.strips(size, transparent_background, factor)) as strips:
            for strip in strips:
                pixels[row : row + len(strip)] = strip
                row += len(strip)
        write_image(filename, pixels)
        return pixels

    def _drawn_size(
        self, window_size: tuple[int, int] | None, scale: int | None
    ) -> tuple[int, tuple[int, int]]:
        """The factor of a screenshot, and its width and height in pixels."""
        largest = checks.LARGEST_DRAWN_SIDE
        factor = 1 if scale is None else checks.count_of("scale", scale, most=largest)
        width, height = checks.size_of(
            "window_size",
            self.plotter.window_size if window_size is None else window_size,
            most=largest // factor,
        )
        return factor, (factor * width, factor * height)

    def strips(
        self, size: tuple[int, int], transparent: bool, scale: int = 1
    ) -> Generator[np.ndarray]:
        """Draw the view strip by strip from the top, as :meth:`screenshot` saves it.

        For pictures that do not fit into memory.

        Parameters
        ----------
        size : tuple[int, int]
            Width and height in pixels.
        transparent : bool
            Whether pixels have an alpha channel, 0 where there is nothing.
        scale : int, default: 1
            How many times as large as usual texts are.

        Returns
        -------
        generator of numpy.ndarray
            Pixels (rows, width, 3 or 4), uint8, the upper row first, of one strip after the other.
            The plotter is as it was when the generator ends or is closed.

        Raises
        ------
        RuntimeError
            If the spheres cannot be drawn in this view.
        TypeError, ValueError
            If an argument is invalid; at once, not with the first strip.

        Examples
        --------
        >>> import pyvista as pv
        >>> import spherepacking
        >>> plotter = pv.Plotter(off_screen=True)
        >>> actor = plotter.packing.add(spherepacking.apollonian(3))
        >>> [strip.shape for strip in plotter.packing.strips((300, 200), False)]
        [(200, 300, 3)]
        >>> plotter.close()
        """
        size = checks.size_of("size", size, most=checks.LARGEST_DRAWN_SIDE)
        transparent = checks.flag_of("transparent", transparent)
        scale = checks.count_of("scale", scale)
        if size[0] % scale or size[1] % scale:
            raise ValueError(f"size: found {size[0]} x {size[1]}, expected multiples of {scale}")
        return self._strips(size, transparent, scale)

    def _strips(
        self, size: tuple[int, int], transparent: bool, scale: int
    ) -> Generator[np.ndarray]:
        """Draw the view strip by strip, and say what is wrong with the spheres, if that is it."""
        from .draw.picture import strips

        try:
            drawn = strips(self.plotter, size, transparent=transparent, scale=scale)
            with closing(drawn):
                for strip in drawn:
                    self._check_drawn()
                    yield strip
        except RuntimeError:
            self._check_drawn()  # which knows better what is wrong
            raise

    def _check_drawn(self) -> None:
        """Raise a RuntimeError if the last rendering lacks spheres."""
        from .draw.mapper import SpherePackingMapper

        for renderer in self.plotter.renderers:
            for actor in renderer.actors.values():
                mapper = getattr(actor, "mapper", None) if actor.GetVisibility() else None
                if isinstance(mapper, SpherePackingMapper) and mapper.GetErrorMessage():
                    raise RuntimeError(f"the spheres cannot be drawn: {mapper.GetErrorMessage()}")
        for picture in self._pictures:
            if picture.error is not None:
                raise RuntimeError(f"the spheres cannot be traced: {picture.error}")
