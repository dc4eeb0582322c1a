"""The program looks at the machine at every tick while something goes on, and seldom if not."""

from __future__ import annotations

import pytest

from tests.own_places import PROGRAMS
from tests.ui.piloted import piloted
from tests.ui.sitting import Opener
from trs80arm.desk.pacing import TICK
from trs80arm.machine.keys import Key
from trs80arm.ui.heartbeat import AWAKE, STEADY, Heartbeat


class Program:
    """Something that is busy or not, on a wall's clock that the test holds."""

    def __init__(self) -> None:
        self.wall = 100.0
        self.busy = False
        self.hurried = False
        self.ticks = 0
        self.heartbeat = Heartbeat(
            self.tick, lambda: self.busy, lambda: self.hurried, lambda: self.wall
        )

    def tick(self) -> None:
        self.ticks += 1


def test_a_program_with_nothing_to_do_rests() -> None:
    program = Program()
    program.heartbeat.beat()
    assert program.heartbeat.resting


def test_a_busy_program_does_not_rest() -> None:
    program = Program()
    program.busy = True
    program.heartbeat.beat()
    assert not program.heartbeat.resting


def test_a_resting_program_looks_up_by_itself_and_goes_on_if_it_has_to() -> None:
    program = Program()
    program.heartbeat.beat()
    program.heartbeat.beat()
    assert program.ticks == 2
    assert program.heartbeat.resting
    program.busy = True
    program.heartbeat.beat()
    assert not program.heartbeat.resting


def test_what_goes_on_by_itself_is_looked_at_once_a_frame_and_hands_and_haste_twice() -> None:
    program = Program()
    program.busy = True
    program.heartbeat.beat()
    assert program.heartbeat.every == STEADY
    program.hurried = True
    program.heartbeat.beat()
    assert program.heartbeat.every == TICK < STEADY


def test_whoever_wakes_it_keeps_it_awake_for_a_while() -> None:
    program = Program()
    program.heartbeat.beat()
    program.heartbeat.wake()
    program.heartbeat.beat()
    assert not program.heartbeat.resting
    program.wall += AWAKE
    program.heartbeat.beat()
    assert program.heartbeat.resting


def test_a_resting_program_is_brought_up_to_now_before_what_woke_it() -> None:
    program = Program()
    program.heartbeat.beat()
    before = program.ticks
    program.heartbeat.wake()
    assert program.ticks == before + 1
    program.heartbeat.wake()
    assert program.ticks == before + 1


@piloted
async def test_at_the_prompt_nothing_goes_on(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.pass_time(0.5)
        assert not sitting.app.busy


@piloted
async def test_a_key_that_is_down_is_something(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.pass_time(0.5)
        sitting.app.keyboard.held.point(Key.A)
        assert sitting.app.busy


@piloted
async def test_a_running_program_is_something_and_a_pause_is_nothing(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        sitting.app.session.rig.type("10 GOTO 10\rRUN\r")
        await sitting.pass_time(4.0)
        assert sitting.app.busy
        sitting.app.commands.machine.pause()
        await sitting.pass_time(0.1)
        assert not sitting.app.busy


@pytest.mark.parametrize("command", ["demo", "run"])
@piloted
async def test_what_is_begun_by_a_command_is_something(command: str, sit_down: Opener) -> None:
    async with sit_down(program=PROGRAMS / "table4.bas") as sitting:
        await sitting.pass_time(0.5)
        assert not sitting.app.busy
        getattr(sitting.app.commands.machine, command)()
        assert sitting.app.busy


@piloted
async def test_snapshots_for_the_debugger_are_the_fewer_the_longer_they_take(
    sit_down: Opener, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with sit_down() as sitting:
        app = sitting.app
        await sitting.type_line("10 GOTO 10")
        app.session.rig.type("RUN\r")
        await sitting.pass_time(1)
        spent, marks = [0.0], []

        def mark() -> None:
            spent.append(spent[-1] + cost)
            marks.append(app.wall())

        monkeypatch.setattr(app.session.timeline, "mark", mark)
        monkeypatch.setattr("trs80arm.ui.app.time.thread_time", lambda: spent[-1])
        counts = []
        for each in (0.0, 0.02):
            cost = each
            marks.clear()
            for _ in range(20):
                sitting.wall.now += 1
                app._mark()
            counts.append(len(marks))
        assert counts == [20, 5]
