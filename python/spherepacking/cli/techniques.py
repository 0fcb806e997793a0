"""The techniques of the command ``render`` beside drawing spheres with OpenGL."""

from __future__ import annotations

import sys
import warnings
from typing import TYPE_CHECKING, Any

import numpy as np
import pyvista as pv

from ..accessor import PackingAccessor
from ..files.exr import write_render
from ..files.image import write_image, write_strips
from ..trace.sky import Sun

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ..look.look import Look
    from ..trace.sky import SkyLike
    from .options import RenderOptions


_STRIP_PIXELS = 2**23
"""Pixels whose rays are cast at a time, which takes less than 1 GB."""


def add_boxes(plotter: pv.Plotter, packing: pv.PolyData, options: RenderOptions) -> pv.PolyData:
    """Add the edges of the boxes of a structure to the scene.

    Returns
    -------
    pyvista.PolyData
        What the picture has to show: the corners, as spheres of radius 0.
    """
    if options.technique == "bvh":
        lines = PackingAccessor(packing).bvh_boxes(options.boxes, as_lines=True)
    else:
        lines = PackingAccessor(packing).grid_boxes(options.cuts, as_lines=True)
    if not lines.n_points:
        return packing
    plotter.add_mesh(lines, color="black", line_width=2.0, lighting=False, show_scalar_bar=False)
    return _as_spheres(lines)


def add_metaballs(
    plotter: pv.Plotter,
    packing: pv.PolyData,
    look: Look,
    material: dict[str, Any],
    options: RenderOptions,
) -> pv.PolyData:
    """Add the surface of metaballs to the scene.

    Returns
    -------
    pyvista.PolyData
        What the picture has to show: the surface's points, as spheres of radius 0.

    Raises
    ------
    ValueError
        If there is no surface.
    """
    with warnings.catch_warnings():
        warnings.filterwarnings("error", "metaballs: ", UserWarning)
        try:
            balls = plotter.packing.add_metaballs(
                packing,
                threshold=options.threshold,
                kernel=options.kernel,
                weights=options.weights,
                count=options.count,
                dimensions=options.dimensions,
                **look.kwargs(),
                **material,
            )
        except UserWarning as empty:
            raise ValueError(f"--threshold: {empty}") from None
    return _as_spheres(balls.surface)


def save_ray_cast(
    plotter: pv.Plotter, packing: pv.PolyData, look: Look, options: RenderOptions
) -> None:
    """Cast rays from the plotter's camera and save the picture, on its background if opaque."""
    samples = options.samples
    if samples is None:
        samples = 2 if options.anti_aliasing else 1
    accessor = PackingAccessor(packing)

    def strips() -> Iterator[np.ndarray]:
        for camera, rows in _views_of_strips(plotter.camera, options.size):
            image = accessor.ray_cast(
                camera,
                (options.size[0], rows),
                structure=options.structure,
                samples=samples,
                progress=sys.stderr.isatty(),
                **look.kwargs(),
            )
            pixels = _pixels_of(image)
            yield pixels if options.transparent else _over(plotter, pixels)

    width, height = options.size
    shape = (height, width, 4 if options.transparent else 3)
    write_strips(options.output, shape, np.dtype(np.uint8), strips())


def _views_of_strips(camera: pv.Camera, size: tuple[int, int]) -> Iterator[tuple[pv.Camera, int]]:
    """Cameras that see strips of a picture from the top, none too large to cast, and their rows."""
    width, height = size
    rows = max(1, _STRIP_PIXELS // width)
    if rows >= height:
        yield camera, height
        return
    center_x, center_y = camera.GetWindowCenter()
    slope = np.tan(np.radians(camera.view_angle) / 2.0)
    for end in range(height, 0, -rows):
        begin = max(0, end - rows)
        scale = (end - begin) / height
        strip = pv.Camera()
        strip.DeepCopy(camera)
        strip.SetWindowCenter(center_x, (center_y + (begin + end) / height - 1.0) / scale)
        strip.view_angle = np.degrees(2.0 * np.arctan(slope * scale))
        strip.parallel_scale = camera.parallel_scale * scale
        yield strip, end - begin


def save_path_trace(
    plotter: pv.Plotter, packing: pv.PolyData, look: Look, options: RenderOptions
) -> None:
    """Trace paths from the plotter's camera and save the picture.

    The sky is behind the spheres, or the plotter's background if one was asked for.
    """
    colors = look.kwargs()
    if look.scalars is None and look.color is None:
        colors["scalars"] = packing.point_data.active_scalars_name
    sun = options.sun
    image = PackingAccessor(packing).path_trace(
        plotter.camera,
        options.size,
        structure=options.structure,
        samples=16 if options.samples is None else options.samples,
        max_bounces=options.max_bounces,
        albedo=options.albedo,
        sky=1.0 if options.sky is None else _sky_of(options.sky),
        sun=None if sun is None else Sun(sun, options.sun_radiance, options.sun_diameter),
        seed=options.seed,
        time_budget=options.time_budget,
        noise_target=options.noise_target,
        exposure=options.exposure,
        filmic=options.filmic,
        denoise=options.denoise,
        sky_visible=not options.transparent and options.background is None,
        progress=sys.stderr.isatty(),
        **colors,
    )
    on_background = options.background is not None and not options.transparent
    if on_background and options.output.suffix.lower() != ".exr":
        write_image(options.output, _over(plotter, _pixels_of(image)))
    else:
        write_render(options.output, image)


def _as_spheres(mesh: pv.PolyData) -> pv.PolyData:
    """The points of a mesh as spheres of radius 0."""
    spheres = pv.PolyData(np.asarray(mesh.points))
    spheres["radius"] = np.zeros(spheres.n_points)
    return spheres


def _pixels_of(image: pv.ImageData) -> np.ndarray:
    """RGBA (height, width, 4), the upper row first."""
    width, height, _ = image.dimensions
    return np.asarray(image["color"]).reshape(height, width, 4)[::-1]


def _over(plotter: pv.Plotter, pixels: np.ndarray) -> np.ndarray:
    """Composite pixels over the plotter's background."""
    alpha = pixels[..., 3:] / 255.0
    background = np.array(plotter.background_color.int_rgb)
    return np.round(alpha * pixels[..., :3] + (1.0 - alpha) * background).astype(np.uint8)


def _sky_of(sky: list[str]) -> SkyLike:
    """The light of a sky from one, two or three numbers, or the name of a file."""
    try:
        numbers = [float(token) for token in sky]
    except ValueError:
        if len(sky) > 1:
            raise ValueError(
                f"--sky: found {' '.join(sky)}, expected one, two or three numbers, or a file"
            ) from None
        return sky[0]
    if len(numbers) > 3:
        raise ValueError(f"--sky: found {len(numbers)} numbers, expected one, two or three")
    return numbers[0] if len(numbers) == 1 else numbers
