"""How far a drawn picture is from float64 rays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..vtk_tools import window_of

if TYPE_CHECKING:
    import pyvista as pv
    from numpy.typing import NDArray

    from .reference import Picture


LARGEST_COUNT = (1 << 24) - 1
"""Number of spheres that the colours of a picture tell apart, without black."""


@dataclass(frozen=True)
class Drawn:
    """What a window shows; rows from the bottom, as VTK."""

    sphere_id: NDArray[np.int64]
    depth: NDArray[np.float64]
    depth_bits: int


@dataclass(frozen=True)
class Errors:
    """Differences of a drawn picture from float64 rays."""

    hit_pixels: int
    """Pixels that the reference hits."""
    silhouette_wrong: int
    """Pixels where one picture has a sphere and the other has none."""
    sphere_wrong: int
    """Pixels where both have a sphere, but not the same one."""
    depth_steps_median: float
    """Median depth error in steps of the depth buffer over pixels that both hit."""
    depth_steps_999: float
    """The error in steps that 99.9 % of these pixels do not exceed."""

    @property
    def silhouette_allowed(self) -> int:
        """The bar: 1e-5 of the hit pixels, and one pixel more."""
        return int(1e-5 * self.hit_pixels) + 1

    @property
    def good(self) -> bool:
        """Whether silhouette and depth are within the bars."""
        return self.silhouette_wrong <= self.silhouette_allowed and self.depth_steps_999 <= 2.0


def id_colors(count: int) -> NDArray[np.uint8]:
    """Return an RGB colour per sphere from which :func:`read` finds the sphere again."""
    if count > LARGEST_COUNT:
        raise ValueError(f"count: found {count}, expected up to {LARGEST_COUNT} spheres")
    codes = np.arange(1, count + 1)
    return np.stack([codes & 255, (codes >> 8) & 255, codes >> 16], axis=1).astype(np.uint8)


def read(plotter: pv.Plotter) -> Drawn:
    """Read sphere ids and depths from a plotter that shows :func:`id_colors` unlit on black."""
    window = window_of(plotter)
    width, height = window.GetSize()
    image = np.asarray(plotter.screenshot(return_img=True, transparent_background=False))
    codes = image[::-1, :, :3].astype(np.int64) @ np.array([1, 256, 65536])
    depth = np.asarray(window_depth(plotter)).reshape(height, width)
    return Drawn(codes - 1, depth.astype(np.float64), window.GetDepthBufferSize())


def window_depth(plotter: pv.Plotter) -> NDArray[np.float32]:
    """Return the depth buffer's values."""
    import pyvista as pv

    window = window_of(plotter)
    width, height = window.GetSize()
    values = pv._vtk.vtkFloatArray()
    window.GetZbufferData(0, 0, width - 1, height - 1, values)
    return pv.convert_array(values)


def compare(drawn: Drawn, expected: Picture) -> Errors:
    """Compare a drawn picture with the reference."""
    drawn_hit = drawn.sphere_id >= 0
    hit = expected.sphere_id >= 0
    both = drawn_hit & hit
    steps = np.abs(drawn.depth - expected.depth)[both] * (2.0**drawn.depth_bits - 1.0)
    return Errors(
        hit_pixels=int(hit.sum()),
        silhouette_wrong=int((drawn_hit != hit).sum()),
        sphere_wrong=int((both & (drawn.sphere_id != expected.sphere_id)).sum()),
        depth_steps_median=float(np.median(steps)) if steps.size else 0.0,
        depth_steps_999=float(np.quantile(steps, 0.999)) if steps.size else 0.0,
    )
