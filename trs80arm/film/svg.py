"""Films as animated SVG: every run of characters once, with the times at which it is to be seen.

A run that stays from picture to picture is written once, however long it stays, so that a film in
which little moves is a small file; those of a row that look the same and come and go together are
written together. Times are SMIL's, which browsers know in pictures too; a viewer
that does not know them shows the first picture.
"""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

from trs80arm.film.blocks import blocks_of
from trs80arm.film.frames import Film, Frame, Look

CELL_WIDTH, CELL_HEIGHT = 10, 20
FONT = "ui-monospace,SFMono-Regular,Menlo,Consolas,'DejaVu Sans Mono','Liberation Mono',monospace"
_BASELINE = 15
_LETTERS = 16.6
"""Size of letters that are a cell wide: monospaced ones are 0.6 of their size."""
_NO_GAP = 1e-6
_PAUSE = 1.5
"""Seconds for which the last picture stays before the film begins again."""

Piece = tuple[int, int, str, Look]
"""Row, column, text and look of a run."""
Spells = tuple[tuple[float, float], ...]
"""When something is shown: beginnings and ends, in seconds of the film."""
Placed = tuple[int, str]
"""Column and text of one of several runs of a row that look the same."""
Rectangle = tuple[float, float, float, float]
"""Left, top, width and height."""


def svg(film: Film) -> bytes:
    """The film as an SVG file."""
    ground = _commonest_ground(film.frames[0])
    looks: dict[Look, int] = {}
    total = film.seconds + _PAUSE
    together: dict[tuple[int, Look, Spells], list[Placed]] = {}
    for (row, column, text, look), spells in _spells(film, ground).items():
        together.setdefault((row, look, tuple(spells)), []).append((column, text))
    drawn = []
    for (row, look, shown), runs in together.items():
        number = looks.setdefault(look, len(looks))
        behind = look.ground != ground
        drawn.append(_timed(_drawn(row, runs, number, behind=behind), _timing(shown, total)))
    width, height = film.width * CELL_WIDTH, film.height * CELL_HEIGHT
    styles = [
        f".i{number}{{fill:{look.ink}{';font-weight:bold' if look.bold else ''}}}"
        f".g{number}{{fill:{look.ground}}}"
        for look, number in looks.items()
    ]
    head = (
        '<svg xmlns="http://www.w3.org/2000/svg" xml:space="preserve" '
        f'viewBox="0 0 {width} {height}" '
        f'width="{width}" height="{height}" font-family="{escape(FONT)}" font-size="{_LETTERS}">'
        f"<title>{escape(film.title)}</title>"
        f"<style>text{{white-space:pre}}{''.join(styles)}</style>"
        f'<rect width="100%" height="100%" fill="{ground}">'
        f'<animate id="f" attributeName="x" from="0" to="0" begin="0;f.end" dur="{total:g}s"/>'
        "</rect>"
    )
    return "\n".join((head, *drawn, "</svg>\n")).encode("utf-8")


def _commonest_ground(frame: Frame) -> str:
    counts: dict[str, int] = {}
    for line in frame.lines:
        for text, look in line:
            counts[look.ground] = counts.get(look.ground, 0) + len(text)
    return max(counts, key=lambda ground: counts[ground])


def _pieces(frame: Frame, ground: str) -> set[Piece]:
    """What is to be seen of a picture: runs with something in them or behind them."""
    pieces = set()
    for row, line in enumerate(frame.lines):
        column = 0
        for text, look in line:
            lead = len(text) - len(text.lstrip(" ")) if look.ground == ground else 0
            seen = text.strip(" ") if look.ground == ground else text
            if seen:
                pieces.add((row, column + lead, seen, look))
            column += len(text)
    return pieces


def _spells(film: Film, ground: str) -> dict[Piece, list[tuple[float, float]]]:
    """When each run is shown; the spells of one that stays are one."""
    spells: dict[Piece, list[tuple[float, float]]] = {}
    shown = list(film.spells())
    for number, (start, end, frame) in enumerate(shown, 1):
        until = film.seconds + _PAUSE if number == len(shown) else end
        for piece in _pieces(frame, ground):
            mine = spells.setdefault(piece, [])
            if mine and mine[-1][1] == start:
                mine[-1] = (mine[-1][0], until)
            else:
                mine.append((start, until))
    return dict(sorted(spells.items(), key=lambda item: item[0][:3]))


def _timing(spells: Spells, total: float) -> tuple[bool, str]:
    """Whether a run is there at first, and the SMIL that shows and hides it."""
    if spells == ((0.0, total),):
        return True, ""
    at_first = spells[0][0] == 0.0
    timing = ""
    if at_first:
        timing = f'<set attributeName="display" to="none" {_during(spells[0][1], total)}/>'
    for start, end in spells[at_first:]:
        timing += f'<set attributeName="display" to="inline" {_during(start, end)}/>'
    return at_first, timing


def _during(start: float, end: float) -> str:
    """From one thousandth of a second to another, so that what follows begins where this ends."""
    first, last = round(start, 3), round(end, 3)
    return f'begin="f.begin+{first:g}s" dur="{round(last - first, 3):g}s"'


def _timed(drawn: str, timing: tuple[bool, str]) -> str:
    at_first, animation = timing
    if not animation:
        return drawn
    hidden = "" if at_first else ' display="none"'
    return f"<g{hidden}>{drawn}{animation}</g>"


def _drawn(row: int, runs: list[Placed], look: int, *, behind: bool) -> str:
    """Runs of a row in a look, which may have a ground of its own behind them."""
    y = row * CELL_HEIGHT
    drawn = ""
    if behind:
        grounds = [
            (column * CELL_WIDTH, y, len(text) * CELL_WIDTH, CELL_HEIGHT) for column, text in runs
        ]
        drawn = f'<path class="g{look}" d="{_outlines(grounds)}"/>'
    letters = ""
    for column, text in runs:
        plain = "".join(" " if blocks_of(sign) else sign for sign in text)
        letters = letters.ljust(column) + plain
    if words := letters.strip():
        first = len(letters) - len(letters.lstrip())
        drawn += (
            f'<text class="i{look}" x="{first * CELL_WIDTH}" y="{y + _BASELINE}" '
            f'textLength="{len(words) * CELL_WIDTH}">{escape(words, quote=False)}</text>'
        )
    shapes = [
        (
            (column + place + left) * CELL_WIDTH,
            y + top * CELL_HEIGHT,
            across * CELL_WIDTH,
            down * CELL_HEIGHT,
        )
        for column, text in runs
        for place, sign in enumerate(text)
        for left, top, across, down in blocks_of(sign)
    ]
    return f'{drawn}<path class="i{look}" d="{_outlines(shapes)}"/>' if shapes else drawn


def _outlines(rectangles: Iterable[Rectangle]) -> str:
    """Rectangles as a path; those that stand in a line without a gap are one."""
    joined: list[Rectangle] = []
    for left, top, width, height in sorted(rectangles, key=lambda one: (one[1], one[3], one[0])):
        if joined:
            before, at, wide, high = joined[-1]
            if (at, high) == (top, height) and abs(before + wide - left) < _NO_GAP:
                joined[-1] = (before, top, wide + width, height)
                continue
        joined.append((left, top, width, height))
    return "".join(
        f"M{left:.5g} {top:.5g}h{width:.5g}v{height:.4g}h-{width:.5g}z"
        for left, top, width, height in joined
    )
