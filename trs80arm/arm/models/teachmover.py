"""The TeachMover, the MiniMover 5's successor with a computer of its own in the base.

Here it hangs on the same card. Its manual is known through programs that quote it; what they do
not settle is the MiniMover's and marked as a guess in `sources`.
"""

from __future__ import annotations

from dataclasses import replace
from math import tau

from trs80arm.arm.model import Drive, Hand, Motor
from trs80arm.arm.models.minimover5 import MINIMOVER5

# Half-steps per turn of the joint, 1.2 times the MiniMover's: 7072, 4158 and 1536. (The table of
# steps per radian that is often quoted has 672 for the elbow and 241 for the wrist, which do not
# agree with these nor with the manual's own start position.)
_S1 = 7072 / tau
_S3 = 4158 / tau
_S4 = 1536 / tau
_S6 = 370.8  # half-steps per inch: the hand's drum is twice as large
_POUND = 32
_WINDS = 1.5 / _S1  # inches of cable per half-step: pulleys as the MiniMover's, a guess
_HAND_RATE = 0.80 * MINIMOVER5.hand_steps  # half-steps per second: the motor's, whatever its drum

TEACHMOVER = replace(
    MINIMOVER5,
    name="teachmover",
    title="TeachMover",
    shoulder_height=7.625,
    hand_length=3.8,
    drives=(
        Drive(Motor.BASE, _S1, 1, 0.42 * _S1, 0.37 * _S1, _WINDS),
        Drive(Motor.SHOULDER, _S1, -1, 0.36 * _S1, 0.15 * _S1, _WINDS),
        Drive(Motor.ELBOW, _S3, -1, 0.82 * _S3, 0.23 * _S3, _WINDS),
        Drive(Motor.RIGHT_WRIST, _S4, -1, 2.02 * _S4, 1.31 * _S4, _WINDS),
        Drive(Motor.LEFT_WRIST, _S4, -1, 2.02 * _S4, 1.31 * _S4, _WINDS),
        Drive(Motor.HAND, _S6, 1, _HAND_RATE, 3.0 * _POUND, 2 * _WINDS),
    ),
    elbow_pays_out=-1,
    compensated=False,
    hand=Hand(range=3.0, pound_steps=_POUND, full_grip=3.0, switch_force=2 / 16, finger_length=1.7),
    sources=(
        ("shoulder_height, hand_length", "7.625 and 3.8 in: TeachVal III, Brock University"),
        ("drives: steps", "7072, 4158, 1536 per turn, 370.8 per inch: TeachMover II programs"),
        (
            "drives: signs and order",
            "its read-back: forearm -J3, pitch -(J4 + J5); J4 is right",
        ),
        ("drives: rates", "the MiniMover's in radians per second, as its brochure repeats them"),
        (
            "drives: the hand's rates",
            "guessed: as many half-steps a second without load as the MiniMover's motor makes, "
            "hence 1.33 in/s on a drum twice as large; 3 lb/s at 3 lb, as Table 1",
        ),
        ("drives: winds", "guessed: the MiniMover's pulleys, and a hand's drum twice as large"),
        ("elbow_pays_out", "its read-back: opening (J6 - J3) / 371"),
        ("compensated", "its @STEP leaves the hand alone; its users add the elbow's steps"),
        (
            "hand",
            "32 steps a pound; the rest guessed to be the MiniMover's",
        ),
        ("link", "7 in: TeachVal III"),
        (
            "limits, full_load, static_force, weights, stiffness, solids, start",
            "guessed to be the MiniMover's",
        ),
    ),
)
