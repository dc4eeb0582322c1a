"""The arm from above: where it points, how the hand is rolled, and all that lies on the table."""

from __future__ import annotations

from trs80arm.drawing.picture import FROM_ABOVE
from trs80arm.ui.panels.arm_view import ArmView


class TopView(ArmView):
    """Table, base and arm from above; the arm's front is to the right."""

    SUBJECT = FROM_ABOVE
    HELP = """
## The arm from above

The arm's front, the article's x, is to the right, and its left side, y, is up. The dots on the
table are inches, the figures count them from the axis of the base. The fingers lie as the roll
turns them. (The caption counts the roll as Table 4 does, with the base's turn taken out.) The wheel
goes closer and farther, and a closer look follows the hand.

In bare lines `O` is the axis of the base, the two bars at the fingertips are the fingers, and,
small as they are, one of `|` `/` `-` `\\` shows how they lie; `[#]` is a part, `=` a feeder, `_` or
a frame a tray, `X` an obstacle, `@` a turntable, `:` a belt and arrows one that runs, `%` a
machine, `?` a sensor and `!` one that answers. Dots `::` lead to where the fingertip would be if no
motor had slipped; a solid drawing has a dim twin there. On request `+` outlines how far the arm
reaches, and `,` marks where the fingertip has been.
"""
