"""The program's own commands: one table for keys, bottom line, palette and the help page.

Plain keys belong to the TRS-80, so a command is on a function key, on Ctrl, or in the palette only.
What a command does is a method of one of the groups in `Commands`.
"""

from __future__ import annotations

from collections.abc import Iterator

from textual.binding import Binding, BindingType

from trs80arm.ui.commands.command import Command, key_names
from trs80arm.ui.commands.rows.arm import ARM
from trs80arm.ui.commands.rows.machine import MACHINE
from trs80arm.ui.commands.rows.peripherals import PERIPHERALS
from trs80arm.ui.commands.rows.program import PROGRAM
from trs80arm.ui.commands.rows.screen import SCREEN
from trs80arm.ui.commands.rows.session import SESSION
from trs80arm.ui.commands.rows.view import VIEW

COMMANDS: tuple[Command, ...] = (
    *PROGRAM,
    *MACHINE,
    *VIEW,
    *ARM,
    *SCREEN,
    *PERIPHERALS,
    *SESSION,
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
