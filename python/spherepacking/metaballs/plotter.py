"""The part of the plotter component ``packing`` that shows metaballs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pyvista as pv

from .. import checks
from ..datasets import packing_of
from ..look.look import Look
from .arguments import FieldOptions

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike
    from pyvista.plotting._typing import ColorLike

    from ..radii import RadiusLike
    from .actor import Metaballs


class MetaballsOfPlotter:
    """Adds surfaces of metaballs to the scene."""

    @property
    def plotter(self) -> pv.BasePlotter:
        """The plotter to add to."""
        raise NotImplementedError

    def add_metaballs(
        self,
        packing: pv.DataSet | pv.MultiBlock,
        threshold: float = 1.0,
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
        opacity: float = 1.0,
        specular: float = 0.3,
        specular_power: float = 20.0,
        name: str | None = None,
        pickable: bool = True,
        reset_camera: bool | None = None,
        render: bool = True,
    ) -> Metaballs:
        """Add the surface on which the field of the spheres has a value.

        Parameters
        ----------
        packing : pyvista.DataSet or pyvista.MultiBlock
            Centres (n, 3) and radii, as in ``plotter.packing.add``.
        threshold : float, default: 1.0
            The value, above 0.
        dimensions, spacing, kernel, weights, count, relative_error, bounds, coloring, scalars, \
        rgb, cmap, clim, log_scale, color
            As in ``packing.packing.metaballs``.
        radius : str, float, array_like or mapping, optional
            Radii, as in ``plotter.packing.add``.
        opacity : float, default: 1.0
            From 0 to 1.
        specular : float, default: 0.3
            Strength of highlights, from 0 to 1.
        specular_power : float, default: 20.0
            Sharpness of highlights, from 0 to 128.
        name : str, optional
            Name of the actor. An actor of that name is replaced.
        pickable : bool, default: True
            Whether it can be picked.
        reset_camera : bool, optional
            Let the camera see all, as in :meth:`pyvista.Plotter.add_actor`.
        render : bool, default: True
            Show it at once, if there is a window.

        Returns
        -------
        Metaballs
            Has the ``actor`` and the ``surface``, ``threshold``, ``weights`` and ``count``, which
            can be set, and the method ``update`` for changes of the packing.

        Raises
        ------
        KeyError, TypeError, ValueError
            If an argument is invalid; the plotter is left as it was.

        Examples
        --------
        >>> import pyvista as pv
        >>> import spherepacking
        >>> plotter = pv.Plotter(off_screen=True)
        >>> balls = plotter.packing.add_metaballs(
        ...     spherepacking.apollonian(3), kernel="wyvill", dimensions=48
        ... )
        >>> balls.threshold = 0.8
        >>> plotter.close()
        """
        from .actor import Metaballs, actor_of

        plotter = self.plotter
        opacity = checks.number_of("opacity", opacity, 0.0, 1.0)
        specular = checks.number_of("specular", specular, 0.0, 1.0)
        power = checks.number_of(
            "specular_power", specular_power, 0.0, checks.LARGEST_SPECULAR_POWER
        )
        plain = pv.Color(checks.color_of("color", color), default_color=pv.global_theme.color)
        if dimensions is None and spacing is None:
            dimensions = 128
        options = FieldOptions(dimensions, spacing, kernel, weights, count, relative_error, bounds)
        look = Look(scalars, rgb, cmap, clim, log_scale, color)
        balls = Metaballs(packing_of(packing, radius), threshold, coloring, look, options)
        colored = coloring is not None and color is None
        actor = balls.actor = actor_of(balls, plain, colored, opacity, specular, power)
        plotter.add_actor(
            actor,
            name=name,
            pickable=bool(pickable),
            reset_camera=reset_camera,
            render=False,
            remove_existing_actor=name is not None,
        )
        if render:
            plotter.render()
        return balls
