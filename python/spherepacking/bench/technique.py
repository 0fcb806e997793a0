"""The techniques of this package, as the benchmark sees them."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, Protocol

import numpy as np
import pyvista as pv

from ..accessor import PackingAccessor
from ..testing import accuracy
from ..testing.scenes import depths_of

if TYPE_CHECKING:
    from collections.abc import Callable

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
    """How rays find spheres, empty where that is no question."""
    rays: int
    """Rays or samples a pixel."""
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
    words = [name, structure, f"{rays} {unit}" if rays > 1 else ""]
    return ", ".join(word for word in words if word)


LIGHT = {"scalars": "radius", "sky": 1.0, "max_bounces": 4, "albedo": 0.8}
"""Of the scene that paths are traced in, as arguments of ``packing.packing.path_trace``."""
PATH_SAMPLES = (1, 4, 16, 64, 256)


def _structure_of(fields: pv.DataSetAttributes, structure: str) -> tuple[float, float]:
    """Seconds and bytes that a picture's structure took, NaN without one."""
    if structure == "none":
        return np.nan, np.nan
    return float(fields["build_seconds"][0]), float(fields["memory_bytes"][0])


class RayCast:
    """Pictures of ``packing.packing.ray_cast``."""

    def __init__(
        self,
        packing: pv.PolyData,
        camera: pv.Camera,
        size: tuple[int, int],
        structure: str,
        samples: int,
    ) -> None:
        # Not that of the packing, which would outlive it under some versions of PyVista.
        self._spheres = PackingAccessor(packing)
        self._words = {
            "camera": camera,
            "window_size": size,
            "structure": structure,
            "samples": samples,
            "scalars": "radius",
        }
        self._image = None
        self.frame()
        fields = self._image.field_data
        self.build_seconds, self.memory_bytes = _structure_of(fields, structure)

    def frame(self) -> None:
        """Cast the rays."""
        self._image = self._spheres.ray_cast(**self._words)

    def seen(self) -> Seen:
        """Return what the last rays hit."""
        width, height = self._words["window_size"]
        return Seen(
            np.asarray(self._image["sphere_id"]).reshape(height, width),
            np.asarray(self._image["depth"], dtype=float).reshape(height, width),
            np.asarray(self._image["color"]).reshape(height, width, 4),
        )

    def close(self) -> None:
        """Let the structure go."""
        self._image = self._spheres = None


class PathTrace:
    """Pictures of ``packing.packing.path_trace``, each from the start."""

    def __init__(
        self,
        packing: pv.PolyData,
        camera: pv.Camera,
        size: tuple[int, int],
        structure: str,
        samples: int,
    ) -> None:
        self._spheres = PackingAccessor(packing)
        self._words = LIGHT | {"camera": camera, "structure": structure, "samples": samples}
        self._size = size
        self._seed = 0
        self._image = None
        # The structure and a picture of the least size.
        fields = self._spheres.path_trace(window_size=(1, 1), **self._words).field_data
        self.build_seconds, self.memory_bytes = _structure_of(fields, structure)

    def frame(self) -> None:
        """Trace the paths, others than the last time."""
        self._seed += 1
        self._image = self._spheres.path_trace(
            window_size=self._size, seed=self._seed, **self._words
        )

    def seen(self) -> Seen:
        """Return what the middles of the pixels show."""
        if self._image is None:
            self.frame()
        width, height = self._size
        return Seen(
            np.asarray(self._image["sphere_id"]).reshape(height, width),
            np.asarray(self._image["depth"], dtype=float).reshape(height, width),
        )

    def light(self, size: tuple[int, int]) -> pv.ImageData:
        """Trace a picture of another size, whose light can be compared."""
        return self._spheres.path_trace(window_size=size, **self._words)

    def close(self) -> None:
        """Let the structure and the picture go."""
        self._image = self._spheres = None


class Window:
    """Frames of an offscreen window with one headlight and one sample a pixel.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    camera : pyvista.Camera
        Camera to copy.
    size : (int, int)
        Width and height in pixels.
    add : callable
        Adds the packing to a plotter, coloured by the given array, or by the radii if it is None.
    """

    def __init__(
        self,
        packing: pv.PolyData,
        camera: pv.Camera,
        size: tuple[int, int],
        add: Callable[[pv.Plotter, pv.PolyData, NDArray[np.uint8] | None], None],
    ) -> None:
        self.build_seconds = self.memory_bytes = np.nan
        self._make = lambda colors: _show(packing, camera, size, add, colors)
        self._plotter = self._make(None)

    def frame(self) -> None:
        """Render and wait until it is done."""
        self._plotter.render_window.MakeCurrent()
        self._plotter.render()
        self._plotter.render_window.WaitForCompletion()

    def seen(self) -> Seen:
        """Draw once more, in colours that say which sphere it is."""
        plotter = self._make(accuracy.id_colors)
        try:
            drawn = accuracy.read(plotter)
            return Seen(drawn.sphere_id, _eye_depth(plotter, drawn.depth))
        finally:
            plotter.close()

    def close(self) -> None:
        """Close the window."""
        self._plotter.close()


def _show(
    packing: pv.PolyData,
    camera: pv.Camera,
    size: tuple[int, int],
    add: Callable[[pv.Plotter, pv.PolyData, NDArray[np.uint8] | None], None],
    colors: Callable[[int], NDArray[np.uint8]] | None,
) -> pv.Plotter:
    plotter = pv.Plotter(off_screen=True, window_size=size, lighting="none")
    plotter.render_window.SetMultiSamples(0)
    plotter.set_background("black")
    plotter.add_light(pv.Light(light_type="headlight"))
    add(plotter, packing, None if colors is None else colors(packing.n_points))
    plotter.camera.position = camera.position
    plotter.camera.focal_point = camera.focal_point
    plotter.camera.up = camera.up
    plotter.camera.view_angle = camera.view_angle
    # Not all mappers know how far their spheres reach.
    depths = depths_of(packing, camera)
    plotter.show(auto_close=False, interactive=False)
    plotter.camera.clipping_range = depths
    plotter.render()
    return plotter


def _eye_depth(plotter: pv.Plotter, depth: NDArray[np.float64]) -> NDArray[np.float64]:
    """Distances along the direction of view of depth buffer values, in perspective."""
    near, far = plotter.camera.clipping_range
    return near * far / (far - depth * (far - near))


def _add_spheres(
    plotter: pv.Plotter, packing: pv.PolyData, colors: NDArray[np.uint8] | None
) -> None:
    look = {"scalars": "radius"} if colors is None else {"scalars": colors, "rgb": True}
    plotter.packing.add(packing, **look, lighting=colors is None, show_scalar_bar=False)


def own() -> list[Technique]:
    """Return the techniques of this package."""
    made = [Technique("OpenGL", "", 1, lambda *view: Window(*view, _add_spheres))]
    for structure, samples in (("bvh", 1), ("bvh", 2), ("bvh", 3), ("grid", 1), ("none", 1)):
        made.append(
            Technique(
                "ray cast",
                structure,
                samples**2,
                lambda *view, how=(structure, samples): RayCast(*view, *how),
            )
        )
    for samples in PATH_SAMPLES:
        made.append(
            Technique(
                "path trace",
                "bvh",
                samples,
                lambda *view, samples=samples: PathTrace(*view, "bvh", samples),
                once=True,
            )
        )
    return made


def everything() -> list[Technique]:
    """Return the techniques of this package and of all others that are there."""
    from . import peers

    made = [*own(), *peers.vtk()]
    with suppress(ImportError):
        from . import embree

        made.extend(embree.techniques())
    return made
