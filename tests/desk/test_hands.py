"""The operator's hands on the arm: it goes, or says why not."""

from __future__ import annotations

from dataclasses import replace

import pytest

from trs80arm.desk.hands import MoveJoint, MoveTo, move_by_hand
from trs80arm.desk.session import Session
from trs80arm.rig import Pose

START = Pose(5.0, 0.0, 0.0, -90.0, 0.0, 0.0)
"""Where Table 4 begins."""


def test_a_joint_is_turned_and_the_hand_put() -> None:
    session = Session()
    assert move_by_hand(session, MoveJoint("base", 30.0)) == ""
    assert session.rig.pose.y > 1
    assert move_by_hand(session, MoveTo(START)) == ""
    assert session.rig.pose.x == pytest.approx(5.0, abs=0.01)


def test_with_the_motors_on_the_arm_does_not_give_way() -> None:
    session = Session()
    session.rig.type("@STEP 50,10\r")
    session.rig.run_until_waiting()
    before = session.rig.joints
    assert "@RESET" in move_by_hand(session, MoveJoint("base", 30.0))
    assert session.rig.joints == before


@pytest.mark.parametrize(
    "move",
    [
        MoveJoint("base", 200.0),
        MoveJoint("nose", 1.0),
        MoveTo(replace(START, x=40.0)),
        MoveTo(replace(START, opening=9.0)),
        MoveTo(replace(START, z=-2.0)),
    ],
)
def test_where_the_arm_cannot_go_it_says_so_and_stays(move: MoveJoint | MoveTo) -> None:
    session = Session()
    before = session.rig.joints
    said = move_by_hand(session, move)
    assert said
    assert "\n" not in said
    assert session.rig.joints == before
