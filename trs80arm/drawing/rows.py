"""Rows of drawn text: what every panel and view beside the tube is made of.

A row is a few spans, each a run of characters in one ink. Panels and canvases make rows without
knowing the screen; `ui/panels/panel.py` turns an ink into a colour of the theme.
"""

from __future__ import annotations

from enum import StrEnum
from typing import NamedTuple, TypeAlias


class Ink(StrEnum):
    """What a run of characters stands for. Its glyphs say the same without any colour."""

    PLAIN = "plain"
    FAINT = "faint"
    LABEL = "label"
    STRONG = "strong"
    ARM = "arm"
    HAND = "hand"
    PART = "part"
    FURNITURE = "furniture"
    GHOST = "ghost"
    TRAIL = "trail"
    WARNING = "warning"
    ALARM = "alarm"
    LAMP_ON = "lamp-on"
    LAMP_OFF = "lamp-off"
    METAL = "metal"
    TABLE = "table"
    SHADOW = "shadow"
    OBSTACLE = "obstacle"
    PART_2 = "part-2"
    PART_3 = "part-3"
    PART_4 = "part-4"
    PART_5 = "part-5"
    PART_6 = "part-6"


PARTS = (Ink.PART, Ink.PART_2, Ink.PART_3, Ink.PART_4, Ink.PART_5, Ink.PART_6)
"""The inks of parts, by the number of their colour."""
LEVELS = 12
"""How many steps of brightness a shaded ink has."""
DARKEST = 0.12
"""How much of an ink there is in its darkest shade; the rest is the ground behind it."""
LIGHT = 3 * 128
"""Red, green and blue of a ground, together, from which on a shadow has more ink, and not less."""


class Paint(NamedTuple):
    """An ink in light or shade, perhaps before another one.

    Attributes:
        ink: of the character.
        level: how bright, 0 to `LEVELS` - 1.
        under: what shows behind the character, None for the panel's own ground.
        under_level: how bright that is.
    """

    ink: Ink
    level: int
    under: Ink | None = None
    under_level: int = 0


Span: TypeAlias = tuple[str, Ink | Paint]
Row: TypeAlias = tuple[Span, ...]


def text_of(row: Row) -> str:
    """The characters of a row, without their inks."""
    return "".join(text for text, _ in row)


def fitted(row: Row, width: int) -> Row:
    """The row cut or filled up with blanks to exactly `width` cells."""
    spans: list[Span] = []
    room = width
    for text, ink in row:
        if room <= 0:
            break
        spans.append((text[:room], ink))
        room -= len(text)
    if room > 0:
        spans.append((" " * room, Ink.PLAIN))
    return tuple(spans)


def changed_part(before: Row, now: Row) -> tuple[int, Row]:
    """What differs in a row from one as long: the first cell's column, and the spans from there."""
    first, column, most = 0, 0, min(len(before), len(now))
    while first < most and before[first] == now[first]:
        column += len(now[first][0])
        first += 1
    last = 0
    while last < most - first and before[-1 - last] == now[-1 - last]:
        last += 1
    olds, news = list(before[first : len(before) - last]), list(now[first : len(now) - last])
    if olds and news and olds[0][1] == news[0][1]:
        (old, ink), (new, _) = olds[0], news[0]
        same = _alike(old, new)
        column += same
        olds[0], news[0] = (old[same:], ink), (new[same:], ink)
    if olds and news and olds[-1][1] == news[-1][1]:
        (old, ink), (new, _) = olds[-1], news[-1]
        same = _alike(old[::-1], new[::-1])
        news[-1] = new[: len(new) - same], ink
    return column, tuple(span for span in news if span[0])


def _alike(one: str, other: str) -> int:
    """How many characters two texts begin with alike."""
    pairs = enumerate(zip(one, other, strict=False))
    return next((at for at, (a, b) in pairs if a != b), min(len(one), len(other)))


def inked(characters: list[str], inks: list[Ink]) -> Row:
    """One row from a character and an ink for each cell, runs of one ink joined.

    A blank takes the ink of its left neighbour, so that it never begins a new span.
    """
    text = "".join(characters)
    end = len(text.rstrip())
    spans: list[Span] = []
    start, current = 0, Ink.PLAIN
    for place in range(end):
        ink = inks[place]
        if ink is not current and characters[place] != " ":
            if place > start:
                spans.append((text[start:place], current))
            start, current = place, ink
    if start < len(text):
        spans.append((text[start:], current))
    return tuple(spans)


def signed(value: float, digits: int) -> str:
    """A number with its sign and so many decimals; what rounds to zero is +0."""
    return f"{round(value, digits) + 0.0:+.{digits}f}"


def clock_text(seconds: float) -> str:
    """Virtual time as minutes, seconds and hundredths."""
    hundredths = int(seconds * 100)
    minutes, rest = divmod(hundredths, 6000)
    return f"{minutes}:{rest // 100:02d}.{rest % 100:02d}"
