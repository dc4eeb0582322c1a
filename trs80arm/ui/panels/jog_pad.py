"""The pendant's buttons: a column for each way to move, its value, and a button for each direction.

The left mouse button holds a button as long as it is down; the right one latches it. On each stands
the key that does the same.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from trs80arm.desk.jogging import Coordinates
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, Span
from trs80arm.rig import Key
from trs80arm.ui.panels.keys_by_mouse import KeysByMouse
from trs80arm.ui.panels.panel import Panel

AXES = 6
LABELS = 6
"""Columns for what stands before the buttons."""
NAMES = {
    Coordinates.WORLD: ("X", "Y", "Z", "pitch", "roll", "hand"),
    Coordinates.TOOL: ("along", "across", "off", "pitch", "roll", "hand"),
}
WORDS = {
    Coordinates.WORLD: (
        *(("forward", "back"), ("left", "right"), ("up", "down")),
        *(("tip up", "tip dn"), ("roll +", "roll -"), ("open", "close")),
    ),
    Coordinates.TOOL: (
        *(("out", "back"), ("left", "right"), ("up", "down")),
        *(("tip up", "tip dn"), ("roll +", "roll -"), ("open", "close")),
    ),
}
"""What the two buttons of each column do."""
_JOINT_WORDS = {
    "base": ("left", "right"),
    "shoulder": ("up", "down"),
    "elbow": ("up", "down"),
    "hand": ("open", "close"),
}
_BUTTONS = 2
"""The row of the first buttons; the others follow."""


@dataclass(frozen=True)
class _Button:
    key: Key
    word: str


class JogPad(KeysByMouse, Panel):
    """The buttons, as wide as there is room.

    Args:
        coordinates: says what they move along now.
        down: says which keys are down.
    """

    ALLOW_SELECT = False

    def __init__(
        self,
        coordinates: Callable[[], Coordinates],
        down: Callable[[], frozenset[Key]],
    ) -> None:
        super().__init__()
        self._coordinates = coordinates
        self._keys_down = down

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """Names, values, and two rows of buttons."""
        coordinates = self._coordinates()
        names: list[Span] = [(coordinates.name.ljust(LABELS), Ink.STRONG)]
        values: list[Span] = [("now".ljust(LABELS), Ink.LABEL)]
        column = self._column(width)
        for name, value in zip(self._names(readings), self._values(readings), strict=True):
            names.append((f" {name}".ljust(column)[:column], Ink.LABEL))
            values.append((f" {value}".ljust(column)[:column], Ink.STRONG))
        rows: list[Row] = [tuple(names), tuple(values)]
        for place, sign in ((0, "+"), (1, "-")):
            row: list[Span] = [(sign.ljust(LABELS), Ink.LABEL)]
            for button in self._buttons(readings, place):
                down = button.key in self._keys_down()
                left, right = (">", "<") if down else ("[", "]")
                face = f"{left}{button.key} {button.word}"[: column - 2] + right
                row.append((face.ljust(column), Ink.LAMP_ON if down else Ink.PLAIN))
            rows.append(tuple(row))
        return rows

    @staticmethod
    def _column(width: int) -> int:
        return max(9, (width - LABELS) // AXES)

    def _names(self, readings: Readings) -> tuple[str, ...]:
        coordinates = self._coordinates()
        if coordinates is Coordinates.JOINT:
            return tuple(
                drive.turns.name.lower().replace("_", " ") for drive in readings.model.drives
            )
        return NAMES[coordinates]

    def _values(self, readings: Readings) -> list[str]:
        if self._coordinates() is Coordinates.JOINT:
            return [str(count) for count in readings.registers]
        pose = readings.pose
        inches = [f"{round(value, 2) + 0.0:.2f} in" for value in (pose.x, pose.y, pose.z)]
        turns = [f"{round(value, 1) + 0.0:.1f}°" for value in (pose.pitch, pose.roll)]
        return [*inches, *turns, f"{pose.opening:.2f} in"]

    def _buttons(self, readings: Readings, place: int) -> list[_Button]:
        """The buttons of a row: 0 those that count up, 1 those that count down."""
        jog = readings.jog
        keys = jog.negative if place else jog.positive
        coordinates = self._coordinates()
        if coordinates is not Coordinates.JOINT:
            words = [pair[place] for pair in WORDS[coordinates]]
        else:
            words = []
            for drive in readings.model.drives:
                pair = _JOINT_WORDS.get(drive.turns.name.lower(), ("up", "down"))
                words.append(pair[place] if drive.sign > 0 else pair[1 - place])
        return [_Button(key, word) for key, word in zip(keys, words, strict=True)]

    def key_at(self, x: int, y: int) -> Key | None:
        """The key of the button at a cell."""
        if self._readings is None or not _BUTTONS <= y < _BUTTONS + 2 or x < LABELS:
            return None
        axis = (x - LABELS) // self._column(self.size.width)
        buttons = self._buttons(self._readings, y - _BUTTONS)
        return buttons[axis].key if axis < AXES else None
