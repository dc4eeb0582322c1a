"""The scope: latches as a logic analyser shows them, and strip charts below, over one time.

It looks at a `History` and remembers how one looks: which joint, how much time a column is, where
the picture ends, and two cursors. The article's Figure 8 is a column of it read downwards, its
Figure 10 all of it.
"""

from __future__ import annotations

from bisect import bisect_left

import numpy as np
import numpy.typing as npt

from trs80arm.drawing.rows import Ink, Row, Span, fitted
from trs80arm.drawing.strips import fineness, strip
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.half_steps import HALF_STEPS
from trs80arm.trace.history import History

COLUMN_MS = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0)
"""How much time a column can be, milliseconds."""
JOINTS = 6
LATCHES = 7
PHASES = 4
LABEL = 14
"""Columns of what stands left of the signals."""
TICKS = 10
"""Columns from one figure of the time axis to the next."""
MARGIN = 6
"""Columns that stay free on the right of what happened last."""

_ON, _OFF, _MANY, _NONE = "▆", "▁", "▒", "·"
_RULE, _ASCII_RULE = "─", "-"
_ASCII_ON, _ASCII_OFF, _ASCII_MANY, _ASCII_NONE = "#", "_", ":", "."

Times = npt.NDArray[np.int64]


class Scope:
    """How one looks at a history.

    Attributes:
        joint: 1 to 6 for all about one joint, None for all latches.
        ascii: whether it is drawn in ASCII.
        cursor: T-state of the cursor, or None.
        mark: T-state of the other cursor, from which time is measured, or None.
    """

    def __init__(self) -> None:
        self.joint: int | None = None
        self.ascii = False
        self.cursor: int | None = None
        self.mark: int | None = None
        self._column = COLUMN_MS.index(10.0)
        self._end: int | None = None
        self._shown: Times = np.zeros(0, dtype=np.int64)

    # -- how one looks ----------------------------------------------------------------------------

    @property
    def step(self) -> int:
        """T-states of a column."""
        return round(COLUMN_MS[self._column] * T_STATES_PER_SECOND / 1000)

    def zoom(self, way: int) -> None:
        """More (1) or less (-1) detail; the cursor, or else the right edge, stays."""
        self._column = min(max(self._column - way, 0), len(COLUMN_MS) - 1)
        if self.cursor is not None and len(self._shown):
            self._end = self.cursor + self.step * (len(self._shown) // 2)

    def scroll(self, columns: int, history: History) -> None:
        """Go back in time by so many columns, or on; at the end the picture moves on by itself."""
        end = (self._live(history) if self._end is None else self._end) + columns * self.step
        self._end = None if end >= self._live(history) else max(end, history.begin + self.step)

    def next_joint(self, way: int) -> None:
        """All latches, joint 1 to 6, and all again."""
        self.joint = ((self.joint or 0) + way) % (JOINTS + 1) or None

    def put_cursor(self, column: int, *, mark: bool = False) -> None:
        """Put the cursor, and with it or behind it the mark, on a column; beside them, away."""
        place = column - LABEL
        moment = int(self._shown[place]) if 0 <= place < len(self._shown) else None
        if mark:
            self.mark = moment
        self.cursor = moment

    def _live(self, history: History) -> int:
        return min(history.now, history.end + MARGIN * self.step)

    # -- the picture ------------------------------------------------------------------------------

    def draw(self, history: History, names: tuple[str, ...], width: int, height: int) -> list[Row]:
        """The picture: a line of words, the signals, the time.

        Args:
            history: what happened.
            names: of the seven latches.
            width: cells.
            height: cells.
        """
        columns = max(1, width - LABEL)
        end = self._live(history) if self._end is None else self._end
        self._shown = end - self.step * np.arange(columns - 1, -1, -1, dtype=np.int64)
        body = height - 2
        if self.joint is None:
            rows = self._latches(history, names, body)
        else:
            rows = self._about(self.joint, history, body)
        rows = [fitted(row, width) for row in rows[:body]]
        rows += [fitted((), width)] * (body - len(rows))
        head = fitted(self._words(history, names), width)
        return [head, *map(self._crossed, rows), fitted(self._axis(), width)][:height]

    def _words(self, history: History, names: tuple[str, ...]) -> Row:
        what = "all latches" if self.joint is None else f"J{self.joint} {names[self.joint - 1]}"
        spans: list[Span] = [
            (what, Ink.STRONG),
            (f"  {COLUMN_MS[self._column]:g} ms a column", Ink.LABEL),
        ]
        if self._end is not None:
            spans.append(("  looking back", Ink.PART))
        if self.cursor is not None:
            spans.append((f"  at {_seconds(self.cursor)}", Ink.STRONG))
            if self.mark is not None and self.mark != self.cursor:
                away = (self.cursor - self.mark) / T_STATES_PER_SECOND
                spans.append((f"  {away * 1000:+.2f} ms from the mark", Ink.PLAIN))
        return tuple(spans)

    def _axis(self) -> Row:
        """Times below: a figure every few columns, at its column."""
        text = [" "] * (LABEL + len(self._shown))
        digits = 4 if self.step < T_STATES_PER_SECOND // 1000 else 3 if self._column < 5 else 2
        for place in range(0, len(self._shown) - TICKS, TICKS):
            if self._shown[place] >= 0:
                figure = f"'{self._shown[place] / T_STATES_PER_SECOND:.{digits}f}"
                text[LABEL + place : LABEL + place + len(figure)] = figure
        return ((f"{'seconds':{LABEL}}", Ink.LABEL), ("".join(text[LABEL:]), Ink.LABEL))

    def _crossed(self, row: Row) -> Row:
        """A row with the cursors over it, where nothing is drawn."""
        for moment, glyph in ((self.mark, ":"), (self.cursor, "|")):
            if moment is not None and len(self._shown):
                place = bisect_left(self._shown.tolist(), moment)
                if place < len(self._shown) and abs(self._shown[place] - moment) < self.step:
                    row = _over(row, LABEL + place, glyph)
        return row

    # -- latches ----------------------------------------------------------------------------------

    def _latches(self, history: History, names: tuple[str, ...], body: int) -> list[Row]:
        """Every phase of every latch if there is room, else a row a latch: its row of Figure 8."""
        rows: list[Row] = []
        whole = body >= LATCHES * PHASES
        spaced = body >= LATCHES * (PHASES + 1)
        room = LABEL - (3 if whole else 1)
        motors = names[:JOINTS]
        if any(len(f"J1 {name}") > room for name in motors):
            motors = tuple(map(_shortened, motors))
        called = [*(f"J{joint} {name}" for joint, name in enumerate(motors, 1)), "auxiliary"]
        for latch, name in enumerate(called):
            if not whole:
                rows.append(((f"{name:{LABEL}}", Ink.LABEL), *self._cycle(history, latch)))
                continue
            for phase in range(PHASES):
                label = f"{name if phase == 0 else '':{LABEL - 3}} {phase + 1}"
                rows.append(((f"{label:{LABEL}}", Ink.LABEL), *self._wave(history, latch, phase)))
            if spaced:
                rows.append(())
        return rows

    def _changes(self, history: History, latch: int) -> tuple[Times, Times]:
        """What a latch held at the end of each column, and how often it was written in it."""
        edges = np.concatenate((self._shown[:1] - self.step, self._shown))
        moments, _ = history.changes(latch)
        before = np.searchsorted(moments, edges, side="right")
        return history.nibbles(latch, self._shown), np.diff(before)

    def _known(self, history: History) -> npt.NDArray[np.bool_]:
        return (self._shown >= history.begin) & (self._shown <= history.now)

    def _wave(self, history: History, latch: int, phase: int) -> list[Span]:
        """A coil over time: on, off, or more often switched than a column can show."""
        held, _ = self._changes(history, latch)
        moments, nibbles = history.changes(latch)
        lit = nibbles >> (PHASES - 1 - phase) & 1
        flips = moments[np.flatnonzero(np.diff(lit, prepend=0))]
        edges = np.concatenate((self._shown[:1] - self.step, self._shown))
        often = np.diff(np.searchsorted(flips, edges, side="right")) > 1
        on = (held >> (PHASES - 1 - phase) & 1).astype(bool)
        glyphs = np.where(often, self._glyph(_MANY, _ASCII_MANY), self._glyph(_OFF, _ASCII_OFF))
        glyphs = np.where(on & ~often, self._glyph(_ON, _ASCII_ON), glyphs)
        inks = np.where(on | often, 1, 0)
        return self._spans(history, glyphs, inks, (Ink.LAMP_OFF, Ink.LAMP_ON))

    def _cycle(self, history: History, latch: int) -> list[Span]:
        """A latch over time as rows of Figure 8, 1 to 8; `?` for a pattern that is none of them."""
        held, writes = self._changes(history, latch)
        glyphs = _ROW_OF_FIGURE_8[held]
        glyphs = np.where(held == 0, self._glyph(_NONE, _ASCII_NONE), glyphs)
        glyphs = np.where(writes > 1, self._glyph(_MANY, _ASCII_MANY), glyphs)
        inks = np.where(writes > 0, 2, np.where(held > 0, 1, 0))
        return self._spans(history, glyphs, inks, (Ink.LAMP_OFF, Ink.PLAIN, Ink.LAMP_ON))

    def _glyph(self, fine: str, ascii: str) -> str:
        return ascii if self.ascii else fine

    def _spans(
        self,
        history: History,
        glyphs: npt.NDArray[np.str_],
        inks: npt.NDArray[np.int64],
        of: tuple[Ink, ...],
    ) -> list[Span]:
        """Characters in runs of one ink; blanks where nothing is known."""
        text = "".join(np.where(self._known(history), glyphs, " ").tolist())
        starts = np.flatnonzero(np.diff(inks, prepend=-1)).tolist()
        ends = [*starts[1:], len(text)]
        return [(text[start:end], of[inks[start]]) for start, end in zip(starts, ends, strict=True)]

    # -- one joint --------------------------------------------------------------------------------

    def _about(self, joint: int, history: History, body: int) -> list[Row]:
        """The phases of a joint's motor, and what the joint did."""
        rows: list[Row] = [
            ((f"{f'phi {phase + 1}':{LABEL}}", Ink.LABEL), *self._wave(history, joint - 1, phase))
            for phase in range(PHASES)
        ]
        across, _ = fineness(ascii=self.ascii)
        fine = self.step / across
        last = int(self._shown[-1])
        times = last - (fine * np.arange(len(self._shown) * across - 1, -1, -1)).astype(np.int64)
        known = (times >= history.begin) & (times <= history.now)
        unit = "in" if joint == JOINTS else "deg"
        charts = (
            (
                "opening" if joint == JOINTS else "angle",
                unit,
                history.quantity(f"angle {joint}", times),
            ),
            ("speed", f"{unit}/s", history.speed(joint, times)),
            ("margin", "%", history.margin(joint, times)),
            ("grip", "lb", history.quantity("force", times)),
        )
        room = max(body - PHASES, 0)
        for number, (name, of, values) in enumerate(charts):
            height = room * (number + 1) // len(charts) - room * number // len(charts)
            if height:
                rows += self._chart(name, of, np.where(known, values, np.nan), times, height)
        return rows

    def _chart(
        self, name: str, unit: str, values: npt.NDArray[np.float64], times: Times, height: int
    ) -> list[Row]:
        """A strip below a rule with its name; beside it what was greatest, is now, and was least.

        At the cursor, if there is one, it is what was there instead of what is now.
        """
        seen = values[np.isfinite(values)]
        least, most = (float(seen.min()), float(seen.max())) if len(seen) else (0.0, 0.0)
        here = values[-1:] if self.cursor is None else values[times >= self.cursor][:1]
        value = _figure(float(here[0]), unit) if len(here) and np.isfinite(here[0]) else ""
        moment = "here" if self.cursor is not None else "now" if self._end is None else "end"
        ruled = height > 2
        room = height - ruled
        between = f"{_figure(least, unit)}..{_figure(most, unit)}"
        labels = [_told(moment, value) if ruled else f"{name} {value}", between][:room]
        if room > 2:
            ends = _told("most", _figure(most, unit)), _told("least", _figure(least, unit))
            labels = [ends[0], _told(moment, value), *[""] * (room - 3), ends[1]]
        lines = strip(values, *_widened(least, most, unit), room, ascii=self.ascii)
        ink = Ink.ALARM if unit == "%" and len(seen) and least <= 0 else Ink.TRAIL
        rule = self._glyph(_RULE, _ASCII_RULE) * len(self._shown)
        head: Row = ((f"{f'{name}, {unit}':{LABEL}}", Ink.LABEL), (rule, Ink.FAINT))
        return [head] * ruled + [
            (
                (f"{label[: LABEL - 1]:{LABEL}}", Ink.STRONG if moment in label else Ink.LABEL),
                (line, ink),
            )
            for label, line in zip(labels, lines, strict=True)
        ]


_ROW_OF_FIGURE_8 = np.array(
    [
        str(HALF_STEPS.index(nibble) + 1) if nibble in HALF_STEPS else "?"
        for nibble in range(1 << PHASES)
    ]
)


def _shortened(name: str) -> str:
    """A name with the initials of all its words but the last: `r wrist`."""
    *before, last = name.split()
    return " ".join((*(word[0] for word in before), last))


def _figure(value: float, unit: str) -> str:
    digits = 1 if unit in ("deg", "deg/s", "%") else 2
    return f"{round(value, digits) + 0.0:.{digits}f}"


def _told(word: str, figure: str) -> str:
    return f"{word:5}{figure:>{LABEL - 6}}"


def _seconds(time: int) -> str:
    return f"{time / T_STATES_PER_SECOND:.4f} s"


def _widened(low: float, high: float, unit: str) -> tuple[float, float]:
    """The range of a chart: all of it for shares, else what is seen and a little more."""
    if unit == "%":
        return min(low, 0.0), 100.0
    room = max((high - low) * 0.05, 0.5)
    return low - room, high + room


def _over(row: Row, column: int, glyph: str) -> Row:
    """A row with a character put into a column where there is a blank or a low line."""
    spans: list[Span] = []
    at = 0
    for text, ink in row:
        place = column - at
        if 0 <= place < len(text) and text[place] in " _▁·.─-":
            spans += [(text[:place], ink), (glyph, Ink.STRONG), (text[place + 1 :], ink)]
        else:
            spans.append((text, ink))
        at += len(text)
    return tuple(span for span in spans if span[0])
