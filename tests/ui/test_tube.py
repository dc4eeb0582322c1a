"""What of the TRS-80's screen is drawn again, and when."""

from __future__ import annotations

from typing import Any

from textual.app import ComposeResult
from textual.geometry import Region

from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from trs80arm.machine.video import COLUMNS, ROWS
from trs80arm.ui.panels.tube import Tube
from trs80arm.ui.themes import Themed


class Watched(Tube):
    """A tube that notes what it asks to be drawn."""

    def __init__(self) -> None:
        super().__init__()
        self.asked: list[tuple[Region, ...]] = []

    def refresh(self, *regions: Region, **options: Any) -> Any:
        self.asked.append(regions)
        return super().refresh(*regions, **options)


class Video:
    """A video memory that is written line by line."""

    def __init__(self) -> None:
        self.wide = False
        self._rows = [b" " * COLUMNS] * ROWS
        self._dirty: list[int] = []

    def write(self, row: int, text: str) -> None:
        self._rows[row] = text.encode("ascii").ljust(COLUMNS)
        self._dirty.append(row)

    def take_dirty(self) -> list[int]:
        taken, self._dirty = self._dirty, []
        return taken

    def row(self, number: int) -> bytes:
        return self._rows[number]


class Desk(Themed[None]):
    def __init__(self) -> None:
        super().__init__()
        self.tube = Watched()
        self.video = Video()

    def compose(self) -> ComposeResult:
        yield self.tube


@piloted
async def test_only_cells_that_differ_are_drawn_again() -> None:
    desk = Desk()
    async with desk.run_test(size=(64, 16)) as pilot:
        desk.video.write(3, "HELLO")
        desk.tube.show(desk.video, None)
        await pilot.pause()
        desk.tube.asked.clear()
        desk.video.write(3, "HALLO")
        desk.tube.show(desk.video, None)
        assert desk.tube.asked == [(Region(1, 3, 1, 1),)]
        await pilot.pause()
        assert screen_text(desk).splitlines()[3].rstrip() == "HALLO"


@piloted
async def test_a_line_written_with_what_it_shows_costs_no_drawing() -> None:
    desk = Desk()
    async with desk.run_test(size=(64, 16)) as pilot:
        await pilot.pause()
        desk.tube.asked.clear()
        desk.video.write(0, "")
        desk.tube.show(desk.video, None)
        assert desk.tube.asked == []


@piloted
async def test_another_width_of_characters_draws_all_of_it_again() -> None:
    desk = Desk()
    async with desk.run_test(size=(64, 16)) as pilot:
        desk.video.write(3, "HxExLxLxO")
        desk.tube.show(desk.video, None)
        await pilot.pause()
        desk.tube.asked.clear()
        desk.video.wide = True
        desk.tube.show(desk.video, None)
        assert desk.tube.asked == [()]
        await pilot.pause()
        assert screen_text(desk).splitlines()[3].rstrip() == "H E L L O"
