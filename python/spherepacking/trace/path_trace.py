"""Pictures by following paths of light with the C++ path tracer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .. import checks
from ..interrupts import interrupts_held
from .denoise import denoised, denoiser
from .prepared import PreparedTracer
from .sky import set_sky, set_sun, sky_of, sun_of

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ..backend import vtkSpherePackingPathTracer
    from ..look.look import Look
    from .prepared import CameraLike
    from .sky import SkyLike, Sun


@dataclass(frozen=True, eq=False)
class PathOptions:
    """What a path-traced picture depends on beside packing, view and look.

    The attributes and their defaults are arguments of ``packing.packing.path_trace``.
    """

    samples: int = 16
    max_bounces: int = 4
    albedo: float = 0.8
    sky: SkyLike = 1.0
    sun: Sun | Sequence[float] | None = None
    seed: int = 0
    structure: str = "bvh"
    cuts: int | None = None
    tile: Sequence[int] | int | None = None
    time_budget: float | None = None
    preview: bool = False
    noise_target: float | None = None
    min_samples: int = 16
    exposure: float = 0.0
    filmic: bool = False
    sky_visible: bool = True
    denoise: bool = False
    progress: bool = False
    stop: Callable[[], bool] | None = None


class PathTracer:
    """Traces paths in a packing; keeps its acceleration structure, and the picture to refine."""

    def __init__(self) -> None:
        self._prepared = PreparedTracer(
            _make_tracer, "tracing paths", white_by_default=True, hash_contents=True
        )

    @interrupts_held
    def trace(
        self,
        packing: pv.PolyData,
        camera: CameraLike,
        window_size: Sequence[int],
        look: Look,
        options: PathOptions,
    ) -> pv.ImageData:
        """Make a picture, or go on with that of the last time."""
        prepared = self._prepared
        with prepared.lock:
            tracer = prepared.prepare(packing, camera, window_size, options.structure, options.cuts)
            _set_options(tracer, options)
            if options.stop is not None and not callable(options.stop):
                raise TypeError(
                    f"stop: found {checks.kind_of(options.stop)}, expected a function, such as "
                    "threading.Event().is_set"
                )
            if checks.flag_of("denoise", options.denoise):
                denoiser()  # that it is missing is said before any path is traced
            image = prepared.run(
                tracer, packing, options.tile, look, options.progress, options.stop
            )
            _note_origin(tracer, image)
            # A preview, of which three quarters are dark, looks like a dark picture.
            if options.denoise and image["samples"].all():
                _denoise(tracer, image)
        return image


def _make_tracer() -> vtkSpherePackingPathTracer:
    from ..backend import vtkSpherePackingPathTracer

    return vtkSpherePackingPathTracer()


def _set_options(tracer: vtkSpherePackingPathTracer, options: PathOptions) -> None:
    """Check the options, then hand them to the tracer."""
    samples = checks.count_of("samples", options.samples)
    max_bounces = checks.count_of("max_bounces", options.max_bounces, least=0)
    albedo = checks.number_of("albedo", options.albedo, 0.0, 1.0)
    sky, sun = sky_of(options.sky), sun_of(options.sun)
    seed = checks.count_of("seed", options.seed, least=0, most=checks.LARGEST_SEED)
    time_budget = _limit_of("time_budget", options.time_budget)
    noise_target = _limit_of("noise_target", options.noise_target)
    min_samples = checks.count_of("min_samples", options.min_samples, least=2)
    exposure = checks.number_of("exposure", options.exposure, *checks.EXPOSURE_LIMITS)
    preview = checks.flag_of("preview", options.preview)
    filmic = checks.flag_of("filmic", options.filmic)
    sky_visible = checks.flag_of("sky_visible", options.sky_visible)
    tracer.SetNumberOfSamples(samples)
    tracer.SetMaximumNumberOfBounces(max_bounces)
    tracer.SetAlbedo(albedo)
    set_sky(tracer, sky)
    set_sun(tracer, sun)
    tracer.SetSeed(seed)
    tracer.SetTimeBudget(time_budget)
    tracer.SetPreview(preview)
    tracer.SetNoiseTarget(noise_target)
    tracer.SetMinimumNumberOfSamples(min_samples)
    tracer.SetExposure(exposure)
    tracer.SetFilmic(filmic)
    tracer.SetSkyVisible(sky_visible)


def _limit_of(name: str, value: float | None) -> float:
    """A limit as the tracer has it, 0 for no limit."""
    if value is None:
        return 0.0
    limit = checks.above_zero(name, value)
    return limit if limit < checks.ENDLESS else 0.0


def _note_origin(tracer: vtkSpherePackingPathTracer, image: pv.ImageData) -> None:
    """Write into a picture what made it."""
    camera = tracer.GetCamera()
    fields = image.field_data
    fields["camera"] = np.array([camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp()])
    parallel = camera.GetParallelProjection()
    fields["parallel_scale"] = [camera.GetParallelScale() if parallel else np.nan]
    fields["view_angle"] = [np.nan if parallel else camera.GetViewAngle()]
    fields["seed"] = [tracer.GetSeed()]
    fields["max_bounces"] = [tracer.GetMaximumNumberOfBounces()]
    fields["reflectance"] = [tracer.GetAlbedo()]


def _denoise(tracer: vtkSpherePackingPathTracer, image: pv.ImageData) -> None:
    """Add the array ``denoised``, and make the colours anew from it."""
    image.point_data["denoised"] = denoised(image)
    colors = pv.convert_array(np.zeros((image.n_points, 4), np.uint8), name="color")
    tracer.Develop(image.GetPointData().GetArray("denoised"), colors)
    # Replaces the array in this picture alone.
    image.GetPointData().AddArray(colors)
