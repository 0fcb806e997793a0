"""Lets techniques take turns and measures their time and their error."""

from __future__ import annotations

import statistics
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypedDict

import numpy as np

from ..accessor import PackingAccessor
from ..checks import LARGEST_RAY_SAMPLES
from ..testing import reference
from ..testing.scenes import camera_of_all, depths_of, knot_tube
from . import light
from .technique import label_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    import pyvista as pv
    from numpy.typing import NDArray

    from .technique import Seen, Subject, Technique

ONCE = 100_000
"""Spheres with which techniques are measured that take long, if there are so many."""


@dataclass(frozen=True)
class Row:
    """What one technique took and missed on one packing."""

    technique: str
    structure: str
    rays: int
    """Rays or samples per pixel."""
    spheres: int
    seconds: float
    """A frame, the median."""
    frames: int
    """That count: those after the first one, or that one alone if it took so long."""
    build_seconds: float
    """Of the structure, NaN without one."""
    bytes_per_sphere: float
    """Of the structure, NaN without one."""
    hit_pixels: int
    """Pixels where float64 rays hit a sphere."""
    wrong_pixels: int
    """Pixels that show another sphere than float64 rays see, or one where they see none."""
    depth_median: float
    """Median of the relative error of the depth where the sphere is right."""
    depth_most: float
    """The largest of them."""
    color_error: float
    """Root mean square of the colour's difference from 256 rays per pixel, as a fraction of white,
    over the pixels that either hits; NaN where colours mean something else."""
    relative_mse: float = np.nan
    """Of the light, against 4096 samples per pixel; NaN for what has none."""
    flip: float = np.nan
    """Mean FLIP error against them; NaN for what has no light, or without the evaluator."""

    @property
    def label(self) -> str:
        """Which technique it is, in a few words."""
        return label_of(self.technique, self.structure, self.rays)


@dataclass(frozen=True)
class Expected:
    """What float64 rays see; rows from the bottom."""

    sphere_id: NDArray[np.int64]
    depth: NDArray[np.float64]


def expect(packing: pv.PolyData, camera: pv.Camera, size: tuple[int, int]) -> Expected:
    """Cast float64 rays through the middles of the pixels."""
    near, far = depths_of(packing, camera)
    camera.clipping_range = near, far
    matrix = camera.GetCompositeProjectionTransformMatrix(size[0] / size[1], -1.0, 1.0)
    to_device = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    picture = reference.cast(packing.points, packing["radius"], to_device, size)
    return Expected(picture.sphere_id, near + picture.t * (far - near))


class PixelErrors(TypedDict):
    """How the pixels of a technique differ from float64 rays, as in `Row`."""

    hit_pixels: int
    wrong_pixels: int
    depth_median: float
    depth_most: float


def errors_of(seen: Seen, expected: Expected) -> PixelErrors:
    """Compare what a technique shows with what float64 rays see."""
    hit = expected.sphere_id >= 0
    right = seen.sphere_id == expected.sphere_id
    both = right & hit
    error = np.abs(seen.depth[both] / expected.depth[both] - 1.0)
    return {
        "hit_pixels": int(hit.sum()),
        "wrong_pixels": int((~right).sum()),
        "depth_median": float(np.median(error)) if error.size else np.nan,
        "depth_most": float(error.max()) if error.size else np.nan,
    }


def color_error(color: NDArray[np.uint8], exact: NDArray[np.uint8]) -> float:
    """Root mean square over what either shows, on black."""
    ours, theirs = (c[..., :3] / 255.0 * (c[..., 3:] / 255.0) for c in (color, exact))
    shown = (color[..., 3] > 0) | (exact[..., 3] > 0)
    return float(np.sqrt(np.mean((ours - theirs)[shown] ** 2))) if shown.any() else 0.0


