"""The dialog of the teaching helper: positions taught, and the program that comes of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical, VerticalScroll
from textual.markup import escape
from textual.widgets import Footer, Input, OptionList, Static

from trs80arm.desk.asking import FileQuestion
from trs80arm.desk.reach import ALL_FILES, Reach
from trs80arm.desk.taught_programs import Manner, Written, written
from trs80arm.desk.teach import Lesson, Position
from trs80arm.drawing.readings import Readings
from trs80arm.saving import write_whole
from trs80arm.shown import shown
from trs80arm.ui.screens.dialog import AskPath, Dialog

_HEADING = " name    hand        J1    J2    J3    J4    J5    J6     x     y     z pitch  roll"


@dataclass(frozen=True)
class TeachResult:
    """What the dialog ends with.

    Attributes:
        listing: a program to be put into the machine's memory.
    """

    listing: str


class TeachScreen(Dialog[TeachResult]):
    """Lists the positions of a lesson, and writes a program of them.

    Args:
        lesson: the positions; the dialog changes them at once.
        look: reads the rig, for teaching the position in which the arm is.
        save_folder: where programs are written unless the user names another folder.
        reach: which files can be named.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("t", "teach", "Teach"),
        Binding("enter", "edit", "Edit", priority=True),
        Binding("w", "write", "Write"),
        Binding("l", "load", "Load"),
        Binding("s", "style", "Style"),
        Binding("g", "grip", "Hand"),
        Binding("left_square_bracket,shift+up", "shift(-1)", "Up", key_display="["),
        Binding("right_square_bracket,shift+down", "shift(1)", "Down", key_display="]"),
        Binding("delete,x", "remove", "Remove", key_display="x"),
        Binding("d", "speed", "Speed"),
        Binding("r", "repeat", "Repeat"),
        Binding("a", "again", "Again"),
    ]
    DEFAULT_CSS = """
    TeachScreen > .dialog { width: 96; height: 90%; }
    TeachScreen .heading { height: 1; text-wrap: nowrap; }
    TeachScreen OptionList {
        height: auto; max-height: 40%; text-wrap: nowrap; text-overflow: clip;
    }
    TeachScreen #listing-box {
        height: 1fr; border-top: solid $frame; border-title-color: $title;
    }
    TeachScreen #listing { color: $text-muted; height: auto; }
    """
    HELP = """
## Teaching

Move the arm, with `@SET` or by hand, and teach each position. The list keeps the registers and the
pose. A position in which the grip switch is closed is one where the hand holds: the program then
closes the hand by `@CLOSE` on arrival, and opens it again where a position does not hold.

The program is written in the style of the article's Table 3, `@STEP` with the differences of the
registers, or of its Table 4, DATA lines of coordinates. Both run on the real machine. The
differences make sense only between positions whose registers count from the same zero: after a
`@RESET` or a slip the dialog names those that do not.
"""

    def __init__(
        self,
        lesson: Lesson,
        look: Callable[[], Readings],
        save_folder: Path,
        reach: Reach = ALL_FILES,
    ) -> None:
        super().__init__()
        self._reach = reach
        self._lesson = lesson
        self._look = look
        self._folder = save_folder
        self._manner = Manner()
        self._in_data = False

    def compose(self) -> ComposeResult:
        """The list, the program, the keys."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Teach"
            yield Static(_HEADING, classes="hint heading", markup=False)
            yield OptionList(markup=False)
            yield Static("", classes="wrong", markup=False)
            with VerticalScroll(id="listing-box", can_focus=False) as scroll:
                scroll.border_title = ""
                yield Static("", id="listing", markup=False)
        yield Footer(show_command_palette=False, compact=True)

    def on_mount(self) -> None:
        """Show the lesson as it is."""
        self._fill(0)
        self.query_one(OptionList).focus()

    def _fill(self, place: int) -> None:
        options = self.query_one(OptionList)
        options.clear_options()
        options.add_options([position_text(position) for position in self._lesson.positions])
        if len(self._lesson):
            options.highlighted = min(max(place, 0), len(self._lesson) - 1)
        self._write_listing()

    def _write_listing(self) -> None:
        style = "Table 4: DATA lines" if self._in_data else "Table 3: @STEP differences"
        ending = "round and round" if self._manner.repeats else "once"
        self.query_one(
            "#listing-box"
        ).border_title = f"in the style of {style}, D = {self._manner.speed}, {ending}"
        written = self._written()
        listing, remark = written.listing, written.problem or written.warning
        if not len(self._lesson):
            listing = "Nothing taught yet. Move the arm, then press T here, or Ctrl+T outside."
            remark = ""
        self.query_one(".wrong", Static).update(remark)
        self.query_one("#listing", Static).update(listing)

    def _written(self) -> Written:
        """The program, or why there is none."""
        model = self._look().model
        return written(self._lesson, self._manner, model, in_coordinates=self._in_data)

    @property
    def _place(self) -> int | None:
        return self.query_one(OptionList).highlighted

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Grey out what needs a position while there is none."""
        if action in {"edit", "grip", "again", "shift", "remove", "write", "load"} and not len(
            self._lesson
        ):
            return None
        return True

    def action_teach(self) -> None:
        """Add the position in which the arm is."""
        self._lesson.add(self._look())
        self._fill(len(self._lesson) - 1)
        self.refresh_bindings()

    def action_again(self) -> None:
        """Put the arm's position now in the place of the marked one."""
        if self._place is not None:
            self._lesson.teach_again(self._place, self._look())
            self._fill(self._place)

    def action_grip(self) -> None:
        """Hand closed here, or open."""
        place = self._place
        if place is not None:
            position = self._lesson.positions[place]
            self._lesson.set_grip(place, not position.grips, position.squeeze)
            self._fill(place)

    def action_shift(self, by: int) -> None:
        """Put the marked position earlier or later."""
        if self._place is not None:
            self._fill(self._lesson.move(self._place, by))

    def action_remove(self) -> None:
        """Take the marked position off the list."""
        if self._place is not None:
            place = self._place
            self._lesson.remove(place)
            self._fill(place)
            self.refresh_bindings()

    def action_style(self) -> None:
        """The other style."""
        self._in_data = not self._in_data
        self._write_listing()

    def action_repeat(self) -> None:
        """Round and round, or once."""
        self._manner = replace(self._manner, repeats=not self._manner.repeats)
        self._write_listing()

    def action_speed(self) -> None:
        """Ask for the D of the steps."""

        def chosen(speed: int | None) -> None:
            if speed is not None:
                self._manner = replace(self._manner, speed=speed)
                self._write_listing()

        self.app.push_screen(AskSpeed(self._manner.speed), chosen)

    def action_edit(self) -> None:
        """Ask for name, registers and hand of the marked position."""
        place = self._place
        if place is None:
            return

        def edited(position: Position | None) -> None:
            if position is not None and place < len(self._lesson):
                self._lesson.rename(place, position.name)
                self._lesson.set_registers(place, position.registers)
                self._lesson.set_grip(place, position.grips, position.squeeze)
                self._fill(place)

        self.app.push_screen(EditPosition(self._lesson.positions[place]), edited)

    def action_write(self) -> None:
        """Write the program to a file."""
        program = self._written()
        if program.problem:
            return

        def chosen(path: Path | None) -> None:
            if path is None:
                return
            try:
                write_whole(path, program.listing.encode("ascii", errors="replace"))
            except OSError as error:
                self.query_one(".wrong", Static).update(f"{path}: {error.strerror or error}")
            else:
                self._lesson.written()
                self.notify(shown(f"Written to {path}"), markup=False)

        self.app.push_screen(
            AskPath(
                FileQuestion(
                    "Write the program",
                    "A listing in plain text, which can be loaded here or typed in anywhere.",
                    self._folder / "taught.bas",
                    to_write=True,
                ),
                self._reach,
            ),
            chosen,
        )

    def action_load(self) -> None:
        """Leave, and put the program into the machine."""
        program = self._written()
        if not program.problem:
            self.dismiss(TeachResult(program.listing))


