"""The dialog with the program of the points: to be looked at, written, loaded, or read back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical, VerticalScroll
from textual.widgets import Static

from trs80arm.desk.asking import Choice, FileQuestion, Question
from trs80arm.desk.pendant import Pendant
from trs80arm.desk.reach import ALL_FILES, Reach
from trs80arm.desk.taught_programs import Written
from trs80arm.reasons import reason
from trs80arm.saving import write_whole
from trs80arm.shown import shown
from trs80arm.ui.screens.dialog import Ask, AskPath, Dialog
from trs80arm.ui.screens.edit_point import AskSpeed
from trs80arm.ui.screens.keys_line import KeysLine

REPLACE = Question(
    "Read points back",
    "The points that are there now were not written anywhere, and would go.",
    (Choice("replace", "Replace them"), Choice("keep", "Keep them")),
)


@dataclass(frozen=True)
class TeachResult:
    """What the dialog ends with.

    Attributes:
        listing: a program to be put into the machine's memory.
    """

    listing: str


class ProgramScreen(Dialog[TeachResult]):
    """Shows the program of a pendant's points, and writes it.

    Args:
        pendant: whose points.
        save_folder: where programs are written unless the user names another folder.
        reach: which files can be named.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("l", "load", "Load"),
        Binding("w", "write", "Write"),
        Binding("s", "style", "Style"),
        Binding("d", "speed", "D"),
        Binding("u", "repeat", "Once/round"),
        Binding("i", "read_file", "Read a file"),
        Binding("m", "read_memory", "Read memory"),
    ]
    DEFAULT_CSS = """
    ProgramScreen > .dialog { width: 96; height: 90%; }
    ProgramScreen #listing-box { height: 1fr; }
    ProgramScreen #listing { height: auto; }
    """

    def __init__(self, pendant: Pendant, save_folder: Path, reach: Reach = ALL_FILES) -> None:
        super().__init__()
        self._pendant = pendant
        self._folder = save_folder
        self._reach = reach
        self._in_data = False

    def compose(self) -> ComposeResult:
        """The program, and the keys."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Program of the points"
            yield Static("", classes="hint", markup=False)
            yield Static("", classes="wrong", markup=False)
            with VerticalScroll(id="listing-box"):
                yield Static("", id="listing", markup=False)
        yield KeysLine()

    def on_mount(self) -> None:
        """Show the program as it is."""
        self._show()
        self.query_one("#listing-box").focus()

    def _show(self, remark: str = "") -> None:
        style = "Table 4: DATA lines" if self._in_data else "Table 3: @STEP differences"
        manner = self._pendant.manner
        ending = "round and round" if manner.repeats else "once"
        self.query_one(".hint", Static).update(
            f"In the style of {style}; D = {manner.speed}; {ending}."
        )
        program = self._written()
        listing = program.listing or "There is no point yet. I and M read a listing back."
        wrong = remark or program.warning
        if len(self._pendant.lesson):
            wrong = wrong or program.problem
        self.query_one(".wrong", Static).update(wrong)
        self.query_one("#listing", Static).update(listing)
        self.refresh_bindings()

    def _written(self) -> Written:
        return self._pendant.program(in_coordinates=self._in_data)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Grey out what needs a program while there is none."""
        if action in {"write", "load"} and not len(self._pendant.lesson):
            return None
        return True

    def action_style(self) -> None:
        """The other style."""
        self._in_data = not self._in_data
        self._show()

    def action_repeat(self) -> None:
        """Round and round, or once."""
        self._pendant.switch_repeats()
        self._show()

    def action_speed(self) -> None:
        """Ask for the D of the steps."""

        def chosen(speed: int) -> None:
            self._pendant.use_delay(speed)
            self._show()

        self.open(AskSpeed(self._pendant.manner.speed), chosen)

    def action_write(self) -> None:
        """Write the program to a file."""
        program = self._written()
        if not program.listing:
            return

        def chosen(path: Path) -> None:
            try:
                write_whole(path, program.listing.encode("ascii", errors="replace"))
            except OSError as error:
                self._show(f"{path}: {reason(error)}")
            else:
                self._pendant.lesson.written()
                self.notify(shown(f"Written to {path}"), markup=False)

        hint = "A listing in plain text, which can be loaded here or typed in anywhere."
        self._ask_file("Write the program", hint, chosen, to_write=True)

    def action_load(self) -> None:
        """Leave, and put the program into the machine."""
        program = self._written()
        if program.listing:
            self.dismiss(TeachResult(program.listing))

    def action_read_file(self) -> None:
        """Read the points of a file's listing."""

        def chosen(path: Path) -> None:
            self._replace(lambda: self._pendant.read_file(path))

        hint = "A listing as the pendant writes it, edited or not."
        self._ask_file(REPLACE.title, hint, chosen, to_write=False)

    def _ask_file(
        self, title: str, hint: str, then: Callable[[Path], object], *, to_write: bool
    ) -> None:
        question = FileQuestion(title, hint, self._folder / "taught.bas", to_write=to_write)
        self.open(AskPath(question, self._reach), then)

    def action_read_memory(self) -> None:
        """Read the points of the program in the machine's memory."""
        self._replace(self._pendant.read_memory)

    def _replace(self, read: Callable[[], str]) -> None:
        def answered(answer: str) -> None:
            if answer == "replace":
                self._show(read())

        if self._pendant.lesson.unwritten:
            self.open(Ask(REPLACE), answered)
        else:
            answered("replace")
