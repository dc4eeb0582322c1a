"""The scope and the arm in space, worked with mouse and keys as a person would."""

from __future__ import annotations

import pytest
from textual.events import MouseMove, MouseScrollDown, MouseScrollUp

from tests.ui.piloted import piloted
from tests.ui.sitting import Opener
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.scope import LABEL
from trs80arm.ui.panels.arm_view import ArmView
from trs80arm.ui.panels.scope_panel import ScopePanel
from trs80arm.ui.panels.space_view import SpaceView


@piloted
async def test_the_scope_shows_the_latches_of_a_motion(sit_down: Opener) -> None:
    async with sit_down(100, 30) as sitting:
        await sitting.app.run_action("do('fill_scope')")
        await sitting.type_line("@STEP 50,100")
        await sitting.pass_time(1)
        scope = sitting.app.desk.panels["scope"]
        assert isinstance(scope, ScopePanel)
        lines = [scope.render_line(y).text for y in range(scope.size.height)]
        [base] = [line for line in lines if line.startswith("J1 base")]
        assert set("12345678▒") & set(base[LABEL:])


@piloted
async def test_in_a_huge_window_the_scope_comes_back_to_its_place(sit_down: Opener) -> None:
    async with sit_down(200, 60) as sitting:
        desk, run = sitting.app.desk, sitting.app.run_action
        await run("do('show_effort')")
        assert not desk.panels["scope"].display
        await run("do('show_scope')")
        assert desk.panels["scope"].display
        assert desk.zoomed is None
        await run("do('show_scope')")
        assert desk.zoomed == "scope"
        await run("do('show_scope')")
        assert desk.zoomed is None


@piloted
async def test_keys_of_the_scope(sit_down: Opener) -> None:
    async with sit_down(100, 30) as sitting:
        await sitting.app.run_action("do('show_scope')")
        await sitting.type_line("@STEP 50,100")
        await sitting.pass_time(3)
        scope = sitting.app.desk.panels["scope"]
        assert isinstance(scope, ScopePanel)
        step = scope.scope.step
        await sitting.press("alt+pageup", "alt+down", "alt+left")
        assert scope.scope.step < step
        assert scope.scope.joint == 1
        assert "looking back" in scope.render_line(0).text
        await sitting.press("alt+pagedown", "alt+up", "alt+right")
        assert scope.scope.step == step
        assert scope.scope.joint is None
        assert "looking back" not in scope.render_line(0).text


@piloted
async def test_a_click_puts_the_cursor_and_one_on_the_names_goes_to_a_joint(
    sit_down: Opener,
) -> None:
    async with sit_down(100, 30) as sitting:
        await sitting.app.run_action("do('fill_scope')")
        await sitting.pass_time(3)
        scope = sitting.app.desk.panels["scope"]
        assert isinstance(scope, ScopePanel)
        await sitting.pilot.click(scope, offset=(LABEL + 80, 5))
        assert scope.scope.cursor is not None
        await sitting.pilot.click(scope, offset=(2, 5))
        assert scope.scope.joint == 1


@piloted
async def test_the_mouse_turns_the_arm_in_space(sit_down: Opener) -> None:
    async with sit_down(100, 30) as sitting:
        await sitting.app.run_action("do('fill_space')")
        await sitting.settle()
        space = sitting.app.desk.panels["space"]
        assert isinstance(space, SpaceView)
        before = space.picture.orbit
        await sitting.pilot.mouse_down(space, offset=(20, 10))
        await sitting.pilot.hover(space, offset=(30, 10))
        await sitting.pilot.mouse_up(space, offset=(30, 10))
        turned = space.picture.orbit
        assert turned != before
        space.post_message(MouseMove(space, 5, 5, 3, 0, 0, False, False, False))
        await sitting.settle()
        assert space.picture.orbit == turned


@pytest.mark.parametrize("name", ["side", "top", "space"])
@piloted
async def test_the_wheel_brings_the_picture_closer_over_which_it_is_turned(
    sit_down: Opener, name: str
) -> None:
    async with sit_down(200, 60) as sitting:
        view = sitting.app.desk.panels[name]
        assert isinstance(view, ArmView)
        shown = view.picture.draw(Readings(), 40, 12)
        for wheel, same in ((MouseScrollUp, False), (MouseScrollDown, True)):
            view.post_message(wheel(view, 5, 5, 0, 0, 0, False, False, False))
            await sitting.settle()
            assert (view.picture.draw(Readings(), 40, 12) == shown) is same


@pytest.mark.parametrize(
    ("key", "way"),
    [("ctrl+left", "turn"), ("ctrl+right", "turn"), ("ctrl+pageup", "tilt")],
)
@piloted
async def test_keys_walk_round_the_arm_in_space(sit_down: Opener, key: str, way: str) -> None:
    async with sit_down(100, 30) as sitting:
        space = sitting.app.desk.panels["space"]
        assert isinstance(space, SpaceView)
        before = getattr(space.picture.orbit, way)
        await sitting.press(key)
        assert getattr(space.picture.orbit, way) != before


@pytest.mark.parametrize(
    ("command", "panel"),
    [
        *((f"space_{way}", "space") for way in ("left", "right", "higher", "lower")),
        *((f"scope_{way}", "scope") for way in ("back", "on", "closer", "farther", "next")),
    ],
)
@piloted
async def test_a_command_for_a_panel_shows_it(sit_down: Opener, command: str, panel: str) -> None:
    async with sit_down(80, 24) as sitting:
        assert not sitting.app.desk.panels[panel].display
        await sitting.app.run_action(f"do('{command}')")
        assert sitting.app.desk.panels[panel].display
        await sitting.app.run_action(f"do('{command}')")
        assert sitting.app.desk.panels[panel].display
