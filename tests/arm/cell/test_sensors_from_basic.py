"""Sensors as a BASIC program has them: OUT selects, @STEP moves, INP reads."""

from __future__ import annotations

import random

from tests.arm.cell.cells import at_the_cell, run, started
from tests.slices import elsewhere

CELL = """
[arm]
at = [8, 3, 1.5]
opening = 1.0
[selector]
bits = [1, 3]
[[tactile]]
name = "tip"
on = "left finger"
bit = 1
[[tactile]]
name = "pad"
on = "right finger"
face = "inner"
bit = 2
[[proximity]]
name = "palm"
on = "palm"
range = 1.5
bit = 3
[[force]]
name = "load"
on = "shoulder"
threshold = 3
bit = 1
bank = 1
[[force]]
name = "grip"
on = "grip"
threshold = 16
bit = 2
bank = 1
[[home]]
name = "shoulder"
joint = "shoulder"
at = 27
bit = 1
bank = 2
[[home]]
name = "base"
joint = "base"
at = 20.6
bit = 2
bank = 2
[[tactile]]
name = "plate"
at = [8, 3]
size = [2, 2]
bit = 1
bank = 3
[[beam]]
name = "beam"
from = [7, 3, 0.8]
to = [9, 3, 0.8]
bit = 2
bank = 3
[[part]]
name = "block"
at = [8, 3]
size = [1, 0.5, 1]
weight = 4
"""
LOOK = """
10 REM DOWN OVER THE BLOCK, CLOSE, SQUEEZE, LIFT, SWING, SET DOWN, OPEN, PRESS ON THE TABLE, UP
20 DATA 0,140,0, 0,0,-310, 0,0,-80, 0,-150,0, 40,0,0, -40,150,0, 0,0,400, 0,90,0, 0,-230,0
30 GOSUB 100:FOR I=1 TO 9:READ A,B,G:FOR K=1 TO 2
40 @STEP 100,A/2,B/2,0,0,0,G/2:GOSUB 100:NEXT K,I:END
100 FOR J=0 TO 3:OUT 158,(J AND 1)*2+(J AND 2)*4
110 LPRINT 15-(INP(152) AND 15);:NEXT:LPRINT:RETURN
"""
"""What answers in each of the four banks, as the sum of the bits, after each half of a motion."""


SWITCH, ONE, TWO, THREE = 1, 2, 4, 8
SEEN = [
    # Bank 0: tip, pad, palm. 1: load, grip. 2: shoulder, base. 3: plate, beam.
    (0, 0, ONE, ONE + TWO),
    (0, 0, 0, ONE + TWO),
    (THREE, 0, 0, ONE + TWO),  # above the block
    (TWO + THREE, 0, 0, ONE + TWO),  # the right finger has met it
    (SWITCH + TWO + THREE, SWITCH, SWITCH, SWITCH + ONE + TWO),  # both have
    (13, SWITCH + TWO, SWITCH, 7),  # and squeeze it
    (13, SWITCH + TWO, SWITCH, 7),
    (13, SWITCH + ONE + TWO, SWITCH, SWITCH + TWO),  # it hangs in the hand
    (13, 7, SWITCH + ONE, SWITCH),  # above the beam; the shoulder's mark is passed
    (13, 7, SWITCH + ONE + TWO, SWITCH),  # and the base's
    (13, 7, 7, SWITCH),
    (13, 7, SWITCH + TWO, SWITCH + TWO),  # back within the base's play
    (13, 7, SWITCH + TWO, SWITCH + ONE + TWO),
    (THREE, 0, TWO, ONE + TWO),  # let go
    (THREE, 0, TWO, ONE + TWO),
    (0, 0, TWO, ONE + TWO),
    (ONE, ONE, TWO, ONE + TWO),  # pressed on the table
    (THREE, 0, TWO, ONE + TWO),
    (0, 0, ONE + TWO, ONE + TWO),
]


def test_a_program_sees_each_sensor_in_its_bank() -> None:
    rig = at_the_cell(CELL)
    lines = [tuple(map(int, line.split())) for line in run(rig, LOOK).split("\n") if line.strip()]
    assert lines == SEEN


def test_it_sees_the_same_however_time_is_sliced() -> None:
    whole = run(at_the_cell(CELL), LOOK)
    chance = random.Random(4)
    rig = started(at_the_cell(CELL), LOOK)
    for k in range(400):
        if rig.outcome is not None and k > 50:
            break
        rig.run_for(chance.choice([0.001, 0.01, 0.2]))
        if k % 40 == 20:
            rig = elsewhere(rig)
    assert rig.printer.text == whole
