"""The plotter component ``packing``: exact spheres in a PyVista scene."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import TYPE_CHECKING

import pyvista as pv

from . import checks
from .datasets import packing_of, with_radii
from .granular.plotter import GranularOfPlotter
from .look.color_map import color_map_of, widened
from .look.look import Look
from .look.material import property_of
from .look.scalar_bar import scalar_bar_of
from .look.scalars import opacity_of, scalars_of
from .metaballs.plotter import MetaballsOfPlotter
from .pictures import PicturesOfPlotter

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from numpy.typing import ArrayLike
    from pyvista.plotting._typing import ColorLike
    from pyvista.plotting.themes import Theme

    from .draw.mapper import SpherePackingMapper
    from .look.color_map import ColorMap
    from .look.scalars import Opacity, Scalars
    from .radii import RadiusLike
    from .trace.live import LivePicture
    from .trace.path_trace import PathOptions


@pv.register_plotter_component("packing")
class PackingComponent(GranularOfPlotter, MetaballsOfPlotter, PicturesOfPlotter):
    """Adds sphere packings to a plotter; every plotter has one as ``plotter.packing``.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        The plotter to add to.

    Examples
    --------
    >>> import pyvista as pv
    >>> import spherepacking
    >>> plotter = pv.Plotter(off_screen=True)
    >>> actor = plotter.packing.add(spherepacking.apollonian(3), cmap="viridis")
    >>> plotter.close()
    """

    def __init__(self, plotter: pv.BasePlotter) -> None:
        self._plotter: pv.BasePlotter | None = plotter
        self._pictures: list[LivePicture] = []

    def __plotter_close__(self) -> None:
        while self._pictures:
            self._pictures.pop().close()
        self._plotter = None

    @property
    def plotter(self) -> pv.BasePlotter:
        """The plotter of this component, or a RuntimeError once it has been closed."""
        if self._plotter is None:
            raise RuntimeError("this plotter has been closed, make a new one")
        return self._plotter

    def add(
        self,
        packing: pv.DataSet | pv.MultiBlock,
        *,
        scalars: str | ArrayLike | None = None,
        cmap: str | list[ColorLike] | pv.LookupTable | None = None,
        clim: Sequence[float] | float | None = None,
        color: ColorLike | None = None,
        opacity: float | str | ArrayLike = 1.0,
        radius: RadiusLike | None = None,
        name: str | None = None,
        rgb: bool | None = None,
        component: int | None = None,
        n_colors: int = 256,
        categories: bool | int = False,
        flip_scalars: bool = False,
        log_scale: bool = False,
        annotations: dict[float, str] | None = None,
        nan_color: ColorLike | None = None,
        nan_opacity: float = 1.0,
        below_color: ColorLike | None = None,
        above_color: ColorLike | None = None,
        show_scalar_bar: bool | None = None,
        scalar_bar_args: dict[str, Any] | None = None,
        lighting: bool | None = None,
        ambient: float | None = None,
        diffuse: float | None = None,
        specular: float | None = None,
        specular_power: float | None = None,
        user_matrix: ArrayLike | None = None,
        show_cell: bool | ColorLike = False,
        pickable: bool = True,
        reset_camera: bool | None = None,
        render: bool = True,
    ) -> pv.Actor:
        """Add the spheres of a packing to the scene.

        Arguments shared with :meth:`pyvista.Plotter.add_mesh` mean the same and have the same
        defaults. The packing is not changed. Arrays given by name stay connected: change them, and
        the next rendering shows it. If any array is given by its values, the spheres are a copy
        that shares the arrays: changes inside them show, arrays that replace them do not.

        Parameters
        ----------
        packing : pyvista.DataSet or pyvista.MultiBlock
            Its points (n, 3) are the centres of the spheres; blocks are joined. It may be empty.
        scalars : str or array_like, optional
            Name of a point array, or an array (n,), (n, 3) or (n, 4), to colour by. If neither
            `scalars` nor `color` is given, the active point scalars are used; those of a packing
            that was read from a file are the radii.
        cmap : str, list or pyvista.LookupTable, optional
            Colour map of the scalars.
        clim : sequence of float, optional
            Range of the scalars that the colour map spans.
        color : ColorLike, optional
            One colour for all spheres.
        opacity : float, str or array_like, default: 1.0
            From 0 to 1: of all spheres, or one per sphere (n,) or the name of such a point array;
            or a transfer function along the colour map, as an array or by name. Spheres behind one
            another mix in the right order after :meth:`pyvista.Plotter.enable_depth_peeling`; with
            OSMesa that needs ``pyvista.global_theme.multi_samples = 1`` before the plotter is made,
            for meshes too (https://github.com/pyvista/pyvista/issues/4867).
        radius : str, float, array_like or mapping, optional
            Radii in the unit of the points: the name of a point array, an array (n,), one number
            for all spheres, or one per type, such as ``{"C": 1.7, "H": 1.1}``. By default the
            array ``radius``, or else one that is called radii, diameter, r, d or the like. Zero is
            legal and draws nothing.
        name : str, optional
            Name of the actor. An actor of that name is replaced.
        rgb : bool, optional
            Take the scalars as colours, (n, 3) or (n, 4), uint8 or floats from 0 to 1. True by
            default if the name of the scalars is ``rgb`` or ``rgba`` or ends with ``_rgb`` or
            ``_rgba``.
        component : int, optional
            Component of scalars with several; their magnitude by default.
        n_colors : int, default: 256
            Number of colours of the colour map.
        categories : bool or int, default: False
            Use as many colours as there are different scalars, or that many.
        flip_scalars : bool, default: False
            Reverse the colour map.
        log_scale : bool, default: False
            Map scalars logarithmically. They have to be positive, or `clim` has to be.
        annotations : dict[float, str], optional
            Texts beside values of the scalar bar.
        nan_color, below_color, above_color : ColorLike, optional
            Colours of NaN and of scalars outside `clim`.
        nan_opacity : float, default: 1.0
            Opacity of spheres whose scalar is NaN.
        show_scalar_bar : bool, optional
            Show a scalar bar; by default as the theme says, and not for `rgb`.
        scalar_bar_args : dict, optional
            Arguments of :meth:`pyvista.Plotter.add_scalar_bar`.
        lighting : bool, optional
            Shade the spheres.
        ambient, diffuse, specular, specular_power : float, optional
            Material, see :class:`pyvista.Property`.
        user_matrix : array_like, optional
            Transformation (4, 4) of the actor: rotation, mirroring, translation and a uniform
            scale, since spheres stay spheres.
        show_cell : bool or ColorLike, default: False
            Draw the edges of the packing's cell (field arrays ``cell_vectors``, ``cell_origin``),
            in the theme's colour of outlines or this one.
        pickable : bool, default: True
            Whether the actor can be picked.
        reset_camera : bool, optional
            Fit the view to the scene; by default unless the camera has been set.
        render : bool, default: True
            Render at once if the plotter is shown already.

        Returns
        -------
        pyvista.Actor
            The actor. Its ``mapper`` behaves like a :class:`pyvista.DataSetMapper`.

        Raises
        ------
        KeyError
            If `radius` or `scalars` names an array that is not there.
        TypeError
            If `packing` is not a PolyData, the radii are not real numbers, or another argument has
            the wrong type.
        ValueError
            If there is not one value per sphere, or a radius is negative or not finite, or another
            argument is out of its range.
        RuntimeError
            If the plotter has been closed.

        Each names the argument, and the plotter is left as it was.

        Examples
        --------
        Spheres coloured by height, with a radius of their own each.

        >>> import numpy as np
        >>> import pyvista as pv
        >>> rng = np.random.default_rng(0)
        >>> centers = pv.PolyData(rng.random((100, 3)))
        >>> plotter = pv.Plotter(off_screen=True)
        >>> actor = plotter.packing.add(
        ...     centers, radius=rng.uniform(0.01, 0.1, 100), scalars=centers.points[:, 2]
        ... )
        >>> plotter.close()
        """
        plotter = self.plotter
        _check_scene(plotter, name)
        shown, radius_name = with_radii(packing, radius)
        matrix = checks.similarity_of(user_matrix)
        prop = property_of(plotter.theme, lighting, ambient, diffuse, specular, specular_power)
        values = scalars_of(shown, scalars, rgb, active=color is None)
        plain = checks.color_of("color", color)
        cell = self._cell_to_show(shown, show_cell)
        color_map = color_map_of(
            values,
            plotter.theme,
            cmap=cmap,
            clim=clim,
            log_scale=log_scale,
            component=component,
            n_colors=n_colors,
            categories=categories,
            flip_scalars=flip_scalars,
            annotations=annotations,
            nan_color=nan_color,
            nan_opacity=nan_opacity,
            below_color=below_color,
            above_color=above_color,
        )
        opacities = opacity_of(shown, opacity, color_map.n_colors, values)
        if values.adds_array or opacities.each is not None:
            shown = shown.copy(deep=False)  # to which the mapper adds arrays
        bar = scalar_bar_of(plotter, values, n_colors, show_scalar_bar, scalar_bar_args)
        # Nothing has changed so far, and what comes does not fail.
        prop.color = plotter.renderer.next_color if plain is None or plain is True else plain
        prop.opacity = 1.0 if opacities.whole is None else opacities.whole
        mapper = _mapper(
            shown, plotter.theme, radius_name, values, opacities, prop.color, color_map, bar
        )
        actor = pv.Actor(mapper, prop)
        actor.user_matrix = matrix
        self._show_cell(cell, name, matrix, reset_camera)
        self._show(actor, shown, bar, name, pickable, reset_camera, render)
        return actor

    def _show(
        self,
        actor: pv.Actor,
        packing: pv.PolyData,
        bar: dict[str, Any] | None,
        name: str | None,
        pickable: bool,
        reset_camera: bool | None,
        render: bool,
    ) -> None:
        """Put the actor into the scene, and its scalar bar."""
        plotter = self.plotter
        plotter.mesh = packing
        plotter.mapper = actor.mapper
        plotter.add_actor(
            actor,
            name=name,
            pickable=bool(pickable),
            reset_camera=reset_camera,
            render=False,
            remove_existing_actor=name is not None,
        )
        if bar is not None:
            plotter.add_scalar_bar(mapper=actor.mapper, render=False, **bar)
        if render:
            plotter.render()

    def path_trace(
        self,
        packing: pv.DataSet | pv.MultiBlock,
        *,
        samples: int = 64,
        step: float = 0.1,
        scalars: str | ArrayLike | None = None,
        rgb: bool | None = None,
        cmap: str | list[ColorLike] | pv.LookupTable | None = None,
        clim: Sequence[float] | float | None = None,
        log_scale: bool = False,
        color: ColorLike | None = None,
        show_scalar_bar: bool | None = None,
        scalar_bar_args: dict[str, Any] | None = None,
        show_cell: bool | ColorLike = False,
        radius: RadiusLike | None = None,
        name: str | None = None,
        reset_camera: bool | None = None,
        **light: Any,
    ) -> LivePicture:
        """Add spheres that are seen in the light of a sky and a sun.

        While the camera moves, the spheres are drawn as :meth:`add` does. When it rests, their
        picture is traced and shown instead, better and better, among all that else is in the
        scene, which neither lights it nor casts shadows on it. Offscreen, every rendering shows the
        finished picture.

        Parameters
        ----------
        packing : pyvista.DataSet or pyvista.MultiBlock
            Centres (n, 3) and radii, as in :meth:`add`.
        samples : int, default: 64
            Samples per pixel of the finished picture.
        step : float, default: 0.1
            Seconds between two pictures while it becomes better, from 0.001 to 60.
        scalars, rgb, cmap, clim, log_scale, color, show_scalar_bar, scalar_bar_args, show_cell, \
        name, reset_camera
            As in :meth:`add`; without `scalars` and `color` the spheres are white.
        radius : str, float, array_like or mapping, optional
            Radii, as in :meth:`add`.
        **light : dict, optional
            `max_bounces`, `albedo`, `sky`, `sun`, `seed`, `exposure`, `filmic`, `denoise`,
            `structure` and others of ``packing.packing.path_trace``.

        Returns
        -------
        LivePicture
            Has ``actor``, ``samples``, ``shown`` and ``finished``, and the methods ``refine`` and
            ``close``.

        Raises
        ------
        TypeError, ValueError
            If an argument is invalid, or the plotter has another render pass; the plotter is left
            as it was.

        Examples
        --------
        >>> import pyvista as pv
        >>> import spherepacking
        >>> plotter = pv.Plotter(off_screen=True, window_size=(200, 150))
        >>> live = plotter.packing.path_trace(spherepacking.apollonian(3), samples=4)
        >>> plotter.show(auto_close=False)
        >>> live.finished
        True
        >>> plotter.close()
        """
        from .trace.live import LivePicture, check_no_pass, check_step
        from .trace.path_trace import PathTracer

        for picture in [p for p in self._pictures if p.abandoned]:
            picture.close()
            self._pictures.remove(picture)
        check_no_pass(self.plotter)
        options = _path_options(samples, light)
        step = check_step(step)
        if scalars is None and color is None:
            color = "white"
        look = Look(scalars, rgb, cmap, clim, log_scale, color)
        packing = packing_of(packing, radius)
        # Whatever is wrong is found with a single pixel, and the picture goes on with its tracer,
        # which has the acceleration structure.
        tracer = PathTracer()
        view = [(1.0, 1.0, 1.0), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]
        tracer.trace(packing, view, (1, 1), look, replace(options, samples=1))
        actor = self.add(
            packing,
            **look.kwargs(),
            show_scalar_bar=show_scalar_bar,
            scalar_bar_args=scalar_bar_args,
            show_cell=show_cell,
            name=name,
            reset_camera=reset_camera,
            render=False,
        )
        live = LivePicture(self.plotter, actor, packing, tracer, look, options, step)
        self._pictures.append(live)
        return live


def _check_scene(plotter: pv.BasePlotter, name: str | None) -> None:
    """Raise a ValueError if the plotter cannot show spheres or `name` is not one of an actor."""
    scale = plotter.renderer.scale
    if len(set(scale)) > 1:
        raise ValueError(f"the plotter's scale: found {scale}, expected the same for all axes")
    if name is not None and not (isinstance(name, str) and name):
        raise ValueError(f"name: found {name!r}, expected a text that is not empty, or None")


def _path_options(samples: int, light: dict[str, Any]) -> PathOptions:
    """Options of a live picture, or a TypeError that names what is not one."""
    from .trace.path_trace import PathOptions

    known = {field.name for field in fields(PathOptions)} - {
        "samples",
        "time_budget",
        "preview",
        "sky_visible",
        "progress",
    }
    if unknown := light.keys() - known:
        raise TypeError(
            f"{min(unknown)}: found one, expected only {', '.join(sorted(known))} and what "
            "plotter.packing.path_trace itself takes"
        )
    samples = checks.count_of("samples", samples)
    return PathOptions(samples=samples, sky_visible=False, **light)


def _mapper(
    packing: pv.PolyData,
    theme: Theme,
    radius: str,
    scalars: Scalars,
    opacity: Opacity,
    color: pv.Color,
    color_map: ColorMap,
    bar: dict[str, Any] | None,
) -> SpherePackingMapper:
    """Make the mapper, which draws the spheres in their colours."""
    from .draw.mapper import SpherePackingMapper

    mapper = SpherePackingMapper(packing, theme, radius)
    # The range of no scalars is not defined.
    colored = scalars.values is not None or opacity.each is not None
    mapper.scalar_visibility = colored and packing.n_points > 0
    if not mapper.scalar_visibility:
        return mapper
    if scalars.values is None:
        mapper.set_custom_opacity(opacity.each, color=color, n_colors=color_map.n_colors)
        return mapper
    if opacity.each is not None:
        color_map = replace(color_map, clim=widened(scalars.values, color_map))
    mapper.set_scalars(
        scalars.values,
        scalars.name,
        rgb=scalars.rgb,
        custom_opac=opacity.each is not None,
        opacity=opacity.transfer if opacity.each is None else opacity.each,
        scalar_bar_args=bar,
        **color_map.kwargs(),
    )
    return mapper
