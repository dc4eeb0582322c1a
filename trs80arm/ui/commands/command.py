"""What a command is, and what it is given: the groups whose methods do it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from trs80arm.desk.files import SessionFiles
    from trs80arm.desk.peripherals import Peripherals
    from trs80arm.desk.proof import Proof
    from trs80arm.desk.served import Served
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
    proof: Proof
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
    served: Served


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
