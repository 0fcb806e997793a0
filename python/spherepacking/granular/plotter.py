"""The part of the plotter component ``packing`` that shows contacts and the cell."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .. import checks
from ..datasets import packing_of
from .cell import cell_of, outline_of
from .contacts import contacts_of

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from pyvista.plotting._typing import ColorLike

    from ..radii import RadiusLike


class GranularOfPlotter:
    """Adds contacts of spheres, and the cell of a simulation, to the scene."""

    @property
    def plotter(self) -> pv.BasePlotter:
        """The plotter to add to."""
        raise NotImplementedError

    def add_contacts(
        self,
        packing: pv.PolyData,
        gap: float = 0.0,
        periodic: bool | Sequence[bool] | None = None,
        *,
        tube_radius: float | None = None,
        radius: RadiusLike | None = None,
        **kwargs: Any,
    ) -> pv.Actor:
        """Add tubes between the centres of spheres that touch.

        Parameters
        ----------
        packing : pyvista.PolyData
            Centres (n, 3) and point array ``radius`` (n,), or another dataset, as in :meth:`add`.
        gap, periodic, radius
            As in ``packing.packing.contacts``; `radius` is that of the spheres.
        tube_radius : float, optional
            Radius of the tubes; by default a fifth of the spheres' median radius.
        **kwargs : dict, optional
            Arguments of :meth:`pyvista.Plotter.add_mesh`. The tubes have the arrays of
            ``packing.packing.contacts``, say ``scalars="overlap"``; by default they are coloured by
            ``gap``.

        Returns
        -------
        pyvista.Actor
            The actor of the tubes.

        Raises
        ------
        KeyError, TypeError, ValueError
            If an argument is invalid, and as ``packing.packing.contacts``.

        Examples
        --------
        >>> import pyvista as pv
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> plotter = pv.Plotter(off_screen=True)
        >>> actor = plotter.packing.add_contacts(packing, gap=1e-9, color="orange")
        >>> plotter.close()
        """
        plotter = self.plotter
        packing = packing_of(packing, radius)
        if tube_radius is not None:
            tube_radius = checks.above_zero("tube_radius", tube_radius)
        lines = contacts_of(packing, gap, periodic)
        if not lines.n_lines:
            # PyVista refuses an empty mesh, but a packing in which nothing touches is no mistake.
            nothing = pv.Actor(pv.DataSetMapper(pv.PolyData()))
            plotter.add_actor(nothing, name=kwargs.get("name"), render=False)
            return nothing
        if tube_radius is None:
            tube_radius = 0.2 * float(np.median(packing.point_data["radius"]))
        if tube_radius > 0.0:
            lines = lines.tube(radius=tube_radius, n_sides=16, capping=False)
        if "color" not in kwargs:
            kwargs.setdefault("scalars", "gap")
        return plotter.add_mesh(lines, **kwargs)

    def _cell_to_show(
        self, packing: pv.PolyData, show_cell: bool | ColorLike
    ) -> tuple[pv.PolyData, pv.Color] | None:
        """The edges of the packing's cell and their colour, or None if they are not wanted."""
        if show_cell is None or show_cell is False:
            return None
        if show_cell is True:
            color = pv.Color(self.plotter.theme.outline_color)
        else:
            color = checks.color_of("show_cell", show_cell)
        return outline_of(cell_of(packing)), color

    def _show_cell(
        self,
        outline: tuple[pv.PolyData, pv.Color] | None,
        name: str | None,
        matrix: np.ndarray,
        reset_camera: bool | None,
    ) -> None:
        """Draw the edges of a cell; `name` is that of the spheres, whose former cell goes."""
        plotter = self.plotter
        cell_name = None if name is None else f"{name} (cell)"
        if outline is None:
            if cell_name in plotter.renderer.actors:
                plotter.renderer.remove_actor(cell_name, render=False)
            return
        edges, color = outline
        plotter.add_mesh(
            edges,
            color=color,
            line_width=2,
            lighting=False,
            pickable=False,
            name=cell_name,
            reset_camera=reset_camera,
            render=False,
        ).user_matrix = matrix
