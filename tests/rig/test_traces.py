"""The analyser on running BASIC programs: Figures 8 and 10, and the same writes in every run."""

from __future__ import annotations

import csv
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from tests.machine.bench_top import Analyser
from trs80arm import Rig
from trs80arm.basic.activity import Waiting
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.driver import Mode
from trs80arm.trace import PoseTrace, Trace

PROGRAMS = Path(__file__).parents[2] / "programs"
FIGURE_8 = (0b0101, 0b0100, 0b0110, 0b0010, 0b1010, 0b1000, 0b1001, 0b0001)


def run(rig: Rig, text: str, seconds: float = 60) -> None:
    """Load a program, type RUN and let it come to its end."""
    rig.load_text(text)
    rig.type("RUN\r")
    rig.run_for(1)
    assert rig.run_until(lambda rig: rig.waiting is Waiting.COMMAND, seconds)


def writes(path: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(path.open()))


def test_figure_10_from_the_trace_of_a_program(tmp_path):
    rig = Rig()
    with Trace(rig, tmp_path / "a.csv"):
        run(rig, "10 @STEP 50,21,3\n")
    rows = writes(tmp_path / "a.csv")
    times = {
        name: [float(row["seconds"]) for row in rows if row["latch"] == name]
        for name in ("base", "shoulder")
    }
    assert len(times["base"]) == 21
    assert len(times["shoulder"]) == 3
    assert times["shoulder"][0] == times["base"][0]
    assert times["shoulder"][-1] == times["base"][-1]
    assert [b - a for a, b in pairwise(times["base"])] == pytest.approx([0.0027] * 20, abs=1e-6)
    assert [b - a for a, b in pairwise(times["shoulder"])] == pytest.approx([0.027] * 2, abs=1e-6)


def test_figure_8_from_the_trace_of_a_program(tmp_path):
    rig = Rig()
    with Trace(rig, tmp_path / "a.npz"):
        run(rig, "10 @STEP 50,16\n20 @STEP 50,-16\n")
    with np.load(tmp_path / "a.npz") as arrays:
        nibbles = arrays["nibble"].tolist()
    down = list(FIGURE_8[1:] + FIGURE_8 + FIGURE_8[:1])
    assert nibbles == [*down, *reversed(down[:-1]), FIGURE_8[0]]


def test_a_program_steps_the_base_with_out_alone_and_its_register_stays(tmp_path):
    rig = Rig()
    rig.load(PROGRAMS / "half-steps.bas")
    turned = []
    with Trace(rig, tmp_path / "a.csv"), PoseTrace(rig, tmp_path / "pose.csv"):
        rig.type("RUN\r")
        rig.run_for(1)
        assert rig.run_until(lambda rig: rig.waiting is Waiting.COMMAND, 60)
    rows = writes(tmp_path / "a.csv")
    assert {row["latch"] for row in rows} == {"base"}
    nibbles = [int(row["nibble"]) for row in rows]
    clockwise, back = nibbles[:97], nibbles[96:193]
    assert clockwise == [FIGURE_8[k % 8] for k in range(97)]
    assert back == clockwise[::-1]
    assert nibbles[193:] == [0]
    assert rig.registers == (0,) * 6
    turned = [float(row["base"]) for row in writes(tmp_path / "pose.csv")]
    # 96 half-steps are a turn of the motor, and 5892 of them a turn of the base.
    assert max(turned) == pytest.approx(96 / 5892 * 360, abs=0.01)
    assert turned[-1] == pytest.approx(turned[0])


def test_pose_trace_of_a_program_ends_where_the_arm_is(tmp_path):
    rig = Rig()
    with PoseTrace(rig, tmp_path / "pose.csv"):
        run(rig, "10 @STEP 50,100,-100,150\n")
    last = writes(tmp_path / "pose.csv")[-1]
    assert float(last["x"]) == pytest.approx(rig.pose.x, abs=1e-4)
    assert float(last["z"]) == pytest.approx(rig.pose.z, abs=1e-4)


