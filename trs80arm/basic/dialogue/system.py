"""SYSTEM: machine code from tape, and the jump to it.

What a tape holds is loaded into memory. A jump to the ROM's own command level leads there; from
anywhere else on the Z-80 goes on (`machine_code`).
"""

from __future__ import annotations

from typing import Any, Final

from trs80arm.basic import costs, cruncher, keyboard
from trs80arm.basic.activity import Waiting
from trs80arm.basic.addresses import word
from trs80arm.basic.characters import BLANKS
from trs80arm.basic.dialogue import line_range, machine_code
from trs80arm.basic.dialogue.line_input import Line, LineInput
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.state import Activity, State

READY_ENTRIES: Final = frozenset((0x0072, 0x06CC, 0x1A19))
"""Addresses of the ROM that lead back to READY: 114, 1740 and 6681."""
ENTRY: Final = 0x40DF
"""Two bytes, low first: where the last SYSTEM tape says its code begins."""

_NAME_MARK, _BLOCK_MARK, _END_MARK = 0x55, 0x3C, 0x78
_NAME_LENGTH = 6


class SystemCommand(Activity):
    """`*?`, over and over, until an answer leads away."""

    def advance(self, state: State) -> None:
        """Ask."""
        state.output.show(b"\r*? ")
        state.begin(LineInput(Waiting.SYSTEM))

    def resumed(self, state: State, result: Any) -> None:
        """A name to load, or `/` and an address to go to; BREAK leads to READY."""
        if not isinstance(result, Line):
            return  # A tape has been loaded.
        if result.text is None:
            state.return_to_command()
            return
        answer: bytes = result.text.strip(BLANKS)
        if line_range.at_end(answer, 0):
            raise BasicError(Code.SN)
        if answer[:1] == b"/":
            self._go(state, answer)
        else:
            state.begin(SystemTape(answer[:_NAME_LENGTH]))

    def _go(self, state: State, answer: bytes) -> None:
        ram = state.memory.ram
        address: int | None = word(ram, ENTRY)
        position = line_range.skip_blanks(answer, 1)
        if not line_range.at_end(answer, position):
            address, position = cruncher.line_number(answer, position)
            if address is None or not line_range.at_end(answer, position):
                return
        assert address is not None
        if address in READY_ENTRIES:
            state.return_to_command()
        else:
            machine_code.go(state, address)


class SystemTape(Activity):
    """A tape of machine code being read into memory.

    Args:
        name: up to six characters; the first program of that name is taken.
    """

    _name: bytes
    _playing: bool

    def __init__(self, name: bytes) -> None:
        self._name = name.ljust(_NAME_LENGTH)
        self._playing = False

    @property
    def wanted(self) -> str:
        """The name that is looked for."""
        return self._name.decode("latin-1").rstrip()

    def advance(self, state: State) -> None:
        """Search for the name and load; a tape that has run out plays on until BREAK."""
        tape = state.host.tape
        if not self._playing:
            tape.start_reading()
            self._playing = True
        elif tape.find_sync():
            if self._read(state) == _NAME_MARK and self._is_name(state):
                self._load(state)
                tape.stop()
                state.end()
        elif keyboard.next_key(state) == keyboard.BREAK:
            tape.stop()
            state.return_to_command()

    def _read(self, state: State) -> int | None:
        value = state.host.tape.read()
        state.clock.now += costs.tape_byte(value or 0)
        return value

    def _is_name(self, state: State) -> bool:
        return bytes(self._read(state) or 0 for _ in range(_NAME_LENGTH)) == self._name

    def _load(self, state: State) -> None:
        """Blocks of up to 256 bytes, each with its address, then the entry."""
        memory = state.memory
        while self._read(state) == _BLOCK_MARK:
            length = self._read(state) or 256
            address = (self._read(state) or 0) | (self._read(state) or 0) << 8
            for place in range(length):
                memory.poke(address + place & 0xFFFF, self._read(state) or 0)
            self._read(state)  # The sum, which the ROM shows as a C when it is wrong.
        for place in range(2):
            memory.poke(ENTRY + place, self._read(state) or 0)
