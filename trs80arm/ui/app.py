"""The application: a sitting at the desk on the screen, keys on their way, time passing.

It puts together what the other rooms have: the session with its files, the pacer, the keyboard, the
screen of the desk, and the groups of commands. Once a tick the machine gets its time, and at most
`fps` times a second what differs is drawn. It is made with everything that it needs, so that a test
can give it a session and a clock of its own.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import re
import signal
import sys
import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from textual import events
from textual.app import App
from textual.command import CommandPalette
from textual.driver import Driver
from textual.filter import LineFilter
from textual.screen import Screen

from trs80arm.desk.base_pendant import BasePendant
from trs80arm.desk.debugger import Debugger
from trs80arm.desk.files import PLAYING, SessionFiles
from trs80arm.desk.leaving import Leaving
from trs80arm.desk.pacing import TICK, Pacer
from trs80arm.desk.pendant import Pendant
from trs80arm.desk.peripherals import Peripherals
from trs80arm.desk.places import STATES, RecentFiles, sitting_name
from trs80arm.desk.plugged import Plugged
from trs80arm.desk.proof import Proof
from trs80arm.desk.reach import Reach
from trs80arm.desk.recovery import Recovery
from trs80arm.desk.remembered import Remembered
from trs80arm.desk.served import Served
from trs80arm.desk.session import Session
from trs80arm.desk.sound import LineSound
from trs80arm.desk.stage import Stage
from trs80arm.desk.states import States
from trs80arm.desk.teach import Lesson
from trs80arm.desk.tour import FILE as TOUR_FILE
from trs80arm.desk.tour import Tour
from trs80arm.drawing.glyphs import choose
from trs80arm.options import ArmStyle, TerminalOptions
from trs80arm.serial.endpoints import Port
from trs80arm.shown import shown
from trs80arm.trace.history import History
from trs80arm.ui.asking import Dialogs
from trs80arm.ui.commands.arm import ArmCommands
from trs80arm.ui.commands.bar import CommandBar
from trs80arm.ui.commands.comfort import ComfortCommands
from trs80arm.ui.commands.command import Commands
from trs80arm.ui.commands.debug import DebugCommands
from trs80arm.ui.commands.keys import KeyCommands
from trs80arm.ui.commands.machine import MachineCommands
from trs80arm.ui.commands.palette import Palette
from trs80arm.ui.commands.program import ProgramCommands
from trs80arm.ui.commands.table import COMMANDS, bindings, command, listed
from trs80arm.ui.commands.tube import TubeCommands
from trs80arm.ui.commands.view import ViewCommands
from trs80arm.ui.heartbeat import STEADY, Heartbeat
from trs80arm.ui.help_topics import Topic, topics
from trs80arm.ui.keys.held_keys import HeldKeys
from trs80arm.ui.keys.jog_keyboard import JogKeyboard
from trs80arm.ui.keys.keyboard import Keyboard
from trs80arm.ui.panels.inspector import Asked
from trs80arm.ui.panels.keys_by_mouse import KeyHeld, KeyLatched, KeysLetGo
from trs80arm.ui.panels.registry import PANELS, PanelRow
from trs80arm.ui.panels.status import Pace, typing_text
from trs80arm.ui.screens.desk import DeskScreen, Typed
from trs80arm.ui.screens.dialog import Dialog
from trs80arm.ui.screens.palette import PaletteScreen
from trs80arm.ui.terminal.driver import choose_driver
from trs80arm.ui.terminal.messages import KeyReport, KeyWentDown, KeyWentUp, TerminalWent
from trs80arm.ui.terminal.no_codes import NoControlCodes
from trs80arm.ui.themes import THEMES, Themed

if TYPE_CHECKING:
    from trs80arm.serial.courier import Courier

OFFER = (
    "`Ctrl+N` begins a tour of five minutes: drive, pick, run, teach.",
    "Or just type: later Ctrl+N, or `trs80arm tour`, begins it as well.",
)
BROWSERS_OWN = re.compile(r"Ctrl\+([NT])\b")
"""Keys that a browser keeps to itself: there it is Alt with the same letter."""
MARK_EVERY = 1.0
"""Seconds of the wall between two snapshots to which the debugger can go back, at least."""
MARKS_SHARE = 0.005
"""The share of the processor's time that these may take: else they are fewer."""
COPY_EVERY = 5.0
"""Seconds of the wall between two looks at whether a recovery copy is due."""
BEHIND_FPS = 5
"""The most frames a second while a dialog is open."""
FAR_AHEAD = 20
"""Keys that wait for the ROM before it is said that they do."""
NOTICE_SECONDS = 6.0
"""How long a notice stands in the status line."""
SIGNALLED = 128
"""With the number of the signal added: the exit code of a program that was told to end."""
GRACE = 2.0
"""Seconds in which a program that was told to end gives the terminal back."""
ENDING = [
    signal.Signals[name]
    for name in ("SIGTERM", "SIGHUP", "SIGINT")
    if name in signal.Signals.__members__
]
"""Told to end, or the terminal was closed: the program goes, but what is unsaved is kept."""


