"""What the command ``render`` does."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
import pyvista as pv

from ..checks import color_of
from ..files.image import check_output, write_strips
from ..look.scalars import means_colors
from ..vtk_tools import window_of
from .camera import aim, fit
from .frames import check_frames, frame_writer, has_number, is_movie, slice_of
from .input import open_steps, read_step
from .options import check_technique, check_view
from .scene import cell_corners, scene_of
from .techniques import add_boxes, add_metaballs, save_path_trace, save_ray_cast

if TYPE_CHECKING:
    from pathlib import Path

    from ..files.steps import PackingSteps
    from ..look.look import Look
    from .input import InputOptions
    from .options import RenderOptions
    from .scene import Scene

# In the middle at the bottom. With four labels, none of them is below the title and touches it.
_SCALAR_BAR = {
    "n_labels": 4,
    "fmt": "%.3g",
    "width": 0.6,
    "height": 0.09,
    "position_x": 0.2,
    "position_y": 0.02,
}
_MATERIAL = {"specular": 0.3, "specular_power": 20.0}


def render(path: Path, options: RenderOptions, source: InputOptions) -> None:
    """Draw the packing in a file and save the picture, or those of several steps.

    Parameters
    ----------
    path : pathlib.Path
        File with the packing.
    options : RenderOptions
        What was asked for.
    source : InputOptions
        Which step is read, and how.

    Raises
    ------
    ImportError, OSError, ValueError
        If an option is invalid, a file cannot be read or written, or a library is missing; nothing
        is written.
    """
    _check(options)
    if options.steps is not None:
        _render_steps(path, options, source)
        return
    if is_movie(options.output):
        raise ValueError(
            f"--output: found the movie {options.output}, expected --steps with it, such as "
            "--steps : for all, or the name of a picture"
        )
    if has_number(options.output):
        raise ValueError(
            f"--output: found {options.output}, which has a place for the numbers of steps, "
            "expected --steps with it, such as --steps : for all, or another name"
        )
    check_output(options.output)
    packing = read_step(open_steps(path, source), path, source)
    scene = scene_of([packing], [str(path)], options, several=False)
    _draw(packing, options, scene, several=False)


def _render_steps(path: Path, options: RenderOptions, source: InputOptions) -> None:
    """Draw several steps with one range of colours and one camera."""
    for name, value in (("--step", source.step), ("--time", source.time)):
        if value is not None:
            raise ValueError(f"{name}: found with --steps, expected one of them")
    chosen = slice_of(options.steps or "")
    check_frames(options.output, options.size)
    steps: PackingSteps = open_steps(path, source)
    indices = range(len(steps))[chosen]
    if not indices:
        raise ValueError(
            f"--steps: found {options.steps}, expected some of the {len(steps)} steps of {path}"
        )
    names = [f"{path}, step {index}" for index in indices]
    scene = scene_of(steps[chosen], names, options, several=True)
    with frame_writer(options.output, options.fps) as write:
        for index in indices:
            write(index, partial(_draw_into, steps[index], options, scene))


def _draw_into(packing: pv.PolyData, options: RenderOptions, scene: Scene, file: Path) -> None:
    """Draw one of several steps into a file."""
    _draw(packing, replace(options, output=file), scene, several=True)


def _draw(packing: pv.PolyData, options: RenderOptions, scene: Scene, *, several: bool) -> None:
    """Draw a packing and save the picture."""
    plotter = pv.Plotter(off_screen=True, window_size=list(options.size))
    try:
        if options.background is not None:
            plotter.background_color = color_of("--background", options.background)
        _set_quality(plotter, options)
        look = scene.look
        if several and not packing.n_points:
            look = replace(look, scalars=None, clim=None)  # it has no arrays
            if options.technique == "metaballs":
                options = replace(options, technique="opengl")  # nor a surface
        shown = _add(plotter, packing, look, options)
        if several and scene.bounds is not None:
            shown = _corners(scene.bounds)
            plotter.renderer.view_isometric(render=False, bounds=scene.bounds)
            plotter.renderer.camera_set = True  # it is not to be placed by what this step shows
        _aim(plotter, shown, options)
        if options.technique == "raycast":
            save_ray_cast(plotter, packing, look, options)
        elif options.technique == "pathtrace":
            save_path_trace(plotter, packing, look, options)
        else:
            plotter.renderer.ResetCameraClippingRange()
            _save(plotter, options)
    finally:
        plotter.close()


def _save(plotter: pv.Plotter, options: RenderOptions) -> None:
    """Save what the plotter shows, which need not fit into memory."""
    width, height = options.size
    strips = plotter.packing.strips(options.size, options.transparent)
    shape = (height, width, 4 if options.transparent else 3)
    try:
        with closing(strips):
            write_strips(options.output, shape, np.dtype(np.uint8), strips)
    except RuntimeError as error:  # that it cannot be drawn
        raise ValueError(str(error)) from None


def _check(options: RenderOptions) -> None:
    """Raise an exception for what is known to be wrong before anything is read."""
    check_technique(options)
    check_view(options)
    if not 0.0 < options.fps <= 1000.0:
        raise ValueError(f"--fps: found {options.fps:g}, expected a number above 0 up to 1000")
    traced = options.technique in ("raycast", "pathtrace")
    if traced and options.opacity != 1.0:
        raise ValueError(
            f"--opacity: found {options.opacity}, expected 1 with --technique {options.technique}"
        )


def _set_quality(plotter: pv.Plotter, options: RenderOptions) -> None:
    """Smooth edges, and mix what is seen through one another in the right order."""
    if options.opacity < 1.0:
        # Upstream: VTK's depth peeling goes neither with multisampling on Mesa, see
        # https://github.com/pyvista/pyvista/issues/4867, nor with vtkSSAAPass.
        window_of(plotter).SetMultiSamples(1)
        plotter.enable_depth_peeling()  # type: ignore[call-arg]  # PyVista's wraps() shows `self`
    if options.anti_aliasing and options.opacity < 1.0:
        # Upstream: with EGL and OSMesa PyVista's enable_anti_aliasing("fxaa") warns, and takes
        # SSAA: https://github.com/pyvista/pyvista/pull/2694.
        window_of(plotter).SetMultiSamples(0)
        plotter.renderer.SetUseFXAA(True)
    elif options.anti_aliasing:
        plotter.enable_anti_aliasing("ssaa")


def _add(
    plotter: pv.Plotter, packing: pv.PolyData, look: Look, options: RenderOptions
) -> pv.PolyData:
    """Add to the scene what is drawn, and return what the picture has to show, as spheres."""
    material: dict[str, Any] = {"opacity": options.opacity, **_MATERIAL}
    if options.technique == "metaballs":
        return add_metaballs(plotter, packing, look, material, options)
    traced = options.technique in ("raycast", "pathtrace")
    plotter.packing.add(
        packing,
        **look.kwargs(),
        **material,
        show_scalar_bar=options.scalar_bar
        and not traced
        and not means_colors(options.scalars or ""),
        scalar_bar_args=_SCALAR_BAR,
        show_cell=options.cell and _ink(plotter.background_color),
    )
    boxed = options.technique in ("bvh", "grid")
    shown = add_boxes(plotter, packing, options) if boxed else packing
    return _with_points(shown, cell_corners(packing)) if options.cell else shown


def _ink(background: pv.Color) -> str:
    """A colour of lines that are seen before the background."""
    red, green, blue = background.float_rgb
    # Luminance of Rec. 709.
    return "white" if 0.2126 * red + 0.7152 * green + 0.0722 * blue < 0.5 else "black"


def _corners(bounds: tuple[float, ...]) -> pv.PolyData:
    """Corners of a box, as spheres of radius 0."""
    return _with_points(pv.PolyData(), np.asarray(pv.Box(bounds).points, dtype=float))


def _with_points(shown: pv.PolyData, points: np.ndarray) -> pv.PolyData:
    """The spheres, and points as spheres of radius 0."""
    radii = np.asarray(shown["radius"], dtype=float) if shown.n_points else np.empty(0)
    both = pv.PolyData(np.concatenate([np.asarray(shown.points, dtype=float), points]))
    both["radius"] = np.concatenate([radii, np.zeros(len(points))])
    return both


def _aim(plotter: pv.Plotter, shown: pv.PolyData, options: RenderOptions) -> None:
    """Place the camera, and let the spheres of `shown` fill the picture if it was not placed."""
    camera = plotter.camera
    aim(camera, options.camera, options.focal, options.up)
    if options.view_angle is not None:
        camera.view_angle = options.view_angle
    elif options.camera is None and options.focal is None and shown.n_points:
        # The scalar bar needs room at the bottom, in pixels, since its letters do.
        room = 110.0 / options.size[1] if len(plotter.scalar_bars) else 0.04
        fit(camera, shown, options.size, max(1.0 - 2.0 * room, 0.5))
    if options.parallel:
        plotter.enable_parallel_projection()  # type: ignore[call-arg]  # as enable_depth_peeling
    camera.zoom(options.zoom)
