"""Pictures through OpenImageIO, checked with Pillow where it reads the format."""

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import spherepacking
from spherepacking import read_image, write_image
from spherepacking.files import image
from spherepacking.files.image import check_output, write_strips

pillow = pytest.importorskip("PIL.Image")  # a dependency of PyVista


@pytest.mark.parametrize("channels", [1, 3, 4])
@pytest.mark.parametrize("extension", ["png", "tif"])
def test_uint8_round_trip(tmp_path, rng, channels, extension):
    pixels = rng.integers(0, 256, (7, 11, channels), dtype=np.uint8)
    path = tmp_path / f"picture.{extension}"
    spherepacking.write_image(path, pixels)
    assert np.array_equal(spherepacking.read_image(path), pixels)


def test_png_is_what_others_read(tmp_path, rng):
    """Straight alpha: also the colours of transparent pixels survive."""
    pixels = rng.integers(0, 256, (5, 9, 4), dtype=np.uint8)
    pixels[0, :, 3] = 0
    spherepacking.write_image(tmp_path / "a.png", pixels)
    with pillow.open(tmp_path / "a.png") as picture:
        assert picture.mode == "RGBA"
        assert np.array_equal(np.asarray(picture), pixels)


def test_reading_what_others_write(tmp_path, rng):
    pixels = rng.integers(0, 256, (5, 9, 4), dtype=np.uint8)
    pillow.fromarray(pixels).save(tmp_path / "a.png")
    assert np.array_equal(spherepacking.read_image(tmp_path / "a.png"), pixels)


@pytest.mark.parametrize("dtype", [np.float16, np.float32])
def test_floats_in_exr(tmp_path, rng, dtype):
    pixels = rng.normal(0.0, 100.0, (6, 4, 3)).astype(dtype)
    spherepacking.write_image(tmp_path / "a.exr", pixels)
    back = spherepacking.read_image(tmp_path / "a.exr")
    assert back.dtype == dtype
    assert np.array_equal(back, pixels)


def test_floats_in_png_are_rounded_and_clamped(tmp_path):
    spherepacking.write_image(tmp_path / "a.png", np.array([[-1.0, 0.0, 0.5, 1.0, 7.0]]))
    back = spherepacking.read_image(tmp_path / "a.png")
    white = np.iinfo(back.dtype).max
    assert back.ravel() / white == pytest.approx([0.0, 0.0, 0.5, 1.0, 1.0], abs=1.0 / white)


def test_unknown_extension_names_file_and_reason(tmp_path):
    path = tmp_path / "a.nonsense"
    for attempt in (check_output, lambda p: spherepacking.write_image(p, np.zeros((2, 2)))):
        with pytest.raises(ValueError, match=r"a\.nonsense.*nonsense"):
            attempt(path)
    assert not path.exists()


def test_missing_folder(tmp_path):
    with pytest.raises(FileNotFoundError, match="there is no folder"):
        spherepacking.write_image(tmp_path / "none" / "a.png", np.zeros((2, 2)))


def test_folder_instead_of_file(tmp_path):
    (tmp_path / "a.png").mkdir()
    with pytest.raises(OSError, match=r"a\.png"):
        spherepacking.write_image(tmp_path / "a.png", np.zeros((2, 2)))


FORMATS = ("png", "jpg", "exr", "tif", "gif")

# A limit on the size of files is what a full disk looks like to a writer.
FULL_DISK = """
import resource, signal, sys
import numpy as np, spherepacking
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
pixels = np.random.default_rng(0).integers(0, 256, (300, 300, 3), dtype=np.uint8)
try:
    spherepacking.write_image(sys.argv[1], pixels)
except OSError as error:
    print(error)
"""


