"""The ray caster and the path tracer of this package, as benchmarks see them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..accessor import PackingAccessor
from .technique import Seen

if TYPE_CHECKING:
    import pyvista as pv

LIGHT: dict[str, Any] = {"scalars": "radius", "sky": 1.0, "max_bounces": 4, "albedo": 0.8}
"""The light and look of the scene that paths are traced in, as arguments of ``path_trace``."""
PATH_SAMPLES = (1, 4, 16, 64, 256)
"""Samples per pixel that are measured."""


def _structure_of(fields: pv.DataSetAttributes, structure: str) -> tuple[float, float]:
    """Seconds and bytes that a picture's structure took, NaN without one."""
    if structure == "none":
        return np.nan, np.nan
    return float(fields["build_seconds"][0]), float(fields["memory_bytes"][0])


class RayCast:
    """Pictures of ``packing.packing.ray_cast``."""

    def __init__(
        self,
        packing: pv.PolyData,
        camera: pv.Camera,
        size: tuple[int, int],
        structure: str,
        samples: int,
    ) -> None:
        # Upstream: PyVista before 0.49 keeps a dataset alive whose accessor packing.packing has
        # been used: https://github.com/pyvista/pyvista/pull/8925.
        self._spheres = PackingAccessor(packing)
        self._camera, self._size = camera, size
        self._structure, self._samples = structure, samples
        self._image = self._cast()
        fields = self._image.field_data
        self.build_seconds, self.memory_bytes = _structure_of(fields, structure)

    def _cast(self) -> pv.ImageData:
        return self._spheres.ray_cast(
            self._camera,
            self._size,
            structure=self._structure,
            samples=self._samples,
            scalars="radius",
        )

    def frame(self) -> None:
        """Cast the rays."""
        self._image = self._cast()

    def seen(self) -> Seen:
        """Return what the last rays hit."""
        width, height = self._size
        return Seen(
            np.asarray(self._image["sphere_id"]).reshape(height, width),
            np.asarray(self._image["depth"], dtype=float).reshape(height, width),
            np.asarray(self._image["color"]).reshape(height, width, 4),
        )

    def close(self) -> None:
        """Let the structure and the picture go."""
        del self._image, self._spheres


class PathTrace:
    """Pictures of ``packing.packing.path_trace``, each from the start."""

    def __init__(
        self,
        packing: pv.PolyData,
        camera: pv.Camera,
        size: tuple[int, int],
        structure: str,
        samples: int,
    ) -> None:
        self._spheres = PackingAccessor(packing)
        self._camera, self._size = camera, size
        self._structure, self._samples = structure, samples
        self._seed = 0
        self._image: pv.ImageData | None = None
        # The structure and a picture of the least size.
        fields = self._trace((1, 1), 0).field_data
        self.build_seconds, self.memory_bytes = _structure_of(fields, structure)

    def _trace(self, size: tuple[int, int], seed: int) -> pv.ImageData:
        return self._spheres.path_trace(
            self._camera,
            size,
            structure=self._structure,
            samples=self._samples,
            seed=seed,
            **LIGHT,
        )

    def frame(self) -> None:
        """Trace the paths, others than the last time."""
        self._seed += 1
        self._image = self._trace(self._size, self._seed)

    def seen(self) -> Seen:
        """Return what the middles of the pixels show."""
        image = self._trace(self._size, 1) if self._image is None else self._image
        width, height = self._size
        return Seen(
            np.asarray(image["sphere_id"]).reshape(height, width),
            np.asarray(image["depth"], dtype=float).reshape(height, width),
        )

    def light(self, size: tuple[int, int]) -> pv.ImageData:
        """Trace a picture of another size, whose light can be compared."""
        return self._trace(size, 0)

    def close(self) -> None:
        """Let the structure and the picture go."""
        del self._image, self._spheres
