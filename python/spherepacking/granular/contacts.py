"""Contacts of spheres: the lines between their centres."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .. import checks
from ..packing import check_radii
from ..vtk_tools import update
from .cell import cell_of, find_cell, set_cell

if TYPE_CHECKING:
    from collections.abc import Sequence

# Coordinates that the filter takes; a gap beyond that is none.
_GAP_LIMITS = checks.Limits(-1e30, 1e30)


def contacts_of(
    packing: pv.PolyData,
    gap: float,
    periodic: bool | Sequence[bool] | None,
    *,
    progress: bool = False,
) -> pv.PolyData:
    """Lines between spheres that touch; arguments as in ``packing.packing.contacts``."""
    from ..backend import vtkSpherePackingContacts

    gap = checks.number_of("gap", gap, *_GAP_LIMITS)
    progress = checks.flag_of("progress", progress)
    packing = with_periodic(packing, periodic)
    check_radii(packing)
    find_cell(packing)
    finder = vtkSpherePackingContacts()
    finder.SetInputData(packing)
    finder.SetGap(gap)
    update(finder, "Finding contacts", progress=progress)
    return pv.wrap(finder.GetOutput())


def with_periodic(packing: pv.PolyData, periodic: bool | Sequence[bool] | None) -> pv.PolyData:
    """The packing itself, or a shallow copy whose cell is periodic as wanted.

    Parameters
    ----------
    packing : pyvista.PolyData
        Packing with or without a cell.
    periodic : bool, sequence of bool or None
        For all vectors of the cell or each; None leaves the packing as it is.

    Returns
    -------
    pyvista.PolyData
        The packing or its copy.

    Raises
    ------
    TypeError, ValueError
        If `periodic` is anything else, or true without a cell.
    """
    if periodic is None:
        return packing
    flags = np.asarray(periodic)
    if flags.dtype != bool or flags.shape not in ((), (3,)):
        raise TypeError(
            f"periodic: found {checks.shown(periodic)}, "
            "expected True, False or three of them for a, b and c"
        )
    if not flags.any() and "cell_vectors" not in packing.field_data:
        return packing
    cell = cell_of(packing)
    result = packing.copy(deep=False)
    set_cell(result, cell._replace(periodic=np.broadcast_to(flags, 3)))
    return result
