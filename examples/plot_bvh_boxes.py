"""Show the boxes of a bounding volume hierarchy.

The surface-area heuristic splits the spheres of a packing in two over and over, and each leaf has a
box around its spheres. With 7 leaves and with 15, every sphere has the colour of its leaf.
"""

import sys

import numpy as np
import pyvista as pv

# %%
# A packing is a PolyData with the point array ``radius``; this one lies along a trefoil knot.
rng = np.random.default_rng(0)
t = rng.uniform(0.0, 2.0 * np.pi, 4000)
knot = [np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)]
packing = pv.PolyData(np.column_stack(knot) + rng.normal(scale=0.15, size=(t.size, 3)))
packing["radius"] = rng.uniform(0.03, 0.12, t.size)

# %%
# ``leaf_of_sphere`` holds the ``box_id`` of the leaf of every sphere. Leaves are numbered among all
# nodes of the hierarchy; their ranks choose the colours.
colors = ["#e6194b", "#3cb44b", "#ffc800", "#4363d8", "#f58231", "#911eb4", "#42d4f4", "#f032e6"]
colors += ["#9adc1e", "#ff9fb6", "#1b7f79", "#b48cff", "#9a6324", "#800000", "#000075"]
look = {"cmap": colors, "clim": (-0.5, 14.5), "n_colors": 15, "show_scalar_bar": False}

plotter = pv.Plotter(off_screen=True, shape=(1, 2), window_size=(1600, 800), border=False)
plotter.enable_anti_aliasing("ssaa")
for column, count in enumerate([7, 15]):
    boxes = packing.packing.bvh_boxes(count, as_lines=True)
    leaves, rank_of_sphere = np.unique(boxes.field_data["leaf_of_sphere"], return_inverse=True)
    ranks = np.searchsorted(leaves, boxes.cell_data["box_id"])
    cost = boxes.field_data["sah_cost"][0]
    print(f"{count} leaves: a random ray is tested against {cost:.0f} spheres and boxes")

    plotter.subplot(0, column)
    plotter.packing.add(packing, scalars=rank_of_sphere, **look)
    plotter.add_mesh(boxes, scalars=ranks, line_width=6, lighting=False, **look)
    plotter.add_text(f"{count} leaves", font_size=14)
    plotter.camera_position = [(4, -6, 8), (0, 0, 0), (0, 0, 1)]
    plotter.reset_camera()
    plotter.camera.zoom(1.1)

# %%
plotter.packing.screenshot(sys.argv[1] if len(sys.argv) > 1 else "bvh_boxes.png")
plotter.close()
