"""The system variables of BASIC in low RAM, and the program area, as PEEK and POKE see them.

Most of the ROM's variables simply are bytes in RAM. Those that the interpreter keeps as Python
values are read and written through the regions here: 40A0H string space, 40A2H line, 40AAH seed,
40B1H top of memory, 40D6H string pointer, 40E6H to 40F7H errors and CONT, 40FBH to 40FFH tables and
DATA (the period's memory maps; cases of the groups `memory` and `layout`).
"""

from __future__ import annotations

from typing import Final

from trs80arm.basic import addresses, room
from trs80arm.basic.addresses import set_word
from trs80arm.basic.execution import under_way
from trs80arm.basic.state import State

_JUMP = 0xC3
_RESTARTS = {0x4000: 0x1C96, 0x4003: 0x1D78, 0x4006: 0x1C90, 0x4009: 0x25D9}
"""Where the vectors of RST 8, 10H, 18H and 20H point (seen by PEEK)."""
_DISK_VECTOR = 0x400F
_INTERRUPT = 0x4012
_ENABLE = 0xFB
_WIDTH = 0x409D
_LAST_ZONE = 0x409E
_USR_UNSET: Final = 0x1E4A
"""Where the vector points until a program sets it: the ROM's FC error."""
_DISK_WORDS, _DISK_EXITS, _DISK_END = 0x4152, 0x41A6, 0x41E5
"""Vectors of three bytes: a jump to ?L3 for each word of Disk BASIC, then returns."""
_NO_DISK: Final = 0x012D


def power_on(ram: bytearray) -> None:
    """Set the variables that the ROM sets when the machine is switched on."""
    for address, target in _RESTARTS.items():
        ram[address] = _JUMP
        set_word(ram, address + 1, target)
    ram[addresses.BREAK_VECTOR] = ram[_DISK_VECTOR] = ram[_INTERRUPT + 1] = addresses.BREAK_ON
    ram[_INTERRUPT] = _ENABLE
    ram[_WIDTH], ram[_LAST_ZONE] = 64, 48
    set_word(ram, addresses.USR_VECTOR, _USR_UNSET)
    for address in range(_DISK_WORDS, _DISK_EXITS, 3):
        ram[address] = _JUMP
        set_word(ram, address + 1, _NO_DISK)
    for address in range(_DISK_EXITS, _DISK_END, 3):
        ram[address] = addresses.BREAK_ON
    ram[addresses.OUTPUT_DEVICE] = 0
    ram[addresses.PRINTER_COLUMN] = 0
    ram[addresses.KEY_LATCH] = 0
    set_word(ram, addresses.LINE_POINTER, addresses.INPUT_BUFFER + 3)
    set_word(ram, addresses.PROGRAM_START, addresses.PROGRAM)


class SystemArea:
    """The addresses whose values the interpreter keeps for itself."""

    RANGE: Final = (0x4099, 0x411C)

    def __init__(self, state: State) -> None:
        self._state = state

    def _words(self) -> dict[int, int]:
        """The words that are Python values, by address."""
        state = self._state
        control, strings, variables = state.control, state.strings, state.variables
        running = under_way(state)
        return {
            0x40A0: strings.bottom,
            0x40A2: 0xFFFF if running is None else running.line(state),
            0x40AA: state.seed & 0xFFFF,
            0x40B1: strings.top,
            0x40B3: 0x40B5 + 3 * len(strings.temporaries),
            0x40D6: strings.next,
            0x40DA: control.data_line,
            0x40E6: control.error_address if running is None else running.statement,
            0x40E8: strings.bottom - control.stack_bytes() - room.STACK_AT_REST,
            0x40EA: control.error_line,
            0x40EC: control.dot,
            0x40EE: control.error_address,
            0x40F0: control.trap,
            0x40F5: control.resume_line,
            0x40F7: control.resume_address,
            0x40FB: variables.arrays_start,
            0x40FD: variables.end,
            0x40FF: control.data,
        }

    def peek(self, address: int) -> int:
        """The byte at an address."""
        state = self._state
        if address == 0x40AC:
            return state.seed >> 16
        if address == addresses.ERROR_CODE:
            return state.control.error
        if address == 0x40F2:
            return 0xFF if state.control.handling else 0
        if address == addresses.TRACE_FLAG:
            return state.control.trace
        words = self._words()
        if address in words:
            return words[address] & 0xFF
        if address - 1 in words:
            # What is reckoned from a word that was POKEd may be below nought or beyond all words.
            return words[address - 1] >> 8 & 0xFF
        return state.memory.ram[address]

    def poke(self, address: int, value: int) -> None:
        """Change a byte; what cannot be a Python value's byte only changes RAM."""
        state = self._state
        state.memory.ram[address] = value
        if 0x40AA <= address <= 0x40AC:
            shift = 8 * (address - 0x40AA)
            state.seed = state.seed & ~(0xFF << shift) | value << shift
        elif address == addresses.ERROR_CODE:
            state.control.error = value
        elif address == 0x40F2:
            state.control.handling = bool(value)
        elif address == addresses.TRACE_FLAG:
            state.control.trace = value
            state.engine.look_around()
        elif addresses.TYPE_TABLE <= address < addresses.TYPE_TABLE + addresses.LETTERS:
            state.engine.look_around()
        elif addresses.PROGRAM_START <= address <= addresses.PROGRAM_START + 1:
            state.program.changed()
            state.engine.look_around()
        else:
            self._poke_word(address, value)

    def _poke_word(self, address: int, value: int) -> None:
        state = self._state
        control, strings = state.control, state.strings
        owners: dict[int, tuple[object, str]] = {
            0x40A0: (strings, "bottom"),
            0x40B1: (strings, "top"),
            0x40D6: (strings, "next"),
            0x40EC: (control, "dot"),
            0x40EE: (control, "error_address"),
            0x40F0: (control, "trap"),
            0x40F5: (control, "resume_line"),
            0x40F7: (control, "resume_address"),
            0x40FF: (control, "data"),
        }
        for start, (owner, name) in owners.items():
            if start <= address <= start + 1:
                old = getattr(owner, name)
                low, high = old & 0xFF, old >> 8
                new = low | value << 8 if address > start else high << 8 | value
                setattr(owner, name, new)


class Workspace:
    """RAM from the start of the program on: text, variables, free memory, strings."""

    def __init__(self, state: State) -> None:
        self._variables = state.variables
        self._ram = state.memory.ram
        self._state = state

    def peek(self, address: int) -> int:
        """The byte at an address."""
        variables = self._variables
        if variables.start <= address < variables.end:
            return variables.peek(address)
        return self._ram[address]

    def poke(self, address: int, value: int) -> None:
        """Store a byte; in the program's text the compiled statements are dropped."""
        variables = self._variables
        if variables.start <= address < variables.end:
            variables.poke(address, value)
            return
        before = self._ram[address]
        self._ram[address] = value
        if address < variables.start:
            self._state.program.poked(address, before)
            self._state.engine.look_around()
