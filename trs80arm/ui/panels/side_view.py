"""The arm from the side, in the plane in which it stands, with table and parts."""

from __future__ import annotations

from trs80arm.drawing.picture import FROM_THE_SIDE
from trs80arm.ui.panels.arm_view import ArmView


class SideView(ArmView):
    """The plane of the arm, seen from the arm's right."""

    SUBJECT = FROM_THE_SIDE
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
