"""A statement done beside the program: what somebody changes who looks into a machine that stands.

An assignment or a POKE is executed by the machine itself: types, ranges and room are checked
as they always are; but it takes none of the machine's time, moves no program on, and the input
buffer holds afterwards what it held before.
"""

from __future__ import annotations

from trs80arm.basic import words
from trs80arm.basic.characters import COLON, QUOTE, is_letter
from trs80arm.basic.execution import DIRECT_LINE, Leave
from trs80arm.basic.state import State

_CHANGING = (words.TOKENS["LET"], words.TOKENS["POKE"])
_OBSERVING = {words.TOKENS[name]: name for name in ("USR", "INP", "INKEY$")}
"""Functions that look at the machine at work, for which time would have to pass."""
_LONGEST = 240
"""Bytes of a line as they can be typed."""


def do(state: State, crunched: bytes) -> None:
    """Do an assignment or a POKE, crunched.

    Raises:
        BasicError: what the machine says to it.
        ValueError: it is another statement, or not one alone; one line that says so.
    """
    check(crunched)
    ram, clock = state.memory.ram, state.clock
    buffer = slice(DIRECT_LINE, DIRECT_LINE + len(crunched) + 4)
    held, now, temporaries = bytes(ram[buffer]), clock.now, list(state.strings.temporaries)
    ram[buffer] = b":" + crunched + b"\0\0\0"
    state.engine.forget_direct()
    try:
        state.engine.step(DIRECT_LINE)
    except Leave:
        state.engine.stale = False
    finally:
        ram[buffer] = held
        state.engine.forget_direct()
        state.strings.temporaries[:] = temporaries
        clock.now = now


def check(crunched: bytes) -> None:
    """See that it is one assignment or POKE that looks at nothing.

    Raises:
        ValueError: it is not; one line that says why.
    """
    if not crunched or not (is_letter(crunched[0]) or crunched[0] in _CHANGING):
        raise ValueError("only an assignment, as A=5, or a POKE changes something here")
    quoted = False
    for code in crunched:
        quoted ^= code == QUOTE
        if quoted:
            continue
        if code == COLON:
            raise ValueError("one statement at a time")
        if code in _OBSERVING:
            raise ValueError(f"{_OBSERVING[code]} takes time, and none passes here")
    if len(crunched) > _LONGEST:
        raise ValueError("a line that long cannot be typed")
