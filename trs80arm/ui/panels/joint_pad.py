"""The joint keys of the TeachMover's pendant as buttons: a column a pair, its register, + and -.

The left mouse button holds a button as long as it is down; the right one latches it. On each stands
the key that does the same.
"""

from __future__ import annotations

from collections.abc import Callable

from trs80arm.desk.base_pendant import AXES, SIGNS
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, Span
from trs80arm.rig import Key
from trs80arm.serial.pendant_keys import JointKey
from trs80arm.ui.panels.keys_by_mouse import KeysByMouse
from trs80arm.ui.panels.panel import Panel

LABELS = 4
"""Columns for what stands before the buttons."""
WORDS = (
    *(("left", "right"), ("up", "down"), ("up", "down")),
    *(("tip up", "tip dn"), ("left", "right"), ("open", "close")),
)
"""What the two buttons of each column do."""
_BUTTONS = 2
"""The row of the first buttons; the others follow."""


class JointPad(KeysByMouse, Panel):
    """The buttons, as wide as there is room.

    Args:
        down: says which keys are down.
    """

    ALLOW_SELECT = False

    def __init__(self, down: Callable[[], frozenset[JointKey]]) -> None:
        super().__init__()
        self._keys_down = down

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """Names, registers, and two rows of buttons."""
        column = self._column(width)
        names: list[Span] = [("".ljust(LABELS), Ink.LABEL)]
        values: list[Span] = [("J".ljust(LABELS), Ink.LABEL)]
        for axis, (name, count) in enumerate(zip(AXES, readings.registers, strict=True), 1):
            names.append((f" {name[0]} {name.lower()}".ljust(column)[:column], Ink.LABEL))
            values.append((f" J{axis} {count}".ljust(column)[:column], Ink.STRONG))
        rows: list[Row] = [tuple(names), tuple(values)]
        for way, sign in ((1, "+"), (-1, "-")):
            row: list[Span] = [(sign.ljust(LABELS), Ink.LABEL)]
            for axis, (name, words) in enumerate(zip(AXES, WORDS, strict=True)):
                down = JointKey[f"{name}_{SIGNS[way]}"] in self._keys_down()
                left, right = (">", "<") if down else ("[", "]")
                face = f"{left}{self._key(readings, axis, way)} {words[way < 0]}"
                row.append(
                    (
                        (face[: column - 2] + right).ljust(column),
                        Ink.LAMP_ON if down else Ink.PLAIN,
                    )
                )
            rows.append(tuple(row))
        return rows

    @staticmethod
    def _key(readings: Readings, axis: int, way: int) -> Key:
        jog = readings.jog
        return (jog.positive if way > 0 else jog.negative)[axis]

    @staticmethod
    def _column(width: int) -> int:
        return max(9, (width - LABELS) // len(AXES))

    def key_at(self, x: int, y: int) -> Key | None:
        """The key of the button at a cell."""
        if self._readings is None or not _BUTTONS <= y < _BUTTONS + 2 or x < LABELS:
            return None
        axis = (x - LABELS) // self._column(self.size.width)
        if axis >= len(AXES):
            return None
        return self._key(self._readings, axis, 1 if y == _BUTTONS else -1)
