"""The page of settings: each with its value, meaning and default, searched, changed and saved."""

from __future__ import annotations

from functools import partial
from typing import ClassVar

from rich.text import Text
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option

from trs80arm.desk.asking import Choice, ListQuestion
from trs80arm.desk.settings_book import Entry, SettingsBook
from trs80arm.settings_catalogue import Setting
from trs80arm.shown import shown
from trs80arm.ui.screens.dialog import Choose, Dialog
from trs80arm.ui.screens.lists import MarkingList

_NAME, _VALUE = 24, 18
"""Cells of a setting's name and of its value in the list."""


class SettingsScreen(Dialog[None]):
    """Shows what is set, and changes it.

    Args:
        book: the settings.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("down", "move(1)", show=False),
        Binding("up", "move(-1)", show=False),
        Binding("pagedown", "move(10)", show=False),
        Binding("pageup", "move(-10)", show=False),
        Binding("ctrl+s", "save", priority=True, show=False),
        Binding("ctrl+x", "to_default", priority=True, show=False),
    ]
    DEFAULT_CSS = """
    SettingsScreen > .dialog { width: 100; height: 96%; }
    SettingsScreen OptionList {
        height: 1fr; max-height: 100%; text-wrap: nowrap; text-overflow: ellipsis;
    }
    SettingsScreen #meaning { height: 6; border-top: solid $frame; }
    """

    def __init__(self, book: SettingsBook) -> None:
        super().__init__()
        self._book = book
        self._shown: list[Entry] = []

    def compose(self) -> ComposeResult:
        """What is searched, the list, what is marked, and what was said."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Settings"
            box.border_subtitle = "Enter changes, Ctrl+X default, Ctrl+S saves, Escape goes back"
            yield Input(placeholder="type to search")
            yield MarkingList(markup=False)
            yield Static("", id="meaning", markup=False)
            yield Static("", classes="wrong", markup=False)

    def on_mount(self) -> None:
        """Show all of them."""
        self._fill()
        self.query_one(OptionList).can_focus = False
        self.query_one(Input).focus()

    def _fill(self) -> None:
        options = self.query_one(OptionList)
        marked = self._marked
        self._shown = self._book.entries(self.query_one(Input).value)
        options.clear_options()
        options.add_options([Option(_line(entry)) for entry in self._shown])
        settings = [entry.setting for entry in self._shown]
        if settings:
            known = marked is not None and marked.setting in settings
            options.highlighted = settings.index(marked.setting) if known and marked else 0
        else:
            self.query_one("#meaning", Static).update("No setting has these words.")

    @property
    def _marked(self) -> Entry | None:
        number = self.query_one(OptionList).highlighted
        return self._shown[number] if number is not None and number < len(self._shown) else None

    def _say(self, text: str) -> None:
        self.query_one(".wrong", Static).update(shown(text))

    def on_input_changed(self, event: Input.Changed) -> None:
        """Show what fits."""
        self._say("")
        self._fill()

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        """Say what the marked one is."""
        if event.option_index < len(self._shown):
            entry = self._shown[event.option_index]
            when = "" if entry.at_once else " From the next start on."
            self.query_one("#meaning", Static).update(
                f"{entry.setting.name}, by default {entry.default}.{when}\n"
                f"{shown(_sentence(entry.setting.meaning))}"
            )

    def action_move(self, by: int) -> None:
        """Mark another one."""
        options = self.query_one(OptionList)
        if self._shown:
            at = (options.highlighted or 0) + by
            options.highlighted = min(max(at, 0), len(self._shown) - 1)

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Change it, by the mouse."""
        self._change(self._shown[event.option_index])

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Change the one that is marked."""
        if (entry := self._marked) is not None:
            self._change(entry)

    def _change(self, entry: Entry) -> None:
        setting = entry.setting
        dialog: Dialog[str]
        if setting.choices:
            choices = tuple(Choice(value, value) for value in setting.choices)
            dialog = Choose(ListQuestion(setting.name, choices, entry.value.strip('"')))
        else:
            dialog = AskValue(entry)
        self.open(dialog, partial(self._set, setting))

    def _set(self, setting: Setting, text: str) -> None:
        trouble = self._book.change(setting, text)
        self._say(f"{setting.name}: {trouble}" if trouble else "Changed; Ctrl+S saves it.")
        self._fill()

    def action_to_default(self) -> None:
        """The marked one is as it would be unless it were set."""
        if (entry := self._marked) is not None:
            text = entry.default.strip('"') if entry.setting.choices else entry.default
            self._set(entry.setting, text)

    def action_save(self) -> None:
        """Write what was changed into the file."""
        self._say(self._book.save())
        self._fill()


class AskValue(Dialog[str]):
    """Asks for a value."""

    def __init__(self, entry: Entry) -> None:
        super().__init__()
        self._entry = entry

    def compose(self) -> ComposeResult:
        """The value."""
        with Vertical(classes="dialog") as box:
            box.border_title = self._entry.setting.name
            box.border_subtitle = "Enter takes it, Escape goes back"
            yield Static(
                shown(_sentence(self._entry.setting.meaning)), classes="hint", markup=False
            )
            yield Input(self._entry.value.strip('"'), select_on_focus=False)

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Answer."""
        self.dismiss(event.value.strip())


def _line(entry: Entry) -> Text:
    mark = "*" if entry.changed else " "
    name = f"{mark} {entry.setting.name}".ljust(_NAME)
    value = entry.value.ljust(_VALUE)
    meaning = _sentence(entry.setting.meaning)
    return Text(shown(f"{name} {value} {meaning}"), no_wrap=True, overflow="ellipsis")


def _sentence(words: str) -> str:
    return words[:1].upper() + words[1:]
