"""The system variables of BASIC in low RAM, and the program area, as PEEK and POKE see them.

Most of the ROM's variables simply are bytes in RAM. Those that the interpreter keeps as Python
values are read and written through the regions here: 40A0H string space, 40A2H line, 40AAH seed,
40B1H top of memory, 40D6H string pointer, 40E6H to 40F7H errors and CONT, 40FBH to 40FFH tables and
DATA (the period's memory maps; cases of the groups `memory` and `layout`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from trs80arm.basic import room
from trs80arm.basic.program import START

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter

BREAK_VECTOR: Final = 0x400C
"""Holds C9H; any other code there disables BREAK (POKE 16396,23)."""
BREAK_ON: Final = 0xC9
_JUMP = 0xC3
_RESTARTS = {0x4000: 0x1C96, 0x4003: 0x1D78, 0x4006: 0x1C90, 0x4009: 0x25D9}
"""Where the vectors of RST 8, 10H, 18H and 20H point (seen by PEEK)."""
_DISK_VECTOR = 0x400F
_INTERRUPT = 0x4012
_ENABLE = 0xFB
_WIDTH = 0x409D
_LAST_ZONE = 0x409E
USR_VECTOR: Final = 0x408E
USR_UNSET: Final = 0x1E4A
"""Where the vector points until a program sets it: the ROM's FC error."""
KEY_LATCH: Final = 0x4099
ERROR_CODE: Final = 0x409A
PRINTER_COLUMN: Final = 0x409B
OUTPUT_DEVICE: Final = 0x409C
PROGRAM_START: Final = 0x40A4
INPUT_POINTER: Final = 0x40A7
INPUT_BUFFER: Final = 0x41E5
"""The byte in front of the line buffer; a direct line is executed here."""
DEF_TABLE: Final = 0x4101
TRACE_FLAG: Final = 0x411B
SINGLE_TYPE: Final = 4
_DISK_WORDS, _DISK_EXITS, _DISK_END = 0x4152, 0x41A6, 0x41E5
"""Vectors of three bytes: a jump to ?L3 for each word of Disk BASIC, then returns."""
_NO_DISK: Final = 0x012D


def power_on(basic: Interpreter) -> None:
    """Set the variables that the ROM sets when the machine is switched on."""
    ram = basic.memory.ram
    for address, target in _RESTARTS.items():
        ram[address] = _JUMP
        _set_word(ram, address + 1, target)
    ram[BREAK_VECTOR] = ram[_DISK_VECTOR] = ram[_INTERRUPT + 1] = BREAK_ON
    ram[_INTERRUPT] = _ENABLE
    ram[_WIDTH], ram[_LAST_ZONE] = 64, 48
    _set_word(ram, USR_VECTOR, USR_UNSET)
    for address in range(_DISK_WORDS, _DISK_EXITS, 3):
        ram[address] = _JUMP
        _set_word(ram, address + 1, _NO_DISK)
    for address in range(_DISK_EXITS, _DISK_END, 3):
        ram[address] = BREAK_ON
    ram[OUTPUT_DEVICE] = 0
    ram[PRINTER_COLUMN] = 0
    ram[KEY_LATCH] = 0
    _set_word(ram, INPUT_POINTER, 0x41E8)
    _set_word(ram, PROGRAM_START, START)
    reset_types(ram)


def reset_types(ram: bytearray) -> None:
    """All names without suffix are single precision."""
    ram[DEF_TABLE : DEF_TABLE + 26] = bytes((SINGLE_TYPE,)) * 26


def _set_word(ram: bytearray, address: int, value: int) -> None:
    ram[address] = value & 0xFF
    ram[address + 1] = value >> 8


class SystemArea:
    """The addresses whose values the interpreter keeps for itself."""

    RANGE: Final = (0x4099, 0x411C)

    def __init__(self, basic: Interpreter) -> None:
        self._basic = basic

    def _words(self) -> dict[int, int]:
        """The words that are Python values, by address."""
        basic = self._basic
        control, strings, variables = basic.control, basic.strings, basic.variables
        execution = basic.execution()
        return {
            0x40A0: strings.bottom,
            0x40A2: 0xFFFF if execution is None else execution.line(basic),
            0x40AA: basic.seed & 0xFFFF,
            0x40B1: strings.top,
            0x40B3: 0x40B5 + 3 * len(strings.temporaries),
            0x40D6: strings.next,
            0x40DA: control.data_line,
            0x40E6: control.error_address if execution is None else execution.statement,
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
        basic = self._basic
        if address == 0x40AC:
            return basic.seed >> 16
        if address == ERROR_CODE:
            return basic.control.error
        if address == 0x40F2:
            return 0xFF if basic.control.handling else 0
        if address == TRACE_FLAG:
            return 0xAF if basic.control.traced else 0
        words = self._words()
        if address in words:
            return words[address] & 0xFF
        if address - 1 in words:
            return words[address - 1] >> 8
        return basic.memory.ram[address]

    def poke(self, address: int, value: int) -> None:
        """Change a byte; what cannot be a Python value's byte only changes RAM."""
        basic = self._basic
        basic.memory.ram[address] = value
        if 0x40AA <= address <= 0x40AC:
            shift = 8 * (address - 0x40AA)
            basic.seed = basic.seed & ~(0xFF << shift) | value << shift
        elif address == ERROR_CODE:
            basic.control.error = value
        elif address == 0x40F2:
            basic.control.handling = bool(value)
        elif address == TRACE_FLAG:
            basic.control.traced = bool(value)
            basic.code.look_around()
        elif DEF_TABLE <= address < DEF_TABLE + 26:
            basic.code.look_around()
        elif PROGRAM_START <= address <= PROGRAM_START + 1:
            basic.program.changed()
            basic.code.look_around()
        else:
            self._poke_word(address, value)

    def _poke_word(self, address: int, value: int) -> None:
        basic = self._basic
        control, strings = basic.control, basic.strings
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

    def __init__(self, basic: Interpreter) -> None:
        self._variables = basic.variables
        self._ram = basic.memory.ram
        self._basic = basic

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
        self._ram[address] = value
        if address < variables.start:
            self._basic.program.changed()
            self._basic.code.look_around()