PROGRAM = """
10 @RESET
20 FOR I=1 TO 3
30 @STEP 20,200,-60,90,5,-5,40*I
40 PRINT I
50 @CLOSE 60
60 @STEP 60,-200,60,-90,-5,5,20
70 NEXT
80 @SET
90 @READ A,B,C,D,E,F:PRINT A;B;C;D;E;F
"""


def operate(rig: Rig, pause: float | None, restore_at: dict[float, Mode] | None = None) -> Analyser:
    """Run `PROGRAM` with somebody at the keys, in slices of `pause` seconds.

    At the times of `restore_at` the rig is put away and brought back, in the motion given there.
    """
    analyser = Analyser()
    rig.card.observers.append(analyser)
    rig.load_text(PROGRAM)
    begin = rig.clock.now
    end = begin + 15 * T_STATES_PER_SECOND
    rig.type("RUN\r")
    script = [(11.0, "1"), (11.5, "W"), (12.25, "3"), (14.0, "0")]
    holds = [(begin + int(at * T_STATES_PER_SECOND), key) for at, key in script]
    restores = [
        (begin + int(at * T_STATES_PER_SECOND), mode) for at, mode in (restore_at or {}).items()
    ]
    while rig.clock.now < end:
        target = min(end, rig.clock.now + int(pause * T_STATES_PER_SECOND)) if pause else end
        if restores and rig.clock.now >= restores[0][0]:
            assert rig.driver.mode is restores.pop(0)[1]
            rig.restore(rig.snapshot())
        if holds and holds[0][0] <= target:
            time, key = holds.pop(0)
            rig.run_to(time)
            rig.hold([key], 0.6)
        else:
            rig.run_to(target)
    assert not restores
    return analyser


def test_the_same_writes_in_one_go_in_slices_and_after_restores_in_mid_motion():
    whole = Rig()
    expected = operate(whole, None)
    assert len(expected.writes) > 3000
    assert whole.driver.mode is Mode.IDLE
    restores = {0.6: Mode.STEP, 2.0: Mode.CLOSE, 11.2: Mode.SET, 12.3: Mode.SET}
    for pause, restore_at in ((1 / 30, None), (0.0031, None), (1 / 60, restores)):
        rig = Rig()
        seen = operate(rig, pause, restore_at)
        assert seen.writes == expected.writes
        assert rig.registers == whole.registers
        assert rig.screen() == whole.screen()
        assert rig.state == whole.state


def test_true_joints_are_counted_from_the_last_reset_also_after_a_restore():
    rig = Rig()
    run(rig, "10 @STEP 50,100,-50,60\n20 @RESET\n30 @STEP 50,7\n")
    assert rig.registers == rig.joints == (7, 0, 0, 0, 0, 0)
    rig.restore(rig.snapshot())
    run(rig, "10 @RESET:@STEP 50,-3,2\n")
    assert rig.registers == rig.joints == (-3, 2, 0, 0, 0, 0)


def test_a_trace_goes_on_through_a_reset_and_a_restore(tmp_path):
    rig = Rig()
    with Trace(rig, tmp_path / "a.csv"), Trace(rig, tmp_path / "a.vcd"):
        snapshot = rig.snapshot()
        run(rig, "10 @STEP 50,5\n")
        rig.restore(snapshot)
        run(rig, "10 @STEP 50,5\n")
        rig.reset()
        run(rig, "10 @STEP 50,5\n")
    assert rig.card.observers == []
    rows = writes(tmp_path / "a.csv")
    nibbles = [int(row["nibble"]) for row in rows if row["latch"] == "base"]
    assert nibbles == [*FIGURE_8[1:6], *FIGURE_8[1:6], 0, *FIGURE_8[1:6]]
    assert rows[0]["t_states"] == rows[5]["t_states"]
    times = [
        int(line[1:]) for line in (tmp_path / "a.vcd").read_text().splitlines() if line[0] == "#"
    ]
    assert times == sorted(set(times))
