"""What ``spherepacking render`` makes of its options."""

from __future__ import annotations

import math

from ..checks import color_of

# In the middle at the bottom. With four labels, none of them is below the title and touches it.
SCALAR_BAR = {
    "n_labels": 4,
    "fmt": "%.3g",
    "width": 0.6,
    "height": 0.09,
    "position_x": 0.2,
    "position_y": 0.02,
}


def set_background(plotter: object, background: str | None) -> None:
    """Set the colour behind the spheres, if one was asked for."""
    if background is not None:
        plotter.set_background(color_of("--background", background))


def set_quality(plotter: object, opacity: float, anti_aliasing: bool) -> None:
    """Smooth edges, and mix what is seen through one another in the right order."""
    if opacity < 1.0:
        # Neither several samples a pixel nor VTK's larger picture go with peeling.
        plotter.render_window.SetMultiSamples(1)
        plotter.enable_depth_peeling()
    if anti_aliasing and opacity < 1.0:
        # Not enable_anti_aliasing: with EGL and OSMesa PyVista warns, and takes the larger picture.
        plotter.render_window.SetMultiSamples(0)
        plotter.renderer.SetUseFXAA(True)
    elif anti_aliasing:
        plotter.enable_anti_aliasing("ssaa")


def look_of(
    plotter: object,
    spheres: object,
    scalars: str | None,
    cmap: str | None,
    clim: tuple[float, float] | None,
    log_scale: bool | None,
    color: str | None,
) -> dict[str, object]:
    """The look that was asked for, and else one that suits the radii."""
    if scalars is not None and scalars not in spheres.point_data:
        there = ", ".join(spheres.point_data.keys())
        raise ValueError(f"--scalars: found no array {scalars!r}, expected one of: {there}")
    unasked = scalars is None and cmap is None and clim is None
    if color is None and unasked and _all_alike(spheres):
        color = plotter.theme.color
    if log_scale is None and color is None and scalars in (None, "radius"):
        log_scale, clim = _radius_scale(spheres, clim)
    return {
        "scalars": scalars,
        "cmap": cmap,
        "clim": clim,
        "log_scale": bool(log_scale),
        "color": color,
    }


def _all_alike(packing: object) -> bool:
    """Whether the radii are equal, so that they give nothing to colour by."""
    radii = packing.point_data["radius"]
    return not len(radii) or radii.min() == radii.max()


def _radius_scale(
    packing: object, clim: tuple[float, float] | None
) -> tuple[bool, tuple[float, float] | None]:
    """Whether the radii call for a logarithmic scale, and the range of the colour map."""
    radii = packing.point_data["radius"]
    positive = radii[radii > 0.0]
    if not positive.size or positive.max() <= 20.0 * positive.min():
        return False, clim
    # Zero has no logarithm, and nothing that is drawn has that radius.
    return True, clim or (float(positive.min()), float(positive.max()))


def check_view(
    size: tuple[int, int], zoom: float, view_angle: float | None, anti_aliasing: bool
) -> None:
    """Raise a ValueError if there is no such picture."""
    # OpenGL draws into textures, of which every implementation has 16384 pixels along a side;
    # smoothing draws twice as many.
    largest = 8192 if anti_aliasing else 16384
    if min(size) < 1 or max(size) > largest:
        raise ValueError(
            f"--size: found {size[0]} {size[1]}, expected numbers of pixels from 1 to {largest}"
        )
    if not 0.0 < zoom < math.inf:
        raise ValueError(f"--zoom: found {zoom}, expected a finite number above 0")
    if view_angle is not None and not 0.0 < view_angle < 180.0:
        raise ValueError(f"--view-angle: found {view_angle}, expected degrees from 0 to 180")


# What other techniques have no use for.
_TECHNIQUES = {
    "samples": ("raycast", "pathtrace"),
    "structure": ("raycast", "pathtrace"),
    "boxes": ("bvh",),
    "cuts": ("grid",),
    **dict.fromkeys(
        ("max_bounces", "albedo", "sky", "sun", "sun_radiance", "sun_diameter", "seed"),
        ("pathtrace",),
    ),
    **dict.fromkeys(
        ("time_budget", "noise_target", "exposure", "filmic", "denoise"), ("pathtrace",)
    ),
    **dict.fromkeys(("threshold", "kernel", "weights", "count", "dimensions"), ("metaballs",)),
}


def check_technique(given: dict[str, object], defaults: dict[str, object]) -> None:
    """Refuse options that the technique has no use for.

    Parameters
    ----------
    given : dict
        Options of ``render``, by their names in Python.
    defaults : dict
        The same with their defaults.

    Raises
    ------
    ValueError
        If there is such an option.
    """
    for name, techniques in _TECHNIQUES.items():
        if given["technique"] not in techniques and given[name] != defaults[name]:
            raise ValueError(
                f"--{name.replace('_', '-')}: found with --technique {given['technique']}, "
                f"expected --technique {' or '.join(techniques)}"
            )
    for name in ("sun_radiance", "sun_diameter"):
        if given["sun"] is None and given[name] != defaults[name]:
            raise ValueError(f"--{name.replace('_', '-')}: found no --sun, expected one")
