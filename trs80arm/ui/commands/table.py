"""The program's own commands: one table for keys, bottom line, palette and the help page.

Plain keys belong to the TRS-80, so a command is on a function key, on Ctrl, or in the palette only.
What a command does is a method of one of the groups in `Commands`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from textual.binding import Binding, BindingType

from trs80arm.options import Speed
from trs80arm.ui import layout
from trs80arm.ui.panels.registry import PANELS, PanelRow

if TYPE_CHECKING:
    from trs80arm.desk.files import SessionFiles
    from trs80arm.desk.peripherals import Peripherals
    from trs80arm.desk.tour import Tour
    from trs80arm.ui.commands.arm import ArmCommands
    from trs80arm.ui.commands.comfort import ComfortCommands
    from trs80arm.ui.commands.debug import DebugCommands
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
    debug: DebugCommands
    arm: ArmCommands
    view: ViewCommands
    tube: TubeCommands
    keys: KeyCommands
    program: ProgramCommands
    peripherals: Peripherals
    comfort: ComfortCommands
    tour: Tour


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
        also: other words by which the palette finds it.
    """

    name: str
    do: Callable[[Commands], object]
    title: str
    help: str
    keys: str = ""
    footer: str = ""
    priority: bool = False
    also: str = ""


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
        "Help",
        "The help: searched, and opened at what is being done.",
        "f1",
        "Help",
        also="manual keys ?",
    ),
    Command(
        "palette",
        lambda to: to.program.palette(),
        "Commands",
        "All commands: type to search, Enter does the one that is marked.",
        "ctrl+p",
        "Commands",
    ),
    Command(
        "open",
        lambda to: to.files.open(),
        "Program: open",
        "Load a program file.",
        "f2,ctrl+o",
        "Open",
        also="load file",
    ),
    Command(
        "save",
        lambda to: to.files.save(),
        "Program: save",
        "Save the program in memory.",
        "f3,ctrl+s",
        "Save",
        also="write store file",
    ),
    Command(
        "run",
        lambda to: to.machine.run(),
        "Program: run",
        "Type RUN.",
        "f5",
        "Run",
        also="start go",
    ),
    Command(
        "break",
        lambda to: to.machine.press_break(),
        "Program: BREAK",
        "BREAK, as Escape.",
        "f9",
        "Break",
        also="stop escape interrupt",
    ),
    Command(
        "paste",
        lambda to: to.files.paste(),
        "Program: paste a listing",
        "Paste a listing: typed in, or loaded at once.",
        "ctrl+v",
        also="listing type in clipboard insert",
    ),
    Command(
        "pause",
        lambda to: to.machine.pause(),
        "Machine: pause or go on",
        "Stop the machine's clock, or let it go on.",
        "f6",
        "Pause",
        also="freeze hold stop",
    ),
    Command(
        "step_statement",
        lambda to: to.debug.step(),
        "Debugger: stop, then one statement",
        "Stop the program and open the debugger; once stopped, do one statement.",
        "f7",
        "Debug",
        also="single step trace breakpoint",
    ),
    Command(
        "debugger",
        lambda to: to.debug.open(),
        "Debugger: open",
        "Listing with breakpoints, variables, memory, steps on and back.",
        "ctrl+x",
        also="breakpoint variables memory poke let inspect step",
    ),
    Command(
        "step_back",
        lambda to: to.debug.back(),
        "Debugger: one statement back",
        "Go one statement back in time.",
        "alt+f7",
        also="undo reverse rewind",
    ),
    Command(
        "back_to_stop",
        lambda to: to.debug.back_to_stop(),
        "Debugger: back to the breakpoint before",
        "Go back in time to the last breakpoint that was reached.",
        also="undo reverse step back",
    ),
    Command(
        "states",
        lambda to: to.debug.states(),
        "Machine: saved states",
        "Save the whole machine by name, load one, remove one.",
        also="snapshot save load state restore",
    ),
    Command(
        "quick_save",
        lambda to: to.debug.quick_save(),
        "Machine: save the state quickly",
        "Save the whole machine, to come back to it.",
        "shift+f3,f15,ctrl+f3",
        also="snapshot state store",
    ),
    Command(
        "quick_load",
        lambda to: to.debug.quick_load(),
        "Machine: load the state saved quickly",
        "Come back to the machine that was saved quickly.",
        "shift+f2,f14,ctrl+f2",
        also="snapshot state restore",
    ),
    Command(
        "step_motor",
        lambda to: to.machine.step_motor(),
        "Machine: one motor step",
        "Pause, and go on to the next change of a latch.",
        "shift+f7,ctrl+f7,f19",
        also="single step half-step latch",
    ),
    Command(
        "speed",
        lambda to: to.machine.choose_speed(),
        "Machine: choose the speed",
        "Choose how fast time goes.",
        "f8",
        "Speed",
        also="fast slow",
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
        also="fast turbo",
    ),
    Command(
        "reset",
        lambda to: to.machine.reset(),
        "Machine: off and on",
        "Switch the TRS-80 off and on again.",
        also="restart reboot power switch",
    ),
    Command(
        "panel",
        lambda to: to.view.next_panel(),
        "View: next panel",
        "Switch the panel under the tube.",
        "f4",
        "Panel",
        also="tab",
    ),
    Command(
        "zoom",
        lambda to: to.view.zoom(layout.ARM),
        "View: arm large, and back",
        "The arm large, and back.",
        "f11",
        "Zoom",
        also="zoom maximize full",
    ),
    Command(
        "lead",
        lambda to: to.view.lead(),
        "View: room for the arm, or for the tube",
        "Give the room to the other of arm and tube; again: to whichever needs it.",
        "ctrl+e",
        also="space larger lead swap",
    ),
    *panel_commands(PANELS),
    Command(
        "arm_style",
        lambda to: to.view.next_arm_style(),
        "Arm view: next style",
        "Draw the arm in ASCII, blocks, braille dots or bare lines.",
        "ctrl+a",
        also="dots drawing braille sextant half blocks outline",
    ),
    Command(
        "choose_arm_style",
        lambda to: to.view.choose_arm_style(),
        "Arm view: choose the style",
        "Choose how the arm is drawn.",
        also="dots drawing braille sextant half blocks outline ascii",
    ),
    Command(
        "space_left",
        lambda to: to.view.turn_space(-10, 0),
        "Arm in space: from further left",
        "Walk round the arm in space.",
        "ctrl+left",
        also="orbit rotate turn 3d",
    ),
    Command(
        "space_right",
        lambda to: to.view.turn_space(10, 0),
        "Arm in space: from further right",
        "The other way round.",
        "ctrl+right",
        also="orbit rotate turn 3d",
    ),
    Command(
        "space_higher",
        lambda to: to.view.turn_space(0, 8),
        "Arm in space: from higher up",
        "Look at the arm in space from higher up.",
        "ctrl+pageup",
        also="orbit tilt 3d",
    ),
    Command(
        "space_lower",
        lambda to: to.view.turn_space(0, -8),
        "Arm in space: from lower down",
        "Look at the arm in space from lower down.",
        "ctrl+pagedown",
        also="orbit tilt 3d",
    ),
    Command(
        "scope_back",
        lambda to: to.view.scroll_scope(-16),
        "Scope: back in time",
        "Go back in time in the scope.",
        "alt+left",
        also="logic analyser history earlier",
    ),
    Command(
        "scope_on",
        lambda to: to.view.scroll_scope(16),
        "Scope: on in time",
        "Go on in time in the scope.",
        "alt+right",
        also="logic analyser later",
    ),
    Command(
        "scope_closer",
        lambda to: to.view.zoom_scope(1),
        "Scope: more detail",
        "Less time a column in the scope.",
        "alt+pageup",
        also="logic analyser zoom in",
    ),
    Command(
        "scope_farther",
        lambda to: to.view.zoom_scope(-1),
        "Scope: less detail",
        "More time a column in the scope.",
        "alt+pagedown",
        also="logic analyser zoom out",
    ),
    Command(
        "scope_next",
        lambda to: to.view.next_joint(1),
        "Scope: next joint",
        "All latches in the scope, or one joint after the other.",
        "alt+down",
        also="strip chart phases",
    ),
    Command(
        "scope_previous",
        lambda to: to.view.next_joint(-1),
        "Scope: joint before",
        "The joint before in the scope.",
        "alt+up",
        also="strip chart phases",
    ),
    Command(
        "envelope",
        lambda to: to.view.arm_option("envelope"),
        "Arm view: envelope",
        "Where the hand can reach.",
        also="reach range",
    ),
    Command(
        "trail",
        lambda to: to.view.arm_option("trail"),
        "Arm view: trail",
        "Where the fingertip has been.",
        also="path trace",
    ),
    Command(
        "labels",
        lambda to: to.view.arm_option("labels"),
        "Arm view: labels",
        "Names in the arm's views.",
        also="names captions",
    ),
    Command(
        "clear_trail",
        lambda to: to.view.clear_trail(),
        "Arm view: clear the trail",
        "Forget where the fingertip has been.",
        also="path erase",
    ),
    Command(
        "arm_closer",
        lambda to: to.view.zoom_arm("in"),
        "Arm view: closer",
        "Show the arm larger.",
        "ctrl+up",
        also="zoom in larger",
    ),
    Command(
        "arm_farther",
        lambda to: to.view.zoom_arm("out"),
        "Arm view: farther",
        "Show the arm smaller.",
        "ctrl+down",
        also="zoom out smaller",
    ),
    Command(
        "arm_fit",
        lambda to: to.view.zoom_arm("fit"),
        "Arm view: fit",
        "Show all of the arm and the bench.",
        also="zoom all whole",
    ),
    Command(
        "teach",
        lambda to: to.arm.teach(),
        "Arm: teach pendant",
        "The teach pendant: jog the arm, teach points, play them, write the program.",
        "f12",
        "Teach",
        also="jog positions points lesson program world tool joint",
    ),
    Command(
        "teach_here",
        lambda to: to.arm.teach_here(),
        "Arm: teach this position",
        "Teach the position where the arm is.",
        "ctrl+t,alt+t",
        also="record position point",
    ),
    Command(
        "hand_move",
        lambda to: to.arm.move_by_hand(),
        "Arm: move by hand",
        "Move the arm by hand, while the motors are off.",
        "ctrl+g",
        also="drag joints manual",
    ),
    Command(
        "come_back",
        lambda to: to.arm.come_back(),
        "Arm: come back after a slip",
        "What a motor lost and why; arm, parts and registers back to the start.",
        "ctrl+r",
        also="recover home reset lost steps slipped",
    ),
    Command(
        "bench",
        lambda to: to.arm.choose_bench(),
        "Bench: choose",
        "Set up another bench.",
        "ctrl+b",
        also="table parts setup",
    ),
    Command(
        "refill",
        lambda to: to.arm.refill(),
        "Bench: put the parts back",
        "Every part to where it was at the start.",
        also="reset parts restore home",
    ),
    Command(
        "score",
        lambda to: to.arm.score(),
        "Bench: score",
        "How well the goals of the bench are met, and how far each part is from its place.",
        also="goals error placement met",
    ),
    Command(
        "latch",
        lambda to: to.keys.latch(),
        "Keys: latch on or off",
        "Latch mode: in @SET a press turns a key on or off.",
        "ctrl+d",
        also="sticky hold",
    ),
    Command(
        "key_test",
        lambda to: to.keys.test(),
        "Keys: test",
        "What the terminal tells about keys.",
        also="keyboard terminal",
    ),
    Command(
        "copy_screen",
        lambda to: to.tube.copy(),
        "Screen: copy",
        "Copy the tube's text.",
        "ctrl+y",
        also="clipboard tube text",
    ),
    Command(
        "save_text",
        lambda to: to.tube.save_text(),
        "Screen: save as text",
        "The tube as a text file.",
        also="export tube",
    ),
    Command(
        "save_picture",
        lambda to: to.tube.save_picture(),
        "Screen: save as picture",
        "The whole window as SVG.",
        also="screenshot svg export image",
    ),
    Command(
        "theme",
        lambda to: to.program.theme(),
        "Screen: theme",
        "Green, white, amber, high contrast, paper.",
        also="colour color dark light green white amber contrast paper",
    ),
    Command(
        "glyphs",
        lambda to: to.view.choose_glyphs(),
        "Screen: graphics glyphs",
        "Sextants, braille, quadrants or ASCII.",
        also="characters font graphics blocks",
    ),
    Command(
        "cursor",
        lambda to: to.view.switch_cursor(),
        "Screen: cursor blinks or not",
        "The ROM's own is steady.",
        also="blink steady",
    ),
    Command(
        "page_up",
        lambda to: to.view.scroll_page(-1),
        "View: page up",
        "Look back in paper, listing or variables.",
        "pageup",
        also="scroll",
    ),
    Command(
        "page_down",
        lambda to: to.view.scroll_page(1),
        "View: page down",
        "Look on in paper, listing or variables.",
        "pagedown",
        also="scroll",
    ),
    Command(
        "tapes",
        lambda to: to.peripherals.tapes(),
        "Tape: cassettes",
        "Put a cassette in, rewind it, eject it.",
        "ctrl+f",
        also="shelf insert recorder csave cload folder",
    ),
    Command(
        "new_tape",
        lambda to: to.peripherals.new_cassette(),
        "Tape: insert a new one",
        "Put a blank cassette into the recorder.",
        also="cassette blank",
    ),
    Command(
        "rewind",
        lambda to: to.peripherals.rewind(),
        "Tape: rewind",
        "Rewind the cassette in the recorder.",
        also="cassette",
    ),
    Command(
        "eject",
        lambda to: to.peripherals.eject(),
        "Tape: eject",
        "Take the cassette out of the recorder.",
        also="cassette",
    ),
    Command(
        "paper",
        lambda to: to.peripherals.paper(),
        "Paper: save or tear off",
        "Save what is printed, or tear it off.",
        "ctrl+u",
        also="printer lprint",
    ),
    Command(
        "save_paper",
        lambda to: to.peripherals.save_paper(),
        "Paper: save",
        "Save what is printed as a text file.",
        also="printer lprint export",
    ),
    Command(
        "tear_off",
        lambda to: to.peripherals.tear_off(),
        "Paper: tear off",
        "Take away what is printed.",
        also="printer lprint clear remove",
    ),
    Command(
        "turbo",
        lambda to: to.comfort.switch_turbo(),
        "Machine: turbo for tapes and pastes",
        "Flat out while a tape goes by or a paste is typed, or not.",
        also="fast cassette speed",
    ),
    Command(
        "sound",
        lambda to: to.comfort.choose_sound(),
        "Machine: sound",
        "How programs are heard that make sound by OUT 255.",
        also="beep bell audio loudspeaker cassette noise",
    ),
    Command(
        "save_keepsakes",
        lambda to: to.files.save_keepsakes(),
        "Machine: save cassettes and paper",
        "What was recorded or printed and is in memory only.",
        also="tape csave lprint printer export",
    ),
    Command(
        "save_recording",
        lambda to: to.files.save_recording(),
        "Session: save a recording",
        "All that was done since power-on.",
        also="record session journal",
    ),
    Command(
        "replay",
        lambda to: to.files.play(),
        "Session: play a recording",
        "Play a recorded session.",
        also="recording playback",
    ),
    Command(
        "discard_recovered",
        lambda to: to.files.discard_recovered(),
        "Session: remove recovered programs",
        "Remove what sessions that ended badly have left.",
        also="discard delete clean",
    ),
    Command(
        "demo",
        lambda to: to.machine.demo(),
        "Session: demonstration",
        "The article's pick and place, with captions.",
        also="tour show example",
    ),
    Command(
        "tour",
        lambda to: to.tour.menu(),
        "Session: tour",
        "The first five minutes, step by step; again: skip, back, leave.",
        "ctrl+n,alt+n",
        also="tutorial learn guide begin first help introduction",
    ),
    Command(
        "settings",
        lambda to: to.program.settings(),
        "Settings",
        "Every setting with its meaning and default, to change and save.",
        also="options preferences config",
    ),
    Command(
        "suspend",
        lambda to: to.program.suspend(),
        "Suspend",
        "Suspend: to the shell; fg comes back.",
        "ctrl+z",
        also="shell background job",
    ),
    Command(
        "interrupt",
        lambda to: to.program.interrupt(),
        "Program: BREAK, or leave",
        "BREAK while something runs or moves; at READY, leave.",
        "ctrl+c",
        priority=True,
        also="stop quit exit",
    ),
    Command(
        "leave",
        lambda to: to.program.leave(),
        "Leave",
        "Leave; asks if the program is unsaved.",
        "f10,ctrl+q",
        "Quit",
        True,
        also="quit exit close end",
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
            yield " ".join(key_names(command)[:2]), command.help


def key_names(command: Command) -> list[str]:
    """The keys of a command as people write them, without those that no keyboard has.

    Terminals that know no Shift on function keys call Shift+F3 F15.
    """
    return [spoken(key) for key in command.keys.split(",") if key and key not in _NO_KEYS]


_NO_KEYS = {f"f{number}" for number in range(13, 25)}


def spoken(key: str) -> str:
    """A key as people write it: `ctrl+pageup` is Ctrl+PageUp."""
    parts = "+".join(part.capitalize() for part in key.split("+"))
    return parts.replace("Pageup", "PageUp").replace("Pagedown", "PageDown")
