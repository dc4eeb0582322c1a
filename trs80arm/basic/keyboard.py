"""How the machine waits for a key: the loops that look at the keyboard until one goes down.

The line editor, EDIT, the pause of SHIFT+@ and LIST use it. Nothing blocks: while no key changes,
waiting is letting the clock run to its limit.
"""

from __future__ import annotations

from typing import Final

from trs80arm.basic import addresses
from trs80arm.basic.state import State

BREAK: Final = 1
SHIFT_AT: Final = 96
"""The code of SHIFT+@, which pauses a program or a listing."""

_T_LOOK: Final = 797
"""T-states of one idle turn of the ROM's waiting loop, with the scan in it (measured)."""


def next_key(state: State) -> int:
    """The code of a key that goes down before the clock's limit, or 0 when that is reached."""
    clock, console = state.clock, state.host.console
    while clock.now < clock.limit:
        code = console.scan()
        if code:
            return code
        if console.quiet:
            clock.now = clock.limit
            break
        clock.now += _T_LOOK
    return 0


def look_for_break(state: State) -> int:
    """One look at the keyboard between two pieces of work, as the statement loop takes it.

    Returns:
        The key's code, 0 for none. Any key but BREAK and SHIFT+@ is remembered for INKEY$.
    """
    console = state.host.console
    if console.quiet:
        return 0
    code = console.scan()
    if code not in (0, BREAK, SHIFT_AT):
        latch(state, code)
    return code


def latch(state: State, code: int) -> None:
    """Remember a key for INKEY$; 0 forgets it."""
    state.memory.poke(addresses.KEY_LATCH, code)
