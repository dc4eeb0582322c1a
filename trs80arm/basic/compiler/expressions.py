"""Expressions: from the text of a line to Python text, in the order in which the ROM evaluates.

Precedence and the odd corners (string `+` binds at once, `=<`, `NOT`) are the ROM's (Level II
facts, Expressions). What begins with a word is read by the function compiler.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from trs80arm.basic import addresses, characters, costs, number_costs, room, tokens, words
from trs80arm.basic.characters import CLOSE, COMMA, OPEN, QUOTE
from trs80arm.basic.compiler import pieces
from trs80arm.basic.compiler.draft import Draft, Mistake
from trs80arm.basic.compiler.values import Conversions, Expression, constant, settled, wider
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.kinds import ANY, DOUBLE, INTEGER, NUMBER, SINGLE, SIZES, STRING
from trs80arm.basic.numbers import functions, literal
from trs80arm.basic.numbers.double import Double
from trs80arm.basic.precedence import BINARY, NOT, RELATION, UNARY_MINUS
from trs80arm.basic.variables import Array, Key

_ARITHMETIC: Final = {
    tokens.PLUS: "add",
    tokens.MINUS: "sub",
    tokens.TIMES: "mul",
    tokens.DIVIDE: "div",
}
_RELATIONS: Final = {1: ">", 2: "==", 3: ">=", 4: "<", 5: "!=", 6: "<="}
_SIGNS: Final = {
    characters.PERCENT: INTEGER,
    characters.DOLLAR: STRING,
    characters.EXCLAMATION: SINGLE,
    characters.NUMBER_SIGN: DOUBLE,
}
"""The signs behind a name that say its type."""


class ExpressionCompiler:
    """Reads expressions from a line and writes them as Python text.

    Args:
        draft: the statement.
        function: reads an operand that begins with a word.

    Attributes:
        convert: conversions of values.
    """

    def __init__(self, draft: Draft, function: Callable[[words.Word], Expression]) -> None:
        self._draft = draft
        self._reader = draft.reader
        self._out = draft.out
        self._scope = draft.scope
        self._function = function
        self.convert = Conversions(draft.out)
        self._operand_end = 0
        """Where the operand read last ends, which string comparison goes back to."""

    # -- whole expressions --------------------------------------------------------------------

    def expression(self) -> Expression:
        """An expression, up to the first character that does not belong to it."""
        self._reader.skip()
        outermost = not self._draft.depth
        value = self._evaluate(0)
        value = settled(self._out, value)
        if outermost:
            self._draft.need_room(room.EXPRESSION)
        return value

    def number(self) -> Expression:
        """An expression that must be a number; TM."""
        value = self.expression()
        if value.kind == STRING:
            raise self._draft.mistake(Code.TM, value)
        return value

    def string(self) -> Expression:
        """An expression that must be a string; TM."""
        value = self.expression()
        if value.kind != STRING:
            raise self._draft.mistake(Code.TM, value)
        return value

    def integer(self) -> Expression:
        """A number rounded down to an integer (2B02H); OV, TM."""
        return settled(self._out, self.convert.to_integer(self.number()))

    def byte(self) -> Expression:
        """A number rounded down to 0..255 (2B1CH); FC, OV, TM."""
        value = settled(self._out, self.convert.to_byte(self.number()))
        self._reader.skip()
        return value

    def whole(self) -> Expression:
        """A number rounded down to 0..32767 (1E45H); FC, OV, TM."""
        return settled(self._out, to_subscript(self.number()))

    # -- operators ----------------------------------------------------------------------------

    def _evaluate(self, precedence: int) -> Expression:
        draft = self._draft
        draft.depth += 1
        left = self._operand()
        reader = self._reader
        self._operand_end = reader.position
        while True:
            mask = 0
            before = reader.state()
            while tokens.GREATER <= reader.code <= tokens.LESS:
                bits = mask ^ 1 << (reader.code - tokens.GREATER)
                if bits < mask:
                    raise draft.mistake(Code.SN, left)
                mask = bits
                reader.advance()
            if mask:
                if precedence >= RELATION:
                    reader.restore(before)
                    break
                left = self._relation(left, mask)
                continue
            operator = reader.code
            if operator not in BINARY:
                break
            if operator == tokens.PLUS and left.kind == STRING:
                left = self._concatenation(left)
                continue
            if BINARY[operator] <= precedence:
                break
            left = self._operation(left, operator)
        draft.depth -= 1
        return left

    def _right(self, left: Expression, precedence: int) -> Expression:
        """What stands to the right of an operator, while its left side is pending."""
        size = room.OPERATOR + SIZES.get(left.kind, SIZES[SINGLE])
        with self._draft.pending(left), self._draft.deeper(size):
            return self._evaluate(precedence)

    def _relation(self, left: Expression, mask: int) -> Expression:
        left = settled(self._out, left)
        right = self._right(left, RELATION)
        strings = (left.kind == STRING) + (right.kind == STRING)
        if strings == 1:
            raise self._draft.mistake(Code.TM, left, right)
        relation = _RELATIONS.get(mask)
        if strings:
            # The ROM goes on behind the last operand it has noted (40F3H), and a concatenation
            # notes none of its own: "A"="B"+"C" compares, and then reads +"C" again.
            self._reader.position = self._operand_end
            self._out.cost += costs.COMPARE_STRINGS
            self._out.allow(costs.MOST_COMPARED)
            test = _string_relation(left, right, relation, self._draft.depth)
        else:
            self._out.cost += costs.binary("compare", left.held, right.held)
            test = self._number_relation(left, right, relation)
        self._out.cost += costs.OPERATOR
        return Expression(f"-({test})", INTEGER, condition=test)

    def _number_relation(self, left: Expression, right: Expression, relation: str | None) -> str:
        kind = wider(left.kind, right.kind)
        if relation is None:
            return f"always({left.text}, {right.text})"
        if kind == DOUBLE:
            a, b = self.convert.to_double(left).text, self.convert.to_double(right).text
            return f"double_compare({a}, {b}) {relation} 0"
        if kind == ANY:
            return f"compare({left.text}, {right.text}) {relation} 0"
        return f"{left.text} {relation} {right.text}"

    def _concatenation(self, left: Expression) -> Expression:
        left = settled(self._out, left)
        self._reader.advance()
        with self._draft.pending(left):
            right = self._operand()
        if right.kind != STRING:
            raise self._draft.mistake(Code.TM, left, right)
        out = self._out
        self._draft.paced = True
        out.cost += costs.CONCATENATE
        value = Expression(f"concatenate({left.text}, {right.text})", STRING)
        return pieces.with_piece(value, pieces.joined(out, left, right), out)

    def _operation(self, left: Expression, operator: int) -> Expression:
        if left.kind == STRING:
            raise self._draft.mistake(Code.TM, left)
        left = settled(self._out, left)
        self._reader.advance()
        self._out.cost += costs.OPERATOR
        if operator in (tokens.AND, tokens.OR):
            return self._logical(left, operator)
        right = self._right(left, BINARY[operator])
        if right.kind == STRING:
            raise self._draft.mistake(Code.TM, left, right)
        if operator == tokens.POWER:
            self._out.cost += costs.POWER
            base, exponent = self.convert.to_single(left), self.convert.to_single(right)
            if exponent.constant in functions.OF_ONE_EXPONENT:
                name = functions.OF_ONE_EXPONENT[exponent.constant]
                return Expression(f"{name}[{base.text}]", SINGLE)
            return Expression(f"power[{base.text}, {exponent.text}]", SINGLE)
        return self._arithmetic(left, _ARITHMETIC[operator], right)

    def _logical(self, left: Expression, operator: int) -> Expression:
        self._out.cost += costs.LOGICAL
        converted = settled(self._out, self.convert.to_integer(left))
        right = self._right(converted, BINARY[operator])
        if right.kind == STRING:
            raise self._draft.mistake(Code.TM, converted, right)
        sign = "&" if operator == tokens.AND else "|"
        if left.condition is not None and right.condition is not None:
            both = f"(({left.condition}) {sign} ({right.condition}))"
            return Expression(f"-{both}", INTEGER, condition=both)
        right = self.convert.to_integer(right)
        return Expression(f"({converted.text} {sign} {right.text})", INTEGER)

    def _arithmetic(self, left: Expression, name: str, right: Expression) -> Expression:
        kind = wider(left.kind, right.kind)
        if kind == NUMBER and name == "div":
            kind = SINGLE
        self._out.cost += costs.binary(name, left.held, right.held)
        held = {left.held, right.held} - {INTEGER, NUMBER}
        if name == "mul" and kind == SINGLE and right.constant and held:
            self._out.cost += number_costs.product_by(float(right.constant))
        if kind == DOUBLE:
            self._out.allow(costs.MOST_OF_CALL)
            a, b = self.convert.to_double(left), self.convert.to_double(right)
            text = f"double_{name}({a.text}, {b.text})"
        elif kind == SINGLE:
            text = self.convert.single_arithmetic(name, left, right, self._draft.depth)
        elif kind == NUMBER and left.kind == right.kind == INTEGER:
            text = f"integer_{name}({left.text}, {right.text})"
        else:
            text = f"any_{name}({left.text}, {right.text})"
        whole = kind == SINGLE and name != "div" and not held
        return Expression(text, kind, whole=whole)

    # -- operands -----------------------------------------------------------------------------

    def _operand(self) -> Expression:
        reader, out = self._reader, self._out
        code = reader.code
        out.cost += costs.OPERAND
        if reader.at_end:
            raise Mistake(Code.MO)
        if characters.is_digit(code) or code == characters.POINT:
            return self._constant()
        if characters.is_letter(code):
            return self._variable()
        if code == tokens.PLUS:
            reader.advance()
            return self._operand()
        if code == tokens.MINUS:
            reader.advance()
            return self._negated(self._nested(UNARY_MINUS))
        if code == QUOTE:
            length, address = reader.string_literal()
            out.cost += costs.STRING_LITERAL + costs.STRING_CHARACTER * length
            call = f"literal({length}, {out.address(address)})"
            value = Expression(call, STRING)
            if address < addresses.PROGRAM or length > characters.LONGEST_STRING:
                return value
            start = address - reader.base
            text = reader.text[start : start + length]
            return pieces.with_piece(value, pieces.literal(text, call, address), out)
        if code == tokens.NOT:
            reader.advance()
            return self._complement(self._nested(NOT))
        if code == characters.AMPERSAND:
            raise Mistake(Code.L3)
        if code in words.FUNCTIONS:
            return self._function(words.BY_TOKEN[code])
        return self._in_parentheses()

    def _in_parentheses(self) -> Expression:
        self._out.cost += costs.PARENTHESES
        self._draft.expect(OPEN)
        with self._draft.deeper(room.PARENTHESIS):
            value = self.expression()
        self.close_parenthesis(value)
        return value

    def close_parenthesis(self, *values: Expression) -> None:
        """A `)` behind values that are pending; SN."""
        if self._reader.code != CLOSE:
            raise self._draft.mistake(Code.SN, *values)
        self._reader.advance()

    def _nested(self, precedence: int) -> Expression:
        """The operand of a sign or a NOT."""
        with self._draft.deeper(room.PARENTHESIS):
            return settled(self._out, self._evaluate(precedence))

    def _complement(self, value: Expression) -> Expression:
        if value.kind == STRING:
            raise self._draft.mistake(Code.TM, value)
        self._out.cost += costs.LOGICAL
        if value.condition is not None:
            test = f"(not {value.condition})"
            return Expression(f"-{test}", INTEGER, condition=test)
        return Expression(f"~{self.convert.to_integer(value).text}", INTEGER)

    def _negated(self, value: Expression) -> Expression:
        self._out.cost += costs.NEGATE
        if value.kind == STRING:
            raise self._draft.mistake(Code.TM, value)
        if value.constant:
            return constant(-value.constant)
        if value.kind == SINGLE:
            # `0.0 -` keeps a zero from getting a sign, which the machine does not have.
            return Expression(f"(0.0 - {value.text})", SINGLE)
        if value.kind == DOUBLE:
            return Expression(f"double_negate({value.text})", DOUBLE)
        if value.condition is not None:
            return Expression(f"(0 + ({value.condition}))", INTEGER)
        kind = NUMBER if value.kind == INTEGER else value.kind
        return Expression(f"negate({value.text})", kind)

    def _constant(self) -> Expression:
        reader = self._reader
        meter = number_costs.LiteralMeter()
        try:
            value, end = literal.scan(reader.text, reader.position, meter=meter)
        except BasicError as error:
            self._out.cost += meter.total
            raise Mistake(error.code) from None
        reader.position = end
        self._out.cost += costs.constant(value, meter.total)
        if reader.text[end - 1] not in literal.TYPE_SIGNS:
            # Blanks behind a type sign are not passed: they end the expression.
            reader.skip()
        return self.convert.double_constant(value) if isinstance(value, Double) else constant(value)

    # -- variables ----------------------------------------------------------------------------

    def name(self) -> Key:
        """The name and kind of a variable; SN where no letter stands."""
        reader = self._reader
        if not characters.is_letter(reader.code):
            raise Mistake(Code.SN)
        first = reader.code
        name = chr(first)
        code = reader.advance()
        while code in characters.OF_NAMES:
            self._out.cost += costs.NAME_LETTER
            if len(name) < 2:
                name += chr(code)
            code = reader.advance()
        if code in _SIGNS:
            reader.advance()
            return name, _SIGNS[code]
        self._out.cost += costs.KIND_BY_LETTER
        return name, self._scope.default_kind(first)

    def _variable(self) -> Expression:
        key = self.name()
        if self._reader.code == OPEN:
            return self._element(key)
        scalar = self._scope.scalar(key)
        self._out.cost += costs.VARIABLE + self._scope.search(scalar) + costs.FETCH[key[1]]
        name = self._out.cell(self._scope.cell_name(key), scalar.cell)
        value = Expression(name, key[1], simple=True)
        if key[1] == STRING:
            return pieces.with_piece(value, pieces.variable(self._out, name), self._out)
        return value

    def _element(self, key: Key) -> Expression:
        array, subscripts = self.subscripts(key)
        if array is None:
            return Expression(f"element({self._out.constant(key)}, {listed(subscripts)})", key[1])
        text = f"{self.array(key)}[{self.index(array, subscripts).text}]"
        value = Expression(text, key[1])
        if key[1] == STRING:
            return pieces.with_piece(value, pieces.element(self._out, text), self._out)
        return value

    def array(self, key: Key) -> str:
        """The name of the elements of an array that exists."""
        return self._out.cell(self._scope.array_name(key), self._scope.array_cell(key))

    def subscripts(self, key: Key) -> tuple[Array | None, list[Expression]]:
        """The subscripts of an element, and the array if it exists with as many dimensions."""
        values = self.subscript_list()
        self._operand_end = self._reader.position
        array = self._scope.array(key, len(values))
        self._out.cost += costs.ARRAY + self._scope.array_search(key)
        if array is None:
            return None, [to_subscript(value) for value in values]
        return array, [self._checked(v, d) for v, d in zip(values, array.dims, strict=True)]

    def subscript_list(self, *, of_dim: bool = False) -> list[Expression]:
        """The values between `(` or `[` and `)` or `]`; SN for another end.

        Args:
            of_dim: whether they are sizes, whose conversion is reckoned with what makes the array.
        """
        values: list[Expression] = []
        draft = self._draft
        while True:
            self._reader.advance()
            taken = 0 if of_dim else room.SUBSCRIPT
            with draft.pending(*map(to_subscript, values)), draft.deeper(taken):
                value = self.number()
            self._out.cost += costs.SUBSCRIPT
            if not of_dim:
                self._out.cost += costs.CONVERT.get(value.held, 0)
            values.append(value)
            if self._reader.code != COMMA:
                break
        if self._reader.code not in (CLOSE, characters.CLOSE_BRACKET):
            raise draft.mistake(Code.SN, *map(to_subscript, values))
        self._reader.advance()
        return values

    def _checked(self, value: Expression, dim: int) -> Expression:
        """A subscript checked against its dimension; FC, BS or OV."""
        if value.constant is not None:
            number = int(value.constant // 1)
            if 0 <= number < dim:
                return constant(number)
        if value.kind in (DOUBLE, ANY):
            return Expression(f"bad({value.text}, {dim})", INTEGER)
        text = test = value.text
        if not value.simple:
            text = self._out.temporary()
            test = f"({text} := {value.text})"
        taken = text if value.kind == INTEGER else f"int({text})"
        return Expression(f"({taken} if 0 <= {test} < {dim} else bad({text}, {dim}))", INTEGER)

    @staticmethod
    def index(array: Array, subscripts: list[Expression]) -> Expression:
        """The place of an element in the list, the first subscript running fastest."""
        *others, last = subscripts
        if not others:
            return last
        text = last.text
        for subscript, dim in zip(reversed(others), reversed(array.dims[:-1]), strict=True):
            text = f"{subscript.text} + {dim} * ({text})"
        return Expression(text, INTEGER)


def to_subscript(value: Expression) -> Expression:
    """A number rounded down to 0..32767 when it is there (1E45H); OV, FC."""
    return Expression(f"subscript({value.text})", INTEGER)


def listed(values: list[Expression]) -> str:
    """The text of arguments."""
    return ", ".join(value.text for value in values)


def _string_relation(left: Expression, right: Expression, relation: str | None, depth: int) -> str:
    operands, equal, compare = f"{left.text}, {right.text}", "string_equal", "string_compare"
    if depth < pieces.MOST - 1 and pieces.plain(left) and pieces.plain(right):
        # No temporary comes or goes, and there is room for one more on each side.
        assert left.piece is not None
        assert right.piece is not None
        operands, equal, compare = f"{left.piece.text}, {right.piece.text}", "alike", "order"
    if relation is None:
        return f"always({compare}({operands}), 0)"
    if relation in ("==", "!="):
        negation = "not " if relation == "!=" else ""
        return f"{negation}{equal}({operands})"
    return f"{compare}({operands}) {relation} 0"
