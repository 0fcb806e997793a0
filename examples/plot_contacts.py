"""Show which spheres of a periodic packing touch, and how hard.

Spheres of several sizes at random in a tilted cell are pushed apart where they overlap. Left: the
spheres, completed at the faces of the cell by their images; right: their contacts as tubes, by the
overlap that is left, and the spheres that touch no other in white.
"""

import sys

import numpy as np
import pyvista as pv

# %%
# A packing in a cell: field arrays hold its vectors, here with the first two periodic.
rng = np.random.default_rng(0)
cell = np.array([[10.0, 0, 0], [2, 10, 0], [0, 0, 8]])
packing = pv.PolyData((rng.random((560, 3)) * [1, 1, 0.9] + [0, 0, 0.05]) @ cell)
packing["radius"] = 10 ** rng.uniform(-0.7, 0.0, packing.n_points)
packing.field_data["cell_vectors"] = cell
packing.field_data["cell_periodic"] = [1, 1, 0]

# %%
# Each contact moves its two spheres apart by a part of the overlap, small ones more.
points = np.array(packing.points)
for _ in range(200):
    contacts = packing.packing.contacts()
    i, j = contacts["i"], contacts["j"]
    ends = contacts.points[contacts.lines.reshape(-1, 3)[:, 1:]]
    along = (ends[:, 1] - ends[:, 0]) / np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)[:, None]
    volumes = packing["radius"] ** 3
    push = 0.4 * contacts["overlap"][:, None] * along / (volumes[i] + volumes[j])[:, None]
    np.add.at(points, i, -push * volumes[j, None])
    np.add.at(points, j, push * volumes[i, None])
    points[:, 2] = np.clip(points[:, 2], packing["radius"], 8 - packing["radius"])
    packing.points = points
packing = packing.packing.wrap()
contacts = packing.packing.contacts()
packing["coordination"] = packing.packing.coordination()
print(f"{contacts.n_lines} contacts, {packing['coordination'].mean():.1f} a sphere")

# %%
plotter = pv.Plotter(off_screen=True, shape=(1, 2), window_size=(1600, 800), border=False)
plotter.enable_anti_aliasing("ssaa")
plotter.subplot(0, 0)
plotter.packing.add(
    packing.packing.ghosts(),
    scalars="coordination",
    cmap="viridis",
    show_cell=True,
    specular=0.3,
    scalar_bar_args={"n_labels": 2},
)
plotter.subplot(0, 1)
plotter.packing.add_contacts(
    packing,
    tube_radius=0.06,
    scalars="overlap",
    cmap="inferno_r",
    specular=0.3,
    scalar_bar_args={"n_labels": 2},
)
alone = packing["coordination"] == 0
free = pv.PolyData(packing.points[alone])
free["radius"] = packing["radius"][alone]
free.field_data["cell_vectors"] = cell
plotter.packing.add(free, color="white", show_cell=True)
for column in range(2):
    plotter.subplot(0, column)
    plotter.camera_position = [(22, -24, 16), (6, 5, 3), (0, 0, 1)]

# %%
plotter.packing.screenshot(sys.argv[1] if len(sys.argv) > 1 else "contacts.png")
plotter.close()
