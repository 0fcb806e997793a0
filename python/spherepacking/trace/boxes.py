"""The part of the accessor ``packing`` that makes boxes to look at acceleration structures by."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pyvista as pv

from .. import checks
from ..packing import check_radii
from ..vtk_tools import errors_raised

if TYPE_CHECKING:
    from ..backend import vtkSpherePackingBoxAlgorithm
    from ..radii import RadiusLike


class BoxesOfPacking:
    """Boxes that show how a hierarchy or a grid divides the spheres."""

    if TYPE_CHECKING:

        def with_radius(self, radius: RadiusLike | None = None) -> pv.PolyData:
            """Return the spheres, see PackingAccessor."""

    def bvh_boxes(
        self,
        boxes: int | None = None,
        depth: int | None = None,
        leaves_only: bool = True,
        *,
        as_lines: bool = False,
        radius: RadiusLike | None = None,
    ) -> pv.PolyData:
        """Boxes of a binary bounding volume hierarchy, each the bounds of its spheres.

        The spheres are split in two over and over, by the surface-area heuristic over all axes (I.
        Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007), so that every
        sphere lies in exactly one leaf. Boxes are in double precision.

        It is not the hierarchy of ``ray_cast`` and ``path_trace``, which is made by the same splits
        but has eight children per node, up to eight spheres per leaf, and boxes in single precision
        that are enlarged by what rounding needs: such boxes are no bounds, and cannot be had in any
        wanted number.

        Parameters
        ----------
        boxes : int, default: 15
            How many leaves there are, 1 or more, unless there are fewer spheres. The node whose
            split lowers the cost most is split first.
        depth : int, optional
            Instead of `boxes`, the depth down to which every node of more than one sphere is
            split, 0 for one box around all spheres.
        leaves_only : bool, default: True
            Return the boxes of the leaves, instead of those of all nodes.
        as_lines : bool, default: False
            Make twelve lines per box instead of six quads.
        radius : str, float, array_like or mapping, optional
            As in :meth:`PackingAccessor.with_radius`.

        Returns
        -------
        pyvista.PolyData
            Six quads (or twelve lines) per box; empty for an empty packing. Cell arrays:

            - ``box_id``: the node, numbered depth first from 0 for the root
            - ``depth``: 0 for the root
            - ``count``: number of spheres in the box

            Field arrays:

            - ``build_seconds``, ``memory_bytes``: of this hierarchy; pictures have their own
            - ``occupied_share``: volume of the leaves over that of the root
            - ``leaf_of_sphere`` (n,): the ``box_id`` of the leaf of each sphere
            - ``sah_cost``: expected number of nodes and spheres that a random ray through the root
              is tested against (J. Goldsmith and J. Salmon, "Automatic Creation of Object
              Hierarchies for Ray Tracing", 1987; J. D. MacDonald and K. S. Booth, "Heuristics for
              Ray Tracing Using Space Subdivision", 1990)

        Raises
        ------
        KeyError
            If there is no such point array of radii.
        TypeError
            If `boxes` or `depth` is not an integer, or the radii are not real numbers.
        ValueError
            If `boxes` is not positive or `depth` is negative, if both are given or make more boxes
            than fit in memory, or if a radius is negative or not finite.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(2)
        >>> packing.packing.bvh_boxes(7).n_cells // 6
        7
        """
        from ..backend import vtkSpherePackingBVH

        if boxes is not None and depth is not None:
            raise ValueError(
                f"depth: found {checks.shown(depth)} beside boxes={checks.shown(boxes)}, "
                "expected one of them"
            )
        bvh = vtkSpherePackingBVH()
        if depth is not None:
            bvh.SetDepth(checks.count_of("depth", depth, least=0))
        elif boxes is not None:
            bvh.SetNumberOfBoxes(checks.count_of("boxes", boxes))
        bvh.SetLeavesOnly(checks.flag_of("leaves_only", leaves_only))
        return _boxes_of(bvh, self.with_radius(radius), as_lines)

    def grid_boxes(
        self, cuts: int = 6, *, as_lines: bool = False, radius: RadiusLike | None = None
    ) -> pv.PolyData:
        """Boxes of the cells of a uniform grid that spheres touch.

        The bounds of the packing are cut `cuts` times along each axis. A cell is touched when the
        centre of a sphere is no farther from it than the radius (J. Arvo, "A Simple Method for
        Box-Sphere Intersection Testing", Graphics Gems, 1990).

        Parameters
        ----------
        cuts : int, default: 6
            How often each axis is cut, 0 or more; there are ``(cuts + 1) ** 3`` cells.
        as_lines : bool, default: False
            Make twelve lines per box instead of six quads.
        radius : str, float, array_like or mapping, optional
            As in :meth:`PackingAccessor.with_radius`.

        Returns
        -------
        pyvista.PolyData
            Six quads (or twelve lines) per box; empty for an empty packing. Cell arrays:

            - ``box_id``: the cell, x fastest
            - ``depth``: 0
            - ``count``: number of spheres that touch the cell

            Field arrays:

            - ``build_seconds``: of counting
            - ``memory_bytes``: what a table of the spheres of each cell would take; pictures that
              are ray-cast through a grid tell what theirs took
            - ``occupied_share``: fraction of the cells that spheres touch

        Raises
        ------
        KeyError
            If there is no such point array of radii.
        TypeError
            If `cuts` is not an integer, or the radii are not real numbers.
        ValueError
            If `cuts` is negative or makes more cells than fit in memory, or a radius is negative or
            not finite.

        Examples
        --------
        >>> import spherepacking
        >>> boxes = spherepacking.apollonian(2).packing.grid_boxes(1)
        >>> boxes.n_cells // 6
        8
        """
        from ..backend import vtkSpherePackingGrid

        grid = vtkSpherePackingGrid()
        grid.SetCuts(checks.count_of("cuts", cuts, least=0))
        return _boxes_of(grid, self.with_radius(radius), as_lines)


def _boxes_of(
    algorithm: vtkSpherePackingBoxAlgorithm, packing: pv.PolyData, as_lines: bool
) -> pv.PolyData:
    """Output of a filter from packings to boxes, or an exception."""
    if packing.n_points:
        check_radii(packing)
    algorithm.SetInputData(packing)
    algorithm.SetBoxesAsLines(checks.flag_of("as_lines", as_lines))
    with errors_raised(algorithm):
        algorithm.Update()
    return pv.wrap(algorithm.GetOutput())
