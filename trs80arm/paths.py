"""Names of files as people type them: looked at without a surprise, whatever was typed.

The system refuses some names (too long, a user that there is none of) by an exception where the
question was only what there is. Here such a name is simply one under which there is nothing.
"""

from __future__ import annotations

import os
import stat
from pathlib import Path
from typing import BinaryIO

from trs80arm.reasons import reason

_AT_ONCE = getattr(os, "O_NONBLOCK", 0)
"""Opens a pipe without waiting for its other end."""


def at_once(path: str, flags: int) -> int:
    """An opener for `open` that waits for nobody: a pipe without another end is opened, or refused.

    Raises:
        OSError: it cannot be opened, or is to be written and is a pipe that nobody reads.
    """
    descriptor = os.open(path, flags | _AT_ONCE, 0o666)
    if _AT_ONCE:
        os.set_blocking(descriptor, True)
    return descriptor


def typed_path(text: str) -> Path:
    """The path that was typed; `~` and `~user` are home folders where there is such a user."""
    path = Path(text.strip())
    try:
        return path.expanduser()
    except (RuntimeError, ValueError):
        # No such user; or a name that no user can have.
        return path


def _mode(path: Path) -> int:
    try:
        return os.stat(path).st_mode
    except (OSError, ValueError):
        return 0


def is_file(path: Path) -> bool:
    """Whether there is a regular file of that name."""
    return stat.S_ISREG(_mode(path))


def is_folder(path: Path) -> bool:
    """Whether there is a folder of that name."""
    return stat.S_ISDIR(_mode(path))


def beside(path: Path, suffix: str) -> Path | None:
    """The file that is named like another one and stands beside it, if there is one."""
    there = path.with_suffix(suffix) if path.name else path
    return there if is_file(there) else None


def refusal(path: Path) -> str:
    """Why the system takes no file of that name; empty if it does, or if there just is none."""
    try:
        os.stat(path)
    except FileNotFoundError:
        return ""
    except OSError as error:
        return f"{path.name[:40]}: {reason(error)}"
    except ValueError:
        return "No file can be called that."
    return ""


def open_to_read(path: Path) -> BinaryIO:
    """A file to be read, or a pipe that somebody writes to.

    A pipe that nobody has opened is at its end at once: nothing here waits for somebody to come.

    Raises:
        OSError: it cannot be opened.
    """
    return open(path, "rb", opener=at_once)


def read_beginning(path: Path, most: int) -> bytes:
    """At most `most` bytes of a regular file.

    Raises:
        OSError: it cannot be read, or is something that one could wait for: a pipe, a device.
    """
    with open_to_read(path) as file:
        if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
            raise OSError(0, "not a file", str(path))
        return file.read(most)
