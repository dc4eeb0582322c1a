"""The group of all commands, of which the terminal's may be left out."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

import click

from trs80arm.cli.table import COMMANDS, front_page

CLOSE = 0.6
"""How much of a word must be that of a command for it to be proposed."""


def load(name: str) -> click.Command:
    """A command of the table."""
    module, attribute, _ = COMMANDS[name]
    command: click.Command = getattr(import_module(f"trs80arm.cli.{module}"), attribute)
    return command


class ProgramFirst(click.Group):
    """The commands of the table, each loaded when it is asked for.

    `terminal` may be left out: `trs80arm table4.bas`.
    """

    default = "terminal"

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Their names."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of that name."""
        return load(cmd_name) if cmd_name in COMMANDS else None

    def get_help(self, ctx: click.Context) -> str:
        """The front page, which needs none of them."""
        return front_page().rstrip()

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put the default command in front of arguments that do not begin with a command."""
        if args[:2] == ["--plain", "tour"]:
            args = ["tour", "--plain", *args[2:]]
        if args[:1] not in (["--help"], ["-h"], ["--version"]) and (
            not args or args[0] not in COMMANDS
        ):
            self._refuse_odd_words(ctx, args)
            self._refuse_options_first(ctx, args)
            args = [self.default, *args]
        return super().parse_args(ctx, args)

    def _refuse_odd_words(self, ctx: click.Context, args: list[str]) -> None:
        """A word that is neither a command nor a program is told as that, whatever follows it."""
        from trs80arm.bundled import PROGRAM_SUFFIX, named
        from trs80arm.paths import is_file

        if not args or args[0].startswith("-"):
            return
        word = args[0]
        plain = word.replace("-", "").isalnum()
        if plain and not Path(word).exists() and not is_file(named(Path(word), PROGRAM_SUFFIX)):
            import difflib

            close = difflib.get_close_matches(word, COMMANDS, 1, CLOSE)
            hint = f"; is {close[0]} meant?" if close else "; `trs80arm programs` lists some"
            raise click.UsageError(f"there is no command and no program {word!r}{hint}", ctx)

    def _refuse_options_first(self, ctx: click.Context, args: list[str]) -> None:
        """A command behind options would be taken for the terminal's program."""
        if not args or not args[0].startswith("-"):
            return
        try:
            found, _, _ = load(self.default).make_parser(ctx).parse_args(list(args))
        except click.UsageError:
            return
        word = str(found.get("program"))
        if word in COMMANDS and not Path(word).exists():
            told = f"{word} is a command: it comes first, and its options behind it"
            raise click.UsageError(told, ctx)
