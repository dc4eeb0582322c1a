"""The screen of the desk: all panels in their places, drawn when their time has come.

It knows what is shown and how, and no machine: the program hands it a rig to look at. No panel has
the keyboard: whatever is shown, plain keys are the TRS-80's, and all hands leave it when a dialog
opens.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from math import radians

from textual import events
from textual.app import ComposeResult
from textual.geometry import Offset, Size
from textual.markup import escape
from textual.message import Message
from textual.widget import Widget
from textual.widgets import Static

from trs80arm.arm.loads import Loads
from trs80arm.deck import Deck
from trs80arm.drawing.readings import Readings
from trs80arm.inspection import Inspection
from trs80arm.machine.video import COLUMNS
from trs80arm.options import ArmStyle, CursorStyle, GlyphSet
from trs80arm.rig import Rig, Waiting
from trs80arm.shown import shown
from trs80arm.trace.history import History
from trs80arm.ui import layout
from trs80arm.ui.keys.host_keys import trs80_keys
from trs80arm.ui.layout import Lead
from trs80arm.ui.panels.arm_view import ArmView
from trs80arm.ui.panels.guide import ROWS, GuideBar
from trs80arm.ui.panels.inspector import Inspector
from trs80arm.ui.panels.registry import AnyPanel, Cadence, PanelRow, groups
from trs80arm.ui.panels.scope_panel import ScopePanel
from trs80arm.ui.panels.space_view import SpaceView
from trs80arm.ui.panels.status import Pace, StatusLine
from trs80arm.ui.panels.top_view import TopView
from trs80arm.ui.panels.tube import Tube
from trs80arm.ui.terminal.layers import Layer
from trs80arm.ui.terminal.pixels import NOT_HERE, PixelScreen

BLINK_SECONDS = 0.5
STAY = 3.0
"""Seconds of the wall for which the arm keeps the room after it moved, and the tube after it was
written on elsewhere than at its end."""
NUMBERS_EVERY = 0.1
"""Seconds of the wall between two looks of the panels with numbers."""
PICTURES_EVERY = 0.045
"""The same of the pictures of the arm: each second frame of thirty a second."""
PIXELS_SHARE = 0.25
"""How much of the processor's time pictures in pixels may take, which are many to draw and send."""
TOO_SMALL = (
    "trs80arm needs {0} columns and {1} rows.\nThis terminal has {2} and {3}.\nCtrl+Q leaves."
)


class Typed(Message):
    """A plain key was pressed while no dialog was open."""

    def __init__(self, name: str, text: str | None) -> None:
        super().__init__()
        self.name = name
        self.text = text


