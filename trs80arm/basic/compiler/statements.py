"""The statements by their tokens, and the compiler of one statement with all that it can hold."""

from __future__ import annotations

from collections.abc import Callable

from trs80arm.basic import costs, tokens
from trs80arm.basic.compiler.arm import ArmCompiler
from trs80arm.basic.compiler.emitter import Emitter
from trs80arm.basic.compiler.reader import Reader
from trs80arm.basic.compiler.scope import Scope
from trs80arm.basic.compiler.values import Mistake
from trs80arm.basic.errors import Code
from trs80arm.basic.program import Program
from trs80arm.basic.variables import DOUBLE, INTEGER, SINGLE, STRING, Key

_LAST_STATEMENT = tokens.token("NEW")
_DISK = frozenset(
    tokens.token(word)
    for word in (
        [
            "CMD",
            "LINE",
            "OPEN",
            "FIELD",
            "GET",
            "PUT",
            "CLOSE",
            "LOAD",
            "MERGE",
            "NAME",
            "KILL",
            "LSET",
            "RSET",
            "SAVE",
            "DEF",
        ]
    )
)
_COMMANDS = {
    tokens.token("LIST"): "list_lines",
    tokens.token("LLIST"): "list_printer",
    tokens.token("DELETE"): "delete_lines",
    tokens.token("EDIT"): "edit_line",
    tokens.token("AUTO"): "auto_lines",
}
_PLAIN = frozenset(
    tokens.token(word)
    for word in [
        "FOR",
        "NEXT",
        "DATA",
        "LET",
        "GOTO",
        "IF",
        "GOSUB",
        "RETURN",
        "REM",
        "ELSE",
        "ON",
        "POKE",
        "SET",
        "RESET",
        "OUT",
        "RESTORE",
    ]
)
"""Statements that may stand anywhere in a block, unless something in them may not."""
_KINDS = {
    tokens.token("DEFSTR"): STRING,
    tokens.token("DEFINT"): INTEGER,
    tokens.token("DEFSNG"): SINGLE,
    tokens.token("DEFDBL"): DOUBLE,
}


