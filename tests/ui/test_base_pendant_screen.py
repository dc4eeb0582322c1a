"""The TeachMover's own pendant on the screen: taught and run by keys alone, or with the mouse."""

from __future__ import annotations

import pytest

from tests.goldens import check_golden
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm import RigSettings
from trs80arm.arm import ArmSettings
from trs80arm.serial.instructions import told
from trs80arm.serial.pendant import PendantMode
from trs80arm.serial.pendant_keys import FunctionKey
from trs80arm.ui.panels.joint_pad import JointPad
from trs80arm.ui.screens.base_pendant import KEYS, BasePendantScreen
from trs80arm.ui.screens.pendant import PendantScreen

TEACHMOVER = RigSettings(controller=True, arm=ArmSettings(model="teachmover"))


async def push(sitting: Sitting, *keys: str) -> None:
    """Press keys, each with a moment for the machine."""
    for key in keys:
        await sitting.press(key)
        await sitting.pass_time(0.2)


async def shown(sitting: Sitting) -> str:
    screen = sitting.app.screen
    assert isinstance(screen, BasePendantScreen)
    screen.show()
    await sitting.pilot.pause()
    return screen_text(sitting.app)


def program(sitting: Sitting) -> list[str]:
    return [told(row) for row in sitting.app.session.rig.controller.memory]


@pytest.mark.parametrize(("width", "height"), [(80, 24), (120, 40)])
@piloted
async def test_a_program_is_taught_by_keys_and_run(
    sit_down: Opener, width: int, height: int
) -> None:
    async with sit_down(width, height, rig=TEACHMOVER) as sitting:
        await sitting.press("f12")
        await sitting.settle()
        assert "TRAIN or MOVE first" in await shown(sitting)
        rig = sitting.app.session.rig
        await push(sitting, "1")
        assert rig.registers[0] == 0
        await push(sitting, "a", "a", "1", "1", "3", "a", "p", "2", "enter", "j", "1", "enter")
        assert "JUMP 1: condition, 0 to 4" in await shown(sitting)
        await push(sitting, "4", "enter")
        assert rig.registers[0] > 0
        assert program(sitting)[2:] == ["pause 2 s", "jump to 1 if it grips"]
        check_golden(f"base-pendant-{width}x{height}", await shown(sitting))
        await push(sitting, "i", "1", "enter", "u")
        moved = rig.registers
        await sitting.pass_time(1)
        assert rig.registers != moved or rig.controller.busy
        await push(sitting, "escape")
        assert not rig.controller.busy
        await push(sitting, "escape")
        assert not sitting.app.dialog_is_open


@piloted
async def test_enter_alone_runs_nothing_and_digits_that_are_not_asked_for_jog(
    sit_down: Opener,
) -> None:
    async with sit_down(rig=TEACHMOVER) as sitting:
        await push(sitting, "f12", "a", "a", "enter")
        rig = sitting.app.session.rig
        assert not rig.controller.busy
        await push(sitting, "v", "9", "backspace", "3", "enter", "2")
        assert rig.controller.speed == 183
        assert rig.registers[1] < 0


@piloted
async def test_the_mouse_holds_a_joint_key(sit_down: Opener) -> None:
    async with sit_down(rig=TEACHMOVER) as sitting:
        await push(sitting, "f12", "m")
        pad = sitting.app.screen.query_one(JointPad)
        rig = sitting.app.session.rig
        await sitting.pilot.mouse_down(pad, offset=(10, 2))
        await sitting.pass_time(0.5)
        assert {key.name for key in rig.controller.held} == {"BASE_PLUS"}
        await sitting.pilot.mouse_up(pad, offset=(10, 2))
        await sitting.pass_time(0.2)
        assert not rig.controller.held
        gone = rig.registers[0]
        assert gone > 50
        await sitting.pass_time(0.3)
        assert rig.registers[0] == gone


@piloted
async def test_every_function_key_has_a_key_and_leaving_takes_all_hands_off(
    sit_down: Opener,
) -> None:
    assert set(KEYS) == set(FunctionKey)
    assert len(set(KEYS.values())) == len(KEYS)
    async with sit_down(rig=TEACHMOVER) as sitting:
        await push(sitting, "f12", "m")
        rig = sitting.app.session.rig
        sitting.app.base_pendant.press(0, 1)
        await sitting.pass_time(0.1)
        sitting.app.pop_screen()
        await sitting.pass_time(0.1)
        assert not rig.controller.held
        assert rig.controller.pendant.mode is PendantMode.MOVE


@piloted
async def test_an_arm_without_a_computer_has_the_other_pendant(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await push(sitting, "f12")
        assert isinstance(sitting.app.screen, PendantScreen)
