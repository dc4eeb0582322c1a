"""Expressions: from the text of a line to Python text, in the order in which the ROM evaluates.

The ROM evaluates while it reads, so a mistake in the text shows only when what stands before it has
been evaluated. The compiler keeps that order: on a mistake it writes out what is pending and then
the error. Precedence and the odd corners (string `+` binds at once, `=<`, `NOT`) are the ROM's
(Level II facts, Expressions).
"""

from __future__ import annotations

from trs80arm.basic import costs, number_costs, room, tokens
from trs80arm.basic.compiler.values import (
    ANY,
    NUMBER,
    Expression,
    ValueCompiler,
    is_closed,
    wider,
)
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import literal
from trs80arm.basic.numbers.double import Double
from trs80arm.basic.variables import DOUBLE, INTEGER, SINGLE, SIZES, STRING, Array, Key

RELATION = 0x64
_UNARY_MINUS = 0x7D
_NOT = 0x5A
_PRECEDENCE = {
    tokens.PLUS: 0x79,
    tokens.MINUS: 0x79,
    tokens.TIMES: 0x7C,
    tokens.DIVIDE: 0x7C,
    tokens.POWER: 0x7F,
    tokens.AND: 0x50,
    tokens.OR: 0x46,
}
_RELATIONS = {1: ">", 2: "==", 3: ">=", 4: "<", 5: "!=", 6: "<="}
_MAX_DEPTH = 100
"""Nesting beyond which an expression is ?OM, as it is on the ROM when its stack is full."""


