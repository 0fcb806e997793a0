"""From a file with a surface to a file with its packing."""

from __future__ import annotations

import sys
import warnings
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pyvista as pv

from ..files.errors import PackingFileError
from ..files.surfaces import read_surface
from ..files.writers import write
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
    if target.is_dir():
        raise IsADirectoryError(f"{target}: found a directory, expected a file name")
    if not target.parent.is_dir():
        raise FileNotFoundError(f"{target}: there is no folder {target.parent}")
    with TemporaryDirectory() as folder:
        # Whether the packing can be written should be known before the work.
        trial = pv.PolyData(np.zeros((1, 3)))
        trial["radius"] = np.ones(1)
        trial_path = Path(folder) / target.name
        try:
            write(trial, trial_path)
        except PackingFileError as error:
            raise PackingFileError(str(error).replace(str(trial_path), str(target))) from None
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
        print(warning.message, file=sys.stderr)
    return not caught
