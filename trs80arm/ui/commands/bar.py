"""The bottom line: the commands to begin with and their keys, as many as fit, to be clicked too."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from rich.segment import Segment
from textual import events
from textual.strip import Strip
from textual.widget import Widget

from trs80arm.ui.commands.command import Command

LESS_IMPORTANT = ("speed", "save", "panel", "pause", "step_statement", "zoom", "teach")
"""What goes, the last one first, where the line is short: it is in palette and help as well."""


@dataclass(frozen=True)
class _Place:
    command: Command
    key: str
    start: int
    stop: int


class CommandBar(Widget):
    """The keys of the commands to begin with, and what they do."""

    ALLOW_SELECT = False
    COMPONENT_CLASSES = {"bar--key", "bar--word"}  # noqa: RUF012
    DEFAULT_CSS = """
    CommandBar { height: 1; background: $panel; }
    CommandBar .bar--key { color: $key; background: $panel; text-style: bold; }
    CommandBar .bar--word { color: $word; background: $panel; }
    """

    def __init__(self, commands: Sequence[Command], *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._commands = commands

    def places(self, width: int) -> Sequence[_Place]:
        """The commands that fit into a line of a width, in the order of their keys."""
        shown = sorted((one for one in self._commands if one.footer), key=_order)
        for name in ("", *reversed(LESS_IMPORTANT)):
            shown = [command for command in shown if command.name != name]
            places = _laid_out(shown)
            if places[-1].stop <= width:
                return places
        return [place for place in places if place.stop <= width]

    def render_line(self, y: int) -> Strip:
        """The line."""
        width, ground = self.size.width, self.rich_style
        key_style = self.get_component_rich_style("bar--key")
        word_style = self.get_component_rich_style("bar--word")
        segments: list[Segment] = []
        for place in self.places(width):
            segments.append(Segment(place.key, key_style))
            segments.append(Segment(f" {place.command.footer} ", word_style))
        return Strip(segments).adjust_cell_length(width, ground)

    async def on_click(self, event: events.Click) -> None:
        """Do what was clicked."""
        for place in self.places(self.size.width):
            if place.start <= event.x < place.stop:
                await self.app.run_action(f"do('{place.command.name}')")


def _key(command: Command) -> str:
    """The first of its keys, in few letters: `F1`, `^P`."""
    return command.keys.partition(",")[0].replace("ctrl+", "^").upper()


def _order(command: Command) -> tuple[bool, str]:
    """Function keys by their numbers, then the others."""
    key = _key(command)
    return not key.startswith("F"), key[1:].rjust(2)


def _laid_out(commands: Sequence[Command]) -> list[_Place]:
    places: list[_Place] = []
    at = 0
    for command in commands:
        key = _key(command)
        stop = at + len(key) + len(command.footer) + 2
        places.append(_Place(command, key, at, stop))
        at = stop
    return places
