"""Packings in GSD files, which HOOMD-blue writes."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .errors import PackingFileError
from .source import Request, finished, without_own_name

if TYPE_CHECKING:
    from pathlib import Path
    from typing import Any

# Further arrays of particles, and what they are called here; those in the file are kept.
_ARRAYS = {
    "velocity": "velocity",
    "image": "image",
    "mass": "mass",
    "charge": "charge",
    "body": "body",
    "orientation": "orientation",
    "angmom": "angular_momentum",
    "moment_inertia": "moment_inertia",
}
_BYTES_OF_A_POSITION = 12
# Magic number, then where the tables of data and of names begin, and how many entries each has.
_HEAD = struct.Struct("<5Q")
_MAGIC = 0x65DF65DF65DF65DF


class GsdFile:
    """A GSD file of the schema hoomd; each frame is a step.

    The schema says that a particle without a diameter has the diameter 1. Nobody may have meant
    that, so such a file has no radii. Hard spheres have theirs in the shapes of types.

    Parameters
    ----------
    path : pathlib.Path
        File to read.
    request : Request
        How to read it.

    Raises
    ------
    ImportError
        If the library gsd is not installed.
    PackingFileError
        If it is no such file.
    """

    def __init__(self, path: Path, request: Request) -> None:
        try:
            import gsd.fl
            import gsd.hoomd
        except ImportError:
            raise ImportError(
                f"{path}: found a GSD file, which the library gsd reads, expected that to be "
                "installed: pip install 'spherepacking[formats]'"
            ) from None
        self._path = path
        self._request = request
        _check_header(path)
        try:
            self._trajectory = gsd.hoomd.open(str(path), "r")
            file = self._trajectory.file
            self.times = [self._time(file, i) for i in range(len(self._trajectory))]
        except (OSError, RuntimeError, ValueError, KeyError) as error:
            raise PackingFileError(
                f"{path}: found no GSD file of the schema hoomd, expected one: {error}"
            ) from None
        if not self.times:
            raise PackingFileError(f"{path}: found no frame, expected a GSD file with one or more")

    @staticmethod
    def _time(file: Any, index: int) -> float:
        """Step of a frame; without one, that of the first frame, or else 0."""
        for frame in (index, 0):
            if file.chunk_exists(frame=frame, name="configuration/step"):
                return float(file.read_chunk(frame=frame, name="configuration/step")[0])
        return 0.0

    def read(self, index: int) -> pv.PolyData:
        """Read the packing of a frame."""
        try:
            return self._frame(index)
        except PackingFileError:
            raise
        # A damaged file holds values of any shape under any name.
        except (OSError, RuntimeError, ValueError, KeyError, TypeError, IndexError) as error:
            raise PackingFileError(
                f"{self._path}: found a frame {index} that cannot be read, expected a whole one: "
                f"{error}"
            ) from None

    def _frame(self, index: int) -> pv.PolyData:
        self._check_count(0)
        self._check_count(index)
        frame = self._trajectory[index]
        frame.validate()
        packing = pv.PolyData(np.asarray(frame.particles.position))
        if packing.n_points:
            self._add_arrays(packing, frame, index)
        _add_cell(packing, frame.configuration)
        packing.field_data["TimeValue"] = [self.times[index]]
        if self._request.radius is None and packing.n_points and "radius" not in packing.point_data:
            raise PackingFileError(
                f"{self._path}: found no diameters in frame {index} (the default of 1 is not "
                "taken), expected them, or radius=0.5 or one for each type"
            )
        own = "diameter" if self._has("diameter", frame, index) else ""
        return finished(packing, self._path, without_own_name(self._request, packing, own))

    def _check_count(self, index: int) -> None:
        """Raise unless the file is as long as the positions of all particles of a frame.

        Upstream: gsd 5.0.1 believes the number, and makes arrays of defaults for so many.
        """
        file = self._trajectory.file
        if not file.chunk_exists(frame=index, name="particles/N"):
            return
        count = int(file.read_chunk(frame=index, name="particles/N")[0])
        size = self._path.stat().st_size
        if count * _BYTES_OF_A_POSITION > size:
            raise PackingFileError(
                f"{self._path}: found {count:,} particles in frame {index} of a file of {size:,} "
                "bytes, expected no more than these hold"
            )

    def _add_arrays(self, packing: pv.PolyData, frame: Any, index: int) -> None:
        """Add what the file holds about the particles."""
        particles = frame.particles
        data = packing.point_data
        if len(particles.typeid) != packing.n_points or not particles.types:
            raise PackingFileError(
                f"{self._path}: found {len(particles.typeid)} types of particles in frame {index}, "
                f"expected {packing.n_points}"
            )
        if particles.typeid.max() >= len(particles.types):
            raise PackingFileError(
                f"{self._path}: found the type {particles.typeid.max()} in frame {index}, "
                f"expected one of the {len(particles.types)} types"
            )
        for name in ("diameter", *_ARRAYS):
            if len(values := getattr(particles, name)) != packing.n_points:
                raise PackingFileError(
                    f"{self._path}: found {len(values)} values of {name} in frame {index}, "
                    f"expected {packing.n_points}"
                )
        data["type"] = particles.typeid.astype(np.int64)
        data["type_name"] = np.array(particles.types)[particles.typeid]
        for name, array in _ARRAYS.items():
            if self._has(name, frame, index):
                data[array] = getattr(particles, name)
        for name, values in frame.log.items():
            if name.startswith("particles/") and len(values) == packing.n_points:
                data[name.removeprefix("particles/")] = values
        if self._has("diameter", frame, index):
            data["radius"] = 0.5 * particles.diameter.astype(np.float64)
        elif radii := [_radius_of(shape) for shape in particles.type_shapes or ()]:
            used = [radii[i] if i < len(radii) else None for i in range(len(particles.types))]
            values = np.array([np.nan if r is None else r for r in used])[particles.typeid]
            if not np.isnan(values).any():
                data["radius"] = values

    def _has(self, name: str, frame: Any, index: int) -> bool:
        """Whether the values are the file's rather than the default.

        A frame that lacks them has those of the first frame, if both have as many particles.
        """
        file, chunk = self._trajectory.file, f"particles/{name}"
        if file.chunk_exists(frame=index, name=chunk):
            return True
        first = self._trajectory[0].particles
        return file.chunk_exists(frame=0, name=chunk) and first.N == frame.particles.N


def _check_header(path: Path) -> None:
    """Raise a PackingFileError if the tables that a header names do not lie in the file.

    Upstream: gsd 5.0.1 ends the process where they are too large ("GSD file layer", version 2,
    documentation of gsd).
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        head = file.read(_HEAD.size)
    if len(head) < _HEAD.size:
        return
    magic, index, entries, names, name_entries = _HEAD.unpack(head)
    if magic != _MAGIC:
        return
    for begin, count, entry in ((index, entries, 32), (names, name_entries, 64)):
        if begin + count * entry > size:
            raise PackingFileError(
                f"{path}: found a table of {count:,} entries at byte {begin:,} of a file of "
                f"{size:,} bytes, expected one in a GSD file"
            )


def _radius_of(shape: dict[str, Any]) -> float | None:
    """Radius of a type's shape; None unless it is a sphere."""
    sphere = shape.get("type") == "Sphere" and "diameter" in shape
    return 0.5 * float(shape["diameter"]) if sphere else None


def _add_cell(packing: pv.PolyData, configuration: Any) -> None:
    """Add the periodic box, which is centred at the origin, as field arrays."""
    lx, ly, lz, xy, xz, yz = (float(value) for value in configuration.box)
    vectors = np.array([[lx, 0.0, 0.0], [xy * ly, ly, 0.0], [xz * lz, yz * lz, lz]])
    packing.field_data["cell_vectors"] = vectors
    packing.field_data["cell_origin"] = -0.5 * vectors.sum(axis=0)
    flat = configuration.dimensions == 2
    packing.field_data["cell_periodic"] = np.array([1, 1, 0 if flat else 1], np.uint8)
