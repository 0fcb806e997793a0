"""The accessor ``packing`` of every PolyData: its points as spheres."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv
from pyvista.core._typing_core import BoundsTuple

from . import _arguments as arguments

if TYPE_CHECKING:
    import os


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
    13
    """

    def __init__(self, packing: pv.PolyData) -> None:
        self._packing = packing

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
