"""Columns r beside colours, in tables."""

import pytest


@pytest.fixture
def refused(read_error, tmp_path):
    """Read a text that has to be refused: the message without the name of the file."""

    def read(text, name="p.csv", **options):
        path = tmp_path / name
        path.write_text(text)
        message, _ = read_error(path, **options)
        return message.removeprefix(str(path))

    return read


@pytest.mark.parametrize(
    "header",
    [
        *("x,y,z,r,red,green,blue", "x,y,z,R,Red,Green,Blue", "x,y,z,r,RED,GREEN,BLUE"),
        *("x,y,z,r,R,G,B", "x,y,z,R,r,g,b", "x,y,z,radius,r,g,b", "x,y,z,r,red,G,green,blue"),
    ],
)
@pytest.mark.parametrize("plain", [False, True])
def test_a_radius_beside_red(read_text, header, plain):
    fields = ["1.5", "2", "3", "4", "255", "0", "7"]
    if ",G," in header and "green" in header:
        fields.insert(5, "9")
    text = header + "\n" + ",".join(fields) + "\n"
    text = text.replace(",", " ") if plain else text
    packing = read_text(text, "p.txt" if plain else "p.csv")
    assert packing["radius"].tolist() == [4]
    assert packing["rgb"].tolist() == [[255, 0, 7]]


@pytest.mark.parametrize(
    "header", ["x,y,z,r,g,b", "x,y,z,r,green,blue", "x,y,z,R,red,g,b", "x,y,z,r,red,green,blue,g,b"]
)
def test_red_alone(refused, header):
    text = header + "\n" + ",".join("123456789"[: header.count(",") + 1]) + "\n"
    message = refused(text)
    assert "which is red beside green and blue" in message


def test_two_of_one_name(refused, read_text):
    text = "x,y,z,r,r,g,b\n1.5,2,3,4,255,0,7\n"
    message = refused(text)
    assert message.startswith(", line 1: found the column 'r' twice beside green and blue")
    assert 'radius="' not in message
    assert "columns=" in message
    packing = read_text(text, "p.csv", columns="x y z radius r g b")
    assert packing["radius"].tolist() == [4]
    assert packing["rgb"].tolist() == [[255, 0, 7]]


def test_colours_beside_given_radii(read_text):
    for header in ("x,y,z,r,red,green,blue", "x,y,z,r,R,G,B"):
        packing = read_text(header + "\n1.5,2,3,4,255,0,7\n", "p.csv", optional=True)
        assert packing["rgb"].tolist() == [[255, 0, 7]]
