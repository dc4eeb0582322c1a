"""The debugger: it stops a program before a statement, goes on by one, over, out, or back.

A stopped machine is no other machine: no time passes at the desk (`Session.halted`), and a program
that was stopped a hundred times has the same run at the same T-states as one that never was.
Nothing is watched while there are no breakpoints and nobody steps.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Any

from trs80arm import inspection
from trs80arm.desk import watches
from trs80arm.desk.session import Session
from trs80arm.desk.watches import Watch
from trs80arm.inspection import Spot, next_spot, spot_at
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.rig import Rig

SLICE = T_STATES_PER_SECOND // 60
"""T-states between two looks at whether a step is done."""
LONGEST_STATEMENT = 60 * T_STATES_PER_SECOND
"""T-states after which one statement, a motion perhaps, is left to go on by itself."""
LONGEST_WALK = T_STATES_PER_SECOND
"""The same for a subroutine, or a run to a line."""
_MOST_STOPS = 1000

_SIGNS: dict[str, Callable[[Any, Any], bool]] = {
    "=": operator.eq,
    "<>": operator.ne,
    "<=": operator.le,
    ">=": operator.ge,
    "<": operator.lt,
    ">": operator.gt,
}
_COMPARISON = re.compile(r"(.+?)\s*(<>|<=|>=|=|<|>)\s*(.+)")
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)(E[+-]?\d+)?")


class Reason(Enum):
    """Why the machine stands."""

    STEP = "step"
    BREAKPOINT = "breakpoint"
    WATCH = "watch"
    LINE = "the line asked for"
    CODE = "machine code"
    BACK = "back"
    ENDED = "ended"


@dataclass(frozen=True)
class Stop:
    """The machine stands.

    Attributes:
        reason: why.
        text: where and why, in words.
        spot: the statement that it stands before, or that ended the program; None if none.
    """

    reason: Reason
    text: str
    spot: Spot | None


@dataclass(frozen=True)
class Condition:
    """A comparison of a variable with a number, a text in quotes, or another variable.

    Attributes:
        text: as it was typed, in capitals but for quotes.
        left: a name.
        sign: `=`, `<>`, `<`, `>`, `<=` or `>=`.
        right: a name, a number or a text in quotes.
    """

    text: str
    left: str
    sign: str
    right: str

    @classmethod
    def parse(cls, text: str) -> Condition:
        """Read one.

        Raises:
            ValueError: it is none; one line that says how it looks.
        """
        found = _COMPARISON.fullmatch(text.strip())
        if found is None:
            raise ValueError('a condition compares, as I>10 or A$="X"')
        left, sign, right = found.groups()
        if not right.startswith('"'):
            right = right.upper()
        condition = cls(f"{left.upper()}{sign}{right}", left.upper(), sign, right)
        if not re.match(r"[A-Z]", condition.left) or not _is_operand(right):
            raise ValueError('a condition compares, as I>10 or A$="X"')
        return condition

    def holds(self, rig: Rig) -> bool:
        """Whether it holds now; it does not while one of its variables is not there."""
        try:
            left, right = inspection.value_of(rig, self.left), self._right(rig)
        except LookupError:
            return False
        if isinstance(left, str) is not isinstance(right, str):
            return False
        if not isinstance(left, str):
            left, right = inspection.as_number(left), inspection.as_number(right)
        return _SIGNS[self.sign](left, right)

    def _right(self, rig: Rig) -> Any:
        if self.right.startswith('"'):
            return self.right.strip('"')
        if _NUMBER.fullmatch(self.right):
            return float(self.right)
        return inspection.value_of(rig, self.right)


def _is_operand(text: str) -> bool:
    return bool(text.startswith('"') or _NUMBER.fullmatch(text) or re.match(r"[A-Z]", text))


def _line_begun(rig: Rig, address: int) -> int | None:
    """The number of the line that begins behind a separator; None if a later statement does."""
    program = rig.basic.program
    if rig.memory.ram[address] or address < program.start - 1:
        return None
    return program.number_at(address + 1)


class Debugger:
    """Stops the machine of a sitting, and moves it on and back.

    Args:
        session: the sitting.

    Attributes:
        breakpoints: the lines before which it stops, each with its condition or None.
        watches: what it stops behind a change of, by name.
    """

    def __init__(self, session: Session) -> None:
        self.session = session
        self.breakpoints: dict[int, Condition | None] = {}
        self.watches: dict[str, Watch] = {}
        self._goal: Callable[[Rig, int], bool] | None = None
        self._goal_reason = Reason.STEP
        self._passed: tuple[int, int] | None = None
        self._stop: Stop | None = None
        self._told: Stop | None = None
        self._stops: list[int] = []
        self._outcome: object = None
        self._runs = False
        self._used = False
        self._unstop: Callable[[], None] | None = None
        session.watch_machine(self._start_afresh)

    def _start_afresh(self) -> None:
        """The machine was switched off and on, or is another one."""
        self._goal = None
        self._stop = self._told = None
        self._stops.clear()
        self._outcome = self.rig.basic.outcome
        names = list(self.watches)
        self._end_watches()
        self.watches = {name: watches.watch(lambda: self.rig, name) for name in names}
        self._watch(anew=True)

    def _watch(self, *, anew: bool = False) -> None:
        """Be asked before each statement while there is something to stop for, and only then."""
        wanted = bool(self.breakpoints or self.watches) or self._goal is not None
        if self._unstop is not None and (anew or not wanted):
            self._unstop()
            self._unstop = None
        if wanted and self._unstop is None:
            self._unstop = self.rig.stop_before(self._asked)

    @property
    def rig(self) -> Rig:
        """The machine."""
        return self.session.rig

    # -- where it stands --------------------------------------------------------------------------

    @property
    def stop(self) -> Stop | None:
        """Why and where the machine stands; None while it goes."""
        return self._stop if self.session.halted else None

    @property
    def waits_to_stop(self) -> bool:
        """Whether a step is under way: the machine works, or waits for its operator."""
        return self._goal is not None

    @property
    def spot(self) -> Spot | None:
        """The statement that is next, or under way, or that ended the program; None if none is."""
        stop = self.stop
        if stop is not None and stop.reason is Reason.ENDED:
            return stop.spot
        return next_spot(self.rig)

    def new_stop(self) -> Stop | None:
        """A stop that was not told yet, told once; else None."""
        self._look_at_the_end()
        stop = self.stop
        if stop is self._told:
            return None
        self._told = stop
        return stop

    # -- breakpoints ------------------------------------------------------------------------------

    def set(self, line: int, condition: str = "") -> None:
        """Stop before a line from now on, always or only when a condition holds.

        Raises:
            ValueError: there is no such line, or that is no condition.
        """
        self._check(line)
        self.breakpoints[line] = Condition.parse(condition) if condition.strip() else None
        self.breakpoints = dict(sorted(self.breakpoints.items()))
        self._watch()

    def _check(self, line: int) -> None:
        if self.rig.basic.program.find(line) is None:
            raise ValueError(f"there is no line {line}")

    def toggle(self, line: int) -> None:
        """Stop before a line from now on, or not any more.

        Raises:
            ValueError: there is no such line.
        """
        if line in self.breakpoints:
            self.clear(line)
        else:
            self.set(line)

    def clear(self, line: int | None = None) -> None:
        """Do not stop before a line any more; None: before none, and watch nothing.

        Raises:
            ValueError: it has no breakpoint.
        """
        if line is None:
            self.breakpoints.clear()
            self._end_watches()
        elif line in self.breakpoints:
            del self.breakpoints[line]
        else:
            raise ValueError(f"line {line} has no breakpoint")
        self._watch()

    def watch(self, text: str) -> str:
        """Stop from now on before the statement behind which something has changed.

        Args:
            text: a variable, as `I` or `B$(2)`, a latch, as `latch base`, or an address.

        Returns:
            Its name.

        Raises:
            ValueError: it is none of them.
        """
        made = watches.watch(lambda: self.rig, text)
        if made.name in self.watches:
            made.end()
        else:
            self.watches[made.name] = made
        self._watch()
        return made.name

    def toggle_watch(self, text: str) -> bool:
        """Watch something, or do not any more.

        Returns:
            Whether it is watched now.

        Raises:
            ValueError: it is nothing that can be watched.
        """
        count = len(self.watches)
        name = self.watch(text)
        if len(self.watches) == count:
            self.unwatch(name)
        return name in self.watches

    def unwatch(self, text: str) -> None:
        """Do not stop for that any more.

        Raises:
            ValueError: it was not watched.
        """
        words = " ".join(text.split()).casefold()
        name = next((name for name in self.watches if name.casefold() == words), None)
        if name is None:
            raise ValueError(f"{text.strip()} is not watched")
        self.watches.pop(name).end()
        self._watch()

    def _end_watches(self) -> None:
        for each in self.watches.values():
            each.end()
        self.watches.clear()

    def _look_again(self) -> None:
        for each in self.watches.values():
            each.look_again()

    def breakpoint_at(self, rig: Rig, address: int) -> bool:
        """Whether a machine that is about to do the statement at an address stops there."""
        line = _line_begun(rig, address) if self.breakpoints else None
        if line is None or line not in self.breakpoints:
            return False
        condition = self.breakpoints[line]
        return condition is None or condition.holds(rig)

    def _asked(self, address: int) -> bool:
        """Whether to stop before a statement (the rig asks)."""
        rig = self.rig
        moment = (rig.clock.now, address)
        if moment == self._passed:
            return False
        changes = [change for each in self.watches.values() if (change := each.changed())]
        if changes and inspection.is_statement(rig, address):
            self._stand(Reason.WATCH, spot_at(rig, address), address, ", ".join(changes))
            return True
        if self.breakpoint_at(rig, address):
            reason = Reason.BREAKPOINT
        elif (
            self._goal is not None
            and inspection.is_statement(rig, address)
            and self._goal(rig, address)
        ):
            reason = self._goal_reason
        else:
            return False
        self._stand(reason, spot_at(rig, address), address)
        return True

    def _stand(self, reason: Reason, spot: Spot | None, address: int, changes: str = "") -> None:
        now = self.rig.clock.now
        self._passed = (now, address)
        self._goal = None
        self._used = self._runs = True
        if reason in (Reason.BREAKPOINT, Reason.LINE, Reason.WATCH):
            if not self.session.timeline.behind:
                self._stops = [time for time in self._stops if time < now]
            self._stops = [*self._stops[1 - _MOST_STOPS :], now]
        self._outcome = None
        words = f"{changes}: {_WORDS[reason].lower()}" if changes else _WORDS[reason]
        self._halt(Stop(reason, f"{words} {spot or 'the end'}", spot))

    def _halt(self, stop: Stop) -> None:
        self._stop = stop
        self._told = None
        self.session.halted = True
        self._watch()

    def _look_at_the_end(self) -> None:
        """When the program has ended, a step is over; an error or BREAK in it is shown."""
        rig = self.rig
        outcome = rig.basic.outcome
        if outcome is None:
            self._runs = self._runs or rig.basic.next_address is not None
            self._outcome = None
            return
        if outcome is self._outcome or self.session.halted:
            return
        self._outcome = outcome
        stepped = self._runs and self._goal is not None
        debugged = self._runs and (bool(self.breakpoints or self.watches) or self._used)
        self._runs = self._used = False
        if outcome is self.session.broken_off:
            return
        ended = outcome.ending.value == "end"
        if not stepped and (not debugged or ended or outcome.line is None):
            return
        self._goal = None
        where = "" if outcome.line is None else f" in {outcome.line}"
        if outcome.code is not None:
            words = f"?{outcome.code.letters} Error{where}"
        else:
            words = "The program has ended" if ended else f"Break{where}"
        self._halt(Stop(Reason.ENDED, words, self._ended_at(outcome.line)))

    def _ended_at(self, line: int | None) -> Spot | None:
        """The statement that ended the program, as far as the machine knows it."""
        control = self.rig.basic.state.control
        if line is None or control.resume_line != line or not control.resume_address:
            return None
        return spot_at(self.rig, control.resume_address)

    # -- on ---------------------------------------------------------------------------------------

    def into(self) -> None:
        """Do one statement, or stop before the next if the machine does not stand.

        A motion comes to its end. Where the operator is asked for something, or nothing runs, the
        machine stops as soon as a statement is next.
        """
        self._walk(lambda rig, address: True, Reason.STEP, LONGEST_STATEMENT)

    def over(self) -> None:
        """Do one statement, and a subroutine that it calls with it."""
        deepest = inspection.depth(self.rig)
        self._walk(lambda rig, address: inspection.depth(rig) <= deepest, Reason.STEP, LONGEST_WALK)

    def out(self) -> None:
        """Go on until the subroutine has returned.

        Raises:
            ValueError: the program is in none.
        """
        deepest = inspection.depth(self.rig)
        if not deepest:
            raise ValueError("the program is in no subroutine")
        self._walk(lambda rig, address: inspection.depth(rig) < deepest, Reason.STEP, LONGEST_WALK)

    def run_to(self, line: int) -> None:
        """Go on until a line is next.

        Raises:
            ValueError: there is no such line.
        """
        self._check(line)
        self._walk(
            lambda rig, address: _line_begun(rig, address) == line, Reason.LINE, LONGEST_WALK
        )

    def stand_here(self) -> None:
        """Stand where the machine is now, before the statement that is next or under way.

        A machine at the prompt goes on waiting.
        """
        address = self.rig.basic.next_address
        if address is not None:
            self._stand(Reason.STEP, spot_at(self.rig, address), address)
            self._passed = None

    def stand_in_code(self, text: str) -> None:
        """Stand before an instruction of machine code, for a reason in words."""
        self._goal = None
        self._used = self._runs = True
        self._halt(Stop(Reason.CODE, text, next_spot(self.rig)))

    def go(self) -> None:
        """Let time go on."""
        self._goal = None
        self.session.halted = False
        self._watch()

    def _walk(self, goal: Callable[[Rig, int], bool], reason: Reason, longest: int) -> None:
        """Go on to a goal; what takes longer is under way when this returns."""
        self.go()
        self._goal, self._goal_reason = goal, reason
        self._watch()
        session, clock = self.session, self.rig.clock
        end = clock.now + longest
        while self._goal is not None and session.busy and clock.now < end:
            session.run_for(SLICE / T_STATES_PER_SECOND)
            self._look_at_the_end()

    # -- back -------------------------------------------------------------------------------------

    def back(self) -> bool:
        """Go back to before the last statement; False if nothing is known of one."""
        return self._back(inspection.is_statement)

    def back_to_stop(self) -> bool:
        """Go back to the last breakpoint that was reached, or to where it was stopped before."""
        stops = set(self._stops)
        return self._back(
            lambda rig, address: rig.clock.now in stops or self.breakpoint_at(rig, address)
        )

    def _back(self, wanted: Callable[[Rig, int], bool]) -> bool:
        if not self.session.timeline.back(wanted):
            return False
        address = self.rig.basic.next_address
        assert address is not None
        self._look_again()
        self._stand(Reason.BACK, spot_at(self.rig, address), address)
        return True


_WORDS = {
    Reason.STEP: "Before",
    Reason.BREAKPOINT: "Breakpoint before",
    Reason.WATCH: "Before",
    Reason.LINE: "Before",
    Reason.BACK: "Back before",
}
