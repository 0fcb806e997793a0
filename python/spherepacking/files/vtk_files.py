"""Packings in the files of VTK: points of any dataset, and collections of them by time."""

from __future__ import annotations

import logging
import warnings
from contextlib import contextmanager
from typing import TYPE_CHECKING
from xml.etree import ElementTree

import numpy as np
import pyvista as pv

from ..datasets import centres_of, check_blocks, wrap
from ..packing import no_such_array
from ..radii import radius_name_in
from .errors import PackingFileError
from .source import Request, finished
from .vtk_counts import check_counts
from .vtk_hdf import check_heaps
from .vtk_legacy import check_legacy

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path
    from typing import Any

EXTENSIONS = (
    *(".vtk", ".vtp", ".vtu", ".vti", ".vtr", ".vts", ".vtm", ".vtmb", ".vtpd", ".vtkhdf"),
    *(".pvtk", ".pvtp", ".pvtu", ".pvti", ".pvtr", ".pvts"),
)
# These hold one step each, which need not be looked up.
SINGLE_STEP = (".vtk", ".vtp", ".vtu", ".vti", ".vtr", ".vts", ".pvtk", ".pvtp", ".pvtu")
# They name further files.
INDICES = (".vtm", ".vtmb", ".vtpd", ".pvtk", ".pvtp", ".pvtu", ".pvti", ".pvtr", ".pvts", ".pvd")

# Indices that name indices, one below the other.
_DEEPEST = 8

# What programs call velocities, LIGGGHTS the first.
_VELOCITIES = ("v", "vel", "velo", "Velocity", "velocities", "V")
_ENDINGS = ("_x _y _z", "_X _Y _Z", ":0 :1 :2", "_0 _1 _2", "[0] [1] [2]")
_VELOCITY_PARTS = [
    *(("vx", "vy", "vz"), ("Vx", "Vy", "Vz")),
    *(
        tuple(stem + ending for ending in endings.split())
        for stem in ("velocity", "v", "vel", "velo", "Velocity")
        for endings in _ENDINGS
    ),
]


class VtkFile:
    """A file that PyVista reads into a dataset.

    Parameters
    ----------
    path : pathlib.Path
        File to read.
    request : Request
        How to read it.
    """

    def __init__(self, path: Path, request: Request) -> None:
        self._path = path
        self._request = request
        _check(path, ())
        with errors_of_vtk(f"{path}: found no dataset that VTK can read"):
            self._reader: Any = pv.get_reader(path)
            algorithm = self._reader.reader
            key = algorithm.GetExecutive().TIME_STEPS()
            self.times = list(algorithm.GetOutputInformation(0).Get(key) or ())

    def read(self, index: int) -> pv.PolyData:
        """Read the packing of a step."""
        algorithm = self._reader.reader
        with errors_of_vtk(f"{self._path}: found no dataset that VTK can read"):
            if self.times:
                algorithm.UpdateTimeStep(self.times[index])
            else:
                algorithm.Update()
            data = pv.wrap(algorithm.GetOutputDataObject(0))
        return self._packing_of(data)

    def _packing_of(self, data: Any) -> pv.PolyData:
        """The packing in a dataset from the file."""
        radius = self._request.radius
        try:
            dataset = wrap(data)
            _check_names(dataset)
            check_blocks(dataset, radius)
            packing = centres_of(dataset, radius if isinstance(radius, str) else None)
            names = packing.point_data.keys()
            if radius is None and packing.n_points and radius_name_in(names) is None:
                message = no_such_array("radius", "radius", packing).args[0]
                if isinstance(dataset, pv.PolyData) and dataset.GetNumberOfPolys():
                    message += "; its polygons may be a surface, which `spherepacking pack` fills"
                raise ValueError(message)
            _add_velocity(packing)
        except UnicodeDecodeError as error:
            raise PackingFileError(
                f"{self._path}: found the bytes {error.object[:30]!r} in an array of texts, "
                "expected UTF-8"
            ) from None
        except (TypeError, ValueError) as error:
            raise PackingFileError(f"{self._path}: {error}") from None
        return finished(packing, self._path, self._request)


