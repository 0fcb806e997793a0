"""How the accessor ``packing`` casts rays: arguments, colours and errors of the C++ tracer."""

from __future__ import annotations

import threading
import zlib
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import pyvista as pv

from .. import checks as arguments
from ..look.color_map import colour_map_of, special_colours
from ..look.scalars import scalars_of
from ..vtk_tools import progress_bar

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike
    from pyvista.plotting._typing import ColorLike

    from ..backend import vtkSpherePackingTracer
    from ..look.scalars import Scalars

STRUCTURES = ("none", "grid", "bvh")
_LARGEST_SIZE = 65536


class Pick(NamedTuple):
    """What a ray hits first.

    Attributes
    ----------
    sphere_id : int
        Index of the sphere in the packing.
    point : numpy.ndarray
        Where it is hit (3,), in the unit of the packing.
    normal : numpy.ndarray
        Unit vector (3,) out of the sphere.
    """

    sphere_id: int
    point: np.ndarray
    normal: np.ndarray


class Caster:
    """A tracer that keeps its structure for as long as the packing does not change."""

    tracer_class = "vtkSpherePackingTracer"
    label = "casting rays"
    plain = False
    """Whether spheres are white if nothing is said, instead of as the plotter draws them."""
    watchful = False
    """Whether to look at all centres and radii each time, since what is kept would be mixed."""

    def __init__(self) -> None:
        # Python code runs while the tracer works, and so may other threads.
        self.lock = threading.Lock()
        self._tracer: vtkSpherePackingTracer | None = None
        # When what the tracer has was last changed; checking and colouring again take as long as
        # casting rays.
        self._state: tuple[int, ...] | None = None
        self._digest = (0, 0)  # of the radii and, if watchful, the centres
        self._told = 0  # when the point data, of which they are a part, was last changed
        self._colors: object = None
        self._look: tuple[object, ...] | None = None

    def prepare(
        self,
        packing: pv.PolyData,
        camera: object,
        window_size: Sequence[int],
        structure: str = "bvh",
        cuts: int | None = None,
    ) -> vtkSpherePackingTracer:
        """Check the arguments and hand them to the tracer."""
        if structure not in STRUCTURES:
            raise ValueError(
                f"structure: found {structure!r}, expected one of {', '.join(STRUCTURES)}"
            )
        if cuts is not None:
            cuts = arguments.count_of("cuts", cuts, least=0)
        size = arguments.size_of("window_size", window_size, most=_LARGEST_SIZE)
        camera = camera_of(camera)
        self._notice(packing)
        state = state_of(packing)
        if state is None or state != self._state:
            self._state = self._look = None
            if packing.n_points:
                arguments.radii_of(packing, "radius")
        if self._tracer is None:
            from .. import backend

            self._tracer = getattr(backend, self.tracer_class)()
            # Errors are raised, not printed.
            self._tracer.AddObserver("ErrorEvent", _ignore)
            self._tracer.GetExecutive().AddObserver("ErrorEvent", _ignore)
        tracer = self._tracer
        if self._state is None:
            # Shares the arrays; the packing itself would be kept alive by its own accessor.
            tracer.SetInputData(packing.copy(deep=False))
            self._state = state
        tracer.SetCamera(camera)
        tracer.SetWindowSize(size)
        tracer.SetStructure(STRUCTURES.index(structure))
        tracer.SetCuts(-1 if cuts is None else cuts)
        return tracer

    def _notice(self, packing: pv.PolyData) -> None:
        """Let VTK know of arrays that were changed without its knowing.

        As by ``packing["radius"] *= 2``, which tells the point data that an array was added, or
        through another view of their memory, which tells nobody.
        """
        state = state_of(packing)
        told = packing.GetPointData().GetMTime()
        same = state == self._state and told == self._told
        if state is None or (same and not self.watchful):
            return
        radii = packing.GetPointData().GetAbstractArray("radius")
        centers = packing.GetPoints().GetData()
        digest = (
            _digest_of(packing.point_data["radius"]),
            _digest_of(packing.points) if self.watchful else 0,
        )
        if state == self._state:
            for array, one, other in zip((radii, centers), digest, self._digest, strict=True):
                if one != other:
                    array.Modified()
        self._digest, self._told = digest, packing.GetPointData().GetMTime()

    def cast(
        self,
        packing: pv.PolyData,
        tile: Sequence[int] | int | None,
        look: dict[str, object],
        progress: bool,
    ) -> pv.ImageData:
        """Make the picture."""
        tracer = self._tracer
        tile = 64 if tile is None else tile
        tile = (tile, tile) if np.ndim(tile) == 0 else tile
        tracer.SetTileSize(arguments.size_of("tile", tile, most=_LARGEST_SIZE))
        key = _key_of(packing, look)
        if key is None or key != self._look:
            self._look = None
            self._colors = _set_look(tracer, packing, self._colors, self.plain, **look)
            self._look = key
        # The picture of the last time belongs to whoever asked for it.
        tracer.Modified()
        # And so does its end before time.
        tracer.SetAbortExecute(0)
        with progress_bar(tracer, self.label, delay=0.0 if progress else np.inf):
            tracer.Update()
        if tracer.GetErrorMessage():
            raise ValueError(tracer.GetErrorMessage())
        image = pv.ImageData()
        image.ShallowCopy(tracer.GetOutput())
        return image

    def pick(self, packing: pv.PolyData, x: float, y: float) -> Pick | None:
        """Cast the ray through a pixel."""
        from ..backend import reference

        tracer = self._tracer
        width, height = tracer.GetWindowSize()
        x = arguments.number_of("x", x, 0.0, width)
        y = arguments.number_of("y", y, 0.0, height)
        t, normal = reference(0.0), [0.0, 0.0, 0.0]
        sphere = tracer.CastPixel(x, y, t, normal)
        if tracer.GetErrorMessage():
            raise ValueError(tracer.GetErrorMessage())
        if sphere < 0:
            return None
        normal = np.array(normal)
        # From the sphere, so that the point keeps its digits however far the camera is.
        radius = float(packing.point_data["radius"][sphere])
        return Pick(sphere, np.asarray(packing.points[sphere], float) + radius * normal, normal)


