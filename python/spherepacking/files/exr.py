"""Path-traced pictures as files of many channels."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .image import write_channels, write_image

if TYPE_CHECKING:
    import os

    import pyvista as pv

_LAYERS = {
    "radiance": ("R", "G", "B"),
    "coverage": ("coverage.A",),
    "denoised": ("denoised.R", "denoised.G", "denoised.B"),
    "albedo": ("albedo.R", "albedo.G", "albedo.B"),
    "normal": ("normal.X", "normal.Y", "normal.Z"),
    "depth": ("Z",),
    "variance": ("variance.Y",),
    "samples": ("samples.Y",),
}
_FIELDS = ("camera", "view_angle", "parallel_scale", "seed", "max_bounces", "reflectance")
_HALF = 2**16


def write_render(path: str | os.PathLike[str], image: pv.ImageData) -> None:
    """Write a picture of ``packing.packing.path_trace``: all of it as EXR, else its colours.

    Parameters
    ----------
    path : str or os.PathLike
        File to write. With ``.exr`` its channels, single precision, are ``R``, ``G``, ``B`` (the
        radiance, linear), ``coverage.A``, ``denoised.R`` and so on if there is one, ``albedo.R``,
        ``normal.X``, ``Z`` (the depth), ``variance.Y``, ``samples.Y``, and
        ``sphere_id.high`` and ``sphere_id.low``, of which the id is 65536 high + low. Attributes
        tell version, samples, seed, camera and how paths went. Other formats get ``color``, without
        its opacity where there is nothing to be seen through.
    image : pyvista.ImageData
        The picture.

    Raises
    ------
    OSError
        If the file cannot be written; an earlier one is as it was.
    ValueError
        If no format has that extension, or `image` is no such picture.

    Examples
    --------
    >>> import spherepacking
    >>> packing = spherepacking.apollonian(2)
    >>> view = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]
    >>> image = packing.packing.path_trace(view, (64, 64), samples=1)
    >>> spherepacking.write_render("apollonian.exr", image)
    """
    path = Path(path).expanduser()
    missing = {"radiance", "color", "sphere_id"} - set(image.point_data.keys())
    if missing:
        raise ValueError(
            f"image: found no point array {min(missing)!r}, expected a picture of path_trace"
        )
    width, height, _ = image.dimensions
    if path.suffix.lower() != ".exr":
        write_image(path, opaque(np.asarray(image["color"]).reshape(height, width, 4)[::-1]))
        return
    names, columns = [], []
    for array, channels in _LAYERS.items():
        if array in image.point_data:
            names.extend(channels)
            columns.append(np.asarray(image[array], np.float32).reshape(-1, len(channels)))
    high, low = np.divmod(np.asarray(image["sphere_id"]), _HALF)
    names.extend(["sphere_id.high", "sphere_id.low"])
    columns.append(np.column_stack([high, low]).astype(np.float32))
    pixels = np.concatenate(columns, axis=1).reshape(height, width, -1)[::-1]
    write_channels(path, np.ascontiguousarray(pixels), names, _attributes_of(image))


def opaque(pixels: np.ndarray) -> np.ndarray:
    """Leave out an alpha channel that says nothing, and which some formats have no room for."""
    return pixels[..., :3] if (pixels[..., 3] == 255).all() else pixels


def _attributes_of(image: pv.ImageData) -> dict[str, str | float]:
    from .. import __version__

    attributes = {
        "Software": f"spherepacking {__version__}",
        "spherepacking:samples": int(np.max(image["samples"])),
    }
    for name in _FIELDS:
        if name not in image.field_data:
            continue
        values = np.asarray(image.field_data[name])
        if name == "camera":
            for part, point in zip(("position", "focal_point", "view_up"), values, strict=True):
                attributes[f"spherepacking:camera_{part}"] = " ".join(repr(float(x)) for x in point)
        elif np.isfinite(values[0]):
            attributes[f"spherepacking:{name}"] = values[0].item()
    return attributes
