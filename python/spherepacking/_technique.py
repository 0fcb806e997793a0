"""The techniques of the command ``render`` beside drawing spheres with OpenGL."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .accessor import PackingAccessor
from .image import write_image

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
    width, height = words["window_size"]
    pixels = np.asarray(image["color"]).reshape(height, width, 4)[::-1]
    if not transparent:
        share = pixels[..., 3:] / 255.0
        background = np.array(plotter.background_color.int_rgb)
        pixels = np.round(share * pixels[..., :3] + (1.0 - share) * background).astype(np.uint8)
    write_image(output, pixels)
