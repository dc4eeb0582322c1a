"""Values on their way through the compiler: pieces of Python text with a type.

What an operand is, how it is converted to another type, and how arithmetic on single precision is
written. `expressions` puts them together.
"""

from __future__ import annotations

from dataclasses import dataclass

from trs80arm.basic import costs
from trs80arm.basic.compiler.emitter import Emitter
from trs80arm.basic.compiler.reader import Reader
from trs80arm.basic.compiler.scope import Scope
from trs80arm.basic.errors import Code
from trs80arm.basic.numbers import convert
from trs80arm.basic.numbers.double import Double
from trs80arm.basic.variables import DOUBLE, INTEGER, SINGLE

NUMBER = "n"
"""Kind of a value that is an integer or a single, known only when it is there."""
ANY = "x"
"""Kind of a number of any type, known only when it is there (VAL)."""

_DEEP = 6
"""Nesting from which on arithmetic is called, not written in line: Python's parser has limits."""


def is_closed(text: str) -> bool:
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
        whole: a single here, but the ROM holds an integer where the value fits into one (INT).
    """

    text: str
    kind: str
    condition: str | None = None
    constant: int | float | None = None
    simple: bool = False
    whole: bool = False

    @property
    def held(self) -> str:
        """The kind that the ROM holds, by which operations take their time."""
        return INTEGER if self.whole else self.kind

    @property
    def shown(self) -> str:
        """The text for PRINT and STR$, which take less time for integers."""
        return f"narrow({self.text})" if self.whole else self.text


def wider(left: str, right: str) -> str:
    """The kind of the result of arithmetic on two kinds."""
    kinds = {left, right}
    if DOUBLE in kinds:
        return DOUBLE
    if ANY in kinds:
        return ANY
    return SINGLE if SINGLE in kinds else NUMBER


class ValueCompiler:
    """The state of one statement's compilation, and the conversions of values.

    Attributes:
        reader: the place in the text.
        out: the function under construction.
        scope: the variables that exist, and what was assumed about them.
        pending: text of values that were read but are not in the function yet.
        observes: whether the statement looks at the machine.
        plain: whether the statement may stand anywhere in a block.
        stack_bytes: what the expression at work takes on the Z-80's stack.
    """

    def __init__(self, reader: Reader, out: Emitter, scope: Scope) -> None:
        self.reader = reader
        self.out = out
        self.scope = scope
        self.pending: list[str] = []
        self.depth = 0
        self.observes = False
        self.plain = True
        self.stack_bytes = 0
        self.deepest = 0

    def deepen(self, size: int) -> None:
        """The evaluation takes so many bytes more of the Z-80's stack (or gives them back)."""
        self.stack_bytes += size
        self.deepest = max(self.deepest, self.stack_bytes)

    # -- mistakes -----------------------------------------------------------------------------

    def mistake(self, code: Code) -> Mistake:
        """The exception to raise for an error that the text makes certain."""
        return Mistake(code)

    def expect(self, code: int) -> None:
        """A character that must stand here (RST 8); SN if another one does."""
        if self.reader.code != code:
            raise self.mistake(Code.SN)
        self.reader.advance()

    def single_arithmetic(self, name: str, left: Expression, right: Expression) -> str:
        """Single arithmetic: the common case in line, the rest by a call (`numbers.single`).

        The range test is on the square, so both signs take the short way.
        """
        if self.depth > _DEEP:
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
        self.out.cost += costs.CONVERT.get(value.held, 0)
        return f"floor({value.text})"

    def to_byte(self, value: Expression) -> str:
        """CINT of a number that must be 0..255."""
        if value.constant is not None and 0 <= value.constant < 256:
            return str(int(value.constant))
        if value.kind == INTEGER:
            return f"byte({value.text})"
        self.out.cost += costs.CONVERT.get(value.held, 0)
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
            return self.double_constant(convert.to_double(value.constant))
        return f"to_double({value.text})"

    def to_kind(self, value: Expression, kind: str) -> str:
        """A number as a variable of a kind takes it."""
        if kind == INTEGER:
            return self.to_integer(value)
        return self.to_single(value) if kind == SINGLE else self.to_double(value)

    def double_constant(self, value: Double) -> str:
        """The name of a double precision constant."""
        return self.scope.constant(value)
