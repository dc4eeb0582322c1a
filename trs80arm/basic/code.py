"""The compiled program: functions by the address of the separator in front of their statement.

The statement loop asks a table for `table[address]` and calls it. What is missing is compiled when
it is reached for the first time, so an error in the text shows where and when the ROM would find
it. There are two tables: one function a statement, and one function a run of statements (`blocks`),
which is faster and gives the same results at the same times.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from types import CellType
from typing import Any, Final, NamedTuple

from trs80arm.basic import addresses, characters, costs, words
from trs80arm.basic.compiler.draft import Mistake
from trs80arm.basic.compiler.emitter import MARGIN, Emitter, Next, TooDeep
from trs80arm.basic.compiler.reader import Reader
from trs80arm.basic.compiler.scope import Assumptions, Scope
from trs80arm.basic.compiler.statements import StatementCompiler
from trs80arm.basic.control import DIRECT, ForFrame
from trs80arm.basic.engine import Place
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.execution import CodeCall, Leave
from trs80arm.basic.native.hot import Hot
from trs80arm.basic.runtime.again import recorded
from trs80arm.basic.runtime.environment import environment
from trs80arm.basic.state import State
from trs80arm.basic.table import Compiled, Function, Table
from trs80arm.basic.variables import Key

_LONGEST = 40
_MOST: Final = 2_000_000
"""Statements, and T-states, of a block at most."""
_STRETCH: Final = 2**29
"""T-states after which blocks are begun anew: what they count with stays a small number."""
_LOWEST = 0x4000
_NEXT: Final = bytes((words.TOKENS["NEXT"],))
_LINE_HEAD = 5
"""A line's final zero, link and number; where these do not fit there is no statement."""
_DEEPEST = 200_000
"""Calls in one another while an expression is compiled whose nesting takes all of 48K."""


class Written(NamedTuple):
    """What a statement turned out to be when it was written.

    Attributes:
        goes_on: where the next statement is if control goes on behind it, else None.
        plain: whether it may stand in a block.
        paced: whether it may take any time, so that the clock must be looked at behind it.
        observes: whether it looks at the machine, so that the clock must be right.
    """

    goes_on: int | None
    plain: bool
    paced: bool
    observes: bool


class Pace:
    """Until when blocks may be begun.

    Attributes:
        soft: the clock's limit less `MARGIN`.
    """

    __slots__ = ("soft",)

    def __init__(self) -> None:
        self.soft = 0


