from __future__ import annotations

from typing import Any

from textual.app import ComposeResult
from textual.geometry import Region

from tests.drawing import samples
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from trs80arm.ui.panels.registers import RegistersPanel
from trs80arm.ui.themes import Themed


class Watched(RegistersPanel):
    """A panel that notes what it asks to be drawn."""

    def __init__(self) -> None:
        super().__init__()
        self.asked: list[tuple[Region, ...]] = []

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
async def test_only_lines_that_differ_are_drawn_again() -> None:
    desk = Desk()
    async with desk.run_test(size=(60, 12)) as pilot:
        desk.panel.show(samples.readings())
        await pilot.pause()
        desk.panel.asked.clear()
        desk.panel.show(samples.readings(registers=(0, 0, 7, 0, 0, 0), joints=(0, 0, 7, 0, 0, 0)))
        assert desk.panel.asked == [(Region(0, 3, 40, 1),)]
        await pilot.pause()
        assert "J3 elbow            7      7" in screen_text(desk)


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
