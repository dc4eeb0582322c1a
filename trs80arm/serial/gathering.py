"""Latch writes gathered into legs: straight pieces of a motion, short enough to be one command.

Everything that moves the arm, `@STEP`, manual mode, a program's own OUT, comes down as patterns on
the card's latches. A TeachMover takes whole moves. So the half-steps that the patterns make are
added up for as long as all motors go evenly, and at most for half a second: a leg is then one
`@STEP` of the other arm, which goes the same way in the same time.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from trs80arm.arm.motors import RING, ROWS
from trs80arm.machine.card import MOTORS
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.pulses import Series

LONGEST = 0.5
"""Seconds that a leg takes at most: what was sent can only be stopped at its end."""
PAUSE = 0.1
"""Seconds without a half-step after which a leg is over."""
LONE_RATE = 50.0
"""Half-steps a second of a half-step that came alone, so that it has no rate of its own."""
_CROOKED = 3
"""Half-steps that a motor may be off the straight way within a leg."""
_LOOK = T_STATES_PER_SECOND // 32
"""T-states between two looks at whether the way is straight."""


@dataclass(frozen=True)
class Leg:
    """A straight piece of a motion.

    Attributes:
        counts: half-steps of the six motors.
        rate: half-steps a second of the motor that makes most of them.
    """

    counts: tuple[int, ...]
    rate: float

    @property
    def seconds(self) -> float:
        """How long it takes."""
        return max(map(abs, self.counts)) / self.rate


@dataclass
class _Begun:
    """A leg that is growing.

    Attributes:
        start: T-state at which it begins.
        goes_on: whether the motion was under way there already.
        end: T-state of its last half-step.
        counts: half-steps up to there.
        looks: T-states and counts along the way; the last of them stands where all is straight.
    """

    start: int
    goes_on: bool
    end: int
    counts: list[int] = field(default_factory=lambda: [0] * len(MOTORS))
    looks: list[tuple[int, list[int]]] = field(default_factory=list)

    def straight(self) -> bool:
        """Whether the looks so far lie on the straight way from the start to the end."""
        span = self.end - self.start
        return all(
            abs(count - whole * (time - self.start) / span) <= _CROOKED
            for time, counts in self.looks
            for count, whole in zip(counts, self.counts, strict=True)
        )

    def leg(self) -> Leg:
        """It, as far as it has come."""
        most = max(map(abs, self.counts))
        spaces, span = most - (not self.goes_on), self.end - self.start
        rate = spaces * T_STATES_PER_SECOND / span if spaces > 0 and span > 0 else LONE_RATE
        return Leg(tuple(self.counts), rate)


class Gathering:
    """Adds half-steps up.

    Args:
        rows: the row of Figure 8 in which each motor stands now.
    """

    def __init__(self, rows: Iterable[int]) -> None:
        self._rows = [row % RING for row in rows]
        self._begun: _Begun | None = None

    def turns(self, times: Series, latches: Series, nibbles: Series) -> Iterator[tuple[int, ...]]:
        """What latch writes turn, as T-state, motor and half-steps; the latches are taken note of.

        A pattern without a field turns nothing, nor does one that points exactly the other way.
        """
        for time, latch, nibble in zip(times, latches, nibbles, strict=True):
            if latch >= len(MOTORS):
                continue
            row = ROWS[nibble]
            if row < 0:
                continue
            turn = (row - self._rows[latch] + RING // 2) % RING - RING // 2
            if turn not in (0, -RING // 2):
                self._rows[latch] = row
                yield int(time), int(latch), int(turn)

    def take(self, turns: Iterable[tuple[int, ...]]) -> Iterator[Leg]:
        """Go on with half-steps.

        Returns:
            The legs that are over by them.
        """
        for time, motor, turn in turns:
            begun = self._begun
            if begun is not None and time > begun.end:
                yield from self._look(begun, time)
                begun = self._begun
            if begun is None:
                begun = self._begun = _Begun(time, goes_on=False, end=time)
            begun.counts[motor] += turn
            begun.end = time

    def _look(self, begun: _Begun, time: int) -> Iterator[Leg]:
        """Before a half-step at a T-state: whether the leg ends here, or has ended before."""
        if time - begun.end > PAUSE * T_STATES_PER_SECOND:
            yield from self.end()
            return
        if begun.end - (begun.looks[-1][0] if begun.looks else begun.start) < _LOOK:
            return
        if not begun.straight():
            yield from self._cut(begun)
        elif begun.end - begun.start >= LONGEST * T_STATES_PER_SECOND - _LOOK:
            yield begun.leg()
            self._begun = _Begun(begun.end, goes_on=True, end=begun.end)
        else:
            begun.looks.append((begun.end, list(begun.counts)))

    def _cut(self, begun: _Begun) -> Iterator[Leg]:
        """End a leg at the last look, where it was straight; what came since begins another."""
        *looks, (time, counts) = begun.looks
        rest = [now - then for now, then in zip(begun.counts, counts, strict=True)]
        if any(counts):
            yield _Begun(begun.start, begun.goes_on, time, counts, looks).leg()
        self._begun = _Begun(time, goes_on=True, end=begun.end, counts=rest)

    def settle(self, now: int) -> Iterator[Leg]:
        """End the leg if nothing has moved for a while.

        Args:
            now: T-state.
        """
        if self._begun and now - self._begun.end > PAUSE * T_STATES_PER_SECOND:
            yield from self.end()

    def end(self) -> Iterator[Leg]:
        """End the leg here."""
        if self._begun is not None and self._begun.looks and not self._begun.straight():
            yield from self._cut(self._begun)
        begun, self._begun = self._begun, None
        if begun is not None and any(begun.counts):
            yield begun.leg()

    @property
    def under_way(self) -> bool:
        """Whether a leg is growing."""
        return self._begun is not None
