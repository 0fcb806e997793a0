"""Let the spheres of a packing flow into one another.

Every sphere adds to a field that falls with the distance from it, and a surface is drawn where the
field has a value, the threshold. At a high threshold the spheres are apart; the lower it is, the
more of them grow together. A new threshold needs no new field.
"""

import sys

import numpy as np
import pyvista as pv
import spherepacking

# %%
# Spheres along a knotted wire, coloured by where they are along it.
rng = np.random.default_rng(1)
t = 2 * np.pi * rng.random(500)
wire = np.column_stack(
    [np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)]
)
packing = pv.PolyData(wire + rng.normal(scale=0.18, size=wire.shape))
packing["radius"] = 0.04 + 0.25 * rng.random(500) ** 4
packing["along"] = t

# %%
# Weights take the small half back, which would be a mist around the wire.
plotter = pv.Plotter(off_screen=True, window_size=(600, 600))
plotter.set_background("white")
balls = plotter.packing.add_metaballs(
    packing,
    threshold=1.0,
    kernel="inverse_square",
    weights=(1.0, 0.5),
    dimensions=160,
    scalars="along",
    cmap="hsv",
)
plotter.camera_position = [(2.0, 1.0, 9.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
plotter.reset_camera()
plotter.camera.zoom(1.2)

# %%
# From spheres apart to one body.
pictures = []
for threshold in (10.0, 3.0, 1.0):
    balls.threshold = threshold
    bodies = balls.surface.split_bodies().n_blocks
    print(f"threshold {threshold:g}: {bodies} bodies of {balls.surface.n_cells} triangles")
    plotter.render()
    pictures.append(plotter.screenshot(None, return_img=True))
print(f"{balls.sums} field for all of them")
plotter.close()
spherepacking.write_image(
    sys.argv[1] if len(sys.argv) > 1 else "metaballs.png", np.hstack(pictures)
)
