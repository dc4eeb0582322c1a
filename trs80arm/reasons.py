"""Why something could not be done, in the one line that a person is told."""

from __future__ import annotations

from trs80arm.shown import message


def reason(error: OSError) -> str:
    """Why a file could not be read or written, without the number and name of the system call."""
    return error.strerror or str(error)


def one_line(error: Exception) -> str:
    """What went wrong in one line, with the file's name before what the system says of it."""
    if isinstance(error, OSError) and error.filename:
        return message(f"{error.filename}: {reason(error)}")
    return message(str(error).splitlines()[0] if str(error) else type(error).__name__)
