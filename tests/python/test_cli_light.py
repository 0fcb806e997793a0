"""The command ``spherepacking render --technique pathtrace``."""

import numpy as np
import pytest
import spherepacking
from spherepacking.cli.main import main


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "three.spheres"
    path.write_text("0 0 0 2\n10 0 0 1\n0 0 10 0.5\n")
    return path


@pytest.fixture
def draw(file):
    """Return a function from options to the picture that they make."""
    output = file.with_suffix(".png")

    def run(*options):
        view = ["--size", 60, 40, "--technique", "pathtrace", "--samples", 4, "--color", "white"]
        arguments = ["render", file, "-o", output, *view, *options]
        assert main([str(word) for word in arguments]) == 0
        return spherepacking.read_image(output)

    return run


def test_skies_and_suns(draw):
    # A white sky, and what it lights.
    picture = draw()
    assert (picture[..., 3:] == 255).all()
    assert picture[0, 0, :3].tolist() == [255, 255, 255]
    assert picture.min() <= 231  # sRGB of 0.8
    # No light at all.
    assert draw("--sky", 0)[..., :3].max() == 0
    assert draw("--sky", 0, "--sun", 1, 1, 1)[..., :3].max() > 150
    red = draw("--sky", 1, 0, 0)
    assert red[0, 0, :3].tolist() == [255, 0, 0]
    assert draw("--exposure", -1)[0, 0, :3].tolist() == [188, 188, 188]


def test_an_image_of_a_sky(draw, tmp_path):
    sky = tmp_path / "sky.exr"
    spherepacking.write_image(sky, np.full((4, 8, 3), [0.0, 1.0, 0.0], np.float32))
    assert draw("--sky", sky)[0, 0, :3].tolist() == [0, 255, 0]


def test_backgrounds(draw):
    assert draw("--background", "#0000ff")[0, 0, :3].tolist() == [0, 0, 255]
    clear = draw("--transparent")
    assert clear[0, 0].tolist() == [0, 0, 0, 0]
    assert clear[..., 3].max() == 255


def test_radii_color_the_spheres(file):
    output = file.with_suffix(".png")
    options = ["--size", "60", "40", "--technique", "pathtrace", "--sky", "0.5", "--cmap", "magma"]
    assert main(["render", str(file), "-o", str(output), *options]) == 0
    picture = spherepacking.read_image(output)[..., :3].astype(int)
    assert (picture.max(axis=-1) - picture.min(axis=-1)).max() > 30


def test_exr_holds_layers(file):
    output = file.with_suffix(".exr")
    options = ["--size", "30", "20", "--technique", "pathtrace", "--samples", "2"]
    assert main(["render", str(file), "-o", str(output), *options]) == 0
    assert spherepacking.read_image(output).shape == (20, 30, 15)


@pytest.mark.parametrize(
    ("options", "found"),
    [
        (("--samples", 0), "samples: found 0"),
        (("--max-bounces", -1), "max_bounces: found -1"),
        (("--albedo", 2), "albedo: found 2"),
        (("--sky", "no.exr"), "no.exr: no such file"),
        (("--sky", 1, "blue"), "--sky: found 1 blue, expected"),
        (("--sky", 1, 2, 3, 4), "--sky: found 4 numbers"),
        (("--sun", 0, 0, 0), "sun: found the direction"),
        (("--opacity", 0.5), "--opacity: found 0.5, expected 1 with --technique pathtrace"),
    ],
)
def test_refusals(file, tmp_path, capfd, options, found):
    output = tmp_path / "a.png"
    arguments = ["render", file, "-o", output, "--technique", "pathtrace", *options]
    assert main([str(word) for word in arguments]) == 2
    assert found in capfd.readouterr().err
    assert not output.exists()
