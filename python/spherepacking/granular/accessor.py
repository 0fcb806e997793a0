"""The part of the accessor ``packing`` that knows the simulation cell and contacts."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .. import checks
from ..datasets import plain_packing
from .cell import cell_of, outline_of
from .contacts import contacts_of
from .images import replicated, with_ghosts, wrapped

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..radii import RadiusLike


class GranularOfPacking:
    """The cell of a simulation, periodic images of spheres, and what touches what.

    A cell is held by the field arrays ``cell_vectors`` (3, 3), rows a, b and c, ``cell_origin``
    (3,) and ``cell_periodic`` (3,), as files that have one bring it.
    """

    _dataset: pv.DataSet | pv.MultiBlock

    if TYPE_CHECKING:

        def with_radius(self, radius: RadiusLike | None = None) -> pv.PolyData:
            """Return the spheres, see PackingAccessor."""

    def contacts(
        self,
        gap: float = 0.0,
        periodic: bool | Sequence[bool] | None = None,
        *,
        radius: RadiusLike | None = None,
        progress: bool = False,
    ) -> pv.PolyData:
        """Lines between the centres of all spheres that touch, whatever their sizes.

        Two spheres touch if the distance of their surfaces, ``sqrt((dx * dx + dy * dy) + dz * dz)
        - (ri + rj)`` in double precision, is at most `gap`. No tolerance is added: spheres that
        should just touch may be apart by rounding, and then need a small gap.

        In a periodic cell every image counts, also of spheres outside the cell and of cells that
        are smaller than a sphere: two may touch several times, and a sphere its own image.

        Parameters
        ----------
        gap : float, default: 0.0
            Largest distance of two surfaces, in the unit of the points; below 0, only those that
            overlap by as much.
        periodic : bool or sequence of bool, optional
            Whether the packing is repeated along the vectors of its cell, or along a, b and c each;
            by default as the field array ``cell_periodic`` says, and not without a cell.
        radius : str, float, array_like or mapping, optional
            Radii, as in :meth:`PackingAccessor.with_radius`.
        progress : bool, default: False
            Show a progress bar. Ctrl-C stops the work with or without.

        Returns
        -------
        pyvista.PolyData
            One line per contact, ordered by i, then j. ``tube()`` makes tubes of them. Cell arrays:

            - ``gap``: distance of the surfaces, negative for spheres that overlap
            - ``overlap``: by how much they do, else 0
            - ``i``, ``j`` (int32): the spheres, i < j, or i for both ends of a contact with its own
              image
            - ``cell_shift`` (n, 3), int32, of periodic packings: how often a, b and c are added to
              the centre of j

            The first points are the packing's, in its order and with its point arrays. A line that
            leaves the cell ends at the image of j, a further point with the arrays of j. Point
            array:

            - ``coordination`` (int32): number of contacts of the sphere; one with its own image
              counts twice

        Raises
        ------
        KeyError
            If there is no point array ``radius``.
        TypeError
            If an argument has the wrong type.
        ValueError
            If `periodic` is true without a cell, the cell is flat or far smaller than a sphere, a
            radius is negative or not finite, or there are more contacts than fit in half of the
            memory.
        KeyboardInterrupt
            If Ctrl-C was pressed.

        Examples
        --------
        >>> import pyvista as pv
        >>> packing = pv.PolyData([[0.0, 0, 0], [1.5, 0, 0], [0, 5, 0]])
        >>> packing["radius"] = [1.0, 1.0, 1.0]
        >>> lines = packing.packing.contacts()
        >>> lines["i"].tolist(), lines["j"].tolist(), lines["overlap"].tolist()
        ([0], [1], [0.5])
        """
        return contacts_of(self.with_radius(radius), gap, periodic, progress=progress)

    def coordination(
        self,
        gap: float = 0.0,
        periodic: bool | Sequence[bool] | None = None,
        *,
        radius: RadiusLike | None = None,
    ) -> np.ndarray:
        """Count the contacts of every sphere.

        Parameters
        ----------
        gap, periodic, radius
            As in :meth:`contacts`.

        Returns
        -------
        numpy.ndarray
            Number of contacts of each sphere (n,), int32.

        Raises
        ------
        KeyError, TypeError, ValueError
            As :meth:`contacts`.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> packing["coordination"] = packing.packing.coordination(gap=1e-9)
        """
        packing = self.with_radius(radius)
        lines = contacts_of(packing, gap, periodic)
        # A copy: PyVista would take a part of an array for the whole when it is added to a packing.
        return np.array(lines.point_data["coordination"][: packing.n_points])

    def cell_outline(self) -> pv.PolyData:
        """Edges of the cell, as :meth:`PackingComponent.add` draws them with `show_cell`.

        Returns
        -------
        pyvista.PolyData
            Twelve lines between eight corners.

        Raises
        ------
        ValueError
            If the packing has no cell.

        Examples
        --------
        >>> import numpy as np
        >>> import pyvista as pv
        >>> packing = pv.PolyData(np.zeros((1, 3)))
        >>> packing.field_data["cell_vectors"] = np.diag([1.0, 2.0, 3.0])
        >>> packing.packing.cell_outline().n_lines
        12
        """
        return outline_of(cell_of(self._dataset))

    def wrap(self) -> pv.PolyData:
        """Move spheres whose centres lie outside the cell into it, by its periodic vectors.

        Returns
        -------
        pyvista.PolyData
            A packing that shares the arrays of this one. What is moved keeps its precision. The
            point array ``image`` (n, 3) says how often a, b and c have to be added to get the
            place back where the sphere was; if there is one already, or ``ix``, ``iy`` and ``iz``,
            these go on counting.

        Raises
        ------
        ValueError
            If the packing has no cell.

        Examples
        --------
        >>> import numpy as np
        >>> import pyvista as pv
        >>> packing = pv.PolyData([[2.5, 0.5, 0.5]])
        >>> packing.field_data["cell_vectors"] = np.eye(3)
        >>> wrapped = packing.packing.wrap()
        >>> wrapped.points.tolist(), wrapped["image"].tolist()
        ([[0.5, 0.5, 0.5]], [[2, 0, 0]])
        """
        return wrapped(plain_packing(self._dataset))

    def replicate(self, nx: int = 1, ny: int = 1, nz: int = 1) -> pv.PolyData:
        """Put copies of the packing side by side along the vectors of its cell.

        Parameters
        ----------
        nx, ny, nz : int, default: 1
            How many there are along a, b and c, this one included.

        Returns
        -------
        pyvista.PolyData
            This packing, then its copies, with all point arrays but ``image``, ``ix``, ``iy`` and
            ``iz``, which counted another cell's vectors. The point array ``cell_shift`` (n, 3),
            int32, says by how many vectors a sphere was moved. The cell has become that of all.

        Raises
        ------
        TypeError, ValueError
            If the packing has no cell, or a number is no integer, below 1, or too large.

        Examples
        --------
        >>> import numpy as np
        >>> import pyvista as pv
        >>> packing = pv.PolyData([[0.5, 0.5, 0.5]])
        >>> packing.field_data["cell_vectors"] = np.eye(3)
        >>> packing.packing.replicate(2, 2).points.tolist()
        [[0.5, 0.5, 0.5], [0.5, 1.5, 0.5], [1.5, 0.5, 0.5], [1.5, 1.5, 0.5]]
        """
        counts = {"nx": nx, "ny": ny, "nz": nz}
        return replicated(
            plain_packing(self._dataset), [checks.count_of(*item) for item in counts.items()]
        )

    def ghosts(self, *, radius: RadiusLike | None = None) -> pv.PolyData:
        """Add the images that complete spheres at periodic faces, for a picture.

        A sphere that sticks out of a periodic face of the cell comes in again at the opposite one:
        images whose spheres reach into the cell are added. Spheres whose centres lie outside are
        left there, see :meth:`wrap`.

        Parameters
        ----------
        radius : str, float, array_like or mapping, optional
            Radii, as in :meth:`PackingAccessor.with_radius`.

        Returns
        -------
        pyvista.PolyData
            This packing, then the images, with all point arrays. Further ones:

            - ``ghost`` (bool): whether it is an image
            - ``cell_shift`` (n, 3), int32: how often a, b and c were added to the centre

        Raises
        ------
        KeyError
            If there is no point array ``radius``.
        ValueError
            If the packing has no cell, or a sphere needs more than 100 000 images.

        Examples
        --------
        >>> import numpy as np
        >>> import pyvista as pv
        >>> packing = pv.PolyData([[0.1, 0.5, 0.5]])
        >>> packing["radius"] = [0.2]
        >>> packing.field_data["cell_vectors"] = np.eye(3)
        >>> packing.packing.ghosts().points.tolist()
        [[0.1, 0.5, 0.5], [1.1, 0.5, 0.5]]
        """
        return with_ghosts(self.with_radius(radius))
