"""Closed surfaces, and what a packing of one must be, checked one by one in double precision."""

import numpy as np
import pyvista as pv


def surface_of(points, triangles):
    faces = np.hstack([np.full((len(triangles), 1), 3), triangles])
    return pv.PolyData(np.asarray(points, float), faces.ravel())


def triangles_of(mesh):
    """Corners (n, 3, 3) of the triangles."""
    faces = mesh.triangulate().faces.reshape(-1, 4)[:, 1:]
    return np.asarray(mesh.points, float)[faces]


def read_off(path):
    words = path.read_text().split()[1:]
    points, faces = int(words[0]), int(words[1])
    end = 3 + 3 * points
    corners = np.array(words[end : end + 4 * faces], int).reshape(-1, 4)[:, 1:]
    return surface_of(np.array(words[3:end], float).reshape(-1, 3), corners)


def blob(rng, roughness=0.3, subdivisions=3):
    """A ball with bumps, at a random place and of a random size."""
    ball = pv.Icosphere(radius=1.0, nsub=subdivisions)
    points = np.asarray(ball.points, float)
    height = sum(np.sin(points @ (rng.normal(size=3) * 4) + rng.uniform(0, 6)) for _ in range(5))
    points *= (1 + roughness * height / 5)[:, None]
    points = points * np.exp(rng.uniform(-3, 3)) + rng.normal(size=3)
    return surface_of(points, ball.faces.reshape(-1, 4)[:, 1:])


def together(*meshes):
    """Several shells as one surface, with their own points."""
    points, faces, first = [], [], 0
    for mesh in meshes:
        points.append(np.asarray(mesh.points, float))
        faces.append(mesh.triangulate().faces.reshape(-1, 4)[:, 1:] + first)
        first += mesh.n_points
    return surface_of(np.vstack(points), np.vstack(faces))


def ball(radius=1.0, center=(0, 0, 0), subdivisions=3):
    return pv.Icosphere(radius=radius, center=center, nsub=subdivisions)


def winding_numbers(mesh, places):
    """Around places (n, 3), as the sum of all solid angles."""
    corners = triangles_of(mesh)
    result = []
    for place in places:
        a, b, c = np.moveaxis(corners - place, 1, 0)
        la, lb, lc = (np.linalg.norm(v, axis=1) for v in (a, b, c))
        above = np.einsum("ij,ij->i", a, np.cross(b, c))
        below = la * lb * lc + (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb
        result.append(np.arctan2(above, below).sum() / (2 * np.pi))
    return np.array(result)


def distances(mesh, places):
    """From places (n, 3) to the nearest of all triangles, by the least over planes and edges."""
    corners = triangles_of(mesh)
    a, b, c = np.moveaxis(corners, 1, 0)
    normals = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1)
    flat = lengths > 0
    unit = normals / np.where(flat, lengths, 1)[:, None]
    result = []
    for place in places:
        best = np.inf
        inside = flat.copy()
        for start, end in ((a, b), (b, c), (c, a)):
            edge = end - start
            square = (edge * edge).sum(1)
            along = ((place - start) * edge).sum(1) / np.where(square > 0, square, 1)
            nearest = start + np.clip(along, 0, 1)[:, None] * edge
            best = min(best, np.linalg.norm(place - nearest, axis=1).min())
            inside &= (np.cross(unit, edge) * (place - start)).sum(1) >= 0
        if inside.any():
            best = min(best, np.abs((unit * (place - a)).sum(1)[inside]).min())
        result.append(best)
    return np.array(result)


def check_packing(packing, mesh, rng, inside=None, samples=150):
    """Assert that it is a packing of the surface, sorted by radius.

    `inside` tells which of some places are, by default those that the surface goes around once.
    """
    centers, radii = np.asarray(packing.points), np.asarray(packing["radius"])
    assert centers.dtype == radii.dtype == np.float64
    assert (radii > 0).all()
    assert (np.diff(radii) <= 0).all()
    for i in range(len(radii) - 1):
        gaps = np.linalg.norm(centers[i + 1 :] - centers[i], axis=1) - radii[i] - radii[i + 1 :]
        assert (gaps >= -1e-6 * radii[i + 1 :]).all()
    chosen = np.unique(np.append(rng.integers(0, len(radii), samples), 0))
    outside = radii[chosen] - distances(mesh, centers[chosen])
    assert outside.max() <= 1e-6 * mesh.length
    if inside is None:
        assert np.allclose(winding_numbers(mesh, centers[chosen]), 1, atol=1e-6)
    else:
        assert inside(centers[chosen]).all()
    volume = 4 / 3 * np.pi * (radii**3).sum()
    fraction = packing.field_data["volume_fraction"][0]
    assert np.isclose(fraction, volume / packing.field_data["surface_volume"][0])
    assert fraction < 1
