"""The pendant on the screen: a task is taught with keys alone, or the mouse, and runs anywhere."""

from __future__ import annotations

import pytest
from textual.widgets import OptionList

from tests.goldens import check_golden
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.arm.models import MINIMOVER5
from trs80arm.desk.taught_programs import in_data, in_steps
from trs80arm.rig import Rig, Waiting
from trs80arm.ui.panels.jog_pad import JogPad
from trs80arm.ui.screens.pendant import PendantScreen

TAP = 0.2
"""Seconds of the wall after which the keyboard's timer has let a key go."""


async def open_pendant(sitting: Sitting) -> None:
    await sitting.press("f12")
    await sitting.settle()


async def tap(sitting: Sitting, key: str, times: int = 1) -> None:
    """Tap a key, each time until its step is done."""
    for _ in range(times):
        await sitting.press(key)
        sitting.wall.now += TAP
        sitting.app.tick()
        await done(sitting)


async def done(sitting: Sitting) -> None:
    """Let the machine's time pass until the pendant has nothing more to do."""
    app = sitting.app
    while app.pendant.busy:
        app.pendant.go_on()
        app.session.run_for(1 / 60)
    app.pacer.forgive()


async def open_hand(sitting: Sitting) -> None:
    await sitting.press("o")
    await sitting.pilot.pause()
    await sitting.press("enter")
    await sitting.pilot.pause()
    await done(sitting)


async def shown(sitting: Sitting) -> str:
    """What the pendant shows."""
    screen = sitting.app.screen
    assert isinstance(screen, PendantScreen)
    screen.show()
    await sitting.pilot.pause()
    return screen_text(sitting.app)


async def teach_the_task(sitting: Sitting) -> None:
    """From (8, 0) to (8, 4), as the pendant's own words say it is done."""
    await open_hand(sitting)
    await tap(sitting, "3", 4)
    await tap(sitting, "1", 6)
    await sitting.press("a")
    await tap(sitting, "e", 3)
    await sitting.press("a", "c")
    await done(sitting)
    await sitting.press("a")
    await tap(sitting, "3", 3)
    await sitting.press("a")
    await tap(sitting, "2", 8)
    await sitting.press("a")
    await tap(sitting, "e", 3)
    await sitting.press("a")
    await open_hand(sitting)
    await sitting.press("a")
    await tap(sitting, "3", 3)
    await sitting.press("a")


def block(rig: Rig) -> tuple[float, ...]:
    return tuple(round(value, 1) for value in rig.arm.bench.parts["block"].place)


@pytest.mark.parametrize(("width", "height"), [(80, 24), (120, 40)])
@piloted
async def test_a_task_is_taught_from_nothing_and_runs_at_the_first_try(
    width: int, height: int, sit_down: Opener
) -> None:
    async with sit_down(width, height) as sitting:
        rig = sitting.app.session.rig
        began = rig.time
        await open_pendant(sitting)
        await teach_the_task(sitting)
        assert rig.time - began < 180
        await shown(sitting)
        assert sitting.app.pendant.hint.endswith("K puts the parts back, P plays it once.")
        await sitting.press("k", "p")
        assert block(rig) == (8.0, 0.0, 0.5)
        await done(sitting)
        assert block(rig) == (8.0, 4.0, 0.5)
        assert rig.registers == rig.joints
        check_golden(f"pendant-{width}x{height}", await shown(sitting))
        positions = sitting.app.lesson.positions
        manner = sitting.app.pendant.manner
    for listing in (in_steps(positions, manner), in_data(positions, manner, MINIMOVER5)):
        assert_runs_without_a_pendant(listing)


def assert_runs_without_a_pendant(listing: str) -> None:
    """On a machine that was just switched on; where it asks for the arm to be set, it is set."""
    rig = Rig()
    rig.load_text(listing)
    rig.type("RUN\r")
    rig.run_until_waiting(120)
    if rig.waiting is Waiting.SET:
        rig.run_for(0.1)
        rig.hold(["0"], 0.2)
        rig.run_for(0.3)
        rig.run_until_waiting(120)
    assert rig.waiting is Waiting.COMMAND
    assert block(rig) == (8.0, 4.0, 0.5)
    assert rig.registers == rig.joints


