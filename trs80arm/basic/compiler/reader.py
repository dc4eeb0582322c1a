"""The place in a line's text, moved as the ROM moves it: blanks are passed, every step costs."""

from __future__ import annotations

from trs80arm.basic import costs
from trs80arm.basic.characters import BLANKS, COLON, END, QUOTE, ZERO, is_digit
from trs80arm.basic.compiler.emitter import Emitter

_QUOTE, _COLON = bytes((QUOTE,)), bytes((COLON,))


class Reader:
    """A cursor in the text of one line.

    Attributes:
        text: the crunched text, its final zero not included.
        base: the address of its first character.
        position: index of the current character.
    """

    def __init__(self, text: bytes, base: int, out: Emitter) -> None:
        self.text = text
        self.base = base
        self.position = 0
        self._out = out

    @property
    def code(self) -> int:
        """The current character, 0 at the end of the line."""
        return self.text[self.position] if self.position < len(self.text) else 0

    @property
    def address(self) -> int:
        """The address of the current character."""
        return self.base + self.position

    def skip(self) -> int:
        """Pass blanks; the character behind them."""
        while self.code in BLANKS:
            self.position += 1
            self._out.cost += costs.BLANK
        return self.code

    def advance(self) -> int:
        """The next character that is no blank (RST 10H)."""
        self.position += 1
        code = self.skip()
        self._out.cost += costs.CHARACTER if code >= COLON else costs.LOW_CHARACTER
        return code

    def state(self) -> tuple[int, int]:
        """What `restore` needs to come back here."""
        return self.position, self._out.cost

    def restore(self, state: tuple[int, int]) -> None:
        """Go back."""
        self.position, self._out.cost = state

    @property
    def at_end(self) -> bool:
        """Whether the statement ends here."""
        return self.code in (END, COLON)

    def string_literal(self) -> tuple[int, int]:
        """Length and address of the quoted text that begins here; the reader goes behind it."""
        start = self.position + 1
        end = self.text.find(_QUOTE, start)
        if end < 0:
            end = len(self.text)
        self.position = end
        if end < len(self.text):
            self.position += 1
        self.skip()
        return end - start, self.base + start

    def skip_rest(self) -> None:
        """Go to the end of the line, passing all without a look."""
        self._out.cost += costs.SKIPPED * (len(self.text) - self.position)
        self.position = len(self.text)

    def skip_statement(self) -> None:
        """Go to the colon or the end that ends the statement, quotes respected (1F05H)."""
        text, start = self.text, self.position
        end = text.find(_COLON, start)
        while end >= 0 and text.count(_QUOTE, start, end) % 2:
            end = text.find(_COLON, end + 1)
        self.position = end if end >= 0 else len(text)
        self._out.cost += costs.SKIPPED * (self.position - start)

    def digits(self) -> int | None:
        """A line number as the ROM reads it (1E5AH); None where there is no digit.

        Returns:
            The number; -1 when it is too large, which is ?SN.
        """
        number: int | None = None
        while is_digit(self.code):
            if (number or 0) > 6552:
                return -1
            number = (number or 0) * 10 + self.code - ZERO
            self._out.cost += costs.LINE_DIGIT
            self.advance()
        return number
