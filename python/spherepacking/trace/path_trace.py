"""How the accessor ``packing`` follows paths of light: arguments of the C++ path tracer."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .. import checks as arguments
from .denoise import denoised, denoiser
from .ray_cast import Caster
from .sky import set_sky, set_sun, sky_of, sun_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .sky import Sun


class PathTracer(Caster):
    """A path tracer that keeps its picture as well, for more samples."""

    tracer_class = "vtkSpherePackingPathTracer"
    label = "tracing paths"
    plain = True
    watchful = True

    def set_paths(
        self,
        *,
        samples: int,
        max_bounces: int,
        albedo: float,
        sky: object,
        sun: Sun | None,
        seed: int,
        time_budget: float | None,
        preview: bool,
        noise_target: float | None,
        min_samples: int,
        exposure: float,
        filmic: bool,
        sky_visible: bool,
    ) -> None:
        """Check the arguments and hand them to the tracer that was prepared."""
        samples = arguments.count_of("samples", samples)
        max_bounces = arguments.count_of("max_bounces", max_bounces, least=0)
        albedo = arguments.number_of("albedo", albedo, 0.0, 1.0)
        sky, sun = sky_of(sky), sun_of(sun)
        seed = arguments.count_of("seed", seed, least=0, most=2**32 - 1)
        limits = {"time_budget": time_budget, "noise_target": noise_target}
        for name, value in limits.items():
            if value is not None:
                limits[name] = arguments.above_zero(name, value)
        min_samples = arguments.count_of("min_samples", min_samples, least=2)
        exposure = arguments.number_of("exposure", exposure, -100.0, 100.0)
        preview = arguments.flag_of("preview", preview)
        filmic = arguments.flag_of("filmic", filmic)
        sky_visible = arguments.flag_of("sky_visible", sky_visible)
        tracer = self._tracer
        tracer.SetNumberOfSamples(samples)
        tracer.SetMaximumNumberOfBounces(max_bounces)
        tracer.SetAlbedo(albedo)
        set_sky(tracer, sky)
        set_sun(tracer, sun)
        tracer.SetSeed(seed)
        # None and endless are the same.
        limits = {n: v if v is not None and v < 1e290 else 0.0 for n, v in limits.items()}
        tracer.SetTimeBudget(limits["time_budget"])
        tracer.SetPreview(preview)
        tracer.SetNoiseTarget(limits["noise_target"])
        tracer.SetMinimumNumberOfSamples(min_samples)
        tracer.SetExposure(exposure)
        tracer.SetFilmic(filmic)
        tracer.SetSkyVisible(sky_visible)

    def trace(
        self,
        packing: pv.PolyData,
        tile: Sequence[int] | int | None,
        look: dict[str, object],
        denoise: bool,
        progress: bool,
    ) -> pv.ImageData:
        """Make the picture and note what made it."""
        if arguments.flag_of("denoise", denoise):
            denoiser()  # that it is missing is said before any path is traced
        image = self.cast(packing, tile, look, progress)
        tracer = self._tracer
        camera = tracer.GetCamera()
        fields = image.field_data
        fields["camera"] = np.array(
            [camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp()]
        )
        parallel = camera.GetParallelProjection()
        fields["parallel_scale"] = [camera.GetParallelScale() if parallel else np.nan]
        fields["view_angle"] = [np.nan if parallel else camera.GetViewAngle()]
        fields["seed"] = [tracer.GetSeed()]
        fields["max_bounces"] = [tracer.GetMaximumNumberOfBounces()]
        fields["reflectance"] = [tracer.GetAlbedo()]
        # A preview, of which three quarters are dark, cannot be told from a dark picture.
        if denoise and image["samples"].all():
            image.point_data["denoised"] = denoised(image)
            colors = pv.convert_array(np.zeros((image.n_points, 4), np.uint8), name="color")
            tracer.Develop(image.GetPointData().GetArray("denoised"), colors)
            # Replaces the array in this picture alone.
            image.GetPointData().AddArray(colors)
        return image