@piloted
async def test_the_program_goes_into_the_machine_and_runs_there(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        rig = sitting.app.session.rig
        await open_pendant(sitting)
        await tap(sitting, "3", 2)
        await sitting.press("a")
        await tap(sitting, "2", 2)
        await sitting.press("a", "l")
        await sitting.settle()
        await sitting.press("l")
        await sitting.settle()
        assert sitting.app.screen is sitting.app.desk
        await sitting.press("f5")
        rig.run_until_waiting()
        rig.run_until_waiting()
        assert rig.registers == sitting.app.lesson.positions[1].registers


@piloted
async def test_a_tap_is_one_step_and_a_held_key_goes_on(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        rig = sitting.app.session.rig
        await open_pendant(sitting)
        await tap(sitting, "3")
        assert rig.pose.z == pytest.approx(0.5, abs=0.02)
        # Auto-repeat holds it.
        for _ in range(16):
            await sitting.press("3")
            await sitting.pass_time(0.1)
        await sitting.pass_time(0.2)
        await done(sitting)
        assert rig.pose.z > 1.4
        stood = rig.pose.z
        await sitting.pass_time(1.0)
        assert rig.pose.z == stood


@piloted
async def test_a_terminal_that_tells_of_releases_holds_as_long_as_the_finger(
    sit_down: Opener,
) -> None:
    async with sit_down() as sitting:
        app = sitting.app
        app.keyboard.told(True)
        await open_pendant(sitting)
        screen = app.screen
        assert isinstance(screen, PendantScreen)
        screen.went_down("3", "3", "3")
        screen.went_down("1", "1", "1")
        await sitting.pass_time(2.0)
        screen.went_up("3")
        screen.went_up("1")
        await done(sitting)
        pose = app.session.rig.pose
        assert pose.z > 0.9
        assert pose.x - 5 == pytest.approx(pose.z, abs=0.03)


@piloted
async def test_the_mouse_holds_a_button(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await open_pendant(sitting)
        await shown(sitting)
        rig = sitting.app.session.rig
        await sitting.pilot.mouse_down(JogPad, offset=(32, 2))
        await sitting.pass_time(0.1)
        await sitting.pilot.mouse_up(JogPad, offset=(32, 2))
        await done(sitting)
        assert rig.pose.z == pytest.approx(0.5, abs=0.02)
        await sitting.pilot.mouse_down(JogPad, offset=(8, 2))
        await sitting.pass_time(1.0)
        await sitting.pilot.mouse_up(OptionList)
        await done(sitting)
        assert rig.pose.x > 5.9


@piloted
async def test_the_keys_below_are_clicked(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await open_pendant(sitting)
        await sitting.pilot.click("KeyLine", offset=(2, 0))
        assert len(sitting.app.lesson) == 1


@piloted
async def test_the_override_goes_from_slow_motion_to_flat_out(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await open_pendant(sitting)
        await sitting.press(*["minus"] * 9)
        assert "Speed 5 %" in await shown(sitting)
        rig = sitting.app.session.rig
        await sitting.press("1")
        began = rig.time
        await sitting.pass_time(0.5)
        assert 0 < rig.registers[2] < 20
        assert rig.time - began < 3.0
        await sitting.press(*["plus"] * 9)
        assert "Speed flat out" in await shown(sitting)
        await done(sitting)
        assert sitting.app.pacer.speed is None


@piloted
async def test_axes_and_step_sizes_are_chosen(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await open_pendant(sitting)
        await sitting.press("j")
        assert "TOOL   along" in await shown(sitting)
        await sitting.press("j", "comma")
        text = await shown(sitting)
        assert "JOINT  base" in text
        assert "Step 50 half-steps" in text
        await tap(sitting, "1")
        assert sitting.app.session.rig.registers == (50, 0, 0, 0, 0, 0)


@piloted
async def test_points_are_marked_gone_to_put_in_order_and_removed(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        rig, pendant = sitting.app.session.rig, sitting.app.pendant
        await open_pendant(sitting)
        for _ in range(3):
            await tap(sitting, "3")
            await sitting.press("a")
        await shown(sitting)
        await sitting.press("up", "up", "enter")
        await done(sitting)
        assert rig.registers == pendant.lesson.positions[0].registers
        await sitting.press("f")
        await done(sitting)
        assert pendant.place == 1
        await sitting.press("b")
        await done(sitting)
        assert pendant.place == 0
        await sitting.press("right_square_bracket", "x")
        assert [p.name for p in pendant.lesson.positions] == ["B", "C"]
        await sitting.press("h")
        assert pendant.lesson.positions[1].grips
        await sitting.press("n")
        await sitting.settle()
        await sitting.press(*"over", "enter")
        await sitting.settle()
        assert "OVER" in pendant.lesson.positions[1].name


@piloted
async def test_a_program_that_runs_is_stopped_by_space(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.run_program("10 GOTO 10\n", 1.0)
        await open_pendant(sitting)
        assert "A program runs: stop it first." in await shown(sitting)
        await sitting.press("space")
        await sitting.pass_time(0.5)
        assert "Stopped." in await shown(sitting)
        await tap(sitting, "3")
        assert sitting.app.session.rig.registers[1] == -78


@piloted
async def test_escape_stops_the_arm_first_and_leaves_then(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await open_pendant(sitting)
        await sitting.press("3")
        await sitting.pass_time(0.05)
        await sitting.press("escape")
        assert isinstance(sitting.app.screen, PendantScreen)
        await done(sitting)
        await sitting.press("escape")
        await sitting.settle()
        assert sitting.app.screen is sitting.app.desk
