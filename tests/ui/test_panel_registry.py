"""A panel is a module and a row in the registry; nothing else knows it."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import trs80arm
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row
from trs80arm.ui import layout
from trs80arm.ui.commands.rows.view import panel_commands
from trs80arm.ui.panels.panel import Panel
from trs80arm.ui.panels.registry import PANELS, Cadence, PanelRow, groups

PACKAGE = Path(trs80arm.__file__).parent
REGISTRY = PACKAGE / "ui" / "panels" / "registry.py"


class WeatherPanel(Panel):
    """A panel that nobody has heard of."""

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        return [((f"WEATHER AT {readings.waiting.name}", Ink.PLAIN),)]


WEATHER = PanelRow(
    "weather",
    "Weather",
    WeatherPanel,
    Cadence.NUMBERS,
    "weather",
    shows="What it is like outside.",
    fills="The weather fills the screen.",
)


def importers(module: str) -> set[str]:
    """The files of the package that import a module."""
    found = set()
    for path in PACKAGE.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        # Few files have its name at all, and only these are read as Python.
        for node in ast.walk(ast.parse(text)) if module in text else ():
            if isinstance(node, ast.ImportFrom) and node.module == module:
                found.add(path.name)
    return found


@pytest.mark.parametrize("name", ["cell", "coils", "effort", "events", "pose", "registers"])
def test_only_the_registry_knows_a_panel(name: str) -> None:
    assert importers(f"trs80arm.ui.panels.{name}") == {REGISTRY.name}


@piloted
@pytest.mark.parametrize(("width", "height"), [(80, 24), (120, 40), (64, 24)])
async def test_a_row_brings_a_panel_to_the_screen(
    sit_down: Opener, width: int, height: int
) -> None:
    async with sit_down(width, height, panels=(*PANELS, WEATHER)) as sitting:
        desk = sitting.app.desk
        assert "WEATHER" not in screen_text(sitting.app)
        for command in panel_commands([WEATHER]):
            command.do(sitting.app.commands)
            sitting.wall.now += 1
            await sitting.settle()
            assert "WEATHER AT COMMAND" in screen_text(sitting.app)
        assert desk.zoomed == "weather"
        desk.zoom("weather")
        for _ in PANELS:
            desk.next_bottom()
            if desk.bottom == "weather":
                break
        assert desk.bottom == "weather"


@piloted
async def test_one_large_panel_follows_another_and_f11_goes_back(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        desk = sitting.app.desk
        for name in ("space", "scope"):
            await sitting.app.run_action(f"do('fill_{name}')")
            await sitting.pass_time(0.2)
            assert desk.zoomed == name
            assert "F11 goes back to all panels." in screen_text(sitting.app)
        await sitting.press("f11")
        assert desk.zoomed is None


def test_every_group_can_be_brought_under_the_tube_where_not_all_is_shown() -> None:
    names = groups((*PANELS, WEATHER))
    assert set(layout.bottoms(names, 64, 24)) == set(names) - {"tube"}
    large = layout.bottoms(names, 120, 40)
    assert large[0] == "arm"
    assert {"keyboard", "weather"} < set(large)
    assert {"tube", "numbers", "motors", "log"}.isdisjoint(large)


def test_the_palette_names_what_the_rows_want() -> None:
    titles = [command.title for command in panel_commands((*PANELS, WEATHER))]
    assert {"View: arm", "View: keyboard", "View: weather"} < set(titles)
    assert {"View: registers large", "View: weather large"} < set(titles)
    assert not {"View: tube", "View: keyboard large"} & set(titles)


@piloted
async def test_a_panel_is_mounted_when_it_is_first_shown_and_in_its_place(
    sit_down: Opener,
) -> None:
    async with sit_down(80, 24) as sitting:
        desk = sitting.app.desk
        rows = [row.id for row in PANELS]

        def mounted() -> list[str | None]:
            return [child.id for child in desk.children if child.id in rows]

        first = mounted()
        assert first == [row for row in rows if desk.panels[row].display]
        assert len(first) < len(rows) / 2
        desk.zoom("paper")
        await sitting.settle()
        assert mounted() == [row for row in rows if row in {*first, "paper"}]
        assert desk.panels["paper"].outer_size == (80, 22)
        desk.zoom("paper")
        await sitting.settle()
        assert "paper" in mounted()
