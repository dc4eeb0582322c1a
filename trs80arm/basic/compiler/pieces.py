"""Strings put together in one go: what the characters of an expression are, as Python bytes.

Level II makes a new string for every function and every `+`, and copies it. All of them go to
string space one below the other, so that a whole expression is one stretch of bytes there: the
result, and above it what was thrown away on the way. A statement written with pieces works out the
characters first and stores that stretch once. Where that cannot be said
beforehand (no room without collecting, a string too long, temporaries left over) nothing has
happened yet, and the routines do it step by step.

A piece may stand for an expression only if working it out twice does no harm and cannot fail. So
numbers are taken out of it (`hoisted`) and evaluated before, which is the ROM's order as long as
nothing was stored before them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

from trs80arm.basic import addresses, costs
from trs80arm.basic.characters import LONGEST_STRING
from trs80arm.basic.compiler.emitter import Emitter
from trs80arm.basic.compiler.values import Expression
from trs80arm.basic.kinds import INTEGER, SINGLE

MOST: Final = 9
"""Variables, literals and functions in a piece; none can need more temporaries than there are."""
_SHOWN: Final = {INTEGER: "shown_integers", SINGLE: "shown_singles"}


@dataclass(frozen=True)
class Piece:
    """The characters of a string expression.

    Attributes:
        text: Python text of its characters, where `lines` have been executed.
        slow: Python text of its descriptor, by the routines.
        lines: what must be executed before.
        hoisted: names of numbers and descriptors, and the text of each, to be evaluated first.
        tests: what must be true before `lines` may be executed.
        present: names of characters that must not be empty.
        stored: what goes to string space, in this order: characters, or the text of some.
        extra: texts of T-states beside those of the bytes stored.
        known: the characters themselves, where they are known.
        place: where a literal stands in the program's text.
        joined: whether it is two strings one after the other.
        count: operands in it.
    """

    text: str
    slow: str
    lines: tuple[str, ...] = ()
    hoisted: tuple[tuple[str, str], ...] = ()
    tests: tuple[str, ...] = ()
    present: tuple[str, ...] = ()
    stored: tuple[str | bytes, ...] = ()
    extra: tuple[str, ...] = ()
    known: bytes | None = None
    place: int = 0
    joined: bool = False
    count: int = 1

    @property
    def certain(self) -> bool:
        """Whether the text of its characters holds for as long as nothing is stored in memory."""
        return not self.tests and (self.known is not None or bool(self.stored))


def literal(characters: bytes, call: str, place: int) -> Piece:
    """A string that stands in the program's text."""
    return Piece(repr(characters), call, known=characters, place=place)


def variable(out: Emitter, name: str) -> Piece:
    """A simple variable."""
    return Piece(out.strings.get(name, f"characters_of({name})"), name)


def element(out: Emitter, text: str) -> Piece:
    """An element of an array: found before, since its subscripts may be wrong."""
    name = out.temporary()
    return Piece(f"characters_of({name})", name, hoisted=((name, text),))


def plain(value: Expression) -> bool:
    """Whether an expression is a literal or a simple variable."""
    piece = value.piece
    return piece is not None and not (piece.stored or piece.lines or piece.hoisted)


def shown(out: Emitter, value: Expression) -> Piece | None:
    """STR$ of an integer or a single."""
    if value.kind not in _SHOWN or value.whole:
        return None
    name, hoisted = _number(out, value.text, simple=value.simple)
    characters, time = out.temporary(), out.temporary()
    return Piece(
        characters,
        f"shown({_SHOWN[value.kind]}[{name}])",
        lines=(f"{characters}, {time} = {_SHOWN[value.kind]}[{name}]",),
        hoisted=hoisted,
        stored=(characters,),
        extra=(time,),
    )


def character(out: Emitter, value: Expression) -> Piece:
    """CHR$ of a number that is 0 to 255."""
    name, hoisted = _number(out, value.text, simple=value.constant is not None)
    made = out.temporary()
    line = f"{made} = characters[{name}]"
    less = f"-{costs.STRING_BYTE}"
    return Piece(made, f"chr_({name})", (line,), hoisted, stored=(made,), extra=(less,))


def part(out: Emitter, calls: str, of: Expression, numbers: list[Expression]) -> Piece | None:
    """LEFT$, RIGHT$ or MID$ of a piece."""
    piece = of.piece
    if piece is None or piece.joined or piece.count == MOST:
        return None
    names: list[str] = []
    hoisted = piece.hoisted
    for number in numbers:
        name, before = _number(out, number.text, simple=number.constant is not None)
        if before and piece.stored:
            return None
        names.append(name)
        hoisted += before
    first, last = names[0], names[-1]
    tests = piece.tests
    if calls == "left":
        cut = f":{first}"
    elif calls == "right":
        cut = f"-{first}:"
    else:
        start = f"{first} - 1"
        cut = f"{start}:" if len(names) == 1 else f"{start}:{start} + {last}"
    slow = f"{calls}({', '.join((piece.slow, *names))})"
    if calls != "left":
        # RIGHT$(A$,0) and MID$(A$,0) are something else.
        if numbers[0].constant == 0:
            return None
        if numbers[0].constant is None:
            tests = (*tests, first)
    if piece.known is not None and all(number.constant is not None for number in numbers):
        known = _cut(calls, piece.known, [int(number.constant or 0) for number in numbers])
        if piece.stored and not known:
            return None
        stored = (*piece.stored, known)
        count = piece.count + 1
        return replace(piece, text=repr(known), slow=slow, stored=stored, known=known, count=count)
    made = out.temporary()
    return Piece(
        made,
        slow,
        lines=(*piece.lines, f"{made} = {piece.text}[{cut}]"),
        hoisted=hoisted,
        tests=tests,
        # A string thrown away for an empty one gives its bytes back.
        present=(*piece.present, made) if piece.stored else piece.present,
        stored=(*piece.stored, made),
        extra=piece.extra,
        count=piece.count + 1,
    )


