"""Fill a shape with spheres.

Where no sphere file is at hand, any closed surface makes one: again and again the largest sphere
that fits is put into what is left. How much is filled grows ever more slowly with their number.
"""

import sys

import numpy as np
import pyvista as pv
import spherepacking
from pyvista import examples

# %%
# An ant that comes with PyVista.
ant = pv.read(examples.antfile)
packing = spherepacking.pack(ant, 5000)

# %%
# The spheres are sorted by size, and the first of them are packings, too.
volume = packing.field_data["surface_volume"][0]
filled = np.cumsum(4 / 3 * np.pi * packing["radius"] ** 3) / volume
for count in (10, 100, 1000, 5000):
    print(f"{count:5d} spheres fill {filled[count - 1]:.1%}")

# %%
# The packing on the left, beside the curve.
plotter = pv.Plotter(off_screen=True, window_size=(1200, 600), shape=(1, 2))
plotter.set_background("white")
plotter.packing.add(
    packing, scalars="radius", log_scale=True, specular=0.3, scalar_bar_args={"n_labels": 4}
)
plotter.view_vector((-0.3, -1.0, 0.6), (0.0, 0.0, 1.0))
plotter.camera.zoom(1.3)
plotter.subplot(0, 1)
chart = pv.Chart2D(x_label="spheres", y_label="filled part of the volume")
chart.line(np.arange(1, len(filled) + 1), filled, width=3.0)
chart.x_axis.log_scale = True
plotter.add_chart(chart)
picture = plotter.screenshot(None, return_img=True)
plotter.close()
spherepacking.write_image(sys.argv[1] if len(sys.argv) > 1 else "pack.png", picture)
