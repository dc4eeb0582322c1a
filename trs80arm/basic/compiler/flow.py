"""Statements that say where the program goes: GOTO, GOSUB, IF, ON, RESUME and so on."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from trs80arm.basic import characters, costs, room, tokens, words
from trs80arm.basic.characters import AT, COMMA, QUOTE
from trs80arm.basic.compiler.draft import Draft, Mistake
from trs80arm.basic.compiler.emitter import Call
from trs80arm.basic.compiler.expressions import ExpressionCompiler
from trs80arm.basic.compiler.relocation import Search, lines_passed
from trs80arm.basic.compiler.values import Expression
from trs80arm.basic.control import DIRECT, GosubFrame
from trs80arm.basic.errors import Code
from trs80arm.basic.kinds import ANY, DOUBLE, STRING
from trs80arm.basic.program import LAST_ADDRESS, Program
from trs80arm.basic.words import Word

_GOTO: Final = words.word("GOTO")
_GOSUB: Final = words.word("GOSUB")


class FlowCompiler:
    """Control flow.

    Args:
        draft: the statement.
        expressions: who reads conditions and limits.
        statement: compiles the statement behind a THEN or an ELSE; whether control goes on
            behind it.
        step: writes the step of a loop for a jump to its NEXT.
        program: to find lines.
        line: the number of the line that is compiled, 65535 for a direct one.
    """

    def __init__(
        self,
        draft: Draft,
        expressions: ExpressionCompiler,
        statement: Callable[[], bool],
        step: Callable[[int], None],
        program: Program,
        line: int,
    ) -> None:
        self._draft = draft
        self._reader = draft.reader
        self._out = draft.out
        self._scope = draft.scope
        self._expressions = expressions
        self._statement = statement
        self._step = step
        self._program = program
        self._line = line

    # -- jumps --------------------------------------------------------------------------------

    def _line_number(self) -> int:
        """The digits that stand here; 0 where there are none."""
        number = self._reader.digits()
        if number == -1:
            raise Mistake(Code.SN)
        return number or 0

    def _jump_address(self, number: int) -> int:
        """The separator in front of a line, its search paid for; UL."""
        behind = self._line if self._line != DIRECT and number > self._line else None
        self._search(number, behind)
        return self._find(number) - 1

    def _search(self, number: int, behind: int | None) -> None:
        """The search for a line is paid for; the arguments are those of `lines_passed`."""
        passed = lines_passed(self._program, number, behind)
        self._out.passes(Search(number, behind, passed))
        self._out.cost += costs.LINE_PASSED * passed

    def _find(self, number: int) -> int:
        """The address of a line's link; UL."""
        address = self._program.find(number)
        if address is None:
            # It may be put in anywhere.
            self._out.depends_on(0, LAST_ADDRESS)
            raise Mistake(Code.UL)
        self._out.depends_on(address - 1, address)
        return address

    def _pass_rest(self) -> None:
        """The rest of the line is passed without a look."""
        self._out.cost += costs.SKIPPED * (len(self._reader.text) - self._reader.position)

    def _goto(self) -> None:
        """GOTO, and THEN or ELSE with digits; the rest of the line is skipped."""
        self._out.cost += _GOTO.work
        number = self._line_number()
        self._pass_rest()
        address = self._jump_address(number)
        self._step(address)
        self._out.go(address)

    def goto_statement(self, _word: Word) -> bool:
        """GOTO n."""
        self._goto()
        return False

    def gosub_statement(self, _word: Word) -> bool:
        """GOSUB n."""
        self._gosub()
        return False

    def _gosub(self) -> None:
        """GOSUB: the way back is behind the statement."""
        out, reader = self._out, self._reader
        out.cost += _GOSUB.work
        start = reader.state()
        reader.skip_statement()
        back = reader.address
        reader.restore(start)
        number = self._line_number()
        self._pass_rest()
        address = self._jump_address(number)
        line = self._line
        frame = out.frame(lambda back: GosubFrame(back, line), back)
        out.emit(f"if memory_room.plenty and len(frames) < {room.FEW}:")
        out.emit(f"  frames.append({frame})")
        out.emit("else:")
        out.emit(f"  open_subroutine({out.address(back)}, {line})")
        if out.straight:
            # Short of memory, statements are compiled with looks at it: not in this block.
            out.indent += 1
            out.leave_for(address)
            out.indent -= 1
            out.calls.append(Call(frame, back))
        out.go(address)

    def return_(self, word: Word) -> bool:
        """RETURN: to behind the GOSUB, loops opened since are dropped."""
        if not self._reader.at_end:
            return True
        out = self._out
        out.cost += word.work
        out.emit("f = frames[-1]")
        if out.straight and out.calls:
            call = out.calls.pop()
            charged = out.cost
            out.emit(f"if f is not {call.frame}:")
            out.indent += 1
            self._leave_subroutine(word)
            out.indent -= 1
            out.cost = charged
            out.emit("frames.pop()")
            out.go(call.back)
            return False
        self._leave_subroutine(word)
        return False

    def _leave_subroutine(self, word: Word) -> None:
        """RETURN by the frame in `f`, whatever it is."""
        out = self._out
        out.emit("if f.scalar is None and len(frames) > 1:")
        out.indent += 1
        out.emit("frames.pop()")
        out.go_to_found("f.back")
        out.indent -= 1
        out.go_to_found(out.keep(f"{word.calls}()"))

    def run(self, word: Word) -> bool:
        """RUN [n]: forget the variables and start."""
        self._out.cost += word.work
        self._out.emit(f"{word.calls}()")
        if self._reader.at_end:
            start = self._program.start
            self._out.depends_on(start - 1, start)
            self._out.go(start - 1)
        else:
            self._goto()
        return False

    # -- IF -----------------------------------------------------------------------------------

    def if_(self, word: Word) -> bool:
        """IF: a true condition goes on in the line, a false one looks for its ELSE."""
        out, reader = self._out, self._reader
        out.cost += word.work
        with self._draft.deeper(room.CONDITION):
            value = self._expressions.expression()
        if reader.code == COMMA:
            reader.advance()
        then = reader.state()
        if reader.code == tokens.THEN:
            reader.advance()
        if value.kind == STRING:
            raise self._draft.mistake(Code.TM, value)
        charged, plain = out.cost, self._draft.plain
        out.emit(f"if {_truth(value)}:")
        out.indent += 1
        self._note_place()
        self._branch()
        out.indent -= 1
        # A block is left behind this branch, so anything may stand in it.
        self._draft.plain = plain
        reader.position, out.cost = then[0], charged
        if self._find_else():
            self._branch()
            return False
        return True

    def _note_place(self) -> None:
        """Have it noted where the program is, for a statement behind THEN that may ask."""
        code = self._reader.skip()
        word = words.BY_TOKEN.get(code)
        if self._out.in_block and (code == AT or (word is not None and not word.plain)):
            self._out.emit(f"now_at({self._out.address(self._out.statement)})")

    def _branch(self) -> None:
        """What is done in one case: a line number, a statement, or nothing."""
        reader = self._reader
        reader.skip()
        try:
            if characters.is_digit(reader.code):
                self._goto()
                return
            goes_on = reader.at_end or self._statement()
        except Mistake as mistake:
            self._draft.fail(mistake)
            self._draft.plain = False
            return
        if goes_on:
            self._out.go(reader.address)

    def _find_else(self) -> bool:
        """Skip to the ELSE that belongs to this IF; False at the end of the line.

        Every IF token that is passed asks for one ELSE more.
        """
        reader = self._reader
        wanted = 1
        while True:
            start = reader.position
            reader.skip_statement()
            wanted += _ifs(reader.text[start : reader.position])
            if reader.code == characters.END:
                return False
            if reader.advance() == tokens.ELSE:
                wanted -= 1
                if not wanted:
                    reader.advance()
                    return True

    # -- ON and errors ------------------------------------------------------------------------

    def on(self, word: Word) -> bool:
        """ON n GOTO, ON n GOSUB, ON ERROR GOTO."""
        out, reader = self._out, self._reader
        if reader.code == tokens.ERROR:
            self._on_error()
            return True
        out.cost += word.work
        with self._draft.deeper(room.CONDITION):
            number = out.keep(self._expressions.byte().text)
        jump = {tokens.GOTO: self._goto, tokens.GOSUB: self._gosub}.get(reader.code)
        if jump is None:
            raise Mistake(Code.SN)
        reader.advance()
        choice = 1
        while True:
            here = reader.state()
            out.emit(f"if {number} == {choice}:")
            out.indent += 1
            try:
                jump()
            except Mistake as mistake:
                out.fail(mistake.code)
                self._draft.plain = False
            out.indent -= 1
            reader.restore(here)
            self._line_number()
            choice += 1
            if reader.code != COMMA:
                return True
            reader.advance()

    def _on_error(self) -> None:
        self._out.cost += costs.ON_ERROR
        self._reader.advance()
        self._draft.expect(tokens.GOTO)
        number = self._line_number()
        if not number:
            self._out.emit("set_trap(0)")
            return
        self._search(number, None)
        self._out.emit(f"set_trap({self._out.address(self._find(number))})")

    def error(self, word: Word) -> None:
        """ERROR n."""
        self._out.cost += word.work
        code = self._expressions.byte().text
        self._out.emit(f"{word.calls}({code})" if self._reader.at_end else code)

    def resume(self, word: Word) -> bool:
        """RESUME, RESUME 0, RESUME NEXT, RESUME n."""
        out, reader = self._out, self._reader
        out.cost += word.work
        out.emit("end_handling()")
        if reader.code == tokens.NEXT:
            reader.advance()
            if not reader.at_end:
                return True
            out.go_to_found("resume_next()")
            return False
        number = self._line_number()
        if not reader.at_end:
            return True
        if number:
            self._pass_rest()
            out.go(self._jump_address(number))
        else:
            out.go_to_found("resume_again()")
        return False

    def restore(self, word: Word) -> None:
        """RESTORE: READ begins again."""
        self._out.cost += word.work
        self._out.emit(f"{word.calls}()")


def _truth(value: Expression) -> str:
    """Text that is true where a number is not zero."""
    if value.condition is not None:
        return value.condition
    if value.kind == DOUBLE:
        return f"{value.text}.mantissa"
    return f"sign({value.text})" if value.kind == ANY else value.text


def _ifs(text: bytes) -> int:
    """The IF tokens outside quotes."""
    return sum(part.count(tokens.IF) for part in text.split(bytes((QUOTE,)))[::2])
