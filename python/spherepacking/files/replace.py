"""Files that appear under their name only when they are complete."""

from __future__ import annotations

import os
import secrets
import shutil
import stat
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Buffer


def check_replaceable(path: Path) -> Path:
    """Raise an OSError unless a file can be written at `path`, as far as that is known before.

    Parameters
    ----------
    path : pathlib.Path
        Where the file is to be; links are followed.

    Returns
    -------
    pathlib.Path
        Where the links lead to.

    Raises
    ------
    FileNotFoundError
        If the folder does not exist.
    PermissionError
        If the file or its folder cannot be written to.
    OSError
        If there is something that is no regular file, such as a folder, a device or a pipe.
    """
    target = Path(os.path.realpath(path))
    if target.is_symlink():
        raise OSError(f"{path}: found links that lead in a circle, expected a file or none")
    if not target.parent.is_dir():
        raise FileNotFoundError(f"{path}: there is no folder {target.parent}")
    if target.exists():
        if not stat.S_ISREG(target.stat().st_mode):
            raise OSError(f"{path}: found something that is no regular file, expected one or none")
        # Renaming would not ask for it.
        if not os.access(target, os.W_OK):
            raise PermissionError(
                f"{path}: found a file that is write-protected, expected one that can be written to"
            )
    if not os.access(target.parent, os.W_OK | os.X_OK):
        raise PermissionError(
            f"{path}: found a folder that cannot be written to, expected one that can be"
        )
    return target


def replace_file(path: Path, data: Buffer) -> None:
    """Write a file under another name in its folder, then rename it; an earlier one keeps its mode.

    AtomicFile.cxx does the same for packings.

    Parameters
    ----------
    path : pathlib.Path
        Where the file is to be; links are followed.
    data : bytes or another buffer
        Its contents.

    Raises
    ------
    OSError
        If it cannot be written; an earlier file is left as it was, and no other one is left.
    """
    target = check_replaceable(path)
    # A name of its own, since one that is longer than the target's may be too long.
    part = target.with_name(f".{secrets.token_hex(8)}.part")
    try:
        with part.open("xb") as file:
            try:
                file.write(data)
                file.close()
                if target.exists():
                    shutil.copymode(target, part)
                part.replace(target)
            except BaseException:
                part.unlink()
                raise
    except OSError as error:
        raise OSError(f"{path}: the file cannot be written ({error.strerror})") from error
