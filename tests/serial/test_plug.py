"""A real arm on a wire beside the model: it goes the model's way, or nothing goes on."""

from __future__ import annotations

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.block_bench import BLOCK
from tests.serial.far_side import HIGH, FarSide, Plugged, nobody
from trs80arm import Rig
from trs80arm.arm.events import Reason
from trs80arm.arm.motors import RING
from trs80arm.serial.courier import Courier
from trs80arm.serial.far_arm import Compare, FarArm, Grip, Move, Zero, speed
from trs80arm.serial.gathering import Leg
from trs80arm.serial.limits import PlugSettings
from trs80arm.serial.speeds import delay_of
from trs80arm.serial.wire import WireError


def test_the_other_arm_has_the_registers_of_the_model() -> None:
    both = Plugged()
    both.do("@STEP 50,400,-100,30,5,-7,20", "@STEP 100,-90", "@STEP 60,0,40,-30,9,9,-40")
    assert both.courier.fault == ""
    assert tuple(both.far.registers) == both.rig.registers == (310, -60, 0, 14, 2, -20)
    assert both.far.heard[0] == "@READ", "nothing moves before it has answered"
    assert both.far.heard[-1] == "@READ"


def test_a_motion_is_sent_in_lines_of_half_a_second_at_its_own_speed() -> None:
    both = Plugged()
    both.do("@STEP 50,-800,200")
    assert both.courier.fault == ""
    assert len(both.far.steps) >= 4
    for base, shoulder, *_ in both.far.steps:
        assert abs(base) * 0.0027 <= 0.52
        assert shoulder == pytest.approx(-base / 4, abs=1)
    speeds = {int(line.split()[1].split(",")[0]) for line in both.far.heard if "STEP" in line}
    assert all(50 <= delay_of(each) <= 53 for each in speeds)


def test_registers_that_were_not_zero_are_where_it_begins() -> None:
    both = Plugged()
    far = FarSide((100, -200, 3, 4, 5, 6))
    courier = Courier(both.rig, far, PlugSettings())
    both.courier.close()
    both.courier = courier
    both.do("@STEP 50,10")
    assert far.registers == [110, -200, 3, 4, 5, 6]
    assert courier.fault == ""


def test_reset_is_sent_and_steps_by_out_are_too() -> None:
    both = Plugged()
    both.do("@STEP 50,10", "@RESET")
    assert "@RESET" in both.far.words
    assert both.far.registers == [0] * 6
    both.do("FOR I=1 TO 4:OUT 152,4:OUT 152,6:OUT 152,2:NEXT")
    assert both.courier.fault == ""
    assert both.rig.arm.motors[0].rotor != 10
    assert both.far.registers[0] == both.rig.arm.motors[0].rotor - 10


def test_the_hand_closes_by_its_own_switch_and_may_close_a_little_otherwise() -> None:
    both = Plugged(BLOCK)
    both.far.closing = -170
    both.do("@CLOSE 100")
    closed = both.rig.registers[5]
    assert both.far.words.count("@CLOSE") == 1
    assert 0 < abs(closed + 170) <= PlugSettings().play
    both.do("@STEP 100,0,0,0,0,0,-10")
    assert both.courier.fault == ""
    assert both.far.registers[5] == -180


def test_a_hand_that_closes_on_nothing_is_told() -> None:
    both = Plugged(BLOCK)
    both.far.closing = -330
    both.do("@CLOSE 100")
    assert both.courier.fault.startswith("The hand on the wire closed ")
    assert "half-steps farther than the model's" in both.courier.fault
    sent = len(both.far.heard)
    both.do("@STEP 100,20")
    assert len(both.far.heard) == sent, "nothing is sent any more"


@pytest.mark.parametrize(
    ("answer", "told"),
    [
        (["0"], "refused @STEP"),
        (["2"], "stop key"),
        (["\x00\ufffd#"], "is no answer"),
        (["1", "1,2"], "is no answer"),
        ([""], "is no answer"),
    ],
)
def test_an_answer_that_is_not_1_stops_all(answer: list[str], told: str) -> None:
    both = Plugged()
    both.far.answer = lambda line: answer if line.startswith("@STEP") else None
    both.do("@STEP 50,400")
    assert told in both.courier.fault
    assert both.courier.fault.endswith(".")
    assert "\n" not in both.courier.fault
    assert len(both.far.steps) == 1


