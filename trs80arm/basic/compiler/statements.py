"""The compiler of one statement, and the parts that it has.

Every part knows some statements, or what can stand in them, and is given the draft and the parts
that it needs. Which part reads which word is said in the word's row in `words`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

from trs80arm.basic import costs, words
from trs80arm.basic.characters import AT
from trs80arm.basic.compiler.arm import ArmCompiler
from trs80arm.basic.compiler.assignments import AssignmentCompiler
from trs80arm.basic.compiler.commands import CommandCompiler
from trs80arm.basic.compiler.draft import Draft, Mistake
from trs80arm.basic.compiler.emitter import Emitter, TooDeep
from trs80arm.basic.compiler.expressions import ExpressionCompiler
from trs80arm.basic.compiler.flow import FlowCompiler
from trs80arm.basic.compiler.functions import FunctionCompiler
from trs80arm.basic.compiler.hardware import HardwareCompiler
from trs80arm.basic.compiler.loops import LoopCompiler
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
        self._draft = Draft(reader, out, scope)
        self._reader = reader
        self._out = out
        self._program = program
        self._line = line
        self._loops = loops
        self._armbasic = armbasic

    # -- the parts, each made when it is needed first -----------------------------------------

    @cached_property
    def functions(self) -> FunctionCompiler:
        """Who reads functions."""
        return FunctionCompiler(self._draft, self.expressions)

    @cached_property
    def expressions(self) -> ExpressionCompiler:
        """Who reads expressions; it leaves what begins with a word to `functions`."""
        return ExpressionCompiler(self._draft, lambda word: self.functions.operand(word))

    @cached_property
    def assignments(self) -> AssignmentCompiler:
        """LET, READ, INPUT and so on."""
        start = self._program.start
        return AssignmentCompiler(self._draft, self.expressions, self._line, start)

    @cached_property
    def flow(self) -> FlowCompiler:
        """GOTO, IF and so on."""
        return FlowCompiler(
            self._draft,
            self.expressions,
            self._statement,
            self._step,
            self._program,
            self._line,
        )

    @cached_property
    def loops(self) -> LoopCompiler:
        """FOR and NEXT."""
        return LoopCompiler(
            self._draft, self.expressions, self.assignments, self._line, self._loops
        )

    @cached_property
    def hardware(self) -> HardwareCompiler:
        """POKE, SET and so on."""
        return HardwareCompiler(self._draft, self.expressions, self.functions)

    @cached_property
    def tape(self) -> TapeCompiler:
        """CSAVE and so on."""
        return TapeCompiler(self._draft, self.expressions, self.assignments)

    @cached_property
    def output(self) -> OutputCompiler:
        """PRINT."""
        return OutputCompiler(self._draft, self.expressions, self.tape)

    @cached_property
    def arm(self) -> ArmCompiler:
        """The `@` statements."""
        return ArmCompiler(self._draft, self.expressions, self.assignments)

    @cached_property
    def commands(self) -> CommandCompiler:
        """END, LIST and so on, and what is passed."""
        return CommandCompiler(self._draft)

    def _step(self, address: int) -> None:
        """On one of several ways through a block it goes to an address: perhaps a loop's NEXT."""
        if self._out.in_block and not self._out.straight:
            self.loops.step_at(address)

    # -- the statement ------------------------------------------------------------------------

    @property
    def plain(self) -> bool:
        """Whether the statement may stand in a block."""
        return self._draft.plain

    @property
    def paced(self) -> bool:
        """Whether the statement may take any time."""
        return self._draft.paced

    @property
    def observes(self) -> bool:
        """Whether the statement looks at the machine."""
        return self._draft.observes

    def compile(self) -> bool:
        """Write the statement at the reader; whether control goes on behind it.

        Raises:
            TooDeep: the compiler cannot go so deeply into itself.
        """
        draft = self._draft
        try:
            self._out.cost += costs.STATEMENT
            goes_on = self._reader.at_end or self._statement()
        except Mistake as mistake:
            draft.fail(mistake)
            goes_on = False
            draft.plain = False
        except RecursionError:
            raise TooDeep from None
        self._out.note_cost()
        return goes_on

    def compile_target(self) -> None:
        """Write a function that finds one variable and returns a reference to it."""
        try:
            reference = self.assignments.target().reference
        except Mistake as mistake:
            self._draft.fail(mistake)
            return
        except RecursionError:
            raise TooDeep from None
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
        found = _PARSERS.get(code)
        if found is None:
            raise Mistake(Code.L3 if code in words.DISK else Code.SN)
        word, part, method = found
        self._reader.advance()
        self._draft.plain &= word.plain
        self._draft.paced |= word.paced
        self._draft.observes |= word.observes
        return method(getattr(self, part), word) is not False


_PARTS = {
    "assignments": AssignmentCompiler,
    "commands": CommandCompiler,
    "flow": FlowCompiler,
    "loops": LoopCompiler,
    "hardware": HardwareCompiler,
    "output": OutputCompiler,
    "tape": TapeCompiler,
}


def _parser(word: Word) -> tuple[Word, str, Callable[[object, Word], bool | None]]:
    part, method = word.parser.split(".")
    return word, part, getattr(_PARTS[part], method)


_PARSERS = {token: _parser(words.BY_TOKEN[token]) for token in words.STATEMENTS}
"""How each statement is read; a row that names no part or method fails here, at the start."""
