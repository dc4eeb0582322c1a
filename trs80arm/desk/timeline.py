"""The way back: what the machine was lately, and how it came from there to here.

A machine is what its operator did to it at which virtual times, so any moment can be had again:
from the last mark before it, a snapshot taken now and then, what was done since is done once more
on a second machine, at the same T-states, and that machine takes the place of the first. What was
done after that moment is not forgotten. While time goes on it is done again, each thing at its own
time, until the operator does something else.

Nothing is written to tape files and paper twice: between a moment that one went back to and the one
from which one did, the machine records and prints in memory.
"""

from __future__ import annotations

from bisect import bisect_right
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, replace

from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.rig import Input, Rig

SHORTEST = T_STATES_PER_SECOND // 4
"""T-states between two marks, at least."""
MOST = 40
"""Marks that are kept; the older, the farther apart."""
LARGEST = 24 << 20
"""Bytes of all marks together."""
WINDOW = T_STATES_PER_SECOND // 16
"""T-states before now that are looked through first for the last statement; marks that are made on
the way back may be as close."""
WIDER = 4
"""How many times as far one looks next."""

Wanted = Callable[[Rig, int], bool]
"""Whether one wants to go back to where a machine is about to do the statement at an address."""


@dataclass(frozen=True)
class Mark:
    """A moment that can be had at once.

    Attributes:
        time: its T-state.
        inputs: how many things the operator had done by then.
        recordings: how many recordings there were on cassettes of the tape folder.
        snapshot: the machine; None if it stood as it begins.
    """

    time: int
    inputs: int
    recordings: int
    snapshot: bytes | None

    @property
    def size(self) -> int:
        """How many bytes are kept."""
        return len(self.snapshot or b"")


