"""The arm from the side, in the plane in which it stands, with table and parts."""

from __future__ import annotations

from math import degrees

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import signed
from trs80arm.drawing.scene import Extras, Scene
from trs80arm.drawing.side_scene import side_scene
from trs80arm.ui.panels.arm_view import ArmView

_LEGENDS = ("  :: where the motors were told to be", "  :: as commanded", " :: told")


class SideView(ArmView):
    """The plane of the arm, seen from the arm's right."""

    HELP = """
## The arm from the side

You look along the table at the plane in which the arm stands: base plate and body, upper arm from
the shoulder `O` to the elbow `o`, forearm to the wrist `o`, and the hand with its two fingers. The
hand is drawn turned towards you, so that its opening shows; how it is rolled is seen from above.

`[#]` is a part, `[:]` a thing that stands beside the plane, `=` a feeder, `_` a tray, `X` an
obstacle. When a motor has slipped, dots `::` show where the arm would be if it had not.

On request `+` outlines where the fingertip can reach with the hand straight, and `,` marks where it
has been. A closer look follows the hand.

The angles below are those of the article: upper arm, forearm and hand to the horizontal, the roll
with the base's turn taken out.
"""

    def scene(self, readings: Readings, extras: Extras) -> Scene:
        """The plane of the arm."""
        return side_scene(readings, extras)

    def caption(self, readings: Readings, width: int) -> str:
        """The angles, and what the dots mean while there are any."""
        if not readings.believed:
            return angles_text(readings, width)
        for legend in _LEGENDS:
            angles = angles_text(readings, width - len(legend))
            if angles:
                return angles + legend
        return angles_text(readings, width)


def angles_text(readings: Readings, width: int) -> str:
    """The five angles in degrees, as wordy as there is room for in less than `width` cells."""
    angles = readings.posture.angles
    values = [
        *map(degrees, (angles.base, angles.shoulder, angles.elbow, angles.pitch)),
        readings.pose.roll,
    ]
    for names, digits in (
        (("base ", "shoulder ", "elbow ", "pitch ", "roll "), 1),
        (("B", "S", "E", "P", "R"), 1),
        (("B", "S", "E", "P", "R"), 0),
    ):
        text = " ".join(
            name + signed(value, digits) for name, value in zip(names, values, strict=True)
        )
        if len(text) < width:
            return text
    return ""