class StatementCompiler(ArmCompiler):
    """Compiles one statement."""

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
        super().__init__(reader, out, scope)
        self.program = program
        self.line = line
        self.loops = loops
        self.plain = False
        self.armbasic = armbasic

    def compile(self) -> bool:
        """Write the statement at the reader; whether control goes on behind it."""
        self.plain = self.reader.at_end or self.reader.code in _PLAIN or self.reader.code < 0x80
        try:
            self.out.cost += costs.STATEMENT
            goes_on = self.reader.at_end or self.statement()
        except (Mistake, RecursionError) as mistake:
            self.flush()
            self.out.fail(mistake.code if isinstance(mistake, Mistake) else Code.OM)
            goes_on = False
            self.plain = False
        self.out.note_cost()
        return goes_on

    def compile_target(self) -> None:
        """Write a function that finds one variable and returns a reference to it."""
        try:
            reference = self.target().reference
        except Mistake as mistake:
            self.flush()
            self.out.fail(mistake.code)
            return
        self.out.charge()
        self.out.emit(f"return {reference}")

    def statement(self) -> bool:
        """One statement; whether control goes on behind it."""
        code = self.reader.code
        if code < tokens.FIRST:
            if code == 0x40:
                self.plain = False
                return self.arm()
            self.let()
            return True
        if code > _LAST_STATEMENT:
            raise self.mistake(Code.SN)
        if code in _DISK:
            raise self.mistake(Code.L3)
        self.reader.advance()
        if code not in _PLAIN:
            self.plain = False
        if code in _COMMANDS:
            self.out.charge()
            rest = self.reader.address, len(self.reader.text) - self.reader.position
            self.out.emit(f"{_COMMANDS[code]}(text_at({rest[1]}, {rest[0]}))")
            return True
        if code in _KINDS:
            self.define(_KINDS[code])
            return False
        return _STATEMENTS[code](self) is not False

    def end(self) -> None:
        """END: to command level; CONT goes on behind it."""
        if self.reader.at_end:
            self.out.charge()
            self.out.emit(f"end_program({self.reader.address})")

    def stop(self) -> None:
        """STOP: `Break in n`."""
        if self.reader.at_end:
            self.out.charge()
            self.out.emit(f"stop_program({self.reader.address})")

    def remark(self) -> None:
        """REM and ELSE: the rest of the line is nothing."""
        rest = len(self.reader.text) - self.reader.position
        self.out.cost += costs.SKIPPED * rest
        self.reader.position = len(self.reader.text)

    def data(self) -> None:
        """DATA met in passing."""
        self.reader.skip_statement()

    def restore(self) -> None:
        """RESTORE: READ begins again."""
        self.out.cost += costs.STATEMENT_WORK["RESTORE"]
        self.out.emit("restore()")

    def plot(self, lit: bool) -> None:
        """SET and RESET of a graphics block."""
        self.out.cost += costs.STATEMENT_WORK["SET"]
        x, y = self.coordinates()
        x, y = self.out.keep(x), self.out.keep(y)
        self.out.charge()
        self.observes = True
        self.out.emit(f"plot({x}, {y}, {lit})")

    def set_block(self) -> None:
        """SET(x,y)."""
        self.plot(True)

    def reset_block(self) -> None:
        """RESET(x,y)."""
        self.plot(False)

    def cls(self) -> None:
        """CLS."""
        self.out.cost += costs.STATEMENT_WORK["CLS"]
        self.out.charge()
        self.out.emit("clear_screen()")

    def random(self) -> None:
        """RANDOM: the refresh register into the seed."""
        self.out.charge()
        self.out.emit("randomize()")

    def poke(self) -> None:
        """POKE address, byte."""
        self.out.cost += costs.STATEMENT_WORK["POKE"]
        address = self.out.keep(self.integer())
        self.expect(0x2C)
        value = self.out.keep(self.byte())
        self.out.charge()
        self.observes = True
        self.out.emit(f"poke({address}, {value}, {self.reader.address})")

    def out_port(self) -> None:
        """OUT port, byte."""
        self.out.cost += costs.STATEMENT_WORK["OUT"]
        port = self.out.keep(self.byte())
        self.expect(0x2C)
        value = self.out.keep(self.byte())
        self.out.charge()
        self.observes = True
        self.out.emit(f"write_port({port}, {value})")

    def error(self) -> None:
        """ERROR n."""
        self.out.cost += costs.STATEMENT_WORK["ERROR"]
        code = self.byte()
        if self.reader.at_end:
            self.out.emit(f"raise_error({code})")
        else:
            self.out.emit(code)

    def trace_on(self) -> None:
        """TRON."""
        self.out.emit("trace(True)")
        self.out.charge()
        self.out.emit(f"leave({self.reader.address})")

    def trace_off(self) -> None:
        """TROFF."""
        self.out.emit("trace(False)")
        self.out.charge()
        self.out.emit(f"leave({self.reader.address})")

    def new(self) -> None:
        """NEW."""
        if self.reader.at_end:
            self.out.charge()
            self.out.emit("new_program()")

    def cont(self) -> bool:
        """CONT; what stands behind it is not looked at."""
        self.out.go("continue_program()")
        return False

    def csave(self) -> None:
        """CSAVE name."""
        self.tape_data(self._name)
        self.out.emit(f"begin_csave(data, {self.reader.address})")

    def _name(self) -> None:
        """A program's name into `data`."""
        self.out.emit(f"data = tape_string({self.string().text})")

    def cload(self) -> None:
        """CLOAD [name] and CLOAD? [name]."""
        verify = self.reader.code == tokens.PRINT
        if verify:
            self.reader.advance()
        if self.reader.at_end:
            self.out.charge()
            self.out.emit("data = None")
        else:
            self.tape_data(self._name)
        self.out.emit(f"begin_cload(data, {verify}, {self.reader.address})")

    def system(self) -> None:
        """SYSTEM."""
        if self.reader.at_end:
            self.out.charge()
            self.out.emit("begin_system()")


_STATEMENTS: dict[int, Callable[[StatementCompiler], object]] = {
    tokens.token(word): method
    for word, method in {
        "END": StatementCompiler.end,
        "FOR": StatementCompiler.for_,
        "RESET": StatementCompiler.reset_block,
        "SET": StatementCompiler.set_block,
        "CLS": StatementCompiler.cls,
        "RANDOM": StatementCompiler.random,
        "NEXT": StatementCompiler.next_,
        "DATA": StatementCompiler.data,
        "INPUT": StatementCompiler.input,
        "DIM": StatementCompiler.dim,
        "READ": StatementCompiler.read,
        "LET": StatementCompiler.let,
        "GOTO": StatementCompiler.goto_statement,
        "RUN": StatementCompiler.run,
        "IF": StatementCompiler.if_,
        "RESTORE": StatementCompiler.restore,
        "GOSUB": StatementCompiler.gosub_statement,
        "RETURN": StatementCompiler.return_,
        "REM": StatementCompiler.remark,
        "STOP": StatementCompiler.stop,
        "ELSE": StatementCompiler.remark,
        "TRON": StatementCompiler.trace_on,
        "TROFF": StatementCompiler.trace_off,
        "ERROR": StatementCompiler.error,
        "RESUME": StatementCompiler.resume,
        "OUT": StatementCompiler.out_port,
        "ON": StatementCompiler.on,
        "SYSTEM": StatementCompiler.system,
        "LPRINT": StatementCompiler.lprint,
        "POKE": StatementCompiler.poke,
        "PRINT": StatementCompiler.print,
        "CONT": StatementCompiler.cont,
        "CLEAR": StatementCompiler.clear,
        "CLOAD": StatementCompiler.cload,
        "CSAVE": StatementCompiler.csave,
        "NEW": StatementCompiler.new,
    }.items()
}
