"""Expressions: from the text of a line to Python text, in the order in which the ROM evaluates.

The ROM evaluates while it reads, so a mistake in the text shows only when what stands before it has
been evaluated. The compiler keeps that order: on a mistake it writes out what is pending and then
the error. Precedence and the odd corners (string `+` binds at once, `=<`, `NOT`) are the ROM's
(Level II facts, Expressions).
"""

from __future__ import annotations

from dataclasses import dataclass

from trs80arm.basic import costs, number_costs, room, tokens
from trs80arm.basic.compiler.emitter import Emitter
from trs80arm.basic.compiler.reader import Reader
from trs80arm.basic.compiler.scope import Scope
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import convert, literal
from trs80arm.basic.numbers.double import Double
from trs80arm.basic.variables import DOUBLE, INTEGER, SINGLE, SIZES, STRING, Array, Key

NUMBER = "n"
"""Kind of a value that is an integer or a single, known only when it is there."""
ANY = "x"
"""Kind of a number of any type, known only when it is there (VAL)."""

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
_DEEP = 6
"""Nesting from which on arithmetic is called, not written in line: Python's parser has limits."""


def _is_closed(text: str) -> bool:
    """Whether Python text needs no parentheses around it: a name, a number, a call, or `(...)`."""
    if text.isidentifier() or text.replace(".", "").isdigit():
        return True
    head = text.partition("(")[0]
    if not text.endswith(")") or not (head == "" or head.isidentifier()):
        return False
    depth = 0
    for place, char in enumerate(text):
        depth += (char == "(") - (char == ")")
        if char == ")" and not depth:
            return place == len(text) - 1
    return False


class Mistake(Exception):  # noqa: N818 - a way of leaving, not a failure of ours
    """The text is wrong from here on: the rest of the statement is this error."""

    def __init__(self, code: Code) -> None:
        super().__init__(code.name)
        self.code = code


@dataclass(frozen=True)
class Expression:
    """A piece of Python text that computes a value.

    Attributes:
        text: the Python expression.
        kind: INTEGER, SINGLE, DOUBLE, STRING, NUMBER or ANY.
        condition: the same as a Python truth value, where it is a comparison.
        constant: the value where it is known.
        simple: whether the text may be written twice without being computed twice.
    """

    text: str
    kind: str
    condition: str | None = None
    constant: int | float | None = None
    simple: bool = False


def wider(left: str, right: str) -> str:
    """The kind of the result of arithmetic on two kinds."""
    kinds = {left, right}
    if DOUBLE in kinds:
        return DOUBLE
    if ANY in kinds:
        return ANY
    return SINGLE if SINGLE in kinds else NUMBER


