"""The programs that come along write under a real ROM what they write with the built-in driver."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from itertools import takewhile

import pytest

from tests.machine.armbasic_z80.assembled import driver
from tests.machine.armbasic_z80.board import Board, lateness, patterns
from tests.machine.armbasic_z80.rom_machine import ROM, SETTINGS, under_the_rom
from tests.machine.bench_top import Analyser, Write
from tests.own_places import PROGRAMS
from tests.rig.test_bundled_programs import ANSWERS, ENDLESS, LONGEST, SETS
from trs80arm.arm import benchfile
from trs80arm.machine.card import Latch, Peripheral
from trs80arm.machine.coordination import Pace
from trs80arm.operator import Hold, parse_holds
from trs80arm.pulses import Burst
from trs80arm.rig import Rig, Waiting

pytestmark = pytest.mark.skipif(ROM is None, reason="TRS80ARM_TEST_ROM names no ROM")

TOLERANCE = 0.02
"""Of a tick."""
NORMAL = 50
"""D of an @SET without one."""


@dataclass
class Motion:
    """A motion of the built-in driver: where its writes begin, when it began, its D."""

    first: int
    start: int
    delay: int
    closes: bool
    stop: int = 0
    """The write behind its last one."""


@dataclass
class Run:
    """What a run wrote, and its motions."""

    writes: list[Write]
    motions: list[Motion] = field(default_factory=list)


@dataclass
class AsItClosed:
    """The arm on its bench; but in an @CLOSE the grip switch closes where it did in another run.

    What lies on a bench moves on a grid of time, so a hand that closes two milliseconds later may
    need a half step more or less.
    """

    plug: Peripheral
    motions: list[Motion]
    written: Analyser

    def follow(self, burst: Burst, stop: tuple[int, int] | None = None) -> int:
        return self.plug.follow(burst, stop)

    def inputs(self, time: int) -> int:
        inputs, done = self.plug.inputs(time), len(self.written.writes)
        closing = next((each for each in self.motions if each.first <= done <= each.stop), None)
        if closing is None:
            return inputs
        return inputs & 0b1110 | (done < closing.stop)


def note_motions(rig: Rig, run: Run) -> None:
    """Take note of the motions that the built-in driver begins."""
    built_in = rig.driver

    def noting(begin: Callable[..., None], closes: bool) -> Callable[..., None]:
        def noted(delay: int | None = None, *rest: object) -> None:
            first = len(run.writes)
            normal = NORMAL if delay is None else delay
            run.motions.append(Motion(first, rig.clock.now, normal, closes))
            begin(delay, *rest)

        return noted

    for name in ("step", "close", "set"):
        setattr(built_in, name, noting(getattr(built_in, name), name == "close"))


def first_tick(rig: Rig) -> int:
    """When manual mode, just begun, looks at the keys first."""
    if rig.settings.rom is None:
        time = rig.driver.next_tick
        assert time is not None
        return time
    board = Board()
    assert board.call_at(driver().origin + 9, de=NORMAL, limit=20_000) is False
    assert board.looked is not None
    return rig.clock.now + board.looked


def jog(rig: Rig, holds: Iterable[Hold]) -> None:
    """Hold keys in manual mode, from half a tick before a tick to half a tick before another."""
    start, (over, under) = first_tick(rig), Pace(0, NORMAL).ratio
    tick = 2.5
    for hold in holds:
        rig.run_to(start + int(tick * over / under))
        for key in hold.keys:
            rig.press(key)
        tick += round(hold.seconds / 0.0027)
        rig.run_to(start + int(tick * over / under))
        for key in hold.keys:
            rig.release(key)
        tick += 3


def play(rig: Rig, name: str, seconds: float) -> None:
    """Run a program with its operator, as in the test of the bundled programs."""
    rig.load(PROGRAMS / f"{name}.bas")
    inputs = list(ANSWERS.get(name, ()))
    sets = [parse_holds(holds) for holds in SETS.get(name, ())]
    rig.type("RUN\r")
    end = rig.time + seconds
    while rig.time < end:
        waiting = rig.run_until_waiting(end - rig.time)
        if waiting is Waiting.INPUT and inputs:
            rig.type(inputs.pop(0) + "\r")
        elif waiting is Waiting.SET and sets:
            jog(rig, sets.pop(0))
        else:
            return


@pytest.mark.parametrize("name", sorted(path.stem for path in PROGRAMS.glob("*.bas")))
def test_a_program_writes_what_it_writes_with_the_built_in_driver(name: str) -> None:
    seconds = 5.0 if name == "table2" else min(ENDLESS.get(name, LONGEST), LONGEST)
    file = PROGRAMS / f"{name}.toml"
    bench = benchfile.load(file) if file.exists() else benchfile.load(PROGRAMS / "table4.toml")
    written = Analyser()
    reference, rig = Run(written.writes), Rig(SETTINGS, bench)
    rig.watch_latches(written)
    note_motions(rig, reference)
    play(rig, name, seconds)
    begins = [motion.first for motion in reference.motions]
    for motion, behind in zip(reference.motions, [*begins, None][1:], strict=True):
        motion.stop = motion.first + _own(reference.writes[motion.first : behind], motion)
    closes = [motion for motion in reference.motions if motion.closes]

    other, mine = under_the_rom(), Analyser()
    other.set_bench(bench)
    other.watch_latches(mine)
    other.card.plug = AsItClosed(other.card.plug, closes, mine)
    play(other, name, seconds)

    count = min(len(mine.writes), len(reference.writes))
    if name not in ENDLESS and name != "table2":
        assert len(mine.writes) == len(reference.writes)
    assert count > 5
    assert patterns(mine.writes[:count]) == patterns(reference.writes[:count])
    for motion in reference.motions:
        span = slice(motion.first, min(motion.stop, count))
        if mine.writes[span]:
            late = lateness(mine.writes[span], reference.writes[span], motion.start)
            assert max(map(abs, late)) <= TOLERANCE * _period(motion)


def _period(motion: Motion) -> float:
    over, under = Pace(0, motion.delay).ratio
    return over / under


def _own(writes: Iterable[Write], motion: Motion) -> int:
    """How many of the writes from its beginning on are a motion's.

    What BASIC writes behind it with OUT or @RESET has times of its own.
    """
    return len(list(takewhile(lambda write: _on_tick(write, motion), writes)))


def _on_tick(write: Write, motion: Motion) -> bool:
    """Whether a write may be one of a motion."""
    time, latch, nibble = write
    pace = Pace(motion.start, motion.delay)
    moves = nibble and (latch == Latch.HAND if motion.closes else latch != Latch.AUXILIARY)
    return bool(moves) and time == pace.time(pace.first_tick_from(time))
