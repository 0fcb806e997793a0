"""Show the cells of a uniform grid that spheres touch.

The bounds of a packing are cut once along each axis, and six times. Cells that no sphere touches
are left out.
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
# Faces that let nearly all light through show the cells as bodies, lines their edges.
plotter = pv.Plotter(off_screen=True, shape=(1, 2), window_size=(1600, 800), border=False)
plotter.enable_anti_aliasing("ssaa")
for column, cuts in enumerate([1, 6]):
    faces = packing.packing.grid_boxes(cuts)
    cells = faces.n_cells // 6
    print(f"cut {cuts}x: spheres touch {cells} of {(cuts + 1) ** 3} cells")

    plotter.subplot(0, column)
    plotter.packing.add(packing, color="orange")
    edges = packing.packing.grid_boxes(cuts, as_lines=True)
    plotter.add_mesh(edges, color="#24478f", line_width=3, lighting=False)
    plotter.add_mesh(faces, color="#4363d8", opacity=0.04, lighting=False)
    plotter.add_text(f"cut {cuts}x: {cells} cells", font_size=14)
    plotter.camera_position = [(3, -6, 9), (0, 0, 0), (0, 0, 1)]
    plotter.reset_camera()

# %%
plotter.packing.screenshot(sys.argv[1] if len(sys.argv) > 1 else "grid_boxes.png")
plotter.close()
