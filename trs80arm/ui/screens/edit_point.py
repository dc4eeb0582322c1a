"""Dialogs about points: a point's name, comment, registers, hand and speed; the D of all."""

from __future__ import annotations

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.markup import escape
from textual.widgets import Input, Static

from trs80arm.desk.teach import MOST_DELAY, Lesson, Position
from trs80arm.ui.screens.dialog import Dialog, LineDialog

MOST_SQUEEZE = 1000
"""Half-steps beyond the grip switch; more than any hand has."""


class AskSpeed(LineDialog[int]):
    """Asks for a D."""

    def __init__(self, speed: int) -> None:
        super().__init__(
            "Speed", "D of @STEP: a step takes 1.2 + 0.03 D ms.", str(speed), "integer"
        )

    def answer(self, text: str) -> int:
        """The number, if it is one of the machine."""
        if not text.isdecimal() or int(text) > MOST_DELAY:
            raise ValueError(f"A number from 0 to {MOST_DELAY}.")
        return int(text)


class EditPoint(Dialog[Position]):
    """Asks for what there is to say of a point."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("down", "app.focus_next", show=False),
        Binding("up", "app.focus_previous", show=False),
    ]

    def __init__(self, position: Position, pound_steps: float) -> None:
        """Ask.

        Args:
            position: as it is.
            pound_steps: half-steps by which the arm's hand closes for a pound.
        """
        super().__init__()
        self._position = position
        self._pound_steps = pound_steps

    def compose(self) -> ComposeResult:
        """Five lines."""
        position = self._position
        with Vertical(classes="dialog") as box:
            box.border_title = f"Point {escape(position.name)}"
            box.border_subtitle = "Enter keeps it, Escape goes back"
            yield Static("Name", classes="hint", markup=False)
            yield Input(position.name, id="name")
            yield Static("Comment, for the list and the listing", classes="hint", markup=False)
            yield Input(position.comment, id="comment")
            yield Static("Registers J1 to J6, in half-steps", classes="hint", markup=False)
            yield Input(" ".join(map(str, position.registers)), id="registers")
            yield Static(
                "Hand: open, or how many half-steps it closes beyond the grip switch "
                f"({self._pound_steps:g} a pound)",
                classes="hint",
                markup=False,
            )
            yield Input(str(position.squeeze) if position.grips else "open", id="hand")
            yield Static("D of the way there; empty: as all others", classes="hint", markup=False)
            yield Input("" if position.delay is None else str(position.delay), id="delay")
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
        lesson.comment(0, typed["comment"])
        hand = typed["hand"].lower()
        if hand in ("open", ""):
            lesson.set_grip(0, grips=False)
        elif hand.isdecimal() and int(hand) <= MOST_SQUEEZE:
            lesson.set_grip(0, grips=True, squeeze=int(hand))
        else:
            raise ValueError(f"hand: open, or a number of half-steps up to {MOST_SQUEEZE}")
        if typed["delay"] and not typed["delay"].isdecimal():
            raise ValueError(f"D is a number from 0 to {MOST_DELAY}")
        lesson.set_delay(0, int(typed["delay"]) if typed["delay"] else None)
        return lesson.positions[0]
