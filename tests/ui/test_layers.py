"""Behind a dialog the desk goes on, and only what changed is drawn."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from unittest.mock import patch

import pytest
from rich.style import Style
from textual._compositor import ChopsUpdate, Compositor
from textual.app import App, ComposeResult
from textual.geometry import Region
from textual.screen import Screen
from textual.strip import Strip
from textual.widget import Widget
from textual.widgets import Static

from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_colours, screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.ui.screens.dialog import Choose, Dialog
from trs80arm.ui.screens.palette import PaletteScreen
from trs80arm.ui.terminal.changes import CellsUpdate, Change
from trs80arm.ui.terminal.layers import Layer


def watch(sitting: Sitting, see: Callable[[object], None]) -> None:
    """Have each update seen that is written to the terminal from now on."""
    real = sitting.app._display

    def display(screen: Screen[object], update: object) -> None:
        if update is not None:
            see(update)
        real(screen, update)  # type: ignore[arg-type]

    sitting.app._display = display  # type: ignore[assignment, method-assign]


def watch_lines(sitting: Sitting) -> list[set[int]]:
    """The lines of each update that is written to the terminal from now on."""
    written: list[set[int]] = []

    def see(update: object) -> None:
        if isinstance(update, ChopsUpdate):
            written.append({y for y, _, _ in update.spans})
        elif isinstance(update, CellsUpdate):
            written.append({y for _, y, _ in update.changes})
        else:
            written.append(set(range(sitting.app.size.height)))

    watch(sitting, see)
    return written


async def until_all_is_written(sitting: Sitting, written: list[set[int]]) -> None:
    """Let all of what was asked for reach the terminal, however busy the computer is."""
    begun = False
    while written or not begun:
        begun = begun or bool(written)
        written.clear()
        await sitting.settle()
        await sitting.pilot.pause()


def test_textual_still_has_the_hooks_that_layers_override_and_use() -> None:
    assert "_compositor_refresh()" in inspect.getsource(Screen._on_timer_update)
    assert "_dirty_widgets" in inspect.getsource(Screen._on_idle)
    assert list(inspect.signature(Widget._set_dirty).parameters) == ["self", "regions"]
    assert list(inspect.signature(Compositor._render_chops).parameters) == [
        "self",
        "crop",
        "is_rendered_line",
    ]
    assert "self._compositor = Compositor()" in inspect.getsource(Screen.__init__)
    assert "self._get_renders(crop)" in inspect.getsource(Compositor._render_chops)
    resume = inspect.getsource(Screen._on_screen_resume)
    assert "if event.refresh_styles:" in resume
    assert "self.stack_updates += 1" in resume
    partial = inspect.getsource(Compositor.render_partial_update)
    assert "self._dirty_regions" in partial
    assert "self._render_chops(" in partial


@piloted
async def test_what_is_shown_for_the_first_time_has_the_styles_that_would_be_found_anew(
    sit_down: Opener,
) -> None:
    async with sit_down(120, 40) as sitting:
        for key in ("f3", "f1", "f2", "f8", "ctrl+p", "ctrl+t", "ctrl+g"):
            await sitting.press(key)
            await sitting.settle()
            screen = sitting.app.screen
            widgets = list(screen.walk_children(with_self=True))
            before = [dict(widget.styles.base.get_rules()) for widget in widgets]
            seen = screen_text(sitting.app), screen_colours(sitting.app)
            screen.update_node_styles(animate=False)
            await sitting.settle()
            assert (screen_text(sitting.app), screen_colours(sitting.app)) == seen
            assert [widget.styles.base.get_rules() for widget in widgets] == before
            await sitting.press("escape")
            await sitting.settle()


@piloted
async def test_the_first_frame_shows_what_there_is(
    sit_down: Opener, monkeypatch: pytest.MonkeyPatch
) -> None:
    frames: list[str] = []
    draw = Compositor.render_full_update

    def see(compositor: Compositor, *, simplify: bool = False) -> object:
        frames.append("\n".join(strip.text for strip in compositor.render_strips()))
        return draw(compositor, simplify=simplify)

    monkeypatch.setattr(Compositor, "render_full_update", see)
    async with sit_down(120, 40) as sitting:
        [frame] = frames
        rows = [row.rstrip() for row in frame.splitlines()]
        assert rows == screen_text(sitting.app).splitlines()


@piloted
async def test_what_the_machine_prints_is_seen_behind_a_dialog(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await sitting.press("f8")
        await sitting.settle()
        assert isinstance(sitting.app.screen, Choose)
        await sitting.type_line('CLS: PRINT "THERE IT IS"')
        assert "THERE IT IS" in screen_text(sitting.app)


@piloted
async def test_only_the_lines_that_changed_are_written_behind_a_dialog(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await sitting.type_line("CLS")
        written = watch_lines(sitting)
        await sitting.press("f8")
        await until_all_is_written(sitting, written)
        # What the desk had left to draw when the dialog opened comes with its next change.
        await sitting.type_line("?1")
        await until_all_is_written(sitting, written)
        await sitting.type_line("?2")
        while not written:
            await sitting.pilot.pause()
        lines = set().union(*written)
        assert lines
        assert len(lines) <= 10
        tube = sitting.app.desk.tube.content_region
        assert lines <= set(range(tube.y, tube.bottom)) | {38}


@piloted
async def test_only_the_cells_that_changed_are_written_behind_a_dialog(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await sitting.type_line("CLS")
        written = watch_lines(sitting)
        await sitting.press("f8")
        await sitting.type_line("?1")
        await until_all_is_written(sitting, written)
        spans: list[tuple[int, int, int]] = []

        def see(update: object) -> None:
            if isinstance(update, ChopsUpdate):
                spans.extend(update.spans)

        watch(sitting, see)
        sitting.app.session.rig.type("?2")
        await sitting.pass_time(0.4)
        await until_all_is_written(sitting, written)
        tube = sitting.app.desk.tube.content_region
        lengths = [right - left for y, left, right in spans if tube.y <= y < tube.bottom]
        assert lengths
        assert max(lengths) <= 8


@piloted
async def test_a_dialog_over_another_dialog_shows_the_desk_too(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await sitting.press("f8")
        await sitting.settle()
        await sitting.press("ctrl+p")
        await sitting.settle()
        assert isinstance(sitting.app.screen, PaletteScreen)
        await sitting.type_line('CLS: PRINT "DEEP BELOW"')
        await sitting.settle()
        assert "DEEP BELOW" in screen_text(sitting.app)


@piloted
async def test_behind_a_dialog_the_desk_is_dimmed_and_afterwards_as_before(
    sit_down: Opener,
) -> None:
    async with sit_down(120, 40) as sitting:
        before = screen_colours(sitting.app)
        await sitting.press("f8")
        await sitting.settle()
        behind = screen_colours(sitting.app)
        assert behind.splitlines()[0] != before.splitlines()[0]
        await sitting.press("escape")
        await sitting.settle()
        assert screen_colours(sitting.app) == before


@piloted
async def test_a_theme_that_is_tried_colours_what_is_behind_the_list(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        sitting.app.commands.program.theme()
        await sitting.settle()
        green = screen_colours(sitting.app).splitlines()[0]
        await sitting.press("down")
        await sitting.settle()
        assert screen_colours(sitting.app).splitlines()[0] != green


Sheet = list[list[tuple[str, Style]]]
"""Lines of cells: a character each and how it looks."""


def cells_of(runs: Iterable[tuple[str, Style | None]]) -> list[tuple[str, Style]]:
    """Runs of characters cell by cell, as far as they can be told apart by looking at them."""
    return [(sign, looks(sign, style or Style())) for text, style in runs for sign in text]


def looks(sign: str, style: Style) -> Style:
    """What of a style is seen: of a blank only what is behind it."""
    return Style(bgcolor=style.bgcolor) if sign == " " else style


def written_on(sheet: Sheet, update: ChopsUpdate | CellsUpdate) -> None:
    """Put an update on a sheet, as the terminal would."""
    if isinstance(update, CellsUpdate):
        for x, y, runs in update.changes:
            cells = cells_of(runs)
            sheet[y][x : x + len(cells)] = cells
        return
    for y, left, right in update.spans:
        strips = zip(update.chop_ends[y], update.chops[y].items(), strict=False)
        for end, (x, strip) in strips:
            if strip is not None and x <= right and end > left:
                cells = cells_of(segment[:2] for segment in strip.crop(0, min(end, right) - x))
                sheet[y][x : x + len(cells)] = cells


def sheet_of(sitting: Sitting) -> Sheet:
    strips = sitting.app.screen._compositor.render_strips()
    return [cells_of(segment[:2] for segment in strip) for strip in strips]


@piloted
async def test_what_is_written_bit_by_bit_is_what_there_is(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        sheet, whole = sheet_of(sitting), 0
        bits: list[object] = []

        def see(update: object) -> None:
            nonlocal sheet, whole
            if isinstance(update, ChopsUpdate | CellsUpdate):
                written_on(sheet, update)
                bits.append(update)
            else:
                sheet, whole = sheet_of(sitting), whole + 1

        watch(sitting, see)
        await sitting.type_line(
            '10 PRINT "HERE": @STEP 200,300,-200,200,0,0,-200: @READ A: GOTO 10'
        )
        sitting.app.session.rig.type("RUN\r")
        for _ in range(8):
            await sitting.pass_time(0.4)
            assert sheet == sheet_of(sitting)
        sitting.app.say("A word with an alarm.", error=True)
        await sitting.pass_time(0.4)
        await sitting.pilot.pause()
        assert sheet == sheet_of(sitting)
        assert whole < 8
        straight = [bit for bit in bits if isinstance(bit, CellsUpdate)]
        assert len(straight) > len(bits) / 2


class Heap(Layer):
    """Two panels, and a sheet that lies over the second one."""

    CSS = """
    Static { position: absolute; width: 10; height: 3; }
    #second { offset: 0 5; }
    #sheet { offset: 8 6; }
    """

    def compose(self) -> ComposeResult:
        yield Static(id="first")
        yield Static(id="second")
        yield Static(id="sheet")


@piloted
async def test_what_lies_behind_something_else_is_not_written_over_it() -> None:
    app: App[None] = App()
    async with app.run_test(size=(40, 12)) as pilot:
        heap = Heap()
        await app.push_screen(heap)
        await pilot.pause()
        cells = [Change(1, 1, [("x", Style())])]
        with heap.frame():
            straight = {panel.id for panel in heap.query(Static) if heap.change(panel, cells)}
        assert straight == {"first", "sheet"}
        assert not heap.change(heap.query_one("#first"), cells)


@piloted
async def test_what_is_all_behind_something_else_is_not_asked_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    app: App[None] = App()
    async with app.run_test(size=(40, 12)) as pilot:
        heap = Heap()
        await app.push_screen(heap)
        heap.query_one("#second").styles.offset = (8, 8)
        await pilot.pause()
        asked: dict[str | None, Region] = {}
        real = Widget.render_lines

        def render_lines(widget: Widget, crop: Region) -> list[Strip]:
            asked[widget.id] = crop
            return real(widget, crop)

        monkeypatch.setattr(Widget, "render_lines", render_lines)
        heap._compositor.render_strips()
        assert asked["sheet"] == Region(0, 0, 10, 3)
        assert asked["second"] == Region(0, 1, 10, 2)
        heap.query_one("#second").styles.offset = (8, 6)
        await pilot.pause()
        asked.clear()
        heap._compositor.render_strips()
        assert {"first", "sheet"} <= asked.keys()
        assert "second" not in asked


@pytest.mark.parametrize("key", ["f2", "f8", "f12"])
@piloted
async def test_a_dialog_is_drawn_when_it_is_laid_out_and_not_before(
    sit_down: Opener, key: str
) -> None:
    async with sit_down(120, 40) as sitting:
        await sitting.type_line("CLS")
        laid_out: list[bool] = []
        watch(sitting, lambda _: laid_out.append(not sitting.app.screen._layout_required))
        layouts = 0
        real = Screen._refresh_layout

        def refresh_layout(screen: Screen[object], *arguments: object, **more: object) -> None:
            nonlocal layouts
            layouts += screen is sitting.app.screen
            real(screen, *arguments, **more)  # type: ignore[arg-type]

        with patch.object(Screen, "_refresh_layout", refresh_layout):
            await sitting.press(key)
            await sitting.settle()
        assert isinstance(sitting.app.screen, Dialog)
        assert 0 < len(laid_out) < layouts
        assert all(laid_out)


@piloted
async def test_only_panels_and_lines_that_changed_are_asked_for(
    sit_down: Opener, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with sit_down(120, 40) as sitting:
        desk = sitting.app.desk
        asked: dict[Widget, int] = {}
        real = Widget.render_lines

        def render_lines(widget: Widget, crop: Region) -> list[Strip]:
            asked[widget] = asked.get(widget, 0) + crop.height
            return real(widget, crop)

        monkeypatch.setattr(Widget, "render_lines", render_lines)
        desk.tube.refresh(Region(0, 0, 64, 1))
        desk.status.refresh()
        await sitting.pilot.pause()
        assert asked == {desk.tube: 1, desk.status: 1}


@piloted
async def test_laid_out_as_it_was_nothing_is_drawn(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await sitting.type_line("CLS")
        await sitting.settle()
        await sitting.pilot.pause()
        written = watch_lines(sitting)
        sitting.app.desk.lay_out()
        await sitting.pilot.pause()
        assert written == []


@piloted
async def test_a_frame_is_written_at_once_and_of_it_what_changed(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await sitting.type_line("CLS")
        desk, rig = sitting.app.desk, sitting.app.session.rig
        updates: list[object] = []
        monkeypatched = sitting.app._display
        sitting.app._display = lambda _, update: updates.append(update)  # type: ignore[method-assign, assignment]
        rig.type("AB")
        rig.run_for(1.0)
        desk.numbers_due = sitting.wall.now + 99
        sitting.app.draw()
        sitting.app._display = monkeypatched  # type: ignore[method-assign]
        [update] = updates
        assert isinstance(update, CellsUpdate)
        place = desk.tube.content_region.offset
        [change] = update.changes
        assert (change.x, change.y) == (place.x + 1, place.y + 1)
        assert "".join(text for text, _ in change.runs).startswith("AB")


@piloted
async def test_where_nothing_changes_nothing_is_written(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await sitting.type_line("CLS")
        await sitting.settle()
        await sitting.pilot.pause()
        written = watch_lines(sitting)
        for _ in range(5):
            sitting.app.draw()
            await sitting.pilot.pause()
        assert written == []
