"""The frame of the terminal program: panels in their places, keys on their way, time passing.

It owns the session, the pacer and the keyboard; the commands are mixed in from the `*_commands`
modules. Once a tick the machine gets its time, and at most `fps` times a second what differs is
drawn.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from datetime import datetime
from pathlib import Path

from textual import events
from textual.app import App, ComposeResult
from textual.command import CommandPalette
from textual.driver import Driver
from textual.geometry import Offset
from textual.screen import Screen
from textual.widget import Widget
from textual.widgets import Static

from trs80arm.desk.pacing import TICK, Pacer
from trs80arm.desk.places import RecentFiles
from trs80arm.desk.session import Session
from trs80arm.desk.teach import Lesson
from trs80arm.drawing.glyphs import choose
from trs80arm.drawing.readings import Readings
from trs80arm.options import ArmStyle, CursorStyle, GlyphSet, TerminalOptions
from trs80arm.ui import layout
from trs80arm.ui.keys.held_keys import HeldKeys
from trs80arm.ui.keys.keyboard import Keyboard
from trs80arm.ui.layout import Bottom
from trs80arm.ui.panels.coils import CoilsPanel
from trs80arm.ui.panels.command_bar import CommandBar
from trs80arm.ui.panels.events import EventsLog
from trs80arm.ui.panels.matrix import KeyHeld, KeyLatched, KeysLetGo, MatrixView
from trs80arm.ui.panels.pose import PosePanel
from trs80arm.ui.panels.registers import RegistersPanel
from trs80arm.ui.panels.side_view import SideView
from trs80arm.ui.panels.status import Pace, StatusLine
from trs80arm.ui.panels.top_view import TopView
from trs80arm.ui.panels.tube import Tube, Typed
from trs80arm.ui.terminal.driver import choose_driver
from trs80arm.ui.terminal.messages import KeyReport, KeyWentDown, KeyWentUp
from trs80arm.ui.themes import THEMES

BLINK_SECONDS = 0.5
NUMBERS_EVERY = 0.1
"""Seconds of the wall between two looks of the panels with numbers."""
NOTICE_SECONDS = 6.0
"""How long a notice stands in the status line."""
TITLES = {
    "tube": "TRS-80",
    "side": "Arm from the side",
    "top": "From above",
    "registers": "Registers",
    "pose": "Pose",
    "coils": "Motors",
    "events": "Log",
    "matrix": "Keyboard",
}
TOO_SMALL = (
    "trs80arm needs {0} columns and {1} rows.\nThis terminal has {2} and {3}.\nCtrl+Q leaves."
)


class DeskScreen(Screen[None]):
    """The screen of the desk. When the keyboard goes elsewhere, all hands leave the TRS-80."""

    def on_screen_suspend(self) -> None:
        """A dialog opened."""
        self._let_go()

    def on_descendant_blur(self) -> None:
        """The tube lost the keyboard."""
        self._let_go()

    def _let_go(self) -> None:
        if isinstance(self.app, Desk):
            self.app.keyboard.let_go()


class Desk(App[int]):
    """The program without its commands.

    Args:
        session: the machine and what belongs to it.
        options: how to start.
        state: the folder for recent files and recovery copies.
        wall: the wall's clock in seconds.
        ticking: whether time passes by itself; a test calls `tick` and `draw` instead.
    """

    TITLE = "trs80arm"
    CSS_PATH = "app.tcss"
    ENABLE_COMMAND_PALETTE = True
    NOTIFICATION_TIMEOUT = 4

    def __init__(
        self,
        session: Session,
        options: TerminalOptions,
        state: Path,
        *,
        wall: Callable[[], float] = time.monotonic,
        ticking: bool = True,
    ) -> None:
        # The driver is chosen while Textual's own constructor runs.
        self.options = options
        self.session = session
        self.wall = wall
        super().__init__()
        self._ticking = ticking
        self.pacer = Pacer(session, wall, options.speed.factor)
        self.keyboard = self._new_keyboard()
        self.lesson = Lesson()
        self.recent = RecentFiles(state / "recent.json")
        self.copy_path = state / f"recovered-{datetime.now():%Y%m%d-%H%M%S}-{os.getpid()}.bas"
        self.bottom = Bottom.ARM
        self.zoomed: str | None = None
        self.cursor_style = options.cursor
        self.arm_style = options.arm
        self._remembered_theme = options.theme
        self._notice = ""
        self._notice_until = 0.0
        self._next_frame = 0.0
        self._next_numbers = 0.0
        for theme in THEMES:
            self.register_theme(theme)
        known = options.theme in self.available_themes
        self.theme = options.theme if known else THEMES[0].name

    def action_command_palette(self) -> None:
        """Open the palette, unless it is open already, perhaps below a dialog."""
        if not any(isinstance(screen, CommandPalette) for screen in self.screen_stack):
            super().action_command_palette()

    def get_theme_variable_defaults(self) -> dict[str, str]:
        """The tube's colours in themes that know no tube: those of any text."""
        colours = self.current_theme.to_color_system().generate()
        return {"tube": colours["foreground"], "tube-background": colours["background"]}

    def _new_keyboard(self) -> Keyboard:
        options = self.options
        return Keyboard(
            self.session.rig,
            HeldKeys(options.tap_ms / 1000, options.repeat_ms / 1000),
            options.keys,
            self.wall,
            self.session.rig.settings.driver.keys.leave,
        )

    def another_machine(self) -> None:
        """The session has another rig on the desk."""
        reports = self.keyboard.reports_releases
        self.keyboard = self._new_keyboard()
        self.keyboard.reports_releases = reports
        self.pacer.forgive()
        self.arrange()

    def get_default_screen(self) -> Screen[None]:
        """The desk."""
        return DeskScreen(id="desk")

    def get_driver_class(self) -> type[Driver]:
        """The driver that reports key releases, where the stock one would be Linux's."""
        return choose_driver(super().get_driver_class(), self.options.keys)

    # -- the panels -------------------------------------------------------------------------------

    def compose(self) -> ComposeResult:
        """All panels; where they stand is decided by `arrange`."""
        yield Static(id="too-small")
        yield Tube(id="tube")
        yield SideView(id="side")
        yield TopView(id="top")
        yield RegistersPanel(id="registers")
        yield PosePanel(id="pose")
        yield CoilsPanel(id="coils")
        yield EventsLog(id="events")
        yield MatrixView(self.session.rig.settings.driver.keys, id="matrix")
        yield StatusLine(id="status")
        yield CommandBar(id="commands")

    def on_mount(self) -> None:
        """Set everything up, and let time begin."""
        self.tube = self.screen.query_one(Tube)
        self.side = self.screen.query_one(SideView)
        self.top = self.screen.query_one(TopView)
        self.registers = self.screen.query_one(RegistersPanel)
        self.pose_panel = self.screen.query_one(PosePanel)
        self.coils = self.screen.query_one(CoilsPanel)
        self.log_panel = self.screen.query_one(EventsLog)
        self.matrix = self.screen.query_one(MatrixView)
        self.status = self.screen.query_one(StatusLine)
        self.desk_screen = self.screen
        for name, title in TITLES.items():
            self.screen.query_one(f"#{name}", Widget).border_title = title
        self.use_glyphs(choose(self.options.glyphs))
        self.use_arm_style(self.arm_style)
        self.tube.focus()
        self.arrange()
        self.pacer.forgive()
        self.app_suspend_signal.subscribe(self, self._suspended)
        self.app_resume_signal.subscribe(self, self._resumed)
        if self._ticking:
            self.set_interval(TICK, self.tick)

    def _suspended(self, _: App[int]) -> None:
        """To the shell: all hands off."""
        self.keyboard.let_go()

    def _resumed(self, _: App[int]) -> None:
        """Back from the shell: the time between was nobody's, and the screen is empty."""
        self.pacer.forgive()
        for screen in self.screen_stack:
            screen.refresh(layout=True)
            for widget in screen.walk_children(Widget):
                widget.refresh()

    def use_glyphs(self, chosen: GlyphSet) -> None:
        """Draw graphics with another set; ASCII goes for everything."""
        self.tube.glyph_set = chosen
        plain = chosen is GlyphSet.ASCII
        self.matrix.ascii = plain
        self.coils.ascii = plain
        self.matrix.refresh()

    def use_arm_style(self, style: ArmStyle) -> None:
        """Draw the arm in ASCII or in braille."""
        self.arm_style = style
        self.side.braille = self.top.braille = style is ArmStyle.BRAILLE

    def on_resize(self, event: events.Resize) -> None:
        """Find every panel its place in the new size."""
        self.call_after_refresh(self.arrange)

    def arrange(self) -> None:
        """Put the panels where the layout has them."""
        width, height = self.size
        places = layout.plan(width, height, self.bottom, self.zoomed)
        framed = layout.shows_everything(width, height) and self.zoomed is None
        for name in TITLES:
            panel = self.desk_screen.query_one(f"#{name}", Widget)
            region = places.get(name)
            panel.display = region is not None
            if region is not None:
                panel.styles.offset = (region.x, region.y)
                panel.styles.width, panel.styles.height = region.width, region.height
                panel.set_class(framed or self.zoomed is not None, "titled")
        self.tube.set_class(framed, "framed")
        message = self.desk_screen.query_one("#too-small", Static)
        message.display = not places
        message.update(TOO_SMALL.format(*layout.SMALLEST, width, height))
        self._next_frame = self._next_numbers = 0.0

    # -- time -------------------------------------------------------------------------------------

    def tick(self) -> None:
        """Give the machine its time, and draw when it is time to."""
        self.keyboard.feed()
        self.pacer.advance()
        now = self.wall()
        if now >= self._next_frame:
            self._next_frame = now + 1 / self.options.fps - TICK / 2
            self.draw(now)

    def draw(self, now: float | None = None) -> None:
        """Draw what differs from what is shown."""
        now = self.wall() if now is None else now
        rig = self.session.rig
        cursor = rig.cursor
        hidden = self.cursor_style is CursorStyle.BLINK and int(now / BLINK_SECONDS) % 2 == 1
        self.tube.show(rig.video, cursor, cursor_hidden=hidden)
        if cursor is not None and self.focused is self.tube:
            self._point_terminal_at(cursor)
        self.matrix.show(rig.held)
        readings = Readings.of(rig)
        for view in (self.side, self.top):
            if view.display:
                view.show(readings)
        if now >= self._next_numbers:
            self._next_numbers = now + NUMBERS_EVERY
            for panel in (self.registers, self.pose_panel, self.coils, self.log_panel):
                if panel.display:
                    panel.show(readings)
            pacer = self.pacer
            self.status.show(
                readings,
                Pace(pacer.speed, pacer.achieved, pacer.paused),
                keys=self.keyboard.in_use.value,
                notice=self._notice if now < self._notice_until else "",
            )

    def _point_terminal_at(self, cell: int) -> None:
        """Let the terminal's own cursor follow, for braille displays and input methods."""
        place = self.tube.content_region.offset + Offset(cell % 64, cell // 64)
        if self.cursor_position != place:
            self.cursor_position = place

    def look(self) -> Readings:
        """What there is to see of arm and machine now."""
        return Readings.of(self.session.rig)

    def say(self, text: str, *, error: bool = False) -> None:
        """Tell the user something: in the status line, and an error in a box as well."""
        self._notice = text
        self._notice_until = self.wall() + NOTICE_SECONDS
        self._next_numbers = 0.0
        if error:
            self.notify(text, severity="error")

    # -- keys -------------------------------------------------------------------------------------

    @property
    def at_the_keyboard(self) -> bool:
        """Whether plain keys go to the TRS-80."""
        return self.screen is self.desk_screen and self.focused is self.tube

    def on_key_went_down(self, message: KeyWentDown) -> None:
        """A key of a terminal that tells presses from releases."""
        if self.at_the_keyboard and not self.operator_came():
            self._mind_the_pause(message.name)
            self.keyboard.went_down(message.base, message.name, message.text)
            self.pacer.advance()

    def on_key_went_up(self, message: KeyWentUp) -> None:
        """The same let go."""
        self.keyboard.went_up(message.base)

    def on_key_report(self, message: KeyReport) -> None:
        """The terminal told whether it reports releases."""
        self.keyboard.told(message.releases)

    def on_typed(self, message: Typed) -> None:
        """A key of a terminal that does not."""
        if not self.keyboard.reports_releases and self.operator_came():
            return
        self._mind_the_pause(message.name)
        self.keyboard.typed(message.name, message.text)
        # The machine sees the key now, not at the next tick.
        self.pacer.advance()

    def _mind_the_pause(self, name: str) -> None:
        """A key in a pause waits for its end, but BREAK ends it."""
        if not self.pacer.paused:
            return
        if name == "escape":
            self.pacer.pause(False)
            self.say("Going on.")
        else:
            self.say("Paused: keys wait until F6.")

    def operator_came(self) -> bool:
        """Whether a key only ended something that was playing; the commands say what plays."""
        return False

    def on_key_held(self, message: KeyHeld) -> None:
        """The mouse holds a key."""
        self.keyboard.held.point(message.key)
        self.keyboard.feed()

    def on_keys_let_go(self, message: KeysLetGo) -> None:
        """The mouse lets go."""
        self.keyboard.held.unpoint()
        self.keyboard.feed()

    def on_key_latched(self, message: KeyLatched) -> None:
        """The mouse latches a key."""
        self.keyboard.held.latch((message.key,))
        self.keyboard.feed()

    def on_paste(self, event: events.Paste) -> None:
        """A paste is typed in, line by line, at the machine's pace."""
        if self.at_the_keyboard:
            event.stop()
            self.type_in(event.text)

    def type_in(self, text: str) -> None:
        """Type a text at the machine's pace; BREAK ends it."""
        self.session.rig.type(text.replace("\r\n", "\r").replace("\n", "\r"))
        self.say("Typing; Escape ends it.")

    def on_app_blur(self, event: events.AppBlur) -> None:
        """The window lost the focus: a release would be lost, so take all hands off."""
        self.keyboard.let_go()
