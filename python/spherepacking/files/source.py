"""What all files of packings have in common, whichever program reads them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal, Protocol

import numpy as np

from ..datasets import with_radius_array
from ..packing import check_radii
from .errors import PackingFileError

if TYPE_CHECKING:
    from pathlib import Path

    import pyvista as pv

    from ..radii import RadiusLike


@dataclass(frozen=True)
class Request:
    """How to read.

    Parameters
    ----------
    radius : str, float, array_like or mapping, optional
        Radii; by default those of the file.
    columns : str, optional
        Names of the columns of a table in text.
    precision : {"double", "single"}, default: "double"
        Precision of the centres.
    progress : bool, default: False
        Show a progress bar.
    """

    radius: RadiusLike | None = None
    columns: str | None = None
    precision: Literal["double", "single"] = "double"
    progress: bool = False


class PackingSource(Protocol):
    """A file, or several, with one packing per step."""

    @property
    def times(self) -> list[float]:
        """Times of the steps, NaN where a step has none; empty for one step of no known time."""

    def read(self, index: int) -> pv.PolyData:
        """Read the packing of a step."""


def without_own_name(request: Request, packing: pv.PolyData, own: str) -> Request:
    """Take the radii that were read where the request names them as the file does.

    Parameters
    ----------
    request : Request
        How to read.
    packing : pyvista.PolyData
        What was read.
    own : str
        What the file calls the numbers that are in ``radius``, halved if they are diameters; the
        packing has no array of that name.

    Returns
    -------
    Request
        `request`, or one without radii.
    """
    named = isinstance(request.radius, str) and request.radius not in packing.point_data
    return replace(request, radius=None) if named and request.radius == own else request


def finished(packing: pv.PolyData, path: Path, request: Request) -> pv.PolyData:
    """Give a packing from a file its radii, precision and active array.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3); it is changed.
    path : pathlib.Path
        File, for errors.
    request : Request
        How to read.

    Returns
    -------
    pyvista.PolyData
        `packing`.

    Raises
    ------
    PackingFileError
        If there are no radii, or these are none.
    """
    try:
        with_radius_array(packing, request.radius)
        check_radii(packing)
    except (KeyError, TypeError, ValueError) as error:
        raise PackingFileError(f"{path}: {error.args[0]}") from None
    kind = np.float32 if request.precision == "single" else np.float64
    if packing.n_points and packing.points.dtype != kind:
        with np.errstate(over="ignore"):
            points = np.asarray(packing.points).astype(kind)
        if not np.isfinite(points).all():
            raise PackingFileError(f"{path}: found centres that single precision does not hold")
        packing.points = points
    if packing.n_points:
        packing.set_active_scalars("radius", preference="point")
    return packing
