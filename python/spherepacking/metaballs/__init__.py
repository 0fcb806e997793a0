"""Fields that spheres add up to, and surfaces in them."""
