"""Rays and spheres in long double: what the ray caster is measured against."""

import numpy as np

UNIT = np.finfo(float).eps / 2


class Exact:
    """All hits of rays (m, 3) with spheres (n, 3), (n,), one row a ray, in long double.

    Attributes
    ----------
    near, far : (m, n)
        t where a ray enters and leaves a sphere; NaN where it misses.
    clearance : (m, n)
        Distance of the line from the centre minus the radius.
    reach : (m, n)
        |f| + r, which the bounds of errors are multiples of.
    cosine : (m, n)
        Of the angle of incidence.
    """

    def __init__(self, centers, radii, origins, directions):
        o, d = (np.asarray(a, float).astype(np.longdouble) for a in (origins, directions))
        c = np.asarray(centers, float).astype(np.longdouble)
        self.origins, self.directions, self.centers = o, d, c
        self.radii = np.asarray(radii, float).astype(np.longdouble)
        f = c[None] - o[:, None]
        square = (d * d).sum(axis=1)[:, None]
        middle = (f * d[:, None]).sum(axis=2) / square
        across = f - middle[..., None] * d[:, None]
        away = np.sqrt((across * across).sum(axis=2))
        with np.errstate(invalid="ignore"):
            half = np.sqrt((self.radii - away) * (self.radii + away) / square)
        self.near, self.far = middle - half, middle + half
        self.clearance = away - self.radii
        self.length = np.sqrt(square)
        self.reach = np.sqrt((f * f).sum(axis=2)) + self.radii
        with np.errstate(invalid="ignore", divide="ignore"):
            self.cosine = half * self.length / self.radii

    def bound(self):
        """How far t may be from exact (m, n), as the header of the test derives it."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return 16 * UNIT * self.reach / self.cosine / self.length

    def first(self):
        """First t > 0 of each sphere (m, n), infinite for none."""
        t = np.where(self.near > 0, self.near, self.far)
        return np.where((self.clearance < 0) & (t > 0), t, np.inf)

    def normals(self, rows, ids):
        """Unit vectors (k, 3) out of the spheres `ids` (k,) where the rays `rows` (k,) hit them."""
        t = self.first()[rows, ids][:, None]
        # Relative to the centre from the first step on: long double is rounded as well.
        away = (self.origins[rows] - self.centers[ids]) + t * self.directions[rows]
        return away / self.radii[ids][:, None]

    def certain(self):
        """Where no rounding within the bounds can undo a hit or change which root it is."""
        bound = self.bound()
        roots = (np.abs(self.near) > bound) & (np.abs(self.far) > bound)
        return (self.clearance < -6 * UNIT * self.reach) & roots & (self.first() < np.inf)


def check(exact, ids, t):
    """Assert that ids (m,) and t (m,) lose nothing and invent nothing, within the bounds.

    Returns the largest error of t as a part of its bound.
    """
    first, bound, certain = exact.first(), exact.bound(), exact.certain()
    rows = np.arange(len(ids))
    hit = ids >= 0
    assert (np.isfinite(t) == hit).all()
    # Nothing is lost: whatever is certainly hit is not before what was found.
    latest = np.where(certain, first + bound, np.inf).min(axis=1, initial=np.inf)
    own = np.zeros(len(ids), np.longdouble)
    own[hit] = np.nan_to_num(bound[rows[hit], ids[hit]], posinf=np.inf, nan=np.inf)
    assert (t <= latest + own).all()
    # Nothing is invented: the line passes the sphere that was found.
    found = exact.clearance[rows[hit], ids[hit]]
    assert (found <= 6 * UNIT * exact.reach[rows[hit], ids[hit]]).all()
    # And t is right.
    sure = hit.copy()
    sure[hit] = certain[rows[hit], ids[hit]]
    error = np.abs(t[sure] - first[rows[sure], ids[sure]]) / bound[rows[sure], ids[sure]]
    assert (error <= 1).all()
    return float(error.max(initial=0))


def towards(rng, centers, radii, origins, shares):
    """Directions (m, 3) that pass random spheres at `shares` (m,) of their radii."""
    chosen = rng.integers(len(radii), size=len(origins))
    f = centers[chosen] - origins
    length = np.linalg.norm(f, axis=1, keepdims=True)
    across = np.cross(f, rng.normal(size=f.shape))
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    with np.errstate(invalid="ignore", divide="ignore"):
        # The line that touches the ball of radius p: its direction is f turned by asin(p / |f|).
        sine = np.clip((shares * radii[chosen])[:, None] / length, -1, 1)
    direction = f * np.sqrt(1 - sine**2) + across * sine * length
    still = ~np.isfinite(direction).all(axis=1) | ~(np.abs(direction) > 0).any(axis=1)
    direction[still] = [0.0, 0.0, 1.0]
    return direction
