"""Path-traced pictures as OpenEXR files with all their layers."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .image import write_channels, write_image

if TYPE_CHECKING:
    import os

    import pyvista as pv

# Channels of each point array.
_CHANNELS = {
    "radiance": ("R", "G", "B"),
    "coverage": ("coverage.A",),
    "denoised": ("denoised.R", "denoised.G", "denoised.B"),
    "albedo": ("albedo.R", "albedo.G", "albedo.B"),
    "normal": ("normal.X", "normal.Y", "normal.Z"),
    "depth": ("Z",),
    "variance": ("variance.Y",),
    "samples": ("samples.Y",),
}
# Field arrays that become attributes.
_ATTRIBUTES = ("camera", "view_angle", "parallel_scale", "seed", "max_bounces", "reflectance")
# Single precision holds integers up to 2**24, so ids are split in two.
_ID_BASE = 2**16


def write_render(path: str | os.PathLike[str], image: pv.ImageData) -> None:
    """Write a picture of ``packing.packing.path_trace``: all of it as EXR, else its colours.

    Parameters
    ----------
    path : str or os.PathLike
        File to write. An ``.exr`` file has these channels, in single precision:

        - ``R``, ``G``, ``B``: the radiance, linear
        - ``coverage.A``
        - ``denoised.R``, ``.G``, ``.B``, if the picture has been denoised
        - ``albedo.R``, ``.G``, ``.B``
        - ``normal.X``, ``.Y``, ``.Z``
        - ``Z``: the depth
        - ``variance.Y``
        - ``samples.Y``
        - ``sphere_id.high``, ``sphere_id.low``: the id is 65536 high + low

        Its attributes hold version, samples, seed, camera and what else made the picture. Files of
        other formats hold ``color``, without alpha where all pixels are opaque.
    image : pyvista.ImageData
        The picture.

    Raises
    ------
    OSError
        If the file cannot be written; an earlier one is left as it was.
    ValueError
        If no format has that extension, or `image` is not such a picture.

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
    names: list[str] = []
    columns: list[np.ndarray] = []
    for array, channels in _CHANNELS.items():
        if array in image.point_data:
            names.extend(channels)
            columns.append(np.asarray(image[array], np.float32).reshape(-1, len(channels)))
    high, low = np.divmod(np.asarray(image["sphere_id"]), _ID_BASE)
    names.extend(["sphere_id.high", "sphere_id.low"])
    columns.append(np.column_stack([high, low]).astype(np.float32))
    pixels = np.concatenate(columns, axis=1).reshape(height, width, -1)[::-1]
    write_channels(path, np.ascontiguousarray(pixels), names, _attributes_of(image))


def opaque(pixels: np.ndarray) -> np.ndarray:
    """Leave out an alpha channel that is opaque everywhere, which not all formats can hold."""
    return pixels[..., :3] if (pixels[..., 3] == 255).all() else pixels


def _attributes_of(image: pv.ImageData) -> dict[str, str | float]:
    from .. import __version__

    attributes: dict[str, str | float] = {
        "Software": f"spherepacking {__version__}",
        "spherepacking:samples": int(np.max(image["samples"])),
    }
    for name in _ATTRIBUTES:
        if name not in image.field_data:
            continue
        values = np.asarray(image.field_data[name])
        if name == "camera":
            for part, point in zip(("position", "focal_point", "view_up"), values, strict=True):
                attributes[f"spherepacking:camera_{part}"] = " ".join(repr(float(x)) for x in point)
        elif np.isfinite(values[0]):
            attributes[f"spherepacking:{name}"] = values[0].item()
    return attributes
