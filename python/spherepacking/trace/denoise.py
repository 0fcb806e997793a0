"""Path-traced pictures without their noise, by Open Image Denoise (the extra ``denoise``)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    import pyvista as pv


def denoiser() -> Callable[..., np.ndarray]:
    """Return Open Image Denoise's function, or raise an ImportError that says what to install."""
    try:
        from pyoidn import denoise
    except (ImportError, OSError) as error:
        raise ImportError(
            f"denoise: Open Image Denoise cannot be loaded ({error}), expected the extra 'denoise':"
            " pip install 'spherepacking[denoise]'"
        ) from error
    return denoise


def denoised(image: pv.ImageData) -> np.ndarray:
    """Estimate what the radiance would be without noise.

    Parameters
    ----------
    image : pyvista.ImageData
        Picture of ``packing.packing.path_trace``.

    Returns
    -------
    numpy.ndarray
        (pixels, 3), float32, linear.
    """
    width, height, _ = image.dimensions
    # Upstream: pyoidn 2.5 keeps what it was given until the next call; copies, so that it keeps no
    # arrays of VTK alive.
    color, albedo, normal = (
        np.array(image[name], np.float32, subok=False).reshape(height, width, 3)
        for name in ("radiance", "albedo", "normal")
    )
    return denoiser()(color, albedo, normal, hdr=True).reshape(-1, 3)
