"""The techniques of the command ``render`` beside drawing spheres with OpenGL."""

from __future__ import annotations

import sys
import warnings
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from ..accessor import PackingAccessor
from ..files.exr import write_render
from ..files.image import write_image
from ..trace.sky import Sun

if TYPE_CHECKING:
    from pathlib import Path


def add_boxes(
    plotter: pv.Plotter, packing: pv.PolyData, technique: str, boxes: int, cuts: int
) -> pv.PolyData:
    """Add the edges of the boxes of a structure to the scene.

    Parameters
    ----------
    plotter : pyvista.Plotter
        Scene to add to.
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    technique : {"bvh", "grid"}
        Structure.
    boxes : int
        Number of leaf boxes of the hierarchy.
    cuts : int
        How often the grid cuts each axis.

    Returns
    -------
    pyvista.PolyData
        What the picture has to show: the corners, as spheres of radius 0.
    """
    if technique == "bvh":
        lines = PackingAccessor(packing).bvh_boxes(boxes, as_lines=True)
    else:
        lines = PackingAccessor(packing).grid_boxes(cuts, as_lines=True)
    if not lines.n_points:
        return packing
    plotter.add_mesh(lines, color="black", line_width=2.0, lighting=False, show_scalar_bar=False)
    corners = pv.PolyData(np.asarray(lines.points))
    corners["radius"] = np.zeros(corners.n_points)
    return corners


def add_metaballs(
    plotter: pv.Plotter, packing: pv.PolyData, words: dict[str, object]
) -> pv.PolyData:
    """Add the surface of metaballs to the scene.

    Parameters
    ----------
    plotter : pyvista.Plotter
        Scene to add to.
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    words : dict
        Arguments of ``plotter.packing.add_metaballs``.

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
            balls = plotter.packing.add_metaballs(packing, **words)
        except UserWarning as empty:
            raise ValueError(f"--threshold: {empty}") from None
    points = pv.PolyData(np.asarray(balls.surface.points))
    points["radius"] = np.zeros(points.n_points)
    return points


def save_ray_cast(
    plotter: pv.Plotter,
    packing: pv.PolyData,
    output: Path,
    transparent: bool,
    words: dict[str, object],
) -> None:
    """Cast the rays of the plotter's camera and save the picture.

    Parameters
    ----------
    plotter : pyvista.Plotter
        Its camera and background are used.
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    output : pathlib.Path
        Picture to write.
    transparent : bool
        Keep the alpha channel instead of mixing with the background.
    words : dict
        Arguments of ``packing.packing.ray_cast``.
    """
    image = PackingAccessor(packing).ray_cast(plotter.camera, progress=sys.stderr.isatty(), **words)
    pixels = _pixels_of(image)
    write_image(output, pixels if transparent else _over(plotter, pixels))


def save_path_trace(
    plotter: pv.Plotter,
    packing: pv.PolyData,
    output: Path,
    behind: str,
    words: dict[str, object],
) -> None:
    """Trace paths from the plotter's camera and save the picture.

    Parameters
    ----------
    plotter : pyvista.Plotter
        Its camera is used, and its background.
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    output : pathlib.Path
        Picture to write.
    behind : {"sky", "background", "nothing"}
        What is behind the spheres.
    words : dict
        Arguments of ``packing.packing.path_trace``.
    """
    image = PackingAccessor(packing).path_trace(
        plotter.camera, progress=sys.stderr.isatty(), sky_visible=behind == "sky", **words
    )
    if behind == "background" and output.suffix.lower() != ".exr":
        write_image(output, _over(plotter, _pixels_of(image)))
    else:
        write_render(output, image)


def _pixels_of(image: pv.ImageData) -> np.ndarray:
    """RGBA (height, width, 4), the upper row first."""
    width, height, _ = image.dimensions
    return np.asarray(image["color"]).reshape(height, width, 4)[::-1]


def _over(plotter: pv.Plotter, pixels: np.ndarray) -> np.ndarray:
    share = pixels[..., 3:] / 255.0
    background = np.array(plotter.background_color.int_rgb)
    return np.round(share * pixels[..., :3] + (1.0 - share) * background).astype(np.uint8)


def light_of(
    sky: list[str] | None,
    sun: tuple[float, float, float] | None,
    sun_radiance: float,
    sun_diameter: float,
) -> dict[str, object]:
    """Sky and sun of the command line as arguments of ``packing.packing.path_trace``.

    Parameters
    ----------
    sky : list of str, optional
        One, two or three numbers, or the name of a file.
    sun : (float, float, float), optional
        Direction towards the sun.
    sun_radiance, sun_diameter : float
        As in :class:`spherepacking.Sun`.
    """
    words = {"sun": sun if sun is None else Sun(sun, sun_radiance, sun_diameter)}
    if sky is None:
        return words
    try:
        numbers = [float(word) for word in sky]
    except ValueError:
        if len(sky) > 1:
            raise ValueError(
                f"--sky: found {' '.join(sky)}, expected one, two or three numbers, or a file"
            ) from None
        return words | {"sky": sky[0]}
    if len(numbers) > 3:
        raise ValueError(f"--sky: found {len(numbers)} numbers, expected one, two or three")
    return words | {"sky": numbers[0] if len(numbers) == 1 else numbers}
