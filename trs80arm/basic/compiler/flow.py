"""Statements that say where the program goes: GOTO, GOSUB, IF, FOR, NEXT, ON, RESUME and so on."""

from __future__ import annotations

from trs80arm.basic import costs, room, tokens
from trs80arm.basic.compiler.assignments import AssignmentCompiler
from trs80arm.basic.compiler.emitter import LOOP_BODY
from trs80arm.basic.compiler.values import Mistake
from trs80arm.basic.control import DIRECT
from trs80arm.basic.errors import Code
from trs80arm.basic.program import Program
from trs80arm.basic.variables import DOUBLE, INTEGER, STRING, Key


class FlowCompiler(AssignmentCompiler):
    """Control flow.

    Attributes:
        program: to find lines.
        line: the number of the line that is compiled, 65535 for a direct one.
        loops: the variables of the open loops, the guess for a bare NEXT.
    """

    program: Program
    line: int
    loops: list[Key]
    plain: bool

    def statement(self) -> bool:
        """One statement; whether control goes on behind it."""
        raise TypeError("no statements here")

    # -- jumps --------------------------------------------------------------------------------

    def line_number(self) -> int:
        """The digits that stand here; 0 where there are none."""
        number = self.reader.digits()
        if number == -1:
            raise self.mistake(Code.SN)
        return number or 0

    def jump_address(self, number: int) -> int:
        """The separator in front of a line, its search paid for; UL."""
        program = self.program
        passed = program.place(number)
        if self.line != DIRECT and number > self.line:
            passed -= program.place(self.line)
        self.out.cost += costs.LINE_PASSED * max(0, passed)
        address = program.find(number)
        if address is None:
            raise self.mistake(Code.UL)
        return address - 1

    def goto(self) -> None:
        """GOTO, and THEN or ELSE with digits; the rest of the line is skipped."""
        self.out.cost += costs.STATEMENT_WORK["GOTO"]
        number = self.line_number()
        self.out.cost += costs.SKIPPED * (len(self.reader.text) - self.reader.position)
        self.out.go(self.jump_address(number))

    def goto_statement(self) -> bool:
        """GOTO n."""
        self.goto()
        return False

    def gosub_statement(self) -> bool:
        """GOSUB n."""
        self.gosub()
        return False

    def gosub(self) -> None:
        """GOSUB: the way back is behind the statement."""
        self.out.cost += costs.STATEMENT_WORK["GOSUB"]
        start = self.reader.state()
        self.reader.skip_statement()
        back = self.reader.address
        self.reader.restore(start)
        number = self.line_number()
        self.out.cost += costs.SKIPPED * (len(self.reader.text) - self.reader.position)
        address = self.jump_address(number)
        frame = self.scope.frame_name(back, self.line)
        self.out.emit(f"if memory_room.plenty and len(frames) < {room.FEW}:")
        self.out.emit(f"  frames.append({frame})")
        self.out.emit("else:")
        self.out.emit(f"  open_subroutine({back}, {self.line})")
        self.out.go(address)

    def return_(self) -> bool:
        """RETURN: to behind the GOSUB, loops opened since are dropped."""
        if not self.reader.at_end:
            return True
        self.out.cost += costs.STATEMENT_WORK["RETURN"]
        self.out.emit("f = frames[-1]")
        self.out.emit("if f.scalar is None and len(frames) > 1:")
        self.out.indent += 1
        self.out.emit("frames.pop()")
        self.out.go("f.back")
        self.out.indent -= 1
        self.out.go("close_subroutine()")
        return False

    def run(self) -> bool:
        """RUN [n]: forget the variables and start."""
        self.out.cost += costs.STATEMENT_WORK["RUN"]
        self.out.emit("start_program()")
        if self.reader.at_end:
            self.out.go(self.program.start - 1)
        else:
            self.goto()
        return False

    # -- IF -----------------------------------------------------------------------------------

    def if_(self) -> bool:
        """IF: a true condition goes on in the line, a false one looks for its ELSE."""
        out, reader = self.out, self.reader
        out.cost += costs.STATEMENT_WORK["IF"]
        self.deepen(room.CONDITION)
        value = self.expression()
        self.deepen(-room.CONDITION)
        if reader.code == 0x2C:
            reader.advance()
        then = reader.state()
        if reader.code == tokens.THEN:
            reader.advance()
        if value.kind == STRING:
            self.pending.append(value.text)
            raise self.mistake(Code.TM)
        test = value.condition or value.text
        if value.kind == DOUBLE:
            test = f"{test}.mantissa"
        elif value.condition is None and value.kind not in (INTEGER, "s", "n"):
            test = f"sign({test})"
        charged = out.cost
        out.emit(f"if {test}:")
        out.indent += 1
        self._branch()
        out.indent -= 1
        reader.position, out.cost = then[0], charged
        if self._find_else():
            self._branch()
            return False
        return True

    def _branch(self) -> None:
        """What is done in one case: a line number, a statement, or nothing."""
        self.reader.skip()
        try:
            if 0x30 <= self.reader.code <= 0x39:
                self.goto()
                return
            goes_on = self.reader.at_end or self.statement()
        except Mistake as mistake:
            self.flush()
            self.out.fail(mistake.code)
            self.plain = False
            return
        if goes_on:
            self.out.go(self.reader.address)

    def _find_else(self) -> bool:
        """Skip to the ELSE that belongs to this IF; False at the end of the line.

        Every IF token that is passed asks for one ELSE more.
        """
        reader = self.reader
        wanted = 1
        while True:
            start = reader.position
            reader.skip_statement()
            wanted += self._ifs(reader.text[start : reader.position])
            if reader.code == 0:
                return False
            if reader.advance() == tokens.ELSE:
                wanted -= 1
                if not wanted:
                    reader.advance()
                    return True

    @staticmethod
    def _ifs(text: bytes) -> int:
        return sum(part.count(tokens.token("IF")) for part in text.split(b'"')[::2])

    # -- loops --------------------------------------------------------------------------------

    def for_(self) -> None:
        """FOR: variable, limit and step; an open loop of the same variable is dropped."""
        out, reader = self.out, self.reader
        out.cost += costs.STATEMENT_WORK["FOR"]
        start = reader.state()
        key = self.name()
        reader.restore(start)
        target = self.target(arrays=False)
        self.expect(tokens.EQUAL)
        self.store(target, self.expression())
        scalar = self.scope.object_name(key)
        out.emit("if frames[-1].scalar is not None:")
        out.emit(f"  drop_loop({scalar})")
        state = reader.state()
        reader.skip_statement()
        body = reader.address
        reader.restore((state[0], out.cost))
        self.expect(tokens.TO)
        if key[1] in (STRING, DOUBLE):
            raise self.mistake(Code.TM)
        self.deepen(room.LIMIT)
        limit = out.keep(self.to_kind(self.number(), key[1]))
        self.deepen(room.STEP - room.LIMIT)
        step = "1" if key[1] == INTEGER else "1.0"
        if reader.code == tokens.STEP:
            out.cost += costs.STATEMENT_WORK["STEP"]
            reader.advance()
            step = self.to_kind(self.number(), key[1])
        self.deepen(-room.STEP)
        out.emit(f"open_loop({scalar}, {limit}, {step}, {body}, {self.line})")
        self.loops.append(key)

    def next_(self) -> None:
        """NEXT [names]: step, compare, and go back to the body or on."""
        if self.reader.at_end:
            self._step_loop(None)
            del self.loops[-1:]
            return
        while True:
            key = self.name()
            self.scope.scalar(key)
            self.out.cost += costs.VARIABLE + self.scope.search(self.scope.scalar(key))
            if not self.scope.exists(key):
                self.out.emit(f"create({key!r})")
            self._step_loop(key)
            del self.loops[-1:]
            if self.reader.code != 0x2C:
                return
            self.reader.advance()

    def _step_loop(self, key: Key | None) -> None:
        """One loop's step: at once when the innermost loop is the expected one."""
        out = self.out
        guess = key or (self.loops[-1] if self.loops else None)
        if guess is None or guess[1] in (STRING, DOUBLE):
            out.cost += costs.STATEMENT_WORK["NEXT"]
            self._slow_step(key)
            return
        integer = guess[1] == INTEGER
        out.cost += costs.STATEMENT_WORK["NEXT_INTEGER" if integer else "NEXT"]
        scalar = self.scope.object_name(guess)
        self.scope.scalar(guess)
        cell = self.scope.scalar(guess).cell
        name = out.cell(self.scope.cell_name(guess), cell, stored=True)
        charged = out.cost
        out.emit("f = frames[-1]")
        out.emit(f"if f.scalar is {scalar}:")
        out.indent += 1
        if integer:
            out.emit(f"{name} = t = integer_step({name}, f.step)")
        else:
            out.emit(f"t = {name} + f.step")
            out.emit("c = t * 536870913.0")
            out.emit("if c - (c - t) != t or not (1e-37 < t < 8e37 or -8e37 < t < -1e-37):")
            out.emit(f"  t = add({name}, f.step)")
            out.emit(f"{name} = t")
        out.emit("if (t <= f.limit if f.up > 0 else goes_on(t, f)):")
        out.indent += 1
        out.go(LOOP_BODY)
        out.indent -= 1
        out.emit("frames.pop()")
        out.indent -= 1
        out.emit("else:")
        out.indent += 1
        out.cost = charged
        self._slow_step(key)
        out.indent -= 1

    def _slow_step(self, key: Key | None) -> None:
        wanted = "None" if key is None else self.scope.object_name(key)
        self.out.emit(f"t = step_loop({wanted})")
        self.out.emit("if t:")
        self.out.indent += 1
        self.out.go("t")
        self.out.indent -= 1

    # -- ON -----------------------------------------------------------------------------------

    def on(self) -> bool:
        """ON n GOTO, ON n GOSUB, ON ERROR GOTO."""
        out, reader = self.out, self.reader
        if reader.code == tokens.ERROR:
            self._on_error()
            return True
        out.cost += costs.STATEMENT_WORK["ON"]
        self.deepen(room.CONDITION)
        number = out.keep(self.byte())
        self.deepen(-room.CONDITION)
        word = reader.code
        if word != tokens.GOSUB and word != tokens.GOTO:
            raise self.mistake(Code.SN)
        reader.advance()
        choice = 1
        while True:
            here = reader.state()
            out.emit(f"if {number} == {choice}:")
            out.indent += 1
            try:
                self.gosub() if word == tokens.GOSUB else self.goto()
            except Mistake as mistake:
                out.fail(mistake.code)
                self.plain = False
            out.indent -= 1
            reader.restore(here)
            self.line_number()
            choice += 1
            if reader.code != 0x2C:
                return True
            reader.advance()

    def _on_error(self) -> None:
        self.out.cost += costs.STATEMENT_WORK["ON ERROR"]
        self.reader.advance()
        self.expect(tokens.GOTO)
        number = self.line_number()
        if not number:
            self.out.emit("set_trap(0)")
            return
        self.out.cost += costs.LINE_PASSED * self.program.place(number)
        address = self.program.find(number)
        if address is None:
            raise self.mistake(Code.UL)
        self.out.emit(f"set_trap({address})")

    def resume(self) -> bool:
        """RESUME, RESUME 0, RESUME NEXT, RESUME n."""
        out, reader = self.out, self.reader
        out.cost += costs.STATEMENT_WORK["RESUME"]
        out.emit("end_handling()")
        if reader.code == tokens.NEXT:
            reader.advance()
            if not reader.at_end:
                return True
            out.go("resume_next()")
            return False
        number = self.line_number()
        if not reader.at_end:
            return True
        if number:
            out.cost += costs.SKIPPED * (len(reader.text) - reader.position)
            out.go(self.jump_address(number))
        else:
            out.go("resume_again()")
        return False
