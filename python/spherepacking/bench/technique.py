"""What a benchmark measures: a technique, and what it shows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    import pyvista as pv
    from numpy.typing import NDArray


class Seen(NamedTuple):
    """What a technique shows; rows from the bottom, as VTK."""

    sphere_id: NDArray[np.int64]
    """Which sphere, -1 for none; ``(height, width)``."""
    depth: NDArray[np.float64]
    """Distance from the camera along the direction of view; ``(height, width)``."""
    color: NDArray[np.uint8] | None = None
    """RGBA, if it can be compared with that of other techniques; ``(height, width, 4)``."""


class Subject(Protocol):
    """A technique that is ready to make pictures of one packing."""

    build_seconds: float
    """How long its structure took to build, NaN if it has none."""
    memory_bytes: float
    """Of its structure, NaN if it has none."""

    def frame(self) -> None:
        """Make the picture."""

    def seen(self) -> Seen:
        """Return what the picture shows."""

    def close(self) -> None:
        """Free what it holds."""


@dataclass(frozen=True)
class Technique:
    """What can be measured."""

    name: str
    structure: str
    """How rays find spheres; empty for techniques without rays."""
    rays: int
    """Rays or samples per pixel."""
    prepare: Callable[[pv.PolyData, pv.Camera, tuple[int, int]], Subject]
    """Makes a subject of a packing, a camera and the picture's size in pixels."""
    once: bool = False
    """Whether one number of spheres is enough, because it takes long."""

    @property
    def label(self) -> str:
        """Name, structure and rays in a few words."""
        return label_of(self.name, self.structure, self.rays)


def label_of(name: str, structure: str, rays: int) -> str:
    """Say in a few words which technique it is."""
    unit = "paths" if name == "path trace" else "rays"
    parts = [name, structure, f"{rays} {unit}" if rays > 1 else ""]
    return ", ".join(part for part in parts if part)
