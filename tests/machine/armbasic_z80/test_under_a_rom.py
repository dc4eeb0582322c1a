"""The five statements from the tape, under the real ROM, write what the built-in ones do.

Played where `TRS80ARM_TEST_ROM` names a Level II ROM of one's own.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import takewhile
from pathlib import Path

import pytest

from tests.machine.armbasic_z80.assembled import driver, maker
from tests.machine.armbasic_z80.board import Board, lateness, patterns
from tests.machine.bench_top import Analyser, Write
from tests.own_places import PROGRAMS
from tests.rig.test_bundled_programs import ANSWERS, ENDLESS, LONGEST, SETS
from trs80arm.arm import benchfile
from trs80arm.machine.card import Latch, Peripheral
from trs80arm.machine.coordination import Pace
from trs80arm.machine.z80.rom import Rom
from trs80arm.operator import Hold, parse_holds
from trs80arm.pulses import Burst
from trs80arm.rig import Key, Rig, RigSettings, Waiting

ROM = os.environ.get("TRS80ARM_TEST_ROM")
pytestmark = pytest.mark.skipif(ROM is None, reason="TRS80ARM_TEST_ROM names no ROM")

TOLERANCE = 0.02
"""Of a tick."""
NORMAL = 50
"""D of an @SET without one."""
SETTINGS = RigSettings(memory_size="31200")


def load_tape(rig: Rig, size: int = 16) -> None:
    """SYSTEM, its name, `/`, READY."""
    rig.insert_cassette("armbasic", maker().tape_file(size).read_bytes())
    for text, waiting in (
        ("SYSTEM", Waiting.SYSTEM),
        (f"ARM{size}", Waiting.SYSTEM),
        ("/", Waiting.COMMAND),
    ):
        rig.type(text + "\r")
        assert rig.run_until_waiting(120) is waiting
    rig.eject_cassette()


@cache
def with_tape() -> tuple[RigSettings, bytes]:
    """A machine under the ROM that has read the tape."""
    assert ROM is not None
    settings = replace(SETTINGS, rom=Rom.read(Path(ROM)))
    rig = Rig(settings)
    load_tape(rig)
    return settings, rig.snapshot()


def under_the_rom() -> Rig:
    settings, snapshot = with_tape()
    rig = Rig(settings)
    rig.restore(snapshot)
    return rig


@pytest.mark.parametrize("size", [16, 32, 48])
def test_the_tape_loads_and_leads_to_ready(size: int) -> None:
    assert ROM is not None
    answer = str(maker().ORIGINS[size])
    rig = Rig(RigSettings(ram_kib=size, memory_size=answer, rom=Rom.read(Path(ROM))))
    load_tape(rig, size)
    rig.type("@STEP 0,5,-3:@READ A,B:PRINT A;B\r")
    rig.run_until_waiting()
    assert " 5 -3" in rig.screen()[-3] + rig.screen()[-2] + "".join(rig.screen())


# -- what is typed, and what the machine says -----------------------------------------------------

DIALOGUES = r"""
10 @STEP 0,1
20 IF A=0 THEN @STEP 0,0,2:A=1
30 GOSUB 100
40 PRINT "DONE":END
100 FOR I=1 TO 3:IF I>1 THEN @STEP 0,0,0,I ELSE @STEP 0,5
110 NEXT I
120 IF I THEN @RESET:@STEP 0,0,0,0,3
130 RETURN
RUN

10 FOR I=1 TO 200:IF I THEN @STEP 0
20 NEXT:PRINT MEM;I
RUN

10  @STEP 0,1:  @READ A:PRINT A
20 @ STEP 0,1
30 @S T E P 0,1
LIST
RUN

10 DEFINT A-Z:DIM P(6):@STEP 0,1,-2,3,-4,5,-6:@READ P(1),P(2),P(3),P(4),P(5),P(6)
20 FOR I=1 TO 6:PRINT P(I);:NEXT
RUN

10 @STEP 0,4:@STEP 0,-4:REM
20 A=7:@STEP 0,A,A*2,A/2
30 @READ X!,Y#,Z%:PRINT X!;Y#;Z%
RUN

10 ON ERROR GOTO 50
20 @STEP -1
30 PRINT "ON":END
50 PRINT ERR/2+1;ERL:RESUME NEXT
RUN

10 ON ERROR GOTO 30
20 @READ A,B$:END
30 PRINT A;ERR/2+1:RESUME 40
40 PRINT "OK"
RUN

