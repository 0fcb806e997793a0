"""From a file with a surface to a file with its packing."""

from __future__ import annotations

import sys
import warnings
from pathlib import Path

import numpy as np

from ..files.surfaces import read_surface
from ..files.writers import check_writable, write
from ..make.pack import pack
from ..printable import printable


def pack_file(
    source: Path,
    target: Path,
    *,
    count: int,
    seed: int,
    min_radius: float | None,
    fraction: float | None,
) -> bool:
    """Pack the surface of a file, write the packing and say how full it is.

    Parameters
    ----------
    source : pathlib.Path
        File with the surface.
    target : pathlib.Path
        File to write.
    count, seed, min_radius, fraction
        See :func:`spherepacking.pack`.

    Returns
    -------
    bool
        False if Ctrl-C ended it early; the spheres that were there are written.
    """
    # Before the work, which may be long.
    check_writable(target)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        mesh = read_surface(source)
    for warning in told:
        print(printable(str(warning.message)), file=sys.stderr)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        packing = pack(
            mesh,
            count,
            seed=seed,
            min_radius=min_radius,
            fraction=fraction,
            progress_bar=sys.stderr.isatty(),
        )
    write(packing, target)
    filled = float(packing.field_data["volume_fraction"][0])
    part = "an unknown part" if np.isnan(filled) else f"{filled:.1%}"
    print(f"{packing.n_points} spheres fill {part} of the volume")
    for warning in caught:
        print(printable(str(warning.message)), file=sys.stderr)
    return not caught
