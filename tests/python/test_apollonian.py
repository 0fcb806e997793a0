"""The Apollonian packing against geometry, literature and a second way to make it."""

import itertools

import numpy as np
import pytest
import spherepacking


def spheres(levels):
    packing = spherepacking.apollonian(levels)
    return np.asarray(packing.points), np.asarray(packing["radius"]), np.asarray(packing["level"])


def gaps(centers, radii):
    """Return distances between the surfaces of all pairs (n, n), 0 where two touch from outside."""
    apart = np.sqrt(((centers[:, None] - centers[None]) ** 2).sum(axis=-1))
    return apart - radii[:, None] - radii[None]


def number_of_new_spheres(levels):
    """Return how many spheres each level adds, from the growth of the group of reflections.

    The five reflections generate a Coxeter group with all orders 3, W, which permutes the spheres;
    four of them fix the fifth sphere. Spheres of one of the five orbits so are the cosets of the
    group of four, U, and their growth is W(t)/U(t), both from Steinberg's formula
    1/W(1/t) = sum over the finite standard subgroups T of (-1)^|T| / T(t)
    (R. Steinberg, Endomorphisms of linear algebraic groups, 1968; N. Bourbaki, Lie IV §1 ex. 26).
    With n reflections: 1/W(1/t) = 1 - n/(1+t) + n(n-1)/2 / ((1+t)(1+t+t^2)).
    """
    inverses = []
    for n in (4, 5):
        # The numerator of 1/W(1/t) over (1+t)(1+t+t²) = t³+2t²+2t+1, highest power first; lowest
        # power first, the same numbers are the numerator of 1/W(t) over the same polynomial.
        numerator = np.polysub([1, 2, 2, 1], np.polymul([n], [1, 1, 1]))
        inverses.append(np.polyadd(numerator, [n * (n - 1) // 2]).tolist())
    fours, fives = inverses
    series = []
    for k in range(levels + 1):
        known = sum(fives[j] * series[k - j] for j in range(1, min(k, 3) + 1))
        series.append(((fours[k] if k <= 3 else 0) - known) // fives[0])
    return [5 * value for value in series]


@pytest.mark.parametrize("levels", [0, 1, 2, 3, 5, 8])
def test_counts_follow_the_growth_of_the_group(levels):
    _, _, level = spheres(levels)
    expected = number_of_new_spheres(levels)
    expected[0] -= 1  # the unit sphere around everything is left out
    assert np.bincount(level, minlength=levels + 1).tolist() == expected


def test_documented_counts():
    text = spherepacking.apollonian.__doc__
    counts = np.cumsum(number_of_new_spheres(11)) - 1
    listed = text[text.index("numbers of spheres are") : text.index("Returns")]
    assert [
        int(word.strip(",.")) for word in listed.split() if word[0].isdigit()
    ] == counts.tolist()


def test_no_overlap_and_all_inside():
    centers, radii, _ = spheres(5)
    gap = gaps(centers, radii)
    np.fill_diagonal(gap, 0.0)
    assert gap.min() > -1e-12
    assert (np.linalg.norm(centers, axis=1) + radii).max() <= 1.0 + 1e-12


def test_neighbors_touch_exactly():
    centers, radii, level = spheres(5)
    gap = np.abs(gaps(centers, radii))
    rim = np.abs(1.0 - np.linalg.norm(centers, axis=1) - radii)
    touching = (gap < 1e-12).sum(axis=1) + (rim < 1e-12)
    # Every sphere of a level touches at least the four that it was made from.
    assert touching[level > 0].min() >= 4
    # There is nothing between touching and a gap that is large beside rounding.
    near = gap[(gap < 1e-6) & ~np.eye(len(radii), dtype=bool)]
    assert near.max() < 1e-12


def test_curvatures_are_those_of_the_bowl_of_integers():
    """They are integers congruent to 0 or 2 modulo 3.

    A. Kontorovich, The local-global principle for integral Soddy sphere packings, J. Mod. Dyn. 15
    (2019): an integral packing has curvatures in two classes modulo 3.
    """
    _, radii, _ = spheres(7)
    curvature = 1.0 / radii
    assert np.abs(curvature - np.round(curvature)).max() < 1e-9
    assert set((np.round(curvature).astype(int) % 3).tolist()) == {0, 2}


def test_soddy_gosset_theorem_holds_for_the_start():
    curvature = np.array([-1.0, 2.0, 2.0, 3.0, 3.0])
    assert curvature.sum() ** 2 == 3.0 * (curvature**2).sum()
    _, radii, _ = spheres(0)
    assert np.sort(1.0 / radii).tolist() == pytest.approx([2, 2, 3, 3], abs=1e-14)


def other_tangent_sphere(four, known):
    """Return the second sphere tangent to four mutually tangent ones, by inversion, in floats.

    The sphere through the points where the four touch is perpendicular to them all; inversion in it
    leaves them where they are and swaps the two spheres tangent to them.
    """
    points = []
    for (c1, b1), (c2, b2) in itertools.combinations(four, 2):
        points.append((b1 * c1 + b2 * c2) / (b1 + b2))
    points = np.array(points)
    center, b = known
    middle = points.mean(axis=0)
    _, spread, axes = np.linalg.svd(points - middle)
    if spread[2] < 1e-9:  # a plane is the limit of that sphere
        return center - 2.0 * axes[2] * (axes[2] @ (center - middle)), b
    # |p - m|² = s² for all points is linear in m and s² - |m|².
    system = np.column_stack([2.0 * points, np.ones(len(points))])
    solution, *_ = np.linalg.lstsq(system, (points**2).sum(axis=1), rcond=None)
    middle, square = solution[:3], solution[3] + (solution[:3] ** 2).sum()
    radius = 1.0 / b
    offset = center - middle
    factor = square / (offset @ offset - radius * radius)
    image = abs(factor * radius)
    # The image surrounds the four if the inverted sphere has the middle inside.
    sign = np.sign(factor) * np.sign(b)
    return middle + factor * offset, sign / image


def test_a_second_way_gives_the_same_spheres():
    """Inversions in floats along all words of reflections, without integers or lookups."""
    levels = 4
    start = [
        (np.zeros(3), -1.0),
        (np.array([0.0, 0.0, 0.5]), 2.0),
        (np.array([0.0, 0.0, -0.5]), 2.0),
        (np.array([2.0 / 3.0, 0.0, 0.0]), 3.0),
        (np.array([1.0 / 3.0, np.sqrt(1.0 / 3.0), 0.0]), 3.0),
    ]
    found = list(start)

    def descend(five, last, depth):
        if depth == levels:
            return
        for i in range(5):
            if i != last:
                rest = five[:i] + five[i + 1 :]
                new = other_tangent_sphere(rest, five[i])
                found.append(new)
                descend([*rest[:i], new, *rest[i:]], i, depth + 1)

    descend(start, None, 0)
    inner = np.array([[*center, 1.0 / b] for center, b in found if b > 0.0])
    different = np.unique(np.round(inner, 7), axis=0)
    centers, radii, _ = spheres(levels)
    ours = np.column_stack([centers, radii])
    assert len(different) == len(ours)
    distance = np.abs(ours[:, None] - different[None]).max(axis=-1)
    assert distance.min(axis=1).max() < 1e-6
    assert distance.min(axis=0).max() < 1e-6


def test_largest_first_and_arrays():
    packing = spherepacking.apollonian(4)
    assert np.all(np.diff(packing["radius"]) <= 0.0)
    assert packing.point_data.active_scalars_name == "radius"
    assert packing.points.dtype == packing["radius"].dtype == np.float64


@pytest.mark.parametrize("levels", [-1, 12])
def test_levels_out_of_range(levels):
    with pytest.raises(ValueError, match=f"levels: found {levels}, expected 0 to 11"):
        spherepacking.apollonian(levels)


def test_levels_of_another_type():
    with pytest.raises(TypeError, match=r"levels: found 2\.5, expected an integer"):
        spherepacking.apollonian(2.5)
