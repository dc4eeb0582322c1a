"""The first five minutes: a tour in steps, each of which waits until one has done it.

A step says in two lines what to press and what comes of it, and looks at the rig until it has
happened. It can be skipped; one can go back a step, leave, and go on another day. Words between
backticks are what is to be typed or pressed, just as it stands: the tour's test does just that.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from trs80arm.arm.bench import BenchError
from trs80arm.bundled import along
from trs80arm.desk.asking import Asking, Choice, ListQuestion, Say
from trs80arm.desk.files import SessionFiles
from trs80arm.desk.places import read_memo, write_memo
from trs80arm.desk.session import Session
from trs80arm.desk.teach import Lesson
from trs80arm.files import FileFormatError
from trs80arm.reasons import one_line
from trs80arm.rig import Counts, Waiting

FILE = "tour.json"
"""The file of the state folder in which the step is remembered."""
PROGRAM, PICK_BENCH = "table4", "table3"
"""The program that is run, and the bench on which the hand stands around a part."""
FAR = 40
"""Half-steps by which a joint must have been moved."""
LIFTED = 0.25
"""Inches above the table from which on a part is lifted."""
TYPED_IN = 10.0
"""Virtual seconds in which a line is typed in."""
_LARGEST = 1 << 12
"""Bytes of the file that remembers the step."""


@dataclass(frozen=True)
class Before:
    """How things stood when a step began."""

    joints: Counts
    taught: int


@dataclass(frozen=True)
class Step:
    """One thing to do.

    Attributes:
        title: what is learned.
        words: what to press, in two lines.
        plain: the same for the line mode.
        done: whether it is done.
        prepare: brings about what the step begins with, where it was come to by another way.
    """

    title: str
    words: tuple[str, str]
    plain: str
    done: Callable[[Session, Lesson, Before], bool]
    prepare: Callable[[Session], None] = lambda session: None


def _waits(what: Waiting) -> Callable[[Session, Lesson, Before], bool]:
    return lambda session, lesson, before: session.waiting is what and not session.typing


def _moved(session: Session, lesson: Lesson, before: Before) -> bool:
    return any(
        abs(now - then) >= FAR for now, then in zip(session.rig.joints, before.joints, strict=True)
    )


def _holds(session: Session, lesson: Lesson, before: Before) -> bool:
    return session.rig.state.held is not None


def _lifts(session: Session, lesson: Lesson, before: Before) -> bool:
    parts = session.rig.arm.bench.parts.values()
    return any(part.held and part.box.bottom > LIFTED for part in parts)


def _then_ready(
    done: Callable[[Session, Lesson, Before], bool],
) -> Callable[[Session, Lesson, Before], bool]:
    """Something is done, and the machine waits for the next line."""
    ready = _waits(Waiting.COMMAND)
    return lambda *seen: ready(*seen) and done(*seen)


def _loaded(session: Session, lesson: Lesson, before: Before) -> bool:
    return session.path is not None and session.path.stem == PROGRAM and bool(session.program)


def _taught(session: Session, lesson: Lesson, before: Before) -> bool:
    return len(lesson) > before.taught


def _taught_elsewhere(session: Session, lesson: Lesson, before: Before) -> bool:
    places = {position.registers for position in lesson.positions}
    return _taught(session, lesson, before) and len(places) > 1


def _slipped(session: Session, lesson: Lesson, before: Before) -> bool:
    return session.slip is not None


def _came_back(session: Session, lesson: Lesson, before: Before) -> bool:
    return session.slip is None and not session.typing


def _never(session: Session, lesson: Lesson, before: Before) -> bool:
    return False


def _at_the_prompt(session: Session) -> None:
    # Half a line that an earlier step was typing would stand before whatever is typed next.
    session.rig.run_until(lambda rig: not rig.typing, TYPED_IN)
    if session.waiting is not Waiting.COMMAND:
        session.ready()


def _in_manual_mode(session: Session) -> None:
    if session.waiting is not Waiting.SET:
        _at_the_prompt(session)
        session.rig.type("@SET\r")


def _around_a_part(session: Session) -> None:
    _at_the_prompt(session)
    session.set_bench(along(PICK_BENCH + ".toml"))


def _with_a_part(session: Session) -> None:
    if session.rig.state.held is None:
        _around_a_part(session)
        session.rig.type("@CLOSE\r")


def _with_the_program(session: Session) -> None:
    # What somebody typed in the meantime is not to go without a question.
    if not session.unsaved and (session.path is None or session.path.stem != PROGRAM):
        session.load(along(PROGRAM + ".bas"))
        session.set_bench(along(PROGRAM + ".toml"))


STEPS: tuple[Step, ...] = (
    Step(
        "Drive the arm",
        (
            "Type `@SET` and press `Enter`.",
            "ARMBASIC's manual mode: a key held moves a joint.",
        ),
        "Type @SET. It is ARMBASIC's manual mode: keys move the joints.",
        _waits(Waiting.SET),
        _at_the_prompt,
    ),
    Step(
        "Drive the arm",
        (
            "Hold `1`: the base turns. Q turns it back; 2 and W are the shoulder.",
            "The registers count the steps.",
        ),
        "Type 1:1 to hold the key 1 for a second: the base turns. 2, W: the shoulder.",
        _moved,
        _in_manual_mode,
    ),
    Step(
        "Drive the arm",
        ("Press `0`: manual mode ends.", "The machine is READY for the next line."),
        "Type 0: manual mode ends.",
        _waits(Waiting.COMMAND),
    ),
    Step(
        "Pick a part",
        (
            "The hand stands around a part now. Type `@CLOSE` and press `Enter`.",
            "It closes until its switch feels the part.",
        ),
        "The hand stands around a part now. Type @CLOSE: it closes until it feels the part.",
        _then_ready(_holds),
        _around_a_part,
    ),
    Step(
        "Pick a part",
        (
            "Lift it: type `@STEP 60,0,-150,-150` and press `Enter`.",
            "The speed, then steps of base, shoulder, elbow.",
        ),
        "Lift it: type @STEP 60,0,-150,-150: the speed, then steps of base, shoulder, elbow.",
        _then_ready(_lifts),
        _with_a_part,
    ),
    Step(
        "Run a program",
        (
            "Press `F2`, type `table4` and press `Enter`.",
            "The article's own program, with its bench.",
        ),
        "Type .open table4: the article's own program, with its bench.",
        _loaded,
        _at_the_prompt,
    ),
    Step(
        "Run a program",
        (
            "Press `F5` to run it. It works out the joints, then it is in manual mode.",
            "Press `0` and it begins. F8 goes faster.",
        ),
        "Type .run: it works out the joints. Then it is in manual mode: type 0 and it begins; "
        "Ctrl+C stops it.",
        _holds,
        _with_the_program,
    ),
    Step(
        "Run a program",
        (
            "It picks and places as long as there are parts.",
            "Press `Escape`, the machine's BREAK: it stops.",
        ),
        "It picks and places as long as there are parts. Press Ctrl+C, the machine's BREAK.",
        _waits(Waiting.COMMAND),
    ),
    Step(
        "Teach",
        (
            "Press `Ctrl+T`: the arm's place is taught.",
            "Any place that is worth coming back to.",
        ),
        "Type .teach: the arm's place is taught.",
        _taught,
        _at_the_prompt,
    ),
    Step(
        "Teach",
        (
            "Type `@STEP 50,300`, press `Enter`; when it stands, press `Ctrl+T`.",
            "F12 makes programs of such places.",
        ),
        "Type @STEP 50,300 and then .teach; .lesson makes a program of such places.",
        _taught_elsewhere,
        _at_the_prompt,
    ),
    Step(
        "A slip",
        (
            "Type `@STEP 50,0,-3000`, press `Enter`: too far for the shoulder.",
            "The register counts on, and the arm does not.",
        ),
        "Type @STEP 50,0,-3000: too far for the shoulder. The register counts, the arm does not.",
        _slipped,
        _at_the_prompt,
    ),
    Step(
        "A slip",
        (
            "Press `Ctrl+R`: it says why steps were lost. `Enter` takes all back.",
            "Arm, parts and registers.",
        ),
        "Type .recover: it says why steps were lost. Answer 1: arm, parts and registers go back.",
        _came_back,
    ),
    Step(
        "That is all",
        (
            "F1 is the help, F2 has more programs, Ctrl+P has every command.",
            "Press `Ctrl+N` and `Enter`: the tour ends.",
        ),
        ".help lists the commands, .open the programs. .tour ends the tour.",
        _never,
        _at_the_prompt,
    ),
)


class Tour:
    """The tour of a sitting.

    Args:
        session: the machine.
        lesson: the positions taught.
        files: asks before a program goes.
        place: the file that remembers how far one has come; that it is there says that the tour
            was offered.
        ask: a way to ask.
        say: a way to say something.

    Attributes:
        under_way: whether the tour is on.
        offered: whether it is being offered now.
    """

    def __init__(
        self,
        session: Session,
        lesson: Lesson,
        files: SessionFiles,
        place: Path,
        ask: Asking,
        say: Say,
    ) -> None:
        self._session = session
        self._lesson = lesson
        self._files = files
        self._place = place
        self._ask = ask
        self._say = say
        self._number = 0
        self._before = self._now()
        self.under_way = False
        self.offered = False

    # -- what there is to be seen -----------------------------------------------------------------

    @property
    def step(self) -> Step | None:
        """The step that waits to be done; None while the tour is not on."""
        return STEPS[self._number] if self.under_way else None

    @property
    def place(self) -> str:
        """Which step of how many: `3/13`."""
        return f"{self._number + 1}/{len(STEPS)}"

    # -- going through it -------------------------------------------------------------------------

    def offer(self) -> None:
        """Offer it, once and never again."""
        if not self._place.exists():
            self.offered = True
            self._remember()

    def decline(self) -> None:
        """Something else is done than what was offered."""
        self.offered = False

    def begin(self) -> None:
        """Begin it, or go on where it was left; what is unsaved is asked about."""
        self._files.if_program_may_go("Tour", self._begin)

    def _begin(self) -> None:
        self.offered = False
        self.under_way = True
        self._to(self._remembered())

    def go_on(self) -> None:
        """Go to the next step if this one is done."""
        step = self.step
        if step is not None and step.done(self._session, self._lesson, self._before):
            self._to(self._number + 1)

    def skip(self) -> None:
        """Go to the next step without having done this one; after the last the tour has ended."""
        if self._number + 1 == len(STEPS):
            self.end()
        else:
            self._to(self._number + 1)

    def back(self) -> None:
        """Go to the step before, and bring about what it begins with."""
        self._to(max(0, self._number - 1))

    def again(self) -> None:
        """Begin at the first step."""
        self._to(0)

    def leave(self) -> None:
        """Leave it; it goes on from here another time."""
        self.under_way = False
        self._say("The tour waits: it goes on here when you come back to it.")

    def end(self) -> None:
        """It has been gone through; the next time it begins at its first step."""
        self.under_way = False
        self._number = 0
        self._remember()
        self._say("That was the tour. The machine is yours.")

    def menu(self) -> None:
        """Begin or go on; while it is on ask what to do with it."""
        if not self.under_way:
            self.begin()
            return
        last = self._number + 1 == len(STEPS)
        choices = (
            Choice("skip", "End the tour" if last else "Skip this step"),
            Choice("back", "Back a step"),
            Choice("again", "From the beginning"),
            Choice("leave", "Leave the tour", "it goes on here the next time"),
        )
        do = {"skip": self.skip, "back": self.back, "again": self.again, "leave": self.leave}
        self._ask.choose(ListQuestion(f"Tour, step {self.place}", choices), lambda it: do[it]())

    def _to(self, number: int) -> None:
        self._number = number
        self._remember()
        try:
            STEPS[number].prepare(self._session)
        except (OSError, BenchError, FileFormatError) as error:
            self._say(f"The tour lacks something: {one_line(error)}", error=True)
        self._before = self._now()

    def _now(self) -> Before:
        return Before(self._session.rig.joints, len(self._lesson))

    # -- remembering ------------------------------------------------------------------------------

    def _remembered(self) -> int:
        """The step at which it was left; the first one if that is not known."""
        content = read_memo(self._place, _LARGEST)
        step = content.get("step") if isinstance(content, dict) else None
        return step if isinstance(step, int) and 0 <= step < len(STEPS) else 0

    def _remember(self) -> None:
        """A state folder that cannot be written is no trouble: the tour begins at its start."""
        write_memo(self._place, {"step": self._number if self.under_way else 0})
