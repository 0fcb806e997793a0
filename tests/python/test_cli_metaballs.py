"""The command ``spherepacking render --technique metaballs``."""

import numpy as np
import pytest
import spherepacking
from spherepacking.cli.main import main


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "three.spheres"
    path.write_text("0 0 0 2\n5 0 0 1\n0 0 5 0.5\n")
    return path


@pytest.fixture
def draw(file):
    """Return a function from options to the exit status; the picture is beside the file."""

    def run(*options):
        view = ["--size", 90, 60, "--technique", "metaballs"]
        if "--dimensions" not in options:
            view += ["--dimensions", 40]
        arguments = ["render", file, "-o", file.with_suffix(".png"), *view, *options]
        return main([str(word) for word in arguments])

    return run


def shown(file):
    return spherepacking.read_image(file.with_suffix(".png"))


def test_it_fills_the_picture(draw, file):
    assert draw("--background", "white", "--color", "red") == 0
    red = np.ptp(np.argwhere(shown(file)[..., 1] < 200)[:, :2], axis=0)
    assert (red > [40, 40]).all()
    assert draw("--kernel", "wyvill", "--threshold", 0.5, "--transparent") == 0
    assert 0 < (shown(file)[..., 3] > 0).mean() < 1


def test_count_and_weights(draw, file):
    view = ("--kernel", "wyvill", "--camera", 0, -20, 0, "--focal", 0, 0, 0, "--transparent")
    covered = []
    for options in ((), ("--count", 1), ("--weights", 1, 0, 0), ("--weights", 0, 1, 1)):
        assert draw(*view, *options) == 0
        covered.append((shown(file)[..., 3] > 0).sum())
    whole, largest, weighted, others = covered
    assert whole > largest == weighted > others > 0


@pytest.mark.parametrize(
    ("options", "found"),
    [
        (("--threshold", 1e9), "--threshold: metaballs: the threshold 1e+09 is above all values"),
        (("--threshold", -1), "threshold: found -1"),
        (("--weights", "nan"), "weights: found [nan]"),
        (("--count", 0), "count: found 0"),
        (("--dimensions", 0), "dimensions: found 0"),
        (("--kernel", "cubic"), "cubic"),
    ],
)
def test_refusals(draw, file, options, found, capsys):
    assert draw(*options) != 0
    assert found in capsys.readouterr().err
    assert not file.with_suffix(".png").exists()
