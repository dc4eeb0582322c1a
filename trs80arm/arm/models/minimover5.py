"""The MiniMover 5 of 1980, from John W. Hill's article, by table and line."""

from __future__ import annotations

from math import radians

from trs80arm.arm.model import (
    ArmModel,
    Drive,
    Hand,
    Limits,
    Link,
    LinkSolid,
    Motor,
    Pose,
    Weights,
)

_S1 = 937.8  # half-steps per radian of base and shoulder: Table 4, line 121
_S3 = 551.4  # of the forearm: line 122
_S4 = 203.7  # of each wrist gear: line 123
_S6 = 618.0  # half-steps per inch of hand opening: line 124
_WINDS = 1.5 / _S1  # inches of cable per half-step: the shoulder's pulley fits the body, a guess
_GIVE = 0.25  # inches that the cables of shoulder and elbow give under the static force: a guess
_POUND = 52  # half-steps of hand cable per pound: article, on joint 6

MINIMOVER5 = ArmModel(
    name="minimover5",
    title="MiniMover 5",
    shoulder_height=8.1,
    link=7.0,
    hand_length=3.5,
    drives=(
        Drive(Motor.BASE, _S1, 1, 0.42 * _S1, 0.37 * _S1, _WINDS),
        Drive(Motor.SHOULDER, _S1, -1, 0.36 * _S1, 0.15 * _S1, _WINDS),
        Drive(Motor.ELBOW, _S3, 1, 0.82 * _S3, 0.23 * _S3, _WINDS),
        Drive(Motor.LEFT_WRIST, _S4, -1, 2.02 * _S4, 1.31 * _S4, _WINDS),
        Drive(Motor.RIGHT_WRIST, _S4, 1, 2.02 * _S4, 1.31 * _S4, _WINDS),
        Drive(Motor.HAND, _S6, 1, 0.80 * _S6, 3.0 * _POUND, _WINDS),
    ),
    elbow_pays_out=1,
    compensated=True,
    limits=Limits(
        base=radians(90),
        shoulder=(radians(-35), radians(144)),
        elbow=(radians(-149), 0.0),
        pitch=radians(90),
        gear=radians(270),
    ),
    hand=Hand(range=3.0, pound_steps=_POUND, full_grip=3.0, switch_force=2 / 16, finger_length=1.7),
    full_load=8.0,
    static_force=64.0,
    weights=Weights(12.0, 3.5, 11.0, 3.5, 11.0, 1.75),
    stiffness=(
        64.0 / _GIVE * 7.0**2,
        64.0 / _GIVE * 7.0**2,
        64.0 / _GIVE * 7.0**2,
        64.0 / _GIVE * 3.5**2 / 2,
        64.0 / _GIVE * 3.5**2 / 2,
        16 * _S6 / _POUND,
    ),
    solids=(
        LinkSolid("upper arm", Link.UPPER_ARM, (3.5, 0.0, 0.0), (4.0, 1.25, 0.75)),
        LinkSolid("forearm", Link.FOREARM, (3.05, 0.0, 0.0), (3.25, 1.0, 0.35)),
        LinkSolid("hand", Link.HAND, (1.15, 0.0, 0.0), (0.65, 0.75, 0.4)),
        LinkSolid("left finger", Link.LEFT_FINGER, (-0.85, 0.1, 0.0), (0.85, 0.1, 0.3)),
        LinkSolid("right finger", Link.RIGHT_FINGER, (-0.85, -0.1, 0.0), (0.85, 0.1, 0.3)),
    ),
    start=Pose(5.0, 0.0, 0.0, -90.0, 0.0, 0.0),
    sources=(
        ("shoulder_height, link, hand_length", "article, Table 4, lines 101 to 103"),
        ("drives: steps", "Table 4, lines 121 to 124"),
        ("drives: signs", "the signs of Table 4's @STEP, line 420; base and hand by inference"),
        ("drives: rates", "Table 1, speeds without load and at full load"),
        (
            "drives: winds",
            "guessed: a pulley of 3 in on the shoulder, as wide as the body, and one drum and "
            "gearing for all; Table 4's steps per radian are then the pulleys' sizes",
        ),
        ("elbow_pays_out, compensated", "article, on joint 6 and on @STEP"),
        ("limits", "Table 1; gears and pitch from the article on joints 4 and 5"),
        ("hand", "article, on joint 6; range and greatest force from Table 1"),
        ("hand: finger_length", "facts 7: a 1.700 in link, in the later manual"),
        ("full_load, static_force", "Table 1"),
        (
            "weights",
            "guessed: a third of Table 1's 6 lb; with them 8 oz is carried through Table 4",
        ),
        ("stiffness", "guessed: a quarter of an inch under 4 lb; the hand's from the article"),
        (
            "solids",
            "guessed, slim enough for Table 1's range; a finger's length is the later manual's",
        ),
        ("start", "Table 4's initialization point, data line 10000"),
    ),
)
