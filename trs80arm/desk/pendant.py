"""The teach pendant: drives the arm by commands that it types at the machine's prompt.

Everything it does is a line of ARMBASIC, typed on the TRS-80's keyboard as a quick user would, seen
on the tube, and kept in `sent`: `@STEP` for jogs and for the way to a point, `@CLOSE` for the grip.
So the registers count all of it, a program's variables are left alone, and whoever watches learns
the language. It types when the machine stands at its prompt and not otherwise; while a program
waits in `@SET` its keys are the keys of `@SET`.

Whoever lets time pass calls `go_on` before each slice.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from trs80arm.desk.jogging import STEP_SIZES, Coordinates, Jogger, Plan, Stance, StepSize
from trs80arm.desk.listed_points import ListingError, read_points
from trs80arm.desk.session import Session
from trs80arm.desk.taught_programs import (
    Manner,
    Written,
    commands,
    move_between,
    moves,
    step_command,
    written,
)
from trs80arm.desk.teach import MOST_DELAY, Lesson, Position
from trs80arm.files import FileFormatError, load_program
from trs80arm.inspection import line_text
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.reasons import one_line
from trs80arm.rig import Key, Rig, Waiting

KEPT = 200
"""Commands that are remembered."""
LONGEST_LINE = 8.0
"""Virtual seconds that a line may take to be typed."""
READY_SECONDS = 1.0
"""Virtual seconds that the machine may take to say READY."""
TOUCH = 0.1
"""Virtual seconds for which BREAK, or the key that ends `@SET`, is held."""
CLOSE = "@CLOSE"
COLUMNS = 64
"""Of the tube."""

IN_THE_WAY = {
    Waiting.NOTHING: "A program runs",
    Waiting.SET: "@SET moves joints only",
    Waiting.INPUT: "A program waits for INPUT",
    Waiting.EDIT: "A line is being edited",
    Waiting.AUTO: "AUTO waits for a line",
    Waiting.PAUSE: "SHIFT @ holds the program",
    Waiting.MEMORY_SIZE: "The machine asks for MEMORY SIZE?",
    Waiting.SYSTEM: "SYSTEM waits for a tape",
}
"""Why no command can be typed, by what the machine waits for."""


@dataclass(frozen=True)
class _Order:
    """A line to be typed.

    Attributes:
        text: the command.
        closes: whether it is void once the grip switch is closed.
        arrives: the place in the list where the arm is when it is done, or None.
    """

    text: str
    closes: bool = False
    arrives: int | None = None


class Pendant:
    """A teach pendant on a session.

    Args:
        session: the machine.
        lesson: the points; the pendant adds to them.
        typed: is given every command that is typed.

    Attributes:
        lesson: the points.
        coordinates: what the keys move the arm along.
        size_number: which of the step sizes a press makes.
        manner: the D of its `@STEP`s, and whether a run goes round and round.
        place: the point that is marked, None without any.
        sent: the commands that were typed, oldest first.
        message: what became of what was wanted; empty if there is nothing to say.
    """

    def __init__(
        self, session: Session, lesson: Lesson, typed: Callable[[str], None] = lambda _: None
    ) -> None:
        self._session = session
        self._typed = typed
        self.lesson = lesson
        self.coordinates = Coordinates.WORLD
        self.size_number = 3
        self.manner = Manner(speed=_unhurried(session.rig))
        self.place: int | None = None
        self.sent: deque[str] = deque(maxlen=KEPT)
        self.message = ""
        self._jogger = Jogger()
        self._held: dict[tuple[int, int], None] = {}
        """The ways whose keys are down, in the order in which they went down."""
        self._owed: dict[tuple[int, int], None] = {}
        """Those of which no step was planned yet: a press is a step at least."""
        self._ended: set[tuple[int, int]] = set()
        """Those that can be held on and on, but nothing comes of it until they are let go."""
        self._passed: dict[Key, None] = {}
        """The keys of the machine's own `@SET` that are held for it."""
        self._queue: deque[_Order] = deque()
        self._doing: _Order | None = None
        self._round: list[_Order] = []
        self._slips_told = 0
        session.watch_machine(self._new_machine)

    @property
    def _rig(self) -> Rig:
        return self._session.rig

    def _new_machine(self) -> None:
        self._forget()
        self._doing = None
        self._passed.clear()
        self._slips_told = 0

    # -- how it stands ----------------------------------------------------------------------------

    @property
    def size(self) -> StepSize:
        """How far a press goes."""
        return STEP_SIZES[self.size_number]

    def other_size(self, by: int) -> None:
        """A coarser step size, or a finer one."""
        self.size_number = min(max(self.size_number + by, 0), len(STEP_SIZES) - 1)

    def next_coordinates(self) -> None:
        """World, tool, joint, and again."""
        self.coordinates = self.coordinates.following
        self._jogger.let_go()

    @property
    def stance(self) -> Stance:
        """The arm as it stands."""
        return Stance.of(self._rig)

    @property
    def busy(self) -> bool:
        """Whether anything is to be typed, or done of what was."""
        return bool(self._queue or self._held or self._owed or self._doing or self._round)

    @property
    def hint(self) -> str:
        """What one could do next; nothing while something is under way."""
        if self._queue or self._doing:
            return ""
        if self.obstacle:
            return "" if self.message else f"{self.obstacle}: {self._way_out}"
        keys, count = self._session.jog_keys, len(self.lesson)
        if not count:
            return (
                f"Keys {''.join(keys.positive)} and {''.join(keys.negative)} move the arm, O opens "
                "the hand. Above the part, press A: that is the first point."
            )
        if count == 1:
            return "Down to the part, A; C closes the hand, A: each place is a point, in order."
        if not any(position.grips for position in self.lesson.positions):
            return "At the part C closes the hand until it grips; A then: the hand holds there."
        return "A adds the next point. When all is taught: K puts the parts back, P plays it once."

    @property
    def obstacle(self) -> str:
        """Why no command can be typed; empty if one can, or the pendant's own is under way."""
        if self._session.playing:
            return "A recording plays"
        if self._session.halted:
            return "The debugger has stopped the machine"
        if self._doing is not None or self._rig.waiting is Waiting.COMMAND:
            return ""
        return IN_THE_WAY[self._rig.waiting]

    # -- time -------------------------------------------------------------------------------------

    def go_on(self) -> None:
        """Type the next line if the machine is ready for it, and not stopped by the debugger."""
        if self._session.halted:
            return
        if self._doing is not None and not self._finished():
            return
        if not self._queue and (self._held or self._owed):
            self._plan_jog()
        if not self._queue:
            self._queue.extend(self._round)
        if not self._queue:
            return
        if self.obstacle:
            self._forget()
            self.message = f"{self.obstacle}: {self._way_out}"
            return
        order = self._queue.popleft()
        if order.closes and self.stance.switch_closed:
            self._forget()
            self.message = "The grip switch has closed."
        else:
            self._send(order)

    @property
    def _way_out(self) -> str:
        return "choose joint coordinates, or end it." if self._in_set else "stop it first."

    @property
    def _in_set(self) -> bool:
        return self._rig.waiting is Waiting.SET

    def _send(self, order: _Order) -> None:
        """Type a line; the time that typing takes passes at once."""
        rig = self._rig
        if not _line_is_empty(rig):
            # As a user would who finds half a line there: BREAK leaves it to be read.
            rig.hold([Key.BREAK], TOUCH)
            rig.run_until(lambda rig: not rig.typing, READY_SECONDS)
        self.sent.append(order.text)
        self._typed(order.text)
        self._doing = order
        rig.type(order.text + "\r")
        rig.run_until(_moves_or_rests, LONGEST_LINE)
        self._finished()

    def _finished(self) -> bool:
        """Whether what was typed is done; READY and the prompt after it are not waited for."""
        rig = self._rig
        if not _moves(rig):
            rig.run_until(_moves_or_rests, READY_SECONDS)
        if _works(rig):
            return False
        order, self._doing = self._doing, None
        if order is not None and order.arrives is not None:
            self.place = order.arrives
        if (slip := self._session.slip) is not None and slip.number >= self._slips_told:
            self._slips_told = rig.arm.event_count
            self._forget()
            self.message = f"{slip.text}: the registers are wrong now."
        return True

    def _forget(self) -> None:
        """Leave out what was still to come."""
        self._queue.clear()
        self._round = []
        self._owed.clear()
        self._end_holding()
        self._jogger.let_go()

    def _end_holding(self) -> None:
        self._ended.update(self._held)
        self._held.clear()

    def stop(self) -> None:
        """Stop: nothing more is typed; a program, or a hand that closes, gets BREAK.

        A `@STEP` under way goes to its end, as on the real machine.
        """
        rig, was_busy = self._rig, self.busy or bool(self._passed)
        self.let_go()
        self._forget()
        if self._doing is not None:
            if self._doing.text == CLOSE:
                rig.hold([Key.BREAK], TOUCH)
        elif rig.waiting is Waiting.NOTHING:
            rig.stop_typing()
            rig.hold([Key.BREAK], TOUCH)
        elif rig.waiting is not Waiting.COMMAND:
            self._session.ready()
        elif not was_busy:
            return
        self.message = "Stopped."

    # -- jogging ----------------------------------------------------------------------------------

    def press(self, axis: int, way: int) -> None:
        """A key goes down: the arm makes a step.

        Args:
            axis: 0 to 5.
            way: 1 or -1.
        """
        self.message = ""
        if self._in_set and self._doing is None and self.coordinates is Coordinates.JOINT:
            key = self._key(axis, way)
            self._passed[key] = None
            self._rig.press(key)
        else:
            self._owed[axis, way] = None
            self._ended.discard((axis, way))
            self._leave_the_way()

    def hold(self, axis: int, way: int) -> None:
        """A key stays down: steps follow one another until it is let go."""
        if self._key(axis, way) not in self._passed and (axis, way) not in self._ended:
            self._held[axis, way] = None

    def release(self, axis: int, way: int) -> None:
        """A key is let go; the step under way is finished."""
        key = self._key(axis, way)
        if key in self._passed:
            del self._passed[key]
            self._rig.release(key)
        self._held.pop((axis, way), None)
        self._ended.discard((axis, way))

    def let_go(self) -> None:
        """All keys are let go."""
        for key in self._passed:
            self._rig.release(key)
        self._passed.clear()
        self._held.clear()
        self._ended.clear()

    def _key(self, axis: int, way: int) -> Key:
        """The key of `@SET` that goes that way."""
        keys = self._session.jog_keys
        return (keys.positive if way > 0 else keys.negative)[axis]

    def end_set(self) -> None:
        """Press the key that ends `@SET`."""
        if self._in_set:
            self._rig.hold([self._session.jog_keys.leave], TOUCH)

    def _leave_the_way(self) -> None:
        """A way from point to point that is under way ends for a jog."""
        if self._round or any(order.arrives is not None for order in self._queue):
            self._queue.clear()
            self._round = []

    def _plan_jog(self) -> None:
        keys = {*self._held, *self._owed}
        # A line begins anew, in tool coordinates along the hand as it then points, with a press.
        if not self._held.keys() - self._owed.keys():
            self._jogger.let_go()
        self._owed.clear()
        ways = [((axis, 1) in keys) - ((axis, -1) in keys) for axis in range(6)]
        if any(ways):
            self._take(self._jogger.plan(self.stance, self.coordinates, ways, self.size))

    def _take(self, plan: Plan) -> None:
        if plan.problem:
            self._end_holding()
            self.message = f"No farther: {plan.problem}."
        self._queue.extend(
            _Order(step_command(self.manner.speed, piece), closes=plan.closes)
            for piece in plan.pieces
        )

    def move_by(self, axis: int, amount: float) -> None:
        """Jog by so much: half-steps in joint coordinates, inches, degrees in the others."""
        self._begin()
        size = StepSize(round(abs(amount)), abs(amount), abs(amount))
        ways = [0] * 6
        ways[axis] = 1 if amount > 0 else -1
        self._jogger.let_go()
        self._take(self._jogger.plan(self.stance, self.coordinates, ways, size))

    def _begin(self) -> None:
        """Something else than what was to come is wanted."""
        self._forget()
        self.message = ""

    # -- the hand ---------------------------------------------------------------------------------

    def close(self) -> None:
        """Close the hand until its switch closes, to the step."""
        self._begin()
        self._queue.append(_Order(CLOSE))

    def open_to(self, width: float) -> None:
        """Open or close the hand to a width, inches; closing ends where the grip switch closes."""
        self._begin()
        stance = self.stance
        most = stance.model.hand.range
        if not 0 <= width <= most:
            self.message = f"The hand opens 0 to {most:g} inches."
            return
        ways = [0, 0, 0, 0, 0, 1 if width > stance.opening else -1]
        size = StepSize(0, abs(width - stance.opening), 0)
        self._take(self._jogger.plan(stance, Coordinates.WORLD, ways, size))

    # -- points -----------------------------------------------------------------------------------

    def teach(self, name: str = "") -> Position:
        """Teach a point where the arm is, behind the one that is marked."""
        self.place = len(self.lesson) if self.place is None else self.place + 1
        position = self.lesson.add(self.stance, name, self.place)
        self.message = f"Point {position.name} is taught."
        return position

    def teach_again(self) -> None:
        """Have the marked point be where the arm is."""
        if self.place is not None:
            self.lesson.teach_again(self.place, self.stance)
            self.message = f"Point {self.lesson.positions[self.place].name} is where the arm is."

    def remove(self) -> None:
        """Take the marked point off the list."""
        if self.place is not None:
            self.message = f"Point {self.lesson.positions[self.place].name} is gone."
            self.lesson.remove(self.place)
            self.mark(self.place)

    def shift(self, by: int) -> None:
        """Put the marked point earlier or later."""
        if self.place is not None:
            self.place = self.lesson.move(self.place, by)

    def switch_grip(self) -> None:
        """Say that the hand holds something at the marked point, or that it does not."""
        if self.place is not None:
            position = self.lesson.positions[self.place]
            self.lesson.set_grip(self.place, not position.grips, position.squeeze)

    def switch_repeats(self) -> None:
        """A run goes round and round, or once."""
        self.manner = replace(self.manner, repeats=not self.manner.repeats)

    def use_delay(self, speed: int) -> None:
        """Another D for its `@STEP`s."""
        self.manner = replace(self.manner, speed=speed)

    def mark(self, place: int) -> None:
        """Mark a point."""
        self.place = min(max(place, 0), len(self.lesson) - 1) if len(self.lesson) else None

    def problem(self, position: Position) -> str:
        """Why the arm cannot go to a point; empty if it can."""
        stance = self.stance
        if not position.same_zero(Position.taken(stance).zero):
            return (
                f"{position.name}: the registers count from elsewhere since it was taught "
                "(@RESET, a slip, or a hand on the arm)"
            )
        found = stance.at(position.registers).problem
        # The cable of a hand that holds is tighter than the part is wide.
        return f"{position.name} is out of reach: {found}" if found else ""

    def _problem_of_all(self) -> str:
        return next(filter(None, map(self.problem, self.lesson.positions)), "")

    def go_to(self, place: int, *, back: bool = False) -> None:
        """Go to a point, and do there what the hand does on arrival.

        Args:
            place: in the list.
            back: whether it undoes the way from that point: the hand first, then the arm.
        """
        self._begin()
        position = self.lesson.positions[place]
        if problem := self.problem(position):
            self.message = f"{problem}."
            return
        move = move_between(Position.taken(self.stance), position)
        lines = commands(move, self.manner.speed, back=back)
        self._queue.extend(map(_Order, lines))
        self._arrive(place)

    def _arrive(self, place: int) -> None:
        """The last line that waits leads to a point."""
        if self._queue:
            self._queue.append(_Order(self._queue.pop().text, arrives=place))
        else:
            self.place = place

    def step(self, by: int) -> None:
        """Go with the arm to the next point (1), or back to the one before (-1)."""
        if self.place is None:
            self._begin()
            self.message = "There is no point yet."
            return
        place = self.place + by
        if 0 <= place < len(self.lesson):
            self.go_to(place, back=by < 0)
        else:
            self._begin()
            self.message = f"That is the {'last' if by > 0 else 'first'} point."

    def run(self) -> None:
        """Go through all points once, or round and round, as a program of them does."""
        self._begin()
        if not len(self.lesson):
            self.message = "There is no point yet."
            return
        if problem := self._problem_of_all():
            self.message = f"{problem}. Nothing moves."
            return
        self.go_to(0)
        way: list[_Order] = []
        for number, move in enumerate(moves(self.lesson.positions, self.manner), start=1):
            lines = commands(move, self.manner.speed)
            way += map(_Order, lines[:-1])
            way += (_Order(line, arrives=number % len(self.lesson)) for line in lines[-1:])
        self._queue.extend(way)
        if self.manner.repeats:
            self._round = way

    # -- programs ---------------------------------------------------------------------------------

    def program(self, *, in_coordinates: bool) -> Written:
        """The program of the points, in Table 4's style or Table 3's."""
        model = self._rig.arm.model
        return written(self.lesson, self.manner, model, in_coordinates=in_coordinates)

    def read_memory(self) -> str:
        """Have the points of the program in the machine's memory.

        Returns:
            Why it cannot be read; empty when it was.
        """
        return self._read(self._session.program)

    def read_file(self, path: Path) -> str:
        """Have the points of a program file.

        Returns:
            Why it cannot be read; empty when it was.
        """
        try:
            return self._read(load_program(path))
        except (FileFormatError, OSError) as error:
            return one_line(error)

    def _read(self, lines: Sequence[tuple[int, bytes]]) -> str:
        self._begin()
        listing = "".join(f"{line_text(line)}\n" for line in lines)
        try:
            points = read_points(listing, self.stance)
        except ListingError as error:
            return str(error)
        self.lesson.replace(points.positions)
        self.lesson.written()
        self.manner = points.manner
        self.place = 0
        self.message = f"{len(points.positions)} points were read."
        return ""