class Timeline:
    """What a rig was, is, and will be again.

    Args:
        rig: whose past is kept, from now on.
        cut: is told how many of the things that were done are left when one went back.
        beginning: makes a machine that is as the rig is now. Then nothing is kept of it at first,
            which takes thrice as long as to switch it on; few ever go back so far.
    """

    def __init__(
        self,
        rig: Rig,
        cut: Callable[[int], object] = lambda count: None,
        beginning: Callable[[], Rig] | None = None,
    ) -> None:
        self._rig = rig
        self._cut = cut
        self._beginning = beginning
        self._done: list[Input] = []
        self._future: deque[Input] = deque()
        self._front = 0
        self._behind = False
        self._again = False
        self._marks: list[Mark] = []
        self._stop = rig.record(self._take)
        if beginning is None:
            self.mark()
        else:
            self._keep(Mark(rig.clock.now, 0, len(rig.recordings), None))

    def close(self) -> None:
        """Keep nothing from now on."""
        self._stop()

    @property
    def behind(self) -> bool:
        """Whether the machine stands before a moment at which it has been already."""
        return self._behind

    @property
    def front(self) -> int:
        """The T-state up to which it has been already, if it is `behind`."""
        return self._front

    # -- what is kept -----------------------------------------------------------------------------

    def mark(self) -> None:
        """Keep the machine as it is now, unless that was done a moment ago."""
        now = self._rig.clock.now
        place = self._place(now)
        if place and now - self._marks[place - 1].time < SHORTEST:
            return
        recordings = len(self._rig.recordings)
        if not self._behind:
            self._keep(Mark(now, len(self._done), recordings, self._rig.snapshot()))

    def _keep(self, mark: Mark) -> None:
        """Put a mark in its place; when there are too many, one goes that is missed least."""
        marks = self._marks
        marks.insert(self._place(mark.time), mark)
        while len(marks) > 2 and (
            len(marks) > MOST or sum(other.size for other in marks) > LARGEST
        ):
            now = marks[-1].time + 1
            gaps = {
                place: (marks[place + 1].time - marks[place - 1].time)
                / (now - marks[place - 1].time)
                for place in range(1, len(marks) - 1)
            }
            del marks[min(gaps, key=gaps.__getitem__)]

    def _take(self, done: Input) -> None:
        """Note what the operator does; something new in the past makes another future."""
        if self._behind and not self._again:
            self._diverge()
        self._done.append(done)

    def _diverge(self) -> None:
        """What was to come will not come; keys that it would have let go are let go now."""
        now = self._rig.clock.now
        to_release = [done.arguments[0] for done in self._future if done.action == "release"]
        self._future.clear()
        self._marks = [mark for mark in self._marks if mark.time <= now]
        self._be_here()
        for key in dict.fromkeys(to_release):
            if key in self._rig.held:
                self._rig.release(key)

    def _be_here(self) -> None:
        """This is the latest moment that there was; files are written from now on."""
        self._behind = False
        self._rig.use_places()

    # -- forwards ---------------------------------------------------------------------------------

    def run_to(self, target: int) -> bool:
        """Run to a T-state, doing again what was done; False if the machine was stopped before."""
        rig = self._rig
        while self._future and self._future[0].time <= target:
            if not rig.run_to(self._future[0].time):
                return False
            self._again = True
            try:
                rig.replay([self._future.popleft()])
            finally:
                self._again = False
        if self._behind and target >= self._front:
            if not rig.run_to(self._front):
                return False
            self._be_here()
        return rig.run_to(target)

    # -- back -------------------------------------------------------------------------------------

    def back(self, wanted: Wanted = lambda rig, address: True) -> bool:
        """Go back to the last statement before now that is `wanted`, to where it was to begin.

        Returns:
            Whether there was one; if not, the machine stays where it is.
        """
        end = now = self._rig.clock.now
        earliest = self._marks[0].time
        window = WINDOW
        while True:
            begin = max(earliest, now - window)
            past = self._past(begin)
            past.run_to(begin)
            if past.time < end:
                self._mark_past(past)
                start = past.time
                found = past.last_start(end, wanted)
                if found is not None:
                    self.go_to(found)
                    return True
                end = start
            if begin <= earliest:
                return False
            window *= WIDER

    def go_to(self, time: int) -> None:
        """Go back to a T-state at which a statement was about to begin."""
        past = self._past(time)
        past.stop_at(time)
        inputs = self._inputs
        if not self._behind:
            self._front = self._rig.clock.now
        self._behind = True
        self._done, self._future = inputs[: past.done], deque(inputs[past.done :])
        self._rig.become(past.rig)
        self._cut(past.done)

    @property
    def _inputs(self) -> list[Input]:
        return [*self._done, *self._future]

    def _place(self, time: int) -> int:
        """How many marks are not behind a T-state."""
        return bisect_right(self._marks, time, key=lambda mark: mark.time)

    def _last_mark(self, time: int) -> Mark:
        return self._marks[max(self._place(time) - 1, 0)]

    def _past(self, time: int) -> _Past:
        """A second machine, at the last mark before a T-state."""
        mark = self._last_mark(time)
        snapshot = mark.snapshot
        if snapshot is None:
            assert self._beginning is not None
            snapshot = self._beginning().snapshot()
            self._marks[self._marks.index(mark)] = replace(mark, snapshot=snapshot)
        past = self._rig.past(snapshot, mark.recordings)
        return _Past(past, mark, self._inputs)

    def _mark_past(self, past: _Past) -> None:
        """Keep a moment of the past that will be wanted again."""
        if past.time - self._last_mark(past.time).time >= WINDOW:
            self._keep(Mark(past.time, past.done, past.recordings, past.rig.snapshot()))


class _Past:
    """A second machine, on the way from a mark to a moment.

    Attributes:
        rig: the machine.
        done: how many of the inputs it has had.
    """

    def __init__(self, rig: Rig, mark: Mark, inputs: list[Input]) -> None:
        self.rig = rig
        self.done = mark.inputs
        self._inputs = inputs
        self._recorded_before = mark.recordings

    @property
    def time(self) -> int:
        """Its T-state."""
        return self.rig.clock.now

    @property
    def recordings(self) -> int:
        """How many recordings there are on cassettes of the tape folder."""
        return self._recorded_before + len(self.rig.recordings)

    def run_to(self, time: int) -> None:
        """Run to a T-state, doing what was done up to then."""
        while self.done < len(self._inputs) and self._inputs[self.done].time <= time:
            self.rig.replay([self._inputs[self.done]])
            self.done += 1
        self.rig.run_to(time)

    def last_start(self, end: int, wanted: Wanted) -> int | None:
        """Run to a T-state; when before it the last statement that is wanted was about to begin."""
        found: int | None = None

        def look(address: int) -> bool:
            nonlocal found
            if self.time < end and wanted(self.rig, address):
                found = self.time
            return False

        unlook = self.rig.stop_before(look)
        self.run_to(end)
        unlook()
        return found

    def stop_at(self, time: int) -> None:
        """Stop at a T-state, before the statement that begins there."""
        self.run_to(time)
        unstop = self.rig.stop_before(lambda address: True)
        self.rig.run_to(time + 1)
        unstop()
