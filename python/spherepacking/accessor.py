"""The accessor ``packing`` of every PolyData: its points as spheres."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv
from pyvista.core._typing_core import BoundsTuple

from . import _arguments as arguments
from ._raycast import Caster, Pick

if TYPE_CHECKING:
    import os
    from collections.abc import Sequence

    from numpy.typing import ArrayLike
    from pyvista.plotting._typing import ColorLike


@pv.register_dataset_accessor("packing", pv.PolyData)
class PackingAccessor:
    """Points as centres of spheres, the point array ``radius`` as their radii.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3).

    Examples
    --------
    >>> import spherepacking
    >>> packing = spherepacking.apollonian(1)
    >>> packing.packing.n_spheres
    9
    """

    def __init__(self, packing: pv.PolyData) -> None:
        self._packing = packing
        self._caster = Caster()

    @property
    def n_spheres(self) -> int:
        """Number of spheres."""
        return self._packing.n_points

    @property
    def centers(self) -> np.ndarray:
        """Centres (n, 3), a view of the points."""
        return self._packing.points

    @property
    def radii(self) -> np.ndarray:
        """Radii (n,) in the unit of the points, a view of the array ``radius``.

        Raises
        ------
        KeyError
            If there is no point array ``radius``.
        TypeError, ValueError
            If its values are no radii.
        """
        if not self.n_spheres:
            return np.empty(0)
        arguments.radii_of(self._packing, "radius")
        return self._packing.point_data["radius"]

    @property
    def bounds(self) -> BoundsTuple:
        """Box around all spheres, x min, x max, y min, …; unlike ``PolyData.bounds`` with radii.

        Without spheres it is that of an empty PolyData.
        """
        if not self.n_spheres:
            return self._packing.bounds
        from ._backend import vtkSpherePackingInput

        arguments.radii_of(self._packing, "radius")
        box = [0.0] * 6
        array = self._packing.GetPointData().GetArray("radius")
        vtkSpherePackingInput.ComputeBounds(self._packing, array, box)
        return BoundsTuple(*box)

    @property
    def volume(self) -> float:
        """Sum of the volumes of the spheres, overlaps counted as often as they occur.

        Infinite if it is more than a float holds.
        """
        with np.errstate(over="ignore"):
            return float(4.0 / 3.0 * np.pi * np.sum(np.asarray(self.radii, dtype=float) ** 3))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the packing, see :func:`spherepacking.write`."""
        from .writers import write

        write(self._packing, path)

    def bvh_boxes(
        self,
        boxes: int | None = None,
        depth: int | None = None,
        leaves_only: bool = True,
        *,
        as_lines: bool = False,
    ) -> pv.PolyData:
        """Boxes of a bounding volume hierarchy, each the bounds of its spheres in double precision.

        The spheres are split in two over and over, by the surface-area heuristic over all axes (I.
        Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007), so that every
        sphere lies in exactly one leaf.

        Parameters
        ----------
        boxes : int, default: 15
            How many leaves there are, 1 or more, unless there are fewer spheres. What lowers the
            cost most is split first.
        depth : int, optional
            Instead of `boxes`, the depth down to which every node of more than one sphere is
            split, 0 for one box around all spheres.
        leaves_only : bool, default: True
            The boxes of the leaves, instead of those of all nodes.
        as_lines : bool, default: False
            Twelve lines a box instead of six quads.

        Returns
        -------
        pyvista.PolyData
            Six quads (or twelve lines) a box, with the cell arrays ``box_id`` (the node, numbered
            depth first from 0 for the root), ``depth`` (0 for the root) and ``count`` (spheres in
            the box). Field arrays: ``build_seconds``, ``memory_bytes``, ``occupied_share`` (volumes
            of the leaves over that of the root), ``leaf_of_sphere`` (n,), the ``box_id`` of the
            leaf of every sphere, and ``sah_cost``, the expected number of nodes and spheres that a
            random ray through the root is tested against (J. Goldsmith and J. Salmon, 1987; J. D.
            MacDonald and K. S. Booth, 1990). Empty for an empty packing.

        Raises
        ------
        KeyError
            If there is no point array ``radius``.
        TypeError
            If `boxes` or `depth` is no integer, or the radii are no real numbers.
        ValueError
            If `boxes` is not positive or `depth` negative, if both are given or make more boxes
            than fit in memory, or if a radius is none.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(2)
        >>> packing.packing.bvh_boxes(7).n_cells // 6
        7
        """
        from ._backend import vtkSpherePackingBVH

        if boxes is not None and depth is not None:
            raise ValueError(f"depth: found {depth!r} beside boxes={boxes!r}, expected one of them")
        bvh = vtkSpherePackingBVH()
        if depth is not None:
            bvh.SetDepth(arguments.count_of("depth", depth, least=0))
        elif boxes is not None:
            bvh.SetNumberOfBoxes(arguments.count_of("boxes", boxes))
        bvh.SetLeavesOnly(arguments.flag_of("leaves_only", leaves_only))
        return self._boxes_of(bvh, as_lines)

    def grid_boxes(self, cuts: int = 6, *, as_lines: bool = False) -> pv.PolyData:
        """Boxes of the cells of a uniform grid that spheres touch.

        The bounds of the packing are cut `cuts` times along each axis. A cell is touched when the
        centre of a sphere is no farther from it than the radius (J. Arvo, "A Simple Method for
        Box-Sphere Intersection Testing", Graphics Gems, 1990).

        Parameters
        ----------
        cuts : int, default: 6
            How often each axis is cut, 0 or more; there are ``(cuts + 1) ** 3`` cells.
        as_lines : bool, default: False
            Twelve lines a box instead of six quads.

        Returns
        -------
        pyvista.PolyData
            Six quads (or twelve lines) a box, with the cell arrays ``box_id`` (the cell, x
            fastest), ``depth`` (0) and ``count`` (spheres that touch the cell), and the field
            arrays ``build_seconds``, ``memory_bytes`` and ``occupied_share``. Empty for an empty
            packing.

        Raises
        ------
        KeyError
            If there is no point array ``radius``.
        TypeError
            If `cuts` is no integer, or the radii are no real numbers.
        ValueError
            If `cuts` is negative or makes more cells than fit in memory, or a radius is none.

        Examples
        --------
        >>> import spherepacking
        >>> boxes = spherepacking.apollonian(2).packing.grid_boxes(1)
        >>> boxes.n_cells // 6
        8
        """
        from ._backend import vtkSpherePackingGrid

        grid = vtkSpherePackingGrid()
        grid.SetCuts(arguments.count_of("cuts", cuts, least=0))
        return self._boxes_of(grid, as_lines)

    def _boxes_of(self, algorithm: object, as_lines: bool) -> pv.PolyData:
        """Output of a filter from packings to boxes, or a ValueError with its sentence."""
        from ._errors import ErrorLog

        if self.n_spheres:
            arguments.radii_of(self._packing, "radius")
        log = ErrorLog(algorithm)
        algorithm.SetInputData(self._packing)
        algorithm.SetBoxesAsLines(arguments.flag_of("as_lines", as_lines))
        algorithm.Update()
        if log.messages:
            raise ValueError(algorithm.GetErrorMessage() or "\n".join(log.messages))
        return pv.wrap(algorithm.GetOutput())

    def ray_cast(
        self,
        camera: pv.Camera | Sequence[Sequence[float]],
        window_size: Sequence[int],
        *,
        structure: str = "bvh",
        cuts: int | None = None,
        samples: int = 1,
        tile: Sequence[int] | int | None = None,
        scalars: str | ArrayLike | None = None,
        rgb: bool | None = None,
        cmap: str | list[ColorLike] | pv.LookupTable | None = None,
        clim: Sequence[float] | float | None = None,
        log_scale: bool = False,
        color: ColorLike | None = None,
        random_colors: bool = False,
        progress: bool = False,
    ) -> pv.ImageData:
        """Make a picture by casting rays, without a window.

        Every pixel holds the exact intersection of its ray, computed in double precision (Haines,
        Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray
        Tracing Gems, 2019). The structure decides about speed alone, not about a single bit, unless
        the camera is more than 1e9 times as far away as the packing is large. It is kept, so that
        further pictures of the same packing take less time, until points or radii are assigned, or
        written to through ``packing.points`` and ``packing["radius"]``. Of changes through other
        views of their memory, VTK and with it the structure know nothing.

        Parameters
        ----------
        camera : pyvista.Camera or sequence
            A camera, or its position, focal point and view-up (3, 3). Its clipping planes do not
            count.
        window_size : sequence of int
            Width and height of the picture in pixels.
        structure : {"bvh", "grid", "none"}, default: "bvh"
            How rays find spheres: through a bounding volume hierarchy, a uniform grid, or by
            testing all.
        cuts : int, optional
            How often the grid cuts each axis; by default it has twice as many cells as spheres.
        samples : int, default: 1
            n for n x n rays a pixel, from 1 to 16, whose colours are averaged.
        tile : int or sequence of int, default: 64
            Width and height in pixels of the tiles in which the picture is made.
        scalars : str or array_like, optional
            What to colour by, as in ``plotter.packing.add``: a point array (n,), by default the
            active one.
        rgb : bool, optional
            Take the scalars for colours; by default if their name ends with ``_rgb`` or ``_rgba``.
        cmap : str, list or pyvista.LookupTable, optional
            Colour map of the scalars.
        clim : sequence of float, optional
            Range of the scalars that the colour map spans.
        log_scale : bool, default: False
            Map scalars logarithmically.
        color : ColorLike, optional
            One colour for all spheres.
        random_colors : bool, default: False
            One random colour a sphere.
        progress : bool, default: False
            Show a progress bar. Ctrl-C stops the work with or without.

        Returns
        -------
        pyvista.ImageData
            One point a pixel, from the lower left corner, with the point arrays ``color`` (RGBA,
            uint8, alpha 0 where nothing is hit), ``depth`` (float32, along the direction of view
            in the unit of the packing, infinite where nothing is hit), ``normal`` (float32, 3, out
            of the sphere) and ``sphere_id`` (int64, -1 where nothing is hit). Field arrays:
            ``tile_extents``, ``compute_seconds`` and ``partial_seconds`` of each tile,
            ``complete_seconds``, ``build_seconds`` and ``memory_bytes`` of the structure.

        Raises
        ------
        KeyError
            If there is no point array ``radius``, or none of the name `scalars`.
        TypeError
            If an argument is of a type that cannot be meant.
        ValueError
            If an argument is out of its range, the camera sees nothing, or a radius is none.
        KeyboardInterrupt
            If Ctrl-C was pressed; no tile is begun after that.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> view = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]
        >>> image = packing.packing.ray_cast(view, (200, 100), samples=2)
        >>> image["color"].shape
        (20000, 4)
        """
        look = {
            "scalars": scalars,
            "rgb": rgb,
            "cmap": cmap,
            "clim": clim,
            "log_scale": log_scale,
            "color": color,
            "random_colors": random_colors,
        }
        with self._caster.lock:
            self._caster.prepare(self._packing, camera, window_size, structure, cuts)
            return self._caster.cast(self._packing, samples, tile, look, progress)

    def pick(
        self,
        camera: pv.Camera | Sequence[Sequence[float]],
        window_size: Sequence[int],
        x: float,
        y: float,
    ) -> Pick | None:
        """Find the sphere that is seen at a point of the picture.

        Parameters
        ----------
        camera : pyvista.Camera or sequence
            A camera, or its position, focal point and view-up (3, 3).
        window_size : sequence of int
            Width and height of the picture in pixels.
        x, y : float
            Where, in pixels from the lower left corner; (0.5, 0.5) is the middle of the first one.

        Returns
        -------
        Pick or None
            ``sphere_id``, ``point`` (3,) and ``normal`` (3,); None where nothing is seen.

        Raises
        ------
        KeyError
            If there is no point array ``radius``.
        TypeError, ValueError
            If an argument is none, or the point lies outside the picture.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> view = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]
        >>> found = packing.packing.pick(view, (200, 200), 100, 100)
        >>> found.normal.shape
        (3,)
        """
        with self._caster.lock:
            self._caster.prepare(self._packing, camera, window_size)
            return self._caster.pick(self._packing, x, y)

    def plot(self, **kwargs: object) -> object:
        """Show the packing in a window, or offscreen in a picture.

        Parameters
        ----------
        **kwargs : dict, optional
            Arguments of :class:`pyvista.Plotter`, of its ``show`` and of ``plotter.packing.add``,
            told apart by their names; `background` sets the colour behind the spheres.

        Returns
        -------
        object
            What :meth:`pyvista.Plotter.show` returns.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> packing.packing.plot(cmap="magma", screenshot="packing.png")  # doctest: +SKIP
        """
        from ._offscreen import choose_window
        from .plotter import PackingComponent

        choose_window()
        background = kwargs.pop("background", None)
        # `lighting` and others are known to two of them: the spheres come first, as in plot() of
        # PyVista's meshes.
        look = _take(kwargs, PackingComponent.add)
        plotter = pv.Plotter(**_take(kwargs, pv.Plotter.__init__))
        try:
            if background is not None:
                plotter.set_background(background)
            plotter.packing.add(self._packing, **look)
            return plotter.show(**kwargs)
        except BaseException:
            plotter.close()
            raise


def _take(kwargs: dict[str, object], function: object) -> dict[str, object]:
    """Move those of `kwargs` that `function` takes into a dict of their own."""
    names = inspect.signature(function).parameters.keys() & kwargs.keys()
    return {name: kwargs.pop(name) for name in names}