class Trs80Arm(Themed[int]):
    """A TRS-80 and a MiniMover 5 in the terminal.

    Args:
        session: the machine and what belongs to it.
        options: how to start.
        state: the folder for recent files and recovery copies.
        wall: the wall's clock in seconds.
        ticking: whether time passes by itself; a test calls `tick` and `draw` instead.
        panels: what there is to be seen.
        courier: takes orders to the real arm that is plugged in, if one is.
        port: where programs are that drive the arm over its serial line, if it is open.

    Attributes:
        desk: the screen of the desk.
        commands: the groups of commands.
    """

    TITLE = "trs80arm"
    CSS_PATH = "app.tcss"
    ENABLE_COMMAND_PALETTE = True
    NOTIFICATION_TIMEOUT = 4
    BINDINGS = bindings()
    COMMANDS = {Palette}  # noqa: RUF012

    def __init__(
        self,
        session: Session,
        options: TerminalOptions,
        state: Path,
        *,
        wall: Callable[[], float] = time.monotonic,
        ticking: bool = True,
        panels: Sequence[PanelRow] = PANELS,
        courier: Courier | None = None,
        port: Port | None = None,
    ) -> None:
        # The driver is chosen while Textual's own constructor runs.
        self.options = options
        self.session = session
        self.wall = wall
        self._no_codes = NoControlCodes()
        self.fault: BaseException | None = None
        super().__init__()
        self._ticking = ticking
        self._notice = ""
        self._notice_until = 0.0
        self._next_frame = 0.0
        self._next_mark = 0.0
        self._remembered_theme = options.theme
        self._trying_themes = False
        self.pacer = Pacer(session, wall, options.speed.factor, lambda: session.hurried)
        self.pacer.hurries = options.turbo
        self._in_browser = bool(os.environ.get("TEXTUAL_DRIVER"))
        self.sound = LineSound(session, self.bell, self.say, options.sound, far=self._in_browser)
        self.heartbeat = Heartbeat(self.tick, lambda: self.busy, lambda: self.hurried, wall)
        held = HeldKeys(options.tap_ms / 1000, options.repeat_ms / 1000)
        self.keyboard = Keyboard(session, held, options.keys, wall)
        self.lesson = Lesson()
        self.pendant = Pendant(session, self.lesson)
        self.jog_keyboard = JogKeyboard(
            session,
            self.pendant,
            HeldKeys(options.tap_ms / 1000, options.repeat_ms / 1000),
            self.keyboard,
            wall,
        )
        self.base_pendant = BasePendant(session)
        self.base_keyboard = JogKeyboard(
            session,
            self.base_pendant,
            HeldKeys(options.tap_ms / 1000, options.repeat_ms / 1000),
            self.keyboard,
            wall,
        )
        bar = CommandBar(COMMANDS, id="commands")
        self.desk = DeskScreen(panels, bar, self.keyboard.let_go)
        self.desk.history = History(session.rig)
        self.recovery = Recovery(session, self.lesson, state, sitting_name(), self.say)
        self.remembered = Remembered(options.settings_file, self.say)
        self.stage = Stage(session, self.say)
        self.debugger = Debugger(session)
        self.states = States(state / STATES)
        asking = Dialogs(self, Reach(options.own_folder))
        self.plugged = Plugged(session, courier, options.plug, asking, self.say)
        self.served = Served(session, port, asking, self.say)
        self.commands = self._groups(state)
        session.watch_machine(self.keyboard.start_afresh)
        for theme in THEMES:
            self.register_theme(theme)
        known = options.theme in self.available_themes
        self.theme = options.theme if known else THEMES[0].name

    def _groups(self, state: Path) -> Commands:
        """The groups of commands, each with what it needs."""
        session, lesson, keyboard, desk = self.session, self.lesson, self.keyboard, self.desk
        reach = Reach(self.options.own_folder)
        dialogs, say = Dialogs(self, reach), self.say
        recent = RecentFiles(state / "recent.json")
        files = SessionFiles(session, self.recovery, recent, dialogs, say, reach)
        self.tour = Tour(session, lesson, files, state / TOUR_FILE, dialogs, say)
        debugger, pacer = self.debugger, self.pacer
        machine = MachineCommands(
            session, debugger, pacer, keyboard, files, self.stage, dialogs, say
        )
        arm = ArmCommands(
            session,
            self.pendant,
            self.jog_keyboard,
            self.base_pendant,
            self.base_keyboard,
            machine,
            files,
            dialogs,
            say,
            dialogs,
            lambda: desk.arm_style,
        )
        leaving = Leaving(
            session, lesson, self.recovery, files, dialogs, arm.teach, lambda: self.exit(0)
        )
        debug = DebugCommands(
            session, debugger, self.states, pacer, dialogs, say, lambda: self.at_the_keyboard
        )
        return Commands(
            files=files,
            proof=Proof(session, dialogs, say),
            machine=machine,
            debug=debug,
            arm=arm,
            view=ViewCommands(desk, self.remembered, dialogs, say),
            tube=TubeCommands(self, files, say),
            keys=KeyCommands(keyboard, self.options.keys, say, dialogs),
            peripherals=Peripherals(session, dialogs, say),
            tour=self.tour,
            served=self.served,
            comfort=ComfortCommands(self.pacer, self.sound, self.remembered, dialogs, say),
            program=ProgramCommands(
                session,
                self.pacer,
                self.sound,
                keyboard,
                desk,
                self.options,
                leaving,
                machine,
                self.stage,
                self,
                dialogs,
                dialogs,
                self._topics,
            ),
        )

    def _topics(self) -> list[Topic]:
        """What the help has words on, for the keys as they work now."""
        from trs80arm.ui.screens.debugger import DebuggerScreen

        panels = (*self.desk.panels.values(), self.desk.status, DebuggerScreen)
        return topics(self.keyboard.in_use, listed(), [panel.HELP for panel in panels])

    def action_do(self, name: str) -> None:
        """Do the command of that name."""
        self.heartbeat.wake()
        command(name).do(self.commands)

    def action_command_palette(self) -> None:
        """Open the palette, unless it is open already, perhaps below a dialog."""
        if not any(isinstance(screen, CommandPalette) for screen in self.screen_stack):
            self.push_screen(PaletteScreen(id="--command-palette"))

    # -- what Textual asks ------------------------------------------------------------------------

    def get_default_screen(self) -> Screen[None]:
        """The desk."""
        return self.desk

    def get_driver_class(self) -> type[Driver]:
        """The driver that reports key releases, where the stock one would be Linux's."""
        return choose_driver(super().get_driver_class(), self.options.keys)

    @property
    def theme_names(self) -> Sequence[str]:
        """The themes that there are, the own ones first."""
        own = [theme.name for theme in THEMES]
        return [*own, *sorted(set(self.available_themes) - set(own))]

    def show_theme(self, name: str) -> None:
        """Show a theme for now."""
        self._trying_themes = True
        self.theme = name
        self._trying_themes = False

    def use_theme(self, name: str) -> None:
        """Show a theme from now on, and remember it."""
        self.theme = name
        self._remember_theme(name)

    def watch_theme(self, name: str) -> None:
        """A theme was chosen, perhaps in Textual's own list: remember it."""
        if self.is_running and not self._trying_themes:
            self._remember_theme(name)

    def _remember_theme(self, name: str) -> None:
        if name != self._remembered_theme:
            self._remembered_theme = name
            self.remembered.choose("theme", name)

    # -- beginning and end ------------------------------------------------------------------------

    def on_mount(self) -> None:
        """Set everything up, and let time begin."""
        self.desk.use_glyphs(choose(self.options.glyphs))
        self._use_first_arm_style(self.options.arm)
        self.desk.cursor_style = self.options.cursor
        self.desk.lay_out()
        self.pacer.forgive()
        self.app_suspend_signal.subscribe(self, self._suspended)
        self.app_resume_signal.subscribe(self, self._resumed)
        if self._ticking:
            self.heartbeat.begin(self)
            self.set_interval(COPY_EVERY, self.recovery.keep)
            self.set_interval(MARK_EVERY, self._mark)

    def _use_first_arm_style(self, style: ArmStyle) -> None:
        """Draw the arm as the options want it, if the terminal can."""
        if style is ArmStyle.PIXELS and self.desk.no_pixels:
            self.say(self.desk.no_pixels)
            style = ArmStyle.HALF
        self.desk.use_arm_style(style)

    def on_ready(self) -> None:
        """Say what was loaded, run it, or play, as the options want."""
        if self._ticking:
            for number in ENDING:
                # Windows has no such handlers.
                with contextlib.suppress(NotImplementedError):
                    asyncio.get_running_loop().add_signal_handler(number, self._told_to_end, number)
        if self.recovery.left_over():
            self.say("A program of a session that ended badly is kept: see F2.")
        rom = self.session.rig.settings.rom
        if rom is not None:
            self.say(rom.told)
        if self.options.tour:
            self.tour.begin()
        elif self.session.greeted:
            self.tour.offer()
        self.plugged.begin()
        self.served.begin()
        # The panels know their sizes and nothing has been drawn: the first frame is to show it all.
        self.draw()
        if self.options.demo:
            self.commands.machine.demo()
        elif self.session.playing:
            self.say(PLAYING)
        elif self.session.system_name is not None:
            self.commands.files.tell_of_machine_code(self.session.system_name)
        elif self.session.path is not None:
            self.commands.files.loaded(self.session.path)
            if self.options.run:
                self.commands.machine.run()

    def _told_to_end(self, number: signal.Signals) -> None:
        """A signal: keep what is unsaved, give the terminal back, end."""
        self.recovery.keep()
        self.session.close()
        # Of a terminal that is gone nothing can be given back, and the writes that wait for it
        # would keep the program for ever.
        last = threading.Timer(GRACE, os._exit, (SIGNALLED + number,))
        last.daemon = True
        last.start()
        self.exit(SIGNALLED + number)

    def _suspended(self, _: App[int]) -> None:
        """To the shell: all hands off."""
        self.keyboard.let_go()

    def _resumed(self, _: App[int]) -> None:
        """Back from the shell: the time between was nobody's, and the screen is empty."""
        self.pacer.forgive()
        for screen in self.screen_stack:
            screen.refresh(layout=True)
            for widget in screen.walk_children():
                widget.refresh()

    # -- time and pictures ------------------------------------------------------------------------

    def get_line_filters(self) -> Sequence[LineFilter]:
        """Textual's own, and that nothing of what is drawn is a control code."""
        return [*super().get_line_filters(), self._no_codes]

    def _fatal_error(self) -> None:
        """Textual's hook for what nobody caught: no traceback on the screen, but an end in order.

        What is raised stays in `fault`, for `ui.start` to tell.
        """
        self.fault = sys.exc_info()[1]
        self._close_messages_no_wait()

    @property
    def busy(self) -> bool:
        """Whether anything goes on that nobody has to begin: a program, a motion, held keys."""
        if self.stage.plays:
            return True
        if self.pacer.paused:
            return False
        at_work = self.session.busy or self.pendant.busy or self.plugged.busy or self.served.moves
        return at_work or self._hands_on or not self.desk.still

    @property
    def hurried(self) -> bool:
        """Whether a look at the machine every frame would be too seldom."""
        return self.pacer.behind or self._hands_on or self.options.fps > 1 / STEADY

    @property
    def _hands_on(self) -> bool:
        keyboards = self.keyboard, self.jog_keyboard.keyboard, self.base_keyboard.keyboard
        return any(keyboard.held.busy for keyboard in keyboards)

    def _mark(self) -> None:
        """Keep a snapshot to which the debugger can go back, while the machine works."""
        if self.session.busy and not self.pacer.paused and self.wall() >= self._next_mark:
            began = time.thread_time()
            self.session.timeline.mark()
            self._next_mark = self.wall() + (time.thread_time() - began) / MARKS_SHARE

    async def on_event(self, event: events.Event) -> None:
        """Whatever the terminal sends wakes the program."""
        if isinstance(event, events.InputEvent):
            self.heartbeat.wake()
        await super().on_event(event)

    def tick(self) -> None:
        """Give the machine its time, and draw when it is time to."""
        self.stage.go_on()
        self.tour.go_on()
        self.keyboard.feed()
        self.jog_keyboard.feed()
        self.base_keyboard.feed()
        if not self.pacer.paused:
            self.pendant.go_on()
        self.plugged.go_on()
        self.pacer.advance()
        if not self.pacer.paused and self.served.go_on():
            self.heartbeat.stay_awake()
        self.sound.go_on()
        self.commands.debug.look()
        now = self.wall()
        if now >= self._next_frame:
            fps = min(self.options.fps, BEHIND_FPS) if self.dialog_is_open else self.options.fps
            self._next_frame = now + 1 / fps - TICK / 2
            self._tell()
            self.draw(now)

    def _tell(self) -> None:
        """Say what the user has to know of what happened."""
        for fault in self.session.new_faults():
            self.say(fault, error=True)
        if (score := self.session.new_score()) is not None:
            self.say(f"{score.headline}. Ctrl+P, score: all of them.")
        if (slip := self.session.new_slip()) is not None:
            self.say(f"{slip.text}. Ctrl+R: why, and the way back.")

    def draw(self, now: float | None = None) -> None:
        """Draw what differs from what is shown."""
        now = self.wall() if now is None else now
        pacer = self.pacer
        ahead = self.keyboard.held.waiting
        self._guide()
        if now >= self.desk.numbers_due:
            bench = self.session.bench_path
            self.desk.entitle(self.session.title, f"bench {bench.stem}" if bench else "")
        self.desk.show(
            self.session.rig,
            now,
            Pace(pacer.speed, pacer.achieved, pacer.paused, pacer.turbo),
            keys=self.keyboard.in_use.value,
            notice=self._notice if now < self._notice_until else "",
            line=typing_text(ahead) if ahead > FAR_AHEAD else self.served.text,
        )

    def _guide(self) -> None:
        """What the tour says now, or its offer."""
        tour = self.tour
        if tour.step is not None:
            first, second = tour.step.words
            more = "Ctrl+N: skip, back, leave"
            gap = self.size.width - len(second.replace("`", "")) - len(more) - 1
            self._say_in_guide(tour.place, (first, f"{second}{' ' * max(2, gap)}{more}"))
        elif tour.offered:
            self._say_in_guide("New here?", OFFER)
        else:
            self.desk.guide("", ())

    def _say_in_guide(self, title: str, lines: tuple[str, ...]) -> None:
        if self._in_browser:
            lines = tuple(BROWSERS_OWN.sub(r"Alt+\1", line) for line in lines)
        self.desk.guide(title, lines)

    def on_resize(self, event: events.Resize) -> None:
        """Find every panel its place in the new size."""
        self.call_after_refresh(self._arrange)

    def _arrange(self) -> None:
        if self.desk.laid_out_for != self.size:
            self.desk.lay_out()
        self._next_frame = 0.0
        self.heartbeat.wake()

    @property
    def tube_text(self) -> str:
        """What the tube shows, as sixteen lines."""
        return self.desk.tube.text

    def say(self, text: str, *, error: bool = False) -> None:
        """Tell the user something: in the status line, and an error in a box as well."""
        if not self.is_running:
            return
        text = shown(text)
        if text != self._notice or self.wall() >= self._notice_until:
            self.desk.numbers_due = 0.0
        self._notice = text
        self._notice_until = self.wall() + NOTICE_SECONDS
        self.heartbeat.wake()
        if error:
            self.notify(text, severity="error", markup=False)

    @property
    def dialog_is_open(self) -> bool:
        """Whether something else than the desk is on the screen."""
        return self.screen is not self.desk

    # -- keys -------------------------------------------------------------------------------------

    @property
    def at_the_keyboard(self) -> bool:
        """Whether plain keys go to the TRS-80."""
        return not self.dialog_is_open

    def on_key_went_down(self, message: KeyWentDown) -> None:
        """A key of a terminal that tells presses from releases."""
        self._up_to_now()
        if isinstance(self.screen, Dialog):
            self.screen.went_down(message.base, message.name, message.text)
        if self.at_the_keyboard and not self.stage.operator_came():
            self.tour.decline()
            self._mind_the_pause(message.name)
            self.keyboard.went_down(message.base, message.name, message.text)
            self.pacer.advance()

    def _up_to_now(self) -> None:
        """Let the machine come to the moment at which a key goes down or up."""
        self.heartbeat.wake()
        self.pacer.advance()

    def on_key_went_up(self, message: KeyWentUp) -> None:
        """The same let go."""
        self._up_to_now()
        if isinstance(self.screen, Dialog):
            self.screen.went_up(message.base)
        self.keyboard.went_up(message.base)

    def on_terminal_went(self, _: TerminalWent) -> None:
        """End as if a shell had told so: who is left behind by one is not told."""
        self._told_to_end(signal.SIGHUP)

    def on_key_report(self, message: KeyReport) -> None:
        """The terminal told whether it reports releases."""
        self.keyboard.told(message.releases)
        self.jog_keyboard.take_up()
        self.base_keyboard.take_up()

    def on_typed(self, message: Typed) -> None:
        """A key of a terminal that does not."""
        self._up_to_now()
        if not self.keyboard.reports_releases and self.stage.operator_came():
            return
        self.tour.decline()
        self._mind_the_pause(message.name)
        self.keyboard.typed(message.name, message.text)
        # The machine sees the key now, not at the next tick.
        self.pacer.advance()

    def _mind_the_pause(self, name: str) -> None:
        """A key in a pause waits for its end, but BREAK ends it."""
        if not self.pacer.paused:
            return
        if name == "escape":
            self.commands.machine.go_on()
        else:
            self.say("Paused: keys wait until F6.")

    def on_asked(self, message: Asked) -> None:
        """A panel was clicked that stands for a command."""
        self.action_do(message.command)

    def on_key_held(self, message: KeyHeld) -> None:
        """The mouse holds a key."""
        self.keyboard.point(message.key)

    def on_keys_let_go(self, message: KeysLetGo) -> None:
        """The mouse lets go."""
        self.keyboard.unpoint()

    def on_key_latched(self, message: KeyLatched) -> None:
        """The mouse latches a key."""
        self.keyboard.latch(message.key)

    def on_paste(self, event: events.Paste) -> None:
        """A paste at the desk: a listing is entered at once, anything else typed."""
        if self.at_the_keyboard:
            event.stop()
            self.commands.files.take_paste(event.text)

    def on_app_blur(self, event: events.AppBlur) -> None:
        """The window lost the focus: a release would be lost, so take all hands off."""
        self.jog_keyboard.keyboard.let_go()
        self.base_keyboard.keyboard.let_go()
        self.keyboard.let_go()
