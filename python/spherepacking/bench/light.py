"""How far the light of a path-traced picture is from that of very many samples."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..accessor import PackingAccessor
from .rays import LIGHT

if TYPE_CHECKING:
    import pyvista as pv
    from numpy.typing import NDArray

SAMPLES = 4096
"""Samples per pixel of the picture that others are compared with."""
SHRINK = 4
"""By what width and height are divided where light is compared, since that picture takes long."""
_DARKEST = 0.01
_SEED = 4096


def size_of_reference(size: tuple[int, int]) -> tuple[int, int]:
    """Width and height in pixels where light is compared, for pictures of `size`."""
    return max(size[0] // SHRINK, 1), max(size[1] // SHRINK, 1)


def reference(packing: pv.PolyData, camera: pv.Camera, size: tuple[int, int]) -> pv.ImageData:
    """Trace the picture that others are compared with.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    camera : pyvista.Camera
        Camera.
    size : (int, int)
        Of the pictures that time is measured with.

    Returns
    -------
    pyvista.ImageData
        Of the smaller size, with a seed that no measurement has.
    """
    return PackingAccessor(packing).path_trace(
        camera, size_of_reference(size), samples=SAMPLES, seed=_SEED, **LIGHT
    )


def relative_mse(radiance: NDArray[np.float32], exact: NDArray[np.float32]) -> float:
    """Mean of the squared difference over the squared light, dark parts weighed as if at 0.1."""
    ours, theirs = np.asarray(radiance, float), np.asarray(exact, float)
    return float(np.mean((ours - theirs) ** 2 / (theirs**2 + _DARKEST)))


def flip(image: pv.ImageData, exact: pv.ImageData) -> float:
    """Mean of the FLIP error of the colours, 0 to 1; NaN without the package ``flip-evaluator``.

    Source: Andersson et al., "FLIP: A Difference Evaluator for Alternating Images" (2020).
    """
    try:
        import flip_evaluator
    except ImportError:
        return np.nan
    width, height, _ = image.dimensions
    pictures = (
        np.asarray(i["color"])[:, :3].reshape(height, width, 3)[::-1].astype(np.float32) / 255.0
        for i in (exact, image)
    )
    _, mean, _ = flip_evaluator.evaluate(*pictures, "LDR", applyMagma=False)
    return float(mean)
