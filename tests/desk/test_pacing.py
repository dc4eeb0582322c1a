"""Wall time becomes virtual time, within a budget, and nothing is lost or made up."""

from __future__ import annotations

import pytest

from trs80arm.desk.pacing import FAST_BUDGET, MOST_OWED, TICK, Pacer


class Desk:
    """A machine whose work costs wall time, and the wall's clock, both held by the test."""

    def __init__(self, cost: float = 0.0) -> None:
        self.wall = 100.0
        self.time = 0.0
        self.cost = cost
        self.busy = True
        self.slices = 0

    def run_for(self, seconds: float) -> None:
        self.slices += 1
        self.time += seconds
        self.wall += seconds * self.cost

    def pass_wall(self, pacer: Pacer, seconds: float) -> None:
        """Let the wall's time pass in ticks."""
        end = self.wall + seconds
        while self.wall < end - 1e-9:
            next_tick = min(self.wall + TICK, end)
            pacer.advance()
            self.wall = max(self.wall, next_tick)


def paced(desk: Desk, speed: float | None) -> Pacer:
    return Pacer(desk, lambda: desk.wall, speed)


@pytest.mark.parametrize("speed", [1.0, 2.0, 5.0, 20.0])
def test_a_minute_of_the_wall_is_a_minute_times_the_speed_within_a_percent(speed: float) -> None:
    desk = Desk(cost=0.002)
    desk.pass_wall(paced(desk, speed), 60.0)
    assert desk.time == pytest.approx(60.0 * speed, rel=0.01)


def test_one_call_keeps_near_its_budget_when_the_machine_is_slow() -> None:
    desk = Desk(cost=3.0)
    pacer = paced(desk, 20.0)
    desk.pass_wall(pacer, 1.0)
    desk.wall += TICK
    before = desk.wall
    pacer.advance()
    assert desk.wall - before < 2 * FAST_BUDGET


def test_what_cannot_be_reached_is_told() -> None:
    desk = Desk(cost=1.0)
    pacer = paced(desk, 5.0)
    desk.pass_wall(pacer, 3.0)
    assert 0.1 < pacer.achieved < 1.0


def test_a_suspended_program_does_not_run_after_the_lost_time() -> None:
    desk = Desk()
    pacer = paced(desk, 1.0)
    desk.wall += 3600
    pacer.advance()
    assert desk.time <= MOST_OWED


def test_time_that_others_let_pass_is_neither_owed_nor_made_up_for() -> None:
    desk = Desk()
    pacer = paced(desk, 1.0)
    desk.pass_wall(pacer, 1.0)
    desk.run_for(30.0)
    desk.pass_wall(pacer, 1.0)
    assert desk.time == pytest.approx(32.0, abs=0.05)


def test_another_machine_whose_clock_is_behind_is_paced_on_from_there() -> None:
    desk = Desk()
    pacer = paced(desk, 1.0)
    desk.pass_wall(pacer, 10.0)
    desk.time = 2.0
    desk.pass_wall(pacer, 1.0)
    assert desk.time == pytest.approx(3.0, abs=0.05)


def test_paused_is_paused() -> None:
    desk = Desk()
    pacer = paced(desk, 1.0)
    pacer.pause(True)
    desk.pass_wall(pacer, 5.0)
    assert desk.time == 0.0
    pacer.pause(False)
    desk.pass_wall(pacer, 1.0)
    assert desk.time == pytest.approx(1.0, abs=0.05)


def test_flat_out_fills_its_budget_while_the_machine_works() -> None:
    desk = Desk(cost=0.001)
    pacer = paced(desk, None)
    before = desk.wall
    pacer.advance()
    assert FAST_BUDGET <= desk.wall - before < 2 * FAST_BUDGET
    assert desk.time > 1.0


def test_flat_out_waits_for_its_operator_at_speed_one() -> None:
    desk = Desk()
    desk.busy = False
    desk.pass_wall(paced(desk, None), 10.0)
    assert desk.time == pytest.approx(10.0, rel=0.01)


def test_a_rest_below_a_t_state_is_not_paid_over_and_over() -> None:
    desk = Desk()
    pacer = paced(desk, 1.0)
    desk.pass_wall(pacer, 5.0)
    assert desk.slices < 5 * 60 * 6


def test_the_way_back_to_a_saved_state_is_no_speed() -> None:
    desk = Desk()
    pacer = paced(desk, 1.0)
    desk.pass_wall(pacer, 3.0)
    desk.time -= 2.0
    desk.pass_wall(pacer, 1.5)
    assert pacer.achieved == pytest.approx(1.0, abs=0.05)


def test_another_speed_is_not_judged_by_the_one_before() -> None:
    desk = Desk()
    pacer = paced(desk, 2.0)
    desk.pass_wall(pacer, 3.0)
    pacer.set_speed(20.0)
    assert pacer.achieved == 20.0


def test_after_a_pause_the_speed_is_what_it_was() -> None:
    desk = Desk()
    pacer = paced(desk, 1.0)
    desk.pass_wall(pacer, 3.0)
    pacer.pause(True)
    desk.pass_wall(pacer, 3.0)
    pacer.pause(False)
    pacer.advance()
    assert pacer.achieved == pytest.approx(1.0, abs=0.05)
