"""Films as animated SVG: every run of characters once, with the times at which it is to be seen.

A run that stays from picture to picture is written once, however long it stays, so that a film in
which little moves is a small file. Times are SMIL's, which browsers know in pictures too; a viewer
that does not know them shows the first picture.
"""

from __future__ import annotations

from html import escape

from trs80arm.film.blocks import blocks_of
from trs80arm.film.frames import Film, Frame, Look

CELL_WIDTH, CELL_HEIGHT = 10, 20
FONT = "ui-monospace,SFMono-Regular,Menlo,Consolas,'DejaVu Sans Mono','Liberation Mono',monospace"
_BASELINE = 15
_LETTERS = 16.6
"""Size of letters that are a cell wide: monospaced ones are 0.6 of their size."""
_PAUSE = 1.5
"""Seconds for which the last picture stays before the film begins again."""

Piece = tuple[int, int, str, Look]
"""Row, column, text and look of a run."""


def svg(film: Film) -> bytes:
    """The film as an SVG file."""
    ground = _commonest_ground(film.frames[0])
    looks: dict[Look, int] = {}
    total = film.seconds + _PAUSE
    drawn = []
    for piece, spells in _spells(film, ground).items():
        look = looks.setdefault(piece[3], len(looks))
        drawn.append(_drawn(piece, look, ground, _timing(spells, total)))
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


def _timing(spells: list[tuple[float, float]], total: float) -> tuple[bool, str]:
    """Whether a run is there at first, and the SMIL that shows and hides it."""
    if spells == [(0.0, total)]:
        return True, ""
    at_first = spells[0][0] == 0.0
    timing = ""
    if at_first:
        timing = f'<set attributeName="display" to="none" {_during(spells[0][1], total)}/>'
    for start, end in spells[at_first:]:
        timing += f'<set attributeName="display" to="inline" {_during(start, end)}/>'
    return at_first, timing


def _during(start: float, end: float) -> str:
    return f'begin="f.begin+{start:.3g}s" dur="{end - start:.3g}s"'


def _drawn(piece: Piece, look: int, ground: str, timing: tuple[bool, str]) -> str:
    row, column, text, of = piece
    at_first, animation = timing
    x, y = column * CELL_WIDTH, row * CELL_HEIGHT
    wide = len(text) * CELL_WIDTH
    drawn = ""
    if of.ground != ground:
        drawn = f'<path class="g{look}" d="M{x} {y}h{wide}v{CELL_HEIGHT}h-{wide}z"/>'
    plain = "".join(" " if blocks_of(sign) else sign for sign in text)
    if plain.strip():
        drawn += (
            f'<text class="i{look}" x="{x}" y="{y + _BASELINE}" textLength="{wide}">'
            f"{escape(plain, quote=False)}</text>"
        )
    shapes = "".join(
        f"M{x + (place + left) * CELL_WIDTH:.5g} {y + top * CELL_HEIGHT:.5g}"
        f"h{across * CELL_WIDTH:.4g}v{down * CELL_HEIGHT:.4g}h-{across * CELL_WIDTH:.4g}z"
        for place, sign in enumerate(text)
        for left, top, across, down in blocks_of(sign)
    )
    if shapes:
        drawn += f'<path class="i{look}" d="{shapes}"/>'
    if not animation:
        return drawn
    hidden = "" if at_first else ' display="none"'
    return f"<g{hidden}>{drawn}{animation}</g>"