@pytest.mark.parametrize("reading", ["", "1,2,3", "a,b,c,d,e,f,g", "1,2,3,4,5,6,7,8"])
def test_a_reading_that_is_none_is_told(reading: str) -> None:
    both = Plugged()
    both.far.answer = lambda line: ["1", reading] if line == "@READ" else None
    both.do("@STEP 50,4")
    assert "after @READ is no answer" in both.courier.fault


def test_a_lost_step_on_the_wire_is_one_sentence() -> None:
    both = Plugged()
    both.do("@STEP 50,40")
    both.far.registers[1] -= 8
    both.do("@STEP 50,40")
    assert both.courier.fault == (
        "The arm on the wire is not where it should be: its register of the shoulder has -8, "
        "and 0 was asked for."
    )


def test_a_wire_that_is_cut_in_mid_motion_is_one_sentence() -> None:
    both = Plugged()
    both.far.answer = lambda line: nobody(line) if len(both.far.steps) == 2 else None
    both.do("@STEP 50,1000")
    assert both.courier.fault == "The wire to the arm is dead: cut."
    assert len(both.far.steps) == 2


def test_nothing_at_the_end_of_the_wire_is_told_at_once() -> None:
    far = FarSide()
    far.answer = nobody
    rig = Plugged().rig
    with pytest.raises(WireError, match="dead"):
        Courier(rig, far, PlugSettings())
    assert far.closed


def test_another_arm_than_a_teachmover_is_refused() -> None:
    with pytest.raises(WireError, match=r"TeachMover, and the model beside it a .*--arm"):
        Courier(Rig(), FarSide(), PlugSettings())


def test_what_is_too_fast_is_refused_before_it_is_sent() -> None:
    both = Plugged(speed=300)
    both.do("@STEP 50,400")
    assert "The base would make 370 half-steps a second" in both.courier.fault
    assert both.far.steps == []


def test_what_is_too_far_is_refused_before_it_is_sent() -> None:
    both = Plugged(range=300)
    both.do("@STEP 50,290", "@STEP 50,-290")
    assert both.courier.fault == ""
    both.do("@STEP 50,0,0,0,0,310")
    assert "The left wrist would go " in both.courier.fault
    assert sum(counts[4] for counts in both.far.steps) <= 300


def test_the_arm_is_stopped_before_what_befalls_the_model() -> None:
    both = Plugged("[arm]\nat = [7, 0, 1]\nopening = 1\n")
    both.do("@STEP 100,0,900")
    assert "was stopped before what befell the model: shoulder slipped" in both.courier.fault
    at_stop = sum(counts[1] for counts in both.far.steps)
    assert at_stop <= both.rig.arm.motors[1].rotor + 8


@pytest.mark.parametrize("way", ["bench", "hand", "back"])
def test_a_model_that_was_put_elsewhere_is_told(way: str) -> None:
    both = Plugged()
    before = both.rig.snapshot()
    if way == "bench":
        both.rig.set_bench(Plugged().rig.arm.bench)
    elif way == "hand":
        both.rig.move_joint("base", 10.0)
    else:
        both.rig.restore(before)
    both.do("@STEP 50,40")
    assert "the arm" in both.courier.fault
    assert both.far.steps == []


def test_a_machine_switched_off_and_on_goes_on() -> None:
    both = Plugged()
    both.do("@STEP 50,40")
    both.rig.reset()
    both.do("@STEP 50,7")
    assert both.courier.fault == ""
    assert both.far.registers == [7, 0, 0, 0, 0, 0]


