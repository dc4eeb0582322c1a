"""The variables of a program that a user's own ROM runs, read from where the ROM keeps them.

Simple variables from 40F9H on, arrays from 40FBH to 40FDH: a byte of type, two of name, then the
value; an array has its length, the number of its dimensions and their sizes in front of its
elements (Level II facts; the same layout that the language here keeps).
"""

from __future__ import annotations

from math import prod

from trs80arm.basic.addresses import PROGRAM_END, word
from trs80arm.basic.kinds import BY_SIZE, SIZES
from trs80arm.basic.state import State
from trs80arm.basic.variables import decode

_ARRAYS, _END = 0x40FB, 0x40FD
_HEAD = 3
_MOST_DIMENSIONS = 16


def read(state: State) -> None:
    """Give a state the variables that stand in its memory, as far as they make sense."""
    ram, top = state.memory.ram, state.memory.top
    place, arrays, end = (word(ram, pointer) for pointer in (PROGRAM_END, _ARRAYS, _END))
    if not 0x4000 < place <= arrays <= end <= top:
        return
    variables = state.variables
    variables.clear(place)
    while place + _HEAD < arrays:
        kind = BY_SIZE.get(ram[place])
        if kind is None:
            return
        scalar = variables.scalar((_name(ram[place + 2], ram[place + 1]), kind))
        variables.create(scalar)
        data = bytes(ram[place + _HEAD : place + _HEAD + SIZES[kind]])
        scalar.cell.cell_contents = decode(kind, data)
        place += _HEAD + SIZES[kind]
    place = arrays
    while place + _HEAD + 3 < end:
        kind = BY_SIZE.get(ram[place])
        count = ram[place + 5]
        first = place + 6 + 2 * count
        if kind is None or not 0 < count <= _MOST_DIMENSIONS or first > end:
            return
        # The last dimension stands first.
        dims = tuple(word(ram, place + 6 + 2 * index) for index in reversed(range(count)))
        size = SIZES[kind]
        if first + prod(dims) * size > end:
            return
        array = variables.add_array((_name(ram[place + 2], ram[place + 1]), kind), dims)
        array.data[:] = [
            decode(kind, bytes(ram[at : at + size]))
            for at in range(first, first + prod(dims) * size, size)
        ]
        place += 5 + word(ram, place + 3)


def _name(first: int, second: int) -> str:
    return chr(first) + (chr(second) if second else "")
