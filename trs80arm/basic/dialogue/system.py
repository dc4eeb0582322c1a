"""SYSTEM: machine code from tape, and the jump to it.

There is no Z-80 here. What a tape holds is loaded into memory; a jump leads somewhere only where
the ROM's own command level is, and anywhere else is ?FC like a USR that was never set up.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from trs80arm.basic import costs, cruncher
from trs80arm.basic.activity import Activity, Waiting
from trs80arm.basic.dialogue import line_range, wait
from trs80arm.basic.dialogue.home import return_to_command
from trs80arm.basic.dialogue.line_input import Line, LineInput
from trs80arm.basic.errors import BasicError, Code

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter

READY_ENTRIES: Final = frozenset((0x0072, 0x06CC, 0x1A19))
"""Addresses of the ROM that lead back to READY: 114, 1740 and 6681."""
ENTRY: Final = 0x40DF
"""Two bytes, low first: where the last SYSTEM tape says its code begins."""

_NAME_MARK, _BLOCK_MARK, _END_MARK = 0x55, 0x3C, 0x78
_NAME_LENGTH = 6


class SystemCommand(Activity):
    """`*?`, over and over, until an answer leads away."""

    def advance(self, basic: Interpreter) -> None:
        """Ask."""
        basic.print_text(b"\r*? ")
        basic.begin(LineInput(Waiting.SYSTEM))

    def resumed(self, basic: Interpreter, result: Any) -> None:
        """A name to load, or `/` and an address to go to; BREAK leads to READY."""
        if not isinstance(result, Line):
            return  # A tape has been loaded.
        if result.text is None:
            return_to_command(basic)
            return
        answer: bytes = result.text.strip(b" \t\n")
        if not answer:
            raise BasicError(Code.SN)
        if answer[:1] == b"/":
            self._go(basic, answer)
        else:
            basic.begin(SystemTape(answer[:_NAME_LENGTH]))

    def _go(self, basic: Interpreter, answer: bytes) -> None:
        ram = basic.host.memory.ram
        address: int | None = ram[ENTRY] | ram[ENTRY + 1] << 8
        position = line_range.skip_blanks(answer, 1)
        if position < len(answer):
            address, position = cruncher.line_number(answer, position)
            if address is None or position < len(answer):
                return
        if address not in READY_ENTRIES:
            raise BasicError(Code.FC)
        return_to_command(basic)


class SystemTape(Activity):
    """A tape of machine code being read into memory.

    Args:
        name: up to six characters; the first program of that name is taken.
    """

    def __init__(self, name: bytes) -> None:
        self._name = name.ljust(_NAME_LENGTH)
        self._playing = False

    def advance(self, basic: Interpreter) -> None:
        """Search for the name and load; a tape that has run out plays on until BREAK."""
        tape = basic.host.tape
        if not self._playing:
            tape.start_reading()
            self._playing = True
        elif tape.find_sync():
            if self._read(basic) == _NAME_MARK and self._is_name(basic):
                self._load(basic)
                tape.stop()
                basic.end()
        elif wait.next_key(basic) == wait.BREAK:
            tape.stop()
            return_to_command(basic)

    def _read(self, basic: Interpreter) -> int | None:
        value = basic.host.tape.read()
        basic.host.clock.now += costs.tape_byte(value or 0)
        return value

    def _is_name(self, basic: Interpreter) -> bool:
        return bytes(self._read(basic) or 0 for _ in range(_NAME_LENGTH)) == self._name

    def _load(self, basic: Interpreter) -> None:
        """Blocks of up to 256 bytes, each with its address, then the entry."""
        memory = basic.host.memory
        while self._read(basic) == _BLOCK_MARK:
            length = self._read(basic) or 256
            address = (self._read(basic) or 0) | (self._read(basic) or 0) << 8
            for place in range(length):
                memory.poke(address + place & 0xFFFF, self._read(basic) or 0)
            self._read(basic)  # The sum, which the ROM shows as a C when it is wrong.
        for place in range(2):
            memory.poke(ENTRY + place, self._read(basic) or 0)
