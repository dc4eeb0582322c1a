"""The variables: Python values for the compiled program, and the picture of them that memory shows.

A simple variable is a cell that the compiled statements share; an array is a list. Both keep the
place they have in the machine's tables behind the program (simple variables in the order of their
creation, then the arrays), so VARPTR, PEEK, POKE, MEM and the search times come out as on the ROM
(Level II facts, Statements, VARPTR; cases `memory-varptr-*`).
"""

from __future__ import annotations

from collections import Counter
from types import CellType
from typing import Any

from trs80arm.basic import costs
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.kinds import DOUBLE, INTEGER, SINGLE, SIZES, STRING, Kind
from trs80arm.basic.numbers import double, single

SCALAR_HEADER = 3
"""Type and two characters of the name before the value of a simple variable."""
_MAX_BYTES = 0x10000

Key = tuple[str, Kind]
"""Name of one or two characters, and the kind."""
Descriptor = list[int]
"""A string in memory: length and address, changed in place when the string moves."""


NO_STRING = (0, 0x4552)
"""The descriptor that the ROM has for the empty string of a variable that does not exist."""


def zero(kind: Kind) -> Any:
    """The value of a variable that does not exist."""
    if kind == STRING:
        return list(NO_STRING)
    if kind == DOUBLE:
        return double.ZERO
    return 0 if kind == INTEGER else 0.0


def is_value(kind: Kind, value: Any) -> bool:
    """Whether a value is one that a variable of that kind can hold."""
    if kind == INTEGER:
        return type(value) is int and -0x8000 <= value <= 0x7FFF
    if kind == SINGLE:
        return type(value) is float and single.unpack(single.pack(value)) == value
    if kind == DOUBLE:
        return isinstance(value, double.Double)
    return (
        isinstance(value, list)
        and list(map(type, value)) == [int, int]
        and 0 <= value[0] <= 0xFF
        and 0 <= value[1] <= 0xFFFF
    )


def encode(kind: Kind, value: Any) -> bytes:
    """The bytes of a value in memory, low byte first."""
    if kind == INTEGER:
        return int(value & 0xFFFF).to_bytes(2, "little")
    if kind == SINGLE:
        return single.pack(value)
    if kind == DOUBLE:
        return double.pack(value)
    # An empty string above all memory is at the address behind FFFFH.
    return bytes((value[0], value[1] & 0xFF, value[1] >> 8 & 0xFF))


def decode(kind: Kind, data: bytes) -> Any:
    """The value that bytes in memory stand for."""
    if kind == INTEGER:
        return int.from_bytes(data, "little", signed=True)
    if kind == SINGLE:
        return single.unpack(data)
    if kind == DOUBLE:
        return double.unpack(data)
    return [data[0], data[1] | data[2] << 8]


class Scalar:
    """A simple variable.

    Attributes:
        name: one or two characters.
        kind: its type.
        cell: holds the value; the compiled statements close over it.
        offset: of its header from the start of the table, None while it does not exist.
    """

    __slots__ = ("cell", "cost", "kind", "name", "offset")

    name: str
    kind: Kind
    cell: CellType
    offset: int | None
    cost: int

    def __init__(self, name: str, kind: Kind) -> None:
        self.name = name
        self.kind = kind
        self.cell = CellType(zero(kind))
        self.offset = None
        self.cost = 0

    def __getstate__(self) -> tuple[Any, ...]:
        return self.name, self.kind, self.cell.cell_contents, self.offset, self.cost

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        self.name, self.kind, value, self.offset, self.cost = state
        self.cell = CellType(value)

    @property
    def value(self) -> Any:
        """What it holds: `int`, `float`, `Double` or a descriptor."""
        return self.cell.cell_contents

    @property
    def size(self) -> int:
        """Bytes in the table, header included."""
        return SCALAR_HEADER + SIZES[self.kind]


