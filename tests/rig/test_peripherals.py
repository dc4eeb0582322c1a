"""What a BASIC program finds behind the card, the keyboard and the cassette recorder's plug."""

from __future__ import annotations

import os
from pathlib import Path

from trs80arm import Rig
from trs80arm.arm import Bench
from trs80arm.arm.benchfile import parse
from trs80arm.arm.minimover import Pose
from trs80arm.files import load_program
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.settings import load

SENSORS = """
[[part]]
at = [8.0, 0.0]
size = [1.0, 1.0, 1.0]
[[proximity]]
bit = 1
at = [8.0, 3.0, 0.0]
range = 1.0
[[tactile]]
bit = 2
at = [3.0, -4.5]
size = [0.5, 0.5]
[[beam]]
bit = 3
from = [8.0, -2.0, 0.5]
to = [8.0, 2.0, 0.5]
"""

TURNTABLE = """
[[part]]
at = [5.0, -4.5]
size = [0.5, 0.5, 0.5]
[[tactile]]
bit = 2
at = [3.0, -4.5]
size = [0.5, 0.5]
[turntable]
at = [4.0, -4.5]
radius = 1.5
steps = 96
"""


def ran(rig: Rig, program: str) -> str:
    """What a program prints on the printer."""
    rig.load_text(program)
    rig.type("RUN\r")
    rig.run_until_waiting(600)
    return rig.printer.text


def bench(text: str) -> Bench:
    return parse(text, "bench")


def with_options(*options: str) -> Rig:
    return Rig(load(None, list(options)).rig())


def test_inp_reads_the_light_beam_the_pad_and_the_hand_that_comes_near() -> None:
    rig = Rig(bench=bench(SENSORS))
    places = [Pose(6, 0, 6, -90, 0, 0), Pose(8, 3, 0.5, -90, 0, 0), Pose(3, -4.5, 0, -90, 0, 0)]
    for pose in places:
        rig.move_to(pose)
        rig.type("LPRINT INP(152)AND14\r")
        rig.run_until_waiting()
    # The part is in the beam, bit 3, all the time; proximity is bit 1 and the pad bit 2.
    assert rig.printer.text == " 6 \n 4 \n 2 \n"


def test_out_to_the_auxiliary_latch_turns_the_turntable_until_the_pad_is_pressed() -> None:
    program = """10 FOR I=0 TO 7:READ P(I):NEXT:DATA 5,4,6,2,10,8,9,1
20 I=8:OUT 158,P(0)
30 I=I+1:OUT 158,P(I AND 7)
40 IF INP(152)AND4 AND I<200 THEN 30
50 LPRINT I-8
"""
    rig = Rig(bench=bench(TURNTABLE))
    # From the other side of the plate to the pad is half a turn, less the part and the pad.
    turned = int(ran(rig, program))
    assert 32 < turned < 48
    assert rig.registers == (0,) * 6


def test_programs_and_data_are_kept_on_cassettes_in_the_folder(tmp_path: Path) -> None:
    folder = tmp_path / "tapes"
    first = with_options(f"machine.tapes={folder}")
    listing = '10 PRINT#-1,1.5,"TWO":CSAVE"P":CSAVE".":CSAVE"/"\n'
    ran(first, listing)
    assert sorted(os.listdir(tmp_path)) == ["tapes"]
    assert sorted(os.listdir(folder)) == ["P.cas", "data.cas", "program-2E.cas", "program-2F.cas"]
    assert load_program(folder / "P.cas") == list(first.basic.program.lines())

    second = with_options(f"machine.tapes={folder}")
    second.type('CLOAD"P"\r')
    second.run_until_waiting(60)
    assert list(second.basic.program.lines()) == list(first.basic.program.lines())
    second.type('CLOAD?"P"\r5 REM\rCLOAD?"P"\r')
    second.run_until(lambda rig: "BAD" in rig.screen(), 180)
    assert [line for line in second.screen() if "BAD" in line] == ["BAD"]
    assert ran(second, "10 INPUT#-1,A,B$:LPRINT A;B$\n") == " 1.5 TWO\n"


def test_ghosts_are_keys_to_peek_and_to_manual_mode_where_they_are_switched_on() -> None:
    counted = []
    for ghosting in ("false", "true"):
        rig = with_options(f"machine.ghosting={ghosting}")
        rig.type("@SET\r")
        rig.run_until_waiting()
        rig.hold(["1", "2", "Q"], 0.5)
        rig.run_for(1)
        counted.append(rig.registers[3])
    assert counted[0] == 0
    assert counted[1] < -100  # R is at the fourth corner


def test_a_tape_is_searched_in_the_same_time_however_it_is_sliced() -> None:
    ends = []
    for step in (60 * T_STATES_PER_SECOND, T_STATES_PER_SECOND // 60):
        rig = Rig()
        rig.type('10 REM A\rCSAVE "A"\rNEW\r20 REM B\rCSAVE "B"\rNEW\r')
        rig.run_until_waiting(600)
        rig.tape.rewind()
        printed: list[int] = []
        rig.listen(lambda code, is_echo, printed=printed, rig=rig: printed.append(rig.clock.now))
        rig.type('CLOAD "B"\r')
        target = rig.clock.now + 60 * T_STATES_PER_SECOND
        while rig.clock.now < target:
            rig.run_to(min(target, rig.clock.now + step))
        assert [number for number, _ in rig.basic.program.lines()] == [20]
        ends.append(printed)
    assert ends[0] == ends[1]
