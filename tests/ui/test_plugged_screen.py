"""A real arm in the terminal: the question before it moves, Escape, and what is told of a fault."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

from tests.serial.far_side import FarSide, nobody
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Sitting, Wall
from trs80arm import RigSettings
from trs80arm.arm import ArmSettings
from trs80arm.desk.opening import open_session
from trs80arm.machine.driver import DriverSettings
from trs80arm.options import ArmStyle, TerminalOptions
from trs80arm.serial.courier import Courier
from trs80arm.serial.limits import Plugging, PlugSettings
from trs80arm.ui.app import Trs80Arm

TEACHMOVER = RigSettings(arm=ArmSettings(model="teachmover"), driver=DriverSettings(break_now=True))


@asynccontextmanager
async def plugged_in(state: Path, far: FarSide) -> AsyncIterator[Sitting]:
    """A desk with an arm on a wire, its question on the screen."""
    (state / "tour.json").write_text("{}")
    options = TerminalOptions(rig=TEACHMOVER, arm=ArmStyle.OUTLINE, plug=Plugging("/dev/ttyUSB0"))
    session, wall = open_session(options), Wall()
    courier = Courier(session.rig, far, PlugSettings())
    app = Trs80Arm(session, options, state, wall=wall, ticking=False, courier=courier)
    app.animation_level = "none"
    async with app.run_test(size=(80, 24)) as pilot:
        await pilot.pause()
        sitting = Sitting(app, pilot, wall)
        await sitting.settle()
        yield sitting
        app.plugged.close()


@piloted
async def test_the_arm_moves_after_a_yes_and_stops_at_escape(tmp_path: Path) -> None:
    far = FarSide()
    async with plugged_in(tmp_path, far) as sitting:
        rig = sitting.app.session.rig
        assert "May it move?" in screen_text(sitting.app)
        rig.type("@STEP 50,-1500\r")
        before = rig.time
        await sitting.pass_time(1)
        assert rig.time == before
        assert far.words == ["@READ"]
        await sitting.press("right", "enter")
        await sitting.settle()
        for _ in range(60):
            await sitting.pass_time(0.1)
            if far.steps:
                break
        assert far.steps
        await sitting.press("escape")
        await sitting.pass_time(0.5)
        sent = len(far.heard)
        await sitting.pass_time(1)
        assert len(far.heard) == sent
        assert rig.registers[0] > -1500


@piloted
async def test_enter_alone_leaves_the_arm_where_it_is(tmp_path: Path) -> None:
    far = FarSide()
    async with plugged_in(tmp_path, far) as sitting:
        await sitting.press("enter")
        await sitting.settle()
        assert far.closed
        sitting.app.session.rig.type("@STEP 50,-90\r")
        await sitting.pass_time(4)
        assert sitting.app.session.rig.registers[0] == -90
        assert far.words == ["@READ"]


@piloted
async def test_a_wire_that_is_cut_is_told_in_a_sentence_and_the_program_stops(
    tmp_path: Path,
) -> None:
    far = FarSide()
    async with plugged_in(tmp_path, far) as sitting:
        await sitting.press("right", "enter")
        await sitting.settle()
        far.answer = nobody
        rig = sitting.app.session.rig
        rig.load_text("10 @STEP 80,-100\n20 @STEP 80,100\n30 GOTO 10\n")
        rig.type("RUN\r")
        await sitting.pass_time(4)
        assert rig.waiting.name == "COMMAND"
        assert "The wire to the arm is dead" in screen_text(sitting.app)
        assert far.closed
