"""From a file with a surface to a file with its packing."""

from __future__ import annotations

import logging
import sys
import warnings
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pyvista as pv

from ._errors import PackingFileError
from ._off import read_off
from ._pack import pack
from ._ply import ends_early
from .writers import write


def read_surface(path: Path) -> pv.PolyData:
    """Read a surface of any format that PyVista reads, or OFF.

    Parameters
    ----------
    path : pathlib.Path
        File to read.

    Returns
    -------
    pyvista.PolyData
        The surface.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ValueError
        If the file holds no surface.
    """
    if not path.is_file():
        raise FileNotFoundError(f"{path}: there is no such file")
    if path.suffix.lower() == ".off":
        mesh = read_off(path)
    elif path.suffix.lower() == ".ply" and ends_early(path):
        raise ValueError(f"{path}: is no surface that can be read: the file ends early")
    else:
        # What goes wrong is said below, once.
        logging.disable(logging.CRITICAL)
        try:
            with pv.vtk_verbosity("off"), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                mesh = pv.read(path)
        except Exception as error:  # readers raise all kinds
            raise ValueError(f"{path}: is no surface that can be read: {error}") from None
        finally:
            logging.disable(logging.NOTSET)
        if isinstance(mesh, pv.MultiBlock):
            mesh = mesh.combine()
        if not isinstance(mesh, pv.PolyData):
            mesh = mesh.extract_surface(algorithm=None)
    if not mesh.n_faces + mesh.n_strips:
        raise ValueError(f"{path}: found no polygons, expected a closed surface")
    return mesh


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
        raise IsADirectoryError(f"{target}: is a directory, expected a file name")
    if not target.parent.is_dir():
        raise FileNotFoundError(f"{target}: there is no folder {target.parent}")
    with TemporaryDirectory() as folder:
        # What cannot be written is better known before the work than after it.
        trial = pv.PolyData(np.zeros((1, 3)))
        trial["radius"] = np.ones(1)
        trial_path = Path(folder) / target.name
        try:
            write(trial, trial_path)
        except PackingFileError as error:
            raise PackingFileError(str(error).replace(str(trial_path), str(target))) from None
    mesh = read_surface(source)
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
