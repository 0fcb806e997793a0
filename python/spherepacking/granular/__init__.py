"""The simulation cell, periodic images, and contacts of spheres."""
