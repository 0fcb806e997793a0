"""``radius={…}``: one radius for each type, and which array holds the types."""

import pytest
import spherepacking
from spherepacking.files.errors import PackingFileError


@pytest.mark.parametrize(
    "name", ["type", "Type", "TYPE", "kind", "Kind", "material", "Material", "matId", "Species"]
)
def test_arrays_of_numbers(tmp_path, name):
    path = tmp_path / "a.csv"
    path.write_text(f"x,y,z,{name}\n1,2,3,1\n4,5,6,2\n7,8,9,1\n")
    packing = spherepacking.read(path, radius={1: 0.5, 2: 0.25})
    assert packing["radius"].tolist() == [0.5, 0.25, 0.5]


@pytest.mark.parametrize("name", ["Element", "Kind", "MATERIAL", "whatever"])
def test_arrays_of_texts(tmp_path, name):
    path = tmp_path / "a.csv"
    path.write_text(f"x,y,z,{name}\n1,2,3,C\n4,5,6,H\n")
    packing = spherepacking.read(path, radius={"C": 1.75, "H": 1.125})
    assert packing["radius"].tolist() == [1.75, 1.125]


def test_the_name_in_lower_case_comes_first_and_type_before_others(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("x,y,z,Type,type,kind\n1,2,3,2,1,2\n4,5,6,1,2,2\n")
    packing = spherepacking.read(path, radius={1: 0.5, 2: 0.25})
    assert packing["radius"].tolist() == [0.5, 0.25]


def test_other_numbers_are_no_types(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("x,y,z,kinds\n1,2,3,1\n")
    with pytest.raises(PackingFileError, match="no point array of types"):
        spherepacking.read(path, radius={1: 0.5})


@pytest.mark.parametrize(
    ("text", "radius"),
    [
        ("x,y,z,type\n1,2,3,-1\n", dict.fromkeys(range(5000), 0.5)),
        ("x,y,z,type\n1,2,3,a\n", {f"type {i}": 0.5 for i in range(5000)}),
        ("x,y,z,w\n1,2,3,1\n", dict.fromkeys(range(5000), 0.5)),
        ("x,y,z,type\n1,2,3,1\n", {i + 0.5: 0.5 for i in range(5000)}),
        ("x,y,z,type\n1,2,3,1\n", {"long" * 5000: 0.5}),
        ("x,y,z,type\n" + "".join(f"1,2,3,{i}\n" for i in range(5000)), {-1: 0.5}),
        ("x,y,z," + ",".join(f"w{i}" for i in range(3000)) + "\n" + "1," * 3002 + "1\n", "no"),
        ("x,y,z," + ",".join(f"w{i}" for i in range(3000)) + "\n" + "1," * 3002 + "1\n", {1: 1}),
    ],
    ids=lambda value: type(value).__name__,
)
def test_sentences_are_bounded(tmp_path, text, radius):
    path = tmp_path / "a.csv"
    path.write_text(text)
    with pytest.raises(PackingFileError) as error:
        spherepacking.read(path, radius=radius)
    assert len(str(error.value)) < 1000 + len(str(path))
