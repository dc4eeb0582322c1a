"""Where the fingertip truly is, how the joints stand, and how hard the hand grips."""

from __future__ import annotations

from math import degrees

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, signed
from trs80arm.ui.panels.panel import Panel

_WIDE = 32
_ROOMY = 34
_COLUMN = 16
_FIRST = 6
"""Cells for a name in the first column, and in the second where there is room."""
_SECOND = 5
"""Cells for a name in the second column."""


class PosePanel(Panel):
    """X, Y, Z, pitch, roll, opening and force; the angles of the article's T1 to T3."""

    HELP = """
## Pose

X, Y and Z of the fingertip in inches: forward of the base's axis, to the arm's left, above the
table. Pitch is the hand's angle to the horizontal, -90 straight down; roll, as the article's
Table 4 counts it, is the hand's turn with the base's taken out. T1, T2 and T3 are the angles of
base, upper arm and forearm, the last two to the horizontal. Hand is the opening between the
fingers; force what they press with, `*` once the grip switch has closed (2 oz).
"""

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """One column, or two where there is room."""
        pose, angles = readings.pose, readings.posture.angles
        narrow = _FIRST if width >= _COLUMN else _SECOND
        place = [
            _entry("X", pose.x, 2, "in", narrow),
            _entry("Y", pose.y, 2, "in", narrow),
            _entry("Z", pose.z, 2, "in", narrow),
            _entry("pitch", pose.pitch, 1, "°", narrow),
            _entry("roll", pose.roll, 1, "°", narrow),
        ]
        size = _SECOND if _WIDE <= width < _ROOMY else narrow
        hand = [_entry("hand", pose.opening, 2, "in", size), _force(readings, size)]
        joints = [
            _entry("T1", degrees(angles.base), 1, "°", size),
            _entry("T2", degrees(angles.shoulder), 1, "°", size),
            _entry("T3", degrees(angles.elbow), 1, "°", size),
        ]
        if width < _WIDE:
            return [*place, *hand, *joints]
        return [
            (*left, (" " * (size - _SECOND + 1), Ink.PLAIN), *right)
            for left, right in zip(place, [*joints, *hand], strict=True)
        ]


def _entry(name: str, value: float, digits: int, unit: str, size: int = _FIRST) -> Row:
    number = signed(value, digits)
    return ((f"{name:{size}}", Ink.LABEL), (f"{number:>7} {unit:2}", Ink.PLAIN))


def _force(readings: Readings, size: int) -> Row:
    closed = readings.switch_closed
    ink = Ink.STRONG if closed else Ink.PLAIN
    return (
        ("force", Ink.LABEL),
        ("*" if closed else " ", ink),
        (f"{readings.force:{size + 1}.2f} lb", ink),
    )
