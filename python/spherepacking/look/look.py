"""What spheres are coloured by, the same for everything that draws them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import pyvista as pv

from ..checks import color_of, flag_of
from ..packing import content_hash
from .color_map import color_map_of
from .scalars import scalars_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike
    from pyvista.plotting._typing import ColorLike

    from ..backend import vtkAbstractArray, vtkDataArray
    from .color_map import ColorMap
    from .scalars import Scalars

_SAMPLES = 64
"""About how many scalars are looked at, each time, for changes that VTK was not notified of."""


@dataclass(frozen=True, eq=False)
class Look:
    """What spheres are coloured by, as it was asked for.

    Attributes
    ----------
    scalars : str or array_like, optional
        Name of a point array, or an array (n,), (n, 3) or (n, 4). If this is None and there is no
        other colour, the active point scalars are used.
    rgb : bool, optional
        Take the scalars as colours; by default if their name is ``rgb`` or ``rgba`` or ends with
        ``_rgb`` or ``_rgba``.
    cmap : str, list or pyvista.LookupTable, optional
        Colour map of the scalars.
    clim : sequence of float, optional
        Range of the scalars that the colour map spans.
    log_scale : bool, default: False
        Map scalars logarithmically.
    color : ColorLike, optional
        One colour for all spheres.
    random_colors : bool, default: False
        One random colour per sphere, whatever `scalars` and `color` are.
    """

    scalars: str | ArrayLike | None = None
    rgb: bool | None = None
    cmap: str | list[ColorLike] | pv.LookupTable | None = None
    clim: Sequence[float] | float | None = None
    log_scale: bool = False
    color: ColorLike | None = None
    random_colors: bool = False

    def kwargs(self) -> dict[str, Any]:
        """The attributes as keyword arguments of ``plotter.packing.add``."""
        return {name: value for name, value in vars(self).items() if name != "random_colors"}

    def sphere_colors(
        self, packing: pv.PolyData, *, white_by_default: bool = False
    ) -> vtkDataArray | None:
        """Check the look, and colour spheres as the mapper draws them.

        Parameters
        ----------
        packing : pyvista.PolyData
            Centres (n, 3).
        white_by_default : bool, default: False
            Do not use the active scalars.

        Returns
        -------
        vtkDataArray or None
            RGBA of each sphere (n, 4), uint8, named apart; None if no scalars colour them.
        """
        log_scale = flag_of("log_scale", self.log_scale)
        random_colors = flag_of("random_colors", self.random_colors)
        active = self.color is None and not random_colors and not white_by_default
        scalars = scalars_of(packing, self.scalars, self.rgb, active=active)
        theme = pv.global_theme
        color_map = color_map_of(
            scalars, theme, cmap=self.cmap, clim=self.clim, log_scale=log_scale
        )
        color_of("color", self.color)
        if scalars.values is None or not packing.n_points:
            return None
        return _mapped(packing, scalars, color_map)

    def key(
        self, packing: pv.PolyData, *, hash_contents: bool = False
    ) -> tuple[object, ...] | None:
        """What the colours depend on, compared by ``==``.

        Parameters
        ----------
        packing : pyvista.PolyData
            The spheres.
        hash_contents : bool, default: False
            Whether to look for changes of the scalars that VTK was not notified of.

        Returns
        -------
        tuple or None
            None if that is unknown without looking at all values.
        """
        arrays = packing.GetPointData()
        if self.scalars is None:
            array = arrays.GetScalars()
        elif isinstance(self.scalars, str):
            array = arrays.GetAbstractArray(self.scalars)
        else:
            return None
        # A table is known by when it was changed.
        table = self.cmap.GetMTime() if isinstance(self.cmap, pv.LookupTable) else None
        theme = pv.global_theme
        # The time of all arrays: some changes are known to the point data alone.
        return (
            None if array is None else arrays.GetMTime(),
            None if array is None else _contents_of(array, hash_contents),
            table,
            repr(vars(self) | ({} if table is None else {"cmap": None})),
            repr((theme.cmap, theme.color, theme.nan_color)),
        )


def _contents_of(array: vtkAbstractArray, hash_contents: bool) -> int | bytes:
    """A hash of an array, or a few values that show whether all have been written to."""
    if hash_contents:
        return content_hash(pv.convert_array(array))
    if not array.IsA("vtkDataArray"):
        return b""  # texts would have to be copied
    values = np.asarray(pv.convert_array(array))
    return values[:: max(1, len(values) // _SAMPLES)].tobytes() if len(values) else b""


def _mapped(packing: pv.PolyData, scalars: Scalars, color_map: ColorMap) -> vtkDataArray:
    """RGBA of each sphere, as the mapper would draw it."""
    from ..draw.mapper import SpherePackingMapper

    mapper = SpherePackingMapper(packing.copy(deep=False), pv.global_theme, "radius")
    mapper.set_scalars(scalars.values, scalars.name, rgb=scalars.rgb, **color_map.kwargs())
    # PyVista puts a producer before the mapper, which makes the scalars the active ones.
    mapper.GetInputAlgorithm().Update()
    colors = mapper.MapScalars(1.0)
    colors.SetName("spherepacking colors")
    return colors
