"""The arm from above: where it points, how the hand is rolled, and all that lies on the table."""

from __future__ import annotations

from math import degrees

from trs80arm.ui.arm_view import ArmView
from trs80arm.ui.canvas_ascii import Canvas
from trs80arm.ui.readings import Readings
from trs80arm.ui.rows import Ink, signed
from trs80arm.ui.scene import Extras, Scene, top_scene


class TopView(ArmView):
    """Table, base and arm from above; the arm's front is to the right."""

    HELP = """
## The arm from above

The arm's front, the article's x, is to the right, and its left side, y, is up. `O` is the axis of
the base, and the outline around it the base plate. The two bars at the fingertips are the fingers,
with the opening between them: they lie as the roll turns them. Small as they are, one of
`|` `/` `-` `\\` shows it.

`[#]` is a part, `=` a feeder, `_` or a frame a tray, `X` an obstacle, `@` a turntable, `?` a
sensor. Dots `::` lead to where the fingertip would be if no motor had slipped.
"""

    def scene(self, readings: Readings, extras: Extras) -> Scene:
        """The table."""
        return top_scene(readings, extras)

    def label_rows(self, width: int, height: int) -> int:
        """One row for the place of the fingertip, where there is room."""
        return 1 if height >= 10 and width >= 20 else 0

    def label(self, readings: Readings, width: int, height: int, canvas: Canvas) -> None:
        """The place of the fingertip in the last row."""
        if not self.label_rows(width, height):
            return
        pose = readings.pose
        roll = degrees(readings.posture.angles.roll)
        text = f"x{signed(pose.x, 1)} y{signed(pose.y, 1)} z{signed(pose.z, 1)}"
        longer = f"{text} roll{signed(roll, 0)}"
        canvas.write(0, height - 1, longer if len(longer) <= width else text[:width], Ink.LABEL)
