"""The arm from the side, in the plane in which it stands, with table and parts."""

from __future__ import annotations

from trs80arm.drawing.picture import FROM_THE_SIDE
from trs80arm.ui.panels.arm_view import ArmView


class SideView(ArmView):
    """The plane of the arm, seen from the arm's right."""

    SUBJECT = FROM_THE_SIDE
    HELP = """
## The arm from the side

You look along the table at the plane in which the arm stands: base and body, upper arm, forearm,
and the hand with its two fingers. The hand, with what it holds, is drawn turned towards you, so
that its opening shows; how it is rolled is seen from above and in space. Along the table's edge is
a scale in inches from the axis of the base, at the left one of heights. What is darker on the table
lies below the arm. Parts have colours of their own, those of one feeder the same; what stands
farther away is darker.

Ctrl+A draws all of it in the next style: solid in ASCII, in half blocks, in blocks of 2x3, in
braille dots, in pixels where the terminal has them, or in bare lines. In bare lines `O` is the
shoulder and `o` a joint, `[#]` a part, `[:]` a thing beside the plane, `=` a feeder, `_` a tray,
`X` an obstacle.

When a motor has slipped, a dim twin, in bare lines dots `::`, shows where the arm would be if it
had not, as far as that is elsewhere in the picture.

On request `+` outlines where the fingertip can reach with the hand straight, and `,` marks where it
has been. The wheel, or Ctrl+Up and Ctrl+Down, goes closer and farther; a closer look follows the
hand.

The angles below are those of the article: upper arm, forearm and hand to the horizontal, the roll
with the base's turn taken out.
"""