class ExpressionCompiler(ValueCompiler):
    """Reads expressions from a line and writes them as Python text."""

    _operand_end = 0
    """Where the operand read last ends, which string comparison goes back to."""

    # -- whole expressions --------------------------------------------------------------------

    def expression(self) -> Expression:
        """An expression, up to the first character that does not belong to it."""
        self.reader.skip()
        outermost = not self.depth
        value = self._evaluate(0)
        if outermost and self.scope.tight:
            self.out.emit(f"room({room.EXPRESSION + self.deepest})")
            self.deepest = 0
        return value

    def number(self) -> Expression:
        """An expression that must be a number; TM."""
        value = self.expression()
        if value.kind == STRING:
            self.pending.append(value.text)
            raise self.mistake(Code.TM)
        return value

    def string(self) -> Expression:
        """An expression that must be a string; TM."""
        value = self.expression()
        if value.kind != STRING:
            self.pending.append(value.text)
            raise self.mistake(Code.TM)
        return value

    def integer(self) -> str:
        """A number rounded down to an integer (2B02H); OV, TM."""
        return self.to_integer(self.number())

    def byte(self) -> str:
        """A number rounded down to 0..255 (2B1CH); FC, OV, TM."""
        value = self.to_byte(self.number())
        self.reader.skip()
        return value

    def flush(self) -> None:
        """Write what was read of an expression that turned out to be wrong."""
        for text in self.pending:
            if not text.isidentifier() and not text.replace(".", "").isdigit():
                self.out.emit(text)
        self.pending.clear()

    def _evaluate(self, precedence: int) -> Expression:
        self.depth += 1
        if self.depth > _MAX_DEPTH:
            raise self.mistake(Code.OM)
        left = self._operand()
        reader = self.reader
        self._operand_end = reader.position
        while True:
            mask = 0
            before = reader.state()
            while tokens.GREATER <= reader.code <= tokens.LESS:
                bits = mask ^ 1 << (reader.code - tokens.GREATER)
                if bits < mask:
                    self.pending.append(left.text)
                    raise self.mistake(Code.SN)
                mask = bits
                reader.advance()
            if mask:
                if precedence >= RELATION:
                    reader.restore(before)
                    break
                left = self._relation(left, mask)
                continue
            operator = reader.code
            if operator not in _PRECEDENCE:
                break
            if operator == tokens.PLUS and left.kind == STRING:
                left = self._concatenation(left)
                continue
            if _PRECEDENCE[operator] <= precedence:
                break
            left = self._operation(left, operator)
        self.depth -= 1
        return left

    def _right(self, left: Expression, precedence: int) -> Expression:
        """What stands to the right of an operator, while its left side is pending."""
        self.pending.append(left.text)
        size = room.OPERATOR + SIZES.get(left.kind, 4)
        self.deepen(size)
        right = self._evaluate(precedence)
        self.deepen(-size)
        self.pending.pop()
        return right

    def _relation(self, left: Expression, mask: int) -> Expression:
        right = self._right(left, RELATION)
        strings = (left.kind == STRING) + (right.kind == STRING)
        if strings == 1:
            self.pending += [left.text, right.text]
            raise self.mistake(Code.TM)
        relation = _RELATIONS.get(mask)
        if strings:
            # The ROM goes on behind the last operand it has noted (40F3H), and a concatenation
            # notes none of its own: "A"="B"+"C" compares, and then reads +"C" again.
            self.reader.position = self._operand_end
            self.out.cost += costs.COMPARE_STRINGS
            test = self._string_relation(left, right, relation)
        else:
            kind = wider(left.kind, right.kind)
            self.out.cost += costs.binary("compare", left.held, right.held)
            if kind == DOUBLE:
                test = f"double_compare({self.to_double(left)}, {self.to_double(right)})"
                test = f"{test} {relation} 0"
            elif kind == ANY:
                test = f"compare({left.text}, {right.text}) {relation} 0"
            else:
                test = f"{left.text} {relation} {right.text}"
            if relation is None:
                test = f"always({left.text}, {right.text})"
        self.out.cost += costs.OPERATOR
        return Expression(f"-({test})", INTEGER, condition=test)

    def _string_relation(self, left: Expression, right: Expression, relation: str | None) -> str:
        if relation is None:
            return f"always(string_compare({left.text}, {right.text}), 0)"
        if relation in ("==", "!="):
            negation = "not " if relation == "!=" else ""
            return f"{negation}string_equal({left.text}, {right.text})"
        return f"string_compare({left.text}, {right.text}) {relation} 0"

    def _concatenation(self, left: Expression) -> Expression:
        self.reader.advance()
        self.pending.append(left.text)
        right = self._operand()
        if right.kind != STRING:
            self.pending.append(right.text)
            raise self.mistake(Code.TM)
        self.pending.pop()
        self.plain = False
        self.out.cost += costs.CONCATENATE
        return Expression(f"concatenate({left.text}, {right.text})", STRING)

    def _operation(self, left: Expression, operator: int) -> Expression:
        if left.kind == STRING:
            self.pending.append(left.text)
            raise self.mistake(Code.TM)
        self.reader.advance()
        self.out.cost += costs.OPERATOR
        precedence = _PRECEDENCE[operator]
        if operator in (tokens.AND, tokens.OR):
            return self._logical(left, operator)
        right = self._right(left, precedence)
        if right.kind == STRING:
            self.pending += [left.text, right.text]
            raise self.mistake(Code.TM)
        if operator == tokens.POWER:
            self.out.allow(costs.MOST_OF_CALL)
            return Expression(f"power({self.to_single(left)}, {self.to_single(right)})", SINGLE)
        return self._arithmetic(left, operator, right)

    def _logical(self, left: Expression, operator: int) -> Expression:
        self.out.cost += costs.LOGICAL
        converted = self.to_integer(left)
        right = self._right(Expression(converted, INTEGER), _PRECEDENCE[operator])
        if right.kind == STRING:
            self.pending += [converted, right.text]
            raise self.mistake(Code.TM)
        sign = "&" if operator == tokens.AND else "|"
        if left.condition is not None and right.condition is not None:
            both = f"(({left.condition}) {sign} ({right.condition}))"
            return Expression(f"-{both}", INTEGER, condition=both)
        return Expression(f"({converted} {sign} {self.to_integer(right)})", INTEGER)

    def _arithmetic(self, left: Expression, operator: int, right: Expression) -> Expression:
        kind = wider(left.kind, right.kind)
        name = {
            tokens.PLUS: "add",
            tokens.MINUS: "sub",
            tokens.TIMES: "mul",
            tokens.DIVIDE: "div",
        }[operator]
        if kind == NUMBER and operator == tokens.DIVIDE:
            kind = SINGLE
        self.out.cost += costs.binary(name, left.held, right.held)
        held = {left.held, right.held} - {INTEGER, NUMBER}
        if name == "mul" and kind == SINGLE and right.constant and held:
            self.out.cost += number_costs.product_by(float(right.constant))
        if kind == DOUBLE:
            self.out.allow(costs.MOST_OF_CALL)
            text = f"double_{name}({self.to_double(left)}, {self.to_double(right)})"
        elif kind == SINGLE:
            text = self.single_arithmetic(name, left, right)
        elif kind == NUMBER and left.kind == right.kind == INTEGER:
            text = f"integer_{name}({left.text}, {right.text})"
        else:
            text = f"any_{name}({left.text}, {right.text})"
        whole = kind == SINGLE and name != "div" and not held
        return Expression(text, kind, whole=whole)

    # -- operands -----------------------------------------------------------------------------

    def _operand(self) -> Expression:
        reader = self.reader
        code = reader.code
        out = self.out
        out.cost += costs.OPERAND
        if code in (0, 0x3A):
            raise self.mistake(Code.MO)
        if 0x30 <= code <= 0x39 or code == 0x2E:
            return self._constant()
        if 0x41 <= code <= 0x5A:
            return self._variable()
        if code == tokens.PLUS:
            reader.advance()
            return self._operand()
        if code == tokens.MINUS:
            reader.advance()
            return self._negated(self._nested(_UNARY_MINUS))
        if code == 0x22:
            length, address = reader.string_literal()
            out.cost += costs.STRING_LITERAL + costs.STRING_CHARACTER * length
            return Expression(f"literal({length}, {address})", STRING)
        if code == tokens.NOT:
            reader.advance()
            value = self._nested(_NOT)
            if value.kind == STRING:
                self.pending.append(value.text)
                raise self.mistake(Code.TM)
            out.cost += costs.LOGICAL
            if value.condition is not None:
                test = f"(not {value.condition})"
                return Expression(f"-{test}", INTEGER, condition=test)
            return Expression(f"~{self.to_integer(value)}", INTEGER)
        if code == 0x26:
            raise self.mistake(Code.L3)
        if code in tokens.FUNCTIONS:
            return self.function(code)
        out.cost += costs.PARENTHESES
        if code != 0x28:
            raise self.mistake(Code.SN)
        reader.advance()
        self.deepen(room.PARENTHESIS)
        value = self.expression()
        self.deepen(-room.PARENTHESIS)
        self.close_parenthesis(value.text)
        text = value.text if is_closed(value.text) else f"({value.text})"
        condition = value.condition
        if condition is not None and not is_closed(condition):
            condition = f"({condition})"
        return Expression(
            text, value.kind, condition, value.constant, value.simple, whole=value.whole
        )

    def _nested(self, precedence: int) -> Expression:
        """The operand of a sign or a NOT."""
        self.deepen(room.PARENTHESIS)
        value = self._evaluate(precedence)
        self.deepen(-room.PARENTHESIS)
        return value

    def close_parenthesis(self, *pending: str) -> None:
        """A `)` behind what is pending; SN."""
        if self.reader.code != 0x29:
            self.pending += pending
            raise self.mistake(Code.SN)
        self.reader.advance()

    def function(self, code: int) -> Expression:
        """An operand that begins with a word (see `functions`)."""
        raise TypeError(f"no functions here: {code}")

    def _negated(self, value: Expression) -> Expression:
        self.out.cost += costs.NEGATE
        if value.kind == STRING:
            self.pending.append(value.text)
            raise self.mistake(Code.TM)
        if value.constant is not None and value.constant:
            negative = -value.constant
            return Expression(f"({negative!r})", value.kind, constant=negative, simple=True)
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
        reader = self.reader
        start = reader.position
        try:
            value, end = literal.scan(reader.text, start)
        except BasicError as error:
            self.out.cost += number_costs.literal(reader.text[start:])
            raise self.mistake(error.code) from None
        reader.position = end
        self.out.cost += costs.constant(reader.text[start:end], value)
        if reader.text[end - 1 : end] not in (b"#", b"!", b"%"):
            # Blanks behind a type sign are not passed: they end the expression.
            reader.skip()
        if isinstance(value, Double):
            return Expression(self.double_constant(value), DOUBLE, simple=True)
        kind = INTEGER if isinstance(value, int) else SINGLE
        return Expression(repr(value), kind, constant=value, simple=True)

    def _variable(self) -> Expression:
        key = self.name()
        if self.reader.code == 0x28:
            return self._element(key)
        scalar = self.scope.scalar(key)
        self.out.cost += costs.VARIABLE + self.scope.search(scalar) + costs.FETCH[key[1]]
        name = self.out.cell(self.scope.cell_name(key), scalar.cell)
        return Expression(name, key[1], simple=True)

    def name(self) -> Key:
        """The name and kind of a variable; SN where no letter stands."""
        reader = self.reader
        if not 0x41 <= reader.code <= 0x5A:
            raise self.mistake(Code.SN)
        first = reader.code
        name = chr(first)
        code = reader.advance()
        while 0x30 <= code <= 0x39 or 0x41 <= code <= 0x5A:
            self.out.cost += costs.NAME_LETTER
            if len(name) < 2:
                name += chr(code)
            code = reader.advance()
        kind = {0x25: INTEGER, 0x24: STRING, 0x21: SINGLE, 0x23: DOUBLE}.get(code)
        if kind is not None:
            reader.advance()
            return name, kind
        self.out.cost += costs.KIND_BY_LETTER
        return name, self.scope.default_kind(first)

    def _element(self, key: Key) -> Expression:
        array, subscripts = self.subscripts(key)
        if array is None:
            arguments = ", ".join(subscripts)
            return Expression(f"element({key!r}, {arguments})", key[1])
        name = self.out.cell(self.scope.array_name(key), self.scope.array_cell(key))
        return Expression(f"{name}[{self.index(array, subscripts)}]", key[1])

    def subscripts(self, key: Key) -> tuple[Array | None, list[str]]:
        """The subscripts of an element, and the array if it exists with as many dimensions."""
        values: list[Expression] = []
        kept = len(self.pending)
        while True:
            self.reader.advance()
            self.deepen(room.SUBSCRIPT)
            value = self.number()
            self.deepen(-room.SUBSCRIPT)
            self.out.cost += costs.SUBSCRIPT + costs.CONVERT.get(value.held, 0)
            values.append(value)
            self.pending.append(f"subscript({value.text})")
            if self.reader.code != 0x2C:
                break
        if self.reader.code not in (0x29, 0x5D):
            raise self.mistake(Code.SN)
        self.reader.advance()
        self._operand_end = self.reader.position
        del self.pending[kept:]
        array = self.scope.array(key, len(values))
        self.out.cost += costs.ARRAY + self.scope.array_search(key)
        if array is None:
            return None, [f"subscript({value.text})" for value in values]
        return array, [self._subscript(v, d) for v, d in zip(values, array.dims, strict=True)]

    def _subscript(self, value: Expression, dim: int) -> str:
        """A subscript checked against its dimension; FC, BS or OV."""
        if value.constant is not None:
            number = int(value.constant // 1)
            if 0 <= number < dim:
                return str(number)
        text = value.text
        if value.kind == INTEGER:
            if not value.simple:
                text = self.out.temporary()
                return f"({text} if 0 <= ({text} := {value.text}) < {dim} else bad({text}, {dim}))"
            return f"({text} if 0 <= {text} < {dim} else bad({text}, {dim}))"
        if value.kind in (DOUBLE, ANY):
            return f"bad({text}, {dim})"
        test = text
        if not value.simple:
            text = self.out.temporary()
            test = f"({text} := {value.text})"
        return f"(int({text}) if 0 <= {test} < {dim} else bad({text}, {dim}))"

    @staticmethod
    def index(array: Array, subscripts: list[str]) -> str:
        """The place of an element in the list, the first subscript running fastest."""
        text = subscripts[-1]
        for subscript, dim in zip(
            reversed(subscripts[:-1]), reversed(array.dims[:-1]), strict=True
        ):
            text = f"{subscript} + {dim} * ({text})"
        return text