def _digest_of(values: np.ndarray) -> int:
    return zlib.crc32(np.ascontiguousarray(values).view(np.uint8))


def state_of(packing: pv.PolyData) -> tuple[int, ...] | None:
    """When centres and radii were last changed, which no two of VTK's arrays have in common."""
    radii = packing.GetPointData().GetAbstractArray("radius")
    if not packing.n_points or radii is None:
        return None
    points = packing.GetPoints()
    return points.GetMTime(), points.GetData().GetMTime(), radii.GetMTime()


def _key_of(packing: pv.PolyData, look: dict[str, object]) -> tuple[object, ...] | None:
    """What the colours depend on, None if that cannot be told without looking at all of it."""
    scalars, cmap = look["scalars"], look["cmap"]
    if scalars is None:
        array = packing.GetPointData().GetScalars()
    elif isinstance(scalars, str):
        array = packing.GetPointData().GetAbstractArray(scalars)
    else:
        return None
    if isinstance(cmap, pv.LookupTable):
        look = look | {"cmap": ("table", cmap.GetMTime())}
    theme = pv.global_theme
    names = (repr(name) for name in (look, theme.cmap, theme.color, theme.nan_color))
    # That of all arrays: some changes are told to the point data alone.
    return (array and packing.GetPointData().GetMTime(), *names)


def _ignore(*_: object) -> None:
    pass


def camera_of(camera: object) -> object:
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
        points = np.asarray([list(point) for point in camera], dtype=float)
        position, focal_point, up = points.reshape(3, 3).tolist()
    except (TypeError, ValueError):
        raise TypeError(
            f"camera: found a {type(camera).__name__}, expected a camera, or three points: its "
            "position, focal point and view-up"
        ) from None
    if position == focal_point:
        raise ValueError(f"camera: found one that stands where it looks at, {position}")
    if not any(up):
        raise ValueError(f"camera: found the view-up {up}, expected a direction")
    made = pv.Camera()
    made.position, made.focal_point, made.up = position, focal_point, up
    return made


def _set_look(
    tracer: vtkSpherePackingTracer,
    packing: pv.PolyData,
    before: object,
    plain: bool,
    scalars: str | ArrayLike | None,
    rgb: bool | None,
    cmap: str | list[ColorLike] | pv.LookupTable | None,
    clim: Sequence[float] | float | None,
    log_scale: bool,
    color: ColorLike | None,
    random_colors: bool,
) -> object:
    """Colours as ``plotter.packing.add`` gives the spheres.

    Returns the array of the colours, which is the one from `before` if it has the same, so that
    what depends on it need not be made anew.
    """
    theme = pv.global_theme
    log_scale = arguments.flag_of("log_scale", log_scale)
    random_colors = arguments.flag_of("random_colors", random_colors)
    active = color is None and not random_colors and not plain
    found = scalars_of(packing, scalars, rgb, active=active)
    words = colour_map_of(found, None, cmap, clim, 256, False, log_scale, None)
    default = "white" if plain else theme.color
    color = pv.Color(arguments.color_of("color", color), default_color=default)
    tracer.SetRandomColors(random_colors)
    tracer.SetColorArrayName("")
    tracer.SetColor(color.float_rgb)
    if found.values is None or not packing.n_points:
        return None
    colors = _colors_of(packing, found, words | special_colours(theme, None, 1.0, None, None))
    if before is not None and np.array_equal(*map(pv.convert_array, (before, colors))):
        colors = before
    data = packing.copy(deep=False)
    data.GetPointData().AddArray(colors)
    tracer.SetInputData(data)
    tracer.SetColorArrayName(colors.GetName())
    return colors


def _colors_of(packing: pv.PolyData, scalars: Scalars, words: dict[str, object]) -> object:
    """RGBA of each sphere, an array of VTK, as the mapper would draw it."""
    from ..draw.mapper import SpherePackingMapper

    mapper = SpherePackingMapper(packing.copy(deep=False), pv.global_theme, "radius")
    mapper.set_scalars(scalars.values, scalars.name, rgb=scalars.rgb, **words)
    # What PyVista puts before it makes the scalars the active ones.
    mapper.GetInputAlgorithm().Update()
    colors = mapper.MapScalars(1.0)
    colors.SetName("spherepacking colors")
    return colors
