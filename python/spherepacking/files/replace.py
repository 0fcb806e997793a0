"""Files that appear under their name only when they are complete."""

from __future__ import annotations

import errno
import fcntl
import os
import re
import secrets
import stat
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

from ..printable import printable

if TYPE_CHECKING:
    from collections.abc import Buffer, Iterator
    from typing import BinaryIO

_PART = re.compile(r"\.spherepacking-[0-9a-f]{16}\.part")


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
    name = printable(str(path))
    if target.is_symlink():
        raise OSError(f"{name}: found links that lead in a circle, expected a file or none")
    if not target.parent.is_dir():
        raise FileNotFoundError(f"{name}: there is no folder {printable(str(target.parent))}")
    if target.is_dir():
        raise IsADirectoryError(f"{name}: found a directory, expected a file name")
    if target.exists():
        if not stat.S_ISREG(target.stat().st_mode):
            raise OSError(f"{name}: found something that is no regular file, expected one or none")
        # Renaming would not ask for it.
        if not os.access(target, os.W_OK):
            raise PermissionError(
                f"{name}: found a file that is write-protected, expected one that can be written to"
            )
    if not os.access(target.parent, os.W_OK | os.X_OK):
        raise PermissionError(
            f"{name}: found a folder that cannot be written to, expected one that can be"
        )
    return target


def replace_file(path: Path, data: Buffer) -> None:
    """Write a file that takes the place of an earlier one when it is complete.

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
    with replacing(path) as file:
        file.write(data)


@contextmanager
def replacing(path: Path) -> Iterator[BinaryIO]:
    """Open a file that takes the place of an earlier one when the block has ended well.

    Until then it has no name where the file system can do that (O_TMPFILE of Linux), so that
    whatever ends the process leaves nothing. Else, and for the moment before it takes its final
    name, it is called ``.spherepacking-….part`` and locked, and whoever writes into that folder
    next removes those that nobody has locked. It has the permissions and the group of an earlier
    file; while it is written nobody but its owner may open it. Other hard links to the earlier file
    keep what that held. PartFile.cxx does the same for packings.

    Parameters
    ----------
    path : pathlib.Path
        Where the file is to be; links are followed.

    Yields
    ------
    file
        It is open for writing, in binary.

    Raises
    ------
    OSError
        If it cannot be written; an earlier file is left as it was, and no other one is left.
    """
    target = check_replaceable(path)
    _remove_left(target.parent)
    # Nobody can foresee the name; one that is longer than the target's might be too long.
    part = target.with_name(f".spherepacking-{secrets.token_hex(8)}.part")
    try:
        try:
            descriptor, named = _open_part(part, target)
            with os.fdopen(descriptor, "wb") as file:
                yield file
                file.flush()
                _take_permissions(descriptor, target)
                # Else, after a loss of power, the name might stand for a file that is not whole.
                _sync(descriptor)
                if not named:
                    # An earlier file can be replaced by one that has a name, only.
                    _give_name(descriptor, part)
                part.replace(target)
        except BaseException:
            # Ctrl-C may come when it has its final name.
            part.unlink(missing_ok=True)
            raise
    except OSError as error:
        if error.strerror is None:
            raise
        raise OSError(
            f"{printable(str(path))}: the file cannot be written ({error.strerror})"
        ) from error


def _open_part(part: Path, target: Path) -> tuple[int, bool]:
    """Open a file to replace `target`, locked, and tell whether it has the name `part`."""
    # What may be private is not to be read by others while it is written.
    mode = 0o600 if target.exists() else 0o666
    if os.access("/proc/self/fd", os.X_OK):
        # Not every file system has such files; whatever else is wrong comes up below.
        with suppress(OSError):
            descriptor = os.open(part.parent, os.O_TMPFILE | os.O_RDWR | os.O_CLOEXEC, mode)
            _lock(descriptor)
            return descriptor, False
    while True:
        descriptor = os.open(part, os.O_CREAT | os.O_EXCL | os.O_RDWR | os.O_CLOEXEC, mode)
        _lock(descriptor)
        # Somebody may have taken it for one that was left, before it was locked.
        if os.fstat(descriptor).st_nlink > 0:
            return descriptor, True
        os.close(descriptor)


def _give_name(descriptor: int, part: Path) -> None:
    folder = os.open(part.parent, os.O_PATH | os.O_DIRECTORY | os.O_CLOEXEC)
    try:
        # Python follows the link to the file with a folder that is given as a number, only.
        os.link(f"/proc/self/fd/{descriptor}", part.name, dst_dir_fd=folder, follow_symlinks=True)
    finally:
        os.close(folder)


def _lock(descriptor: int) -> None:
    # Where a file system has no locks, nobody gets one to remove the file either.
    with suppress(OSError):
        fcntl.flock(descriptor, fcntl.LOCK_EX)


def _sync(descriptor: int) -> None:
    try:
        os.fsync(descriptor)
    except OSError as error:
        # Some file systems have no such thing.
        if error.errno not in (errno.EINVAL, errno.ENOSYS):
            raise


def _take_permissions(descriptor: int, target: Path) -> None:
    """Give a file the group and the permissions of an earlier one."""
    try:
        earlier = target.stat()
    except FileNotFoundError:
        return
    permissions = stat.S_IMODE(earlier.st_mode) & 0o777
    if os.fstat(descriptor).st_gid != earlier.st_gid:
        try:
            os.fchown(descriptor, -1, earlier.st_gid)
        except OSError:
            # Another group gets none.
            permissions &= 0o707
    os.fchmod(descriptor, permissions)


def _remove_left(folder: Path) -> None:
    """Remove files of processes that are no more: nobody has locked them."""
    try:
        names = [name for name in os.listdir(folder) if name.startswith(".spherepacking-")]
    except OSError:
        return  # one may write into a folder that one may not list
    for name in filter(_PART.fullmatch, names):
        # Whatever is wrong with them is no reason not to write.
        with suppress(OSError):
            flags = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC
            descriptor = os.open(folder / name, flags)
            try:
                status = os.fstat(descriptor)
                if (
                    stat.S_ISREG(status.st_mode)
                    and status.st_uid == os.geteuid()
                    and status.st_nlink == 1
                ):
                    fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
                    os.unlink(folder / name)
            finally:
                os.close(descriptor)