class AskSpeed(Dialog[int]):
    """Asks for a D."""

    def __init__(self, speed: int) -> None:
        super().__init__()
        self._speed = speed

    def compose(self) -> ComposeResult:
        """The number."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Speed"
            box.border_subtitle = "Enter does it, Escape goes back"
            yield Static("D of @STEP: a step takes 1.2 + 0.03 D ms.", classes="hint", markup=False)
            yield Input(str(self._speed), type="integer")
            yield Static("", classes="wrong", markup=False)

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Answer, if it is a number of the machine."""
        if event.value.isdecimal() and int(event.value) <= 32767:
            self.dismiss(int(event.value))
        else:
            self.query_one(".wrong", Static).update("A number from 0 to 32767.")


class EditPosition(Dialog[Position]):
    """Asks for name, registers and squeeze of a position."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("down", "app.focus_next", show=False),
        Binding("up", "app.focus_previous", show=False),
    ]

    def __init__(self, position: Position) -> None:
        super().__init__()
        self._position = position

    def compose(self) -> ComposeResult:
        """Three lines."""
        position = self._position
        with Vertical(classes="dialog") as box:
            box.border_title = f"Position {escape(position.name)}"
            box.border_subtitle = "Enter keeps it, Escape goes back"
            yield Static("Name", classes="hint", markup=False)
            yield Input(position.name, id="name")
            yield Static("Registers J1 to J6, in half-steps", classes="hint", markup=False)
            yield Input(" ".join(map(str, position.registers)), id="registers")
            yield Static(
                "Hand: open, or how many half-steps it closes beyond the grip switch (52 a pound)",
                classes="hint",
                markup=False,
            )
            yield Input(str(position.squeeze) if position.grips else "open", id="hand")
            yield Static("", classes="wrong", markup=False)

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Answer, if all of it can be used."""
        try:
            self.dismiss(self._edited())
        except ValueError as problem:
            self.query_one(".wrong", Static).update(str(problem))

    def _edited(self) -> Position:
        typed = {line.id: line.value.strip() for line in self.query(Input)}
        words = typed["registers"].replace(",", " ").split()
        try:
            registers = [int(word) for word in words]
        except ValueError:
            registers = []
        lesson = Lesson()
        lesson.insert(self._position)
        lesson.set_registers(0, registers)
        lesson.rename(0, typed["name"])
        hand = typed["hand"].lower()
        if hand in ("open", ""):
            lesson.set_grip(0, grips=False)
        elif hand.isdecimal() and int(hand) <= 1000:
            lesson.set_grip(0, grips=True, squeeze=int(hand))
        else:
            raise ValueError("hand: open, or a number of half-steps up to 1000")
        return lesson.positions[0]


def position_text(position: Position) -> str:
    """A line of the list."""
    hand = f"hold+{position.squeeze}" if position.grips else "open"
    counts = "".join(f"{count:6d}" for count in position.registers)
    pose = position.pose
    place = "".join(f"{round(value, 1) + 0.0:6.1f}" for value in (pose.x, pose.y, pose.z))
    turn = "".join(f"{round(value):6d}" for value in (pose.pitch, pose.roll))
    return f"{position.name[:7]:7} {hand:8.8}{counts}{place}{turn}"
