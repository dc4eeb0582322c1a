"""Variables and arrays at run time, where a cell or a list is not enough for a statement."""

from __future__ import annotations

from typing import Any

from trs80arm.basic import addresses, costs, room
from trs80arm.basic.characters import FIRST_LETTER
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.kinds import STRING, Kind
from trs80arm.basic.numbers import convert
from trs80arm.basic.runtime.part import Part
from trs80arm.basic.state import State
from trs80arm.basic.variables import Array, Key, Scalar, array_size

AUTOMATIC = 11
"""Elements in each dimension of an array that no DIM made."""
_LAST_ADDRESS = 0xFFFF
"""An array that would pass it is ?BS, however little memory there is."""


class Reference:
    """A variable or element found, to be assigned to (INPUT)."""

    def __init__(self, state: State, kind: Kind, owner: Scalar | list[Any], index: int) -> None:
        self._state = state
        self.kind = kind
        self._owner = owner
        self._index = index

    def assign(self, value: Any) -> None:
        """Give it a number of any type, or the bytes of a string; OV, OS."""
        owner = self._owner
        if self.kind == STRING:
            target = owner.value if isinstance(owner, Scalar) else owner[self._index]
            strings = self._state.strings
            strings.assign(target, strings.new(value), self._state.program.start)
        elif isinstance(owner, Scalar):
            owner.cell.cell_contents = convert.to_kind(self.kind, value)
        else:
            owner[self._index] = convert.to_kind(self.kind, value)


class Storage(Part):
    """Making and finding variables."""

    def free_memory(self, in_use: int) -> float:
        """MEM, a single, with so many bytes of the stack in use by the expression."""
        return float(self._state.room.free() - room.MEM_DEPTH - in_use)

    def free_after(self, _argument: object, in_use: int) -> float:
        """FRE of a number."""
        return self.free_memory(in_use)

    def create(self, key: Key) -> None:
        """Make a simple variable if it is not there; OM."""
        scalar = self._variables.scalar(key)
        if scalar.offset is None:
            self._state.need_room(scalar.size + room.VARIABLE)
            self._variables.create(scalar)
            self._clock.now += costs.NEW_SCALAR
            self._clock.now += costs.NEW_SCALAR_BYTE * self._variables.arrays_size
            self._state.engine.created()

    def _array(self, key: Key, dimensions: int) -> Array:
        array = self._variables.arrays.get(key)
        if array is None:
            return self._make(key, (AUTOMATIC,) * dimensions)
        if len(array.dims) != dimensions:
            raise BasicError(Code.BS)
        return array

    def _make(self, key: Key, dims: tuple[int, ...]) -> Array:
        size = array_size(key[1], dims)
        if self._variables.end + size > _LAST_ADDRESS:
            raise BasicError(Code.BS)
        self._state.need_room(size + room.ARRAY)
        array = self._variables.add_array(key, dims)
        self._clock.now += costs.NEW_ARRAY + costs.NEW_ARRAY_BYTE * size
        self._state.engine.created()
        return array

    def dimension(self, key: Key, *sizes: int) -> None:
        """DIM of an array; DD if it is there, BS, OM."""
        if key in self._variables.arrays:
            raise BasicError(Code.DD)
        self._make(key, tuple(size + 1 for size in sizes))

    def place(self, key: Key, *subscripts: int) -> tuple[list[Any], int]:
        """The elements of an array and the index of one of them; BS, OM."""
        array = self._array(key, len(subscripts))
        index = 0
        factor = 1
        for subscript, dim in zip(subscripts, array.dims, strict=True):
            if subscript >= dim:
                raise BasicError(Code.BS)
            index += subscript * factor
            factor *= dim
        return array.data, index

    def element(self, key: Key, *subscripts: int) -> Any:
        """The value of an element."""
        data, index = self.place(key, *subscripts)
        return data[index]

    def element_address(self, key: Key, *subscripts: int) -> int:
        """VARPTR of an element."""
        array = self._array(key, len(subscripts))
        _, index = self.place(key, *subscripts)
        return _signed(self._variables.element_address(array, index))

    def scalar_address(self, key: Key) -> int:
        """VARPTR of a simple variable; FC if it was never assigned."""
        return _signed(self._variables.address(self._variables.scalar(key)))

    def scalar_reference(self, key: Key) -> Reference:
        """A simple variable to assign to."""
        scalar = self._variables.scalar(key)
        return Reference(self._state, key[1], scalar, 0)

    def element_reference(self, key: Key, index: int) -> Reference:
        """An element to assign to."""
        return Reference(self._state, key[1], self._variables.arrays[key].data, index)

    def define(self, size: int, first: int, last: int) -> None:
        """DEFINT and so on for a range of letters."""
        start = addresses.TYPE_TABLE - FIRST_LETTER
        for letter in range(first, last + 1):
            self._ram[start + letter] = size
        self._state.engine.look_around()

    def clear_all(self) -> None:
        """CLEAR."""
        self._state.clear_all()

    def clear_strings(self, size: int) -> None:
        """CLEAR n; OM when it leaves no room."""
        if self._strings.top - size < self._state.program.end + room.CLEAR:
            raise BasicError(Code.OM)
        self._state.clear_all(size)


def _signed(address: int) -> int:
    return address - 0x10000 if address > 0x7FFF else address