@pytest.mark.parametrize("extension", FORMATS)
def test_a_full_disk_loses_nothing(tmp_path, extension):
    path = tmp_path / f"a.{extension}"
    path.write_text("earlier work")
    done = subprocess.run(
        [sys.executable, "-c", FULL_DISK, path],
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout == f"{path}: the picture cannot be written (File too large)\n"
    assert done.stderr == ""
    assert path.read_text() == "earlier work"
    assert os.listdir(tmp_path) == [path.name]


def test_a_full_disk_when_the_picture_is_whole(tmp_path):
    path = tmp_path / "a.png"
    path.write_text("earlier work")
    code = f"""
{FULL_DISK.split("pixels", maxsplit=1)[0]}
from pathlib import Path
from spherepacking.files.replace import replace_file
try:
    replace_file(Path(sys.argv[1]), bytes(5000))
except OSError as error:
    print(error)
"""
    done = subprocess.run(
        [sys.executable, "-c", code, path], capture_output=True, text=True, check=True
    )
    assert done.stdout == f"{path}: the file cannot be written (File too large)\n"
    assert path.read_text() == "earlier work"
    assert os.listdir(tmp_path) == [path.name]


@pytest.mark.parametrize("extension", FORMATS)
def test_a_picture_is_replaced_behind_a_link_and_keeps_its_mode(tmp_path, rng, extension):
    target, link = tmp_path / "target", tmp_path / f"link.{extension}"
    target.write_text("old")
    target.chmod(0o640)
    link.symlink_to(target)
    spherepacking.write_image(link, rng.integers(0, 256, (5, 9, 3), dtype=np.uint8))
    assert link.is_symlink()
    assert target.stat().st_mode & 0o777 == 0o640
    assert spherepacking.read_image(link).shape[:2] == (5, 9)
    assert sorted(os.listdir(tmp_path)) == sorted([link.name, "target"])


def test_many_at_once(tmp_path, rng):
    """The last one wins, and nobody ever sees half a picture."""
    path = tmp_path / "a.png"
    pictures = [rng.integers(0, 256, (60, 50, 3), dtype=np.uint8) for _ in range(4)]

    def write_often(picture):
        for _ in range(25):
            spherepacking.write_image(path, picture)
            found = spherepacking.read_image(path)
            assert any(np.array_equal(found, each) for each in pictures)

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(write_often, pictures))
    assert os.listdir(tmp_path) == ["a.png"]


def test_the_longest_name(tmp_path):
    path = tmp_path / ("a" * 251 + ".png")
    spherepacking.write_image(path, np.zeros((2, 2)))
    assert os.listdir(tmp_path) == [path.name]


def test_a_name_that_is_no_text(tmp_path):
    path = tmp_path / os.fsdecode(b"a\xff.png")
    spherepacking.write_image(path, np.zeros((2, 2)))
    assert path.is_file()


def test_links(tmp_path):
    (tmp_path / "to_nothing.png").symlink_to("b.png")
    spherepacking.write_image(tmp_path / "to_nothing.png", np.zeros((2, 2)))
    assert (tmp_path / "to_nothing.png").is_symlink()
    assert spherepacking.read_image(tmp_path / "b.png").shape == (2, 2, 1)
    (tmp_path / "circle.png").symlink_to("circle.png")
    with pytest.raises(OSError, match=r"circle\.png: found links that lead in a circle"):
        spherepacking.write_image(tmp_path / "circle.png", np.zeros((2, 2)))


@pytest.mark.parametrize("extension", ["null", "term"])
def test_what_is_no_file(tmp_path, extension):
    with pytest.raises(ValueError, match="no picture format of that extension can be written"):
        spherepacking.write_image(tmp_path / f"a.{extension}", np.zeros((2, 2)))
    assert os.listdir(tmp_path) == []


def test_devices_and_pipes_are_not_replaced(tmp_path):
    (tmp_path / "device.png").symlink_to("/dev/full")
    os.mkfifo(tmp_path / "pipe.png")
    for name in ("device.png", "pipe.png"):
        for attempt in (check_output, lambda p: spherepacking.write_image(p, np.zeros((2, 2)))):
            with pytest.raises(OSError, match=rf"{name}: found something that is no regular file"):
                attempt(tmp_path / name)


def test_reading_no_file(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"a\.png: no such file"):
        spherepacking.read_image(tmp_path / "a.png")


def test_reading_no_picture(tmp_path):
    path = tmp_path / "a.png"
    path.write_text("1 2 3 4\n")
    with pytest.raises(OSError, match=r"a\.png: the picture cannot be read: \S+"):
        spherepacking.read_image(path)


