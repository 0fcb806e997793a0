"""What is known about a packing: its radii, and whether it has changed."""

from __future__ import annotations

import zlib
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from .checks import some_of
from .printable import printable

if TYPE_CHECKING:
    import pyvista as pv

    from .backend import vtkPolyData


def no_such_array(argument: str, name: str, packing: pv.PolyData) -> KeyError:
    """Make the error that says which arrays there are."""
    there = printable(some_of(packing.point_data.keys(), 30) or "none")
    hint = " (there is a cell array of that name)" if name in packing.cell_data else ""
    advice = ""
    if argument == "radius":
        # Files' columns of diameters and the like have become `radius`.
        advice = (
            "; without radius= the array 'radius' is taken"
            if "radius" in packing.point_data
            else "; radius='NAME' names the one with the radii"
            if len(packing.point_data)
            else "; radius=0.5 gives all spheres the same"
        )
    return KeyError(
        f"{argument}: the packing has no point array {name!r}{hint}, its point arrays are: {there}"
        f"{advice}"
    )


def snapshot(packing: pv.PolyData) -> vtkPolyData:
    """Share the points and arrays of a packing as they are now.

    VTK works without Python's lock: what another thread replaces meanwhile would go away.

    Parameters
    ----------
    packing : pyvista.PolyData
        The packing.

    Returns
    -------
    vtkPolyData
        Another one, with the same arrays.
    """
    from .backend import vtkPolyData

    shared = vtkPolyData()
    shared.ShallowCopy(packing)
    if packing.GetPoints() is not None:
        # PyVista's packing.points = ... puts another array into the same vtkPoints. Theirs gets a
        # twin of the array, on the same memory, since vtkPoints names an array that it is given,
        # and that counts as a change.
        coordinates = packing.GetPoints().GetData()
        twin = coordinates.NewInstance()
        twin.ShallowCopy(coordinates)
        twin.shared_with = coordinates  # which may keep the memory of a NumPy array alive
        points = packing.GetPoints().NewInstance()
        points.SetData(twin)
        shared.SetPoints(points)
    return shared


def check_radii(packing: pv.PolyData, name: str = "radius") -> None:
    """Check that a point array holds radii, and that the centres are finite.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3).
    name : str, default: "radius"
        Name of the point array. A packing without spheres need not have it.

    Raises
    ------
    KeyError
        If there is no array of that name.
    TypeError
        If the radii are not real numbers.
    ValueError
        If there is not one radius per sphere, or a radius is negative or not finite, or a centre is
        not finite.
    """
    from .backend import vtkSpherePackingInput

    if packing.n_points and name not in packing.point_data:
        raise no_such_array("radius", name, packing)
    check = vtkSpherePackingInput()
    if check.FindRadii(snapshot(packing), name) is None and (message := check.GetMessage()):
        numeric = packing.point_data[name].dtype.kind in "iuf"
        raise (ValueError if numeric else TypeError)(f"radius: {message}")


class ModifiedTimes(NamedTuple):
    """When VTK last learned of changes of a packing; equal as long as it learned of no other.

    VTK counts changes, so no two of its objects have a time in common.

    Attributes
    ----------
    points, coordinates, radii : int
        Of the vtkPoints, of their array, and of the point array ``radius``.
    arrays : int
        Of the latest change of any point array, or of which there are.
    whole : int
        Of the latest change of anything in the packing.
    """

    points: int
    coordinates: int
    radii: int
    arrays: int
    whole: int

    @property
    def geometry(self) -> tuple[int, int, int]:
        """Of what centres and radii depend on."""
        return self.points, self.coordinates, self.radii


def modified_times(packing: pv.PolyData) -> ModifiedTimes | None:
    """When a packing was last changed; None without spheres or radii."""
    arrays = packing.GetPointData()
    radii = arrays.GetAbstractArray("radius")
    if not packing.n_points or radii is None:
        return None
    points = packing.GetPoints()
    return ModifiedTimes(
        points.GetMTime(),
        points.GetData().GetMTime(),
        radii.GetMTime(),
        arrays.GetMTime(),
        packing.GetMTime(),
    )


class ChangeDetector:
    """Finds out when a packing was last changed, also behind VTK's back.

    NumPy writes into an array without notifying VTK. ``packing["radius"] *= 2`` only notifies the
    point data that an array was added, and a write through another view of the memory nothing.

    Parameters
    ----------
    hash_contents : bool
        Hash centres and radii each time. Otherwise only the radii, and only after another change
        that VTK was notified of.
    """

    def __init__(self, *, hash_contents: bool) -> None:
        self._hash_contents = hash_contents
        self._times: ModifiedTimes | None = None
        self._hashes = (0, 0)

    def modified_times(self, packing: pv.PolyData) -> ModifiedTimes | None:
        """Notify VTK of the changes that it does not know of, and return the times after that."""
        times, before = modified_times(packing), self._times
        if times is None:
            return None
        same = before is not None and times.geometry == before.geometry
        notified = before is None or times.arrays != before.arrays
        if same and not notified and not self._hash_contents:
            return times
        hashes = (
            content_hash(packing.point_data["radius"]),
            content_hash(packing.points) if self._hash_contents else 0,
        )
        if same:
            radii = packing.GetPointData().GetAbstractArray("radius")
            coordinates = packing.GetPoints().GetData()
            for array, found, known in zip((radii, coordinates), hashes, self._hashes, strict=True):
                if found != known:
                    array.Modified()
        self._hashes, self._times = hashes, modified_times(packing)
        return self._times


def content_hash(values: np.ndarray) -> int:
    """Hash (CRC-32) of the bytes of an array."""
    return zlib.crc32(np.ascontiguousarray(values).view(np.uint8))
