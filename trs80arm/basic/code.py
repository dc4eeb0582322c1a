"""The compiled program: statement functions by the address of the separator in front of them.

The statement loop asks for `code[address]` and calls it. A statement is compiled when it is reached
for the first time, so an error in the text shows where and when the ROM would find it. Compiled
statements are kept while the text stays the same, and used again as long as what they assumed about
the variables holds (`compiler.scope`).
"""

from __future__ import annotations

from collections.abc import Callable
from types import CellType, FunctionType
from typing import TYPE_CHECKING, Any, NamedTuple

from trs80arm.basic import costs, system_area
from trs80arm.basic.compiler.emitter import Emitter, Mark
from trs80arm.basic.compiler.reader import Reader
from trs80arm.basic.compiler.scope import Assumptions, Scope
from trs80arm.basic.compiler.statements import StatementCompiler
from trs80arm.basic.control import DIRECT, ForFrame
from trs80arm.basic.errors import Code
from trs80arm.basic.variables import Key

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter

Function = Callable[[], int]
_COLON = 0x3A
_VARIANTS = 4
"""Compiled forms of one statement that are kept for different pictures of the variables."""


class Compiled(NamedTuple):
    """One function, and what it takes for granted."""

    function: FunctionType
    assumptions: Assumptions
    marks: list[Mark]
    first_line: int


class CompiledCode(dict[int, Function]):
    """Address to function; what is missing is compiled when it is asked for.

    Attributes:
        stale: the text or the types of names changed under the running statement.
    """

    def __init__(self, basic: Interpreter) -> None:
        super().__init__()
        self._basic = basic
        self._environment: dict[str, Any] = basic.runtime.environment()
        self._array_cells: dict[Key, CellType] = {}
        self._kept: dict[bytes, dict[int, list[Compiled]]] = {}
        self._version = basic.program.version
        self._fragile: list[int] = []
        self._current: dict[int, Compiled] = {}
        self.stale = False

    def __missing__(self, address: int) -> Function:
        compiled = self._find(address)
        self._current[address] = compiled
        if compiled.assumptions.fragile:
            self._fragile.append(address)
        function: Function = compiled.function
        self[address] = function
        return function

    # -- what makes compiled statements invalid -----------------------------------------------

    def look_around(self) -> None:
        """The text, the types of names or the mode changed: start afresh."""
        self.clear()
        self.stale = True

    def cleared(self) -> None:
        """The variables are gone."""
        self.clear()
        self._fragile.clear()

    def created(self) -> None:
        """A variable or an array was made: statements that missed something are looked at again."""
        for address in self._fragile:
            self.pop(address, None)
        self._fragile.clear()

    def forget_direct(self) -> None:
        """Another direct line stands in the buffer."""
        start, stop = system_area.INPUT_BUFFER, self._basic.program.start - 1
        for kept in self._kept.values():
            for address in [a for a in kept if start <= a < stop]:
                del kept[address]
        for address in [a for a in self if start <= a < stop]:
            del self[address]

    # -- compiling ----------------------------------------------------------------------------

    def _find(self, address: int) -> Compiled:
        basic = self._basic
        if self._version != basic.program.version:
            self._version = basic.program.version
            self._kept.clear()
        types = bytes(basic.memory.ram[system_area.DEF_TABLE : system_area.DEF_TABLE + 26])
        variants = self._kept.setdefault(types, {}).setdefault(address, [])
        for compiled in variants:
            if compiled.assumptions.hold(basic.variables):
                self._refresh_cells(compiled)
                return compiled
        compiled = self._compile(address, types)
        variants.append(compiled)
        del variants[:-_VARIANTS]
        return compiled

    def _refresh_cells(self, compiled: Compiled) -> None:
        """Arrays made anew have new lists."""
        for key, dims, _ in compiled.assumptions.arrays:
            if dims is not None and key in self._array_cells:
                self._array_cells[key].cell_contents = self._basic.variables.arrays[key].data

    def _compile(self, address: int, types: bytes) -> Compiled:
        basic = self._basic
        out = Emitter()
        scope = Scope(basic.variables, self._array_cells, self._environment, types)
        out.statement = address
        self._statement(address, out, scope)
        function, first_line = out.build(self._environment)
        return Compiled(function, scope.assumptions(), out.marks, first_line)

    def _statement(self, address: int, out: Emitter, scope: Scope) -> None:
        """Write the statement behind a separator."""
        basic = self._basic
        ram = basic.memory.ram
        program = basic.program
        direct = address < program.start - 1
        start = address + 1
        line = DIRECT
        if ram[address] == 0:
            if direct or not (ram[start] or ram[start + 1]):
                out.emit(f"end_of_text({address})")
                return
            start += 4
            line = ram[address + 3] | ram[address + 4] << 8
            out.cost += costs.NEW_LINE
        elif ram[address] != _COLON:
            out.cost += costs.STATEMENT
            out.fail(Code.SN)
            return
        elif not direct:
            link = program.line_at(address)
            line = 0 if link is None else program.number_at(link)
        reader = Reader(bytes(ram[start : ram.index(0, start)]), start, out)
        reader.skip()
        top = basic.control.frames[-1]
        innermost = None
        if isinstance(top, ForFrame):
            innermost = top.scalar.name, top.scalar.kind
        StatementCompiler(reader, out, scope, program, line, innermost, basic.armbasic).compile()

    def find_target(self, address: int) -> tuple[Any, int]:
        """The variable whose name stands at an address (INPUT's list), and what stands behind it.

        It is made if it is not there, subscripts are evaluated.
        """
        basic = self._basic
        ram = basic.memory.ram
        types = bytes(ram[system_area.DEF_TABLE : system_area.DEF_TABLE + 26])
        out = Emitter()
        scope = Scope(basic.variables, self._array_cells, self._environment, types)
        reader = Reader(bytes(ram[address : ram.index(0, address)]), address, out)
        compiler = StatementCompiler(
            reader, out, scope, basic.program, DIRECT, None, basic.armbasic
        )
        compiler.compile_target()
        function, _ = out.build(self._environment)
        return function(), reader.address

    # -- errors -------------------------------------------------------------------------------

    def failing_cost(self, address: int, error: BaseException) -> int:
        """T-states that a statement had come to when it raised an error."""
        compiled = self._current.get(address)
        traceback = error.__traceback__
        if compiled is None:
            return 0
        code = compiled.function.__code__
        while traceback is not None:
            if traceback.tb_frame.f_code is code:
                index = traceback.tb_lineno - compiled.first_line - 1
                if 0 <= index < len(compiled.marks):
                    return compiled.marks[index].cost
                return 0
            traceback = traceback.tb_next
        return 0
