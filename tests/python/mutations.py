"""Damaged copies of small files, for tests that no damage crashes a reader or passes unnoticed.

``python tests/python/mutations.py 20000 FOLDER`` reads so many of each format of surfaces that is
read in the process, and prints how many were refused, and the longest time.
"""

import io
import sys
import time
import warnings
from collections import Counter
from pathlib import Path

import numpy as np
import pyvista as pv

# What is put in place of a byte: signs that mean something, digits, and bytes that mean nothing.
_BYTES = b"0123456789-+.eE \n\r\t/_,;xfvo\x00\x01\x1b\x7f\x80\xff"


def mutated(data, rng):
    """A copy in which a few bytes are others, are missing or are more, or that ends early."""
    data = bytearray(data)
    for _ in range(rng.choice([1, 1, 1, 2, 4])):
        at = int(rng.integers(len(data) + 1))
        kind = rng.integers(5)
        if kind == 0 and at < len(data):
            data[at] = int(rng.choice(list(_BYTES)))
        elif kind == 1 and at < len(data):
            data[at] ^= 1 << int(rng.integers(8))
        elif kind == 2:
            data.insert(at, int(rng.choice(list(_BYTES))))
        elif kind == 3:
            del data[at : at + int(rng.integers(1, 4))]
        elif rng.integers(4) == 0:
            del data[at:]
    return bytes(data)


def surfaces(folder):
    """Good files of a small surface, by their names; mixed polygons where the format has them."""
    mesh = pv.Icosahedron(center=(1.25, 0.5, -0.75))
    mesh.clear_data()
    cube = pv.Cube(center=(4, 0, 0)).clean()
    cube.clear_data()
    mixed = mesh.append_polydata(cube)
    mixed.clear_data()
    files = {}
    for name, surface, options in (
        ("binary.stl", mesh, {}),
        ("text.stl", mesh, {"binary": False}),
        ("triangles.ply", mesh, {}),
        ("mixed.ply", mixed, {}),
        ("text.ply", mixed, {"binary": False}),
        ("triangles.obj", mesh, {}),
        ("binary.vtk", mixed, {}),
        ("text.vtk", mixed, {"binary": False}),
        ("binary.vtp", mixed, {}),
        ("text.vtp", mixed, {"binary": False}),
        ("binary.vtu", mixed.cast_to_unstructured_grid(), {}),
        ("text.vtu", mixed.cast_to_unstructured_grid(), {"binary": False}),
    ):
        surface.save(folder / name, **options)
        files[name] = (folder / name).read_bytes()
    rows = [f"v {x:.6g} {y:.6g} {z:.6g}\n" for x, y, z in mixed.points]
    polygons = [mixed.get_cell(i).point_ids for i in range(mixed.n_cells)]
    faces = ["f " + " ".join(f"{i + 1}//{i + 1}" for i in ids) + "\n" for ids in polygons]
    files["mixed.obj"] = "".join(["# a comment\n", *rows, *faces]).encode()
    text = io.StringIO()
    np.savetxt(text, mixed.points, "%.9g")
    faces = [" ".join(map(str, [len(ids), *ids])) + "\n" for ids in polygons]
    files["mixed.off"] = (
        f"OFF\n{len(mixed.points)} {len(faces)} 0\n{text.getvalue()}{''.join(faces)}".encode()
    )
    return files


def main(count, folder):
    from spherepacking.files.errors import SurfaceFileError
    from spherepacking.files.surfaces import read_surface

    warnings.simplefilter("ignore")
    rng = np.random.default_rng()
    for name, data in surfaces(folder).items():
        path = folder / f"mutated{name[-4:]}"
        if name[-4:-1] == ".vt":
            continue
        path.write_bytes(data)
        whole = read_surface(path)
        tally, longest = Counter(), 0.0
        for _ in range(count):
            path.write_bytes(mutated(data, rng))
            start = time.perf_counter()
            try:
                mesh = read_surface(path)
                same = (mesh.n_points, mesh.n_cells) == (whole.n_points, whole.n_cells)
                tally["of the same counts" if same else "of other counts"] += 1
            except SurfaceFileError:
                tally["refused"] += 1
            longest = max(longest, time.perf_counter() - start)
        print(f"{name}: {dict(tally)}, at most {longest:.2f} s", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]), Path(sys.argv[2]))
