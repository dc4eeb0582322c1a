"""The compiler of one statement, and the parts that it has.

Every part knows some statements, or what can stand in them, and is given the draft and the parts
that it needs. Which part reads which word is said in the word's row in `words`.
"""

from __future__ import annotations

from collections.abc import Callable

from trs80arm.basic import costs, words
from trs80arm.basic.characters import AT
from trs80arm.basic.compiler.arm import ArmCompiler
from trs80arm.basic.compiler.assignments import AssignmentCompiler
from trs80arm.basic.compiler.commands import CommandCompiler
from trs80arm.basic.compiler.draft import Draft, Mistake
from trs80arm.basic.compiler.emitter import Emitter
from trs80arm.basic.compiler.expressions import ExpressionCompiler
from trs80arm.basic.compiler.flow import FlowCompiler
from trs80arm.basic.compiler.functions import FunctionCompiler
from trs80arm.basic.compiler.hardware import HardwareCompiler
from trs80arm.basic.compiler.output import OutputCompiler
from trs80arm.basic.compiler.reader import Reader
from trs80arm.basic.compiler.scope import Scope
from trs80arm.basic.compiler.tape import TapeCompiler
from trs80arm.basic.errors import Code
from trs80arm.basic.program import Program
from trs80arm.basic.variables import Key
from trs80arm.basic.words import Word

_LET = words.word("LET")


class StatementCompiler:
    """Compiles one statement.

    Args:
        reader: where it stands.
        out: the function that it becomes a part of.
        scope: the variables.
        program: to find lines.
        line: the number of its line, 65535 for a direct one.
        loops: the variables of the open loops, changed by FOR and NEXT.
        armbasic: whether ARMBASIC is loaded; without it `@` is ?SN.
    """

    def __init__(
        self,
        reader: Reader,
        out: Emitter,
        scope: Scope,
        program: Program,
        line: int,
        loops: list[Key],
        armbasic: bool,
    ) -> None:
        draft = self._draft = Draft(reader, out, scope)
        self._reader = reader
        self._out = out
        self._armbasic = armbasic
        expressions = ExpressionCompiler(draft)
        functions = expressions.functions = FunctionCompiler(draft, expressions)
        self.assignments = AssignmentCompiler(draft, expressions, line)
        self.flow = FlowCompiler(
            draft, expressions, self.assignments, self._statement, program, line, loops
        )
        self.hardware = HardwareCompiler(draft, expressions, functions)
        self.tape = TapeCompiler(draft, expressions, self.assignments)
        self.output = OutputCompiler(draft, expressions, self.tape)
        self.arm = ArmCompiler(draft, expressions, self.assignments)
        self.commands = CommandCompiler(draft)

    @property
    def plain(self) -> bool:
        """Whether the statement may stand anywhere in a block."""
        return self._draft.plain

    @property
    def observes(self) -> bool:
        """Whether the statement looks at the machine."""
        return self._draft.observes

    def compile(self) -> bool:
        """Write the statement at the reader; whether control goes on behind it."""
        draft = self._draft
        try:
            self._out.cost += costs.STATEMENT
            goes_on = self._reader.at_end or self._statement()
        except (Mistake, RecursionError) as mistake:
            draft.fail(mistake if isinstance(mistake, Mistake) else Mistake(Code.OM))
            goes_on = False
            draft.plain = False
        self._out.note_cost()
        return goes_on

    def compile_target(self) -> None:
        """Write a function that finds one variable and returns a reference to it."""
        try:
            reference = self.assignments.target().reference
        except Mistake as mistake:
            self._draft.fail(mistake)
            return
        self._out.charge()
        self._out.emit(f"return {reference}")

    def _statement(self) -> bool:
        """One statement, an IF's too; whether control goes on behind it."""
        code = self._reader.code
        if code == AT:
            self._draft.plain = False
            if not self._armbasic:
                raise Mistake(Code.SN)
            self.arm.statement()
            return True
        if code < words.FIRST:
            self.assignments.let(_LET)
            return True
        if code in words.DISK:
            raise Mistake(Code.L3)
        if code not in words.STATEMENTS:
            raise Mistake(Code.SN)
        word = words.BY_TOKEN[code]
        self._reader.advance()
        self._draft.plain &= word.plain
        self._draft.observes |= word.observes
        part, method = _PARSERS[code]
        return method(getattr(self, part), word) is not False


_PARTS = {
    "assignments": AssignmentCompiler,
    "commands": CommandCompiler,
    "flow": FlowCompiler,
    "hardware": HardwareCompiler,
    "output": OutputCompiler,
    "tape": TapeCompiler,
}


def _parser(token: int) -> tuple[str, Callable[[object, Word], bool | None]]:
    part, method = words.BY_TOKEN[token].parser.split(".")
    return part, getattr(_PARTS[part], method)


_PARSERS = {token: _parser(token) for token in words.STATEMENTS}
"""How each statement is read; a row that names no part or method fails here, at the start."""
