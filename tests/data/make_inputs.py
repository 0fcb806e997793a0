"""Write the files of this folder: small inputs in the formats and the style of real ones.

Tests on real inputs run on these, too, so that nothing is checked only where the real ones are:
``REAL`` in tests/conftest.py says which stands for which. Everything here is made by this script.
"""

import json
from pathlib import Path

import numpy as np
import pyvista as pv

FOLDER = Path(__file__).parent
RESIDUES = ("ALA", "GLY", "LYS", "SER")
ATOMS = (("N", 1.7), ("CA", 1.9), ("C", 1.75), ("O", 1.49))


def write(name, lines, newline="\n"):
    (FOLDER / name).write_bytes(newline.join(lines).encode())


def clump(rng):
    """Spheres that overlap deeply, one of them wholly inside another."""
    rows = np.column_stack([rng.normal(scale=0.4, size=(12, 3)), rng.uniform(0.15, 0.5, 12)])
    rows[5] = [*(rows[4, :3] + 0.01), 0.1]
    write(
        "clump.csv", ["x,y,z,r", *(",".join(f"{v:.15g}" for v in row) for row in rows), ""], "\r\n"
    )


def tree():
    """A tree of three levels, as ends without a newline."""
    lines = ["# rmin rmax", " 10   80", "", "# number of levels", "3"]
    angles = 2 * np.pi * np.arange(3) / 3
    middles = np.column_stack([40 * np.cos(angles), 40 * np.sin(angles), 0 * angles])
    leaves = [middle + 20 * step for middle in middles for step in [*np.eye(3), -np.ones(3) / 2]]
    for level, points, radius in ((1, np.zeros((1, 3)), 80), (2, middles, 40), (3, leaves, 10)):
        lines += ["", f"# number of spheres in level {level}", str(len(points)), ""]
        lines += [f"# x y z r of spheres in level {level}"]
        lines += [f"{x:.2f} {y:.2f} {z:.2f} {radius:.2f}" for x, y, z in points]
    write("tree.sph", lines)


def atoms(rng):
    """A chain of residues: chain, residue, atom, then the sphere."""
    lines = []
    for residue in range(3, 15):
        middle = np.array([1.5 * residue, 3 * np.sin(residue), 3 * np.cos(residue)])
        for atom, radius in ATOMS:
            x, y, z = np.round(middle + rng.normal(scale=0.9, size=3), 3)
            lines.append(f"A {residue} {atom} {x:g} {y:g} {z:g} {radius:g}")
    write("atoms.xyzr", [*lines, ""])


def helix(rng):
    """Atoms with charges, hydrogens of radius 0 among them."""
    lines = ["REMARK   1 made for tests", "REMARK   1"]
    for i in range(1, 61):
        turn = 0.6 * i
        x, y, z = 6 * np.cos(turn), 6 * np.sin(turn), 0.7 * i
        kind = "HETATM" if i > 55 else "ATOM"
        atom, radius = ("H", 0.0) if i % 4 == 0 else ("CA", 1.0 + i % 3 / 2)
        charge = rng.uniform(-0.5, 0.5)
        residue = RESIDUES[i % len(RESIDUES)]
        lines.append(
            f"{kind:6}{i:5}  {atom:3} {residue} {i // 4 + 1:5}    "
            f"{x:8.3f}{y:8.3f}{z:8.3f}{charge:8.4f}{radius:7.4f}"
        )
    write("helix.pqr", [*lines, "TER", "END", ""], "\r\n")


