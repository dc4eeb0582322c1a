"""Virtual time passes for the works of a rig."""

from __future__ import annotations

from collections.abc import Callable

from trs80arm.basic.activity import Waiting
from trs80arm.machine.clock import END_OF_TIME, T_STATES_PER_SECOND
from trs80arm.machine.driver import Mode
from trs80arm.works.devices import Works
from trs80arm.works.key_events import KeyEvents
from trs80arm.works.observers import Observers, attach

_FRAME = T_STATES_PER_SECOND // 60
"""T-states after which whoever waits for something looks again."""


class Running:
    """Lets works run.

    Args:
        works: the devices.
        keys: what is about to happen to their keys.
        observers: who looks at them, and before which statements `run_to` is to stop.
    """

    def __init__(self, works: Works, keys: KeyEvents, observers: Observers) -> None:
        self._works = works
        self._keys = keys
        self._observers = observers

    def run_for(self, seconds: float) -> bool:
        """Let `seconds` of virtual time pass, counted from where the last run was to end.

        Returns:
            Whether they have passed: not if the machine was stopped.

        Raises:
            ValueError: that is no time, or after `END_OF_TIME`.
        """
        if not 0 <= seconds <= END_OF_TIME / T_STATES_PER_SECOND:
            raise ValueError(f"time cannot pass for {seconds} seconds")
        return self.run_to(self._works.asked + round(seconds * T_STATES_PER_SECOND))

    def run_to(self, target: int) -> bool:
        """Run until the clock shows at least `target` T-states.

        Returns:
            Whether it does: not if the machine was stopped before a statement.

        Raises:
            ValueError: that is after `END_OF_TIME`.
        """
        if target > END_OF_TIME:
            raise ValueError("the clock does not go that far")
        works = self._works
        works.asked = max(works.asked, target)
        clock, stops, code_stops = works.clock, self._observers.stops, self._observers.code_stops
        stops.heeded = code_stops.heeded = True
        stops.reached = code_stops.reached = False
        try:
            while clock.now < target:
                self._turn(target, until_waiting=works.typist.looks_up)
                if stops.reached or code_stops.reached:
                    works.asked = clock.now
                    return False
        finally:
            stops.heeded = code_stops.heeded = False
        return True

    def run_until(self, condition: Callable[[], bool], seconds: float) -> bool:
        """Run until `condition()` holds; it is looked at each time a wait begins, too.

        Returns:
            Whether it holds, after at most `seconds` of virtual time.
        """
        works = self._works
        end = works.clock.now + round(seconds * T_STATES_PER_SECOND)
        while not condition():
            if works.clock.now >= end:
                return False
            self._turn(min(end, works.clock.now + _FRAME), until_waiting=True)
            works.asked = works.clock.now
        return True

    def run_until_line(self, line: int, seconds: float) -> bool:
        """Run until the program is about to execute the first statement of a line.

        Returns:
            Whether it got there, after at most `seconds` of virtual time.
        """
        works = self._works
        standing, begun = works.basic.next_address, works.clock.now

        def reached(address: int) -> bool:
            if address == standing and works.clock.now == begun:
                return False
            link = works.basic.program.find(line)
            return link is not None and address == link - 1

        end = attach(self._observers.stops.conditions, reached)
        try:
            return not self.run_to(begun + round(seconds * T_STATES_PER_SECOND))
        finally:
            end()

    def run_until_text(self, text: str, seconds: float) -> bool:
        """Run until a text has been sent to the display since now.

        Returns:
            Whether it was, after at most `seconds` of virtual time.
        """
        printed = bytearray()
        wanted = text.replace("\n", "\r").encode("latin-1", errors="replace")
        end = attach(self._observers.codes, lambda code, is_echo: printed.append(code))
        try:
            return self.run_until(lambda: wanted in printed, seconds)
        finally:
            end()

    def run_until_waiting(self, seconds: float) -> Waiting:
        """Run until everything typed is in and the machine waits for the operator again.

        Returns:
            What it waits for; NOTHING if it still works after that many virtual seconds.
        """
        works = self._works
        end = works.clock.now + round(seconds * T_STATES_PER_SECOND)
        while works.clock.now < end:
            self._keys.move()
            if works.basic.waiting is not Waiting.NOTHING and not (
                works.typist.pending or works.events
            ):
                break
            self._turn(end, until_waiting=True)
            works.asked = works.clock.now
        return works.basic.waiting

    def step_statement(self) -> int | None:
        """Do one statement of BASIC, or of what the machine does instead.

        Returns:
            The number of the line that is next; None when no program runs.
        """
        works = self._works
        clock = works.clock
        before = clock.now
        # The motions of a computer in the arm's base are none of the statement's.
        own = works.controller is None
        while clock.now == before or (own and works.driver.mode in (Mode.STEP, Mode.CLOSE)):
            self._keys.move()
            clock.limit = clock.now + _FRAME
            works.basic.step_statement()
        self._arm_advances()
        works.asked = clock.now
        return works.basic.next_line

    def _turn(self, target: int, until_waiting: bool) -> None:
        """Hand the machine one stretch of time in which no key changes."""
        works, keys = self._works, self._keys
        clock, typist, basic = works.clock, works.typist, works.basic
        works_on = basic.waiting is Waiting.NOTHING
        for time, key, down in typist.due(clock.now, not works_on):
            keys.add(time, key, down, typed=True)
        keys.move()
        limit = target
        key_time, look = keys.next_time, typist.next_look
        if key_time is not None and key_time < limit:
            limit = key_time
        if look is not None and clock.now < look < limit:
            limit = look
        clock.limit = limit
        # A machine that waits already is not asked to stop at the wait that it is in.
        basic.advance(until_waiting=until_waiting and works_on)
        self._arm_advances()

    def _arm_advances(self) -> None:
        """Let the arm, and the computer in its base, come to where the clock is."""
        works = self._works
        now = works.clock.now
        if works.controller is not None:
            works.controller.advance(now)
        # What falls goes on falling while nobody steps a motor.
        works.arm.advance(now)
