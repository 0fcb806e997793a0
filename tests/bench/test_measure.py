"""What the benchmark measures: errors that are there are found, turns are taken, limits kept."""

import csv
import io
import time

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.bench import measure, table
from spherepacking.bench.catalog import everything, own
from spherepacking.bench.measure import Expected, color_error, errors_of, expect, take_turns
from spherepacking.bench.technique import Seen, Technique
from spherepacking.testing.scenes import camera_of_all, depths_of, knot_tube

SIZE = (120, 90)


def one_sphere():
    packing = pv.PolyData(np.array([[0.5, 0.2, -0.1]]))
    packing["radius"] = np.array([0.7])
    packing.set_active_scalars("radius", preference="point")
    return packing


def test_expected_depth_is_the_distance_along_the_view():
    expected = expect(one_sphere(), camera_of_all(), (201, 201))
    ids, depth = expected.sphere_id, expected.depth
    forward = -np.ones(3) / np.sqrt(3)
    away = (np.array([0.5, 0.2, -0.1]) - 3.0) @ forward
    # The nearest point of the sphere faces the camera, but for the view's angle.
    assert depth[ids == 0].min() == pytest.approx(away - 0.7, abs=0.02)
    assert np.isinf(depth[ids < 0]).all()
    assert depth[ids == 0].max() < away


def test_depths_contain_the_packing():
    packing = knot_tube(500)
    low, high = depths_of(packing, camera_of_all())
    expected = expect(packing, camera_of_all(), SIZE)
    seen = expected.depth[expected.sphere_id >= 0]
    assert low < seen.min()
    assert seen.max() < high < 2 * low + 10


def test_errors_are_counted():
    ids = np.array([[0, 1, -1], [2, -1, 3]])
    expected = Expected(ids, np.where(ids < 0, np.inf, 2.0))
    exact = errors_of(Seen(ids, expected.depth), expected)
    assert exact == {"hit_pixels": 4, "wrong_pixels": 0, "depth_median": 0.0, "depth_most": 0.0}
    # Another sphere, one where there is none, and none where there is one.
    seen = Seen(np.array([[1, 1, 0], [-1, -1, 3]]), np.array([[2, 2.002, 1], [1, 1, 2.0]]))
    wrong = errors_of(seen, expected)
    assert wrong["wrong_pixels"] == 3
    assert wrong["depth_most"] == pytest.approx(1e-3)
    assert wrong["depth_median"] == pytest.approx(0.5e-3)


def test_color_error_is_a_share_of_white_over_what_is_shown():
    black, half = np.zeros((2, 2, 4), np.uint8), np.zeros((2, 2, 4), np.uint8)
    assert color_error(black, black) == 0.0
    half[0, 0] = 255
    black[0, 1] = [0, 0, 0, 255]
    # Two pixels are shown, one of which is white where it should be nothing.
    assert color_error(half, black) == pytest.approx(np.sqrt(0.5))


@pytest.mark.parametrize("technique", everything(), ids=lambda t: t.label)
def test_techniques_see_the_packing(technique):
    packing, camera = knot_tube(300), camera_of_all()
    expected = expect(packing, camera, SIZE)
    subject = technique.prepare(packing, camera, SIZE)
    try:
        subject.frame()
        errors = errors_of(subject.seen(), expected)
    finally:
        subject.close()
    # Rays and our mapper are exact; flat discs and meshes are not, but show the same thing.
    exact = technique.name in ("OpenGL", "ray cast", "Embree")
    assert errors["wrong_pixels"] <= (1 if exact else 0.4 * errors["hit_pixels"])
    assert errors["depth_median"] <= (1e-6 if exact else 5e-2)
    assert errors["hit_pixels"] > 1000


def test_more_rays_are_nearer_to_many():
    packing, camera = knot_tube(300), camera_of_all()
    rays = [t for t in own() if t.name == "ray cast" and t.structure == "bvh"]
    exact = measure._smooth(packing, camera, SIZE)
    errors = [color_error(t.prepare(packing, camera, SIZE).seen().color, exact) for t in rays]
    assert [t.rays for t in rays] == [1, 4, 9]
    assert errors[0] > 1.5 * errors[1] > 2 * errors[2] > 0


class Sleeper:
    build_seconds = memory_bytes = np.nan

    def __init__(self, seconds, log, name):
        self.seconds, self.log, self.name = seconds, log, name

    def frame(self):
        self.log.append(self.name)
        time.sleep(self.seconds)


def test_subjects_take_turns_and_the_first_frame_does_not_count():
    log = []
    times = take_turns([Sleeper(0, log, "a"), Sleeper(0, log, "b")], 3, limit=10.0)
    assert log == ["a", "b"] * 4
    assert [len(own) for own in times] == [3, 3]


def test_slow_subjects_make_fewer_frames():
    log = []
    quick, slow, slowest = take_turns(
        [Sleeper(0, log, "a"), Sleeper(0.1, log, "b"), Sleeper(0.3, log, "c")], 5, limit=0.35
    )
    assert len(quick) == 5
    assert 1 <= len(slow) < 5
    assert len(slowest) == 1, "the first one, which is all there is"
    assert slowest[0] >= 0.3


def test_what_would_be_too_slow_is_left_out():
    class Slow(Sleeper):
        def __init__(self, packing, _camera, size):
            super().__init__(0.05 * packing.n_points / 100, [], "")
            self.shape = size[::-1]

        def seen(self):
            return Seen(np.full(self.shape, -1), np.full(self.shape, np.inf))

        def close(self):
            self.log.clear()

    slow = Technique("slow", "", 1, Slow)
    found = list(measure.measure([slow], [100, 200, 1000], SIZE, turns=2, limit=0.25))
    assert [len(rows) for rows in found] == [1, 1, 0]
    assert found[0][0].wrong_pixels == found[0][0].hit_pixels > 0


def test_csv_has_every_number():
    (rows,) = measure.measure(own()[:2], [200], SIZE, turns=1)
    read = list(csv.DictReader(io.StringIO(table.csv_of(rows).decode())))
    assert [row["technique"] for row in read] == ["OpenGL", "ray cast"]
    for row, line in zip(rows, read, strict=True):
        assert float(line["seconds"]) == row.seconds > 0
        assert int(line["hit_pixels"]) == row.hit_pixels
    assert read[0]["build_seconds"] == ""
    assert float(read[1]["bytes_per_sphere"]) > 16


def test_the_scene_is_part_of_the_package():
    assert spherepacking.testing.scenes.knot_tube(100).n_points == 100
