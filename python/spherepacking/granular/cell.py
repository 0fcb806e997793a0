"""The simulation cell of a packing: the parallelepiped of three vectors from its origin."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pyvista as pv


class Cell(NamedTuple):
    """What the field arrays ``cell_vectors``, ``cell_origin`` and ``cell_periodic`` hold.

    Attributes
    ----------
    vectors : numpy.ndarray
        a, b and c as rows (3, 3).
    origin : numpy.ndarray
        The corner from which they go (3,).
    periodic : numpy.ndarray
        Whether the packing is repeated along each (3,), bool.
    """

    vectors: np.ndarray
    origin: np.ndarray
    periodic: np.ndarray

    @property
    def duals(self) -> np.ndarray:
        """Rows d (3, 3), so that ``d @ (point - origin)`` are a point's coordinates in vectors.

        Where the cell is flat, only along its periodic vectors; the other rows are 0.
        """
        if _spans(self.vectors):
            return np.linalg.inv(self.vectors).T
        duals = np.zeros((3, 3))
        duals[self.periodic] = np.linalg.pinv(self.vectors[self.periodic]).T
        return duals

    def fractions(self, points: np.ndarray) -> np.ndarray:
        """Coordinates (n, 3) of points in vectors of the cell, from 0 to 1 inside."""
        return (points - self.origin) @ self.duals.T

    def sums(self, shifts: np.ndarray) -> np.ndarray:
        """Sums (n, 3) of the vectors, each as often as `shifts` (n, 3) say."""
        a, b, c = (shifts[..., k, None] * self.vectors[k] for k in range(3))
        return (a + b) + c


def _spans(vectors: np.ndarray) -> bool:
    """Whether vectors (k, 3) are linearly independent, by more than rounding."""
    lengths = np.linalg.norm(vectors, axis=1)
    if not len(vectors) or not lengths.all():
        return not len(vectors)
    return float(np.linalg.svd(vectors / lengths[:, None], compute_uv=False)[-1]) > 1e-10


def _values(packing: pv.DataObject, name: str, shape: tuple[int, ...]) -> np.ndarray:
    """Finite numbers of a field array, or a ValueError."""
    values = np.asarray(packing.field_data[name], float)
    if values.size != np.prod(shape) or not np.isfinite(values).all():
        size = "9" if shape == (3, 3) else "3"
        raise ValueError(f"{name}: found {values.tolist()}, expected {size} finite numbers")
    return values.reshape(shape)


def find_cell(packing: pv.DataObject) -> Cell | None:
    """The cell of a packing, or None if it has none.

    Without ``cell_origin`` that is 0, without ``cell_periodic`` all vectors are periodic.

    Parameters
    ----------
    packing : pyvista.DataObject
        Packing with or without the field array ``cell_vectors``.

    Returns
    -------
    Cell or None
        The cell.

    Raises
    ------
    ValueError
        If the arrays do not hold a cell.
    """
    names = packing.field_data.keys()
    if "cell_vectors" not in names:
        return None
    vectors = _values(packing, "cell_vectors", (3, 3))
    origin = _values(packing, "cell_origin", (3,)) if "cell_origin" in names else np.zeros(3)
    periodic = _values(packing, "cell_periodic", (3,)) if "cell_periodic" in names else np.ones(3)
    cell = Cell(vectors, origin, periodic != 0)
    if not _spans(vectors[cell.periodic]):
        raise ValueError(
            f"cell_vectors: found {vectors[cell.periodic].tolist()} for the periodic ones, "
            "expected vectors that do not lie in one plane or line"
        )
    return cell


def cell_of(packing: pv.DataObject) -> Cell:
    """The cell of a packing, or a ValueError if it has none."""
    cell = find_cell(packing)
    if cell is None:
        raise ValueError(
            "packing: found no cell, expected the field array cell_vectors, and cell_origin and "
            "cell_periodic if they are not 0 0 0 and 1 1 1"
        )
    return cell


def set_cell(packing: pv.PolyData, cell: Cell) -> None:
    """Write the field arrays of a cell."""
    packing.field_data["cell_vectors"] = cell.vectors
    packing.field_data["cell_origin"] = cell.origin
    packing.field_data["cell_periodic"] = cell.periodic.astype(np.uint8)


def outline_of(cell: Cell) -> pv.PolyData:
    """The twelve edges of a cell as lines between its eight corners."""
    corners = np.array([[k & 1, k >> 1 & 1, k >> 2] for k in range(8)])
    edges = [(i, i | bit) for bit in (1, 2, 4) for i in range(8) if not i & bit]
    lines = np.insert(np.array(edges), 0, 2, axis=1)
    return pv.PolyData(cell.origin + cell.sums(corners), lines=lines.ravel())
