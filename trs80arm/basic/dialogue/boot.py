"""Power-on: MEMORY SIZE?, and the banner.

The answer reserves the memory from an address on for machine code; BASIC's strings end two below.
"""

from __future__ import annotations

from typing import Any, Final

from trs80arm.basic import cruncher
from trs80arm.basic.activity import Waiting
from trs80arm.basic.dialogue import line_range
from trs80arm.basic.dialogue.line_input import LineInput
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.state import Activity, State

LEAST_TOP: Final = 17430
"""Below this address there is no room for BASIC: ?OM."""
_CLEAR_SCREEN = b"\x1c\x1f"
_T_PROBE: Final = 16
"""T-states per byte of RAM of the test that finds its end when only ENTER was pressed."""


class MemorySize(Activity):
    """Asks until the answer makes sense, then hands over to the command level."""

    _clear: bool

    def __init__(self) -> None:
        self._clear = True

    def advance(self, state: State) -> None:
        """Ask."""
        if self._clear:
            state.output.show(_CLEAR_SCREEN)
        self._clear = False
        state.output.show(b"MEMORY SIZE? ")
        state.begin(LineInput(Waiting.MEMORY_SIZE))

    def resumed(self, state: State, result: Any) -> None:
        """An answer, or None for BREAK, which asks again."""
        answer = result.text
        if answer is None:
            return
        try:
            top = self._top(state, answer)
        except BasicError as error:
            state.output.show(b"?" + error.code.letters.encode("ascii") + b" Error")
            self._clear = True
            return
        if top is not None:
            state.cold_start(top)
            state.output.show(b"RADIO SHACK LEVEL II BASIC\r")
            state.end()

    def _top(self, state: State, answer: bytes) -> int | None:
        """The highest address for BASIC; None when there is no RAM at the address given."""
        memory = state.memory
        position = line_range.skip_blanks(answer, 0)
        if position >= len(answer):
            state.clock.now += _T_PROBE * (memory.top - 0x4000)
            return memory.top - 1
        number, end = cruncher.line_number(answer, position)
        if number is None or end < len(answer):
            raise BasicError(Code.SN)
        if number > memory.top:
            return None
        if number < LEAST_TOP:
            raise BasicError(Code.OM)
        return number - 2