def test_a_stop_holds_what_is_left_until_the_operator_moves_the_arm_again() -> None:
    both = Plugged(HIGH)
    rig, courier = both.rig, both.courier
    rig.type("@STEP 50,1200\r")
    while not both.far.steps:
        rig.run_for(0.01)
        courier.deliver()
    courier.stop()
    rig.run_for(0.4)
    sent = len(both.far.heard)
    rig.hold(["BREAK"], 0.2)
    both.wait()
    assert len(both.far.heard) == sent
    left = rig.registers[0] - both.far.registers[0]
    assert left > 0
    both.do("PRINT 1")
    assert len(both.far.heard) == sent, "printing is no motion"
    both.do("@STEP 50,0,5")
    assert tuple(both.far.registers) == rig.registers
    assert courier.fault == ""


def test_the_speed_that_is_sent_is_never_faster() -> None:
    for delay in range(28, 75):
        rate = 1000 / (1.2 + 0.03 * delay)
        assert delay <= delay_of(speed(rate)) <= delay + 3
    assert (speed(0.0), speed(1e9)) == (0, 245)


def test_a_motion_with_a_slip_is_not_sent_although_the_coils_are_off_by_then() -> None:
    both = Plugged()
    both.do("@STEP 45,-5")
    sent = list(both.far.registers)
    both.do("OUT 152,9:OUT 152,14:OUT 152,4:OUT 152,0")
    assert both.rig.state.slipped == (0,) * 6
    assert both.courier.fault == (
        "The arm on the wire was stopped before what befell the model: "
        "base slipped 8 steps: too fast."
    )
    assert both.far.registers == sent


statements = st.one_of(
    st.builds(
        lambda delay, counts: f"@STEP {delay},{','.join(map(str, counts))}",
        st.integers(45, 120),
        st.lists(st.integers(-60, 60), min_size=1, max_size=6),
    ),
    st.builds(
        lambda port, patterns: ":".join(f"OUT {port},{pattern}" for pattern in patterns),
        st.integers(152, 157),
        st.lists(st.integers(0, 15), min_size=1, max_size=9),
    ),
    st.sampled_from(["@RESET", "PRINT 1", "OUT 158,5", "FOR I=1 TO 300:NEXT"]),
)


@example(program=["@STEP 45,0,-10,55", "@STEP 45,0,-10,55", "@STEP 45,0,-27,27"], slices=0.004)
@example(
    program=["@STEP 45,-2", "@STEP 45,-3", "OUT 152,9:OUT 152,14:OUT 152,4:OUT 152,0"], slices=0.004
)
@settings(max_examples=40, deadline=None)
@given(program=st.lists(statements, max_size=5), slices=st.sampled_from([0.004, 0.05, 0.3]))
def test_whatever_moves_the_model_moves_the_arm_or_is_told(
    program: list[str], slices: float
) -> None:
    both = Plugged()
    zero = now(both)
    both.rig.watch_resets(lambda: zero.__setitem__(slice(None), now(both)))
    for statement in program:
        both.rig.type(statement + "\r")
        while both.rig.typing or both.rig.waiting.name != "COMMAND":
            both.rig.run_for(slices)
            both.courier.deliver()
    both.courier.finish()
    if both.courier.fault:
        assert both.courier.fault.endswith((".", "--plug-speed.", "--plug-range."))
    else:
        gone = [here - then for here, then in zip(now(both), zero, strict=True)]
        # At a stop the model's rotor is held back, by less than half a ring, or it would slip.
        off = [there - here for there, here in zip(both.far.registers, gone, strict=True)]
        assert all(abs(each) < RING // 2 for each in off), off
        assert not any(off) or any(motor.trouble is Reason.STOP for motor in both.rig.arm.motors)


def now(both: Plugged) -> list[int]:
    """Where the model's rotors stand."""
    return [motor.rotor for motor in both.rig.arm.motors]


@given(answers=st.lists(st.text(max_size=12), min_size=1, max_size=3))
def test_any_answers_are_a_fault_or_none_and_never_anything_else(answers: list[str]) -> None:
    far = FarSide()
    far.answer = lambda line: answers
    arm = FarArm(far, [*"abcdef"], 40)
    leg = Leg((1, 0, 0, 0, 0, -5), 100.0)
    faults = []
    for order in (Move(leg), Grip(leg), Zero(), Compare()):
        try:
            arm.do(order)
        except WireError as error:
            faults.append(str(error))
    assert all(fault.endswith(".") and "\n" not in fault for fault in faults)
