"""The arm from the side, in the plane in which it stands, with table and parts."""

from __future__ import annotations

from math import degrees

from trs80arm.ui.arm_view import ArmView
from trs80arm.ui.canvas_ascii import Canvas
from trs80arm.ui.readings import Readings
from trs80arm.ui.rows import Ink, signed
from trs80arm.ui.scene import Extras, Scene, side_scene

_LEGEND = ":: where the motors were told to be"


class SideView(ArmView):
    """The plane of the arm, seen from the arm's right."""

    HELP = """
## The arm from the side

You look along the table at the plane in which the arm stands: base plate and body, upper arm from
the shoulder `O` to the elbow `o`, forearm to the wrist `o`, and the hand with its two fingers. The
hand is drawn turned towards you, so that its opening shows; how it is rolled is seen from above.

`[#]` is a part, `[:]` a thing that stands beside the plane, `=` a feeder, `_` a tray, `X` an
obstacle. When a motor has slipped, dots `::` show where the arm would be if it had not.

The angles below are those of the article: upper arm, forearm and hand to the horizontal.
"""

    def scene(self, readings: Readings, extras: Extras) -> Scene:
        """The plane of the arm."""
        return side_scene(readings, extras)

    def label_rows(self, width: int, height: int) -> int:
        """One row for the angles, where there is room."""
        return 1 if height >= 10 and width >= 28 else 0

    def label(self, readings: Readings, width: int, height: int, canvas: Canvas) -> None:
        """The angles in the last row, and what the dots mean in the first."""
        if self.label_rows(width, height):
            canvas.write(0, height - 1, angles_text(readings, width), Ink.LABEL)
        if readings.believed and height >= 8:
            legend = _LEGEND if width >= len(_LEGEND) else ":: told"
            canvas.write(0, 0, legend[:width], Ink.GHOST)


def angles_text(readings: Readings, width: int) -> str:
    """The five angles in degrees, as wordy as `width` cells allow."""
    angles = readings.posture.angles
    values = [
        degrees(angle)
        for angle in (angles.base, angles.shoulder, angles.elbow, angles.pitch, angles.roll)
    ]
    text = ""
    for names, digits in (
        (("base ", "shoulder ", "elbow ", "pitch ", "roll "), 1),
        (("B", "S", "E", "P", "R"), 1),
        (("B", "S", "E", "P", "R"), 0),
    ):
        text = " ".join(
            name + signed(value, digits) for name, value in zip(names, values, strict=True)
        )
        if len(text) <= width:
            break
    return text