class Array:
    """An array.

    Attributes:
        dims: how many elements in each dimension (the largest subscript plus one).
        data: the elements, the first subscript running fastest.
    """

    __slots__ = ("cost", "data", "dims", "kind", "name", "offset")

    name: str
    kind: Kind
    dims: tuple[int, ...]
    data: list[Any]
    offset: int
    cost: int

    def __init__(self, name: str, kind: Kind, dims: tuple[int, ...], offset: int) -> None:
        self.name = name
        self.kind = kind
        self.dims = dims
        count = 1
        for dim in dims:
            count *= dim
        self.data = [[0, 0] for _ in range(count)] if kind == STRING else [zero(kind)] * count
        self.offset = offset
        self.cost = 0

    @property
    def header(self) -> bytes:
        """Type, name, distance to the next array, number of dimensions, dimensions last first."""
        name = self.name.encode("ascii")
        rest = 1 + 2 * len(self.dims) + len(self.data) * SIZES[self.kind]
        out = bytes((SIZES[self.kind], name[1] if len(name) > 1 else 0, name[0]))
        out += (rest & 0xFFFF).to_bytes(2, "little") + bytes((len(self.dims),))
        for dim in reversed(self.dims):
            out += dim.to_bytes(2, "little")
        return out

    @property
    def size(self) -> int:
        """Bytes in the table, header included."""
        return array_size(self.kind, self.dims)


def array_size(kind: Kind, dims: tuple[int, ...]) -> int:
    """The bytes that an array takes, header included; BS when its elements pass 64K."""
    count = SIZES[kind]
    for dim in dims:
        count *= dim
        if count >= _MAX_BYTES:
            raise BasicError(Code.BS)
    return count + 6 + 2 * len(dims)


