"""Generated headers: what is read is what was written, or the file is refused; never other numbers.

A table is made of columns in any order, a way to write their names, and what people do wrong with
these; its spheres are known before any text is written.
"""

import random
from collections import Counter

import numpy as np
import pyvista as pv
from hypothesis import given, settings
from hypothesis import strategies as st

ROWS = 3
SIZES = {
    "radius": ["r", "R", "radius", "Radius", "RADIUS", "rad", "radii", "sphere_radius"],
    "diameter": ["d", "D", "diameter", "Diameter", "diam", "grain_diameter"],
}
IDS = ["id", "ID", "index", "nr", "tag", "Particle ID", "Grain number", "atom id"]
EXTRAS = ["mass", "vx", "vy", "vz", "rho", "q", "type", "phase", "T", "m", "n", "s", "density"]
EXTRAS += ["volume", "fx", "stress_xx", "x_y", "radial", "rx", "dx", "xx", "z0", "kind of", "xmin"]
AXES = ["{}", "{}", "{}", "pos_{}", "{}_pos", "center_{}", "c{}", "coord{}"]
NOTES = [
    "made by a script",
    "3 spheres in a box",
    "x-ray scan",
    "r = 0.5",
    "1 2 3 4",
    "seed: 7",
    "",
]


class Table:
    """Columns of names and fields, and the spheres that they stand for."""

    def __init__(self, rng):
        self.rng = rng
        self.clean = True  # nothing about the header is unusual
        self.refuse = False  # there is no radius
        self.columns = []
        self.spheres = np.zeros((ROWS, 4))
        self.add_sphere()
        self.add_others()
        rng.shuffle(self.columns)
        if rng.random() < 0.4:  # the usual order
            order = {id(column): i for i, column in enumerate(self.sphere)}
            self.columns.sort(key=lambda c: order.get(id(c), -1 if c["kind"] == "id" else 9))

    def add_sphere(self):
        rng = self.rng
        axis = rng.choice(AXES)
        whole = rng.random() < 0.2
        self.colors = rng.random() < 0.2
        self.angles = rng.random() < 0.1
        self.sphere = []
        for i, letter in enumerate(rng.choice(["xyz", "XYZ"])):
            numbers = [rng.uniform(-50, 50) for _ in range(ROWS)]
            fields = [str(round(v)) if whole else f"{v:.4f}" for v in numbers]
            self.spheres[:, i] = [float(field) for field in fields]
            self.sphere.append({"name": axis.format(letter), "kind": "length", "fields": fields})
        kind = rng.choice(["radius", "radius", "radius", "diameter"])
        name = rng.choice(SIZES[kind])
        self.red = self.colors and name in ("r", "R")
        self.refuse = self.red or (self.angles and name in ("r", "R"))
        fields = [f"{rng.uniform(0.1, 9):.3f}" for _ in range(ROWS)]
        self.spheres[:, 3] = [float(f) * (0.5 if kind == "diameter" else 1) for f in fields]
        self.sphere.append({"name": name, "kind": "length", "fields": fields})
        self.columns = list(self.sphere)

    def add_others(self):
        rng = self.rng
        if rng.random() < 0.5:
            first = rng.choice([0, 1, 17])
            ids = [str(first + i * (1 if first < 2 else 5)) for i in range(ROWS)]
            rng.shuffle(ids)
            self.columns.append({"name": rng.choice(IDS), "kind": "id", "fields": ids})
        if self.colors:
            for name in "gb" if self.red else "rgb":
                fields = [str(rng.randrange(256)) for _ in range(ROWS)]
                self.columns.append({"name": name, "kind": "color", "fields": fields})
        if self.angles:
            for name in ("theta", "phi"):
                fields = [f"{rng.uniform(0, 3):.3f}" for _ in range(ROWS)]
                self.columns.append({"name": name, "kind": "angle", "fields": fields})
        for name in rng.sample(EXTRAS, rng.choice([0, 0, 1, 2, 4])):
            make = rng.choice(
                [
                    lambda: f"{rng.uniform(-5, 5):.3f}",
                    lambda: str(rng.randrange(9)),
                    lambda: rng.choice(["sand", "clay", "x", "B12"]),
                ]
            )
            fields = [make() for _ in range(ROWS)]
            self.columns.append({"name": name, "kind": "other", "fields": fields})
        names = Counter(c["name"].lower() for c in self.columns)
        # r, g, b with R as the radius is one name twice.
        self.refuse |= any(n > 1 for n in names.values())

    def names(self):
        """The names as the header has them, with numbers and units, and perhaps too few or many."""
        rng = self.rng
        names = [column["name"] for column in self.columns]
        self.words = max(len(name.split()) for name in names)
        unit = rng.choice(["", "", "", "{} [mm]", "{}(mm)", "{} (in mm)", "{} mm", "{}_mm"])
        if unit:
            lengths = [column["kind"] == "length" for column in self.columns]
            names = [
                unit.format(n) if is_length else n
                for n, is_length in zip(names, lengths, strict=True)
            ]
        self.unit = unit
        if unit and self.red and not self.angles:
            self.refuse = self.clean = False  # R in mm is no color
        number = rng.choice(["", "", "", "", "{}:{}", "{}: {}", "[{}] {}", "{}){}", "{}.{}"])
        first = rng.choice([0, 1])
        if number:
            names = [number.format(i + first, name) for i, name in enumerate(names)]
        self.number = number
        mistake = rng.choice(["", "", "", "", "fewer", "more", "much more"])
        if mistake == "fewer" and (self.colors or self.angles):
            mistake = ""  # r without b or phi beside it is a radius, to anyone
        if "kind of" in names:
            mistake = ""  # as are two names
        if mistake == "fewer":
            names = names[: -rng.choice([1, 2])]
        elif mistake:
            names += ["wx", "wy", "wz"][: 1 if mistake == "more" else 3]
        self.clean &= not mistake
        return names

    def text(self):
        """The whole file, and its name."""
        rng = self.rng
        names = self.names()
        comment = rng.choice(["# ", "#", "## ", "# columns: "])
        before = "".join(f"# {note}\n" for note in rng.sample(NOTES, rng.choice([0, 0, 1, 2])))
        after = "".join(f"# {note}\n" for note in rng.sample(NOTES, rng.choice([0, 0, 0, 1])))
        style = rng.choice(["comment", "comment", "comment", "header", "csv", "lines"])
        fields = list(zip(*(column["fields"] for column in self.columns), strict=True))
        if style == "csv":
            delimiter = rng.choice([",", ";", "\t", ", "])
            header = delimiter.join(names) + "\n"
            rows = [delimiter.join(row) for row in fields]
            return before + header + "\n".join(rows) + "\n", rng.choice(["p.csv", "p.txt"])
        between = rng.choice([" ", "  ", "\t", ", ", ","])
        rows = [rng.choice([" ", "\t", "  "]).join(row) for row in fields]
        if style == "lines":
            label = rng.choice(["# ", "# column ", "#"])
            header = "".join(f"{label}{name}\n" for name in names)
            self.clean &= bool(self.number) and label != "#"
        elif style == "header":
            self.clean &= "," not in between
            header = between.join(names) + "\n"
        else:
            header = comment + between.join(names) + "\n"
        # Names of several words between single blanks may be read or not.
        self.clean &= self.words == 1 or between != " "
        self.clean &= self.unit != "{}_mm" or True
        return before + header + after + "\n".join(rows) + "\n", "p.txt"


SEEN = Counter()


@settings(max_examples=1500)
@given(seed=st.integers(0, 2**32))
def check(read, path, seed):
    table = Table(random.Random(seed))
    text, name = table.text()
    (path / name).write_text(text)
    reader = read(path / name)
    reader.AddObserver("ErrorEvent", lambda *_: None)
    reader.Update()
    message = reader.GetErrorMessage()
    packing = pv.wrap(reader.GetOutput())
    if message:
        assert packing.n_points == 0
        assert message.startswith(str(path / name)), text
        SEEN["refused"] += 1
        SEEN["clean and refused"] += table.clean and not table.refuse
        if table.clean and not table.refuse:
            print(text, message)
        return
    assert not table.refuse, text
    found = np.column_stack([packing.points, packing["radius"]])
    assert found.tolist() == table.spheres.tolist(), text
    SEEN["read"] += 1
    SEEN["not clean and read"] += not table.clean


def test_generated_headers(reader_for, tmp_path):
    SEEN.clear()
    check(reader_for, tmp_path)
    print(SEEN)
    assert SEEN["read"] >= 300
    assert SEEN["clean and refused"] == 0, "what is usual is read"
