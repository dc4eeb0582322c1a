"""The program's own commands: one table for keys, bottom line, palette and the help page.

Plain keys belong to the TRS-80, so a command is on a function key, on Ctrl, or in the palette only.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

from textual.binding import Binding, BindingType
from textual.command import DiscoveryHit, Hit, Hits, Provider


@dataclass(frozen=True)
class Command:
    """A command.

    Attributes:
        action: Textual's action, `run_action` does it.
        title: as the palette has it, `group: what it does`.
        help: one sentence.
        keys: the keys, comma separated.
        footer: its word in the bottom line, empty when it is not there.
        priority: whether its keys work in dialogs, too.
    """

    action: str
    title: str
    help: str
    keys: str = ""
    footer: str = ""
    priority: bool = False


COMMANDS: tuple[Command, ...] = (
    Command("help", "Help: one page", "This page: keys, BREAK, programs to try.", "f1", "Help"),
    Command("open", "Program: open", "Load a program file.", "f2,ctrl+o", "Open"),
    Command("save", "Program: save", "Save the program in memory.", "f3,ctrl+s", "Save"),
    Command("run_program", "Program: run", "Type RUN.", "f5", "Run"),
    Command("break_program", "Program: BREAK", "BREAK, as Escape.", "f9", "Break"),
    Command(
        "paste_listing",
        "Program: paste a listing",
        "Paste a listing: typed in, or loaded at once.",
        "ctrl+v",
    ),
    Command(
        "pause",
        "Machine: pause or go on",
        "Stop the machine's clock, or let it go on.",
        "f6",
        "Pause",
    ),
    Command(
        "step_statement", "Machine: one statement", "Pause, and do one statement.", "f7", "Step"
    ),
    Command(
        "step_motor",
        "Machine: one motor step",
        "Pause, and go on to the next change of a latch.",
        "shift+f7,ctrl+f7,f19",
    ),
    Command("speed", "Machine: choose the speed", "Choose how fast time goes.", "f8", "Speed"),
    Command("set_speed('1')", "Speed: 1, as it was", "As fast as the real machine."),
    Command("set_speed('2')", "Speed: 2", "Twice as fast."),
    Command("set_speed('5')", "Speed: 5", "Five times as fast."),
    Command("set_speed('20')", "Speed: 20", "Twenty times as fast."),
    Command("set_speed('max')", "Speed: flat out", "As fast as this computer can."),
    Command("reset", "Machine: off and on", "Switch the TRS-80 off and on again."),
    Command("panel", "View: next panel", "Switch the panel under the tube.", "f4", "Panel"),
    Command("zoom", "View: arm large, and back", "The arm large, and back.", "f11", "Zoom"),
    Command(
        "show_bottom('keyboard')",
        "View: keyboard",
        "The TRS-80's keys, to see and to click.",
        "ctrl+k",
    ),
    Command("show_bottom('arm')", "View: arm", "The arm from the side and from above."),
    Command("show_bottom('motors')", "View: motors", "The coils of the motors, and the inputs."),
    Command("show_bottom('log')", "View: log", "What happened to the arm."),
    Command("maximise('registers')", "View: registers large", "Registers fill the screen."),
    Command("maximise('pose')", "View: pose large", "The pose fills the screen."),
    Command("maximise('coils')", "View: motors large", "The coils fill the screen."),
    Command("maximise('events')", "View: log large", "The log fills the screen."),
    Command("arm_style", "Arm view: ASCII or braille", "Draw the arm the other way.", "ctrl+a"),
    Command("arm_option('envelope')", "Arm view: envelope", "Where the hand can reach."),
    Command("arm_option('trail')", "Arm view: trail", "Where the fingertip has been."),
    Command("arm_option('labels')", "Arm view: labels", "Names in the arm's views."),
    Command("clear_trail", "Arm view: clear the trail", "Forget where the fingertip has been."),
    Command("arm_zoom('in')", "Arm view: closer", "Show the arm larger.", "ctrl+up"),
    Command("arm_zoom('out')", "Arm view: farther", "Show the arm smaller.", "ctrl+down"),
    Command("arm_zoom('fit')", "Arm view: fit", "Show all of the arm and the bench."),
    Command("teach", "Arm: teach", "The positions taught, and programs of them.", "f12", "Teach"),
    Command(
        "teach_here", "Arm: teach this position", "Teach the position where the arm is.", "ctrl+t"
    ),
    Command(
        "hand_move",
        "Arm: move by hand",
        "Move the arm by hand, while the motors are off.",
        "ctrl+g",
    ),
    Command("bench", "Bench: choose", "Set up another bench.", "ctrl+b"),
    Command("refill", "Bench: put the parts back", "Every part to where it was at the start."),
    Command(
        "latch",
        "Keys: latch on or off",
        "Latch mode: in @SET a press turns a key on or off.",
        "ctrl+d",
    ),
    Command("key_test", "Keys: test", "What the terminal tells about keys."),
    Command("copy_screen", "Screen: copy", "Copy the tube's text.", "ctrl+y"),
    Command("save_screen('txt')", "Screen: save as text", "The tube as a text file."),
    Command("save_screen('svg')", "Screen: save as picture", "The whole window as SVG."),
    Command("change_theme", "Screen: theme", "Green, white, amber, high contrast, paper."),
    Command("glyphs", "Screen: graphics glyphs", "Sextants, braille, quadrants or ASCII."),
    Command("cursor", "Screen: cursor blinks or not", "The ROM's own is steady."),
    Command("save_recording", "Session: save a recording", "All that was done since power-on."),
    Command("replay", "Session: play a recording", "Play a recorded session."),
    Command("demo", "Session: demonstration", "The article's pick and place, with captions."),
    Command("settings", "Settings: show", "What is set, and where."),
    Command("suspend_process", "Suspend", "Suspend: to the shell; fg comes back.", "ctrl+z"),
    Command(
        "leave",
        "Leave",
        "Leave; asks if the program is unsaved.",
        "f10,ctrl+q,ctrl+c",
        "Quit",
        True,
    ),
)


def bindings() -> list[BindingType]:
    """The commands' keys."""
    return [
        Binding(
            key,
            command.action,
            command.title,
            priority=command.priority,
            tooltip=command.help,
        )
        for command in COMMANDS
        for key in filter(None, command.keys.split(","))
    ]


class Palette(Provider):
    """The commands in the palette, each with its key."""

    def _entries(self) -> Iterator[tuple[str, Command]]:
        for command in COMMANDS:
            key = command.keys.partition(",")[0]
            yield (f"{command.title}  ({spoken(key)})" if key else command.title), command

    async def discover(self) -> Hits:
        """All of them, before anything is typed."""
        for title, command in self._entries():
            yield DiscoveryHit(
                title, partial(self.app.run_action, command.action), help=command.help
            )

    async def search(self, query: str) -> Hits:
        """Those that fit what was typed."""
        matcher = self.matcher(query)
        for title, command in self._entries():
            if (score := matcher.match(title)) > 0:
                yield Hit(
                    score,
                    matcher.highlight(title),
                    partial(self.app.run_action, command.action),
                    help=command.help,
                )


def spoken(key: str) -> str:
    """A key as people write it: `ctrl+up` is Ctrl+Up."""
    return "+".join(part.capitalize() for part in key.split("+"))
