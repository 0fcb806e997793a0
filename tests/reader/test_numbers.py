"""Numbers against Python's float(), and for single precision against exact fractions."""

import hashlib
import locale
import math
import os
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

HARD = [
    "0",
    "-0",
    "-0.0",
    "+1.5",
    "1.",
    ".5",
    "-.5e-3",
    "+.5E+3",
    "1e23",
    "8.5e22",
    "9007199254740993",
    "9007199254740992.9999999999999999999999999999",
    "9007199254740993.00000000000000000000000000000000000000001",
    "0.1000000000000000055511151231257827021181583404541015625",
    "0.10000000000000001249000902703301107976585626602172851562499999",
    "0.1000000000000000124900090270330110797658562660217285156250",
    "2.2250738585072011e-308",
    "2.2250738585072014e-308",
    "4.9406564584124654e-324",
    "2.4703282292062327208299493357e-324",
    "2.4703282292062328e-324",
    "2.4703282292062327e-324",
    "1e-400",
    "-1e-400",
    "1e-99999999999",
    "0e99999999999",
    "1.7976931348623157e308",
    "1.7976931348623158e308",
    "123456789012345678901234567890",
    "0." + "0" * 400 + "1e400",
    "1" + "0" * 300 + "e-300",
    "3." + "1" * 800,
    "6.02214076e23",
    "1e+05",
    "00012.50",
]


def bits(values):
    return np.asarray(values, dtype=np.float64).view(np.uint64).tolist()


def nearest_float32(text):
    """The float32 nearest to a decimal, ties to even, by exact arithmetic."""
    exact = Fraction(text)
    near = np.float32(float(exact))
    with np.errstate(over="ignore"):
        candidates = [near] + [np.nextafter(near, np.float32(to)) for to in (np.inf, -np.inf)]
    finite = [c for c in candidates if np.isfinite(c)]
    return min(finite, key=lambda c: (abs(Fraction(float(c)) - exact), int(c.view(np.uint32)) & 1))


@pytest.mark.parametrize("text", HARD, ids=range(len(HARD)))
def test_hard_numbers_round_as_pythons(read_text, text):
    packing = read_text(f"{text} 1 {text} 1\n")
    assert bits(packing.points[0]) == bits([float(text), 1, float(text)])


