"""A process of its own for VTK's readers, which a damaged file may crash or keep busy for ever."""

from __future__ import annotations

import io
import math
import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..printable import printable
from .errors import SurfaceFileError
from .surface_rows import refuse

if TYPE_CHECKING:
    from collections.abc import Callable

# What a file may take, beside what is taken before: 64 times its bytes, 2 s for 100 kB.
_BYTES_PER_BYTE, _BYTES = 64, 1 << 30
_BYTES_PER_SECOND, _SECONDS = 50_000, 5.0
# Seconds that more may pass than the processor works, while libraries are loaded and for others.
_WAITING = 120.0
_CODE = "from spherepacking.files.vtk_surfaces import hand_over; hand_over()"
_REFUSED = 3


def arrays_from_child(path: Path) -> dict[str, np.ndarray]:
    """Let another process read a file.

    Parameters
    ----------
    path : pathlib.Path
        File to read.

    Returns
    -------
    dict[str, numpy.ndarray]
        What that process has handed over.

    Raises
    ------
    SurfaceFileError
        If it has refused the file, or has crashed, or has taken too long or too much memory.
    """
    seconds = _SECONDS + _WAITING + path.stat().st_size / _BYTES_PER_SECOND
    try:
        # -P: nothing is imported from the folder where the user is.
        done = subprocess.run(
            [sys.executable, "-P", "-c", _CODE, path.absolute()],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            timeout=seconds,
            check=False,
        )
    except subprocess.TimeoutExpired:
        refuse(path, f"a file that VTK's reader has not read in {seconds:.0f} s", "a whole one")
    if done.returncode == -signal.SIGXCPU:
        refuse(path, "a file that VTK's reader does not come to an end with", "a whole one")
    if done.returncode == _REFUSED:
        # The process was given an absolute path.
        sentence = done.stdout.decode().removeprefix(printable(str(path.absolute())))
        raise SurfaceFileError(f"{path}{sentence}")
    if done.returncode != 0:
        refuse(path, "a file on which VTK's reader crashes or runs out of memory", "a whole one")
    with np.load(io.BytesIO(done.stdout), allow_pickle=False) as arrays:
        return dict(arrays)


def hand_over_arrays(read: Callable[[Path], dict[str, np.ndarray]]) -> None:
    """Read the file that the command line names, and write arrays or what is wrong to stdout.

    Parameters
    ----------
    read : callable
        Reads a file into arrays, or raises a ValueError.
    """
    path = Path(sys.argv[1])
    # What VTK prints does not belong to what is handed over.
    stdout = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    most = _BYTES + _BYTES_PER_BYTE * path.stat().st_size + _taken()
    resource.setrlimit(resource.RLIMIT_DATA, (most, most))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    seconds = time.process_time() + _SECONDS + path.stat().st_size / _BYTES_PER_SECOND
    resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(seconds), math.ceil(seconds) + 5))
    with stdout:
        try:
            arrays = read(path)
        except ValueError as error:
            stdout.write(str(error).encode())
            stdout.flush()
            os._exit(_REFUSED)
        np.savez(stdout, allow_pickle=False, **arrays)


def _taken() -> int:
    """Bytes of data that this process has."""
    with open("/proc/self/status", encoding="utf-8") as status:
        return next(int(line.split()[1]) << 10 for line in status if line.startswith("VmData"))
