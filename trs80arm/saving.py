"""Writing a file whole or not at all, for everything of the user's that is saved.

Programs, cassettes, traces, settings and recovery copies go through here; a crash or a full disk
leaves the older file as it was. What is no regular file (a terminal, a pipe, `/dev/null`) is
written to and never replaced.
"""

from __future__ import annotations

import errno
import os
import re
import stat
import sys
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

from trs80arm.locks import hold, remove_unheld
from trs80arm.paths import at_once

_BEGINNING, _ENDING = ".trs80arm-", ".saving"
_UNFINISHED = re.compile(r"\.trs80arm-[a-z0-9_]{8}\.saving")
"""A file that has not got its name yet; its writer holds a lock on it."""


def write_whole(path: Path, content: bytes) -> None:
    """Write a file so that it holds either all of `content` or what it held before.

    Raises:
        OSError: the file cannot be written; an older one is untouched.
    """
    with whole_file(path) as file:
        file.write(content)


@contextmanager
def whole_file(path: Path) -> Iterator[BinaryIO]:
    """A file to write bit by bit, which takes its name only when all of it is written.

    The content goes to a new file beside it first, is brought to the disk, and then takes the
    name. A link is followed. Of a file that exists the permissions stay, and the owner and group
    where the system lets them. A device or a pipe is written to directly.

    Raises:
        OSError: the file cannot be written; an older one is untouched.
    """
    with _called(path), ExitStack() as opened:
        there = _look(path)
        if there is not None and not stat.S_ISREG(there.st_mode):
            yield opened.enter_context(open_to_write(path))
            return
        target = _target(path, there)
        temporary, file = _begin(target.parent)
        opened.enter_context(file)
        try:
            yield file
            file.flush()
            _dress(file.fileno(), there)
            os.fsync(file.fileno())
            if sys.platform == "win32":
                file.close()
            # Still open, and so locked: nobody takes it for a killed writer's.
            os.replace(temporary, target)
        except BaseException:
            with suppress(OSError):
                os.unlink(temporary)
            raise
        _bring_to_disk(target.parent)


def expect_to_write(path: Path) -> None:
    """Find out whether a file can be written, before the work that it is to hold is done.

    Raises:
        OSError: it cannot. What it would be for a device or a pipe is only known when it is opened.
    """
    with _called(path):
        there = _look(path)
        if there is not None and stat.S_ISDIR(there.st_mode):
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        if there is None or stat.S_ISREG(there.st_mode):
            temporary, file = _begin(_target(path, there).parent)
            file.close()
            os.unlink(temporary)


@contextmanager
def _called(path: Path) -> Iterator[None]:
    """Errors bear the name that the user knows the file by, not that of the unfinished one."""
    try:
        yield
    except OSError as error:
        if error.filename is None or _UNFINISHED.fullmatch(Path(error.filename).name):
            raise OSError(error.errno, error.strerror, str(path)) from None
        raise


def _look(path: Path) -> os.stat_result | None:
    """What is at a path now, links followed; None for nothing."""
    try:
        return os.stat(path)
    except FileNotFoundError:
        return None
    except ValueError:
        # A zero in the name.
        raise OSError(errno.EINVAL, os.strerror(errno.EINVAL)) from None


def _target(path: Path, there: os.stat_result | None) -> Path:
    """The regular file that is to be written, links followed.

    Raises:
        PermissionError: there is one, which may not be.
    """
    target = Path(os.path.realpath(path))
    if there is not None and not _is_writable(target):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    return target


def _is_writable(path: Path) -> bool:
    """Whether the file itself may be written, as replacing it would not ask."""
    return os.access(path, os.W_OK, effective_ids=os.access in os.supports_effective_ids)


def open_to_write(path: Path, *, append: bool = False) -> BinaryIO:
    """A file that is written bit by bit, from its beginning or on from its end; a device or a pipe.

    Raises:
        OSError: it cannot be opened, or is a pipe that nobody reads, which would wait for ever.
    """
    return open(path, "ab" if append else "wb", opener=at_once)


def _begin(folder: Path) -> tuple[Path, BinaryIO]:
    """A new file in a folder, in which killed writers may have left theirs."""
    _clear(folder)
    while True:
        # Its name has nothing of the target's, which may be as long as names can be.
        descriptor, name = tempfile.mkstemp(_ENDING, _BEGINNING, folder)
        file = os.fdopen(descriptor, "wb")
        hold(file)
        if os.fstat(descriptor).st_nlink:
            return Path(name), file
        file.close()  # Another writer cleared it away before it was locked.


def _clear(folder: Path) -> None:
    """Remove what writers have left who were killed: files that nobody holds a lock on."""
    with suppress(OSError):
        for name in os.listdir(folder):
            if _UNFINISHED.fullmatch(name):
                remove_unheld(folder / name)


def _dress(descriptor: int, like: os.stat_result | None) -> None:
    """Give a new file the owner and permissions of the old one, or those of any new file."""
    if sys.platform == "win32":
        return
    if like is None:
        mask = os.umask(0)
        os.umask(mask)
        os.fchmod(descriptor, 0o666 & ~mask)
        return
    now = os.fstat(descriptor)
    if now.st_uid != like.st_uid:
        with suppress(OSError):
            os.fchown(descriptor, like.st_uid, -1)
    if now.st_gid != like.st_gid:
        with suppress(OSError):
            os.fchown(descriptor, -1, like.st_gid)
    os.fchmod(descriptor, stat.S_IMODE(like.st_mode))


def _bring_to_disk(folder: Path) -> None:
    """Let the new name outlast a power cut; some file systems cannot say that of a folder."""
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
