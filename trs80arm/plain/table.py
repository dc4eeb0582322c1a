"""All commands of the line mode, group by group, and what is done with a line that names one."""

from __future__ import annotations

from trs80arm.plain import arm, debugging, machine, pendant, peripherals, processor, teaching
from trs80arm.plain.command import Group, LineCommand, Sitting

COLUMN = 26
"""Columns of the help for how a command is typed."""
SET_HELP = (
    "In @SET: KEYS:SECONDS with keys joined by +, several of them, and 0 to end, as 6:1 1+W:0.5 0"
)


def show_help(sitting: Sitting, words: str) -> None:
    """All commands, or one of them at length."""
    command = _find(words.removeprefix(".")) if words else None
    if command is not None:
        sitting.tell(f".{command.usage}: {command.help}\n{command.more}".rstrip())
        return
    lines = ["A line is typed into the TRS-80, with ENTER. Ctrl+C is BREAK. Lines with a point:"]
    for group in GROUPS:
        lines.append(f"{group.title}:")
        lines += [f"  .{each.usage:<{COLUMN}} {each.help}" for each in group.commands]
    sitting.tell("\n".join([*lines, SET_HELP]))


GROUPS: tuple[Group, ...] = (
    machine.GROUP,
    arm.GROUP,
    pendant.GROUP,
    teaching.GROUP,
    peripherals.GROUP,
    debugging.GROUP,
    processor.GROUP,
    Group(
        "This program",
        (
            LineCommand("help", "all commands, or one", show_help, "[COMMAND]"),
            LineCommand(
                "tour",
                "the first five minutes, step by step; again: skip, back, leave",
                lambda sitting, _: sitting.tour.menu(),
            ),
            LineCommand("quit", "leave", lambda sitting, _: sitting.leave()),
        ),
    ),
)


def _find(name: str) -> LineCommand | None:
    commands = (command for group in GROUPS for command in group.commands)
    return next((command for command in commands if command.name == name.casefold()), None)


def is_command(line: str) -> bool:
    """Whether a line names a command, its point before it."""
    return line.startswith(".") and _find(line[1:].partition(" ")[0]) is not None


def do_command(sitting: Sitting, line: str) -> None:
    """Do the command that a line names; its point is left out."""
    name, _, words = line.partition(" ")
    command = _find(name)
    if command is None:
        sitting.tell(f"There is no .{name}; .help lists what there is.")
    else:
        command.do(sitting, words.strip())