class ExpressionCompiler:
    """Reads expressions from a line and writes them as Python text.

    Attributes:
        reader: the place in the text.
        out: the function under construction.
        scope: the variables that exist, and what was assumed about them.
    """

    def __init__(self, reader: Reader, out: Emitter, scope: Scope) -> None:
        self.reader = reader
        self.out = out
        self.scope = scope
        self.pending: list[str] = []
        self._depth = 0
        self._operand_end = 0
        self.observes = False
        self.plain = True
        self.stack_bytes = 0
        self._deepest = 0

    def deepen(self, size: int) -> None:
        """The evaluation takes so many bytes more of the Z-80's stack (or gives them back)."""
        self.stack_bytes += size
        self._deepest = max(self._deepest, self.stack_bytes)

    # -- mistakes -----------------------------------------------------------------------------

    def mistake(self, code: Code) -> Mistake:
        """The exception to raise for an error that the text makes certain."""
        return Mistake(code)

    def expect(self, code: int) -> None:
        """A character that must stand here (RST 8); SN if another one does."""
        if self.reader.code != code:
            raise self.mistake(Code.SN)
        self.reader.advance()

    # -- whole expressions --------------------------------------------------------------------

    def expression(self) -> Expression:
        """An expression, up to the first character that does not belong to it."""
        self.reader.skip()
        outermost = not self._depth
        value = self._evaluate(0)
        if outermost and self.scope.tight:
            self.out.emit(f"room({room.EXPRESSION + self._deepest})")
            self._deepest = 0
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
        self._depth += 1
        if self._depth > _MAX_DEPTH:
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
        self._depth -= 1
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
            self.out.cost += costs.binary("compare", left.kind, right.kind)
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
            self.out.cost += costs.POWER
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
        self.out.cost += costs.binary(name, left.kind, right.kind)
        if name == "mul" and kind == SINGLE and right.constant:
            self.out.cost += number_costs.product_by(float(right.constant))
        if kind == DOUBLE:
            self.out.allow(costs.MOST_OF_DOUBLE)
            text = f"double_{name}({self.to_double(left)}, {self.to_double(right)})"
        elif kind == SINGLE:
            text = self._single(name, left, right)
        elif kind == NUMBER and left.kind == right.kind == INTEGER:
            text = f"integer_{name}({left.text}, {right.text})"
        else:
            text = f"any_{name}({left.text}, {right.text})"
        return Expression(text, kind)

    def _single(self, name: str, left: Expression, right: Expression) -> str:
        """Single arithmetic: the common case in line, the rest by a call (`numbers.single`).

        The range test is on the square, so both signs take the short way.
        """
        if self._depth > _DEEP:
            return f"{name}({self.as_float(left)}, {self.as_float(right)})"
        first, a = self._twice(left)
        second, b = self._twice(right)
        call = f"{name}({a}, {b})"
        if name in ("add", "sub"):
            sign = "+" if name == "add" else "-"
            return (
                f"(s if (c := (s := {first} {sign} {second}) * 536870913.0) - (c - s) == s"
                f" and 1e-74 < s * s < 1e74 else {call})"
            )
        sign, guard = ("*", "") if name == "mul" else ("/", f"{second} and ")
        if guard:
            if first != a:
                # The divisor is looked at first, but the dividend is evaluated before it.
                guard = f"({first} or True) and {guard}"
            first, second = a, b
        return (
            f"((c := s * 536870913.0) - (c - s) if {guard}1e-74 <"
            f" (s := {first} {sign} {second} * 1.0000000000000002) * s < 1e74 else {call})"
        )

    def _twice(self, value: Expression, name: str | None = None) -> tuple[str, str]:
        """Text that computes an operand, and text that gives it again."""
        text = self.as_float(value)
        if value.simple or value.constant is not None:
            return text, text
        name = name or self.out.temporary()
        return f"({name} := {text})", name

    # -- conversions --------------------------------------------------------------------------

    def to_integer(self, value: Expression) -> str:
        """CINT of a number."""
        if value.kind == INTEGER:
            return value.text
        if value.constant is not None and -32768 <= value.constant < 32768:
            return str(int(value.constant // 1))
        self.out.cost += costs.CONVERT[value.kind]
        return f"floor({value.text})"

    def to_byte(self, value: Expression) -> str:
        """CINT of a number that must be 0..255."""
        if value.constant is not None and 0 <= value.constant < 256:
            return str(int(value.constant))
        if value.kind == INTEGER:
            return f"byte({value.text})"
        self.out.cost += costs.CONVERT[value.kind]
        return f"byte(floor({value.text}))"

    def as_float(self, value: Expression) -> str:
        """A number as an operand of single arithmetic, where an `int` will do as well."""
        return repr(float(value.constant)) if value.constant is not None else value.text

    def to_single(self, value: Expression) -> str:
        """CSNG of a number."""
        if value.constant is not None:
            return repr(float(value.constant))
        if value.kind == SINGLE:
            return value.text
        if value.kind in (INTEGER, NUMBER):
            return f"float({value.text})"
        return f"to_single({value.text})"

    def to_double(self, value: Expression) -> str:
        """CDBL of a number."""
        if value.kind == DOUBLE:
            return value.text
        if value.constant is not None:
            return self._double_constant(convert.to_double(value.constant))
        return f"to_double({value.text})"

    def to_kind(self, value: Expression, kind: str) -> str:
        """A number as a variable of a kind takes it."""
        if kind == INTEGER:
            return self.to_integer(value)
        return self.to_single(value) if kind == SINGLE else self.to_double(value)

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
        text = value.text if _is_closed(value.text) else f"({value.text})"
        condition = value.condition
        if condition is not None and not _is_closed(condition):
            condition = f"({condition})"
        return Expression(text, value.kind, condition, value.constant, value.simple)

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
            raise self.mistake(error.code) from None
        reader.position = end
        self.out.cost += costs.constant(reader.text[start:end], value)
        if reader.text[end - 1 : end] not in (b"#", b"!", b"%"):
            # Blanks behind a type sign are not passed: they end the expression.
            reader.skip()
        if isinstance(value, Double):
            return Expression(self._double_constant(value), DOUBLE, simple=True)
        kind = INTEGER if isinstance(value, int) else SINGLE
        return Expression(repr(value), kind, constant=value, simple=True)

    def _double_constant(self, value: Double) -> str:
        return self.scope.constant(value)

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
            self.out.cost += costs.SUBSCRIPT + costs.CONVERT.get(value.kind, 0)
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
