"""One way through a program: what is known on it at a statement."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Final

from trs80arm.basic import tokens
from trs80arm.basic.characters import FIRST_LETTER
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.kinds import DOUBLE, INTEGER, SINGLE, STRING, Kind
from trs80arm.basic.numbers import convert
from trs80arm.check.expressions import Call, Expression, Literal, Operation, Relation, Variable
from trs80arm.check.reach import Reach
from trs80arm.check.values import (
    CURVED,
    FUNCTIONS,
    NO_ITEMS,
    OPERATIONS,
    Failure,
    Held,
    Items,
    Unknown,
    Value,
    compared,
)

Key = tuple[str, Kind]
KINDS: Final = {"%": INTEGER, "!": SINGLE, "#": DOUBLE, "$": STRING}
ZERO: Final = Value(0)
_EMPTY: Final = Value(b"")
_LETTERS: Final = 26
_LARGEST_NAME: Final = 30
"""Names in that of an unknown; one that would have more is another unknown."""


@dataclass(frozen=True, slots=True)
class Subroutine:
    """An open GOSUB, and where its RETURN goes."""

    back: int


@dataclass(frozen=True, slots=True)
class Loop:
    """An open FOR."""

    variable: Key
    limit: Value
    step: Value
    body: int


@dataclass(frozen=True, slots=True)
class Doubt:
    """A decision by computed DATA that may be the program's refusal of a point.

    Attributes:
        before: the way as it was there.
        other: where it would have gone on with the other outcome.
        items: that were decided on.
        line: of the decision.
    """

    before: Path
    other: int
    items: Items
    line: int


@dataclass(frozen=True, slots=True)
class Suspicion:
    """DATA that the program turns away, if it would have moved the arm by them.

    Attributes:
        items: of DATA.
        text: how, in words.
    """

    items: Items
    text: str


@dataclass
class Path:
    """A way, and all that is known on it.

    Attributes:
        reach: of the arm.
        place: of the next statement.
        variables, arrays: by name; of arrays the elements that were set, by subscripts.
        blurred: arrays of which an unknown element was set, and by which DATA.
        types: kinds by first letter.
        frames: open loops and subroutines.
        registers: J1 to J6.
        next_item: of DATA.
        read_in: by item, which READ on this way took it.
        read_into: by item, the name of the variable that took it.
        reads: how many there were.
        motions: how many there were.
        loaded: by item, after how many motions it was last looked at as it was read.
        curved: items that went through geometry.
        facts: of unknowns, what has been decided.
        visits: by place, how often something unknown was decided there, and the last outcome.
        sure: whether nothing unknown was decided.
        trapped: whether an ON ERROR is on.
        printed: whether something was printed since the last doubt.
        doubt: the last decision that may be a refusal.
        suspicion: DATA that are taken for in order, against the program's own decision.
        forgiven: all DATA of which that was so.
        bad: DATA by which the arm cannot go where it is sent, and why.
        good: DATA by which it was sent where it can go.
        idle: statements since something new was learned.
    """

    reach: Reach
    place: int = 0
    variables: dict[Key, Value] = field(default_factory=dict)
    arrays: dict[Key, dict[tuple[int, ...], Value]] = field(default_factory=dict)
    blurred: dict[Key, Items] = field(default_factory=dict)
    types: list[Kind] = field(default_factory=lambda: [SINGLE] * _LETTERS)
    frames: list[Subroutine | Loop] = field(default_factory=list)
    registers: list[Value] = field(default_factory=lambda: [ZERO] * 6)
    next_item: int = 0
    read_in: dict[int, int] = field(default_factory=dict)
    read_into: dict[int, str] = field(default_factory=dict)
    reads: int = 0
    motions: int = 0
    loaded: dict[int, int] = field(default_factory=dict)
    curved: set[int] = field(default_factory=set)
    facts: dict[Any, Held] = field(default_factory=dict)
    visits: dict[int, tuple[int, bool]] = field(default_factory=dict)
    sure: bool = True
    trapped: bool = False
    printed: bool = False
    doubt: Doubt | None = None
    suspicion: Suspicion | None = None
    forgiven: Items = NO_ITEMS
    bad: dict[Items, str] = field(default_factory=dict)
    good: set[Items] = field(default_factory=set)
    idle: int = 0
    _fresh: int = 0

    def copy(self) -> Path:
        """The same, to go on another way."""
        other = Path.__new__(Path)
        for name, value in self.__dict__.items():
            other.__dict__[name] = _COPIES.get(name, _same)(value)
        return other

    def latest(self, items: Items) -> Items:
        """Of the DATA that something was computed from those that it is now about.

        A position that a program keeps was computed from all points before; this one's coordinates
        were looked at, as they were read, since the last motion.
        """
        last = max((self.loaded.get(each, -1) for each in items), default=-1)
        now = [each for each in items if self.loaded.get(each, -1) == last]
        # A later READ of the same variable is another point.
        now.sort(key=lambda each: self.read_in[each])
        return frozenset({self.read_into[each]: each for each in now}.values())

    # -- values -------------------------------------------------------------------------------

    def unknown(self, items: Items = NO_ITEMS) -> Value:
        """A value that is known from nothing."""
        self._fresh += 1
        return Value(Unknown(self._fresh), items)

    def key(self, variable: Variable) -> Key:
        """The name and kind of a variable."""
        kind = KINDS.get(variable.kind)
        return variable.name, kind or self.types[ord(variable.name[0]) - FIRST_LETTER]

    def value(self, expression: Expression) -> Value:
        """The value of an expression.

        Raises:
            Failure: it is an error.
        """
        match expression:
            case Literal(held):
                return Value(held)
            case Variable():
                value = self._load(expression)
                if value.as_read:
                    for item in value.items:
                        self.loaded[item] = self.motions
                return value
            case Operation(operator, None, right):
                return self._signed(operator, self.value(right))
            case Operation(operator, left, right):
                assert left is not None
                return self._operation(operator, self.value(left), self.value(right))
            case Relation(mask, left, right):
                a, b = self.value(left), self.value(right)
                items = a.items | b.items
                if a.known and b.known:
                    return self._made(items, compared, mask, a.held, b.held)
                return self._named(items, Relation, mask, a.held, b.held)
            case Call(function, arguments):
                return self._call(function, [self.value(each) for each in arguments])

    def _made(self, items: Items, make: Callable[..., Held], *operands: object) -> Value:
        try:
            return Value(make(*operands), items)
        except BasicError as error:
            if self.suspicion is not None and items & self.suspicion.items:
                # The point is taken for in order, so this is some number.
                return self.unknown(items)
            raise Failure(error.code, items) from None

    def _named(self, items: Items, operation: object, *operands: Held) -> Value:
        size = 1 + sum(each.size for each in operands if isinstance(each, Unknown))
        if size > _LARGEST_NAME:
            return self.unknown(items)
        name = (operation, *operands)
        known = self.facts.get(name)
        return Value(Unknown(name, size) if known is None else known, items)

    def _signed(self, operator: int, value: Value) -> Value:
        if not value.known:
            return self._named(value.items, operator, value.held)
        if operator == tokens.NOT:
            return self._made(value.items, lambda a: ~convert.to_integer(a), value.held)
        return self._made(value.items, _negated, value.held)

    def _operation(self, operator: int, a: Value, b: Value) -> Value:
        items = a.items | b.items
        if items and (
            (operator == tokens.TIMES and a.items and b.items)
            or (operator == tokens.DIVIDE and b.items)
            or operator == tokens.POWER
        ):
            self.curved |= items
        if a.known and b.known:
            return self._made(items, OPERATIONS[operator], a.held, b.held)
        return self._named(items, operator, a.held, b.held)

    def _call(self, function: int, arguments: list[Value]) -> Value:
        items = NO_ITEMS.union(*(each.items for each in arguments))
        if function in CURVED:
            self.curved |= items
        make = FUNCTIONS.get(function)
        if make is None:
            return self.unknown(items)
        held = [each.held for each in arguments]
        if all(each.known for each in arguments):
            return self._made(items, make, *held)
        return self._named(items, function, *held)

    def integer(self, expression: Expression) -> Value:
        """The value of an expression, rounded down to an integer."""
        value = self.value(expression)
        if not value.known:
            return value
        return self._made(value.items, convert.to_integer, value.held)

    # -- variables ----------------------------------------------------------------------------

    def _load(self, variable: Variable) -> Value:
        key = self.key(variable)
        blank = _EMPTY if key[1] is STRING else ZERO
        if variable.subscripts is None:
            return self._fact(self.variables.get(key, blank))
        place, items = self._place(variable.subscripts)
        if key in self.blurred or place is None:
            elements = self.arrays.get(key, {}).values()
            all_items = NO_ITEMS.union(*(each.items for each in elements))
            return self.unknown(items | all_items | self.blurred.get(key, NO_ITEMS))
        return self._fact(self.arrays.get(key, {}).get(place, blank))

    def _fact(self, value: Value) -> Value:
        if isinstance(value.held, Unknown) and value.held.name in self.facts:
            return Value(self.facts[value.held.name], value.items)
        return value

    def _place(self, subscripts: tuple[Expression, ...]) -> tuple[tuple[int, ...] | None, Items]:
        values = [self.integer(each) for each in subscripts]
        items = NO_ITEMS.union(*(each.items for each in values))
        if not all(each.known for each in values):
            return None, items
        return tuple(convert.to_integer(each.held) for each in values), items

    def store(self, variable: Variable, value: Value) -> None:
        """Give a variable a value.

        Raises:
            Failure: it does not take it.
        """
        key = self.key(variable)
        if value.known:
            value = self._fitting(key[1], value)
        if variable.subscripts is None:
            self.variables[key] = value
            return
        place, items = self._place(variable.subscripts)
        if place is None:
            self.blurred[key] = self.blurred.get(key, NO_ITEMS) | items | value.items
        else:
            self.arrays.setdefault(key, {})[place] = value

    def _fitting(self, kind: Kind, value: Value) -> Value:
        if kind is STRING:
            if not isinstance(value.held, bytes):
                raise Failure(Code.TM)
            return value
        made = self._made(value.items, convert.to_kind, kind, value.held)
        return Value(made.held, value.items, value.as_read)


def _negated(held: Held) -> Held:
    if isinstance(held, (bytes, Unknown)):
        raise BasicError(Code.TM)
    return convert.negate(held)


def _same(value: Any) -> Any:
    return value


_COPIES: Final[dict[str, Callable[[Any], Any]]] = {
    **dict.fromkeys(
        (
            *("reach", "variables", "blurred", "types", "frames", "registers"),
            *("read_in", "read_into", "loaded", "curved", "facts", "visits", "bad", "good"),
        ),
        lambda value: value.copy(),
    ),
    "arrays": lambda arrays: {key: elements.copy() for key, elements in arrays.items()},
}
"""How what a way may change is copied; the rest is never changed itself."""
