"""The dialog that opens a program: recent files, those that come along, a folder, a preview."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import ClassVar

from rich.text import Text
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option

from trs80arm.desk.asking import ProgramQuestion, Shelf
from trs80arm.desk.places import program_files
from trs80arm.desk.reach import Reach
from trs80arm.files import FileFormatError, MachineCodeError, holds_sound, parse_program
from trs80arm.inspection import line_text
from trs80arm.paths import is_file, read_beginning
from trs80arm.reasons import reason
from trs80arm.shown import shown
from trs80arm.ui.screens.dialog import Dialog
from trs80arm.ui.screens.lists import MarkingList

PREVIEW_LINES = 40
MOST_BYTES = 1 << 20
"""Files larger than this are no TRS-80 programs and are not read for a preview."""


class OpenScreen(Dialog[Path]):
    """Asks for a program file.

    Args:
        question: where programs are.
        reach: which files can be named.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("down", "to_list", show=False),
        Binding("tab", "app.focus_next", show=False),
        Binding("ctrl+x", "discard", priority=True, show=False),
    ]
    DEFAULT_CSS = """
    OpenScreen > .dialog { width: 110; height: 90%; }
    OpenScreen Horizontal { height: 1fr; margin-top: 1; }
    OpenScreen OptionList { width: 36; height: 100%; max-height: 100%; }
    OpenScreen #preview {
        width: 1fr; height: 100%; padding-left: 1; overflow: hidden;
        border-left: solid $frame; color: $text-muted;
    }
    """

    def __init__(self, question: ProgramQuestion, reach: Reach) -> None:
        super().__init__()
        self.question = question
        self._reach = reach
        self._paths: list[Path] = []
        self._warned: Path | None = None
        self._gone: set[Path] = set()

    def compose(self) -> ComposeResult:
        """Name, list and preview."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Open a program"
            box.border_subtitle = "Type to filter or give a path; Enter opens, Escape goes back"
            yield Input(placeholder="name, path or folder/", id="name")
            yield Static("", classes="wrong", markup=False)
            with Horizontal():
                yield MarkingList(markup=False)
                yield Static("", id="preview", markup=False)

    def on_mount(self) -> None:
        """Show everything."""
        self._fill("")
        self.query_one(Input).focus()

    def _fill(self, wanted: str) -> None:
        options = self.query_one(OptionList)
        options.clear_options()
        self._paths = []
        part = wanted
        typed = self._reach.typed(wanted)
        if wanted and (wanted.endswith("/") or typed.parent != self._reach.typed("x").parent):
            # A folder that is named is what one wants to look into.
            part = "" if wanted.endswith("/") else typed.name
            shelves = self._folder(typed if wanted.endswith("/") else typed.parent)
        else:
            question = self.question
            shelves = [*question.shelves, *self._folder(question.folder), *question.below]
        for shelf in shelves:
            entries = [entry for entry in shelf.entries(part) if entry[0] not in self._gone]
            if entries:
                options.add_option(Option(shelf.title, disabled=True))
                self._paths.append(Path())
            for path, label in entries:
                options.add_option(
                    Option(Text(shown(f"  {label}"), no_wrap=True, overflow="ellipsis"))
                )
                self._paths.append(path)
        files = [n for n, path in enumerate(self._paths) if path != Path()]
        # `table4` is table4.bas, whatever else begins like that.
        whole = (n for n in files if self._paths[n].stem.casefold() == part.casefold())
        first = next(whole, files[0] if files else None)
        options.highlighted = first
        if first is None:
            self._preview(None)
            if not is_file(typed):
                self.query_one(".wrong", Static).update("No program fits.")

    def _folder(self, folder: Path) -> list[Shelf]:
        """The programs of a folder, if it can be looked into."""
        refused = self._reach.refusal(folder, to_write=False)
        return [] if refused else [Shelf(str(folder), program_files(folder))]

    def on_input_changed(self, event: Input.Changed) -> None:
        """Show what fits."""
        self.query_one(".wrong", Static).update("")
        self._fill(event.value.strip())

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        """Show the beginning of the file."""
        if event.option_index < len(self._paths):
            path = self._paths[event.option_index]
            self._preview(path)
            if self._may_go(path) and path != self._warned:
                self.query_one(".wrong", Static).update("Ctrl+X removes it.")

    def _preview(self, path: Path | None) -> None:
        self.run_worker(self._show_preview(path), group="preview", exclusive=True)

    async def _show_preview(self, path: Path | None) -> None:
        """Read a file and show its beginning, while keys go on being taken."""
        text = await asyncio.to_thread(preview, path) if path else ""
        # The dialog may have been left meanwhile.
        for page in self.query("#preview").results(Static):
            page.update(text)

    def action_to_list(self) -> None:
        """Go from the name to the list."""
        options = self.query_one(OptionList)
        if self.query_one(Input).has_focus:
            options.focus()
        options.action_cursor_down()

    def _may_go(self, path: Path) -> bool:
        """Whether it is offered to be removed."""
        return any(shelf.discard and path in shelf.files for shelf in self.question.shelves)

    def action_discard(self) -> None:
        """Remove the recovered copy that is marked, when asked to twice."""
        number = self.query_one(OptionList).highlighted
        path = self._paths[number] if number is not None else Path()
        if not self._may_go(path):
            return
        if self._warned != path:
            self._warned = path
            self.query_one(".wrong", Static).update("Ctrl+X again removes it for ever.")
            return
        for shelf in self.question.shelves:
            if shelf.discard is not None and path in shelf.files:
                shelf.discard(path)
        self._gone.add(path)
        self.query_one(".wrong", Static).update("")
        self._fill(self.query_one(Input).value.strip())

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Open what was typed if it is a file, else what is marked in the list."""
        path = self._reach.typed(event.value)
        if outside := self._reach.refusal(path, to_write=False):
            self.query_one(".wrong", Static).update(outside)
            return
        if is_file(path):
            self.dismiss(path)
            return
        number = self.query_one(OptionList).highlighted
        if number is None:
            self.query_one(".wrong", Static).update(f"There is no file {event.value.strip()}.")
        else:
            self.dismiss(self._paths[number])

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Open it."""
        self.dismiss(self._paths[event.option_index])


def preview(path: Path) -> str:
    """The beginning of a program file as LIST would show it, or why it cannot be opened."""
    try:
        content = read_beginning(path, MOST_BYTES + 1)
        if holds_sound(path):
            return "A cassette as sound: it is listened to when it is opened."
        if len(content) > MOST_BYTES:
            return "Too large for a program of the TRS-80."
        lines = parse_program(content)
    except OSError as error:
        return reason(error)
    except MachineCodeError as tape:
        return f"A cassette of machine code, {tape.name}.\n\nSYSTEM loads it."
    except FileFormatError as error:
        return f"{path.name}: {error}"
    listed = [line_text(line) for line in lines[:PREVIEW_LINES]]
    return "\n".join(listed) or "An empty program."
