"""The keys at the foot of a dialog look as in Textual's footer, and a click is the key."""

from __future__ import annotations

from typing import ClassVar

import pytest
from textual.app import App, ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.widget import Widget
from textual.widgets import Button, Footer, Input

from tests.ui.piloted import piloted
from trs80arm.ui.screens.keys_line import KeysLine


class Corner(Vertical):
    """Has a key of its own while something in it has the keyboard."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("z", "app.press('z')", "Corner's own")]


class Program(App[None]):
    """Two things that can have the keyboard, and keys of all kinds."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("f7,s", "press('step')", "Step", key_display="F7"),
        Binding("space", "press('stop')", "Stop", key_display="Space"),
        Binding("o", "press('over')", "Over"),
        Binding("x", "press('never')", "Never"),
        Binding("h", "press('hidden')", "Hidden", show=False),
    ]

    def __init__(self, line: Widget) -> None:
        super().__init__()
        self.line = line
        self.pressed: list[str] = []
        self.rung = 0

    def compose(self) -> ComposeResult:
        yield Button("A button")
        with Corner():
            yield Input()
        yield self.line

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """One is there and cannot be used."""
        return None if "never" in parameters else True

    def action_press(self, what: str) -> None:
        self.pressed.append(what)

    def bell(self) -> None:
        self.rung += 1

    @property
    def foot(self) -> list[tuple[str, str, str, bool, bool]]:
        """The cells of the last row: characters, colours, bold, dim."""
        cells = []
        for text, style, _ in self.screen._compositor.render_strips()[-1]:
            assert style is not None
            colours = str(style.color), str(style.bgcolor)
            cells += [(one, *colours, bool(style.bold), bool(style.dim)) for one in text]
        # Where nothing stands the colour of what would is nothing.
        return [
            (one, "" if one == " " else fore, back, one != " " and bold, one != " " and dim)
            for one, fore, back, bold, dim in cells
        ]


@pytest.mark.parametrize("width", [80, 30])
@piloted
async def test_it_looks_as_textuals_footer_does(width: int) -> None:
    feet = []
    for line in (Footer(show_command_palette=False, compact=True), KeysLine()):
        async with Program(line).run_test(size=(width, 12)) as pilot:
            app = pilot.app
            assert isinstance(app, Program)
            await pilot.pause()
            one = app.foot
            app.query_one(Input).focus()
            await pilot.pause()
            other = app.foot
            assert other != one
            await pilot.hover(line, offset=(1, 0))
            await pilot.pause()
            pointed = app.foot
            assert pointed != other
            feet.append((one, other, pointed))
    assert feet[1] == feet[0]
    text = "".join(cell[0] for cell in feet[0][0])
    assert text.startswith("F7 Step Space Stop o Over")
    assert "Hidden" not in text


@piloted
async def test_a_click_is_the_key_and_one_that_cannot_be_used_rings() -> None:
    line = KeysLine()
    async with Program(line).run_test(size=(80, 12)) as pilot:
        app = pilot.app
        assert isinstance(app, Program)
        app.query_one(Button).focus()
        await pilot.pause()
        text = "".join(cell[0] for cell in app.foot)
        for word in ("Step", "Over", "Stop"):
            await pilot.click(line, offset=(text.index(word), 0))
        await pilot.pause()
        assert app.pressed == ["step", "over", "stop"]
        await pilot.click(line, offset=(text.index("Space") - 1, 0))
        await pilot.click(line, offset=(70, 0))
        assert app.rung == 0
        await pilot.click(line, offset=(text.index("Never"), 0))
        assert app.rung == 1
        assert len(app.pressed) == 3
