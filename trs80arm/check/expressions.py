"""Expressions of a program as trees, for rules that look at what a statement reads.

Precedence is the compiler's (`basic/compiler/expressions.py`). What that takes for an error is told
by the proofreader; here it is only `Unreadable`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from trs80arm.basic import characters, tokens, words
from trs80arm.basic.characters import CLOSE, COMMA, OPEN, QUOTE
from trs80arm.basic.errors import BasicError
from trs80arm.basic.numbers import literal
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.precedence import BINARY, NOT, RELATION, UNARY_MINUS

_KINDS: Final = frozenset(b"%!#$")
_WITHOUT_PARENTHESES: Final = frozenset(
    words.TOKENS[word] for word in ("ERL", "ERR", "MEM", "INKEY$", "TIME$")
)
_ARGUMENTS: Final = {
    **{words.TOKENS[word]: (2,) for word in ("LEFT$", "RIGHT$", "STRING$", "POINT")},
    words.TOKENS["MID$"]: (2, 3),
}
"""How many things stand in a function's parentheses, where it is not one."""
_DEEPEST: Final = 60
"""Operands in one another, as no person writes them; a run tells of more."""


class Unreadable(Exception):  # noqa: N818 - the proofreader tells what is wrong
    """Here stands what is no part of the language."""


@dataclass(frozen=True, slots=True)
class Literal:
    """A number or a string that stands in the text."""

    value: Number | bytes


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable or an element of an array.

    Attributes:
        name: of it, the two characters that count.
        kind: the sign behind the name, or nothing.
        subscripts: of an element; None for a plain variable.
        position: how much of the line's crunched text stands before it.
    """

    name: str
    kind: str
    subscripts: tuple[Expression, ...] | None
    position: int


@dataclass(frozen=True, slots=True)
class Operation:
    """Two operands, or one behind a sign or a NOT, and the operator's token."""

    operator: int
    left: Expression | None
    right: Expression


@dataclass(frozen=True, slots=True)
class Relation:
    """A comparison; `mask` has 1 for greater, 2 for equal and 4 for less."""

    mask: int
    left: Expression
    right: Expression


@dataclass(frozen=True, slots=True)
class Call:
    """A function and what stands in its parentheses."""

    function: int
    arguments: tuple[Expression, ...]


Expression = Literal | Variable | Operation | Relation | Call


def parts(expression: Expression) -> Iterator[Expression]:
    """An expression and all that it is made of."""
    yield expression
    match expression:
        case Variable(subscripts=inner) | Call(arguments=inner):
            operands: tuple[Expression | None, ...] = inner or ()
        case Operation(left=left, right=right) | Relation(left=left, right=right):
            operands = left, right
        case _:
            return
    for operand in operands:
        if operand is not None:
            yield from parts(operand)


def variables(expression: Expression) -> Iterator[Variable]:
    """The variables in an expression, those in subscripts too."""
    return (part for part in parts(expression) if isinstance(part, Variable))


def calls(expression: Expression) -> Iterator[Call]:
    """The functions in an expression."""
    return (part for part in parts(expression) if isinstance(part, Call))


