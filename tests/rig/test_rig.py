"""The public door: boot, typing, keys, snapshots, what is seen."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trs80arm import Rig, RigSettings
from trs80arm.arm import benchfile
from trs80arm.arm.by_hand import MotorsOn
from trs80arm.basic.activity import Waiting
from trs80arm.rig import Input


def test_the_machine_boots_to_the_real_banner() -> None:
    rig = Rig()
    assert rig.waiting is Waiting.COMMAND
    assert rig.screen()[:4] == ["MEMORY SIZE?", "RADIO SHACK LEVEL II BASIC", "READY", ">_"]


def test_typed_lines_arrive_however_fast_they_are_typed() -> None:
    rig = Rig()
    rig.type('10 PRINT "HELLO"\r20 GOTO 40\r30 PRINT "NO"\r40 PRINT 1;2\rRUN\r')
    rig.run_until_waiting()
    assert rig.screen()[8:12] == ["HELLO", " 1  2", "READY", ">_"]


def test_break_stops_a_program() -> None:
    rig = Rig()
    rig.load_text("10 GOTO 10")
    rig.type("RUN\r")
    rig.run_for(3)
    assert rig.waiting is Waiting.NOTHING
    rig.hold(["BREAK"], 0.1)
    rig.run_for(0.5)
    assert rig.waiting is Waiting.COMMAND
    assert "BREAK IN 10" in rig.screen()


def test_a_key_that_the_machine_lacks_is_refused() -> None:
    with pytest.raises(ValueError, match="F1"):
        Rig().press("F1")


def test_a_run_is_the_same_however_it_is_sliced() -> None:
    ends = set()
    for step in (0.5, 1 / 60, 0.00037):
        rig = Rig()
        rig.load_text("10 FOR I=1 TO 30:@STEP 20,I,-I:PRINT RND(100);:NEXT:GOTO 10")
        rig.type("RUN\r")
        target = rig.clock.now + 5 * 1_774_080
        while rig.clock.now < target:
            rig.run_to(min(target, rig.clock.now + round(step * 1_774_080)))
        ends.add((rig.clock.now, tuple(rig.screen()), rig.registers, rig.joints))
    assert len(ends) == 1


def sliced(rig: Rig, seconds: float, slices: int) -> None:
    for _ in range(slices):
        rig.run_for(seconds / slices)


def test_letting_go_in_the_middle_of_typing_is_the_same_however_it_is_sliced() -> None:
    ends = set()
    for slices in (1, 2, 30, 60):
        rig = Rig()
        rig.type("PRINT 1\rPRINT 2\r")
        sliced(rig, 0.5, slices)
        rig.release_all()
        sliced(rig, 3, slices)
        ends.add(rig.snapshot())
    assert len(ends) == 1
    assert ">PRINT PRINT 2" in rig.screen()


@settings(max_examples=25, deadline=None)
@given(
    st.lists(
        st.tuples(
            st.sampled_from(["type", "program", "hold", "release_all", "stop_typing", "press"]),
            st.sampled_from([0.0625, 0.125, 0.25, 0.75, 1.5]),
        ),
        min_size=1,
        max_size=8,
    ),
    st.sampled_from([2, 8, 32]),
)
def test_whatever_the_operator_does_it_is_the_same_however_it_is_sliced(
    script: list[tuple[str, float]], slices: int
) -> None:
    whole, cut = Rig(), Rig()
    for rig, count in ((whole, 1), (cut, slices)):
        for what, seconds in script:
            if what == "type":
                rig.type("PRINT 1\rPRINT 2\rA$=INKEY$:PRINT A$\r")
            elif what == "program":
                rig.load_text("10 PRINT RND(9);:IF INKEY$<>CHR$(13) THEN 10\n20 INPUT A:GOTO 10")
                rig.type("RUN\r5\r")
            elif what == "hold":
                rig.hold(["BREAK"], 0.1)
            elif what == "press":
                rig.press("A")
            else:
                getattr(rig, what)()
            sliced(rig, seconds, count)
    assert cut.snapshot() == whole.snapshot()


def test_a_snapshot_in_the_middle_of_a_motion_goes_on_as_if_nothing_had_been() -> None:
    rig = Rig()
    rig.load_text("10 @STEP 100,400,-200:@CLOSE:PRINT 1/3:GOTO 10")
    rig.type("RUN\r")
    rig.run_for(1.2345)
    snapshot = rig.snapshot()
    rig.run_for(3)
    first = (rig.clock.now, rig.screen(), rig.registers, rig.state)
    other = Rig()
    other.restore(snapshot)
    other.run_for(3)
    assert (other.clock.now, other.screen(), other.registers, other.state) == first


def test_a_recorded_session_replays_to_the_same_end() -> None:
    rig = Rig()
    log: list[Input] = []
    stop = rig.record(log.append)
    rig.type("@SET\r")
    rig.run_for(1)
    rig.press("1")
    rig.run_for(0.3)
    rig.press("W")
    rig.run_for(0.2)
    rig.release("1")
    rig.release("W")
    rig.hold(["0"], 0.1)
    rig.run_for(1)
    stop()
    again = Rig()
    again.replay(log)
    again.run_to(rig.clock.now)
    assert again.registers == rig.registers != (0, 0, 0, 0, 0, 0)
    assert again.screen() == rig.screen()


def test_switching_off_and_on_leaves_the_arm_where_it_is() -> None:
    rig = Rig()
    rig.type("@STEP 50,200,-100,50\r")
    rig.run_until_waiting()
    pose = rig.pose
    rig.reset()
    assert rig.pose == pose
    assert rig.registers == (0, 0, 0, 0, 0, 0)
    assert not rig.state.motors_on
    assert rig.screen()[0] == "MEMORY SIZE?"


def test_register_and_joint_part_when_a_motor_slips() -> None:
    rig = Rig()
    rig.type("@STEP 0,400\r")
    rig.run_until_waiting()
    assert rig.registers[0] == 400
    assert rig.joints[0] < 400
    assert (rig.registers[0] - rig.joints[0]) % 8 == 0


def test_without_armbasic_the_words_are_syntax_errors() -> None:
    rig = Rig(RigSettings(armbasic=False))
    rig.type("@RESET\r")
    rig.run_until_waiting()
    assert "?SN ERROR" in rig.screen()


def test_single_step_does_one_statement_and_a_motion_to_its_end() -> None:
    rig = Rig()
    rig.load_text("10 A=1:B=2\n20 @STEP 50,37\n30 GOTO 10\n")
    rig.type("RUN\r")
    rig.run_until(lambda rig: rig.basic.next_line is not None)
    lines = []
    while len(lines) < 12:
        lines.append(rig.step_statement())
        if rig.registers[0] == 37:
            break
    assert lines[-1] == 30
    assert rig.registers[0] % 37 == 0


def test_a_new_bench_is_set_up_with_the_motors_off() -> None:
    rig = Rig()
    rig.type("@STEP 50,200\r")
    rig.run_until_waiting()
    bench = benchfile.parse("[[part]]\nname = 'cube'\nat = [9, 1]\nsize = [1, 1, 1]\nweight = 1\n")
    rig.set_bench(bench)
    assert rig.registers == rig.joints == (0, 0, 0, 0, 0, 0)
    assert not rig.state.motors_on
    assert list(rig.arm.bench.parts) == ["cube"]


def test_hand_moving_wants_the_motors_off() -> None:
    rig = Rig()
    rig.move_joint("base", 30)
    assert rig.pose.y > 2
    rig.type("@STEP 50,1\r")
    rig.run_until_waiting()
    with pytest.raises(MotorsOn):
        rig.move_joint("base", 0)


def test_the_parts_go_back_to_where_they_were() -> None:
    rig = Rig()
    rig.load_text("10 @STEP 50,0,-207,290:@STEP 50,0,0,0,0,0,370:@STEP 50,0,132,-36:@CLOSE")
    rig.type("RUN\r")
    rig.run_until_waiting()
    assert rig.state.held == "block"
    rig.type("@STEP 100,0,-132,36\r@STEP 100,300\r@STEP 100,0,0,0,0,0,200\r")
    rig.run_until_waiting()
    moved = rig.arm.bench.parts["block"].box
    rig.refill()
    assert rig.arm.bench.parts["block"].box != moved


def test_typing_that_is_stopped_stops_in_the_middle_of_a_line() -> None:
    rig = Rig()
    rig.type('10 PRINT "ABCDEFGHIJKLMNOPQRSTUVWXYZ"\r20 PRINT 2\r')
    assert rig.run_until(lambda rig: any("ABCD" in line for line in rig.screen()), 10)
    assert 45 > rig.to_type > 25
    rig.stop_typing()
    assert rig.to_type == 0
    rig.hold(["BREAK"], 0.1)
    rig.run_for(10)
    assert not rig.held
    assert not rig.typing
    assert list(rig.basic.program.lines()) == []
    assert rig.waiting is Waiting.COMMAND
    rig.type("PRINT 6*7\r")
    rig.run_until_waiting()
    assert " 42" in rig.screen()


@pytest.mark.parametrize("moment", [0.0, 0.03, 0.09, 0.13, 0.2])
def test_typing_that_is_stopped_leaves_no_key_down(moment: float) -> None:
    rig = Rig()
    rig.hold(["A"], 0.5)
    rig.type('"!#$%&\r')
    rig.run_for(moment)
    rig.stop_typing()
    rig.run_for(0.15)
    assert rig.held == {"A"}
    rig.run_for(0.5)
    assert rig.held == frozenset()


@pytest.mark.parametrize(
    ("ram", "lines", "seen"),
    [
        (16, ['A$="A":V=VARPTR(A$):POKE V+1,255:POKE V+2,255:POKE V,9:B$=A$+""', "PRINT PEEK(-1)"],
         " 255"),
        (48, ['A$="A"+"":POKE VARPTR(A$),9:B$=A$+"":PRINT LEN(B$)'], " 9"),
        (48, ['10 A$="A"+"":V=VARPTR(A$):POKE V+1,250:POKE V+2,255:POKE V,255:B$=A$+""', "RUN"],
         None),
        (16, ["10 POKE -1,44:POKE 16639,255:POKE 16640,255:READ A", "RUN"], "?OD ERROR IN 10"),
        (48, ["10 POKE -1,44:POKE 16639,255:POKE 16640,255:READ A", "RUN"], "?SN ERROR IN 0"),
        (48, ["10 POKE -1,34:POKE -2,44:POKE 16639,254:POKE 16640,255:READ A$", "RUN"], None),
    ],
)  # fmt: skip
def test_strings_and_data_at_the_end_of_memory_are_read_around_it(
    ram: int, lines: list[str], seen: str | None
) -> None:
    rig = Rig(RigSettings(ram_kib=ram))
    for line in lines:
        rig.type(line + "\r")
        rig.run_until_waiting()
    if seen is not None:
        assert seen in rig.screen()
    rig.type("\x01PRINT 7\r")
    rig.run_until_waiting()
    assert " 7" in rig.screen()
    assert len(rig.memory.ram) == 65536


def test_a_literal_longer_than_a_descriptor_can_say_has_a_length_of_one_byte() -> None:
    rig = Rig()
    rig.load_text(f'10 A$="{"X" * 300}":PRINT PEEK(VARPTR(A$));LEN(A$)')
    rig.type("RUN\r")
    rig.run_until_waiting()
    assert " 44  44" in rig.screen()
