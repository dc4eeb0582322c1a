"""PRINT and LPRINT in all their forms."""

from __future__ import annotations

from collections.abc import Callable

from trs80arm.basic import costs, room, tokens
from trs80arm.basic.compiler.flow import FlowCompiler
from trs80arm.basic.compiler.values import Expression, Mistake
from trs80arm.basic.errors import Code
from trs80arm.basic.variables import STRING


class OutputCompiler(FlowCompiler):
    """PRINT."""

    def print(self) -> None:
        """PRINT [@ place,] [USING format;] items, or `#-1,` items to the tape.

        It prints where 409CH says and sets that back to the screen behind it, as LPRINT does.
        """
        if self.reader.code == 0x23:
            self._print_tape()
            return
        self._printed(place=True)
        self.out.emit("to_screen()")

    def lprint(self) -> None:
        """The same to the printer."""
        self.out.charge()
        self.out.emit("to_printer()")
        self._printed(place=False)
        self.out.emit("to_screen()")

    def _printed(self, place: bool) -> None:
        reader, out = self.reader, self.out
        out.cost += costs.STATEMENT_WORK["PRINT"]
        if place and reader.code == 0x40:
            reader.advance()
            out.cost += costs.STATEMENT_WORK["PRINT@"]
            out.emit(f"print_at({self.integer()})")
            self.expect(0x2C)
        newline = True
        while not reader.at_end:
            code = reader.code
            if code == tokens.USING:
                reader.advance()
                self._using()
                return
            newline = False
            if code == tokens.TAB:
                self._tab()
            elif code == 0x2C:
                out.cost += costs.STATEMENT_WORK["TAB"]
                out.charge()
                out.emit("print_comma()")
                reader.advance()
            elif code == 0x3B:
                reader.advance()
            else:
                self._item(self.expression())
                reader.skip()
                newline = True
        if newline:
            out.charge()
            out.emit("print_newline()")

    def _tab(self) -> None:
        self.reader.advance()
        self.out.cost += costs.STATEMENT_WORK["TAB"]
        column = self.out.keep(self.byte())
        if self.reader.code != 0x29:
            raise Mistake(Code.SN)
        self.reader.advance()
        self.out.charge()
        self.out.emit(f"print_tab({column})")

    def _item(self, value: Expression) -> None:
        out = self.out
        out.cost += costs.STATEMENT_WORK["PRINT_ITEM"]
        if value.kind == STRING:
            out.charge()
            out.emit(f"print_string({value.text})")
            return
        text = out.keep(value.shown)
        out.charge()
        out.emit(f"print_number({text})")

    def _using(self) -> None:
        """USING format; values: the format is read anew from value to value."""
        out, reader = self.out, self.reader
        layout = self.string()
        layout_name = out.keep(f"using({layout.text})")
        self.expect(0x3B)
        while True:
            out.charge()
            out.emit(f"using_literal({layout_name})")
            self.deepen(room.PARENTHESIS)
            value = self.expression()
            self.deepen(-room.PARENTHESIS)
            reader.skip()
            out.charge()
            function = "using_string" if value.kind == STRING else "using_number"
            out.emit(f"{function}({layout_name}, {value.text})")
            separator = reader.code in (0x2C, 0x3B)
            if not separator and not reader.at_end:
                raise Mistake(Code.SN)
            if not separator:
                out.emit(f"using_end({layout_name})")
                out.emit("print_newline()")
                return
            reader.advance()
            if reader.at_end:
                out.emit(f"using_end({layout_name})")
                return

    def _print_tape(self) -> None:
        self.tape_unit()
        out = self.out

        def items() -> None:
            out.emit("data = b''")
            newline = True
            while not self.reader.at_end:
                newline = self.reader.code not in (0x2C, 0x3B)
                if not newline:
                    if self.reader.code == 0x2C:
                        out.emit("data += b','")
                    self.reader.advance()
                    continue
                value = self.expression()
                function = "tape_string" if value.kind == STRING else "tape_number"
                out.emit(f"data += {function}({value.text})")
            if newline:
                out.emit("data += b'\\r'")

        self.tape_data(items)
        out.emit(f"begin_tape_print(data, {self.reader.address})")

    def tape_data(self, evaluate: Callable[[], None]) -> None:
        """Evaluate what goes to the tape into `data`; an error goes in its place.

        The ROM records the leader before it evaluates, so the error is only raised behind it.
        """
        out = self.out
        out.emit("try:")
        out.indent += 1
        try:
            evaluate()
        except Mistake as mistake:
            self.flush()
            out.fail(mistake.code)
        out.indent -= 1
        out.emit("except BasicError as error:")
        out.emit("  data = error")
        out.charge()