10 TRON
20 @STEP 0,1
30 IF 1 @STEP 0,1
40 PRINT 1
RUN

10 IF 1=1 @STEP 0,3
20 IF 0 @STEP 0,3 ELSE @STEP 0,0,1
30 IF 1 THEN @STEP 0,1:@STEP 0,1 ELSE @STEP 0,9
40 IF 0 THEN @STEP 0,1:@STEP 0,1 ELSE @RESET:@STEP 0,2
50 @READ A,B:PRINT A;B
RUN

10 ON 2 GOTO 20,30
20 PRINT 20
30 @STEP 0,1:GOSUB 50:GOTO 60
50 @STEP 0,1:RETURN
60 ON 1 GOSUB 50:PRINT 60
RUN

10 @STEP 0,30000
20 @STEP 0,30000:@READ A:PRINT A
RUN

10 @STEP 0,0,0,32767,0,0,-32768
20 @READ A,B,C,D,E,F:PRINT C;F
RUN

10 @STEP 0,3
15 STOP
20 @STEP 0,3
RUN
CONT
@READ A:PRINT A

10 @FOO
RUN

10 @STEP 0,1 PRINT
RUN

10 @RESET X
RUN

10 @READ A,B,C,D,E,F,G
RUN

@READ A,B,

@READ A B

@READ 5

@READ A(11)

@READ Q(3):PRINT Q(3)

@STEP

@STEP 1 2,3

@STEP 1,,2

@STEP 1,2,

@STEP ,1

@STEP -1,2

@STEP -1,"A"

@STEP 1E5

@STEP 0,1E5

@STEP "A"

@STEP 0,A$

@RESET:PRINT 1

@RESET 5

@

@@

@FOR

@READ

@READ A$

@CLOSE -1

@CLOSE 1,2

@CLOSE A$

@SET -1

@SET 1,2

PRINT @64,"HI"

PRINT@64,@

A=@

A$="@STEP":PRINT A$

REM @STEP

@STEP 0,-1.5:@READ A:PRINT A

10 DATA @STEP
20 READ A$:PRINT A$
RUN
"""
"""What is typed, line by line; each after a blank line on a machine that has just been started."""


def conversation(rig: Rig, lines: Iterable[str]) -> tuple[list[str], list[tuple[int, int]]]:
    """What is on the tube after some lines were typed, and what the latches got."""
    written = Analyser()
    rig.type("CLS\r")
    rig.run_until_waiting()
    rig.watch_latches(written)
    for line in lines:
        rig.type(line + "\r")
        rig.run_until_waiting(1000)
    return [line.rstrip() for line in rig.screen()], patterns(written.writes)


@pytest.mark.parametrize("typed", DIALOGUES.strip().split("\n\n"))
def test_a_conversation_goes_as_with_the_built_in_statements(typed: str) -> None:
    lines = typed.splitlines()
    assert conversation(under_the_rom(), lines) == conversation(Rig(SETTINGS), lines)


@pytest.mark.parametrize("statement", ["@SET", "@CLOSE 20"])
@pytest.mark.parametrize("numbered", [False, True])
def test_break_ends_manual_mode_and_a_close_that_does_not_end(
    statement: str, numbered: bool
) -> None:
    screens = []
    for rig in (under_the_rom(), Rig(SETTINGS)):
        lines = [f"10 {statement}", "20 PRINT 20"] if numbered else []
        for line in ("CLS", "@RESET", *lines):
            rig.type(line + "\r")
            rig.run_until_waiting()
        rig.card.plug = Open()
        rig.type("RUN\r" if numbered else statement + "\r")
        rig.run_for(2)
        rig.hold([Key.BREAK], 0.2)
        assert rig.run_until(lambda rig: rig.waiting is Waiting.COMMAND, 5)
        if numbered:
            rig.type("CONT\r")
            rig.run_until_waiting()
        screens.append([line.rstrip() for line in rig.screen()])
    assert screens[0] == screens[1]
    assert any("BREAK" in line for line in screens[0])


class Open:
    """An arm that never grips."""

    def follow(self, burst: Burst, stop: tuple[int, int] | None = None) -> int:
        return len(burst)

    def inputs(self, time: int) -> int:
        return 0b1111


# -- the programs that come along -----------------------------------------------------------------


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
    for motion, behind in zip(reference.motions, [*begins[1:], None], strict=True):
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