def chain(rng):
    """Atoms with charges, with a name of the chain, and a part that is no atom."""
    lines = []
    for i in range(1, 41):
        x, y, z = 1.3 * i + rng.normal(), rng.normal(), rng.normal()
        atom, radius = ATOMS[i % len(ATOMS)]
        residue = RESIDUES[i // len(ATOMS) % len(RESIDUES)]
        lines.append(
            f"ATOM  {i:5}  {atom:3} {residue} A {i // 4 + 1:4}    "
            f"{x:8.3f} {y:8.3f} {z:8.3f} {rng.uniform(-1, 1):7.4f} {radius:6.4f}"
        )
    write("chain.pqr", [*lines, "TER", "END", ""])


def protein(rng):
    """Atoms of two chains in the columns of the Protein Data Bank, hydrogens among them."""
    lines = ["HEADER    MADE FOR TESTS", "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000"]
    names = (("N", "N"), ("CA", "C"), ("C", "C"), ("O", "O"), ("HA", "H"), ("SG", "S"))
    for i in range(1, 49):
        x, y, z = 80 + 2.1 * i + rng.normal(), rng.normal(), -200 * rng.uniform()
        name, element = names[i % len(names)]
        lines.append(
            f"ATOM  {i:5}  {name:3} {RESIDUES[i // len(names) % len(RESIDUES)]} {'AB'[i > 24]}"
            f"{i // len(names) + 9:4}    {x:8.3f}{y:8.3f}{z:8.3f}  1.00  0.00"
            f"          {element:>2}  "
        )
    write("protein.pdb", [*lines, "TER", "END", ""])


def equal_spheres(rng):
    """Equal spheres on a shaken lattice, with their diameters, and the .nfo beside them."""
    lattice = np.stack(np.meshgrid(*[np.arange(6)] * 3), axis=-1).reshape(-1, 3) * 3.4
    rows = np.column_stack([lattice + rng.uniform(-0.8, 0.8, lattice.shape), np.full(216, 1.4)])
    (FOLDER / "equal.xyzd").write_bytes(rows.astype("<f8").tobytes())
    porosity = 1 - (np.pi / 6 * rows[:, 3] ** 3).sum() / 20.4**3
    write(
        "equal.nfo",
        [
            f"N: {len(rows)}",
            " Dimensions: 20.4 20.4 20.4",
            f" Theoretical Porosity: {porosity:.15g}",
            f"Final Porosity: {porosity:.15g} (Tolerance: 1.000100)",
            "",
        ],
    )


def planets(rng):
    """A star and bodies of ever smaller radii around it, in km, up to 6e9 km away."""
    radii = [7e5, 3000, 6100, 6400, 1800, 70000, 58000, 25000, 1200]
    distances = [0, 6e7, 1.1e8, 1.5e8, 1.5e8 + 4e5, 8e8, 1.4e9, 4.5e9, 6e9]
    bodies = []
    for i, (radius, distance) in enumerate(zip(radii, distances, strict=True)):
        angle = 2.4 * i if i != 4 else 2.4 * 3
        position = [distance * np.cos(angle), distance * np.sin(angle), 0.01 * distance]
        bodies.append({"name": f"body {i}", "radius": radius, "position": position})
    write("planets.json", [json.dumps({"bodies": bodies}, indent=1), ""])


def blob(seed, roughness):
    """A ball with bumps: points (n, 3) and triangles (m, 3)."""
    rng = np.random.default_rng(seed)
    ball = pv.Icosphere(nsub=2)
    points = np.asarray(ball.points, float)
    height = sum(np.sin(points @ (3 * rng.normal(size=3)) + rng.uniform(0, 6)) for _ in range(4))
    return points * (1 + roughness * height / 4)[:, None], ball.faces.reshape(-1, 4)[:, 1:]


def surfaces():
    points, faces = blob(1, 0.4)
    lines = [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in points]
    write("blob.obj", [*lines, *(f"f {a} {b} {c}" for a, b, c in faces + 1), ""])
    points, faces = blob(2, 0.6)
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [f"{x:.6f} {y:.6f} {z:.6f} " for x, y, z in points]
    write("blob.off", [*lines, *(f"3 {a} {b} {c} " for a, b, c in faces), ""])
    cubes()


def cubes():
    """Cubes along a diagonal, each touching the next with an edge that four triangles share."""
    corners, faces = {}, []
    for shift in ((0, 0, 0), (1, 1, 0), (2, 2, 0)):
        cube = pv.Cube(center=shift).triangulate().clean()
        ids = [corners.setdefault(tuple(np.round(p, 6)), len(corners)) for p in cube.points]
        faces += [[ids[i] for i in face] for face in cube.faces.reshape(-1, 4)[:, 1:]]
    points = np.array(list(corners))
    normals = points - points.mean(axis=0)
    header = ["ply", "format ascii 1.0", "comment made for tests", f"element vertex {len(points)}"]
    header += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    rows = [" ".join(f"{v:g}" for v in [*p, *n]) for p, n in zip(points, normals, strict=True)]
    write("cubes.ply", [*header, *rows, *(f"3 {a} {b} {c}" for a, b, c in faces), ""])


def main():
    rng = np.random.default_rng(0)
    clump(rng)
    tree()
    atoms(rng)
    helix(rng)
    chain(rng)
    equal_spheres(rng)
    planets(rng)
    surfaces()
    np.savez(FOLDER / "positions.npz", position=rng.uniform(-1, 1, (20, 3)).astype(np.float32))
    protein(rng)


if __name__ == "__main__":
    main()