class DeskScreen(Layer):
    """All panels, and what of them is shown.

    Args:
        rows: the panels.
        bar: the line of commands at the bottom.
        let_go: takes all hands off the machine's keys.

    Attributes:
        panels: the widgets, by their ids.
        tube: the screen of the TRS-80.
        side: the arm from the side.
        status: the line under everything.
        bottom: the group that is shown under the tube.
        zoomed: the panel or group that fills the screen, or None.
        history: what latches and arm did lately, for the scope.
        arm_style: how the arm is drawn.
        no_pixels: why it cannot be in pixels; empty if it can.
        cursor_style: whether the cursor blinks.
        numbers_due: the wall's time at which numbers are to be drawn again.
        still: whether arm and bench stood at the last frame as at the one before.
        laid_out_for: the size of the terminal that the panels have their places for.
    """

    def __init__(
        self,
        rows: Sequence[PanelRow],
        bar: Widget,
        let_go: Callable[[], None],
    ) -> None:
        super().__init__(id="desk")
        self._rows = rows
        self._groups = groups(rows)
        self._let_go = let_go
        self.panels = {row.id: row.make(id=row.id) for row in rows}
        for panel in self.panels.values():
            panel.add_class("placed")
            panel.display = False
        self._scopes = [panel for panel in self.panels.values() if isinstance(panel, ScopePanel)]
        [self.tube] = (panel for panel in self.panels.values() if isinstance(panel, Tube))
        self._arm_views = [panel for panel in self.panels.values() if isinstance(panel, ArmView)]
        self._inspectors = [panel for panel in self.panels.values() if isinstance(panel, Inspector)]
        self.side = self._arm_views[0]
        self.status = StatusLine(id="status")
        self._bar = bar
        self._guide = GuideBar(id="guide")
        self._guide.display = False
        self._too_small = Static(id="too-small")
        self._too_small.display = False
        self.bottom = layout.ARM
        self.zoomed: str | None = None
        self.history: History | None = None
        self.arm_style = ArmStyle.ASCII
        self.no_pixels = NOT_HERE
        self.cursor_style = CursorStyle.BLINK
        self.numbers_due = 0.0
        self.laid_out_for = Size(0, 0)
        self._pictures_due = 0.0
        self._pixels_took = 0.0
        self._shown: list[tuple[Cadence, AnyPanel]] = []
        self._loads: Loads | None = None
        self._titles = "", ""
        self.still = False
        self._chosen_lead: Lead | None = None
        self._moving_lead = Lead.TUBE
        self._moved_at = self._wrote_at = -STAY
        self._coils: tuple[int, ...] = (0,) * 7
        self._stood: tuple[object, ...] = ()

    def compose(self) -> ComposeResult:
        """What is shown at first, as `lay_out` has decided; what else is shown is mounted then."""
        yield from (widget for widget in self._at_times if widget.display)
        yield self.status
        yield self._bar

    @property
    def _at_times(self) -> list[Widget]:
        """What is not always shown, in its order."""
        return [self._too_small, *self.panels.values(), self._guide]

    def _mount_shown(self) -> None:
        """Mount what is shown for the first time, each in its place."""
        before: Widget = self.status
        if not before.is_attached:
            return
        for widget in reversed(self._at_times):
            if widget.display and not widget.is_attached:
                self.mount(widget, before=before)
            if widget.is_attached:
                before = widget

    def on_screen_suspend(self) -> None:
        """A dialog opened."""
        self._let_go()
        self._redraw_pixels()

    def on_screen_resume(self) -> None:
        """It closed."""
        self._redraw_pixels()

    def _redraw_pixels(self) -> None:
        """Behind a dialog the arm is drawn in characters, as pixels would lie over it."""
        if self.arm_style is ArmStyle.PIXELS:
            for view in self._arm_views:
                view.redraw()

    def on_key(self, event: events.Key) -> None:
        """Hand a plain key on; everything else goes its way to the program's commands."""
        if trs80_keys(event.key, event.character) is not None:
            event.stop()
            event.prevent_default()
            self.post_message(Typed(event.key, event.character))

    # -- where panels stand -----------------------------------------------------------------------

    def lay_out(self) -> None:
        """Put the panels where the layout has them."""
        self.laid_out_for = self.app.size
        width, height = self._room
        places = layout.plan(self._groups, width, height, self.bottom, self.zoomed, self.leading)
        frames = layout.frames(width, height) if self.zoomed is None else layout.Frames.TITLED
        leading = self.tube if self.leading is Lead.TUBE else self._large_one or self.side
        # Without a corner beside it Textual puts a title on the line itself.
        blank = " " if frames is layout.Frames.TITLED else ""
        for row in self._rows:
            panel, region = self.panels[row.id], places.get(row.id)
            title = f"{blank}{row.title}{blank}" if row.title else ""
            if panel.border_title != title:
                panel.border_title = title
            panel.display = region is not None
            if region is not None:
                panel.styles.offset = (region.x, region.y)
                panel.styles.width, panel.styles.height = region.width, region.height
                # What is yet to be mounted gets its styles then.
                styled = panel.is_attached
                for kind in layout.Frames:
                    with_rule = kind is not layout.Frames.RULED or region.x > 0
                    panel.set_class(frames is kind and with_rule, kind.value, update=styled)
                panel.set_class(panel is leading, "leading", update=styled)
        self._shown = [(row.cadence, self.panels[row.id]) for row in self._rows if row.id in places]
        self._too_small.display = not places
        self._mount_shown()
        if not places:
            self._too_small.update(TOO_SMALL.format(*layout.SMALLEST, width, height))
        self.numbers_due = 0.0

    @property
    def _room(self) -> tuple[int, int]:
        """The size of the terminal without the lines of the tour."""
        width, height = self.app.size
        return width, height - (ROWS if self._guide.display else 0)

    def guide(self, title: str, lines: tuple[str, ...]) -> None:
        """Say what the tour has to say, in two lines above the status line; nothing without any."""
        # In a window that is too small for all the status line stays, and the tour goes.
        shown = bool(lines) and self.app.size.height >= layout.SMALLEST[1] + ROWS
        if (title, lines) != (self._guide.title, self._guide.lines):
            self._guide.say(title, lines)
        if shown != self._guide.display:
            self._guide.display = shown
            self.lay_out()

    @property
    def leading(self) -> Lead:
        """What has most of the room: what was chosen, else the arm while it moves."""
        return self._chosen_lead or self._moving_lead

    @property
    def _large_one(self) -> Widget | None:
        """What is switched in, where it is to have the arm's room."""
        wants = self.bottom in layout.LARGE_ONES and layout.shared(*self._room)
        return self.panels[self._groups[self.bottom][0]] if wants else None

    def choose_lead(self) -> Lead | None:
        """The other one leads from now on, and after that whichever has something to show.

        Returns:
            What leads from now on; None if it follows what happens.
        """
        if self._chosen_lead is None:
            self._chosen_lead = Lead.TUBE if self.leading is Lead.ARM else Lead.ARM
        else:
            self._chosen_lead = None
        self.lay_out()
        return self._chosen_lead

    def _follow(self, readings: Readings, now: float) -> None:
        """The arm leads while it moves, and what else wants its room while it is switched in.

        Not so when the tube has more to show than its last lines.
        """
        if readings.waiting is Waiting.SET or readings.coils != self._coils:
            self._moved_at = now
        self._coils = readings.coils
        if self.tube.wrote_elsewhere:
            self._wrote_at = now
        tube = self.tube.graphics or now < self._wrote_at + STAY
        shows = now < self._moved_at + STAY or self._large_one is not None
        lead = Lead.ARM if shows and not tube else Lead.TUBE
        if lead is not self._moving_lead:
            self._moving_lead = lead
            self.lay_out()

    def _bottoms(self) -> list[str]:
        return layout.bottoms(self._groups, *self._room)

    def next_bottom(self) -> None:
        """Show the next group of panels under the tube."""
        choices = self._bottoms()
        if self.zoomed is not None or self.bottom not in choices:
            self._show_bottom(choices[0])
        else:
            self._show_bottom(choices[(choices.index(self.bottom) + 1) % len(choices)])

    def show_bottom(self, group: str) -> None:
        """Show a group of panels under the tube; asked for again, the first one.

        One that has a place of its own is shown there, or on all of the screen if it is seen.
        """
        choices = self._bottoms()
        if group not in choices:
            comes_back = self.zoomed is None and not self._sees(group)
            if comes_back:
                self._show_bottom(choices[0])
            if not comes_back or not self._sees(group):
                self.zoom(group)
        elif group == self.bottom and self.zoomed is None:
            self._show_bottom(choices[0])
        else:
            self._show_bottom(group)

    def _sees(self, group: str) -> bool:
        return any(self.panels[name].display for name in self._groups.get(group, ()))

    def _show_bottom(self, group: str) -> None:
        self.bottom = group
        self.zoomed = None
        self.lay_out()

    def scroll_page(self, pages: int) -> None:
        """Look further down, or up, in the panels that are switched in, or in the paper."""
        group = self.zoomed or self.bottom
        shown = [
            panel
            for name in self._groups.get(group, (group,))
            if isinstance(panel := self.panels.get(name), Inspector) and panel.display
        ]
        for panel in shown or [each for each in self._inspectors if each.id == layout.PAPER]:
            panel.scroll(pages * max(1, panel.size.height - 1))

    def zoom(self, name: str) -> None:
        """One panel or group on all of the screen; asked for again, or by the arm, back."""
        back = self.zoomed is not None and name in (self.zoomed, layout.ARM)
        self.zoomed = None if back else name
        self.lay_out()

    # -- how they are drawn -----------------------------------------------------------------------

    @property
    def glyph_set(self) -> GlyphSet:
        """The set that graphics are drawn with."""
        return self.tube.glyph_set

    def use_glyphs(self, chosen: GlyphSet) -> None:
        """Draw graphics with another set; ASCII goes for everything."""
        self.tube.glyph_set = chosen
        for panel in self.panels.values():
            if hasattr(panel, "ascii"):
                panel.ascii = chosen is GlyphSet.ASCII

    def use_pixels(self, pixels: PixelScreen | str) -> None:
        """The terminal shows pixels, and this is how; or why it does not, in a line."""
        self.no_pixels = pixels if isinstance(pixels, str) else ""
        for view in self._arm_views:
            view.pixels = None if isinstance(pixels, str) else pixels

    def use_arm_style(self, style: ArmStyle) -> None:
        """Draw the arm in another style."""
        self.arm_style = style
        for view in self._arm_views:
            view.picture.style = style
            view.redraw()

    def toggle_arm_option(self, name: str) -> bool:
        """Turn `envelope`, `trail` or `labels` on or off; whether it is on now."""
        shown = not getattr(self.side.picture, name)
        for view in self._arm_views:
            setattr(view.picture, name, shown)
            view.redraw()
        return shown

    def clear_trail(self) -> None:
        """Forget where the fingertip has been."""
        for view in self._arm_views:
            view.picture.clear_trail()
            view.redraw()

    def turn_space(self, round_it: float, above: float) -> None:
        """Look at the arm in space from elsewhere, by so many degrees round it and up."""
        self._bring(SpaceView)
        for view in self._arm_views:
            view.picture.turn(radians(round_it), radians(above))
            view.redraw()

    def _bring(self, kind: type[Widget]) -> None:
        """Show a panel of a kind that is to be worked with, if none is seen."""
        rows = [row for row in self._rows if isinstance(self.panels[row.id], kind)]
        if rows and not any(self.panels[row.id].display for row in rows):
            self.show_bottom(rows[0].group)

    def scroll_scope(self, columns: int) -> None:
        """Go back in time in the scope, or on, by so many columns."""
        self._bring(ScopePanel)
        for scope in self._scopes:
            scope.scroll(columns)

    def zoom_scope(self, way: int) -> None:
        """More (1) or less (-1) detail in the scope."""
        self._bring(ScopePanel)
        for scope in self._scopes:
            scope.scope.zoom(way)
            scope.redraw()

    def next_joint(self, way: int) -> None:
        """All latches in the scope, or one joint after the other."""
        self._bring(ScopePanel)
        for scope in self._scopes:
            scope.scope.next_joint(way)
            scope.redraw()

    def zoom_arm(self, way: str) -> None:
        """Closer (`in`), farther (`out`), or all of it (`fit`)."""
        for view in self._arm_views:
            getattr(view.picture, f"zoom_{way}")()
            view.redraw()

    # -- drawing ----------------------------------------------------------------------------------

    def show(
        self, rig: Rig, now: float, pace: Pace, *, keys: str, notice: str, line: str = ""
    ) -> None:
        """Draw what differs from what is shown, and write all of it at once.

        Args:
            rig: what there is to see.
            now: the wall's time in seconds.
            pace: how fast the rig runs.
            keys: how keys are read.
            notice: what is to be said now, or nothing.
            line: what goes on at the keyboard or the arm's serial line, or nothing.
        """
        with self.frame():
            self._show(rig, now, pace, keys, notice, line)

    def _show(self, rig: Rig, now: float, pace: Pace, keys: str, notice: str, line: str) -> None:
        cursor = rig.cursor
        blinks = self.cursor_style is CursorStyle.BLINK
        hidden = blinks and int(now / BLINK_SECONDS) % 2 == 1
        self.tube.show(rig.video, cursor, cursor_hidden=hidden)
        if cursor is not None and self.tube.display:
            self._point_terminal_at(cursor)
        readings = Readings.of(rig, self.history, loads=self._loads)
        stands = (readings.posture, readings.things, readings.coils, len(readings.events))
        self.still, self._stood = stands == self._stood, stands
        self._follow(readings, now)
        numbers = now >= self.numbers_due
        if numbers:
            self._loads = rig.loads
            readings = replace(readings, loads=self._loads)
            self.numbers_due = now + NUMBERS_EVERY
            self._inspect(rig)
        # The last of a motion is not to be missed.
        pictures = self.still or now >= self._pictures_due
        if pictures:
            self._pictures_due = now + max(PICTURES_EVERY, self._pixels_took / PIXELS_SHARE)
        due = {Cadence.FRAME: True, Cadence.PICTURE: pictures, Cadence.NUMBERS: numbers}
        began = time.thread_time()
        for cadence, panel in self._shown:
            if due[cadence] and not isinstance(panel, Tube):
                panel.show(readings)
        if pictures:
            took = time.thread_time() - began
            self._pixels_took = took if self.arm_style is ArmStyle.PIXELS else 0.0
        if numbers:
            tape = Deck.of(rig).progress if rig.tape.running else ""
            self.status.show(readings, pace, keys=keys, notice=notice, goes_on=tape or line)
            self._guide.styles.margin = (0, 0, 1 + self.status.needed, 0)

    def _inspect(self, rig: Rig) -> None:
        """Look into the machine for the panels that show its memory, if any is seen."""
        seen = [panel for panel in self._inspectors if panel.display]
        if seen:
            inspection = Inspection.of(rig)
            for panel in seen:
                panel.inspect(inspection)

    def entitle(self, program: str, bench: str) -> None:
        """Say on the frames which program is in memory, and which bench stands there."""
        if (program, bench) == self._titles:
            return
        self._titles = program, bench
        self.tube.border_subtitle = escape(shown(program))
        for view in self._arm_views:
            if isinstance(view, TopView):
                view.border_subtitle = escape(shown(bench))

    def _point_terminal_at(self, cell: int) -> None:
        """Let the terminal's own cursor follow, for braille displays and input methods."""
        tube = self.tube
        column = cell % COLUMNS - tube.first_column
        row = cell // COLUMNS - tube.first_row
        place = tube.content_region.offset + Offset(column, row)
        if self.app.cursor_position != place:
            self.app.cursor_position = place