def _unhurried(rig: Rig) -> int:
    """The D, in tens, at which each motor of the arm follows while the hand is empty.

    It is the article's own 50 for the MiniMover; a `@STEP` makes a half-step in 1.2 + 0.03 D ms.
    """
    arm = rig.arm
    slowest = max(curve.period(0.0, arm.settings.speed_margin) for curve in arm.strength.curves)
    least = (1000 * slowest / T_STATES_PER_SECOND - 1.2) / 0.03
    return min(max(0, math.ceil(least / 10) * 10), MOST_DELAY)


def _works(rig: Rig) -> bool:
    """Whether a line is typed or carried out."""
    return rig.typing or rig.waiting is Waiting.NOTHING


def _moves(rig: Rig) -> bool:
    """Whether a motion is under way."""
    return rig.driver.next_tick is not None


def _moves_or_rests(rig: Rig) -> bool:
    """Whether what was typed has led to a motion, or to its end."""
    return _moves(rig) or not _works(rig)


def _line_is_empty(rig: Rig) -> bool:
    """Whether the cursor stands right behind a prompt."""
    cell = rig.cursor
    if cell is None or cell % COLUMNS == 0:
        return False
    before = rig.video.lines()[cell // COLUMNS][: cell % COLUMNS]
    return before.strip() == ">"
