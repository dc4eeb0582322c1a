from __future__ import annotations

from typing import Any

import pytest
from textual.app import ComposeResult
from textual.geometry import Region

from tests.drawing import samples
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row
from trs80arm.ui.panels.panel import Panel
from trs80arm.ui.panels.registers import RegistersPanel
from trs80arm.ui.themes import Themed


class Watched(RegistersPanel):
    """A panel that notes what it asks to be drawn."""

    def __init__(self) -> None:
        super().__init__()
        self.asked: list[tuple[Region, ...]] = []
        self.found: set[str] = set()

    def get_component_rich_style(self, *names: str, **options: Any) -> Any:
        self.found.update(names)
        return super().get_component_rich_style(*names, **options)

    def refresh(self, *regions: Region, **options: Any) -> Any:
        self.asked.append(regions)
        return super().refresh(*regions, **options)


class Desk(Themed[None]):
    CSS = "Watched { width: 40; height: 9; }"

    def __init__(self) -> None:
        super().__init__()
        self.panel = Watched()

    def compose(self) -> ComposeResult:
        yield self.panel


@piloted
async def test_only_cells_that_differ_are_drawn_again() -> None:
    desk = Desk()
    async with desk.run_test(size=(60, 12)) as pilot:
        desk.panel.show(samples.readings())
        await pilot.pause()
        desk.panel.asked.clear()
        desk.panel.show(samples.readings(registers=(0, 0, 7, 0, 0, 0), joints=(0, 0, 7, 0, 0, 0)))
        assert desk.panel.asked == [(Region(20, 3, 8, 1),)]
        await pilot.pause()
        assert "J3 elbow            7      7" in screen_text(desk)


@piloted
async def test_however_many_lines_differ_the_others_stand() -> None:
    desk = Desk()
    async with desk.run_test(size=(60, 12)) as pilot:
        desk.panel.show(samples.readings())
        await pilot.pause()
        desk.panel.asked.clear()
        moved = (7, 7, 7, 7, 7, 7)
        desk.panel.show(samples.readings(registers=moved, joints=moved))
        assert desk.panel.asked == [tuple(Region(20, y, 8, 1) for y in range(1, 7))]


@piloted
async def test_styles_are_found_of_those_inks_only_that_are_on_the_panel() -> None:
    desk = Desk()
    async with desk.run_test(size=(60, 12)) as pilot:
        desk.panel.show(samples.readings())
        await pilot.pause()
        rows = desk.panel.draw(samples.readings(), 40, 9)
        inks = {ink for row in rows for _, ink in row} - {Ink.PLAIN}
        assert desk.panel.found == {f"panel--{ink.value}" for ink in inks}


class Saying(Panel):
    """A panel with a word from outside."""

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        return [(("A\x1b[2JB\x9b", Ink.STRONG),)]


@pytest.mark.parametrize("theme", ["green", "textual-ansi"])
@piloted
async def test_no_control_codes_leave_a_panel(theme: str) -> None:
    class Outside(Themed[None]):
        def compose(self) -> ComposeResult:
            yield Saying()

    desk = Outside()
    desk.theme = theme if theme in desk.available_themes else "textual-dark"
    async with desk.run_test(size=(60, 12)) as pilot:
        panel = desk.query_one(Saying)
        panel.show(samples.readings())
        await pilot.pause()
        line = panel.render_lines(Region(0, 0, 60, 1))[0]
        assert line.text.rstrip() == "A[2JB"


@piloted
async def test_readings_that_look_the_same_cost_no_drawing() -> None:
    desk = Desk()
    async with desk.run_test(size=(60, 12)) as pilot:
        desk.panel.show(samples.readings())
        await pilot.pause()
        desk.panel.asked.clear()
        desk.panel.show(samples.readings(time=99.0))
        assert desk.panel.asked == []


@piloted
async def test_a_panel_follows_its_size() -> None:
    desk = Desk()
    async with desk.run_test(size=(60, 12)) as pilot:
        desk.panel.show(samples.slipped())
        await pilot.pause()
        desk.panel.styles.width = 16
        await pilot.pause()
        assert "J2     -8    16!" in screen_text(desk)
        assert "shoulder" not in screen_text(desk)


@piloted
async def test_another_theme_recolours_the_panel() -> None:
    desk = Desk()
    async with desk.run_test(size=(60, 12)) as pilot:
        desk.panel.show(samples.slipped())
        await pilot.pause()
        before = desk.panel.render_line(2)
        desk.theme = "textual-light"
        await pilot.pause()
        after = desk.panel.render_line(2)
        assert after.text == before.text
        assert [segment.style for segment in after] != [segment.style for segment in before]
