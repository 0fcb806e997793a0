"""What the command ``render`` does."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

import pyvista as pv

from ..checks import color_of
from ..files.image import check_output
from ..files.steps import read
from ..look.look import Look
from ..vtk_tools import window_of
from .camera import aim, check_extent, fit
from .options import check_technique, check_view
from .techniques import add_boxes, add_metaballs, save_path_trace, save_ray_cast

if TYPE_CHECKING:
    from pathlib import Path

    from pyvista.plotting._typing import ColorLike

    from .options import RenderOptions

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
# Radii that spread over more than this ratio are coloured by their logarithm.
_WIDE = 20.0


def render(path: Path, options: RenderOptions) -> None:
    """Draw the packing in a file and save the picture.

    Parameters
    ----------
    path : pathlib.Path
        File with the packing.
    options : RenderOptions
        What was asked for.

    Raises
    ------
    OSError, ValueError
        If an option is invalid, or a file cannot be read or written; nothing is written.
    """
    _check(options)
    packing = read(path, progress=sys.stderr.isatty())
    check_extent(str(path), packing)
    plotter = pv.Plotter(off_screen=True, window_size=list(options.size))
    try:
        if options.background is not None:
            plotter.background_color = color_of("--background", options.background)
        _set_quality(plotter, options)
        look = _look_of(plotter, packing, options)
        shown = _add(plotter, packing, look, options)
        _aim(plotter, packing, shown, options)
        if options.technique == "raycast":
            save_ray_cast(plotter, packing, look, options)
        elif options.technique == "pathtrace":
            save_path_trace(plotter, packing, look, options)
        else:
            plotter.renderer.ResetCameraClippingRange()
            plotter.packing.screenshot(options.output, transparent_background=options.transparent)
    finally:
        plotter.close()


def _check(options: RenderOptions) -> None:
    """Raise an exception for what is known to be wrong before anything is read."""
    check_technique(options)
    check_output(options.output)
    check_view(options)
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


def _look_of(plotter: pv.Plotter, packing: pv.PolyData, options: RenderOptions) -> Look:
    """The look that was asked for, and else one that suits the radii."""
    scalars, clim = options.scalars, options.clim
    color: ColorLike | None = options.color
    if scalars is not None and scalars not in packing.point_data:
        there = ", ".join(packing.point_data.keys())
        raise ValueError(f"--scalars: found no array {scalars!r}, expected one of: {there}")
    log_scale = options.log_scale
    unasked = scalars is None and options.cmap is None and clim is None
    if color is None and unasked and _all_alike(packing):
        color = plotter.theme.color
    if log_scale is None and color is None and scalars in (None, "radius"):
        log_scale, clim = _radius_scale(packing, clim)
    return Look(
        scalars=scalars, cmap=options.cmap, clim=clim, log_scale=bool(log_scale), color=color
    )


def _all_alike(packing: pv.PolyData) -> bool:
    """Whether the radii are equal, so that there is nothing to colour by."""
    radii = packing.point_data["radius"]
    return not len(radii) or radii.min() == radii.max()


def _radius_scale(
    packing: pv.PolyData, clim: tuple[float, float] | None
) -> tuple[bool, tuple[float, float] | None]:
    """Whether the radii call for a logarithmic scale, and the range of the colour map."""
    radii = packing.point_data["radius"]
    positive = radii[radii > 0.0]
    if not positive.size or positive.max() <= _WIDE * positive.min():
        return False, clim
    # Zero has no logarithm, and nothing that is drawn has that radius.
    return True, clim or (float(positive.min()), float(positive.max()))


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
        show_scalar_bar=options.scalar_bar and not traced,
        scalar_bar_args=_SCALAR_BAR,
    )
    if options.technique in ("bvh", "grid"):
        return add_boxes(plotter, packing, options)
    return packing


def _aim(
    plotter: pv.Plotter, packing: pv.PolyData, shown: pv.PolyData, options: RenderOptions
) -> None:
    """Place the camera, and let the spheres of `shown` fill the picture if it was not placed."""
    camera = plotter.camera
    aim(camera, options.camera, options.focal, options.up)
    if options.view_angle is not None:
        camera.view_angle = options.view_angle
    elif options.camera is None and options.focal is None and packing.n_points:
        # The scalar bar needs room at the bottom, in pixels, since its letters do.
        room = 110.0 / options.size[1] if len(plotter.scalar_bars) else 0.04
        fit(camera, shown, options.size, max(1.0 - 2.0 * room, 0.5))
    if options.parallel:
        plotter.enable_parallel_projection()  # type: ignore[call-arg]  # as enable_depth_peeling
    camera.zoom(options.zoom)