def joined(out: Emitter, left: Expression, right: Expression) -> Piece | None:
    """Two strings one after the other."""
    a, b = left.piece, right.piece
    if a is None or b is None or a.count + b.count > MOST or (a.stored and b.hoisted):
        return None
    known = None if a.known is None or b.known is None else a.known + b.known
    made = out.temporary() if known is None else repr(known)
    lines = a.lines + b.lines
    return Piece(
        made,
        f"concatenate({a.slow}, {b.slow})",
        lines=(*lines, f"{made} = {a.text} + {b.text}") if known is None else lines,
        hoisted=a.hoisted + b.hoisted,
        tests=a.tests + b.tests,
        present=a.present + b.present,
        stored=(*a.stored, *b.stored, made if known is None else known),
        extra=a.extra + b.extra,
        known=known,
        joined=True,
        count=a.count + b.count,
    )


def _cut(calls: str, characters: bytes, numbers: list[int]) -> bytes:
    """LEFT$, RIGHT$ or MID$ of known characters; the first number is not 0 but for LEFT$."""
    if calls == "left":
        return characters[: numbers[0]]
    if calls == "right":
        return characters[-numbers[0] :]
    start = numbers[0] - 1
    return characters[start : start + numbers[1] if len(numbers) > 1 else None]


def _written(stored: tuple[str | bytes, ...]) -> str:
    """Text of all that is stored, the last first, as it lies in string space."""
    texts: list[str | bytes] = []
    for each in reversed(stored):
        if texts and isinstance(each, bytes) and isinstance(before := texts[-1], bytes):
            texts[-1] = before + each
        else:
            texts.append(each)
    return " + ".join(repr(each) if isinstance(each, bytes) else each for each in texts)


def _number(out: Emitter, text: str, *, simple: bool) -> tuple[str, tuple[tuple[str, str], ...]]:
    """A name or a constant for a number, and what must be evaluated before."""
    if simple:
        return text, ()
    name = out.temporary()
    return name, ((name, text),)


def _room(joined: str | None) -> str:
    """Text that is true where a string can be stored without more ado (`StringSpace`).

    Args:
        joined: characters that may be too many; how many is kept as `size`.
    """
    room = f"{addresses.PROGRAM} <= space.bottom <= low"
    short = f" and (size := len({joined})) <= {LONGEST_STRING}" if joined else ""
    return f"{room} and high < ram_end and not space.temporaries{short}"


def store(out: Emitter, target: str, piece: Piece) -> None:
    """Write LET of a piece that goes to string space.

    In one go where the bytes fit below those that are there, no temporary is left over, and the
    string is not too long; step by step where that is not so.
    """
    for name, text in piece.hoisted:
        out.emit(f"{name} = {text}")
    slow = f"assign({target}, {piece.slow})"
    kept = ""
    if piece.tests:
        kept = out.keep("False")
        out.emit(f"if {' and '.join(piece.tests)}:")
        out.indent += 1
    for line in piece.lines:
        out.emit(line)
    written = _written(piece.stored)
    if not written.isidentifier():
        written = out.keep(written)
    out.emit("high = space.next")
    out.emit(f"low = high - len({written})")
    room = _room(piece.text if piece.joined else None)
    length = f"len({piece.text})"
    if piece.joined:
        length = "size"
    elif written == piece.text:
        length = "high - low"
    out.emit(f"if {' and '.join((*piece.present, room))}:")
    out.indent += 1
    if kept:
        out.emit(f"{kept} = True")
    out.emit(f"view[low + 1 : high + 1] = {written}")
    out.emit("space.next = low")
    out.emit(f"{target}[0] = {length}")
    out.emit(f"{target}[1] = low + 1")
    out.charge_found(" + ".join((f"(high - low) * {costs.STRING_BYTE}", *piece.extra)))
    out.indent -= 1
    if kept:
        out.indent -= 1
    out.emit(f"if not {kept}:" if kept else "else:")
    out.indent += 1
    out.emit(slow)
    out.indent -= 1


def point_to(out: Emitter, target: str, piece: Piece) -> None:
    """Write LET of a literal: it stays where it stands, below string space."""
    assert piece.known is not None
    place = out.address(piece.place)
    out.emit(f"if {place} <= space.bottom and not space.temporaries:")
    out.emit(f"  {target}[0] = {len(piece.known)}")
    out.emit(f"  {target}[1] = {place}")
    out.emit("else:")
    out.indent += 1
    out.emit(f"assign({target}, {piece.slow})")
    out.indent -= 1


def with_piece(value: Expression, piece: Piece | None, out: Emitter) -> Expression:
    """An expression that may be written as a piece; flat functions know none."""
    return value if piece is None or out.flat else replace(value, piece=piece)
