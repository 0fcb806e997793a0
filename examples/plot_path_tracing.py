"""Show a packing in the light of a sky and a sun.

Paths of light are followed from sphere to sphere: the sun casts shadows, the sky reaches into gaps
as far as it can, and colours bleed from sphere to sphere. More bounces brighten what is deep
inside.
"""

import sys

import numpy as np
import pyvista as pv
import spherepacking

# %%
# Spheres of three sizes that fell into a bowl, more or less: those that would overlap are left out.
rng = np.random.default_rng(2)
centers, radii = np.empty((0, 3)), np.empty(0)
for radius, tries in ((0.30, 300), (0.16, 3000), (0.08, 20000)):
    for center in rng.uniform([-1, -1, 0], [1, 1, 1], (tries, 3)):
        bowl = np.linalg.norm(center[:2]) + 0.6 * center[2] < 1.2 - radius
        if bowl and (np.linalg.norm(centers - center, axis=1) > radii + radius).all():
            centers, radii = np.vstack([centers, center]), np.append(radii, radius)
packing = pv.PolyData(centers)
packing["radius"] = radii
paint = np.array([[240, 240, 235], [230, 90, 60], [60, 120, 200]], np.uint8)
packing["paint_rgb"] = paint[np.searchsorted(-np.unique(radii)[::-1], -radii)]
print(f"{packing.n_points} spheres")

# %%
# A bluish sky over a darker ground, and a low sun with soft shadows.
light = {
    "sky": ((0.25, 0.23, 0.2), (0.6, 0.75, 1.0)),
    "sun": spherepacking.Sun((1.0, -0.6, 1.0), radiance=(1.6, 1.4, 1.1), diameter=6.0),
}
camera = [(2.6, -3.0, 3.4), (0.0, 0.0, 0.35), (0.0, 0.0, 1.0)]
size = (800, 800)
pictures = []
for bounces in (1, 8):
    image = packing.packing.path_trace(
        camera, size, samples=32, max_bounces=bounces, scalars="paint_rgb", filmic=True, **light
    )
    seconds = image.field_data["complete_seconds"][0]
    print(f"{bounces} bounces: {seconds:.1f} s, mean light {image['radiance'].mean():.3f}")
    pictures.append(np.asarray(image["color"]).reshape(*size[::-1], 4)[::-1])

# %%
# Direct light alone on the left, eight bounces on the right.
spherepacking.write_image(
    sys.argv[1] if len(sys.argv) > 1 else "path_tracing.png", np.hstack(pictures)
)
