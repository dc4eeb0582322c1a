"""The dialog of saved states: save, list, load, remove."""

from __future__ import annotations

from datetime import datetime
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.widgets import OptionList, Static

from trs80arm.desk.session import Session
from trs80arm.desk.states import QUICK, StateError, States
from trs80arm.ui.screens.ask_line import AskLine
from trs80arm.ui.screens.dialog import Dialog
from trs80arm.ui.screens.keys_line import KeysLine
from trs80arm.ui.screens.lists import MarkingList


class StatesScreen(Dialog[str]):
    """Lists the saved states; ends with the name of one that is to be loaded.

    Args:
        states: the saved states.
        session: what is saved.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("enter", "load", "Load", priority=True),
        Binding("s", "save", "Save"),
        Binding("delete,x", "remove", "Remove", key_display="x"),
    ]
    DEFAULT_CSS = """
    StatesScreen > .dialog { width: 76; height: 60%; }
    StatesScreen OptionList { height: 1fr; max-height: 100%; text-wrap: nowrap; }
    """

    def __init__(self, states: States, session: Session) -> None:
        super().__init__()
        self._states = states
        self._session = session
        self._names: list[str] = []

    def compose(self) -> ComposeResult:
        """The list, the keys."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Saved states"
            yield Static("The whole machine, the newest first.", classes="hint", markup=False)
            yield MarkingList(markup=False)
            yield Static("", classes="wrong", markup=False)
        yield KeysLine()

    def on_mount(self) -> None:
        """Show what there is."""
        self._fill()
        self.query_one(OptionList).focus()

    def _fill(self) -> None:
        options = self.query_one(OptionList)
        found = self._states.all()
        self._names = [state.name for state in found]
        width = max(map(len, self._names), default=0)
        options.clear_options()
        options.add_options(
            f"{state.name:{width}}  {datetime.fromtimestamp(state.saved):%Y-%m-%d %H:%M}  "
            f"{state.line}"
            for state in found
        )
        if found:
            options.highlighted = 0
        self.query_one(".hint", Static).update(
            "The whole machine, the newest first."
            if found
            else "Nothing is saved yet. S saves the machine as it stands."
        )

    @property
    def _marked(self) -> str | None:
        place = self.query_one(OptionList).highlighted
        return None if place is None or place >= len(self._names) else self._names[place]

    def action_load(self) -> None:
        """Leave with the marked one."""
        if self._marked is not None:
            self.dismiss(self._marked)

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """A state was clicked."""
        self.action_load()

    def action_save(self) -> None:
        """Ask for a name, and save the machine."""

        def save(name: str) -> None:
            self._states.save(name, self._session)
            self._fill()

        hint = "A name; a state that has it already is replaced."
        self.open(AskLine("Save the state", hint, self._marked or QUICK, save))

    def action_remove(self) -> None:
        """Remove the marked one."""
        if self._marked is None:
            return
        try:
            self._states.delete(self._marked)
        except StateError as error:
            self.query_one(".wrong", Static).update(str(error))
        self._fill()
