"""The cassette recorder as its operator sees it: the cassette in it, its counter, what goes on.

The machine of 1980 tells little: two stars in the corner of the tube. Whoever stands at the
recorder sees the counter, and hears what goes by. Looking changes nothing and takes none of the
machine's time.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import islice

from trs80arm.basic.dialogue.system import SystemTape
from trs80arm.basic.dialogue.tape_statements import Cload, InputTape, PrintTape, Writing
from trs80arm.basic.state import Activity
from trs80arm.machine import cassette, tape_files
from trs80arm.machine.cassette import Stretch
from trs80arm.machine.tape_files import sign
from trs80arm.rig import Rig

BYTE_SECONDS = 0.016
"""About how long a byte takes at 500 baud; the counter counts in it."""
MOST = 100
"""Recordings of a cassette that are told apart; a strange file may have millions."""
ANY_PROGRAM = "any program"
"""What CLOAD without a name looks for."""


@dataclass(frozen=True)
class Recorded:
    """Something that is on a cassette.

    Attributes:
        label: `program A`, `machine code NAME` or `data`.
        start: where it begins, in bytes from the start of the tape.
        stop: where it ends.
    """

    label: str
    start: int
    stop: int


@dataclass(frozen=True)
class Deck:
    """The recorder at one moment.

    Attributes:
        cassette: the name of the cassette in it, or None.
        by_hand: whether it was put in by hand, and so stays in.
        running: whether its motor is on.
        position: where the tape stands, in bytes.
        length: how much is on it, in bytes.
        holds: what is on it, in a few words.
        doing: what goes on, in one line; empty while the motor is off.
        done: how much of what is recorded or loaded has gone by, 0 to 1; None if that is unknown.
    """

    cassette: str | None = None
    by_hand: bool = False
    running: bool = False
    position: int = 0
    length: int = 0
    holds: str = ""
    doing: str = ""
    done: float | None = None

    @classmethod
    def of(cls, rig: Rig) -> Deck:
        """Look at the recorder of a machine."""
        tape = rig.tape
        position, length = tape.position, tape.length
        if tape.recorded is not None:
            position = length = length + tape.recorded
        doing, done = _work(rig) if tape.running else ("", None)
        return cls(
            cassette=tape.cassette,
            by_hand=tape.by_hand,
            running=tape.running,
            position=position,
            length=length,
            holds=contents_text(tape.content) if tape.cassette is not None else "",
            doing=doing,
            done=done,
        )

    @property
    def counter(self) -> str:
        """How far the tape has gone and how much there is on it, minutes and seconds."""
        return f"{tape_time(self.position)} of {tape_time(self.length)}"

    @property
    def progress(self) -> str:
        """What goes on, with how much of it is done."""
        percent = "" if self.done is None else f" {self.done:.0%}"
        return self.doing + percent


def cassettes_of(rig: Rig) -> tuple[str, ...]:
    """The names of the cassettes on the shelf and in the recorder."""
    tape = rig.tape
    return tuple(sorted({*tape.cassettes, *filter(None, [tape.cassette])}))


def tape_time(length: int) -> str:
    """How long so many bytes of tape play: `1:04`."""
    minutes, seconds = divmod(round(length * BYTE_SECONDS), 60)
    return f"{minutes}:{seconds:02d}"


@lru_cache(maxsize=64)
def contents(tape: bytes) -> tuple[Recorded, ...]:
    """What is on a cassette, in order, as far as `MOST`."""
    return tuple(
        Recorded(_label(stretch), stretch.start, stretch.stop)
        for stretch in islice(cassette.stretches(tape), MOST)
    )


def contents_text(tape: bytes) -> str:
    """What is on a cassette, in a few words."""
    labels = [recorded.label for recorded in contents(tape)]
    more = ["and more"] if len(labels) == MOST else []
    return ", ".join([*labels, *more]) or "blank"


def _label(stretch: Stretch) -> str:
    words = tape_files.label(stretch.recording)
    return words if stretch.fault is None or stretch.recording is None else f"{words}, damaged"


def _work(rig: Rig) -> tuple[str, float | None]:
    """What the machine does at the recorder, and how much of it is done."""
    tape = rig.tape
    activity = rig.basic.state.stack[-1]
    if isinstance(activity, Writing):
        word = "PRINT#" if isinstance(activity, PrintTape) else "CSAVE"
        where = tape.cassette if tape.by_hand else "a cassette of its own"
        return f"{word} on {where}", (tape.recorded or 0) / activity.total
    here = next(
        (each for each in contents(tape.content) if each.start <= tape.position < each.stop), None
    )
    statement, wanted = _wanted(activity)
    if here is None:
        silence = "" if tape.passes else "; the tape is at its end, BREAK stops"
        return f"{statement}: searching for {wanted}{silence}", None
    found = here.label.partition(",")[0]
    if found != wanted and not (wanted == ANY_PROGRAM and found.startswith("program")):
        return f"{statement}: searching for {wanted}, found {here.label}", None
    size = max(1, here.stop - here.start)
    return f"{statement}: {here.label}", (tape.position - here.start) / size


def _wanted(activity: Activity) -> tuple[str, str]:
    """The statement at work, and what it looks for, as a cassette's contents name it."""
    match activity:
        case Cload():
            name = activity.wanted
            return activity.statement, ANY_PROGRAM if name is None else f"program {sign(name)}"
        case InputTape():
            return "INPUT#", "data"
        case SystemTape():
            return "SYSTEM", f"machine code {activity.wanted}"
        case _:
            return "The motor is on", "nothing"