def test_reading_a_cut_picture(tmp_path, rng):
    path = tmp_path / "a.png"
    spherepacking.write_image(path, rng.integers(0, 256, (64, 64, 3), dtype=np.uint8))
    path.write_bytes(path.read_bytes()[:2000])
    with pytest.raises(OSError, match=r"a\.png: the picture cannot be read: \S+"):
        spherepacking.read_image(path)


@pytest.mark.parametrize("pixels", [np.zeros(5), np.zeros((2, 2, 2, 2)), np.zeros((0, 4, 3))])
def test_no_shape_of_a_picture(tmp_path, pixels):
    with pytest.raises(ValueError, match=r"pixels: found shape .*expected \(height, width"):
        spherepacking.write_image(tmp_path / "a.png", pixels)


@pytest.mark.parametrize("pixels", [np.zeros((2, 2), complex), np.zeros((2, 2), int)])
def test_no_type_of_a_picture(tmp_path, pixels):
    with pytest.raises(TypeError, match=r"pixels: found (complex|int)"):
        spherepacking.write_image(tmp_path / "a.png", pixels)


def test_differences_are_those_of_numpy(rng):
    first = rng.integers(0, 256, (20, 30, 3), dtype=np.uint8)
    second = rng.integers(0, 256, (20, 30, 3), dtype=np.uint8)
    error = np.abs(first / 255.0 - second / 255.0)
    difference = spherepacking.compare_images(first, second)
    assert difference.mean == pytest.approx(error.mean(), rel=1e-5)
    assert difference.rms == pytest.approx(np.sqrt((error**2).mean()), rel=1e-5)
    assert difference.maximum == pytest.approx(error.max(), rel=1e-5)
    # The peak to signal ratio is a fact about rms and white.
    assert difference.psnr == pytest.approx(-20.0 * np.log10(difference.rms), abs=0.01)


def test_equal_pictures_do_not_differ(rng):
    pixels = rng.random((8, 8, 4))
    difference = spherepacking.compare_images(pixels, pixels)
    assert (difference.mean, difference.rms, difference.maximum) == (0.0, 0.0, 0.0)
    assert difference.psnr == np.inf


def test_shapes_that_differ():
    with pytest.raises(
        ValueError, match=r"second: found shape \(3, 2, 1\), expected .*\(2, 3, 1\)"
    ):
        spherepacking.compare_images(np.zeros((2, 3)), np.zeros((3, 2)))


@pytest.mark.parametrize(
    "extension", ["png", "tif", "exr", "jpg", "bmp", "tga", "webp", "jp2", "gif", "ppm", "hdr"]
)
def test_strips_make_the_same_file(tmp_path, rng, extension):
    pixels = rng.integers(0, 256, (61, 40, 3)).astype(np.uint8)
    whole, strips = tmp_path / f"whole.{extension}", tmp_path / f"strips.{extension}"
    try:
        write_image(whole, pixels)
    except ValueError:
        pytest.skip("OpenImageIO does not write it")
    write_strips(strips, pixels.shape, pixels.dtype, (pixels[i : i + 7] for i in range(0, 61, 7)))
    assert (read_image(strips) == read_image(whole)).all()


def test_what_fails_between_strips_leaves_nothing(tmp_path):
    def strips():
        yield np.zeros((7, 40, 3), np.uint8)
        raise RuntimeError("the rest cannot be drawn")

    path = tmp_path / "a.png"
    path.write_bytes(b"what was there")
    with pytest.raises(RuntimeError, match="the rest cannot be drawn"):
        write_strips(path, (61, 40, 3), np.dtype(np.uint8), strips())
    assert path.read_bytes() == b"what was there"
    assert list(tmp_path.iterdir()) == [path]


def test_large_pictures_are_checked_by_rows(tmp_path, rng, monkeypatch):
    """What cannot be read back is no picture; little of it is read at a time."""
    pixels = rng.integers(0, 256, (61, 40, 3)).astype(np.uint8)
    monkeypatch.setattr(image, "_ROOM_TO_CHECK", 1000)
    write_image(tmp_path / "a.png", pixels)
    assert (read_image(tmp_path / "a.png") == pixels).all()
    whole = (tmp_path / "a.png").read_bytes()
    (tmp_path / "a.png").write_bytes(whole[: len(whole) // 2])
    assert not image._can_be_read(tmp_path / "a.png")
