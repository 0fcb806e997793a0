"""Names of arrays that hold diameters; the words beside are what each must mean."""

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.size_names import diameters_in

DIAMETERS = [
    *("d", "D", "diam", "Diam", "diameter", "Diameters", "DIAMETER", "dia", "Ø", "2r"),
    *("Durchmesser", "Kugeldurchmesser", "diametre", "diamètre", "diametro", "диаметр", "直径"),
    *("particle_diameter", "equivalent diameter", "EqDiameter", "eqdiameter", "equivalentDiameter"),
    *("Diam_eq", "d_eq", "dEq", "diameter_um", "diameter [mm]", "diameter (kg/m^3)", "d [mm]"),
    *("pore.diameter", "throat.diameter", "Sauter diameter", "diameter_0", "inner_diameter"),
]
RADII = [
    *("r", "R", "rad", "radius", "Radius [mm]", "radii", "Halbmesser", "vdw", "size", "pore_size"),
    *("depth", "median", "diamond", "density", "id", "ID", "old", "Dreieck", "add", "diagonal"),
    *("meridian", "media", "world", "dx", "area_2d", "3D"),
]
UNSURE = [
    *("D50", "d32", "d_mean", "mean d", "1/d", "1/diameter", "diameter^2", "half_diameter"),
    *("semidiameter", "radius_from_diameter", "log_diameter", "diameter_ratio", "diam2"),
    *("diameter_std", "InverseDiameter"),
]


def with_array(name, values=(1.0, 3.0)):
    mesh = pv.PolyData(np.array([[0.0, 0, 0], [9, 0, 0]]))
    mesh[name] = np.array(values)
    return mesh


@pytest.mark.parametrize("name", DIAMETERS)
def test_diameters_are_halved(name):
    assert diameters_in(name) == "yes"
    assert with_array(name).packing.with_radius(name)["radius"].tolist() == [0.5, 1.5]


@pytest.mark.parametrize("name", RADII)
def test_others_are_taken_as_they_are(name):
    assert diameters_in(name) == "no"
    assert with_array(name).packing.with_radius(name)[
        "radius" if name != "radius" else name
    ].tolist() == [1, 3]


@pytest.mark.parametrize("name", UNSURE)
def test_what_is_not_certain_is_refused(tmp_path, name):
    mesh = with_array(name)
    with pytest.raises(
        ValueError, match=r"which may hold diameters .* expected radius=packing"
    ) as e:
        mesh.packing.with_radius(name)
    # What the sentence says is an answer.
    packing = mesh
    for said, radii in zip(str(e.value).split("radius=")[1:], ([0.5, 1.5], [1, 3]), strict=True):
        radius = eval(said.removesuffix(" or "), {"packing": packing})
        assert mesh.packing.with_radius(radius)["radius"].tolist() == radii
    mesh.save(tmp_path / "a.vtp")
    with pytest.raises(spherepacking.PackingFileError, match=r"a\.vtp: radius: found the array"):
        spherepacking.read(tmp_path / "a.vtp", radius=name)


@pytest.mark.parametrize(
    "name",
    [
        *("d", "diam", "diameter", "Diameters", "Durchmesser", "diametro", "diametre", "diamètre"),
        *(
            "диаметр",
            "直径",
            "particle_diameter",
            "equivalent_diameter",
            "pore_diameter",
            "eq_diameter",
        ),
        *("r", "rad", "radius", "radii", "Halbmesser", "rayon", "raggio", "grain_radius"),
    ],
)
def test_tables_know_the_same_words(tmp_path, name):
    """By their own list, in io/NameMeaning.cxx."""
    path = tmp_path / "a.csv"
    path.write_text(f"x,y,z,{name}\n1,2,3,1\n4,5,6,3\n")
    halved = spherepacking.read(path)["radius"].tolist()
    assert halved == ([0.5, 1.5] if diameters_in(name) == "yes" else [1, 3])
    assert diameters_in(name) != "unsure"
