"""What messages about tables say that a user can do."""

import pytest


@pytest.fixture
def refused(read_error, tmp_path):
    """Read a text that has to be refused: the message without the name of the file."""

    def read(text, name="p.csv", **options):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        message, _ = read_error(path, **options)
        return message.removeprefix(str(path))

    return read


@pytest.mark.parametrize(
    "text",
    [
        "x;y;z;radius\n0,5;0;0;1,5\n1,25;2;3;2\n",
        "x;y;z;radius\n0;0;0;-1,5e3\n",
        'x,y,z,radius\n"0,5",0,0,1\n',
        b"\xef\xbb\xbfx;y;z;radius\r\n0,5;0;0;1,5\r\n",
        "x\ty\tz\tr\n0,5\t0\t0\t1,5\n",
    ],
)
def test_decimal_commas_in_csv(refused, text):
    message = refused(text)
    assert message.startswith(", line 2: found ")
    assert "which looks like a decimal comma, expected a number with a point" in message


@pytest.mark.parametrize("head", ["x y z r\n", "# x y z r\n1 2 3 4\n", "1 2 3 4\n"])
def test_decimal_commas_between_blanks(refused, head):
    message = refused(head + "0,1 0,2 0,3 0,05\n", "p.txt")
    assert "found what looks like decimal commas in '0,1 0,2 0,3 0,05', expected" in message


def test_thousands_are_no_decimal_commas(refused):
    message = refused("x;y;z;r\n1,000.5;2;3;4\n")
    assert message.endswith("expected a number")


def test_rows_without_numbers(refused):
    message = refused("x,y,z,r\nlength,length,length,size\n1,2,3,4\n")
    assert message.startswith(", line 2: found 'length,length,length,size', in which no field is a")
    assert "# before what is no row" in message
    message = refused("x,y,z,r\n1,2,3,4\n,,,\n")
    assert message.startswith(", line 3: found ',,,', a row of empty fields, expected 4 columns")
    assert message.endswith("delete the row")


def test_a_title(refused):
    message = refused("Sample 3\n\nx,y,z,r\n1,2,3,4\n")
    assert message.startswith(", line 1: found the columns 'Sample 3', expected a header")
    assert "# before titles above it" in message
    assert 'columns="' in message


def test_names_of_one_thing(refused):
    message = refused("x,y,z,Radius_px,Radius_um\n1,2,3,4,5\n")
    assert "which name one thing twice" in message
    assert "(--columns)" in message


@pytest.mark.parametrize("optional", [False, True])
def test_elements_before_places(refused, read_text, optional):
    text = "C 1.5 2.5 3.5\n"
    message = refused(text, "p.txt", optional=optional)
    assert 'columns="element x y z" (--columns)' in message
    assert ("radius= (--radius)" in message) != optional
    packing = read_text(text, "p.txt", columns="element x y z", optional=True)
    assert packing["element"].tolist() == ["C"]
    assert 'columns="element x y z r"' in refused("C 1.5 2.5 3.5 0.5\n", "p.txt")
