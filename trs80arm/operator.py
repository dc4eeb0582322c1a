"""A person at the keyboard, from a script: answers INPUT, and jogs the arm in `@SET`.

The command line's `--input` and `--set` and many tests sit a scripted operator in front of a rig.
It does what a person would do and no more: it types when the machine waits, and holds keys down.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from trs80arm.basic.activity import Waiting
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.keys import Key
from trs80arm.rig import LONGEST_HOLD, Rig

HAND_PAUSE = 0.1
"""Seconds between two holds, and how long the ending key is held: a person's fingers."""
GLANCE = 0.25
"""Virtual seconds between two looks at a run."""
_TICK = 1 / T_STATES_PER_SECOND
_ANSWERED_BY_KEYS = (Waiting.NOTHING, Waiting.INPUT, Waiting.SET)
"""What a key that is still to be pressed can bring on."""


class ScriptError(ValueError):
    """A line of holds that cannot be understood; the message says what was found."""


@dataclass(frozen=True)
class Hold:
    """Keys held down together for some seconds."""

    keys: tuple[Key, ...]
    seconds: float


def parse_holds(text: str) -> list[Hold]:
    """Read what the operator does in one `@SET`.

    Args:
        text: items separated by blanks, each `KEYS:SECONDS` with keys joined by `+`, or a key alone
            for a short press: `"6:1.0 1+W:0.5 0"`.

    Raises:
        ScriptError: an item is not of that form, names a key that the TRS-80 lacks or lasts longer
            than a key can be held.
    """
    holds = []
    for item in text.split():
        match = re.fullmatch(r"(?P<keys>.+?)(?::(?P<seconds>\d+(?:\.\d*)?|\.\d+))?", item)
        names = match["keys"].upper().split("+") if match else []
        try:
            keys = tuple(Key(name) for name in names)
        except ValueError:
            raise ScriptError(
                f"{item!r} is not KEYS:SECONDS with keys of the TRS-80 joined by +"
            ) from None
        seconds = match["seconds"] if match else None
        if seconds is not None and not float(seconds) <= LONGEST_HOLD:
            raise ScriptError(
                f"a key can be held for {LONGEST_HOLD:.0f} seconds, not {seconds[:40]}"
            )
        holds.append(Hold(keys, HAND_PAUSE if seconds is None else float(seconds)))
    return holds


class Operator:
    """Works a rig from a script until the script has no answer left.

    Args:
        rig: the rig to sit at.
        inputs: the answers to INPUT, in order, each typed with ENTER.
        sets: what to do in each `@SET`, in order.
        keys: what to hold down at times of the rig's clock in seconds, in order, whatever goes on.
        look: called every `GLANCE` virtual seconds or so while `run` lets time pass.
    """

    def __init__(
        self,
        rig: Rig,
        inputs: Iterable[str] = (),
        sets: Iterable[Iterable[Hold]] = (),
        keys: Iterable[tuple[float, Hold]] = (),
        look: Callable[[Rig], None] | None = None,
    ) -> None:
        self.rig = rig
        self._look = look
        self._inputs = deque(inputs)
        self._sets = deque(list(holds) for holds in sets)
        self._keys = deque(keys)
        self._holds: deque[Hold] = deque()
        self._busy_until = 0.0

    def answer(self, text: str) -> None:
        """Have an answer more to INPUT, after those that there are."""
        self._inputs.append(text)

    def jog(self, holds: Iterable[Hold]) -> None:
        """Have something more to do in an `@SET`, after what there is."""
        self._sets.append(list(holds))

    def run(self, seconds: float) -> Waiting:
        """Let the program run, with the operator's help.

        Args:
            seconds: the most virtual time to spend.

        Returns:
            What the machine waits for that the script does not have; NOTHING at the time limit.
        """
        rig = self.rig
        end = rig.time + seconds
        while rig.time < end:
            due = self._press_due(end)
            until = self._glance(due)
            waiting = rig.run_until_waiting(until - rig.time)
            if until < due and until - rig.time < _TICK:
                continue  # It is not settled what the machine waits for.
            if waiting is Waiting.INPUT and self._inputs:
                rig.type(self._inputs.popleft() + "\r")
            elif waiting is Waiting.SET and self._sets:
                self._jog(self._sets.popleft(), end)
            elif waiting in _ANSWERED_BY_KEYS and due < end:
                self._pass(due - rig.time, end)
            else:
                return waiting
        return Waiting.NOTHING

    def attend(self) -> bool:
        """Do what is due now, for whoever lets time pass himself.

        Returns:
            Whether anything is still to come: the program runs, or waits for what the script has.
        """
        rig = self.rig
        if rig.time < self._busy_until or rig.typing:
            return True
        waiting = rig.waiting
        if waiting is Waiting.INPUT and self._inputs:
            rig.type(self._inputs.popleft() + "\r")
        elif waiting is Waiting.SET and (self._holds or self._sets):
            if not self._holds:
                self._holds.extend(self._sets.popleft())
            hold = self._holds.popleft()
            rig.hold(hold.keys, hold.seconds)
            self._busy_until = rig.time + hold.seconds + HAND_PAUSE
        else:
            self._holds.clear()
            return waiting is Waiting.NOTHING
        return True

    def _jog(self, holds: list[Hold], end: float) -> None:
        """Do all the holds of one manual mode, while it lasts."""
        rig = self.rig
        for hold in holds:
            if rig.waiting is not Waiting.SET or rig.time >= end:
                return
            rig.hold(hold.keys, hold.seconds)
            self._pass(hold.seconds, end)
            self._pass(HAND_PAUSE, end)

    def _press_due(self, end: float) -> float:
        """Hold the keys whose time has come; until when nothing more is due."""
        while self._keys and self._keys[0][0] - self.rig.time < _TICK:
            hold = self._keys.popleft()[1]
            self.rig.hold(hold.keys, hold.seconds)
        return min(end, self._keys[0][0]) if self._keys else end

    def _glance(self, until: float) -> float:
        """Look, if anybody does; until when time may pass before the next look."""
        if self._look is None:
            return until
        self._look(self.rig)
        return min(until, self.rig.time + GLANCE)

    def _pass(self, seconds: float, end: float) -> None:
        """Let time pass, not beyond the end; keys are held at theirs."""
        rig = self.rig
        target = min(rig.time + seconds, end)
        while target - rig.time >= _TICK:
            if not rig.run_for(self._glance(min(target, self._press_due(end))) - rig.time):
                return
