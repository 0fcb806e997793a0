"""Pictures and picks by casting rays with the C++ tracer."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .. import checks
from ..vtk_tools import errors_raised
from .prepared import PreparedTracer

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pyvista as pv

    from ..backend import vtkSpherePackingTracer
    from ..look.look import Look
    from .prepared import CameraLike


class Pick(NamedTuple):
    """What a ray hits first.

    Attributes
    ----------
    sphere_id : int
        Index of the sphere in the packing.
    point : numpy.ndarray
        The point (3,) where it is hit, in the unit of the packing.
    normal : numpy.ndarray
        Unit vector (3,) out of the sphere.
    """

    sphere_id: int
    point: np.ndarray
    normal: np.ndarray


class RayCaster:
    """Casts rays at a packing, and keeps its acceleration structure."""

    def __init__(self) -> None:
        self._prepared = PreparedTracer(_make_tracer, "casting rays")

    def cast(
        self,
        packing: pv.PolyData,
        camera: CameraLike,
        window_size: Sequence[int],
        look: Look,
        *,
        structure: str,
        cuts: int | None,
        samples: int,
        tile: Sequence[int] | int | None,
        progress: bool,
    ) -> pv.ImageData:
        """Make a picture; the arguments are those of ``packing.packing.ray_cast``."""
        samples = checks.count_of("samples", samples, most=checks.LARGEST_RAY_SAMPLES)
        with self._prepared.lock:
            tracer = self._prepared.prepare(packing, camera, window_size, structure, cuts)
            tracer.SetSamples(samples)
            return self._prepared.run(tracer, packing, tile, look, progress)

    def pick(
        self,
        packing: pv.PolyData,
        camera: CameraLike,
        window_size: Sequence[int],
        x: float,
        y: float,
    ) -> Pick | None:
        """Cast the ray through a point of the picture, as ``packing.packing.pick``."""
        from ..backend import reference

        with self._prepared.lock:
            tracer = self._prepared.prepare(packing, camera, window_size)
            width, height = tracer.GetWindowSize()
            x = checks.number_of("x", x, 0.0, width)
            y = checks.number_of("y", y, 0.0, height)
            t: Any = reference(0.0)  # which the stub calls a float
            out = [0.0, 0.0, 0.0]
            with errors_raised(tracer):
                sphere = tracer.CastPixel(x, y, t, out)
            x, y, z, radius = tracer.GetCastSphere()
        if sphere < 0:
            return None
        normal = np.array(out)
        # From the sphere, so that the point keeps its digits however far the camera is.
        return Pick(sphere, np.array([x, y, z]) + radius * normal, normal)


def _make_tracer() -> vtkSpherePackingTracer:
    from ..backend import vtkSpherePackingTracer

    return vtkSpherePackingTracer()
