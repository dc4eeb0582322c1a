"""When something goes wrong in the program itself, which must not happen.

The machine as it stands goes into a snapshot, what the operator did into a recording, what happened
into a report, all beside the recovery copies. The user is told one sentence.
"""

from __future__ import annotations

import contextlib
import platform
import traceback
from collections.abc import Callable
from pathlib import Path

from trs80arm import __version__
from trs80arm.desk.session import Session
from trs80arm.paths import is_file
from trs80arm.saving import write_whole
from trs80arm.shown import shown

FAULT = 3
"""The exit code after a fault of the program."""


def last_words(error: BaseException, folder: Path, session: Session | None = None) -> str:
    """Keep what can be kept after a fault.

    Args:
        error: what was raised.
        folder: the state folder.
        session: the machine, where there was one.

    Returns:
        The sentence for the user: what it was and what to send.
    """
    with contextlib.suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
    name = _free_name(folder)
    kept = []
    if session is not None:
        if _kept(lambda: write_whole(folder / f"{name}.snapshot", session.rig.snapshot())):
            kept.append(f"{name}.snapshot")
        if _kept(lambda: session.save_recording(folder / f"{name}.jsonl")):
            kept.append(f"{name}.jsonl")
    if _kept(lambda: write_whole(folder / f"{name}.txt", _report(error).encode())):
        kept.append(f"{name}.txt")
    sentence = f"a fault of the program itself: {_in_short(error)}"
    if kept:
        sentence += f"; please report it with {', '.join(kept)} in {folder}"
    return shown(sentence)


def _free_name(folder: Path) -> str:
    number = 1
    while any(is_file(folder / f"fault-{number}{end}") for end in (".txt", ".snapshot")):
        number += 1
    return f"fault-{number}"


def _kept(keep: Callable[[], None]) -> bool:
    """Whether something could be kept; whatever is broken now must not break this."""
    with contextlib.suppress(Exception):
        keep()
        return True
    return False


def _report(error: BaseException) -> str:
    where = f"Python {platform.python_version()}, {platform.platform()}"
    return f"trs80arm {__version__}, {where}\n\n{''.join(traceback.format_exception(error))}"


def _in_short(error: BaseException) -> str:
    """The error and where in the program it came up."""
    own = [
        f"{Path(frame.filename).name} line {frame.lineno}"
        for frame in traceback.extract_tb(error.__traceback__)
        if "trs80arm" in Path(frame.filename).parts
    ]
    place = f" in {own[-1]}" if own else ""
    return f"{type(error).__name__}{place}"
