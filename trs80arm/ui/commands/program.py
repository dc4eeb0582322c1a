"""The commands about the program itself: help, settings, theme, to the shell, leaving.

Dialogs are imported when they are opened: the first frame needs none.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from inspect import cleandoc
from typing import Any, Protocol

from trs80arm.desk.asking import Asking, Choice, ListQuestion
from trs80arm.desk.leaving import Leaving
from trs80arm.desk.pacing import Pacer
from trs80arm.desk.session import Session
from trs80arm.desk.settings_book import SettingsBook
from trs80arm.desk.sound import LineSound
from trs80arm.desk.stage import Stage
from trs80arm.drawing.glyphs import choose
from trs80arm.options import ArmStyle, CursorStyle, GlyphSet, KeyMode, Sound, Speed, TerminalOptions
from trs80arm.plain_values import as_table
from trs80arm.rig import Waiting
from trs80arm.ui.asking import Screens
from trs80arm.ui.commands.machine import MachineCommands
from trs80arm.ui.commands.view import View
from trs80arm.ui.help_topics import AFTER_A_SLIP, WHILE_WAITING, Topic, topics_of
from trs80arm.ui.keys.keyboard import Keyboard


class Shell(Protocol):
    """What Textual does for every program."""

    theme: str

    @property
    def dialog_is_open(self) -> bool:
        """Whether something else than the desk is on the screen."""

    @property
    def theme_names(self) -> Sequence[str]:
        """The themes that there are, the own ones first."""

    def show_theme(self, name: str) -> None:
        """Show a theme for now."""

    def use_theme(self, name: str) -> None:
        """Show a theme from now on, and remember it."""

    def action_suspend_process(self) -> None:
        """Go to the shell for a while."""

    def action_command_palette(self) -> None:
        """Open the palette."""


class ProgramCommands:
    """Help, settings, themes, and ways out.

    Args:
        session: the machine.
        pacer: how fast its time goes.
        sound: what is heard of it.
        keyboard: the operator's hands.
        view: what is seen.
        options: how the program was started.
        leaving: asks before it ends.
        machine: presses BREAK.
        stage: what plays by itself.
        shell: what Textual does for every program.
        ask: a way to ask.
        screens: shows the pages.
        topics: of the help, for the keys as they work now.
    """

    def __init__(
        self,
        session: Session,
        pacer: Pacer,
        sound: LineSound,
        keyboard: Keyboard,
        view: View,
        options: TerminalOptions,
        leaving: Leaving,
        machine: MachineCommands,
        stage: Stage,
        shell: Shell,
        ask: Asking,
        screens: Screens,
        topics: Callable[[], Sequence[Topic]],
    ) -> None:
        self._session = session
        self._pacer = pacer
        self._sound = sound
        self._keyboard = keyboard
        self._view = view
        self._options = options
        self._leaving = leaving
        self._machine = machine
        self._stage = stage
        self._shell = shell
        self._ask = ask
        self._screens = screens
        self._topics = topics
        self._settings_book = self._book()

    def help(self) -> None:
        """The help, at what is being done."""
        from trs80arm.ui.screens.help import HelpScreen

        session = self._session
        here = topics_of(cleandoc(self._screens.help_here))
        if here:
            first = here[0].title
        elif session.slip is not None:
            first = AFTER_A_SLIP
        else:
            first = WHILE_WAITING.get(session.waiting, "")
        titles = {topic.title for topic in here}
        others = (topic for topic in self._topics() if topic.title not in titles)
        self._screens.open(HelpScreen([*here, *others], first))

    def palette(self) -> None:
        """All commands, to be searched."""
        self._shell.action_command_palette()

    def theme(self) -> None:
        """Choose a theme; each is seen while it is marked."""
        choices = tuple(Choice(name, name) for name in self._shell.theme_names)
        question = ListQuestion("Theme", choices, self._shell.theme)
        self._ask.choose(question, self._shell.use_theme, self._shell.show_theme)

    def suspend(self) -> None:
        """To the shell."""
        self._shell.action_suspend_process()

    def leave(self) -> None:
        """Leave."""
        self._leaving.leave()

    def interrupt(self) -> None:
        """BREAK while the machine works for a program; else leave, but not without a question."""
        if self._shell.dialog_is_open:
            self._leaving.ask_first()
        elif self._stage.operator_came():
            return
        elif self._works():
            self._machine.press_break()
        else:
            self._leaving.ask_first()

    def _works(self) -> bool:
        idle = (Waiting.COMMAND, Waiting.EDIT, Waiting.MEMORY_SIZE, Waiting.SYSTEM)
        return self._session.waiting not in idle or self._session.busy

    def settings(self) -> None:
        """What is set, what it means, and how to have it otherwise."""
        from trs80arm.ui.screens.settings import SettingsScreen

        self._screens.open(SettingsScreen(self._settings_book))

    def _try_theme(self, name: str) -> None:
        if name not in self._shell.theme_names:
            raise ValueError(f"there is no theme {name}")
        self._shell.show_theme(name)

    def _try_arm_style(self, value: str) -> None:
        style = ArmStyle(value)
        if style is ArmStyle.PIXELS and self._view.no_pixels:
            raise ValueError(self._view.no_pixels)
        self._view.use_arm_style(style)

    def _book(self) -> SettingsBook:
        """The settings, with who takes which of them at once."""
        view, keyboard = self._view, self._keyboard

        def use_cursor(value: str) -> None:
            view.cursor_style = CursorStyle(value)

        def use_keys(value: str) -> None:
            keyboard.let_go()
            keyboard.mode = KeyMode(value)

        def use_turbo(value: bool) -> None:
            self._pacer.hurries = value

        return SettingsBook(
            self._options.settings_file,
            self._tables,
            {
                "terminal.speed": lambda value: self._pacer.set_speed(Speed(str(value)).factor),
                "terminal.keys": use_keys,
                "terminal.glyphs": lambda value: view.use_glyphs(choose(GlyphSet(value))),
                "terminal.theme": self._try_theme,
                "terminal.arm": self._try_arm_style,
                "terminal.cursor": use_cursor,
                "terminal.turbo": use_turbo,
                "terminal.sound": lambda value: self._sound.use(Sound(value)),
            },
        )

    def _tables(self) -> dict[str, dict[str, Any]]:
        rig, speed = self._session.rig.settings, self._pacer.speed
        return {
            "terminal": {
                "speed": "max" if speed is None else f"{speed:g}",
                "keys": self._keyboard.mode.value,
                "glyphs": self._view.glyph_set.value,
                "theme": self._shell.theme,
                "arm": self._view.arm_style.value,
                "cursor": self._view.cursor_style.value,
                "turbo": self._pacer.hurries,
                "sound": self._sound.sound.value,
                "fps": self._options.fps,
                "tap_ms": self._options.tap_ms,
                "repeat_ms": self._options.repeat_ms,
            },
            "machine": {
                "ram": rig.ram_kib,
                "memory_size": rig.memory_size,
                "armbasic": rig.armbasic,
                "blocks": rig.blocks,
                "native": rig.native,
                "ghosting": rig.ghosting,
                "tapes": str(rig.tape_folder or ""),
                "printer": str(rig.printer_file or ""),
            },
            "card": as_table(rig.card, with_defaults=True),
            "driver": as_table(rig.driver, with_defaults=True),
            "arm": as_table(rig.arm, with_defaults=True),
        }