def _check_names(dataset: Any) -> None:
    """Raise a ValueError unless the names of arrays and the texts of the dataset are texts."""
    if not isinstance(dataset, pv.DataSet):
        for block in dataset:
            if block is not None:
                _check_names(block)
        return
    for arrays in (dataset.GetPointData(), dataset.GetCellData(), dataset.GetFieldData()):
        for i in range(arrays.GetNumberOfArrays()):
            name = arrays.GetArrayName(i)
            if not isinstance(name, str):
                raise ValueError(f"found the name {name!r} of an array, expected UTF-8")
    for name in dataset.field_data:
        # Texts that are none raise a UnicodeDecodeError.
        dataset.field_data[name]


def _check(path: Path, above: tuple[Path, ...]) -> None:
    """Check what a file and those that it names say of themselves, before VTK believes it.

    Parameters
    ----------
    path : pathlib.Path
        The file.
    above : tuple[pathlib.Path, ...]
        Files that name it, from the first one on.
    """
    extension = path.suffix.lower()
    if extension == ".vtk":
        check_legacy(path)
    elif extension == ".vtkhdf":
        check_heaps(path)
    elif extension in EXTENSIONS:
        below = (*above, path.resolve())
        for file in check_counts(path):
            if file.resolve() in below or len(below) > _DEEPEST:
                raise PackingFileError(
                    f"{path}: found {file} in it, which names it in turn, expected files of data"
                )
            _check(file, below)


def _add_velocity(packing: pv.PolyData) -> None:
    """Add the array ``velocity`` where the file calls it otherwise, as the reader of texts does."""
    arrays = packing.point_data
    if "velocity" in arrays or not packing.n_points:
        return
    shapes = {name: arrays[name].shape[1:] for name in arrays if arrays[name].dtype.kind in "iuf"}
    for name in _VELOCITIES:
        if shapes.get(name) == (3,):
            arrays["velocity"] = arrays[name]
            return
    for parts in _VELOCITY_PARTS:
        if all(shapes.get(part) == () for part in parts):
            arrays["velocity"] = np.column_stack([arrays[part] for part in parts])
            return


@contextmanager
def errors_of_vtk(what: str) -> Iterator[None]:
    """Raise what VTK reports in the block as one PackingFileError, instead of printing it.

    Parameters
    ----------
    what : str
        What is wrong then, before a colon and the first message of VTK.

    Raises
    ------
    PackingFileError
        If VTK reports an error, or whatever else is raised in the block.
    """
    failure: Exception | None = None
    logging.disable(logging.CRITICAL)
    try:
        with (
            pv.vtk_verbosity("off"),
            pv.VtkErrorCatcher() as caught,
            warnings.catch_warnings(),
        ):
            warnings.simplefilter("ignore")
            try:
                yield
            except Exception as error:  # readers raise all kinds
                failure = error
    finally:
        logging.disable(logging.NOTSET)
    said = [event.alert for event in caught.events if event.kind.upper() == "ERROR"]
    if failure is not None or said:
        # What comes first is the cause.
        text = " ".join((said[0] if said else str(failure)).split())
        raise PackingFileError(f"{what}: {text}") from None


# --- collections ----------------------------------------------------------------------------------


def parts_by_time(path: Path) -> list[tuple[float, list[Path]]]:
    """Files that a collection of ParaView (.pvd) names, by time.

    Parameters
    ----------
    path : pathlib.Path
        The collection.

    Returns
    -------
    list[tuple[float, list[pathlib.Path]]]
        Times in order, each with the files whose points belong together.

    Raises
    ------
    PackingFileError
        If it is no such collection, or names no file.
    """
    found: dict[float, list[tuple[int, Path]]] = {}
    try:
        for element in ElementTree.parse(path).getroot().iterfind("Collection/DataSet"):
            time, part = float(element.get("timestep", "0")), int(element.get("part", "0"))
            found.setdefault(time, []).append((part, path.parent / element.attrib["file"]))
    except (ElementTree.ParseError, KeyError, ValueError) as error:
        raise PackingFileError(
            f"{path}: found no collection of files, expected one: {error}"
        ) from None
    if not found:
        raise PackingFileError(f"{path}: found no file in it, expected a collection of files")
    return [
        (time, [file for _, file in sorted(parts, key=lambda item: item[0])])
        for time, parts in sorted(found.items())
    ]