class Variables:
    """Both tables.

    Attributes:
        start: the address of the first simple variable (the pointer at 40F9H).
        scalars: every simple variable that was ever named, whether it exists or not.
        order: the simple variables that exist, in the order of their creation.
        arrays: the arrays in the order of their creation.
        size: bytes of the simple variables.
        arrays_size: bytes of the arrays.
    """

    def __init__(self) -> None:
        self.start = 0
        self.scalars: dict[Key, Scalar] = {}
        self.order: list[Scalar] = []
        self._of_kind: dict[Kind, int] | None = None
        self.arrays: dict[Key, Array] = {}
        self.size = 0
        self.arrays_size = 0
        self._zeros: dict[tuple[Key, int], bytes] = {}

    def __getstate__(self) -> dict[str, Any]:
        # Names that were compiled and never given a value say nothing about the machine.
        named = {(each.name, each.kind): each for each in self.order}
        return self.__dict__ | {"scalars": named, "_of_kind": None}

    def _counts(self) -> dict[Kind, int]:
        """How many of the simple variables that exist are of each kind."""
        if self._of_kind is None:
            counted = Counter(scalar.kind for scalar in self.order)
            self._of_kind = {kind: counted[kind] for kind in SIZES}
        return self._of_kind

    def count(self, kind: Kind) -> int:
        """How many simple variables of a kind exist."""
        return self._counts()[kind]

    def clear(self, start: int) -> None:
        """Forget all of them; the tables begin at `start`."""
        self.start = start
        for scalar in self.order:
            scalar.offset = None
            if scalar.kind == STRING:
                scalar.value[:] = NO_STRING
            else:
                scalar.cell.cell_contents = zero(scalar.kind)
        self.order.clear()
        self._of_kind = None
        self.arrays.clear()
        self._zeros.clear()
        self.size = 0
        self.arrays_size = 0

    @property
    def arrays_start(self) -> int:
        """The address of the first array (40FBH)."""
        return self.start + self.size

    @property
    def end(self) -> int:
        """The first address behind the arrays (40FDH)."""
        return self.start + self.size + self.arrays_size

    def scalar(self, key: Key) -> Scalar:
        """The variable of a name and kind, whether it exists or not."""
        found = self.scalars.get(key)
        if found is None:
            found = self.scalars[key] = Scalar(*key)
        return found

    def create(self, scalar: Scalar) -> None:
        """Put a variable at the end of the table; the arrays move up."""
        scalar.cost = self.missing_cost(scalar)
        scalar.offset = self.size
        self.size += scalar.size
        counts = self._counts()
        self.order.append(scalar)
        counts[scalar.kind] += 1
        if scalar.kind == STRING:
            scalar.value[:] = (0, 0)

    def missing_cost(self, wanted: Scalar) -> int:
        """T-states to look through the whole table for a variable that is not in it."""
        same = self._counts()[wanted.kind]
        others = len(self.order) - same
        return costs.SCALAR_OTHER_NAME * same + costs.SCALAR_OTHER_KIND * others

    def search_cost(self, scalar: Scalar) -> int:
        """T-states that the ROM needs to pass the variables in front of this one."""
        return self.missing_cost(scalar) if scalar.offset is None else scalar.cost

    def add_array(self, key: Key, dims: tuple[int, ...]) -> Array:
        """Make an array; whether there is room is the caller's business."""
        array = Array(*key, dims, self.arrays_size)
        array.cost = costs.ARRAY_OTHER * len(self.arrays)
        self.arrays[key] = array
        self.arrays_size += array.size
        return array

    def address(self, scalar: Scalar) -> int:
        """The address of a simple variable's value; FC while it does not exist (VARPTR)."""
        if scalar.offset is None:
            raise BasicError(Code.FC)
        return self.start + scalar.offset + SCALAR_HEADER

    def element_address(self, array: Array, index: int) -> int:
        """The address of an element's value."""
        header = 6 + 2 * len(array.dims)
        return self.arrays_start + array.offset + header + index * SIZES[array.kind]

    # -- what PEEK and POKE see ---------------------------------------------------------------

    def _find(self, address: int) -> tuple[Scalar | Array, int] | None:
        place = address - self.start
        if place < self.size:
            for scalar in self.order:
                offset = scalar.offset or 0
                if offset <= place < offset + scalar.size:
                    return scalar, place - offset
        place -= self.size
        for array in self.arrays.values():
            if array.offset <= place < array.offset + array.size:
                return array, place - array.offset
        return None

    def peek(self, address: int) -> int:
        """The byte of the tables at an address between `start` and `end`."""
        found = self._find(address)
        if found is None:
            return 0
        owner, place = found
        if isinstance(owner, Scalar):
            if place >= SCALAR_HEADER:
                return self._bytes(owner, -1, owner.value)[place - SCALAR_HEADER]
            name = owner.name.encode("ascii")
            return (SIZES[owner.kind], name[1] if len(name) > 1 else 0, name[0])[place]
        header = owner.header
        if place < len(header):
            return header[place]
        index, byte = divmod(place - len(header), SIZES[owner.kind])
        return self._bytes(owner, index, owner.data[index])[byte]

    def poke(self, address: int, value: int) -> None:
        """Change a byte of a variable's value; names and dimensions cannot be changed this way."""
        found = self._find(address)
        if found is None:
            return
        owner, place = found
        if isinstance(owner, Scalar):
            byte = place - SCALAR_HEADER
            if byte >= 0:
                new = self._with_byte(owner, -1, owner.value, byte, value)
                if owner.kind == STRING:
                    owner.value[:] = new
                else:
                    owner.cell.cell_contents = new
            return
        header = len(owner.header)
        if place >= header:
            index, byte = divmod(place - header, SIZES[owner.kind])
            new = self._with_byte(owner, index, owner.data[index], byte, value)
            if owner.kind == STRING:
                owner.data[index][:] = new
            else:
                owner.data[index] = new

    def _bytes(self, owner: Scalar | Array, index: int, value: Any) -> bytes:
        """The bytes of a value; a zero that was POKEd keeps what stands beside its exponent."""
        data = encode(owner.kind, value)
        if owner.kind in (SINGLE, DOUBLE) and not data[-1]:
            return self._zeros.get(((owner.name, owner.kind), index), data)
        return data

    def _with_byte(self, owner: Scalar | Array, index: int, old: Any, byte: int, new: int) -> Any:
        data = bytearray(self._bytes(owner, index, old))
        data[byte] = new
        if owner.kind in (SINGLE, DOUBLE) and not data[-1]:
            self._zeros[(owner.name, owner.kind), index] = bytes(data)
        return decode(owner.kind, bytes(data))
