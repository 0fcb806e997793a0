"""Packings of shapes: closed surfaces filled with spheres."""

from __future__ import annotations

import warnings

import numpy as np
import pyvista as pv

from .. import checks
from ..packing import snapshot
from ..vtk_tools import update


def pack(
    mesh: pv.PolyData,
    count: int,
    *,
    seed: int = 0,
    min_radius: float | None = None,
    fraction: float | None = None,
    progress_bar: bool = False,
) -> pv.PolyData:
    """Fill a closed surface with spheres that overlap neither each other nor the surface.

    Again and again a sphere is put where about the largest fits, so the packing looks like those
    of ProtoSphere: a few large spheres, and ever smaller ones between them and along the surface.
    The spheres are sorted from large to small; the first of them are a packing, too.

    Points of the surface may coincide, or nearly so, triangles may be there twice and turned either
    way, and more than two may share an edge. Of several shells, one that lies within another bounds
    a hole.

    Parameters
    ----------
    mesh : pyvista.PolyData
        Closed surface, of any polygons, in any unit.
    count : int
        How many spheres at most, from 1 on. There are fewer if the search ends without finding
        more, as in sheets thinner than a millionth of the surface's size.
    seed : int, default: 0
        Another number from 0 on gives another packing; the same one always the same packing.
    min_radius : float, optional
        Radii are above this, in the unit of the surface.
    fraction : float, optional
        Part of the volume that is enough, above 0 and up to 1.
    progress_bar : bool, default: False
        Show progress and the remaining time on stderr.

    Returns
    -------
    pyvista.PolyData
        Centres (n, 3), float64, and point array ``radius`` (n,), float64, both in the unit of the
        surface. ``field_data`` has ``volume_fraction`` and ``surface_volume``; the fraction is NaN
        if the surface crosses itself so much that it would be above 1.

    Raises
    ------
    TypeError
        If `mesh` is not a PolyData, or `count` or `seed` is not an integer.
    ValueError
        If a number is out of range, no sphere of `min_radius` fits, or the surface is not closed;
        the message says where it is open.

    Warns
    -----
    UserWarning
        If Ctrl-C was pressed. The spheres that were there by then are returned.

    Notes
    -----
    A branch-and-bound search over an octree finds where spheres fit; what is inside is decided by
    the generalised winding number (A. Jacobson, L. Kavan, O. Sorkine-Hornung: Robust inside-outside
    segmentation using generalized winding numbers, 2013). The kind of packing is that of R. Weller
    and G. Zachmann: ProtoSphere: a GPU-assisted prototype guided sphere packing algorithm for
    arbitrary objects (2010).

    Examples
    --------
    >>> import pyvista as pv
    >>> import spherepacking
    >>> packing = spherepacking.pack(pv.Cube(), 100)
    >>> packing.n_points, round(float(packing["radius"][0]), 3)
    (100, 0.5)
    """
    from ..backend import vtkSpherePacker

    if not isinstance(mesh, pv.PolyData):
        raise TypeError(
            f"mesh: found {checks.kind_of(mesh)}, expected a pyvista.PolyData; extract_surface() "
            "makes one of other meshes"
        )
    packer = vtkSpherePacker()
    packer.SetInputData(snapshot(mesh))
    packer.SetNumberOfSpheres(checks.count_of("count", count))
    packer.SetSeed(checks.count_of("seed", seed, 0))
    if min_radius is not None:
        least = checks.number_of("min_radius", min_radius, 0.0, np.finfo(float).max)
        packer.SetMinimumRadius(least)
    if fraction is not None:
        part = checks.above_zero("fraction", fraction)
        packer.SetVolumeFraction(checks.number_of("fraction", part, 0.0, 1.0))
    progress = checks.flag_of("progress_bar", progress_bar)
    stopped = False
    try:
        update(packer, "packing", progress=progress)
    except KeyboardInterrupt:
        # It may come when all spheres are there.
        stopped = True
        if not packer.GetOutput().GetNumberOfPoints():
            raise
    packing = pv.wrap(packer.GetOutput())
    if stopped:
        warnings.warn(f"stopped after {packing.n_points} of {count} spheres", stacklevel=2)
    return packing
