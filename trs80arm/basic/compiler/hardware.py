"""Statements that reach the machine: graphics, the display, memory and ports."""

from __future__ import annotations

from trs80arm.basic.characters import COMMA
from trs80arm.basic.compiler.draft import Draft
from trs80arm.basic.compiler.expressions import ExpressionCompiler
from trs80arm.basic.compiler.functions import FunctionCompiler
from trs80arm.basic.words import Word


class HardwareCompiler:
    """SET, RESET, CLS, POKE, OUT and RANDOM.

    Args:
        draft: the statement.
        expressions: who reads addresses and bytes.
        functions: who reads `(x,y)`.
    """

    def __init__(
        self, draft: Draft, expressions: ExpressionCompiler, functions: FunctionCompiler
    ) -> None:
        self._draft = draft
        self._out = draft.out
        self._expressions = expressions
        self._functions = functions

    def set_block(self, word: Word) -> None:
        """SET(x,y)."""
        self._plot(word, lit=True)

    def reset_block(self, word: Word) -> None:
        """RESET(x,y)."""
        self._plot(word, lit=False)

    def _plot(self, word: Word, *, lit: bool) -> None:
        self._out.cost += word.work
        x, y = (self._out.keep(place.text) for place in self._functions.coordinates())
        self._out.charge()
        self._out.emit(f"{word.calls}({x}, {y}, {lit})")

    def clear_screen(self, word: Word) -> None:
        """CLS."""
        self._out.cost += word.work
        self._out.charge()
        self._out.emit(f"{word.calls}()")

    def random(self, word: Word) -> None:
        """RANDOM: the refresh register into the seed."""
        self._out.charge()
        self._out.emit(f"{word.calls}()")

    def poke(self, word: Word) -> None:
        """POKE address, byte."""
        self._out.cost += word.work
        address = self._out.keep(self._expressions.integer().text)
        value = self._byte_behind_comma()
        self._out.emit(
            f"{word.calls}({address}, {value}, {self._out.address(self._draft.reader.address)})"
        )

    def out(self, word: Word) -> None:
        """OUT port, byte."""
        self._out.cost += word.work
        port = self._out.keep(self._expressions.byte().text)
        value = self._byte_behind_comma()
        self._out.emit(f"{word.calls}({port}, {value})")

    def _byte_behind_comma(self) -> str:
        """The byte that goes to memory or a port; the clock is right when it goes."""
        self._draft.expect(COMMA)
        value = self._out.keep(self._expressions.byte().text)
        self._out.charge()
        return value
