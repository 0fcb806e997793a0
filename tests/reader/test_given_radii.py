"""Tables without names beside radii that the user gives, and first columns of times."""

import pytest

IDS = "1 2.3 1.0 0.7\n2 2.1 1.1 0.9\n3 1 2 3.5\n"


def centers(packing):
    return packing.points.tolist()


@pytest.fixture
def refused(read_error, tmp_path):
    """Read a text that has to be refused: the message without the name of the file."""

    def read(text, name="p.txt", **options):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        message, _ = read_error(path, **options)
        return message.removeprefix(str(path))

    return read


class TestGivenRadii:
    """Who gives radii says that the fourth column need not hold them."""

    @pytest.mark.parametrize("single", [False, True])
    @pytest.mark.parametrize(
        ("text", "others"),
        [
            ("1.5 2.5 3.5 7\n1 2 3 8\n", {"column_4": [7, 8]}),
            (
                "1.5 2.5 3.5 0.5 -2 0.25\n1 2 3 0.125 4 8\n",
                {"column_4": [0.5, 0.125], "column_5": [-2, 4], "column_6": [0.25, 8]},
            ),
            ("# by hand\n1.5 2.5 3.5 -7\n1 2 3 8\n", {"column_4": [-7, 8]}),
            ("# x y z of grains\n1.5 2.5 3.5 7\n1 2 3 8\n", {"column_4": [7, 8]}),
            ("1.5, 2.5, 3.5, 7\n1, 2, 3, 8\n", {"column_4": [7, 8]}),
            ("1.5 2.5 3.5 7\n# x y z r\n1 2 3 8\n", {"column_4": [7, 8]}),
        ],
    )
    def test_no_column_is_lost(self, read_text, text, others, single):
        packing = read_text(text, "p.txt", optional=True, single=single)
        assert centers(packing) == [[1.5, 2.5, 3.5], [1, 2, 3]]
        assert {name: packing[name].tolist() for name in packing.array_names} == others

    def test_texts_are_kept(self, read_text):
        packing = read_text("1.5 2.5 3.5 sand\n1 2 3 clay\n", "p.txt", optional=True)
        assert packing["column_4"].tolist() == ["sand", "clay"]

    @pytest.mark.parametrize("name", ["p.xyzr", "p.spheres"])
    def test_the_extension_names_the_radius(self, read_text, name):
        packing = read_text("5 2.5 3.5 7\n6 2 3 8\n", name, optional=True)
        assert packing["radius"].tolist() == [7, 8]

    @pytest.mark.parametrize(
        "text",
        [
            IDS,
            "3 2.3 1.0 0.7\n1 2.1 1.1 0.9\n2 1 2 3.5\n",
            "1 2.3 1.0 0.7\n",
            "1.0 2.3 1.0 0.7\n2.0 2.1 1.1 0.9\n",
            "0 2.3 1.0 0.7\n1 2.1 1.1 0.9\n",
            "# from Voro++\n" + IDS,
            "7 2.3 1.0 0.7\n7 2.1 1.1 0.9\n",
        ],
    )
    def test_ids_are_not_x(self, refused, read_text, text):
        message = refused(text, optional=True)
        assert "in the first column of 4, which may be ids rather than x" in message
        assert 'columns="id x y z" or columns="x y z -" (--columns)' in message
        first = [float(field) for field in text.splitlines()[-1].split()]
        packing = read_text(text, "p.txt", optional=True, columns="id x y z")
        assert centers(packing)[-1] == first[1:]
        packing = read_text(text, "p.txt", optional=True, columns="x y z value")
        assert centers(packing)[-1] == first[:3]

    def test_without_given_radii_four_are_a_sphere(self, read_text):
        assert read_text(IDS, "p.txt")["radius"].tolist() == [0.7, 0.9, 3.5]

    def test_coordinates_on_a_grid(self, read_text):
        packing = read_text("0 0 0 0.5\n0 1 0 0.25\n1 0 0 0.5\n", "p.txt", optional=True)
        assert packing["column_4"].tolist() == [0.5, 0.25, 0.5]

    def test_a_later_comment_of_other_columns(self, refused):
        message = refused("1.5 2.5 3.5 7\n# z y x r\n1 2 3 8\n", optional=True)
        assert "expected the same columns in all rows" in message


TIMES = "0.0 1.5 2.5 3.5 0.5\n0.0 1.25 2 3 0.75\n0.1 1.5 2 3 .5\n0.1 1.25 2 3 .5\n"


class TestTimes:
    """A first column that repeats and never falls may hold times."""

    @pytest.mark.parametrize("single", [False, True])
    @pytest.mark.parametrize(
        "text",
        [
            TIMES,
            "0.5 1.5 2.5 3.5 0.5\n0.5 1.25 2 3 0.75\n",
            "1e-3 1 2 3 1\n1e-3 4 5 6 1\n2e-3 1 2 3 1\n2e-3 4 5 6 1\n",
        ],
    )
    def test_refused(self, refused, read_text, text, single):
        message = refused(text, single=single)
        assert message.startswith(", line 1: found numbers that repeat and never fall in the first")
        assert 'columns="time x y z r" or columns="x y z r -" (--columns)' in message
        for columns, begin in (("time x y z r", 1), ("x y z r -", 0)):
            packing = read_text(text, columns=columns)
            rows = [[float(f) for f in row.split()][begin : begin + 3] for row in text.splitlines()]
            assert packing.points.astype("f4").tolist() == pytest.approx(
                [pytest.approx(row) for row in rows]
            )

    def test_six_columns(self, refused):
        text = "".join(f"{row} 9\n" for row in TIMES.splitlines())
        assert 'columns="time x y z r -" or columns="x y z r - -"' in refused(text)

    def test_beside_given_radii(self, refused):
        message = refused("0.0 1 2 3\n0.0 4 5 6\n0.1 1 2 3\n0.1 4 5 6\n", optional=True)
        assert 'columns="time x y z" or columns="x y z -"' in message

    @pytest.mark.parametrize(
        "text",
        [
            "0.1 1.5 2.5 0.5 9\n0.0 1.25 2 3 9\n0.1 1.5 2 3 9\n0.1 1.25 2 3 9\n",
            "0.1 1.5 2.5 0.5 9\n0.2 1.25 2 3 9\n0.3 1.5 2 3 9\n",
            "-0.5 1.5 2.5 0.5 9\n-0.5 1.25 2 3 9\n0.5 1.5 2 3 9\n0.5 1.25 2 3 9\n",
            "0.5 1.5 2.5 0.5 9\n",
            "0.0 1.5 2.5 3.5\n0.0 1.25 2 3\n0.1 1.5 2 3\n0.1 1.25 2 3\n",
            "# x y z r and a label\n" + TIMES,
            "0.5 1 2 3 9\n0.5 1 2 3 8\n",
        ],
        ids=["falls", "all differ", "a sign", "one row", "four columns", "named", "one place"],
    )
    def test_coordinates(self, read_text, text):
        rows = [[float(f) for f in row.split()] for row in text.splitlines() if row[0] != "#"]
        packing = read_text(text, "p.txt")
        assert centers(packing) == [row[:3] for row in rows]
        assert packing["radius"].tolist() == [row[3] for row in rows]


def test_a_first_row_that_may_be_a_box(refused, read_text):
    text = "1 2 3 4\n1 2 3 4\n"
    assert 'or columns="x y z r" (--columns)' in refused(text)
    assert read_text(text, columns="x y z r").n_points == 2
