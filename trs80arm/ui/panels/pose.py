"""Where the fingertip truly is, how the joints stand, and how hard the hand grips."""

from __future__ import annotations

from math import degrees

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, signed
from trs80arm.ui.panels.panel import Panel

_WIDE = 34


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
        place = [
            _entry("X", pose.x, 2, "in"),
            _entry("Y", pose.y, 2, "in"),
            _entry("Z", pose.z, 2, "in"),
            _entry("pitch", pose.pitch, 1, "°"),
            _entry("roll", pose.roll, 1, "°"),
        ]
        hand = [_entry("hand", pose.opening, 2, "in"), _force(readings)]
        joints = [
            _entry("T1", degrees(angles.base), 1, "°"),
            _entry("T2", degrees(angles.shoulder), 1, "°"),
            _entry("T3", degrees(angles.elbow), 1, "°"),
        ]
        if width < _WIDE:
            return [*place, *hand, *joints]
        return [
            (*left, ("  ", Ink.PLAIN), *right)
            for left, right in zip(place, [*joints, *hand], strict=True)
        ]


def _entry(name: str, value: float, digits: int, unit: str) -> Row:
    number = signed(value, digits)
    return ((f"{name:6}", Ink.LABEL), (f"{number:>7} {unit:2}", Ink.PLAIN))


def _force(readings: Readings) -> Row:
    closed = readings.switch_closed
    ink = Ink.STRONG if closed else Ink.PLAIN
    return (("force", Ink.LABEL), ("*" if closed else " ", ink), (f"{readings.force:7.2f} lb", ink))