@contextmanager
def _deep() -> Iterator[None]:
    """Let the compiler go into itself as deeply as the Z-80's stack allows in the most memory."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, _DEEPEST))
    try:
        yield
    finally:
        sys.setrecursionlimit(before)


class CompiledCode:
    """Both tables.

    Attributes:
        statements: one function a statement.
        blocks: one function for a run of statements.
        pace: until when blocks may be begun.
        hot: who makes hot loops native, None where nobody does.
        environment: the names that compiled statements know; what a single one of them keeps
            for itself is among its cells.
        stale: the text or the types of names changed under the running statement.
    """

    def __init__(self, state: State) -> None:
        self._state = state
        self.variables = state.variables
        self.pace = Pace()
        self.environment: dict[str, Any] = {
            **environment(state),
            "pace": self.pace,
            "alone": self.step,
        }
        self._recorded: dict[str, Any] | None = None
        self._array_cells: dict[Key, CellType] = {}
        self._version = state.program.version
        self.statements = Table(self, self._compile_statement)
        self.blocks = Table(self, self._compile_block)
        self.hot = Hot(self.alone, self.types, state) if state.native else None
        self.stale = False

    # -- executing ----------------------------------------------------------------------------

    def run(self, place: Place) -> None:
        """Execute statements until the clock's limit; near it one by one (`Engine.run`)."""
        clock = self._state.clock
        pace = self.pace
        address = place.next
        table, hot = self.blocks, self.hot
        try:
            if self._state.blocks:
                end = clock.limit - MARGIN
                until = end if hot is None else hot.begin(end)
                while True:
                    while clock.now < until:
                        pace.soft = min(until, clock.now + _STRETCH)
                        while clock.now < pace.soft:
                            place.statement = address
                            address = table[address]()
                    if until == end or hot is None:
                        break
                    self.check_version()
                    address, until = hot.reach(address, end)
            table = self.statements
            while clock.now < clock.limit:
                place.statement = address
                address = table[address]()
        except (BasicError, Leave) as error:
            place.statement, cost = table.failed(address, error)
            clock.now += cost
            self._note(error, place.statement, cost)
            raise
        place.next = address

    def step(self, address: int) -> int:
        """Execute one statement (`Engine.step`)."""
        table = self.statements
        try:
            return table[address]()
        except (BasicError, Leave) as error:
            _, cost = table.failed(address, error)
            self._state.clock.now += cost
            self._note(error, address, cost)
            raise

    def _note(self, error: BasicError | Leave, statement: int, cost: int) -> None:
        """A statement that calls machine code is executed again, and charged once."""
        if isinstance(error, CodeCall):
            error.address = statement
            self._state.code_calls.pending = cost

    def call_code(self, address: int, function: Function) -> int:
        """Execute a statement that may call machine code, anew or again."""
        calls = self._state.code_calls
        calls.begin(address, self._state.clock.now)
        try:
            return function()
        finally:
            calls.end()

    # -- what makes compiled statements invalid -----------------------------------------------

    def look_around(self) -> None:
        """The text, the types of names or the mode changed: start afresh."""
        self.statements.clear()
        self.blocks.clear()
        if self.hot is not None:
            self.hot.look_around()
        self.stale = True

    def cleared(self) -> None:
        """The variables are gone."""
        self.statements.cleared()
        self.blocks.cleared()
        if self.hot is not None:
            self.hot.look_around()

    def created(self) -> None:
        """A variable or an array was made."""
        self.statements.created()
        self.blocks.created()
        if self.hot is not None:
            self.hot.look_around()

    def forget_direct(self) -> None:
        """Another direct line stands in the buffer."""
        start, stop = addresses.INPUT_BUFFER, self._state.program.start - 1
        self.statements.forget(start, stop)
        self.blocks.forget(start, stop)

    def check_version(self) -> None:
        """Forget what was compiled from another text."""
        program = self._state.program
        if self._version != program.version:
            changes = program.changes_since(self._version)
            self._version = program.version
            self.statements.follow(changes, program)
            self.blocks.follow(changes, program)
            if self.hot is not None:
                self.hot.forget_from(min(change.first for change in changes))

    def types(self) -> bytes:
        """The table of DEFINT and so on, by which compiled statements are kept.

        They are kept apart for a machine with hardly any memory left.
        """
        ram = self._state.memory.ram
        types = bytes(ram[addresses.TYPE_TABLE : addresses.TYPE_TABLE + addresses.LETTERS])
        return types + b"!" if self._state.room.tight else types

    def refresh_cells(self, assumptions: Assumptions) -> None:
        """Arrays made anew have new lists."""
        for key, dims, _ in assumptions.arrays:
            if dims is not None and key in self._array_cells:
                self._array_cells[key].cell_contents = self.variables.arrays[key].data

    # -- compiling ----------------------------------------------------------------------------

    def _scope(self, types: bytes) -> Scope:
        tight = self._state.room.tight
        return Scope(self.variables, self._array_cells, types, tight)

    def _compile_statement(self, address: int, types: bytes) -> Compiled:
        try:
            return self._compile_alone(address, types, Emitter())
        except TooDeep:
            with _deep():
                return self._compile_alone(address, types, Emitter(flat=True))

    def alone(self, address: int, loops: list[Key]) -> tuple[Emitter, Assumptions]:
        """The text of one statement, and what it takes for granted.

        Args:
            address: the separator in front of it.
            loops: the variables of the loops that are open there, changed by FOR and NEXT.

        Raises:
            TooDeep: it can only be written flat.
        """
        out = Emitter()
        scope = self._scope(self.types())
        goes_on = self._write(address, out, scope, loops).goes_on
        if goes_on is not None:
            out.go(goes_on)
        return out, scope.assumptions()

    def _compile_alone(self, address: int, types: bytes, out: Emitter) -> Compiled:
        scope = self._scope(types)
        goes_on = self._write(address, out, scope, self._loops()).goes_on
        if goes_on is not None:
            out.go(goes_on)
        return self._built(out, scope)

    def _compile_block(self, address: int, types: bytes) -> Compiled:
        """The statements from an address on, as far as they can be run in one go."""
        out = Emitter()
        out.lead(address, self._state.control.frames[-1])
        scope = self._scope(types)
        out.next_at = partial(self._next_at, scope)
        loops = self._loops()
        here: int | None = address
        seen: set[int] = set()
        paced = False
        while here is not None and here not in seen:
            before = out.state(), scope.state(), list(loops)
            if paced:
                out.look_at_clock(here)
            if seen:
                # No line has come between.
                out.depends_on(here, here + 1)
            try:
                found = self._write(here, out, scope, loops)
                if found.observes and seen:
                    # The clock must be right before it looks.
                    self._take_back(out, scope, loops, before)
                    out.charge()
                    out.emit(f"now_at({out.address(here)})")
                    found = self._write(here, out, scope, loops)
            except TooDeep:
                if not seen:
                    return self._compile_statement(address, types)
                self._take_back(out, scope, loops, before)
                break
            fragile = scope.assumptions().fragile
            solid = found.plain and not fragile and not out.calls_code
            if seen and (not solid or out.most_cost > _MOST or len(seen) == _LONGEST):
                asked = scope.state()
                self._take_back(out, scope, loops, before)
                out.calls_code = False
                if fragile:
                    # A longer block takes this one's place when what is missing has been made.
                    scope.restore(asked)
                break
            seen.add(here)
            if found.observes:
                # It may have been a POKE into a string.
                out.strings = {}
            here, out.followed = found.goes_on or out.followed, None
            paced = found.paced
            if not solid:
                break
        if out.calls_code:
            # It is executed again as a whole, so it stands alone.
            return self._compile_statement(address, types)
        if here is not None:
            out.leave_for(here)
        try:
            return self._built(out, scope)
        except TooDeep:
            # Statement by statement, each as flat as it must be.
            return self._compile_statement(address, types)

    @staticmethod
    def _take_back(out: Emitter, scope: Scope, loops: list[Key], before: tuple[Any, ...]) -> None:
        """Undo the writing of a statement."""
        written, asked, loops[:] = before
        out.restore(written)
        scope.restore(asked)

    def _built(self, out: Emitter, scope: Scope) -> Compiled:
        names = self.environment
        if out.calls_code:
            names = self._recorded = self._recorded or recorded(names, self._state)
        relocatable = out.build(names)
        return Compiled(relocatable, out.location(), scope.assumptions(), out.marks, out.calls_code)

    def _loops(self) -> list[Key]:
        """The variables of the open loops that NEXT can come to: those of this subroutine."""
        loops: list[Key] = []
        for frame in reversed(self._state.control.frames):
            if not isinstance(frame, ForFrame):
                break
            loops.append((frame.scalar.name, frame.scalar.kind))
        return loops[::-1]

    def _write(self, address: int, out: Emitter, scope: Scope, loops: list[Key]) -> Written:
        """Write the statement behind a separator."""
        state = self._state
        ram = state.memory.ram
        program = state.program
        out.begin(address)
        direct = address < program.start - 1
        start = address + 1
        line = DIRECT
        if not _LOWEST <= address < state.memory.top - _LINE_HEAD:
            out.depends_on(address, start)
            out.fail(Code.SN)
            return Written(None, False, False, False)
        # The separator in front of a line belongs to the line before it.
        text = address if ram[address] else start
        if ram[address] == 0:
            if direct or not (ram[start] or ram[start + 1]):
                out.depends_on(text, start + 1)
                out.emit(f"end_of_text({out.address(address)})")
                return Written(None, False, False, False)
            start += 4
            line = ram[address + 3] | ram[address + 4] << 8
            out.cost += costs.NEW_LINE
        elif ram[address] != characters.COLON:
            out.depends_on(address, start)
            out.cost += costs.STATEMENT
            out.fail(Code.SN)
            return Written(None, False, False, False)
        elif not direct:
            link = program.line_at(address)
            line = 0 if link is None else program.number_at(link)
        reader = Reader(program.text_from(start), start, out)
        out.depends_on(text, start + len(reader.text))
        reader.skip()
        compiler = StatementCompiler(reader, out, scope, program, line, loops, state.armbasic)
        goes_on = reader.address if compiler.compile() else None
        return Written(goes_on, compiler.plain, compiler.paced, compiler.observes)

    def _next_at(self, scope: Scope, address: int, loops: list[Key]) -> Next | None:
        """The NEXT, of one loop, that a line begins with; the line's address less one is given."""
        program = self._state.program
        text = program.text_from(address + _LINE_HEAD)
        if text[:1] != _NEXT or self._state.memory.ram[address]:
            return None
        out = Emitter()
        reader = Reader(text, address + _LINE_HEAD, out)
        reader.advance()
        key = None
        compiler = StatementCompiler(reader, out, scope, program, DIRECT, [], self._state.armbasic)
        if not reader.at_end:
            try:
                key = compiler.expressions.name()
            except Mistake:
                return None
            if not reader.at_end or not scope.exists(key):
                return None
        out = Emitter()
        self._write(address, out, scope, loops.copy())
        return Next(key, out.cost, out.reach)

    def find_target(self, address: int) -> tuple[Any, int]:
        """The variable whose name stands at an address (INPUT's list), and what stands behind it.

        It is made if it is not there, subscripts are evaluated.
        """
        try:
            return self._find_target(address, Emitter())
        except TooDeep:
            with _deep():
                return self._find_target(address, Emitter(flat=True))

    def _find_target(self, address: int, out: Emitter) -> tuple[Any, int]:
        state = self._state
        reader = Reader(state.program.text_from(address), address, out)
        compiler = StatementCompiler(
            reader, out, self._scope(self.types()), state.program, DIRECT, [], state.armbasic
        )
        compiler.compile_target()
        function = out.build(self.environment).at(out.location().addresses)
        return function(), reader.address
