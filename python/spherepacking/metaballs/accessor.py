"""The part of the accessor ``packing`` that makes metaballs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pyvista as pv

from ..look.look import Look
from .arguments import FieldOptions
from .field import metaball_field
from .surface import metaballs

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike
    from pyvista.plotting._typing import ColorLike

    from ..radii import RadiusLike


class MetaballsOfPacking:
    """Implicit fields of the spheres, and surfaces in them."""

    if TYPE_CHECKING:

        def with_radius(self, radius: RadiusLike | None = None) -> pv.PolyData:
            """Return the spheres, see PackingAccessor."""

    def metaball_field(
        self,
        dimensions: Sequence[int] | int | None = None,
        *,
        spacing: Sequence[float] | float | None = None,
        kernel: str = "inverse",
        weights: ArrayLike | None = None,
        count: int | None = None,
        relative_error: float = 1e-3,
        bounds: Sequence[float] | None = None,
        threshold: float | None = None,
        gradient: bool = False,
        strongest: bool = False,
        blend: bool = False,
        scalars: str | ArrayLike | None = None,
        rgb: bool | None = None,
        cmap: str | list[ColorLike] | pv.LookupTable | None = None,
        clim: Sequence[float] | float | None = None,
        log_scale: bool = False,
        radius: RadiusLike | None = None,
        progress: bool = False,
    ) -> pv.ImageData:
        """Sum what all spheres add at the points of a grid, within a bound on the error.

        The sums of the inverse kernels, which reach everywhere, go through a tree of spheres whose
        far parts are expanded (L. Greengard and V. Rokhlin, "A Fast Algorithm for Particle
        Simulations", 1987; W. Dehnen, "A Hierarchical O(N) Force Calculation Algorithm", 2002).
        The smooth part of the sums of many spheres goes through a hierarchy of grids, which is
        faster, if the error may be 1e-3 and neither gradient nor strongest is wanted (D. Hardy, J.
        Stone and K. Schulten, "Multilevel summation of electrostatic potentials using graphics
        processing units", 2009).

        Parameters
        ----------
        dimensions : int or sequence of int
            Points of the grid along x, y and z, or one number for all three.
        spacing : float or sequence of float, optional
            Instead of `dimensions`, the distance of the points, in the unit of the packing.
        kernel : {"inverse", "inverse_square", "gaussian", "wyvill"}, default: "inverse"
            What a sphere of weight w and radius r adds at the distance d from its centre:

            - ``"inverse"``: ``w r / d``, not more than at d = r / 1024
            - ``"inverse_square"``: ``w r**2 / d**2``, not more than at d = r / 1024
            - ``"gaussian"``: ``w exp(2 - 2 d**2 / r**2)`` (J. Blinn, "A Generalization of
              Algebraic Surface Drawing", 1982)
            - ``"wyvill"``: ``2 w (1 - u)**2 (1 - 4 u / 9)`` with ``u = d**2 / (2 r)**2``, and 0
              from d = 2 r on (G. Wyvill, C. McPheeters and B. Wyvill, "Data Structure for Soft
              Objects", 1986)

            All are w at d = r.
        weights : array_like, optional
            k weights from 0 to 1e20 (k,), each for an equal part of the spheres from the largest
            to the smallest; 1 for all by default.
        count : int, optional
            Use this many of the largest spheres.
        relative_error : float, default: 1e-3
            Bound on the relative error of the field, from 2e-5 to 0.5, or 0 to sum sphere by
            sphere, with an error below 1e-5. To the last two kernels' bound 1e-6 times the
            largest weight is added.
        bounds : sequence of float, optional
            Box of the grid, x min, x max, y min, … By default a tenth of the packing's longest side
            more than its bounds, or as `threshold` says.
        threshold : float, optional
            Without `bounds`, make the grid so large that the surface on which the field has this
            value closes inside.
        gradient : bool, default: False
            Make the array ``gradient`` too.
        strongest : bool, default: False
            Make the array ``strongest`` too.
        blend : bool, default: False
            Make the array ``blend`` too, if the spheres differ in colour.
        scalars, rgb, cmap, clim, log_scale
            What the spheres are coloured by, as in :meth:`ray_cast`.
        radius : str, float, array_like or mapping, optional
            As in :meth:`PackingAccessor.with_radius`.
        progress : bool, default: False
            Show a progress bar. Ctrl-C stops the work with or without.

        Returns
        -------
        pyvista.ImageData
            The grid. Point arrays:

            - ``field`` (float32)
            - ``gradient`` (n, 3), float32: the exact derivative of what ``field`` approximates, per
              unit of length; its error is small, but not bounded relative to itself
            - ``strongest`` (int64): the sphere that adds most, -1 where none adds anything
            - ``blend`` (n, 3), uint8: mean of the spheres' colours, weighted by what they add

            Field arrays:

            - ``build_seconds``, ``sum_seconds``: of the tree, and of the sums
            - ``meshes``: number of grids in the hierarchy that the smooth part went through, 0 if
              all sums went through the tree

        Raises
        ------
        KeyError
            If there is no such point array of radii, or none of the name `scalars`.
        TypeError
            If an argument has the wrong type.
        ValueError
            If an argument is out of its range, the grid does not fit in memory, or a radius is
            negative or not finite.
        KeyboardInterrupt
            If Ctrl-C was pressed.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> field = packing.packing.metaball_field(32, kernel="wyvill")
        >>> field["field"].shape
        (32768,)
        """
        options = FieldOptions(dimensions, spacing, kernel, weights, count, relative_error, bounds)
        return metaball_field(
            self.with_radius(radius),
            options,
            threshold,
            gradient=gradient,
            strongest=strongest,
            blend=blend,
            look=Look(scalars, rgb, cmap, clim, log_scale),
            progress=progress,
        )

    def metaballs(
        self,
        threshold: float,
        *,
        dimensions: Sequence[int] | int | None = None,
        spacing: Sequence[float] | float | None = None,
        kernel: str = "inverse",
        weights: ArrayLike | None = None,
        count: int | None = None,
        relative_error: float = 1e-3,
        bounds: Sequence[float] | None = None,
        coloring: str | None = "blend",
        scalars: str | ArrayLike | None = None,
        rgb: bool | None = None,
        cmap: str | list[ColorLike] | pv.LookupTable | None = None,
        clim: Sequence[float] | float | None = None,
        log_scale: bool = False,
        color: ColorLike | None = None,
        radius: RadiusLike | None = None,
        progress: bool = False,
    ) -> pv.PolyData:
        """Make the surface on which the field of the spheres has a value.

        The triangles are those of flying edges (W. Schroeder, R. Maynard and B. Geveci, "Flying
        Edges: A High-Performance Scalable Isocontouring Algorithm", 2015), which lie off the true
        surface by an amount that falls with the square of the grid's spacing.

        Parameters
        ----------
        threshold : float
            The value, above 0. At 1, a single sphere of weight 1 is its own surface.
        dimensions : int or sequence of int, default: 128
            Points of the grid along x, y and z, or one number for all three.
        spacing : float or sequence of float, optional
            Instead of `dimensions`, the distance of the points, in the unit of the packing.
        kernel, weights, count, relative_error
            The field, as in :meth:`metaball_field`.
        bounds : sequence of float, optional
            Box of the grid, x min, x max, y min, …; what of the surface is outside is cut off. By
            default the surface closes inside.
        coloring : {"blend", "strongest"}, optional
            Colour by the mean of the spheres' colours, weighted by what they add, or by the sphere
            that adds most; None for no colours.
        scalars, rgb, cmap, clim, log_scale
            What the spheres are coloured by, as in :meth:`ray_cast`.
        color : ColorLike, optional
            One colour for all spheres, which leaves the array ``color`` out.
        radius : str, float, array_like or mapping, optional
            As in :meth:`PackingAccessor.with_radius`.
        progress : bool, default: False
            Show a progress bar. Ctrl-C stops the work with or without.

        Returns
        -------
        pyvista.PolyData
            Triangles that face outwards, closed unless `bounds` cuts them; empty, with a warning,
            if the field has the threshold nowhere. Point arrays:

            - ``Normals`` (n, 3), float32: from the field's gradient
            - ``color`` (n, 3), uint8: if the spheres differ in colour
            - ``sphere_id`` (int64): with ``coloring="strongest"``

        Raises
        ------
        KeyError
            If there is no such point array of radii, or none of the name `scalars`.
        TypeError
            If an argument has the wrong type.
        ValueError
            If an argument is out of its range, the grid does not fit in memory, or a radius is
            negative or not finite.
        KeyboardInterrupt
            If Ctrl-C was pressed.

        Warns
        -----
        UserWarning
            If the surface is empty.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> surface = packing.packing.metaballs(1.0, kernel="wyvill", dimensions=48)
        >>> surface.is_manifold
        True
        """
        if dimensions is None and spacing is None:
            dimensions = 128
        options = FieldOptions(dimensions, spacing, kernel, weights, count, relative_error, bounds)
        look = Look(scalars, rgb, cmap, clim, log_scale, color)
        return metaballs(self.with_radius(radius), options, threshold, coloring, look, progress)
