"""How the command line leaves: its exit codes, and the one line of what cannot be done."""

from __future__ import annotations

import sys
from contextlib import suppress
from typing import NoReturn

from trs80arm import shown
from trs80arm.cli.streams import give_up_output

USAGE_ERROR = 2
BROKEN_PIPE = 128 + 13
"""The exit code when whoever read the output has left: that of a program ended by SIGPIPE."""
INTERRUPTED = 128 + 2


def fail(why: object) -> NoReturn:
    """Say one clear line on standard error and leave with the code for bad usage."""
    tell(shown.message(why))
    sys.exit(USAGE_ERROR)


def tell(line: str) -> None:
    """Say a line on standard error; where nothing can be written the exit code has to do."""
    with suppress(OSError):
        print(f"trs80arm: {line}", file=sys.stderr, flush=True)


def leave(error: BaseException) -> NoReturn:
    """Leave on what no command has foreseen: an interruption, a system's refusal, a fault."""
    if isinstance(error, KeyboardInterrupt):
        sys.exit(INTERRUPTED)
    if isinstance(error, BrokenPipeError):
        give_up_output()
        sys.exit(BROKEN_PIPE)
    if isinstance(error, OSError):
        from trs80arm.reasons import one_line, reason

        if error.filename:
            fail(one_line(error))
        give_up_output()
        fail(f"standard output: {reason(error)}")
    from trs80arm.desk.last_resort import FAULT, last_words
    from trs80arm.desk.places import state_folder

    tell(last_words(error, state_folder()))
    sys.exit(FAULT)
