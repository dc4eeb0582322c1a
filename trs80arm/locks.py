"""Files that a process holds while it lives, so that others know that they are in use.

The system lets go when the process ends, however it ends. Windows has no such locks; there nothing
is ever held.
"""

from __future__ import annotations

import sys
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from trs80arm.paths import open_to_read


def hold(file: BinaryIO) -> None:
    """Hold a file for as long as it is open.

    Raises:
        OSError: somebody else holds it.
    """
    if sys.platform != "win32":
        import fcntl

        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


def is_held(path: Path) -> bool:
    """Whether somebody holds the file of that name now."""
    try:
        with open_to_read(path) as file:
            hold(file)
    except BlockingIOError:
        return True
    except OSError:
        return False
    return False


def remove_unheld(path: Path) -> None:
    """Remove a file unless somebody holds it."""
    with suppress(OSError), open_to_read(path) as file:
        hold(file)
        path.unlink()
