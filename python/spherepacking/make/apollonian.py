"""The Apollonian sphere packing, in exact integers.

A sphere is a row (b, b·x, b·y/√3, b·z, b'): its curvature b = 1/r, its centre times b, and the
curvature b' of its image under inversion in the unit sphere. Five mutually tangent spheres leave
exactly one more sphere tangent to four of them besides the fifth; in three dimensions its row is
the sum of the rows of the four, less that of the fifth. The rule is linear, so all rows are integer
when the first five are.

J. C. Lagarias, C. L. Mallows, A. R. Wilks: Beyond the Descartes Circle Theorem, American
Mathematical Monthly 109 (2002), theorem 3.3 for n dimensions. The five spheres to start from are
those of F. Soddy: The bowl of integers and the hexlet, Nature 139 (1937).
"""

from __future__ import annotations

import operator

import numpy as np
import pyvista as pv

from ..checks import shown

# The unit sphere around everything, two of radius 1/2, and two of the hexlet of radius 1/3.
_START = np.array(
    [
        [-1, 0, 0, 0, 1],
        [2, 0, 0, 1, 0],
        [2, 0, 0, -1, 0],
        [3, 2, 0, 0, 1],
        [3, 1, 1, 0, 1],
    ],
    dtype=np.int64,
)
_MAX_LEVELS = 11  # 1.4 million spheres; the next level would have 4.8 million


def _unique_rows(rows: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Different rows of an integer array, where each occurs first, and which one each row is."""
    order = np.lexsort(rows.T[::-1])
    ordered = rows[order]
    starts = np.ones(len(rows), dtype=bool)
    starts[1:] = np.any(ordered[1:] != ordered[:-1], axis=1)
    index = np.empty(len(rows), dtype=np.int64)
    index[order] = np.cumsum(starts) - 1
    return ordered[starts], order[starts], index


def _next_level(spheres: np.ndarray, fives: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Swap each sphere of each five for the other one that touches the remaining four.

    Parameters
    ----------
    spheres : numpy.ndarray
        Rows (n, 5) of the spheres known so far.
    fives : numpy.ndarray
        Mutually tangent spheres, (m, 5) indices into `spheres`.

    Returns
    -------
    tuple[numpy.ndarray, numpy.ndarray]
        The known spheres followed by the new ones, and the different new fives.
    """
    rows = spheres[fives]
    swapped = (rows.sum(axis=1, keepdims=True) - 2 * rows).reshape(-1, 5)
    fresh, _, which = _unique_rows(swapped)
    together, first, index = _unique_rows(np.concatenate([spheres, fresh]))
    # A known sphere comes before its double, so `first` points to it; new ones are appended.
    new = np.flatnonzero(first >= len(spheres))
    number = np.where(first < len(spheres), first, 0)
    number[new] = len(spheres) + np.arange(len(new))
    spheres = np.concatenate([spheres, together[new]])

    replacement = number[index[-len(fresh) :]][which].reshape(-1, 5)
    fives = np.repeat(fives[:, None, :], 5, axis=1)
    diagonal = np.arange(5)
    fives[:, diagonal, diagonal] = replacement
    fives, _, _ = _unique_rows(np.sort(fives.reshape(-1, 5), axis=1))
    return spheres, fives


def _rows(levels: int) -> tuple[np.ndarray, np.ndarray]:
    """Rows (n, 5) of all spheres up to a level, the outer one first, and the level of each."""
    spheres = _START
    fives = np.arange(5)[None, :]
    level = np.zeros(len(spheres), dtype=np.int32)
    for current in range(1, levels + 1):
        spheres, fives = _next_level(spheres, fives)
        new = np.full(len(spheres) - len(level), current, dtype=np.int32)
        level = np.concatenate([level, new])
    return spheres, level


def apollonian(levels: int) -> pv.PolyData:
    """Make the Apollonian packing of spheres in the unit sphere, Soddy's bowl of integers.

    It starts from four mutually tangent spheres inside the unit sphere, two of radius 1/2 and two
    of radius 1/3. Each level adds all the spheres that touch four mutually tangent ones of the
    levels before, the unit sphere among them. Tangent spheres touch up to the rounding of
    their centres and radii to float64, and none overlap.

    Parameters
    ----------
    levels : int
        From 0, the four spheres, to 11. The numbers of spheres are 4, 9, 29, 89, 299, 989, 3329,
        11159, 37529, 126089, 423899 and 1424789.

    Returns
    -------
    pyvista.PolyData
        Centres (n, 3) in float64, largest sphere first, with the point arrays ``radius`` (active)
        and ``level``, the level that a sphere came with. The unit sphere is not one of them.

    Raises
    ------
    TypeError
        If `levels` is not an integer.
    ValueError
        If it is not from 0 to 11.

    Examples
    --------
    >>> import spherepacking
    >>> packing = spherepacking.apollonian(4)
    >>> packing.n_points
    299
    >>> float(packing["radius"].max())
    0.5
    """
    try:
        levels = operator.index(levels)
    except TypeError:
        raise TypeError(f"levels: found {shown(levels)}, expected an integer") from None
    if not 0 <= levels <= _MAX_LEVELS:
        raise ValueError(f"levels: found {levels}, expected 0 to {_MAX_LEVELS}")
    rows, level = _rows(levels)
    rows, level = rows[1:], level[1:]
    order = np.lexsort((*rows.T[3:0:-1], rows[:, 0]))
    curvature, bx, by, bz, _ = rows[order].T
    centers = np.column_stack([bx, np.sqrt(3.0) * by, bz]) / curvature[:, None]
    packing = pv.PolyData(centers)
    packing.point_data["level"] = level[order]
    packing.point_data["radius"] = 1.0 / curvature
    packing.set_active_scalars("radius", preference="point")
    return packing
