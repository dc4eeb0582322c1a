"""Values on their way through the compiler: pieces of Python text with what is known of them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from trs80arm.basic import costs
from trs80arm.basic.compiler import rounding
from trs80arm.basic.compiler.emitter import Emitter
from trs80arm.basic.kinds import ANY, DOUBLE, INTEGER, NUMBER, SINGLE, Kind
from trs80arm.basic.numbers import convert
from trs80arm.basic.numbers.double import Double

if TYPE_CHECKING:
    from trs80arm.basic.compiler.pieces import Piece

_DEEP = 6
"""Nesting from which on arithmetic is called, not written in line: Python's parser has limits."""


@dataclass(frozen=True)
class Expression:
    """A piece of Python text that computes a value.

    Attributes:
        text: the Python expression.
        kind: the kind of its value.
        condition: the same as a Python truth value, where it is a comparison.
        constant: the value where it is known.
        simple: whether the text is a name or a number: it may be written twice without being
            computed twice, or left out without being missed.
        whole: a single here, but the ROM holds an integer where the value fits into one (INT).
        piece: the characters of a string, where it can be put together in one go.
    """

    text: str
    kind: Kind
    condition: str | None = None
    constant: int | float | None = None
    simple: bool = False
    whole: bool = False
    piece: Piece | None = None

    @property
    def held(self) -> Kind:
        """The kind that the ROM holds, by which operations take their time."""
        return INTEGER if self.whole else self.kind

    @property
    def shown(self) -> str:
        """The text for PRINT and STR$, which take less time for integers."""
        return f"narrow({self.text})" if self.whole else self.text


def settled(out: Emitter, value: Expression) -> Expression:
    """In a flat function the value in a local name: computed now, and never nested in another."""
    if not out.flat or value.simple:
        return value
    return replace(value, text=out.keep(value.text), condition=None, simple=True)


def constant(value: int | float) -> Expression:
    """A number that is known."""
    kind = INTEGER if isinstance(value, int) else SINGLE
    text = repr(value) if value >= 0 else f"({value!r})"
    return Expression(text, kind, constant=value, simple=True)


def wider(left: Kind, right: Kind) -> Kind:
    """The kind of the result of arithmetic on two kinds."""
    kinds = {left, right}
    for kind in (DOUBLE, ANY, SINGLE):
        if kind in kinds:
            return kind
    return NUMBER


class Conversions:
    """Values made values of another type, and arithmetic on singles.

    Args:
        out: the function under construction.
    """

    def __init__(self, out: Emitter) -> None:
        self._out = out

    def to_integer(self, value: Expression) -> Expression:
        """CINT of a number."""
        if value.kind == INTEGER:
            return value
        if value.constant is not None and -32768 <= value.constant < 32768:
            return constant(int(value.constant // 1))
        self._out.cost += costs.CONVERT.get(value.held, 0)
        return Expression(f"floor({value.text})", INTEGER)

    def to_byte(self, value: Expression) -> Expression:
        """CINT of a number that must be 0..255."""
        if value.constant is not None and 0 <= value.constant < 256:
            return constant(int(value.constant))
        if value.kind == INTEGER:
            return Expression(f"byte({value.text})", INTEGER)
        self._out.cost += costs.CONVERT.get(value.held, 0)
        return Expression(f"byte(floor({value.text}))", INTEGER)

    def to_single(self, value: Expression) -> Expression:
        """CSNG of a number."""
        if value.kind == SINGLE:
            return value
        if value.constant is not None:
            return constant(float(value.constant))
        convert_ = "float" if value.kind in (INTEGER, NUMBER) else "to_single"
        return Expression(f"{convert_}({value.text})", SINGLE)

    def to_double(self, value: Expression) -> Expression:
        """CDBL of a number."""
        if value.kind == DOUBLE:
            return value
        if value.constant is not None:
            return self.double_constant(convert.to_double(value.constant))
        return Expression(f"to_double({value.text})", DOUBLE)

    def to_kind(self, value: Expression, kind: Kind) -> Expression:
        """A number as a variable of a kind takes it."""
        if kind == INTEGER:
            return self.to_integer(value)
        return self.to_single(value) if kind == SINGLE else self.to_double(value)

    def double_constant(self, value: Double) -> Expression:
        """A double that is known."""
        return Expression(self._out.constant(value), DOUBLE, simple=True)

    # -- arithmetic ---------------------------------------------------------------------------

    def single_arithmetic(self, name: str, left: Expression, right: Expression, depth: int) -> str:
        """Text of an operation on singles: the common case in line, the rest by a call.

        Args:
            name: `add`, `sub`, `mul` or `div`.
            left: a single, or an integer, which will do as well.
            right: another.
            depth: how deeply the operation is nested.
        """
        if depth > _DEEP:
            return f"{name}({_as_float(left)}, {_as_float(right)})"
        first, a = self._twice(left)
        second, b = self._twice(right)
        call = f"{name}({a}, {b})"
        if name in ("add", "sub"):
            known = [value.constant for value in (left, right) if value.constant is not None]
            sign = "+" if name == "add" else "-"
            near = any(rounding.is_near(number) for number in known)
            return rounding.rounded_sum(first, sign, second, (a, b), call, near=near)
        if name == "mul":
            return rounding.product(first, "*", second, call)
        if right.constant:
            return rounding.product(first, "/", second, call)
        guard = f"{second} and "
        if first != a:
            # The divisor is looked at first, but the dividend is evaluated before it.
            guard = f"({first} or True) and {guard}"
        return rounding.product(a, "/", b, call, guard)

    def _twice(self, value: Expression) -> tuple[str, str]:
        """Text that computes an operand, and text that gives it again."""
        text = _as_float(value)
        if value.simple:
            return text, text
        name = self._out.temporary()
        return f"({name} := {text})", name


def _as_float(value: Expression) -> str:
    return repr(float(value.constant)) if value.constant is not None else value.text
