"""What a compiled statement takes for granted about the variables, and whether it still holds.

The text of a compiled statement depends on which variables exist, where they stand in the tables
(the time to find them) and how large arrays are. The scope notes each such assumption; before a
statement is used again after a CLEAR, or when something new was created, they are compared.
"""

from __future__ import annotations

from types import CellType
from typing import Any, NamedTuple

from trs80arm.basic import costs
from trs80arm.basic.characters import FIRST_LETTER
from trs80arm.basic.kinds import BY_SIZE, SINGLE, Kind
from trs80arm.basic.variables import Array, Key, Scalar, Variables


class Assumptions(NamedTuple):
    """What held when a statement was compiled.

    Attributes:
        scalars: variables with the time to find them, and whether they existed.
        arrays: keys of arrays with their dimensions (None: not there) and the time to find them.
        fragile: something was missing, so that every creation may change the picture.
    """

    scalars: tuple[tuple[Scalar, bool, int], ...]
    arrays: tuple[tuple[Key, tuple[int, ...] | None, int], ...]
    fragile: bool

    def hold(self, variables: Variables) -> bool:
        """Whether everything is still so."""
        for scalar, exists, cost in self.scalars:
            if (scalar.offset is not None) != exists or variables.search_cost(scalar) != cost:
                return False
        for key, dims, cost in self.arrays:
            array = variables.arrays.get(key)
            if (None if array is None else array.dims) != dims:
                return False
            if cost != _search(variables, key):
                return False
        return True


def _search(variables: Variables, key: Key) -> int:
    array = variables.arrays.get(key)
    return len(variables.arrays) * costs.ARRAY_OTHER if array is None else array.cost


class Scope:
    """The variables as one compiled function sees them.

    Attributes:
        tight: whether expressions must look for room on the stack.
    """

    def __init__(
        self,
        variables: Variables,
        cells: dict[Key, CellType],
        types: bytes,
        tight: bool = False,
    ) -> None:
        self.tight = tight
        self._variables = variables
        self._cells = cells
        self._types = types
        self._scalars: dict[Key, tuple[Scalar, bool, int]] = {}
        self._arrays: dict[Key, tuple[Key, tuple[int, ...] | None, int]] = {}

    def assumptions(self) -> Assumptions:
        """Everything that was asked for."""
        scalars, arrays = tuple(self._scalars.values()), tuple(self._arrays.values())
        fragile = any(not exists for _, exists, _ in scalars) or any(a[1] is None for a in arrays)
        return Assumptions(scalars, arrays, fragile)

    def state(self) -> tuple[Any, ...]:
        """What `restore` needs to forget what will be asked for."""
        return dict(self._scalars), dict(self._arrays)

    def restore(self, state: tuple[Any, ...]) -> None:
        """Forget what was asked for since."""
        self._scalars, self._arrays = state

    def default_kind(self, letter: int) -> Kind:
        """The kind of a name without suffix, by its first letter (DEFINT and so on)."""
        return BY_SIZE.get(self._types[letter - FIRST_LETTER], SINGLE)

    def scalar(self, key: Key) -> Scalar:
        """A simple variable."""
        scalar = self._variables.scalar(key)
        if key not in self._scalars:
            cost = self._variables.search_cost(scalar)
            self._scalars[key] = scalar, scalar.offset is not None, cost
        return scalar

    def exists(self, key: Key) -> bool:
        """Whether a simple variable has a place in the table."""
        self.scalar(key)
        return self._scalars[key][1]

    def search(self, scalar: Scalar) -> int:
        """T-states to find a simple variable."""
        return self._variables.search_cost(scalar)

    def object(self, key: Key) -> Scalar:
        """The variable itself, for the loops that it runs; nothing is assumed about it."""
        return self._variables.scalar(key)

    @staticmethod
    def cell_name(key: Key) -> str:
        """The Python name under which a statement knows a simple variable."""
        return f"v_{key[0]}_{key[1]}"

    @staticmethod
    def array_name(key: Key) -> str:
        """The Python name under which a statement knows an array."""
        return f"a_{key[0]}_{key[1]}"

    def array(self, key: Key, dimensions: int) -> Array | None:
        """The array of a name if it exists and has as many dimensions."""
        array = self._variables.arrays.get(key)
        dims = None if array is None else array.dims
        self._arrays[key] = key, dims, _search(self._variables, key)
        return array if array is not None and len(array.dims) == dimensions else None

    def array_search(self, key: Key) -> int:
        """T-states to find an array."""
        return _search(self._variables, key)

    def array_cell(self, key: Key) -> CellType:
        """The cell that holds the elements of an array that exists."""
        cell = self._cells.get(key)
        data = self._variables.arrays[key].data
        if cell is None:
            cell = self._cells[key] = CellType(data)
        else:
            cell.cell_contents = data
        return cell
