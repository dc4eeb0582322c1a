"""Functions by the address of the separator in front of their statement, and what they are kept by.

A function is used again as long as what it assumed about the variables holds (`compiler.scope`),
and goes with its text when the program is edited (`compiler.relocation`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from types import FrameType, FunctionType
from typing import Final, Protocol

from trs80arm.basic.compiler.emitter import Mark
from trs80arm.basic.compiler.relocation import Location, Relocatable
from trs80arm.basic.compiler.scope import Assumptions
from trs80arm.basic.program import Change, Program
from trs80arm.basic.variables import Variables

_VARIANTS: Final = 4
"""Compiled forms of one statement that are kept for different pictures of the variables."""

Function = Callable[[], int]


class Compiled:
    """One function, where it stands, and what it takes for granted.

    Args:
        relocatable: the function.
        location: where it stands.
        assumptions: what it takes for granted about variables.
        marks: what is known of each line of its text.
        calls_code: whether it may call machine code.
    """

    __slots__ = ("_function", "assumptions", "calls_code", "location", "marks", "relocatable")

    def __init__(
        self,
        relocatable: Relocatable,
        location: Location,
        assumptions: Assumptions,
        marks: list[Mark],
        calls_code: bool,
    ) -> None:
        self.relocatable = relocatable
        self.location = location
        self.assumptions = assumptions
        self.marks = marks
        self.calls_code = calls_code
        self._function: FunctionType | None = None

    @property
    def start(self) -> int:
        """The address of the separator in front of it."""
        return self.location.addresses[0]

    @property
    def function(self) -> FunctionType:
        """The function itself, made when it is asked for first."""
        if self._function is None:
            self._function = self.relocatable.at(self.location.addresses)
        return self._function

    def after(self, changes: Sequence[Change], program: Program) -> Compiled | None:
        """The function when the program was changed, None if it is another one."""
        location = self.location.after(changes, program)
        if location is None or location is self.location:
            return location and self
        return Compiled(self.relocatable, location, self.assumptions, self.marks, self.calls_code)


class Owner(Protocol):
    """Whose table it is (`CompiledCode`)."""

    variables: Variables

    def check_version(self) -> None:
        """Have tables follow the program's changes."""

    def types(self) -> bytes:
        """The types of names, by which compiled statements are kept."""

    def refresh_cells(self, assumptions: Assumptions) -> None:
        """Have functions see arrays that were made anew."""

    def call_code(self, address: int, function: Function) -> int:
        """Execute a statement that may call machine code."""


class Table(dict[int, Function]):
    """Address to function; `compile_` makes what is missing.

    Attributes:
        current: the compiled form behind each function in use.
    """

    def __init__(self, owner: Owner, compile_: Callable[[int, bytes], Compiled]) -> None:
        super().__init__()
        self._owner = owner
        self._compile = compile_
        self._kept: dict[bytes, dict[int, list[Compiled]]] = {}
        self._fragile: list[int] = []
        self.current: dict[int, Compiled] = {}

    def __missing__(self, address: int) -> Function:
        compiled = self._find(address)
        self.current[address] = compiled
        if compiled.assumptions.fragile:
            self._fragile.append(address)
        function: Function = compiled.function
        if compiled.calls_code:
            function = partial(self._owner.call_code, address, function)
        self[address] = function
        return function

    def _find(self, address: int) -> Compiled:
        owner = self._owner
        owner.check_version()
        types = owner.types()
        variants = self._kept.setdefault(types, {}).setdefault(address, [])
        for compiled in variants:
            if compiled.assumptions.hold(owner.variables):
                owner.refresh_cells(compiled.assumptions)
                return compiled
        compiled = self._compile(address, types)
        variants.append(compiled)
        del variants[:-_VARIANTS]
        return compiled

    def follow(self, changes: Sequence[Change], program: Program) -> None:
        """The program was changed: keep what holds, where it stands now."""
        self.cleared()
        self.current.clear()
        for types, kept in self._kept.items():
            moved: dict[int, list[Compiled]] = {}
            for variants in kept.values():
                for compiled in variants:
                    found = compiled.after(changes, program)
                    if found is not None:
                        moved.setdefault(found.start, []).append(found)
            self._kept[types] = moved

    def cleared(self) -> None:
        """The variables are gone."""
        self.clear()
        self._fragile.clear()

    def created(self) -> None:
        """Something was made: statements that missed something are looked at again."""
        for address in self._fragile:
            self.pop(address, None)
        self._fragile.clear()

    def forget(self, start: int, stop: int) -> None:
        """Drop everything compiled from an address range."""
        for kept in self._kept.values():
            for address in [a for a in kept if start <= a < stop]:
                del kept[address]
        for address in [a for a in self if start <= a < stop]:
            del self[address]

    def failed(self, address: int, error: BaseException) -> tuple[int, int]:
        """The statement in which an error was raised, and what it had cost by then."""
        compiled = self.current.get(address)
        traceback = error.__traceback__
        if compiled is not None:
            code = compiled.function.__code__
            while traceback is not None:
                if traceback.tb_frame.f_code is code:
                    index = traceback.tb_lineno - compiled.relocatable.first_line - 1
                    if 0 <= index < len(compiled.marks):
                        statement, cost = compiled.marks[index]
                        place = compiled.location.addresses[statement]
                        return place, cost + _counted(traceback.tb_frame)
                    break
                traceback = traceback.tb_next
        return address, 0


def _counted(frame: FrameType) -> int:
    """T-states that a block has counted and not told the clock."""
    names = frame.f_locals
    spent: int = names["given"] - names["spare"] if "given" in names else 0
    return spent
