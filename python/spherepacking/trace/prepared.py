"""A C++ tracer that is prepared anew only for what has changed."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import numpy as np
import pyvista as pv

from .. import checks
from ..packing import ChangeDetector, check_radii
from ..vtk_tools import update

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ..backend import vtkCamera, vtkDataArray, vtkSpherePackingTracer
    from ..look.look import Look

    type CameraLike = pv.Camera | vtkCamera | Sequence[Sequence[float]]

STRUCTURES = ("none", "grid", "bvh")


class PreparedTracer[Tracer: vtkSpherePackingTracer]:
    """A tracer that keeps its acceleration structure for as long as the packing does not change.

    Parameters
    ----------
    make : callable
        Makes the tracer, when it is first used.
    label : str
        What the progress bar says.
    white_by_default : bool, default: False
        Whether spheres are white if nothing is said, instead of as the plotter draws them.
    hash_contents : bool, default: False
        Whether to look for changes of all centres, radii and scalars each time, as a tracer needs
        that goes on with its picture, which would mix packings.

    Attributes
    ----------
    lock : threading.Lock
        Held from :meth:`prepare` to the end of the work: while the tracer works Python code runs,
        and so may other threads.
    """

    def __init__(
        self,
        make: Callable[[], Tracer],
        label: str,
        *,
        white_by_default: bool = False,
        hash_contents: bool = False,
    ) -> None:
        self.lock = threading.Lock()
        self._make = make
        self._label = label
        self._white_by_default = white_by_default
        self._hash_contents = hash_contents
        self._changes = ChangeDetector(hash_contents=hash_contents)
        self._tracer: Tracer | None = None
        # When the centres and radii of the tracer were last changed, and what its colours depend
        # on: checking and colouring again take as long as casting rays.
        self._geometry: tuple[int, int, int] | None = None
        self._look_key: tuple[object, ...] | None = None
        self._colors: vtkDataArray | None = None

    def prepare(
        self,
        packing: pv.PolyData,
        camera: CameraLike,
        window_size: Sequence[int],
        structure: str = "bvh",
        cuts: int | None = None,
    ) -> Tracer:
        """Check the arguments and hand them to the tracer."""
        structure = checks.one_of("structure", structure, STRUCTURES)
        if cuts is not None:
            cuts = checks.count_of("cuts", cuts, least=0)
        size = checks.size_of("window_size", window_size, most=checks.LARGEST_TRACED_SIDE)
        camera = camera_of(camera)
        if self._tracer is not None and not self._hash_contents:
            self._tracer.NoticeChanges()
        times = self._changes.modified_times(packing)
        geometry = None if times is None else times.geometry
        if geometry is None or geometry != self._geometry:
            self._geometry = self._look_key = None
            if packing.n_points:
                check_radii(packing)
        if self._tracer is None:
            self._tracer = self._make()
        tracer = self._tracer
        if self._geometry is None:
            # Shares the arrays; the packing itself would be kept alive by its own accessor.
            tracer.SetInputData(packing.copy(deep=False))
            self._geometry = geometry
        tracer.SetCamera(camera)
        tracer.SetWindowSize(size)
        tracer.SetStructure(STRUCTURES.index(structure))
        tracer.SetCuts(-1 if cuts is None else cuts)
        return tracer

    def run(
        self,
        tracer: Tracer,
        packing: pv.PolyData,
        tile: Sequence[int] | int | None,
        look: Look,
        progress: bool,
    ) -> pv.ImageData:
        """Make a picture with the tracer that :meth:`prepare` returned."""
        tracer.SetTileSize(_tile_of(tile))
        key = look.key(packing, hash_contents=self._hash_contents)
        if key is None or key != self._look_key:
            self._look_key = None
            self._set_look(tracer, packing, look)
            self._look_key = key
        # The picture of the last time belongs to whoever asked for it.
        tracer.Modified()
        # That it was stopped holds for the last time alone.
        tracer.SetAbortExecute(0)
        update(tracer, self._label, progress=progress)
        image = pv.ImageData()
        image.ShallowCopy(tracer.GetOutput())
        return image

    def _set_look(self, tracer: Tracer, packing: pv.PolyData, look: Look) -> None:
        """Colour the spheres; equal colours stay one array, so that a picture can be refined."""
        colors = look.sphere_colors(packing, white_by_default=self._white_by_default)
        default = "white" if self._white_by_default else pv.global_theme.color
        color = pv.Color(checks.color_of("color", look.color), default_color=default)
        before, self._colors = self._colors, colors
        tracer.SetRandomColors(look.random_colors)
        tracer.SetColorArrayName("")
        tracer.SetColor(color.float_rgb)
        if colors is None:
            return
        if before is not None:
            values, known = pv.convert_array(colors), pv.convert_array(before)
            if np.array_equal(values, known):
                self._colors = colors = before
        data = packing.copy(deep=False)
        data.GetPointData().AddArray(colors)
        tracer.SetInputData(data)
        tracer.SetColorArrayName(colors.GetName())


def _tile_of(tile: Sequence[int] | int | None) -> tuple[int, int]:
    """Width and height of tiles in pixels."""
    sides: Any = 64 if tile is None else tile
    if np.ndim(sides) == 0:
        sides = (sides, sides)
    return checks.size_of("tile", sides, most=checks.LARGEST_TRACED_SIDE)


def camera_of(camera: CameraLike) -> vtkCamera:
    """`camera` as a vtkCamera, or a TypeError or ValueError.

    Parameters
    ----------
    camera : pyvista.Camera, vtkCamera or sequence
        A camera, or its position, focal point and view-up.
    """
    from ..backend import vtkCamera

    if isinstance(camera, vtkCamera):
        return camera
    try:
        points = checks.numbers_of([list(point) for point in camera])
    except (TypeError, KeyError):
        points = None
    if points is None or points.shape != (3, 3):
        raise TypeError(
            f"camera: found {checks.kind_of(camera)}, expected a camera, or three points: its "
            "position, focal point and view-up"
        )
    position, focal_point, up = points.tolist()
    if position == focal_point:
        raise ValueError(
            f"camera: found the position {position} at the focal point, expected another one"
        )
    if not any(up):
        raise ValueError(f"camera: found the view-up {up}, expected a direction")
    made = pv.Camera()
    made.position, made.focal_point, made.up = position, focal_point, up
    return made
