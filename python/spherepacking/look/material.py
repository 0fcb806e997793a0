"""The material of spheres."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from ..checks import LARGEST_SPECULAR_POWER, number_of, shown

if TYPE_CHECKING:
    from pyvista.plotting.themes import Theme


def property_of(
    theme: Theme,
    lighting: bool | None,
    ambient: float | None,
    diffuse: float | None,
    specular: float | None,
    specular_power: float | None,
) -> pv.Property:
    """Make the material of spheres, or a ValueError; what is None is the theme's."""
    for name, value in (("ambient", ambient), ("diffuse", diffuse), ("specular", specular)):
        if value is not None:
            number_of(name, value, 0.0, 1.0)
    if not (lighting is None or isinstance(lighting, (bool, np.bool_))):
        raise ValueError(f"lighting: found {shown(lighting)}, expected True, False or None")
    if specular_power is not None:
        number_of("specular_power", specular_power, 0.0, LARGEST_SPECULAR_POWER)
    return pv.Property(
        theme=theme,
        style="surface",
        interpolation="Phong",
        show_edges=False,
        lighting=lighting,
        ambient=ambient,
        diffuse=diffuse,
        specular=specular,
        specular_power=specular_power,
    )
