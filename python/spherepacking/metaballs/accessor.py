"""The part of the accessor ``packing`` that makes metaballs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pyvista as pv

from . import field as _field

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike
    from pyvista.plotting._typing import ColorLike


class MetaballsOfPacking:
    """Implicit fields of the spheres, and surfaces in them."""

    _packing: pv.PolyData

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
        progress: bool = False,
    ) -> pv.ImageData:
        """Sum what all spheres add at the points of a grid, within a bound on the error.

        The sums of the inverse kernels, which reach everywhere, go through a tree of spheres whose
        far parts are expanded (L. Greengard and V. Rokhlin, "A Fast Algorithm for Particle
        Simulations", 1987; W. Dehnen, "A Hierarchical O(N) Force Calculation Algorithm", 2002).
        What is smooth of the sums of many spheres goes through meshes, which is faster, if the
        error may be 1e-3 and neither gradient nor strongest is wanted (D. Hardy, J. Stone and K.
        Schulten, "Multilevel summation of electrostatic potentials using graphics processing
        units", 2009).

        Parameters
        ----------
        dimensions : int or sequence of int
            Points of the grid along x, y and z, or one number for all three.
        spacing : float or sequence of float, optional
            Instead of `dimensions`, the distance of the points, in the unit of the packing.
        kernel : {"inverse", "inverse_square", "gaussian", "wyvill"}, default: "inverse"
            What a sphere of weight w and radius r adds at the distance d from its centre:
            ``w r / d`` or ``w r**2 / d**2``, neither more than at d = r / 1024;
            ``w exp(2 - 2 d**2 / r**2)`` (J. Blinn, "A Generalization of Algebraic Surface
            Drawing", 1982); or ``2 w (1 - u)**2 (1 - 4 u / 9)`` with ``u = d**2 / (2 r)**2``, and
            0 from d = 2 r on (G. Wyvill, C. McPheeters and B. Wyvill, "Data Structure for Soft
            Objects", 1986). All are w at d = r.
        weights : array_like, optional
            k weights from 0 to 1e20 (k,), each for an equal share of the spheres from the largest
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
        scalars : str or array_like, optional
            What the spheres are coloured by, as in ``plotter.packing.add``: a point array (n,), by
            default the active one.
        rgb : bool, optional
            Take the scalars for colours; by default if their name ends with ``_rgb`` or ``_rgba``.
        cmap : str, list or pyvista.LookupTable, optional
            Colour map of the scalars.
        clim : sequence of float, optional
            Range of the scalars that the colour map spans.
        log_scale : bool, default: False
            Map scalars logarithmically.
        progress : bool, default: False
            Show a progress bar. Ctrl-C stops the work with or without.

        Returns
        -------
        pyvista.ImageData
            With the point arrays ``field`` (float32), ``gradient`` (float32, 3, the exact
            derivative of what ``field`` approximates, in the field's unit a unit of length; its
            error is small, but not bounded relative to itself), ``strongest`` (int64, the sphere
            that adds most, -1 where none adds anything) and ``blend`` (uint8, 3, the spheres'
            colours, weighted by what they add), and the field arrays ``build_seconds``,
            ``sum_seconds`` and ``meshes``, how many the sums went through, 0 if they did through
            the tree.

        Raises
        ------
        KeyError
            If there is no point array ``radius``, or none of the name `scalars`.
        TypeError
            If an argument is of a type that cannot be meant.
        ValueError
            If an argument is out of its range, the grid does not fit in memory, or a radius is
            none.
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
        algorithm = _field.field_filter(
            self._packing,
            dimensions=dimensions,
            spacing=spacing,
            bounds=bounds,
            threshold=threshold,
            kernel=kernel,
            weights=weights,
            count=count,
            relative_error=relative_error,
        )
        flag_of = _field.arguments.flag_of
        algorithm.SetComputeGradient(flag_of("gradient", gradient))
        algorithm.SetComputeStrongest(flag_of("strongest", strongest))
        flag_of("log_scale", log_scale)
        if flag_of("blend", blend):
            look = {
                "scalars": scalars,
                "rgb": rgb,
                "cmap": cmap,
                "clim": clim,
                "log_scale": log_scale,
                "color": None,
            }
            _field.color_by(algorithm, self._packing, look)
        return _field.run(algorithm, progress)

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
        kernel : {"inverse", "inverse_square", "gaussian", "wyvill"}, default: "inverse"
            What a sphere adds, see :meth:`metaball_field`.
        weights : array_like, optional
            k weights from 0 on (k,), each for an equal share of the spheres from the largest to the
            smallest.
        count : int, optional
            Use this many of the largest spheres.
        relative_error : float, default: 1e-3
            Bound on the relative error of the field, see :meth:`metaball_field`.
        bounds : sequence of float, optional
            Box of the grid, x min, x max, y min, …; what of the surface is outside is cut off. By
            default the surface closes inside.
        coloring : {"blend", "strongest"}, optional
            Colour by the mean of the spheres' colours, weighted by what they add, or by the sphere
            that adds most; None for no colours.
        scalars : str or array_like, optional
            What the spheres are coloured by, as in ``plotter.packing.add``: a point array (n,), by
            default the active one.
        rgb : bool, optional
            Take the scalars for colours; by default if their name ends with ``_rgb`` or ``_rgba``.
        cmap : str, list or pyvista.LookupTable, optional
            Colour map of the scalars.
        clim : sequence of float, optional
            Range of the scalars that the colour map spans.
        log_scale : bool, default: False
            Map scalars logarithmically.
        color : ColorLike, optional
            One colour for all spheres, which leaves the array ``color`` out.
        progress : bool, default: False
            Show a progress bar. Ctrl-C stops the work with or without.

        Returns
        -------
        pyvista.PolyData
            Triangles that face outwards, closed unless `bounds` cuts them, with the point arrays
            ``Normals`` (float32, 3, from the field's gradient), ``color`` (uint8, 3) if the spheres
            differ in colour, and with ``coloring="strongest"`` also ``sphere_id`` (int64). Empty,
            with a warning, if the field has the threshold nowhere.

        Raises
        ------
        KeyError
            If there is no point array ``radius``, or none of the name `scalars`.
        TypeError
            If an argument is of a type that cannot be meant.
        ValueError
            If an argument is out of its range, the grid does not fit in memory, or a radius is
            none.
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
        threshold = _field.threshold_of(threshold)
        coloring = _field.coloring_of(coloring)
        look = {
            "scalars": scalars,
            "rgb": rgb,
            "cmap": cmap,
            "clim": clim,
            "log_scale": log_scale,
            "color": color,
        }
        words = {
            "dimensions": 128 if dimensions is None and spacing is None else dimensions,
            "spacing": spacing,
            "bounds": bounds,
            "kernel": kernel,
            "weights": weights,
            "count": count,
            "relative_error": relative_error,
        }
        field, colors = _field.surface_field(
            self._packing, threshold, coloring, look, words, progress
        )
        return colored_surface(field, threshold, coloring, colors)


def colored_surface(
    field: pv.ImageData, threshold: float, coloring: str | None, colors: object
) -> pv.PolyData:
    """Make the surface of a field, and its array ``color``.

    Parameters
    ----------
    field : pyvista.ImageData
        Point arrays ``field`` and ``gradient``, and ``blend`` or ``strongest`` as `coloring` says.
    threshold : float
        Value of the surface.
    coloring : {"blend", "strongest"}, optional
        Where the colours come from.
    colors : numpy.ndarray, optional
        Colours (n, 3) of the spheres, uint8; None for none.

    Returns
    -------
    pyvista.PolyData
        As :meth:`MetaballsOfPacking.metaballs` returns it.
    """
    surface = _field.surface_at(field, threshold)
    data = surface.point_data
    if coloring == "strongest" and surface.n_points:
        ids = _field.ids_at(field, surface.points)
        data["sphere_id"] = ids
        if colors is not None:
            data["color"] = colors[ids]
    if "color" in data:
        data.active_scalars_name = "color"
    return surface
