"""Machine code at work beside BASIC: begun by USR or by the `/` of SYSTEM.

The processor executes what is in RAM. Where it comes to an address of the ROM, of which nothing is
here, this project's BASIC and drivers answer (`rom_entries`), or say that they cannot. BREAK ends
it: at once if the code does not look at the keyboard, and held for a second in any case.
"""

from __future__ import annotations

from typing import Any, Final

from trs80arm.basic import addresses
from trs80arm.basic.activity import Waiting
from trs80arm.basic.control import DIRECT
from trs80arm.basic.dialogue import accumulator, rom_entries
from trs80arm.basic.dialogue.line_input import Line, LineInput
from trs80arm.basic.endings import stop
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.execution import break_
from trs80arm.basic.host import Processor
from trs80arm.basic.kinds import SIZES, STRING
from trs80arm.basic.outcome import Ending
from trs80arm.basic.state import Activity, State

RETURN_ADDRESS: Final = 0x0890
"""Where the ROM has a routine that USR called come back to."""
SYSTEM_STACK: Final = 0x4288
"""Where the stack is when SYSTEM goes to a program."""
_STACK: Final = 18
"""Bytes of the Z-80's stack that an expression with USR has in use."""
_UNSEEN: Final = 88_704
"""T-states, 50 ms, for which BREAK is down unseen until it ends the code."""
_HELD: Final = 1_774_080
"""T-states, a second, for which BREAK is down until it ends any code."""
_HALT_LOOK: Final = 65_536


def processor_of(state: State) -> Processor:
    """The processor; where there is none that is said, and FC."""
    processor = state.host.processor
    if processor is None:
        raise BasicError(Code.FC)
    if processor.missing:
        _tell(state, processor.missing.encode("ascii"))
        raise BasicError(Code.FC)
    return processor


def _tell(state: State, text: bytes) -> None:
    state.output.leave_printer()
    state.output.newline_if_needed()
    state.output.show(text + b"\r")


def call(state: State, argument: Any) -> None:
    """Begin the routine that USR calls, with its argument in the accumulator."""
    vector = addresses.word(state.memory.ram, addresses.USR_VECTOR)
    if vector == rom_entries.FC_ERROR:
        raise BasicError(Code.FC)
    processor = processor_of(state)
    kind = accumulator.put(state, argument)
    registers = processor.registers
    registers.settle()
    registers.sp = max(state.strings.bottom - state.control.stack_bytes() - _STACK, 0) & 0xFFFF
    processor.push(RETURN_ADDRESS)
    registers.a = SIZES[kind]
    registers.hl = registers.pc = vector
    registers.de = addresses.word(state.memory.ram, 0x4121) if kind == STRING else RETURN_ADDRESS
    state.begin(MachineCode())


def go(state: State, address: int) -> None:
    """Go to a program, as SYSTEM does; it has nothing to come back to."""
    processor = processor_of(state)
    registers = processor.registers
    registers.settle()
    registers.sp = SYSTEM_STACK
    registers.hl = registers.pc = address
    state.begin(MachineCode())


def push_reset(state: State) -> None:
    """The reset button ends machine code, whatever it waits for."""
    if any(isinstance(activity, MachineCode) for activity in state.stack):
        stop(state, DIRECT, 0, Ending.END)


class MachineCode(Activity):
    """The processor executes what is in RAM."""

    _down: int
    """The T-state from which BREAK is down; -1 while it is not."""
    _waits: bool
    """Whether a routine of the ROM waits for a key."""
    _line_at: int
    """Where the line goes that is being typed."""

    def __init__(self) -> None:
        self._down = -1
        self._waits = False
        self._line_at = 0

    @property
    def waiting(self) -> Waiting:
        """INPUT while the code has called for a key, and otherwise nothing."""
        return Waiting.INPUT if self._waits else Waiting.NOTHING

    def advance(self, state: State) -> None:
        """Execute code until the clock's limit."""
        clock, processor = state.clock, processor_of(state)
        processor.without_rom(rom_entries.JUMPS, rom_entries.T_JUMP)
        registers = processor.registers
        while clock.now < clock.limit and state.stack[-1] is self:
            due = self._break_due(state, processor)
            if clock.now >= due:
                break_(state)
                return
            grid = clock.now - clock.now % _HALT_LOOK + _HALT_LOOK
            processor.answer_live(
                (0x4099, 0x411C),
                (addresses.PROGRAM, max(state.variables.end, addresses.PROGRAM + 1)),
            )
            if processor.run(min(clock.limit, grid, due)):
                self._answer(state, processor, registers.pc)
            elif registers.halted and clock.now >= grid:
                # The board's HALT line pulls the reset button's circuit.
                stop(state, DIRECT, 0, Ending.END)

    def _break_due(self, state: State, processor: Processor) -> int:
        """The T-state at which BREAK, if it stays down, ends the code."""
        now = state.clock.now
        if not state.memory.peek(rom_entries.BREAK_ROW) & rom_entries.BREAK_BIT:
            self._down = -1
            return now + _HELD
        if self._down < 0:
            self._down = now
        return min(self._down + _HELD, max(self._down, processor.looked) + _UNSEEN)

    def _answer(self, state: State, processor: Processor, address: int) -> None:
        if address == RETURN_ADDRESS:
            state.code_calls.returned(accumulator.get(state))
            state.end()
            return
        entry = rom_entries.ENTRIES.get(address)
        if entry is None:
            _tell(state, b"Machine code went to %04XH in the ROM, which is not here" % address)
            raise BasicError(Code.FC)
        called = rom_entries.Call(state, processor, address)
        entry(called)
        self._waits = called.waits
        if called.wants_line:
            self._line_at = called.registers.hl
            state.begin(LineInput(Waiting.INPUT))

    def resumed(self, state: State, result: Any) -> None:
        """A line was typed for the code."""
        if isinstance(result, Line):
            processor = processor_of(state)
            rom_entries.give_line(rom_entries.Call(state, processor, 0), self._line_at, result)
