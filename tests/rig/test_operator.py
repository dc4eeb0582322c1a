"""The scripted operator does what a person at the keyboard would do."""

from __future__ import annotations

import pytest

from trs80arm import Rig
from trs80arm.basic.activity import Waiting
from trs80arm.machine.keys import Key
from trs80arm.operator import HAND_PAUSE, Hold, Operator, ScriptError, parse_holds


def test_holds_are_read_as_keys_and_seconds() -> None:
    assert parse_holds("6:1.0 1+W:.5 0") == [
        Hold((Key.N6,), 1.0),
        Hold((Key.N1, Key.W), 0.5),
        Hold((Key.N0,), HAND_PAUSE),
    ]


@pytest.mark.parametrize("text", ["6:", "6:x", "%:1", "1+:1", ":1", "6:1:1", "6:-1"])
def test_holds_that_make_no_sense_are_refused_with_the_item(text: str) -> None:
    with pytest.raises(ScriptError, match="KEYS:SECONDS"):
        parse_holds(text)


def test_inputs_are_typed_one_after_the_other() -> None:
    rig = Rig()
    rig.load_text('10 INPUT "A";A\n20 INPUT B$\n30 PRINT A*2;B$\n')
    rig.type("RUN\r")
    assert Operator(rig, inputs=["21", "YES"]).run(30) is Waiting.COMMAND
    assert " 42 YES" in rig.screen()


def test_an_input_without_an_answer_stops_the_run() -> None:
    rig = Rig()
    rig.load_text("10 INPUT A\n20 INPUT B\n")
    rig.type("RUN\r")
    assert Operator(rig, inputs=["1"]).run(30) is Waiting.INPUT


def test_two_joints_are_jogged_together_and_zero_ends_it() -> None:
    rig = Rig()
    rig.type("@SET\r")
    assert Operator(rig, sets=[parse_holds("6:0.5 1+3:0.5 0")]).run(30) is Waiting.COMMAND
    j1, j2, j3, j4, j5, j6 = rig.registers
    # 0.5 s at 2.7 ms a step; the first and last step may fall on either side.
    assert j1 == j3
    assert abs(j1 - 185) <= 1
    assert abs(j6 - 185) <= 1
    assert (j2, j4, j5) == (0, 0, 0)


def test_a_zero_pressed_the_moment_manual_mode_begins_ends_it() -> None:
    rig = Rig()
    rig.load_text('10 @SET\n20 PRINT "DONE"\n')
    rig.type("RUN\r")
    assert Operator(rig, sets=[parse_holds("0")]).run(10) is Waiting.COMMAND
    assert "DONE" in rig.screen()
