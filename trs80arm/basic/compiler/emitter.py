"""The Python text of one compiled function, line by line, and the function made of it.

A compiled statement is a function without arguments that does the statement's work and returns the
address of the next one. It shares the variables' cells with all other statements. What a statement
costs is added to the clock where it leaves; the emitter knows for every line how much had come
together by then, so that a statement that fails is charged for what it has done.
"""

from __future__ import annotations

from types import CellType, CodeType, FunctionType
from typing import Any, NamedTuple

from trs80arm.basic.errors import Code

LOOP_BODY = "f.body"
"""Where NEXT goes back to, in generated text."""


class Mark(NamedTuple):
    """What is known of a line of generated text.

    Attributes:
        statement: the address of the statement that it belongs to.
        cost: T-states not yet charged when it runs.
    """

    statement: int
    cost: int


class Emitter:
    """Collects the body of one function.

    Attributes:
        cost: T-states that came together since the clock was last charged.
        most_cost: the most that came together on one way through the function.
        statement: the address of the statement whose text is being written.
    """

    def __init__(self) -> None:
        self.cost = 0
        self.statement = 0
        self.lines: list[str] = []
        self.marks: list[Mark] = []
        self.indent = 1
        self.cells: dict[str, CellType] = {}
        self.stored: set[str] = set()
        self._temporaries = 0
        self._leader: int | None = None
        self.most_cost = 0
        self._charged = 0

    def lead(self, address: int) -> None:
        """The function begins a block: a jump to its own start goes round inside it."""
        self._leader = address
        self.emit("while True:")
        self.indent += 1

    def emit(self, text: str) -> None:
        """Add a line."""
        self.lines.append("  " * self.indent + text)
        self.marks.append(Mark(self.statement, self.cost))

    def charge(self) -> None:
        """Write what has come together to the clock."""
        if self.cost:
            cost, self.cost = self.cost, 0
            self._charged += cost
            self.emit(f"clock.now += {cost}")

    def allow(self, most: int) -> None:
        """Reckon with T-states that a call will charge by itself, at most so many."""
        self._charged += most

    def note_cost(self) -> None:
        """One way through the function ends here."""
        self.most_cost = max(self.most_cost, self._charged + self.cost)

    def go(self, address: int | str) -> None:
        """Leave the function for the statement at an address."""
        self.note_cost()
        if self.cost:
            self.emit(f"clock.now += {self.cost}")
        if self._leader is not None:
            if address == self._leader:
                self.emit("if clock.now < pace.soft: continue")
            elif address == LOOP_BODY:
                self.emit(f"if {LOOP_BODY} == {self._leader} and clock.now < pace.soft: continue")
        self.emit(f"return {address}")

    def fail(self, code: Code) -> None:
        """Raise a Level II error."""
        self.emit(f"fail({int(code)})")

    def temporary(self) -> str:
        """A new local name."""
        self._temporaries += 1
        return f"t{self._temporaries}"

    def keep(self, text: str) -> str:
        """Evaluate an expression now; the local name that holds its value."""
        name = self.temporary()
        self.emit(f"{name} = {text}")
        return name

    def cell(self, name: str, cell: CellType, stored: bool = False) -> str:
        """Use a shared cell under a name."""
        self.cells[name] = cell
        if stored:
            self.stored.add(name)
        return name

    def source(self) -> str:
        """The Python text of the function, inside one that declares its cells."""
        names = list(self.cells)
        out = ["def cells():"]
        if names:
            out.append(f" {' = '.join(names)} = None")
        out.append(" def statement():")
        if self.stored:
            out.append(f"  nonlocal {', '.join(sorted(self.stored))}")
        return "\n".join([*out, *self.lines, " return statement\n"])

    @property
    def _first_line(self) -> int:
        """The number of lines of `source` in front of the emitted ones."""
        return 2 + bool(self.cells) + bool(self.stored)

    def build(self, environment: dict[str, Any]) -> tuple[FunctionType, int]:
        """The function, and the number of its text lines in front of the first emitted one."""
        try:
            module = compile(self.source(), "<statement>", "exec")
        except (SyntaxError, RecursionError, MemoryError):
            # Nested more deeply than Python can read: out of memory here as well.
            del self.lines[:], self.marks[:]
            self.indent = 1
            self.fail(Code.OM)
            module = compile(self.source(), "<statement>", "exec")
        code = _inner(_inner(module, "cells"), "statement")
        closure = tuple(self.cells[name] for name in code.co_freevars)
        return FunctionType(code, environment, "statement", None, closure), self._first_line


def _inner(code: CodeType, name: str) -> CodeType:
    for constant in code.co_consts:
        if isinstance(constant, CodeType) and constant.co_name == name:
            return constant
    raise LookupError(name)
