"""The functions of Level II as operands: what stands in their parentheses and what they compute.

Each method is a way of reading that a row of `words` can name: most functions are read by one of
the `of_` methods, which differ in the argument that they take.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from trs80arm.basic import costs, room, words
from trs80arm.basic.characters import COMMA, OPEN
from trs80arm.basic.code_calls import USR
from trs80arm.basic.compiler import pieces
from trs80arm.basic.compiler.draft import Draft, Mistake
from trs80arm.basic.compiler.expressions import ExpressionCompiler, listed
from trs80arm.basic.compiler.values import Expression, settled
from trs80arm.basic.errors import Code
from trs80arm.basic.kinds import ANY, DOUBLE, INTEGER, NUMBER, SINGLE, STRING, Kind
from trs80arm.basic.words import Word

_COLUMNS, _ROWS = 128, 48
"""Graphics blocks of the display."""
_HARMLESS = re.compile(rb"(?:, *[0-9]{1,2} *)?\)")
"""The end of MID$, with or without a length, in which no error can be."""


class FunctionCompiler:
    """Reads functions.

    Args:
        draft: the statement.
        expressions: who reads their arguments.
    """

    def __init__(self, draft: Draft, expressions: ExpressionCompiler) -> None:
        self._draft = draft
        self._reader = draft.reader
        self._out = draft.out
        self._expressions = expressions
        self._convert = expressions.convert

    def operand(self, word: Word) -> Expression:
        """The operand whose word stands here."""
        self._out.cost += word.work
        value = _PARSERS[word.spelling](self, word)
        self._out.calls_code |= word.calls == USR
        self._draft.observes |= word.observes
        self._draft.plain &= word.plain
        self._draft.paced |= word.paced
        return value

    # -- without parentheses, or with other things in them ------------------------------------

    def disk(self, _word: Word) -> Expression:
        """A word of Disk BASIC: L3, whatever stands behind it."""
        raise Mistake(Code.L3)

    def of_nothing(self, word: Word) -> Expression:
        """ERL, ERR and INKEY$."""
        self._reader.advance()
        return _call(word)

    def memory(self, word: Word) -> Expression:
        """MEM: what the expression at work takes does not count as free."""
        self._reader.advance()
        return _call(word, str(self._draft.stack_bytes))

    def varptr(self, _word: Word) -> Expression:
        """VARPTR of a variable or an element."""
        self._reader.advance()
        self._draft.expect(OPEN)
        key = self._expressions.name()
        name = self._out.constant(key)
        if self._reader.code == OPEN:
            _, subscripts = self._expressions.subscripts(key)
            value = Expression(f"element_address({name}, {listed(subscripts)})", INTEGER)
            self._expressions.close_parenthesis(value)
        else:
            scope = self._draft.scope
            self._out.cost += costs.VARIABLE + scope.search(scope.scalar(key))
            value = Expression(f"scalar_address({name})", INTEGER)
            # Whether there is one is seen behind the parenthesis.
            self._expressions.close_parenthesis()
        return value

    def characters(self, word: Word) -> Expression:
        """STRING$: how many, and a code or a string that begins with the character."""
        self._reader.advance()
        self._draft.expect(OPEN)
        count = self._expressions.byte()
        with self._draft.pending(count):
            self._draft.expect(COMMA)
            value = self._expressions.expression()
            self._expressions.close_parenthesis(value)
        if value.kind == STRING:
            return _call(word, count.text, f"first_code({value.text})")
        return _call(word, count.text, self._convert.to_byte(value).text)

    def part_of_string(self, word: Word) -> Expression:
        """LEFT$, RIGHT$ and MID$: the string, then one number, or two."""
        expressions, reader = self._expressions, self._reader
        reader.advance()
        self._draft.expect(OPEN)
        string = expressions.expression()
        with self._draft.pending(string):
            self._draft.expect(COMMA)
            if string.kind != STRING:
                raise Mistake(Code.TM)
            middle = word.calls == "middle"
            numbers = [self._place() if middle else expressions.byte()]
            with self._draft.pending(*numbers):
                if middle and reader.code == COMMA:
                    reader.advance()
                    numbers.append(expressions.byte())
                expressions.close_parenthesis(*numbers[1:])
        value = _call(word, string.text, *(number.text for number in numbers))
        piece = pieces.part(self._out, word.calls, string, numbers)
        return pieces.with_piece(value, piece, self._out)

    def _place(self) -> Expression:
        """The place that MID$ begins at: FC for 0 comes before any error in what follows.

        Where nothing can be wrong in that, MID$ looks at it.
        """
        place = self._expressions.byte()
        if place.constant == 0:
            raise Mistake(Code.FC)
        if place.constant is not None or _HARMLESS.match(self._reader.text, self._reader.position):
            return place
        return settled(self._out, Expression(f"from_one({place.text})", INTEGER))

    def of_place(self, word: Word) -> Expression:
        """POINT."""
        self._reader.advance()
        return _call(word, *(place.text for place in self.coordinates()))

    def coordinates(self) -> tuple[Expression, Expression]:
        """`(x,y)` of SET, RESET and POINT; FC outside 128 by 48."""
        self._draft.expect(OPEN)
        x = Expression(f"below({self._expressions.byte().text}, {_COLUMNS})", INTEGER)
        x = settled(self._out, x)
        with self._draft.pending(x):
            self._draft.expect(COMMA)
            y = Expression(f"below({self._expressions.byte().text}, {_ROWS})", INTEGER)
            self._expressions.close_parenthesis(y)
        return x, y

    # -- of one argument in parentheses -------------------------------------------------------

    def _argument(self) -> Expression:
        """What stands in parentheses behind the word."""
        self._reader.advance()
        if self._reader.code != OPEN:
            raise Mistake(Code.SN)
        self._out.cost += costs.PARENTHESES
        self._reader.advance()
        with self._draft.deeper(room.FUNCTION):
            value = self._expressions.expression()
        self._expressions.close_parenthesis(value)
        self._out.cost += costs.FUNCTION
        return value

    def _number(self) -> Expression:
        value = self._argument()
        if value.kind == STRING:
            raise self._draft.mistake(Code.TM, value)
        return value

    def disk_of_argument(self, _word: Word) -> Expression:
        """A function of Disk BASIC: L3 behind its argument."""
        raise self._draft.mistake(Code.L3, self._argument())

    def of_anything(self, word: Word) -> Expression:
        """A function that takes a string as well."""
        return _call(word, self._argument().text)

    def of_string(self, word: Word) -> Expression:
        """A function of a string; TM."""
        return _call(word, self._string().text)

    def length(self, word: Word) -> Expression:
        """LEN: that of a variable is the first thing in its descriptor."""
        value = self._string()
        return Expression(f"{value.text}[0]", INTEGER) if value.simple else _call(word, value.text)

    def _string(self) -> Expression:
        value = self._argument()
        if value.kind != STRING:
            raise self._draft.mistake(Code.TM, value)
        return value

    def of_number(self, word: Word) -> Expression:
        """A function of a number of any type."""
        return _call(word, self._number().text)

    def of_shown(self, word: Word) -> Expression:
        """STR$: what the ROM holds as an integer is shown as one."""
        value = self._number()
        piece = pieces.shown(self._out, value)
        return pieces.with_piece(_call(word, value.shown), piece, self._out)

    def of_single(self, word: Word) -> Expression:
        """A function of a single, whose results are remembered."""
        value = self._number()
        self._out.cost += costs.BY_POLYNOMIAL[word.calls]
        return Expression(f"{word.calls}[{self._convert.to_single(value).text}]", _kind(word))

    def of_integer(self, word: Word) -> Expression:
        """A function of an integer."""
        value = self._number()
        if value.constant != 0:
            self._out.cost += word.unless_zero
        return _call(word, self._convert.to_integer(value).text)

    def of_byte(self, word: Word) -> Expression:
        """A function of an integer of 0 to 255."""
        return _call(word, self._convert.to_byte(self._number()).text)

    def of_code(self, word: Word) -> Expression:
        """CHR$."""
        value = self._convert.to_byte(self._number())
        piece = pieces.character(self._out, value)
        return pieces.with_piece(_call(word, value.text), piece, self._out)

    def free_space(self, word: Word) -> Expression:
        """FRE: of a string the free string space, of a number what MEM is."""
        value = self._argument()
        if value.kind == STRING:
            return Expression(f"free_strings({value.text})", SINGLE)
        return _call(word, value.text, str(self._draft.stack_bytes))

    def converted(self, word: Word) -> Expression:
        """CINT, CSNG and CDBL: nothing but the conversion."""
        kind = _kind(word)
        return Expression(self._convert.to_kind(self._number(), kind).text, kind)

    def rounding(self, word: Word) -> Expression:
        """INT and FIX: by the type of the argument."""
        value = self._number()
        self._out.cost += costs.FLOOR[value.kind]
        if value.kind == INTEGER:
            return value
        if value.kind == SINGLE:
            floor = word.calls == "any_floor"
            text = f"({value.text} // 1.0)" if floor else f"{word.calls}({value.text})"
            return Expression(text, SINGLE, whole=True)
        # Of a double that has come to fit into an integer it is one.
        kind = ANY if value.kind == DOUBLE else value.kind
        return Expression(f"{word.calls}({value.text})", kind)

    def magnitude(self, word: Word) -> Expression:
        """ABS."""
        value = self._number()
        if value.kind == SINGLE:
            return Expression(f"abs({value.text})", SINGLE)
        # ABS(-32768) is a single.
        kind = NUMBER if value.kind == INTEGER else value.kind
        return Expression(f"{word.calls}({value.text})", kind)


def _call(word: Word, *arguments: str) -> Expression:
    """The routine of a word called."""
    return Expression(f"{word.calls}({', '.join(arguments)})", _kind(word))


def _kind(word: Word) -> Kind:
    assert word.gives is not None
    return word.gives


_PARSERS: dict[str, Callable[[FunctionCompiler, Word], Expression]] = {
    row.spelling: getattr(FunctionCompiler, row.parser)
    for row in words.TABLE
    if row.role is words.Role.FUNCTION
}
"""How each function is read; a row that names no method fails here, when the program starts."""
