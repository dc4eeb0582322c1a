"""Changing the program: lines typed at the prompt, lines from AUTO and EDIT, a whole program."""

from __future__ import annotations

from collections.abc import Iterable

from trs80arm.basic import costs, cruncher, editing_costs, endings, room
from trs80arm.basic.characters import BLANKS
from trs80arm.basic.errors import Code
from trs80arm.basic.state import State

LINE_OVERHEAD = 5
"""A line's link, number and final zero."""


def store_line(state: State, number: int, text: bytes) -> None:
    """Store a typed line (not crunched yet) under a number; one of blanks or nothing deletes.

    All variables, CONT and the error trap go, as in the ROM (facts, thing 12).

    Raises:
        BasicError: OM when it does not fit.
    """
    crunched, cost = cruncher.crunch(text)
    if not text.strip(BLANKS):
        crunched = b""
    program = state.program
    control = state.control
    clock = state.clock
    clock.now += costs.STORE_LINE + cost
    clock.now += editing_costs.search(program, number)
    control.dot = number
    is_new = program.find(number) is None
    if is_new:
        clock.now += costs.NEW_LINE_NUMBER
    needed = len(crunched) + LINE_OVERHEAD + room.LINE
    if crunched and is_new:
        # The variables are about to go, but the stack is still there.
        state.room.need(needed - (state.variables.end - program.end))
    delete_range(state, number, number)
    frames = list(control.frames)
    state.clear_all()
    if crunched:
        # The room is looked at before the stack is emptied, and the old line is gone by then.
        control.frames[:] = frames
        try:
            state.room.need(needed)
        finally:
            control.frames[1:] = []
        clock.now += editing_costs.put_in(program.place_for(number), program.end, crunched)
        program.store(number, crunched)
        state.clear_all()
    clock.now += editing_costs.link(program, number)


def delete_range(state: State, first: int, last: int) -> None:
    """Take the lines from `first` to `last` out of the program, in the time of the ROM's move."""
    program = state.program
    before = program.end
    if program.delete_range(first, last):
        stop = program.place_for(first) + before - program.end
        state.clock.now += editing_costs.take_out(stop, before)


def load_lines(state: State, lines: Iterable[tuple[int, bytes]]) -> None:
    """Replace the program by crunched lines, sorted by number, as a tape would.

    Lines that do not fit into memory are left out, and ?OM is reported.
    """
    wanted = sorted(dict(lines).items())
    free = state.strings.bottom - state.program.start - room.LINE
    fits = []
    for number, text in wanted:
        free -= len(text) + LINE_OVERHEAD
        if free < 0:
            break
        fits.append((number, text))
    state.program.load(fits)
    state.clear_all()
    if len(fits) < len(wanted):
        endings.report(state, Code.OM, None)
