"""The group of all commands, of which the terminal's may be left out."""

from __future__ import annotations

import difflib
from pathlib import Path

import click

CLOSE = 0.6
"""How much of a word must be that of a command for it to be proposed."""


class ProgramFirst(click.Group):
    """A group of commands of which `terminal` may be left out: `trs80arm table4.bas`."""

    default = "terminal"

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put the default command in front of arguments that do not begin with a command."""
        if args[:2] == ["--plain", "tour"]:
            args = ["tour", "--plain", *args[2:]]
        if args[:1] not in (["--help"], ["-h"], ["--version"]) and (
            not args or args[0] not in self.commands
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
            close = difflib.get_close_matches(word, self.commands, 1, CLOSE)
            hint = f"; is {close[0]} meant?" if close else "; `trs80arm programs` lists some"
            raise click.UsageError(f"there is no command and no program {word!r}{hint}", ctx)

    def _refuse_options_first(self, ctx: click.Context, args: list[str]) -> None:
        """A command behind options would be taken for the terminal's program."""
        if not args or not args[0].startswith("-"):
            return
        try:
            found, _, _ = self.commands[self.default].make_parser(ctx).parse_args(list(args))
        except click.UsageError:
            return
        word = str(found.get("program"))
        if word in self.commands and not Path(word).exists():
            told = f"{word} is a command: it comes first, and its options behind it"
            raise click.UsageError(told, ctx)
