"""PRINT and LPRINT in all their forms but the tape's."""

from __future__ import annotations

from typing import Final

from trs80arm.basic import costs, room, tokens, words
from trs80arm.basic.characters import AT, CLOSE, COMMA, NUMBER_SIGN, SEMICOLON
from trs80arm.basic.code_calls import USR
from trs80arm.basic.compiler.draft import Draft, Mistake
from trs80arm.basic.compiler.expressions import ExpressionCompiler
from trs80arm.basic.compiler.tape import TapeCompiler
from trs80arm.basic.compiler.values import Expression
from trs80arm.basic.errors import Code
from trs80arm.basic.kinds import STRING
from trs80arm.basic.words import Word

_TAB: Final = words.BY_TOKEN[tokens.TAB]


class OutputCompiler:
    """PRINT.

    Args:
        draft: the statement.
        expressions: who reads the items.
        tape: who reads what is printed to the tape.
    """

    def __init__(self, draft: Draft, expressions: ExpressionCompiler, tape: TapeCompiler) -> None:
        self._draft = draft
        self._reader = draft.reader
        self._out = draft.out
        self._expressions = expressions
        self._tape = tape

    def print(self, word: Word) -> None:
        """PRINT [@ place,] [USING format;] items, or `#-1,` items to the tape.

        It prints where 409CH says and sets that back to the screen behind it, as LPRINT does.
        """
        if self._reader.code == NUMBER_SIGN:
            self._tape.print()
            return
        self._out.cost += word.work
        if self._reader.code == AT:
            self._place()
        self._items()
        self._out.emit("to_screen()")

    def lprint(self, word: Word) -> None:
        """The same to the printer."""
        self._out.charge()
        self._out.emit("to_printer()")
        self._out.cost += word.work
        self._items()
        self._out.emit("to_screen()")

    def _place(self) -> None:
        self._reader.advance()
        self._out.cost += costs.PRINT_AT
        self._out.emit(f"print_at({self._expressions.integer().text})")
        self._draft.expect(COMMA)

    def _items(self) -> None:
        reader, out = self._reader, self._out
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
            elif code == COMMA:
                out.cost += _TAB.work
                out.charge()
                out.emit("print_comma()")
                reader.advance()
            elif code == SEMICOLON:
                reader.advance()
            else:
                self._item(self._expressions.expression())
                reader.skip()
                newline = True
        if newline:
            out.charge()
            out.emit("print_newline()")

    def _tab(self) -> None:
        self._reader.advance()
        self._out.cost += _TAB.work
        column = self._out.keep(self._expressions.byte().text)
        if self._reader.code != CLOSE:
            raise Mistake(Code.SN)
        self._reader.advance()
        self._out.charge()
        self._out.emit(f"print_tab({column})")

    def _item(self, value: Expression) -> None:
        out = self._out
        out.cost += costs.PRINT_ITEM
        if value.kind == STRING:
            out.charge()
            out.emit(f"print_string({value.text})")
            return
        if value.text.startswith(f"{USR}("):
            # The only place for a string that machine code gives.
            text = out.keep(value.text.replace(USR, "user_value", 1))
            out.charge()
            out.emit(f"print_anything({text})")
            return
        text = out.keep(value.shown)
        out.charge()
        out.emit(f"print_number({text})")

    def _using(self) -> None:
        """USING format; values: the format is read anew from value to value."""
        out, reader = self._out, self._reader
        written = self._expressions.string()
        with self._draft.pending(written):
            self._draft.expect(SEMICOLON)
        layout = out.keep(f"using({written.text})")
        while True:
            out.charge()
            out.emit(f"using_literal({layout})")
            with self._draft.deeper(room.PARENTHESIS):
                value = self._expressions.expression()
            reader.skip()
            out.charge()
            function = "using_string" if value.kind == STRING else "using_number"
            out.emit(f"{function}({layout}, {value.text})")
            separator = reader.code in (COMMA, SEMICOLON)
            if not separator and not reader.at_end:
                raise Mistake(Code.SN)
            if not separator:
                out.emit(f"using_end({layout})")
                out.emit("print_newline()")
                return
            reader.advance()
            if reader.at_end:
                out.emit(f"using_end({layout})")
                return
