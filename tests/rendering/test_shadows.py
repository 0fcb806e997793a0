"""Shadows of spheres, on each other and on meshes, by VTK's shadow maps."""

import numpy as np
import pytest
import pyvista as pv
from scenes import make_packing


@pytest.mark.parametrize("sun", [False, True], ids=["spotlight", "sun"])
def test_shadows_are_those_of_fine_meshes(sun):
    centers = np.array([[0.0, 0.0, 0.0], [0.9, 0.9, 1.5], [1.6, -0.5, 0.2]])
    radii = [1.0, 0.4, 0.5]

    def picture(add):
        plotter = pv.Plotter(off_screen=True, window_size=(300, 300), lighting="none")
        plotter.set_background("black")
        plotter.add_light(
            pv.Light(position=(4, 4, 8), positional=not sun, cone_angle=30, intensity=0.8)
        )
        add(plotter)
        plotter.add_mesh(pv.Plane(center=(0, 0, -1), i_size=6, j_size=6), ambient=0.2)
        plotter.camera_position = [(3, -8, 6), (0, 0, 0), (0, 0, 1)]
        plotter.enable_shadows()
        pixels = plotter.screenshot(return_img=True)
        plotter.close()
        return pixels.astype(int)

    def meshes(plotter):
        for center, radius in zip(centers, radii, strict=True):
            mesh = pv.Sphere(radius=radius, center=center, theta_resolution=200, phi_resolution=200)
            plotter.add_mesh(mesh, color="white", ambient=0.2, smooth_shading=True)

    def spheres(plotter):
        plotter.packing.add(make_packing(centers, radii), color="white", ambient=0.2)

    expected, found = picture(meshes), picture(spheres)
    assert ((expected > 20) & (expected < 80)).mean() > 0.05  # there is shadow
    assert (np.abs(expected - found).max(axis=-1) > 8).mean() < 0.01
