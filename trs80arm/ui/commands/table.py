"""The program's own commands: one table for keys, bottom line, palette and the help page.

Plain keys belong to the TRS-80, so a command is on a function key, on Ctrl, or in the palette only.
What a command does is a method of one of the groups in `Commands`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from textual.binding import Binding, BindingType
from textual.command import DiscoveryHit, Hit, Hits, Provider

from trs80arm.options import Speed
from trs80arm.ui import layout
from trs80arm.ui.panels.registry import PANELS, PanelRow

if TYPE_CHECKING:
    from trs80arm.desk.files import SessionFiles
    from trs80arm.ui.commands.arm import ArmCommands
    from trs80arm.ui.commands.keys import KeyCommands
    from trs80arm.ui.commands.machine import MachineCommands
    from trs80arm.ui.commands.program import ProgramCommands
    from trs80arm.ui.commands.tube import TubeCommands
    from trs80arm.ui.commands.view import ViewCommands


@dataclass(frozen=True)
class Commands:
    """The groups of commands, each an object that holds what it needs."""

    files: SessionFiles
    machine: MachineCommands
    arm: ArmCommands
    view: ViewCommands
    tube: TubeCommands
    keys: KeyCommands
    program: ProgramCommands


@dataclass(frozen=True)
class Command:
    """A command.

    Attributes:
        name: in letters and `_`, for whoever does it by name.
        do: what it does.
        title: as the palette has it, `group: what it does`.
        help: one sentence.
        keys: the keys, comma separated.
        footer: its word in the bottom line, empty when it is not there.
        priority: whether its keys work in dialogs, too.
    """

    name: str
    do: Callable[[Commands], object]
    title: str
    help: str
    keys: str = ""
    footer: str = ""
    priority: bool = False


def panel_commands(panels: Iterable[PanelRow]) -> Iterator[Command]:
    """The commands that bring panels to sight, as their rows want them."""
    rows = list(panels)
    for row in rows:
        if row.shows:
            yield Command(
                f"show_{row.group}",
                lambda to, group=row.group: to.view.show_bottom(group),  # type: ignore[misc]
                f"View: {row.group}",
                row.shows,
                row.key,
            )
    for row in rows:
        if row.fills:
            yield Command(
                f"fill_{row.id}",
                lambda to, id=row.id: to.view.zoom(id),  # type: ignore[misc]
                f"View: {row.title.lower()} large",
                row.fills,
            )


COMMANDS: tuple[Command, ...] = (
    Command(
        "help",
        lambda to: to.program.help(),
        "Help: one page",
        "This page: keys, BREAK, programs to try.",
        "f1",
        "Help",
    ),
    Command(
        "open",
        lambda to: to.files.open(),
        "Program: open",
        "Load a program file.",
        "f2,ctrl+o",
        "Open",
    ),
    Command(
        "save",
        lambda to: to.files.save(),
        "Program: save",
        "Save the program in memory.",
        "f3,ctrl+s",
        "Save",
    ),
    Command("run", lambda to: to.machine.run(), "Program: run", "Type RUN.", "f5", "Run"),
    Command(
        "break",
        lambda to: to.machine.press_break(),
        "Program: BREAK",
        "BREAK, as Escape.",
        "f9",
        "Break",
    ),
    Command(
        "paste",
        lambda to: to.files.paste(),
        "Program: paste a listing",
        "Paste a listing: typed in, or loaded at once.",
        "ctrl+v",
    ),
    Command(
        "pause",
        lambda to: to.machine.pause(),
        "Machine: pause or go on",
        "Stop the machine's clock, or let it go on.",
        "f6",
        "Pause",
    ),
    Command(
        "step_statement",
        lambda to: to.machine.step_statement(),
        "Machine: one statement",
        "Pause, and do one statement.",
        "f7",
        "Step",
    ),
    Command(
        "step_motor",
        lambda to: to.machine.step_motor(),
        "Machine: one motor step",
        "Pause, and go on to the next change of a latch.",
        "shift+f7,ctrl+f7,f19",
    ),
    Command(
        "speed",
        lambda to: to.machine.choose_speed(),
        "Machine: choose the speed",
        "Choose how fast time goes.",
        "f8",
        "Speed",
    ),
    Command(
        "speed_1",
        lambda to: to.machine.set_speed(Speed.ONE),
        "Speed: 1, as it was",
        "As fast as the real machine.",
    ),
    Command("speed_2", lambda to: to.machine.set_speed(Speed.TWO), "Speed: 2", "Twice as fast."),
    Command(
        "speed_5", lambda to: to.machine.set_speed(Speed.FIVE), "Speed: 5", "Five times as fast."
    ),
    Command(
        "speed_20",
        lambda to: to.machine.set_speed(Speed.TWENTY),
        "Speed: 20",
        "Twenty times as fast.",
    ),
    Command(
        "speed_max",
        lambda to: to.machine.set_speed(Speed.FLAT_OUT),
        "Speed: flat out",
        "As fast as this computer can.",
    ),
    Command(
        "reset",
        lambda to: to.machine.reset(),
        "Machine: off and on",
        "Switch the TRS-80 off and on again.",
    ),
    Command(
        "panel",
        lambda to: to.view.next_panel(),
        "View: next panel",
        "Switch the panel under the tube.",
        "f4",
        "Panel",
    ),
    Command(
        "zoom",
        lambda to: to.view.zoom(layout.ARM),
        "View: arm large, and back",
        "The arm large, and back.",
        "f11",
        "Zoom",
    ),
    *panel_commands(PANELS),
    Command(
        "arm_style",
        lambda to: to.view.switch_arm_style(),
        "Arm view: ASCII or braille",
        "Draw the arm the other way.",
        "ctrl+a",
    ),
    Command(
        "envelope",
        lambda to: to.view.arm_option("envelope"),
        "Arm view: envelope",
        "Where the hand can reach.",
    ),
    Command(
        "trail",
        lambda to: to.view.arm_option("trail"),
        "Arm view: trail",
        "Where the fingertip has been.",
    ),
    Command(
        "labels",
        lambda to: to.view.arm_option("labels"),
        "Arm view: labels",
        "Names in the arm's views.",
    ),
    Command(
        "clear_trail",
        lambda to: to.view.clear_trail(),
        "Arm view: clear the trail",
        "Forget where the fingertip has been.",
    ),
    Command(
        "arm_closer",
        lambda to: to.view.zoom_arm("in"),
        "Arm view: closer",
        "Show the arm larger.",
        "ctrl+up",
    ),
    Command(
        "arm_farther",
        lambda to: to.view.zoom_arm("out"),
        "Arm view: farther",
        "Show the arm smaller.",
        "ctrl+down",
    ),
    Command(
        "arm_fit",
        lambda to: to.view.zoom_arm("fit"),
        "Arm view: fit",
        "Show all of the arm and the bench.",
    ),
    Command(
        "teach",
        lambda to: to.arm.teach(),
        "Arm: teach",
        "The positions taught, and programs of them.",
        "f12",
        "Teach",
    ),
    Command(
        "teach_here",
        lambda to: to.arm.teach_here(),
        "Arm: teach this position",
        "Teach the position where the arm is.",
        "ctrl+t",
    ),
    Command(
        "hand_move",
        lambda to: to.arm.move_by_hand(),
        "Arm: move by hand",
        "Move the arm by hand, while the motors are off.",
        "ctrl+g",
    ),
    Command(
        "bench",
        lambda to: to.arm.choose_bench(),
        "Bench: choose",
        "Set up another bench.",
        "ctrl+b",
    ),
    Command(
        "refill",
        lambda to: to.arm.refill(),
        "Bench: put the parts back",
        "Every part to where it was at the start.",
    ),
    Command(
        "latch",
        lambda to: to.keys.latch(),
        "Keys: latch on or off",
        "Latch mode: in @SET a press turns a key on or off.",
        "ctrl+d",
    ),
    Command(
        "key_test", lambda to: to.keys.test(), "Keys: test", "What the terminal tells about keys."
    ),
    Command(
        "copy_screen", lambda to: to.tube.copy(), "Screen: copy", "Copy the tube's text.", "ctrl+y"
    ),
    Command(
        "save_text",
        lambda to: to.tube.save_text(),
        "Screen: save as text",
        "The tube as a text file.",
    ),
    Command(
        "save_picture",
        lambda to: to.tube.save_picture(),
        "Screen: save as picture",
        "The whole window as SVG.",
    ),
    Command(
        "theme",
        lambda to: to.program.theme(),
        "Screen: theme",
        "Green, white, amber, high contrast, paper.",
    ),
    Command(
        "glyphs",
        lambda to: to.view.choose_glyphs(),
        "Screen: graphics glyphs",
        "Sextants, braille, quadrants or ASCII.",
    ),
    Command(
        "cursor",
        lambda to: to.view.switch_cursor(),
        "Screen: cursor blinks or not",
        "The ROM's own is steady.",
    ),
    Command(
        "save_recording",
        lambda to: to.files.save_recording(),
        "Session: save a recording",
        "All that was done since power-on.",
    ),
    Command(
        "replay",
        lambda to: to.files.play(),
        "Session: play a recording",
        "Play a recorded session.",
    ),
    Command(
        "demo",
        lambda to: to.machine.demo(),
        "Session: demonstration",
        "The article's pick and place, with captions.",
    ),
    Command(
        "settings", lambda to: to.program.settings(), "Settings: show", "What is set, and where."
    ),
    Command(
        "suspend",
        lambda to: to.program.suspend(),
        "Suspend",
        "Suspend: to the shell; fg comes back.",
        "ctrl+z",
    ),
    Command(
        "interrupt",
        lambda to: to.program.interrupt(),
        "Program: BREAK, or leave",
        "BREAK while something runs or moves; at READY, leave.",
        "ctrl+c",
        priority=True,
    ),
    Command(
        "leave",
        lambda to: to.program.leave(),
        "Leave",
        "Leave; asks if the program is unsaved.",
        "f10,ctrl+q",
        "Quit",
        True,
    ),
)


def command(name: str) -> Command:
    """The command of that name."""
    return next(command for command in COMMANDS if command.name == name)


def bindings() -> list[BindingType]:
    """The commands' keys."""
    return [
        Binding(
            key,
            f"do('{command.name}')",
            command.title,
            priority=command.priority,
            tooltip=command.help,
        )
        for command in COMMANDS
        for key in filter(None, command.keys.split(","))
    ]


def listed() -> Iterator[tuple[str, str]]:
    """The keys of the commands that have some, and what they do."""
    for command in COMMANDS:
        if command.keys:
            yield " ".join(map(spoken, command.keys.split(",")[:2])), command.help


class Palette(Provider):
    """The commands in the palette, each with its key."""

    def _entries(self) -> Iterator[tuple[str, Command, Callable[[], object]]]:
        for command in COMMANDS:
            key = command.keys.partition(",")[0]
            title = f"{command.title}  ({spoken(key)})" if key else command.title
            yield title, command, partial(self.app.run_action, f"do('{command.name}')")

    async def discover(self) -> Hits:
        """All of them, before anything is typed."""
        for title, command, do in self._entries():
            yield DiscoveryHit(title, do, help=command.help)

    async def search(self, query: str) -> Hits:
        """Those that fit what was typed."""
        matcher = self.matcher(query)
        for title, command, do in self._entries():
            if (score := matcher.match(title)) > 0:
                yield Hit(score, matcher.highlight(title), do, help=command.help)


def spoken(key: str) -> str:
    """A key as people write it: `ctrl+up` is Ctrl+Up."""
    return "+".join(part.capitalize() for part in key.split("+"))
