"""Conversations with the statements from the tape go as with the built-in ones."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pytest

from tests.machine.armbasic_z80.assembled import maker
from tests.machine.armbasic_z80.board import patterns
from tests.machine.armbasic_z80.rom_machine import ROM, SETTINGS, load_tape, under_the_rom
from tests.machine.bench_top import Analyser
from trs80arm.machine.z80.rom import Rom
from trs80arm.pulses import Burst
from trs80arm.rig import Key, Rig, RigSettings, Waiting

pytestmark = pytest.mark.skipif(ROM is None, reason="TRS80ARM_TEST_ROM names no ROM")


@pytest.mark.parametrize("size", [16, 32, 48])
def test_the_tape_loads_and_leads_to_ready(size: int) -> None:
    assert ROM is not None
    answer = str(maker().ORIGINS[size])
    rom = Rom.read(Path(ROM))
    rig = Rig(RigSettings(ram_kib=size, memory_size=answer, armbasic=False, rom=rom))
    load_tape(rig, size)
    rig.type("@STEP 0,5,-3:@READ A,B:PRINT A;B\r")
    rig.run_until_waiting()
    assert any(line.startswith(" 5 -3") for line in rig.screen())


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
