"""The line under everything: virtual clock, speed, keys, what the machine waits for.

A notice stands beside them, and where it is too long for that, in lines of its own above.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from textwrap import wrap

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, Span, clock_text
from trs80arm.machine.driver import Mode
from trs80arm.rig import Waiting
from trs80arm.ui.panels.panel import Panel

_WAITING = {
    Waiting.NOTHING: "running",
    Waiting.MEMORY_SIZE: "MEMORY SIZE?",
    Waiting.COMMAND: "at READY",
    Waiting.AUTO: "AUTO: BREAK ends it",
    Waiting.INPUT: "waits at INPUT",
    Waiting.EDIT: "in EDIT",
    Waiting.PAUSE: "stopped by SHIFT @: any key goes on",
    Waiting.SET: "@SET: keys move the arm, 0 ends it",
    Waiting.SYSTEM: "SYSTEM",
}
_SHORTLY = {Waiting.SET: "@SET: 0 ends", Waiting.PAUSE: "held", Waiting.AUTO: "AUTO"}
"""The same in a few letters, for a line with a long notice on it."""
_GAP: Span = ("  ", Ink.PLAIN)
MOST_NOTICE = 3
"""The most lines that a notice has to itself."""
_MOTION = {Mode.STEP: "@STEP", Mode.CLOSE: "@CLOSE", Mode.SET: "@SET"}


@dataclass(frozen=True)
class Pace:
    """How fast the machine is asked to run, and does.

    Attributes:
        speed: virtual seconds a second of the wall; None for flat out.
        achieved: the same as it really is.
        paused: whether time stands still.
        turbo: whether it goes flat out for now, and returns to its speed by itself.
    """

    speed: float | None = 1.0
    achieved: float = 1.0
    paused: bool = False
    turbo: bool = False

    def text(self) -> str:
        """In few words."""
        if self.paused:
            return "PAUSED"
        if self.turbo:
            return f"turbo x{self.achieved:.0f}"
        if self.speed is None:
            return f"flat out x{self.achieved:.0f}"
        percent = round(100 * self.achieved / self.speed)
        return f"x{self.speed:g} {percent}%"


class StatusLine(Panel):
    """Clock, speed and what is achieved of it, key mode, waiting state, and a notice.

    Attributes:
        needed: lines that it takes.
    """

    HELP = """
## Status line

The machine's own time since it was switched on; the speed that was asked for and how much of it is
achieved; how keys are read (`events`: real press and release; `repeat`: your terminal does not
report releases, so a tap jogs and a held key runs; `latch`: a key goes down at the first press and
up at the second); what the machine is doing or waiting for, or with `--serial` where the arm's
serial line is and what went over it last; and for some seconds what the program has to say.
"""

    def __init__(self, *, id: str | None = None, classes: str | None = None) -> None:
        super().__init__(id=id, classes=classes)
        self._pace = Pace()
        self._keys = ""
        self._notice = ""
        self._goes_on = ""
        self.needed = 1

    def show(
        self,
        readings: Readings,
        pace: Pace | None = None,
        keys: str = "",
        notice: str = "",
        goes_on: str = "",
    ) -> None:
        """Show these readings with the program's own state.

        Args:
            readings: of the rig.
            pace: how fast it runs.
            keys: how keys are read.
            notice: a message to be read beside the machine's state for now.
            goes_on: what goes on at the recorder or at the arm's serial line.
        """
        self._pace = pace or self._pace
        self._keys, self._notice, self._goes_on = keys, notice, goes_on
        super().show(readings)

    def redraw(self) -> None:
        """Draw the last readings again, in as many lines as they need."""
        if self._readings is not None and self.size.width:
            self.needed = len(self._lines(self._readings, self.size.width))
            if self.needed != self.size.height:
                self.styles.height = self.needed
        super().redraw()

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """The state's row, and above it what of a notice does not fit there."""
        return self._lines(readings, width)

    def _lines(self, readings: Readings, width: int) -> list[Row]:
        clock: Span = (clock_text(readings.time)[:-1], Ink.STRONG)
        pace: Span = (self._pace.text(), Ink.ALARM if self._pace.paused else Ink.PLAIN)
        held: Span = pace if self._pace.paused else ("", Ink.PLAIN)
        keys: Span = (f"keys: {self._keys}" if self._keys else "", Ink.PLAIN)
        motors: Span = (
            "motors ON" if readings.motors_on else "motors off",
            Ink.STRONG if readings.motors_on else Ink.PLAIN,
        )
        said = self._goes_on or doing_text(readings)
        doing: Span = (said, Ink.PLAIN if self._notice else Ink.STRONG)
        shortly: Span = (_SHORTLY.get(readings.waiting, said), doing[1])
        notice: Span = (self._notice, Ink.STRONG)
        slipped: Span = ("! steps lost" if readings.believed else "", Ink.ALARM)
        fuller = (
            (clock, pace, keys, motors, slipped, doing),
            (clock, pace, keys, slipped, doing),
            (clock, pace, slipped, doing),
            (clock, held, slipped, doing),
        )
        beside = [*((*spans, notice) for spans in fuller), (held, doing, notice)]
        row = _first_that_fits([*beside, (held, shortly, notice)], width)
        if row is not None:
            return [row]
        words: list[Row] = [((line, Ink.STRONG),) for line in wrap(self._notice, width)]
        doing = (said, Ink.STRONG)
        alone = [*((*spans[:-1], doing) for spans in fuller), (held, doing), (held, shortly)]
        return [*words[:MOST_NOTICE], _first_that_fits(alone, width) or (shortly,)]


def _first_that_fits(choices: Iterable[Sequence[Span]], width: int) -> Row | None:
    """The first of some choices of words that fit into a line, two blanks between them."""
    for spans in choices:
        parts = [span for span in spans if span[0]]
        if sum(len(text) for text, _ in parts) + 2 * (len(parts) - 1) <= width:
            first, *others = parts
            return (first, *(each for span in others for each in (_GAP, span)))
    return None


def typing_text(left: int) -> str:
    """That so many keys are still to be typed."""
    return f"typing, {left} to go: Escape stops"


def doing_text(readings: Readings) -> str:
    """What the machine does or waits for."""
    if readings.to_type:
        return typing_text(readings.to_type)
    motion = _MOTION.get(readings.mode)
    if readings.waiting is Waiting.NOTHING and motion:
        return f"running {motion}"
    return _WAITING[readings.waiting]
