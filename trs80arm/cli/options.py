"""The options that several commands share, and the settings that they come to."""

from __future__ import annotations

from collections.abc import Callable
from importlib import resources
from typing import TYPE_CHECKING, Any, TypeVar

import click

from trs80arm.cli.arguments import A_BENCH, A_PATH
from trs80arm.cli.ending import fail

if TYPE_CHECKING:
    from trs80arm.serial.limits import Plugging
    from trs80arm.settings import Settings

Command = TypeVar("Command", bound=Callable[..., Any])
SETTING_FLAGS = {
    "ram": ("machine.ram", "K of RAM: 4, 16, 32 or 48."),
    "memory-size": ("machine.memory_size", "What is typed at MEMORY SIZE?"),
    "tapes": ("machine.tapes", "The folder of the cassettes."),
    "printer": ("machine.printer", "The file for the printer's paper."),
    "rom": ("machine.rom", "A file with your own Level II ROM, to run on the Z-80 (extra `z80`)."),
    "arm": ("arm.model", "The arm on the cable: {arms}."),
}
SCREEN_FLAGS = {
    "speed": (
        "terminal.speed",
        "Virtual seconds a second: 0.05 to 20, or max.",
    ),
    "keys": ("terminal.keys", "auto, events, repeat or latch."),
    "glyphs": ("terminal.glyphs", "auto, sextant, braille, quadrant or ascii."),
    "theme": ("terminal.theme", "green, white, amber, contrast or paper."),
    "arm-style": (
        "terminal.arm",
        "The arm: ascii, half, sextant, braille or outline.",
    ),
    "cursor": ("terminal.cursor", "blink or steady."),
    "fps": ("terminal.fps", "The most frames a second."),
}
PLUG_FLAGS = {
    "plug-speed": ("plug.speed", "Half-steps a second that the arm on the wire may make at most."),
    "plug-range": ("plug.range", "Half-steps that its motors may go from where they stood."),
}
PLUGGED_ARM = "arm.model=teachmover"
"""The arm that the model is where a wire is plugged in and nothing else is said."""


class Told(click.Option):
    """An option whose help has words that are looked up only when somebody wants to read it."""

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        """What `--help` says of it."""
        record = super().get_help_record(ctx)
        if record is None or "{arms}" not in record[1]:
            return record
        # Their modules are listed, not loaded: help answers without numpy.
        modules = (file.name for file in (resources.files("trs80arm") / "arm" / "models").iterdir())
        arms = sorted(name[:-3] for name in modules if name.endswith(".py") and name[0] != "_")
        flag, text = record
        return flag, text.format(arms=" or ".join(arms))


def settings_options(flags: dict[str, tuple[str, str]]) -> Callable[[Command], Command]:
    """The flags that are settings; each stands for `--option TABLE.KEY=VALUE`."""

    def decorate(command: Command) -> Command:
        for name, (_, text) in reversed(flags.items()):
            command = click.option(f"--{name}", metavar="VALUE", help=text, cls=Told)(command)
        return command

    return decorate


_CONFIG = click.option("--config", type=A_PATH, help="The settings file instead of the usual one.")
_OPTION = click.option("--option", multiple=True, help="Any setting: TABLE.KEY=VALUE (repeatable).")
_BENCH = click.option(
    "--bench", type=A_BENCH, help="The bench: a TOML file or one that came along."
)


def machine_options(command: Command) -> Command:
    """The options of every command that builds a rig."""
    for option in (
        _CONFIG,
        _OPTION,
        click.option(
            "--break-now/--break-at-end",
            default=None,
            help="BREAK stops a motion at once, or is seen when it has ended.",
        ),
        click.option("--no-armbasic", is_flag=True, help="The bare ROM: @ words are ?SN."),
        settings_options(SETTING_FLAGS),
        _BENCH,
    ):
        command = option(command)
    return command


def arm_options(command: Command) -> Command:
    """The options of a command that is about the arm and not the TRS-80."""
    for option in (_CONFIG, _OPTION, settings_options({"arm": SETTING_FLAGS["arm"]}), _BENCH):
        command = option(command)
    return command


def plug_options(command: Command) -> Command:
    """A real arm beside the model."""
    for option in (
        click.option("--yes", is_flag=True, help="The arm on the wire may move: nobody is asked."),
        settings_options(PLUG_FLAGS),
        click.option(
            "--plug",
            metavar="serial:PORT",
            help="A TeachMover on a serial port does what the model does (extra `serial`).",
        ),
    ):
        command = option(command)
    return command


def take_plug(given: dict[str, Any], settings: Settings) -> Plugging | None:
    """The wire to be plugged in; takes the flags out of `given`."""
    plug, allowed = given.pop("plug"), given.pop("yes")
    if plug is None:
        if allowed:
            fail("--yes is for --plug serial:PORT, which is not given")
        return None
    from trs80arm.serial.limits import Plugging
    from trs80arm.serial.port import SCHEME, is_port

    if not is_port(plug):
        fail(f"--plug {plug}: expected {SCHEME} and a port, as {SCHEME}/dev/ttyUSB0")
    return Plugging(plug.removeprefix(SCHEME), settings.plug, allowed)


def answer_options(command: Command) -> Command:
    """What the operator of an unattended run answers."""
    for option in (
        click.option(
            "--set", "sets", multiple=True, help='The next @SET, as in "6:1.0 1+W:0.5 0".'
        ),
        click.option("--input", "inputs", multiple=True, help="The answer to the next INPUT."),
    ):
        command = option(command)
    return command


def take_settings(given: dict[str, Any], *defaults: str) -> Settings:
    """Read settings file, environment and flags; takes the flags out of `given`."""
    from trs80arm import settings

    flags = {}
    for name, (setting, _) in (SETTING_FLAGS | SCREEN_FLAGS | PLUG_FLAGS).items():
        value = given.pop(name.replace("-", "_"), None)
        if value is not None:
            flags[f"{setting}={value}"] = f"--{name} {value}"
    if given.pop("no_armbasic", False):
        flags["machine.armbasic=false"] = "--no-armbasic"
    break_now = given.pop("break_now", None)
    if break_now is not None:
        flags[f"driver.break_now={str(break_now).lower()}"] = "--break-now"
    every = [*flags, *given.pop("option")]
    try:
        return settings.load(given.pop("config"), every, defaults=defaults)
    except settings.SettingsError as error:
        message = str(error)
        for option, flag in flags.items():
            # The user knows it by the flag that was typed.
            message = message.replace(f"--option {option}", flag)
        fail(message)
