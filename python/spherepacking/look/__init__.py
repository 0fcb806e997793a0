"""How spheres look: scalars, colour maps, scalar bars, materials."""
