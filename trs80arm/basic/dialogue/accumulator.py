"""The ROM's accumulator at 411DH to 4124H, with the type of what is in it at 40AFH.

Machine code finds USR's argument there and leaves its result there.
"""

from __future__ import annotations

from typing import Any, Final

from trs80arm.basic.addresses import set_word, word
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.kinds import BY_SIZE, DOUBLE, INTEGER, SINGLE, SIZES, STRING, Kind
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.numbers.double import Double
from trs80arm.basic.state import State
from trs80arm.basic.variables import SCALAR_HEADER, decode, encode

TYPE: Final = 0x40AF
_DOUBLE, _SINGLE = 0x411D, 0x4121
_TEMPORARY: Final = 0x40B5
"""Where a string that is no variable's has its length and address."""
_PLACES: Final = {INTEGER: _SINGLE, STRING: _SINGLE, SINGLE: _SINGLE, DOUBLE: _DOUBLE}


def kind_of(value: Any) -> Kind:
    """The type of a value of the machine."""
    if isinstance(value, int):
        return INTEGER
    if isinstance(value, float):
        return SINGLE
    return DOUBLE if isinstance(value, Double) else STRING


def put(state: State, value: Any) -> Kind:
    """Leave a value in the accumulator; its type."""
    ram = state.memory.ram
    kind = kind_of(value)
    if kind == STRING:
        set_word(ram, _SINGLE, _descriptor(state, value))
    else:
        data = encode(kind, value)
        place = _PLACES[kind]
        ram[place : place + len(data)] = data
    ram[TYPE] = SIZES[kind]
    return kind


def get(state: State) -> Any:
    """What is in the accumulator: a number, or the characters of a string."""
    ram, memory = state.memory.ram, state.memory
    kind = BY_SIZE.get(ram[TYPE])
    if kind is None:
        raise BasicError(Code.TM)
    if kind == STRING:
        place = word(ram, _SINGLE)
        length, low, high = (memory.peek(place + byte & 0xFFFF) for byte in range(3))
        return memory.read(low | high << 8, length)
    place = _PLACES[kind]
    return decode(kind, bytes(ram[place : place + SIZES[kind]]))


def number(state: State) -> Number:
    """The number in the accumulator; TM for a string."""
    value = get(state)
    if isinstance(value, bytes):
        raise BasicError(Code.TM)
    found: Number = value
    return found


def _descriptor(state: State, string: list[int]) -> int:
    """The address of a string's length and address: a variable's own, or a copy's."""
    variables = state.variables
    for scalar in variables.order:
        if scalar.kind == STRING and scalar.value is string and scalar.offset is not None:
            return variables.start + scalar.offset + SCALAR_HEADER
    ram = state.memory.ram
    ram[_TEMPORARY] = string[0] & 0xFF
    set_word(ram, _TEMPORARY + 1, string[1])
    return _TEMPORARY
