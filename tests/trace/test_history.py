"""The history of latches and arm agrees with what really happened, and does not grow."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from trs80arm.arm.bench import Bench
from trs80arm.machine.card import Latch
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.half_steps import HALF_STEPS
from trs80arm.rig import Rig
from trs80arm.trace import history as history_module
from trs80arm.trace.history import History


def moved(command: str, seconds: float = 4.0) -> tuple[Rig, History]:
    """A rig that was watched while it did a command, slice by slice as in the terminal."""
    rig = Rig(bench=Bench())
    history = History(rig)
    rig.type(f"{command}\r")
    for _ in range(round(seconds * 60)):
        rig.run_for(1 / 60)
    return rig, history


def test_every_half_step_of_a_motion_is_a_row_further_in_figure_8() -> None:
    _, history = moved("@STEP 50,24")
    times, nibbles = history.changes(Latch.BASE)
    rows = [HALF_STEPS.index(nibble) for nibble in nibbles.tolist()]
    assert all((after - before) % 8 == 1 for before, after in pairwise(rows))
    assert len(rows) >= 24
    assert (np.diff(times) > 0).all()


def test_a_coordinated_motion_begins_and_ends_together_as_in_figure_10() -> None:
    _, history = moved("@STEP 50,21,3")
    base, _ = history.changes(Latch.BASE)
    shoulder, _ = history.changes(Latch.SHOULDER)
    assert len(base) == 21
    assert len(shoulder) == 3
    assert abs(int(base[-1]) - int(shoulder[-1])) < T_STATES_PER_SECOND // 100


def test_a_latch_holds_what_was_written_last() -> None:
    rig, history = moved("OUT 152,5:OUT 152,4")
    now = np.array([rig.clock.now])
    assert history.nibbles(Latch.BASE, now).tolist() == [4]
    assert history.nibbles(Latch.BASE, np.array([0])).tolist() == [0]


def test_the_recorder_follows_the_joints_and_tells_their_speed() -> None:
    rig, history = moved("@STEP 50,400")
    now = np.array([rig.clock.now])
    assert history.quantity("angle 1", now)[0] == pytest.approx(np.degrees(rig.state.angles.base))
    steps, _ = history.changes(Latch.BASE)
    middle = np.linspace(int(steps[100]), int(steps[300]), 5).astype(np.int64)
    rate = T_STATES_PER_SECOND * 200 / int(steps[300] - steps[100])
    expected = np.degrees(rate / rig.arm.model.drives[0].steps)
    assert history.speed(1, middle) == pytest.approx([expected] * 5, rel=0.05)


def test_a_motor_has_less_left_the_faster_it_goes_and_all_when_it_stands() -> None:
    def least(command: str) -> float:
        _, history = moved(command)
        steps, _ = history.changes(Latch.BASE)
        times = np.arange(int(steps[40]), int(steps[-40]), 20_000)
        return float(history.margin(1, times).min())

    assert 0 < least("@STEP 50,300") < least("@STEP 100,300") < 100
    rig, history = moved("@STEP 100,300")
    still = rig.clock.now - np.arange(5)[::-1] * 10_000
    assert history.margin(1, still) == pytest.approx([100.0] * 5)


def test_the_force_of_the_grip_rises_while_the_hand_closes_on_itself() -> None:
    rig, history = moved("@STEP 50,0,0,0,0,0,-50", 3)
    assert rig.state.force > 0.5
    assert history.quantity("force", np.array([rig.clock.now]))[0] == rig.state.force


def test_it_keeps_so_many_writes_and_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history_module, "WRITES", 100)
    monkeypatch.setattr(history_module, "LOOKS", 20)
    rig, history = moved("@STEP 50,400")
    times, nibbles = history.changes(Latch.BASE)
    assert len(times) == 100
    assert history.begin == times[0]
    assert nibbles[-1] == rig.card.latches[Latch.BASE]


def test_a_clock_that_goes_back_begins_a_new_history() -> None:
    rig, history = moved("PRINT")
    before = rig.snapshot()
    rig.type("@STEP 50,40\r")
    rig.run_for(3)
    rig.restore(before)
    assert rig.clock.now < history.end
    rig.type("OUT 152,5\r")
    rig.run_for(2)
    times, nibbles = history.changes(Latch.BASE)
    assert nibbles.tolist() == [5]
    assert times[0] <= rig.clock.now


def test_watching_changes_nothing() -> None:
    watched, _ = moved("@STEP 50,100,-50,60,20,-20,100")
    alone = Rig(bench=Bench())
    alone.type("@STEP 50,100,-50,60,20,-20,100\r")
    for _ in range(240):
        alone.run_for(1 / 60)
    assert watched.state == alone.state
    assert watched.clock.now == alone.clock.now
