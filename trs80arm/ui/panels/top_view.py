"""The arm from above: where it points, how the hand is rolled, and all that lies on the table."""

from __future__ import annotations

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import signed
from trs80arm.drawing.scene import Extras, Scene
from trs80arm.drawing.top_scene import top_scene
from trs80arm.ui.panels.arm_view import ArmView


class TopView(ArmView):
    """Table, base and arm from above; the arm's front is to the right."""

    HELP = """
## The arm from above

The arm's front, the article's x, is to the right, and its left side, y, is up. `O` is the axis of
the base, and the outline around it the base plate. The two bars at the fingertips are the fingers,
with the opening between them: they lie as the roll turns them. (The caption counts the roll as
Table 4 does, with the base's turn taken out.) Small as they are, one of `|` `/` `-` `\\` shows it.

`[#]` is a part, `=` a feeder, `_` or a frame a tray, `X` an obstacle, `@` a turntable, `?` a
sensor. Dots `::` lead to where the fingertip would be if no motor had slipped. On request `+`
outlines how far the arm reaches, and `,` marks where the fingertip has been.
"""

    def scene(self, readings: Readings, extras: Extras) -> Scene:
        """The table."""
        return top_scene(readings, extras)

    def caption(self, readings: Readings, width: int) -> str:
        """The place of the fingertip, and the roll."""
        pose = readings.pose
        place = f"x{signed(pose.x, 1)} y{signed(pose.y, 1)} z{signed(pose.z, 1)}"
        longer = f"{place} roll{signed(pose.roll, 0)}"
        return longer if len(longer) <= width else place if len(place) <= width else ""
