"""The command ``spherepacking bench``."""

import csv
import importlib.util
import itertools

import pytest
import spherepacking
from spherepacking.bench import command, fields
from spherepacking.cli import main as cli


def bench(tmp_path, *arguments):
    files = ["--csv", tmp_path / "b.csv", "--png", tmp_path / "b.png"]
    return cli.main([str(word) for word in ("bench", *files, *arguments)])


def test_table_csv_and_picture(tmp_path, capsys):
    options = [
        "--counts",
        400,
        100,
        "--size",
        80,
        60,
        "--turns",
        1,
        "--only",
        "OpenGL",
        "ray cast, bvh",
    ]
    assert bench(tmp_path, *options) == 0
    said = capsys.readouterr().out
    lines = (tmp_path / "b.csv").read_text().splitlines()
    assert [line.split(",")[0] for line in lines[1:]] == ["OpenGL", *["ray cast"] * 3] * 2
    for word in ("ray cast, bvh, 9 rays", "OpenGL", "400", "100"):
        assert word in said
    picture = spherepacking.read_image(tmp_path / "b.png").astype(int)
    assert picture.shape == (1500, 3000, 3)
    # Each of these charts has lines in the colours of the techniques.
    for quarter in (picture[:750, :1000], picture[:750, 1000:2000], picture[:750, 2000:]):
        assert (abs(quarter - [0x1F, 0x77, 0xB4]).sum(axis=-1) < 30).sum() > 50
        assert (abs(quarter - [0xD6, 0x27, 0x28]).sum(axis=-1) < 30).sum() > 50


def test_light_is_measured_once(tmp_path, capsys):
    options = ["--counts", 100, 300, "--size", 80, 60, "--turns", 1, "--only", "path trace"]
    assert bench(tmp_path, *options) == 0
    assert "path trace, bvh, 16 paths" in capsys.readouterr().out
    with (tmp_path / "b.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["spheres"] for row in rows] == ["300"] * 5
    assert [row["rays"] for row in rows] == ["1", "4", "16", "64", "256"]
    errors = [float(row["relative_mse"]) for row in rows]
    assert all(b < a / 3 for a, b in itertools.pairwise(errors))
    assert {row["wrong_pixels"] for row in rows} == {"0"}
    if importlib.util.find_spec("flip_evaluator"):
        visible = [float(row["flip"]) for row in rows]
        assert visible == sorted(visible, reverse=True)
    else:
        assert {row["flip"] for row in rows} == {""}


def test_what_is_done_is_kept(tmp_path, monkeypatch, capsys):
    def stopped(*arguments, **kwargs):
        rows = whole(*arguments, **kwargs)
        yield next(rows)
        rows.close()
        raise KeyboardInterrupt

    whole = command.measure
    monkeypatch.setattr(command, "measure", stopped)
    options = ["--counts", 100, 200, "--size", 40, 30, "--turns", 1, "--only", "cast, bvh"]
    assert bench(tmp_path, *options) == 130
    assert "ray cast, bvh" in capsys.readouterr().out
    assert len((tmp_path / "b.csv").read_text().splitlines()) == 4
    assert (tmp_path / "b.png").is_file()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--counts", 99], "--counts: found [99], expected numbers from 100"),
        (["--only", "fluid"], "--only: found 'fluid', expected a part of: OpenGL;"),
        (["--turns", 0], "--turns: found 0, expected 1 or more"),
        (["--limit", "nan"], "--limit: found nan, expected a finite number of seconds"),
        (["--size", 0, 5], "--size: found 0 5, expected numbers of pixels"),
        (["--png", "no/b.png"], "no/b.png: there is no folder"),
        (["--csv", "no/b.csv"], "no/b.csv: there is no folder"),
    ],
)
def test_bad_arguments(tmp_path, monkeypatch, capsys, options, message):
    monkeypatch.chdir(tmp_path)
    assert cli.main(["bench", *map(str, options)]) == 2
    said = capsys.readouterr().err
    assert message in said
    assert len(said.splitlines()) == 1
    assert list(tmp_path.iterdir()) == []


def test_metaballs_have_rows_of_their_own(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(fields, "GRIDS", (16, 48))
    assert bench(tmp_path, "--counts", 300, "--turns", 1, "--only", "metaballs") == 0
    assert "Metaballs" in capsys.readouterr().out
    with (tmp_path / "b_metaballs.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert not (tmp_path / "b.csv").exists()
    found = [row for row in rows if row["what"] == "field"]
    assert [float(row["relative_error"]) for row in found] == list(fields.TOLERANCES)
    for row in found:
        assert float(row["field_error"]) <= max(float(row["relative_error"]), 1e-5)
    coarse, fine = (row for row in rows if row["what"] == "surface")
    # In lengths; the numbers are in spacings.
    assert float(fine["distance"]) * 16 < float(coarse["distance"]) * 48
