"""Embree 3, where the package was built with ``-DSPHEREPACKING_EMBREE=ON``; else an ImportError."""

from __future__ import annotations

import ctypes
import os
import time
from functools import partial
from pathlib import Path

import numpy as np
import pyvista as pv

from .technique import Seen, Technique

_RGBA = 4  # as VTK counts them
PACKETS = (1, 4, 8, 16)
"""Numbers of rays that Embree takes at once."""


def _load() -> ctypes.CDLL:
    path = Path(__file__).parents[1] / "lib" / "libspherepacking_embree.so"
    try:
        library = ctypes.CDLL(str(path))
    except OSError as error:
        raise ImportError(f"{path}: the library cannot be loaded ({error})") from error
    pointer, number = ctypes.c_void_p, ctypes.c_int
    library.spherepacking_embree_build.argtypes = [pointer, ctypes.c_int64, number]
    library.spherepacking_embree_build.restype = pointer
    library.spherepacking_embree_bytes.argtypes = [pointer]
    library.spherepacking_embree_bytes.restype = ctypes.c_int64
    library.spherepacking_embree_trace.argtypes = [pointer] * 2 + [number] * 3 + [pointer] * 5
    library.spherepacking_embree_trace.restype = None
    library.spherepacking_embree_free.argtypes = [pointer]
    library.spherepacking_embree_free.restype = None
    return library


_library = _load()


def _rays_of(camera: pv.Camera, size: tuple[int, int]) -> np.ndarray:
    """Origin, direction of pixel (0, 0)'s corner, steps along x and y, towards the eye (5, 3)."""
    position = np.asarray(camera.position, dtype=float)
    forward = np.asarray(camera.focal_point, dtype=float) - position
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, camera.up)
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    step = 2.0 * np.tan(np.radians(camera.view_angle) / 2.0) / size[1]
    corner = forward - 0.5 * step * (size[0] * right + size[1] * up)
    return np.ascontiguousarray([position, corner, step * right, step * up, -forward])


class Embree:
    """Pictures with the arrays of ``packing.packing.ray_cast``, from spheres of Embree.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    camera : pyvista.Camera
        Camera in perspective.
    size : (int, int)
        Width and height in pixels.
    packet : {1, 4, 8, 16}
        How many rays are handed over at once.
    """

    def __init__(
        self, packing: pv.PolyData, camera: pv.Camera, size: tuple[int, int], packet: int
    ) -> None:
        table = pv.LookupTable(pv.global_theme.cmap)
        table.scalar_range = packing.get_data_range("radius")
        array = packing.GetPointData().GetArray("radius")
        self._colors = pv.convert_array(table.MapScalars(array, 0, -1, _RGBA))
        self._spheres = np.ascontiguousarray(
            np.column_stack([packing.points, packing["radius"]]), dtype=np.float32
        )
        self._view = _rays_of(camera, size)
        self._size = size
        self._packet = packet
        shape = (size[1], size[0])
        self._color = np.empty((*shape, 4), np.uint8)
        self._depth = np.empty(shape, np.float32)
        self._normal = np.empty((*shape, 3), np.float32)
        self._ids = np.empty(shape, np.int64)
        self._scene = None
        self.build_seconds = self.build()
        self.memory_bytes = float(_library.spherepacking_embree_bytes(self._scene))

    def build(self) -> float:
        """Build the structure, anew if there is one, and return the seconds that took."""
        self.close()
        start = time.perf_counter()
        self._scene = _library.spherepacking_embree_build(
            self._spheres.ctypes.data, len(self._spheres), len(os.sched_getaffinity(0))
        )
        return time.perf_counter() - start

    def frame(self) -> None:
        """Trace the rays."""
        arrays = (self._colors, self._color, self._depth, self._normal, self._ids)
        _library.spherepacking_embree_trace(
            self._scene,
            self._view.ctypes.data,
            self._packet,
            *self._size,
            *(array.ctypes.data for array in arrays),
        )

    def seen(self) -> Seen:
        """Return what the last rays hit."""
        return Seen(self._ids, self._depth.astype(float), self._color)

    def close(self) -> None:
        """Free the scene."""
        if self._scene is not None:
            _library.spherepacking_embree_free(self._scene)
            self._scene = None


def techniques() -> list[Technique]:
    """Return Embree with single rays and with packets."""
    return [
        Technique(
            "Embree",
            "single" if packet == 1 else f"packets of {packet}",
            1,
            partial(Embree, packet=packet),
        )
        for packet in PACKETS
    ]