class Text:
    """A place in the crunched text of a line, blanks passed, and what is read from there.

    Attributes:
        text: of the line.
        position: of the character that comes next.
    """

    def __init__(self, text: bytes) -> None:
        self.text = text
        self.position = 0
        self._depth = 0
        self.skip()

    @property
    def code(self) -> int:
        """The current character, 0 at the end of the line."""
        return self.text[self.position] if self.position < len(self.text) else 0

    @property
    def at_end(self) -> bool:
        """Whether the statement ends here."""
        return self.code in (characters.END, characters.COLON)

    def skip(self) -> int:
        """Pass blanks; the character behind them."""
        while self.code in characters.BLANKS and self.position < len(self.text):
            self.position += 1
        return self.code

    def advance(self) -> int:
        """The next character that is no blank."""
        self.position += 1
        return self.skip()

    def take(self, code: int) -> bool:
        """Pass a character if it stands here."""
        if self.code != code:
            return False
        self.advance()
        return True

    def expect(self, code: int) -> None:
        """Pass a character that has to stand here.

        Raises:
            Unreadable: another one does.
        """
        if not self.take(code):
            raise Unreadable

    def line_number(self) -> int | None:
        """The digits that stand here, blanks between them passed as the machine does."""
        digits = ""
        while characters.is_digit(self.code):
            digits += chr(self.code)
            self.advance()
        return int(digits) if digits else None

    def skip_statement(self) -> None:
        """Go to the colon or the end that ends the statement; a colon in quotes ends none."""
        quoted = False
        while self.position < len(self.text):
            code = self.text[self.position]
            if code == QUOTE:
                quoted = not quoted
            elif code == characters.COLON and not quoted:
                return
            self.position += 1

    # -- expressions --------------------------------------------------------------------------

    def expression(self, precedence: int = 0) -> Expression:
        """An expression, up to the first character that does not belong to it.

        Raises:
            Unreadable: none stands here.
        """
        self._depth += 1
        if self._depth > _DEEPEST:
            raise Unreadable
        left = self._operand()
        while True:
            before, mask = self.position, 0
            while tokens.GREATER <= self.code <= tokens.LESS:
                mask |= 1 << (self.code - tokens.GREATER)
                self.advance()
            if mask:
                if precedence >= RELATION:
                    self.position = before
                    break
                left = Relation(mask, left, self.expression(RELATION))
                continue
            operator = self.code
            if BINARY.get(operator, 0) <= precedence:
                break
            self.advance()
            left = Operation(operator, left, self.expression(BINARY[operator]))
        self._depth -= 1
        return left

    def _operand(self) -> Expression:
        code = self.code
        if characters.is_digit(code) or code == characters.POINT:
            return self._number()
        if characters.is_letter(code):
            return self.variable()
        if code == tokens.PLUS:
            self.advance()
            return self._operand()
        if code in (tokens.MINUS, tokens.NOT):
            self.advance()
            value = self.expression(UNARY_MINUS if code == tokens.MINUS else NOT)
            return Operation(code, None, value)
        if code == QUOTE:
            return Literal(self.string())
        if code in words.FUNCTIONS:
            return self._call(code)
        self.expect(OPEN)
        value = self.expression()
        self.expect(CLOSE)
        return value

    def _number(self) -> Literal:
        try:
            value, self.position = literal.scan(self.text, self.position)
        except BasicError:
            raise Unreadable from None
        self.skip()
        return Literal(value)

    def string(self) -> bytes:
        """What stands in the quotes that begin here."""
        start = self.position + 1
        end = self.text.find(b'"', start)
        end = len(self.text) if end < 0 else end
        self.position = end
        if end < len(self.text):
            self.advance()
        return self.text[start:end]

    def variable(self) -> Variable:
        """A variable or an element.

        Raises:
            Unreadable: no letter stands here.
        """
        start = self.position
        if not characters.is_letter(self.code):
            raise Unreadable
        name, kind = chr(self.code), ""
        while self.advance() in characters.OF_NAMES:
            name += chr(self.code)
        if self.code in _KINDS:
            kind = chr(self.code)
            self.advance()
        subscripts = None
        if self.code == OPEN:
            subscripts = self._list((CLOSE, characters.CLOSE_BRACKET))
        return Variable(name[:2], kind, subscripts, start)

    def _list(self, ends: tuple[int, ...] = (CLOSE,)) -> tuple[Expression, ...]:
        values = []
        while True:
            self.advance()
            values.append(self.expression())
            if self.code != COMMA:
                break
        if self.code not in ends:
            raise Unreadable
        self.advance()
        return tuple(values)

    def _call(self, function: int) -> Call:
        self.advance()
        if function in _WITHOUT_PARENTHESES:
            return Call(function, ())
        if self.code != OPEN:
            raise Unreadable
        arguments = self._list()
        if len(arguments) not in _ARGUMENTS.get(function, (1,)):
            raise Unreadable
        return Call(function, arguments)
