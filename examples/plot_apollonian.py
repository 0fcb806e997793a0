"""Draw an Apollonian packing.

The spheres that fill the gaps between mutually tangent spheres in a ball, over six levels. Each one
is drawn as an exact sphere, whatever the distance.
"""

import sys
from pathlib import Path

import pyvista as pv

# %%
# With spherepacking installed, PyVista reads packing files. The radii are the active scalars.
packing = pv.read(Path(__file__).with_name("apollonian.spheres"))
print(f"{packing.n_points} spheres, bounds {packing.packing.bounds}")

# %%
# ``plotter.packing.add`` takes the arguments of ``plotter.add_mesh``.
plotter = pv.Plotter(off_screen=True, window_size=(1000, 1000))
plotter.enable_anti_aliasing("ssaa")
plotter.packing.add(packing, cmap="magma", log_scale=True, specular=0.3, specular_power=20)
plotter.camera.zoom(1.4)
plotter.packing.screenshot(sys.argv[1] if len(sys.argv) > 1 else "apollonian.png")
plotter.close()
