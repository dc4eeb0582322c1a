"""From the samples of a picture to cells of characters: what every style of drawing shares.

A style says how many samples a cell has and which character and paints the cells get; here are the
cells as arrays, and the rows of text that come of them.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Any, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from trs80arm.drawing.materials import INKS
from trs80arm.drawing.raster import Nearness, Seen
from trs80arm.drawing.rows import LEVELS, Ink, Paint, Row
from trs80arm.drawing.solids import Floats, Ints

_Number = TypeVar("_Number", bound=np.generic)
Text: TypeAlias = tuple[int, int, str, Ink]
"""What is written on a sheet: column and row of its first character, the text and its ink."""
SheetShape: TypeAlias = tuple[int, int]
"""Height and width of a sheet of cells."""
NO_INK = -1
"""The ink of a sample that shows nothing."""
NEVER = np.finfo(np.float32).max
"""Where something fades that looks alike however far away it is."""


@dataclass(frozen=True, slots=True, eq=False)
class Looks:
    """How all that samples may show looks, by a number for each.

    Attributes:
        ink: index of the ink, or `NO_INK`.
        light: how bright, 0 to 1.
        body: the thing that is seen; 0 the table, negative for nothing.
        fades: inches behind the picture's plane at which it has half its brightness, `NEVER` for
            what has all of it everywhere; None if all is such.
    """

    ink: npt.NDArray[np.int8]
    light: npt.NDArray[np.float32]
    body: npt.NDArray[np.int16]
    fades: npt.NDArray[np.float32] | None = None


class Samples:
    """What a picture shows, sample by sample: samples a cell x height x width.

    So what is asked of all samples of a cell goes along the first axis, which is quick. In a cell
    they go along its rows from the top. What most cells show is the same in all of their samples:
    how it looks is found for those that are asked for.

    Args:
        shown: the number, in `looks`, of what each sample shows.
        seen: the samples, for how near that is.
        looks: how it looks.
    """

    def __init__(self, shown: npt.NDArray[np.int32], seen: Seen, looks: Looks) -> None:
        self.shape = shown.shape
        self._shown = shown
        self._seen = seen
        self._looks = looks

    @cached_property
    def ink(self) -> npt.NDArray[np.int8]:
        """Index of the ink, or `NO_INK`."""
        return self._looks.ink.take(self._shown, mode="wrap")

    @cached_property
    def light(self) -> npt.NDArray[np.float32]:
        """How bright, 0 to 1."""
        light = self._looks.light.take(self._shown, mode="wrap")
        if self._looks.fades is not None:
            behind = -self.nearness / self._looks.fades.take(self._shown, mode="wrap")
            light *= 1 - 0.5 * np.minimum(np.maximum(behind, 0.0), 1.0)
        return light

    @cached_property
    def body(self) -> npt.NDArray[np.int16]:
        """The thing that is seen; 0 the table, negative for nothing."""
        return self._looks.body.take(self._shown, mode="wrap")

    @cached_property
    def nearness(self) -> Nearness:
        """How near it is."""
        return self._seen.nearness

    def first(self) -> Samples:
        """The first sample of each cell only, cells counted along the rows from the top: 1 x n."""
        shown, keys = self._shown[0].reshape(1, -1), self._seen.keys[0].reshape(1, -1)
        return Samples(shown, Seen(keys), self._looks)

    def mixed(self) -> Ints:
        """The cells whose samples do not all show the same, counted along the rows."""
        mixed = (self._shown[1:] != self._shown[0]).any(0)
        if self._looks.fades is not None:
            mixed |= self._looks.fades.take(self._shown[0], mode="wrap") < NEVER
        return np.flatnonzero(mixed)

    def of(self, cells: Ints) -> Samples:
        """The samples of some cells only: samples a cell x cells."""
        return Samples(_of(self._shown, cells), Seen(_of(self._seen.keys, cells)), self._looks)


def _of(values: npt.NDArray[_Number], cells: Ints) -> npt.NDArray[_Number]:
    """Values of the samples of some cells."""
    return values.reshape(len(values), -1).take(cells, 1)


@dataclass(frozen=True, eq=False)
class Marks:
    """Characters for cells in which nothing stands.

    Attributes:
        places: the cells, counted along the rows from the top; of two marks the later one is seen.
        glyphs: code points.
        inks: indices of their inks.
        texts: which text each is of, counted from 0: a figure of which a part has no room says
            something else. None where each stands for itself.
    """

    places: Ints
    glyphs: Ints
    inks: Ints
    texts: Ints | None = None

    @classmethod
    def written(cls, texts: Iterable[Text], shape: SheetShape) -> Marks:
        """Texts on a sheet, each whole or not at all; blanks leave cells."""
        height, width = shape
        whole = [
            (column, row, text, ink)
            for column, row, text, ink in texts
            if 0 <= row < height and 0 <= column <= width - len(text)
        ]
        signs = [
            (row * width + at, ord(sign), INKS.index(ink), number)
            for number, (column, row, text, ink) in enumerate(whole)
            for at, sign in enumerate(text, column)
            if sign != " "
        ]
        places, glyphs, inks, numbers = np.array(signs, dtype=np.int64).reshape(-1, 4).T
        return cls(places, glyphs, inks, numbers)

    @classmethod
    def dots(cls, x: Floats, y: Floats, glyphs: str, ink: Ink, shape: SheetShape) -> Marks:
        """Dots on a sheet.

        Args:
            x: of the dots, cells from the left edge, fractions and all.
            y: cells from the upper edge.
            glyphs: one for the upper half of a cell and one for the lower.
            ink: theirs.
            shape: of the sheet.
        """
        height, width = shape
        inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        x, y = x[inside], y[inside]
        rows = y.astype(np.int64)
        glyph = np.where(y - rows < 0.5, ord(glyphs[0]), ord(glyphs[1]))
        return cls(rows * width + x.astype(np.int64), glyph, np.full_like(rows, INKS.index(ink)))


def apart(figures: Iterable[Text]) -> list[Text]:
    """The figures that can be told from one another: without those with another one within a cell.

    Args:
        figures: what is written where, the ones first that are to be kept.
    """
    kept: list[Text] = []
    for figure in figures:
        column, row, text, _ = figure
        if all(
            y != row or column > x + len(other) or x > column + len(text) for x, y, other, _ in kept
        ):
            kept.append(figure)
    return kept


class Cells:
    """A sheet of characters with their paints, as arrays, height x width.

    Attributes:
        glyphs: code points.
        ink, level: of the characters: index of the ink or `NO_INK`, and brightness.
        under, under_level: the same of what is behind them.
        free: where nothing stands, so that something may be marked.
    """

    def __init__(self, height: int, width: int) -> None:
        shape = (height, width)
        self.glyphs = np.full(shape, 32, dtype=np.uint32)
        self.ink = np.full(shape, NO_INK, dtype=np.int64)
        self.level = np.zeros(shape, dtype=np.int64)
        self.under = np.full(shape, NO_INK, dtype=np.int64)
        self.under_level = np.zeros(shape, dtype=np.int64)
        self.free = np.ones(shape, dtype=np.bool_)

    def mark(self, marks: Marks) -> None:
        """Put characters into cells where nothing stands; what they show is behind from then on."""
        free = self.free.take(marks.places)
        if marks.texts is not None:
            free &= np.bincount(marks.texts, ~free).take(marks.texts) == 0
        places = marks.places[free]
        self._clear(places)
        self.glyphs.put(places, marks.glyphs[free])
        self.ink.put(places, marks.inks[free])
        self.level.put(places, PLAINLY)

    def _clear(self, places: Ints) -> None:
        """Let what cells show be behind a character that is put there."""
        glyphs = self.glyphs.take(places)
        blocks = (glyphs >= FULL_BLOCK) & ((glyphs < DOTS.start) | (glyphs >= DOTS.stop))
        bare = places[(self.under.take(places) == NO_INK) & blocks]
        if len(bare):
            self.under.put(bare, self.ink.take(bare))
            self.under_level.put(bare, self.level.take(bare))

    def rows(self) -> list[Row]:
        """The sheet as rows of spans."""
        return _rows(self.glyphs, self._paints())

    def _paints(self) -> Ints:
        """The paint of each cell as a number, which `_paint` reads."""
        blank = (self.glyphs == 32) & (self.under == NO_INK)
        ink, under = self.ink + np.int64(1), self.under + np.int64(1)
        code = ((ink * _STEPS + self.level) * _INKS + under) * _STEPS + self.under_level
        code *= ~blank
        # A blank takes the paint of its left neighbour, so that it begins no span of its own.
        if blank.any():
            places = np.where(blank, 0, np.arange(blank.shape[1]))
            np.maximum.accumulate(places, axis=1, out=places)
            taken = np.take_along_axis(code, places, axis=1)
            code = np.where(blank & (taken % (_INKS * _STEPS) < _STEPS), taken, code)
        return code


class LastRows:
    """The rows of a picture as it was, of which those that stand are not made again."""

    def __init__(self) -> None:
        self._glyphs = np.zeros((0, 0), dtype=np.uint32)
        self._paints = np.zeros((0, 0), dtype=np.int64)
        self._rows: list[Row] = []

    def of(self, cells: Cells) -> list[Row]:
        """The rows of a sheet; where a row is as it was, it is the very row."""
        glyphs, paints = cells.glyphs, cells._paints()
        if glyphs.shape == self._glyphs.shape:
            changed = ((glyphs != self._glyphs) | (paints != self._paints)).any(1).nonzero()[0]
        else:
            changed, self._rows = np.arange(len(glyphs)), [()] * len(glyphs)
        rows = list(self._rows)
        if len(changed):
            made = _rows(glyphs[changed], paints[changed])
            for place, row in zip(changed.tolist(), made, strict=True):
                rows[place] = row
        self._glyphs, self._paints, self._rows = glyphs, paints, rows
        return list(rows)


def _rows(glyphs: npt.NDArray[np.uint32], code: Ints) -> list[Row]:
    """Characters and the numbers of their paints as rows of spans."""
    begins = np.ones(code.shape, dtype=bool)
    begins[:, 1:] = code[:, 1:] != code[:, :-1]
    height, width = code.shape
    starts = np.flatnonzero(begins)
    paints = map(_paint, code.ravel()[starts].tolist())
    text = glyphs.astype("<u4").tobytes().decode("utf-32-le")
    begins_at = starts.tolist()
    spans = [
        (text[start:end], paint)
        for start, end, paint in zip(
            begins_at, [*begins_at[1:], height * width], paints, strict=True
        )
    ]
    first = np.searchsorted(starts, width * np.arange(height + 1)).tolist()
    return [tuple(spans[begin:end]) for begin, end in pairwise(first)]


FULL_BLOCK = 0x2580
"""The first code point of the blocks, which leave no ground to write on."""
DOTS = range(0x2800, 0x2900)
"""The code points of braille, which leave nearly all of it."""
PLAINLY = LEVELS
"""The level of what is written plainly, in an ink that has no shades."""
_STEPS = LEVELS + 1
_INKS = len(INKS) + 1


@lru_cache(4096)
def _paint(code: int) -> Ink | Paint:
    code, under_level = divmod(code, _STEPS)
    code, under = divmod(code, _INKS)
    ink, level = divmod(code, _STEPS)
    if ink == 0 and under == 0:
        return Ink.PLAIN
    if level == PLAINLY and under == 0:
        return INKS[ink - 1]
    behind = INKS[under - 1] if under else None
    level = min(level, LEVELS - 1)
    if ink == 0:
        return Paint(INKS[under - 1], under_level, behind, under_level)
    return Paint(INKS[ink - 1], level, behind, under_level)


def nearest_but(nearness: npt.NDArray[np.float32], but: npt.NDArray[np.bool_]) -> Ints:
    """The place of the nearest sample of each cell, but for those that do not count.

    At least one of each cell must count; where nothing is seen in any of them it is one of those.

    Args:
        nearness: of samples a cell x cells.
        but: those that do not count.
    """
    rest = np.where(but, -np.inf, np.maximum(nearness, _FARTHEST))
    return np.asarray(rest.argmax(0), dtype=np.int64)


_FARTHEST = np.float32(-1e9)


def levels(light: npt.NDArray[Any]) -> npt.NDArray[np.int64]:
    """Brightness from 0 to 1 as levels."""
    whole = (light * LEVELS).astype(np.int64)
    return np.minimum(np.maximum(whole, 0, out=whole), LEVELS - 1, out=whole)