def _timed(work: Callable[[], None]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def take_turns(subjects: Sequence[Subject], turns: int, limit: float) -> list[list[float]]:
    """Time frames of all subjects in turn, after one frame of each that is not counted.

    Parameters
    ----------
    subjects : sequence of Subject
        What takes turns.
    turns : int
        How many frames of each are timed, 1 or more.
    limit : float
        Seconds that all frames of a subject may take; those that need more make fewer frames. One
        whose first frame takes longer has that one counted.

    Returns
    -------
    list of list of float
        Seconds of the frames that count, of each subject.
    """
    first = [_timed(subject.frame) for subject in subjects]
    times: list[list[float]] = [[] for _ in subjects]
    for turn in range(turns):
        for subject, seconds, own in zip(subjects, first, times, strict=True):
            if (turn + 2) * seconds <= limit:
                own.append(_timed(subject.frame))
    return [own or [seconds] for own, seconds in zip(times, first, strict=True)]


def measure(
    techniques: Sequence[Technique],
    counts: Sequence[int],
    size: tuple[int, int] = (1000, 1000),
    turns: int = 5,
    limit: float = 20.0,
    tick: Callable[[str], None] = lambda _: None,
) -> Iterator[list[Row]]:
    """Measure techniques on packings of more and more spheres.

    Parameters
    ----------
    techniques : sequence of Technique
        What is measured.
    counts : sequence of int
        Numbers of spheres, from 100, ascending.
    size : (int, int), default: (1000, 1000)
        Width and height of the pictures.
    turns : int, default: 5
        Frames of each technique that are timed.
    limit : float, default: 20.0
        Seconds that the frames of a technique may take. It is left out from the count on at which,
        by the time of the count before, a single one would take longer.
    tick : callable
        Called with what is being measured.

    Yields
    ------
    list of Row
        The rows of one count.
    """
    camera = camera_of_all()
    last: dict[str, float] = {}
    previous = counts[0] if counts else 0
    for count in counts:
        tick(f"{count} spheres: float64 rays")
        packing = knot_tube(count)
        expected = expect(packing, camera, size)
        chosen = [
            t
            for t in techniques
            if last.get(t.label, 0.0) * count / previous <= limit
            and (not t.once or count == _only_count(counts))
        ]
        subjects = []
        try:
            for technique in chosen:
                tick(f"{count} spheres: {technique.label}")
                subjects.append(technique.prepare(packing, camera, size))
            tick(f"{count} spheres: frames")
            times = take_turns(subjects, turns, limit)
            tick(f"{count} spheres: errors")
            yield _rows(chosen, subjects, times, packing, camera, size, expected)
        finally:
            for subject in subjects:
                subject.close()
        # Those that are left out stay out.
        last = {t.label: float("inf") for t in techniques if not t.once} | {
            t.label: min(own) for t, own in zip(chosen, times, strict=True)
        }
        previous = count


def _only_count(counts: Sequence[int]) -> int:
    """Return the number of spheres for what takes long: that of the report on such renderers."""
    return ONCE if ONCE in counts else max(counts)


def _rows(
    techniques: Sequence[Technique],
    subjects: Sequence[Subject],
    times: Sequence[Sequence[float]],
    packing: pv.PolyData,
    camera: pv.Camera,
    size: tuple[int, int],
    expected: Expected,
) -> list[Row]:
    """One row per technique."""
    exact = bright = None
    rows = []
    for technique, subject, own in zip(techniques, subjects, times, strict=True):
        seen = subject.seen()
        error = np.nan
        if seen.color is not None:
            if exact is None:
                exact = _smooth(packing, camera, seen.color.shape[1::-1])
            error = color_error(seen.color, exact)
        relative_mse = flip = np.nan
        if hasattr(subject, "light"):
            if bright is None:
                bright = light.reference(packing, camera, size)
            image = subject.light(light.size_of_reference(size))
            relative_mse = light.relative_mse(image["radiance"], bright["radiance"])
            flip = light.flip(image, bright)
        rows.append(
            Row(
                technique=technique.name,
                structure=technique.structure,
                rays=technique.rays,
                spheres=packing.n_points,
                seconds=statistics.median(own),
                frames=len(own),
                build_seconds=subject.build_seconds,
                bytes_per_sphere=subject.memory_bytes / packing.n_points,
                color_error=error,
                **errors_of(seen, expected),
                relative_mse=relative_mse,
                flip=flip,
            )
        )
    return rows


def _smooth(packing: pv.PolyData, camera: pv.Camera, size: tuple[int, int]) -> NDArray[np.uint8]:
    image = PackingAccessor(packing).ray_cast(
        camera, size, samples=LARGEST_RAY_SAMPLES, scalars="radius"
    )
    return np.asarray(image["color"]).reshape(size[1], size[0], 4)
