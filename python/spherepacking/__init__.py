"""See sphere packings: exact ray-cast spheres for VTK and PyVista."""
