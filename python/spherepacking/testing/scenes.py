"""Scenes of the benchmarks."""

from __future__ import annotations

import numpy as np
import pyvista as pv

_TUBE_RADIUS = 0.36
_CURVE_SCALE = 0.45
_SOLID_FRACTION = 0.6
_EXPONENT = 1.0 / 2.8


def _trefoil(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Points (n, 3) of a trefoil knot for parameters t (n,), and its derivative."""
    s, c = np.sin, np.cos
    point = np.column_stack([s(t) + 2 * s(2 * t), c(t) - 2 * c(2 * t), -s(3 * t)])
    slope = np.column_stack([c(t) + 4 * c(2 * t), -s(t) + 4 * s(2 * t), -3 * c(3 * t)])
    return _CURVE_SCALE * point, _CURVE_SCALE * slope


def _radii(count: int, volume: float) -> np.ndarray:
    """Radii ∝ rank^(-1/2.8) (count,), those that fit no tube cut down, of total volume `volume`."""
    law = np.arange(1, count + 1, dtype=float) ** -_EXPONENT
    tail = np.cumsum(law[::-1] ** 3)[::-1]
    largest = 0.95 * _TUBE_RADIUS
    cubes = volume / (4.0 / 3.0 * np.pi)
    cut = 0
    # Cutting one sphere down enlarges the others, which may make one more to be cut down.
    while True:
        scale = np.cbrt((cubes - cut * largest**3) / tail[cut])
        too_large = int(np.count_nonzero(law[:10_000] * scale > largest))
        if too_large <= cut:
            return np.minimum(law * scale, largest)
        cut = too_large


def knot_tube(count: int, seed: int = 0) -> pv.PolyData:
    """Make a polydisperse packing in a knotted tube 3.18 wide, with random overlaps.

    Parameters
    ----------
    count : int
        Number of spheres, from 100.
    seed : int, default: 0
        Seed of the random numbers; the same count and seed make the same packing.

    Returns
    -------
    pyvista.PolyData
        Centres (count, 3) and point array ``radius`` (count,), both float32, largest sphere first.
        Their volumes add up to 0.6 of that of the tube.
    """
    rng = np.random.default_rng(seed)
    t = np.linspace(0.0, 2.0 * np.pi, 4097)
    _, slope = _trefoil(t)
    speed = np.linalg.norm(slope, axis=1)
    length = np.concatenate([[0.0], np.cumsum(0.5 * (speed[1:] + speed[:-1]) * np.diff(t))])
    volume = _SOLID_FRACTION * np.pi * _TUBE_RADIUS**2 * length[-1]
    radii = _radii(count, volume)

    centers = np.empty((count, 3), dtype=np.float32)
    for start in range(0, count, 1_000_000):
        part = slice(start, min(start + 1_000_000, count))
        n = part.stop - part.start
        along = np.interp(rng.random(n) * length[-1], length, t)
        point, tangent = _trefoil(along)
        # The tangent is never vertical, so this frame is defined everywhere.
        side = np.column_stack([tangent[:, 1], -tangent[:, 0], np.zeros(n)])
        side /= np.linalg.norm(side, axis=1, keepdims=True)
        up = np.cross(side, tangent)
        up /= np.linalg.norm(up, axis=1, keepdims=True)
        away = (_TUBE_RADIUS - radii[part]) * np.sqrt(rng.random(n))
        angle = 2.0 * np.pi * rng.random(n)
        centers[part] = (
            point + (away * np.cos(angle))[:, None] * side + (away * np.sin(angle))[:, None] * up
        )
    packing = pv.PolyData()
    packing.points = centers
    packing.point_data["radius"] = radii.astype(np.float32)
    packing.set_active_scalars("radius", preference="point")
    return packing


def camera_of_all() -> pv.Camera:
    """Make the camera of every benchmark: at (3, 3, 3), looking at the origin, 40° high."""
    camera = pv.Camera()
    camera.position, camera.focal_point, camera.up = (3.0, 3.0, 3.0), (0.0, 0.0, 0.0), (0, 0, 1.0)
    camera.view_angle = 40.0
    return camera


def set_camera(plotter: pv.Plotter) -> None:
    """Let a plotter look at the scene as every benchmark does."""
    camera = camera_of_all()
    plotter.camera_position = [camera.position, camera.focal_point, camera.up]
    plotter.camera.view_angle = camera.view_angle


def depths_of(packing: pv.PolyData, camera: pv.Camera) -> tuple[float, float]:
    """Find between which distances from the camera, along its direction, all spheres lie.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,), n > 0.
    camera : pyvista.Camera
        Camera outside the packing.

    Returns
    -------
    tuple[float, float]
        The least and the greatest distance, with a hundredth of their difference to spare.
    """
    position = np.asarray(camera.position, dtype=float)
    forward = np.asarray(camera.focal_point, dtype=float) - position
    forward /= np.linalg.norm(forward)
    away = (np.asarray(packing.points, dtype=float) - position) @ forward
    radii = np.asarray(packing.point_data["radius"], dtype=float)
    least, greatest = float((away - radii).min()), float((away + radii).max())
    spare = 0.01 * (greatest - least)
    return max(least - spare, 1e-3 * greatest), greatest + spare