def test_random_numbers_of_many_forms_round_as_pythons(read_text):
    rng = np.random.default_rng(20240607)
    values = rng.integers(0, 2**64, 40000, dtype=np.uint64).view(np.float64)
    values = values[np.isfinite(values)]
    values = values[: values.size // 4 * 4].reshape(-1, 4)
    values[:, 3] = abs(values[:, 3])
    forms = ["{!r}", "{:.17g}", "{:.20e}", "{:.25g}", "{:.3g}"]
    rows = [
        [forms[(i + j) % 5].format(v) for j, v in enumerate(row)]
        for i, row in enumerate(values.tolist())
    ]
    # A short form of the largest values may round beyond all doubles.
    rows = [row for row in rows if all(math.isfinite(float(text)) for text in row)]
    packing = read_text("\n".join(map(" ".join, rows)) + "\n", chunk=1000)
    expected = np.array([[float(text) for text in row] for row in rows])
    assert len(rows) > 9000
    assert bits(packing.points) == bits(expected[:, :3])
    assert bits(packing["radius"]) == bits(expected[:, 3])


def short_decimals():
    """All lengths before and after the point up to 10, with and without signs and neighbours."""
    rng = np.random.default_rng(99)
    texts = []
    for before in range(11):
        for after in range(11):
            for sign in ("", "-", "+"):
                for digits in ("0", "9", None):
                    pick = [str(d) for d in rng.integers(0, 10, before + after)]
                    pick = pick if digits is None else [digits] * (before + after)
                    if pick:
                        texts.append(sign + "".join(pick[:before]) + "." + "".join(pick[before:]))
                        texts.append(texts[-1] + "e-3")
    return texts


@pytest.mark.parametrize("separator", [" ", ",", "\t"])
def test_short_decimals_round_as_pythons(read_text, separator):
    texts = short_decimals()
    rows = [separator.join([text, "1", text, text.lstrip("-")]) for text in texts]
    packing = read_text("\n".join(rows) + "\n", chunk=5000)
    expected = [float(text) for text in texts]
    assert bits(packing.points[:, 0]) == bits(packing.points[:, 2]) == bits(expected)
    assert bits(packing["radius"]) == bits(np.abs(expected))


def test_short_decimals_round_once_to_single_precision(read_text):
    texts = short_decimals()
    packing = read_text("\n".join(f"{text} 0 0 1" for text in texts), single=True)
    got = packing.points[:, 0].copy().view(np.uint32) & 0x7FFFFFFF
    expected = np.array([abs(nearest_float32(text)) for text in texts]).view(np.uint32)
    assert got.tolist() == expected.tolist()


@pytest.mark.parametrize(
    "text",
    ["1.5x", "1.5.", "1.5e", "1..5", "1.5-", "--1.5", "-+1.5", "+-1.5", "1.5_0", "1.:", "1./"],
)
@pytest.mark.parametrize("tail", ["", " " * 20])
def test_what_is_nearly_a_short_decimal(read_error, tmp_path, text, tail):
    (tmp_path / "p.spheres").write_text(f"0 {text} 0 1{tail}\n{tail}")
    message, _ = read_error(tmp_path / "p.spheres")
    assert f"line 1: found '{text}' as y in column 2, expected a number" in message


@pytest.mark.parametrize("line_end", ["\n", "\r\n", " \n", "\r"])
def test_rows_of_short_decimals_round_as_pythons(read_text, line_end):
    # Rows about as long as what is scanned at once, and far shorter and longer ones.
    rng = np.random.default_rng(5)

    def number(most_before, most_after, sign):
        before, after = rng.integers(1, most_before + 1), rng.integers(1, most_after + 1)
        digits = "".join(map(str, rng.integers(0, 10, before + after)))
        return f"{sign}{digits[:before]}.{digits[before:]}"

    rows = []
    for most in [(1, 7), (3, 6), (8, 7), (9, 9)]:
        for _ in range(2000):
            signs = [*rng.choice(["", "-"], 3), ""]
            rows.append([number(*most, sign) for sign in signs])
    rows += [["-0.0", "0.0", "-0.0000000", "0.0"], ["99999999.9999999"] * 4]
    text = line_end.join(" ".join(row) for row in rows) + line_end
    packing = read_text(text, chunk=5000)
    expected = np.array([[float(field) for field in row] for row in rows])
    assert bits(packing.points) == bits(expected[:, :3])
    assert bits(packing["radius"]) == bits(expected[:, 3])


def test_rows_of_short_decimals_round_once_to_single_precision(read_text):
    rng = np.random.default_rng(6)
    rows = [
        [f"{x:.{n}f}" for x in abs(rng.normal(size=4))] for n in (1, 3, 6, 7) for _ in range(500)
    ]
    packing = read_text("\n".join(" ".join(row) for row in rows), single=True)
    expected = np.array([[nearest_float32(field) for field in row] for row in rows], np.float32)
    assert packing.points.tolist() == expected[:, :3].tolist()
    assert packing["radius"].tolist() == expected[:, 3].tolist()


HASHES = """
import hashlib, sys
import pyvista as pv
from spherepacking.vtkSpherePackingCore import vtkSpherePackingReader as Reader

for precision in (Reader.DOUBLE_PRECISION, Reader.SINGLE_PRECISION):
    reader = Reader()
    reader.SetFileName(sys.argv[1])
    reader.SetOutputPointsPrecision(precision)
    reader.Update()
    packing = pv.wrap(reader.GetOutput())
    values = packing.points.tobytes() + packing["radius"].tobytes()
    print(hashlib.sha256(values).hexdigest())
"""


@pytest.mark.parametrize("without", [{}, {"SPHEREPACKING_WITHOUT_AVX2": "1"}], ids=["avx2", "any"])
def test_rows_of_short_decimals_on_every_processor(tmp_path, without):
    rng = np.random.default_rng(7)
    fields = [f"{x:.{n}f}" for n in range(8) for x in rng.normal(scale=40, size=1000)]
    rows = np.reshape(fields, (-1, 4)).tolist()
    rows = [[*row[:3], row[3].lstrip("-")] for row in rows]
    path = tmp_path / "p.spheres"
    path.write_text("\n".join(" ".join(row) for row in rows) + "\n")
    wanted = []
    for kind, number in ((np.float64, float), (np.float32, nearest_float32)):
        values = np.array([[number(field) for field in row] for row in rows], kind)
        # Fraction has no sign of zero.
        zero = np.array([[field.startswith("-") for field in row] for row in rows]) & (values == 0)
        values[zero] = -0.0
        packed = values[:, :3].tobytes() + values[:, 3].tobytes()
        wanted.append(hashlib.sha256(packed).hexdigest())
    command = [sys.executable, "-c", HASHES, str(path)]
    done = subprocess.run(
        command, env=os.environ | without, capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == wanted


@pytest.mark.parametrize(
    ("row", "message"),
    [
        ("1.5 2.-5 3.5 4.5", "found '2.-5' as y"),
        ("1.5 2-.5 3.5 4.5", "found '2-.5' as y"),
        ("1.5 2.5.5 3.5 4.5", "found '2.5.5' as y"),
        ("1.5 - 2.5 3.5 4.5", "found '-' as y"),
        ("--1.5 2.5 3.5 4.5", "found '--1.5' as x"),
        ("1.5 --2.5 3.5 4.5", "found '--2.5' as y"),
        ("1.5 2.5 3:5 4.5", "found '3:5' as z"),
        ("1.5 2.5 3.5/4.5 4.5", "found '3.5/4.5' as z"),
        ("1.5 2.5 3.5 -4.5", "found '-4.5' as radius"),
        ("1.5 2.5 3.5 4.5 5.5", "found 5 columns"),
        ("1.5 2.5 3.5", "found 3 columns"),
        ("1.5 2.5 3.5 4.5x", "found '4.5x' as radius"),
        ("1.5 2.5 3.5 4.\u06655", "found '4.\u06655' as radius"),
    ],
)
def test_what_is_nearly_a_row_of_short_decimals(read_error, tmp_path, row, message):
    good = "1.5 -2.5 3.5 4.5\n"
    (tmp_path / "p.spheres").write_text(f"{good}{row}\n{good * 20}", encoding="utf-8")
    found, _ = read_error(tmp_path / "p.spheres")
    assert "line 2: " in found
    assert message in found


def test_halfway_cases_round_to_even(read_text):
    rng = np.random.default_rng(7)
    texts = []
    for value in abs(rng.normal(size=300)):
        up = np.nextafter(value, np.inf)
        middle = (Fraction(value) + Fraction(float(up))) / 2
        digits = str(middle.numerator * 10**1100 // middle.denominator).rjust(1101, "0")
        exact = digits[:-1100] + "." + digits[-1100:].rstrip("0")
        texts += [exact, exact + "0" * 20 + "1"]
    packing = read_text("\n".join(f"{text} 0 0 1" for text in texts))
    assert bits(packing.points[:, 0]) == bits([float(text) for text in texts])


@pytest.mark.parametrize(
    "text",
    [
        "16777217",
        "16777217.000000000000000000001",
        "0.1",
        "1.000000059604644775390625",
        "1.00000005960464477539062500000000000000000001",
        "1.4e-45",
        "7.006492321624085e-46",
        "7.0064923216240854e-46",
        "1e-50",
        "3.4028235e38",
        "1.17549435e-38",
        "0.50000002980232241545",
    ],
)
def test_single_precision_rounds_once(read_text, text):
    packing = read_text(f"{text} 0 0 1\n", single=True)
    assert packing.points[0, 0].view(np.uint32) == nearest_float32(text).view(np.uint32)


def test_the_reference_for_single_precision_is_not_that_of_double_rounding():
    text = "1.00000005960464477539062500000000000000000001"
    assert nearest_float32(text) != np.float32(float(text))


finite = st.floats(allow_nan=False, allow_infinity=False)
radius = st.floats(min_value=0, max_value=1.7e308 / 2, allow_nan=False)
finite32 = st.floats(width=32, allow_nan=False, allow_infinity=False)
radius32 = st.floats(min_value=0, width=32, allow_nan=False, allow_infinity=False)


@pytest.mark.parametrize("extension", ["spheres", "csv", "xyzr", "txt", "xyzd"])
@settings(
    deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=50
)
@given(rows=st.lists(st.tuples(finite, finite, finite, radius), min_size=1, max_size=20))
def test_written_doubles_read_back_bit_for_bit(read, write, tmp_path, extension, rows):
    import pyvista as pv

    rows = np.array(rows)
    packing = pv.PolyData(rows[:, :3].copy())
    packing["radius"] = rows[:, 3]
    path = tmp_path / f"p.{extension}"
    assert write(packing, path) == (True, "")
    back = read(path)
    assert bits(back.points) == bits(rows[:, :3])
    assert bits(back["radius"]) == bits(rows[:, 3])


@pytest.mark.parametrize("extension", ["spheres", "csv", "xyzr", "txt", "xyzd"])
@settings(
    deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=50
)
@given(rows=st.lists(st.tuples(finite32, finite32, finite32, radius32), min_size=1, max_size=20))
def test_written_floats_read_back_bit_for_bit(read, write, tmp_path, extension, rows):
    import pyvista as pv

    rows = np.array(rows, dtype=np.float32)
    packing = pv.PolyData(rows[:, :3].copy())
    packing["radius"] = rows[:, 3]
    assert packing.points.dtype == np.float32
    path = tmp_path / f"p.{extension}"
    assert write(packing, path) == (True, "")
    back = read(path, single=True)
    assert back.points.view(np.uint32).tolist() == rows[:, :3].copy().view(np.uint32).tolist()
    assert back["radius"].view(np.uint32).tolist() == rows[:, 3].copy().view(np.uint32).tolist()
    assert bits(read(path).points) == bits(rows[:, :3]), "and as doubles"


@pytest.fixture
def comma_locale():
    before = locale.setlocale(locale.LC_ALL)
    for name in ["de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8", "de_DE"]:
        try:
            locale.setlocale(locale.LC_ALL, name)
        except locale.Error:
            continue
        assert locale.localeconv()["decimal_point"] == ","
        yield name
        locale.setlocale(locale.LC_ALL, before)
        return
    pytest.skip("no locale with a decimal comma: de_DE.UTF-8, fr_FR.UTF-8")


def test_a_locale_with_decimal_commas_changes_nothing(comma_locale, read, write, tmp_path):
    import pyvista as pv

    packing = pv.PolyData(np.array([[0.5, -1234.5, 1e-3]]))
    packing["radius"] = np.array([2.25])
    for extension in ["spheres", "csv", "xyzr", "txt", "xyzd"]:
        path = tmp_path / f"p.{extension}"
        assert write(packing, path) == (True, "")
        back = read(path)
        assert back.points.tolist() == [[0.5, -1234.5, 1e-3]]
        assert back["radius"].tolist() == [2.25]
    assert (tmp_path / "p.csv").read_text() == "x,y,z,radius\n0.5,-1234.5,0.001,2.25\n"
