"""The five statements in BASIC: arguments, errors, keys and BREAK, on the whole machine."""

from __future__ import annotations

import pytest

from trs80arm import Rig
from trs80arm.basic.activity import Waiting
from trs80arm.machine.card import CardSettings, Jumper, Latch
from trs80arm.machine.driver import DriverSettings, Mode
from trs80arm.rig import RigSettings


def direct(line: str, settings: RigSettings | None = None) -> tuple[Rig, list[str]]:
    """Type one line at the prompt of a fresh machine; the rig, and what it printed below it."""
    rig = Rig(settings)
    rig.type(line + "\r")
    rig.run_for(0.5)
    rig.run_until_waiting(60)
    screen = [text for text in rig.screen() if text]
    below = screen[
        max(k for k, text in enumerate(screen) if text.startswith(">" + line[:40])) + 1 :
    ]
    return rig, below


def error(line: str, settings: RigSettings | None = None) -> str | None:
    """The error that a line gives, or None."""
    _, below = direct(line, settings)
    return next((text for text in below if text.startswith("?")), None)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("@STEP -1,5", "?FC ERROR"),
        ("@CLOSE -1", "?FC ERROR"),
        ("@SET -1", "?FC ERROR"),
        ("@STEP 32768,5", "?OV ERROR"),
        ("@STEP 50,32768", "?OV ERROR"),
        ("@STEP 50,0,-32769", "?OV ERROR"),
        ('@STEP "A",5', "?TM ERROR"),
        ('@STEP 50,5,"A"', "?TM ERROR"),
        ('@CLOSE "A"', "?TM ERROR"),
        ("@SET A$", "?TM ERROR"),
        ("@READ A$", "?TM ERROR"),
        ("@READ A,B,C$(1)", "?TM ERROR"),
        ("@READ A(11)", "?BS ERROR"),
        ("@STEP", "?MO ERROR"),
        ("@STEP 50,", "?MO ERROR"),
        ("@STEP 50,1,2,3,4,5,6,7", "?SN ERROR"),
        ("@STEP 50,,5", "?SN ERROR"),
        ("@STEP 50 5", None),
        ("@STEP 50;5", "?SN ERROR"),
        ("@CLOSE 5,5", "?SN ERROR"),
        ("@SET 5,5", "?SN ERROR"),
        ("@RESET 1", "?SN ERROR"),
        ("@READ", "?SN ERROR"),
        ("@READ 5", "?SN ERROR"),
        ("@READ A,", "?SN ERROR"),
        ("@READ A,B,C,D,E,F,G", "?SN ERROR"),
        ("@PRINT", "?SN ERROR"),
        ("@", "?SN ERROR"),
        ("@ STEP 50,5", None),
        ("@STEP 50", None),
        ("IF 1 THEN @STEP 50,5 ELSE @RESET", None),
        ("@RESET:@STEP 50,5:@READ A", None),
    ],
)
def test_errors(line, message):
    assert error(line) == message


@pytest.mark.parametrize("line", ["@STEP 50,5", "@CLOSE", "@SET", "@RESET", "@READ A"])
def test_on_the_bare_rom_the_words_are_syntax_errors(line):
    assert error(line, RigSettings(armbasic=False)) == "?SN ERROR"


def test_nothing_moves_when_an_argument_is_wrong():
    rig, _ = direct("@STEP 50,100,200,1/0")
    assert rig.registers == (0,) * 6
    assert not rig.state.motors_on


def test_arguments_are_rounded_down():
    rig, _ = direct("@STEP 50,2.7,-10.5,.5,-.5,3.999999")
    assert rig.registers == (2, -11, 0, -1, 3, 0)


def test_registers_go_to_variables_of_any_numeric_type():
    rig, below = direct("@STEP 9,1,-2,3,-4,5,6:@READ A%,B!,C#,D(3),E#(1),F:?A%;B!;C#;D(3);E#(1);F")
    assert " 1 -2  3 -4  5  6" in below
    assert rig.registers == (1, -2, 3, -4, 5, 6)


def test_list_shows_the_statements_as_typed():
    rig = Rig()
    rig.type("10 @step 50,1:@close:@set 20:@reset:@read a\rLIST\r")
    rig.run_for(1)
    rig.run_until_waiting(20)
    assert "10 @STEP 50,1:@CLOSE:@SET 20:@RESET:@READ A" in rig.screen()


def test_break_leaves_manual_mode_to_ready():
    rig = Rig()
    rig.load_text("10 @SET\n20 PRINT 1\n")
    rig.type("RUN\r")
    rig.run_for(1)
    rig.run_until_waiting()
    assert rig.waiting is Waiting.SET
    rig.hold(["1"], 0.5)
    rig.run_for(0.6)
    rig.hold(["BREAK"], 0.2)
    rig.run_for(0.5)
    assert rig.waiting is Waiting.COMMAND
    text = [line for line in rig.screen() if line]
    assert [line.rstrip("_") for line in text[-3:]] == ["BREAK IN 10", "READY", ">"]
    assert rig.registers[0] == pytest.approx(185, abs=1)


def test_the_0_that_ends_manual_mode_is_not_typed_at_the_prompt():
    rig = Rig()
    rig.type("@SET\r")
    rig.run_for(0.7)
    assert rig.waiting is Waiting.SET
    rig.hold(["0", "1"], 0.3)
    rig.run_for(1)
    assert rig.waiting is Waiting.COMMAND
    assert [line for line in rig.screen() if line][-1] in (">", ">_")


def broken_step(break_now: bool) -> Rig:
    """A machine in which BREAK was held from 0.5 to 2.5 seconds into a move of 2.7."""
    rig = Rig(RigSettings(driver=DriverSettings(break_now=break_now)))
    rig.load_text("10 @STEP 50,1000\n20 PRINT 7\n30 GOTO 20\n")
    rig.type("RUN\r")
    rig.run_until(lambda rig: rig.driver.mode is Mode.STEP)
    rig.run_for(0.5)
    rig.hold(["BREAK"], 2.5)
    return rig


def test_break_during_a_step_is_seen_when_the_motion_has_ended():
    rig = broken_step(False)
    rig.run_for(2.1)
    assert rig.waiting is not Waiting.COMMAND
    rig.run_for(0.9)
    assert rig.waiting is Waiting.COMMAND
    assert rig.registers[0] == 1000
    assert "BREAK IN 10" in rig.screen()


def test_break_now_ends_a_step_at_once():
    rig = broken_step(True)
    rig.run_for(0.1)
    assert rig.waiting is Waiting.COMMAND
    assert 180 <= rig.registers[0] <= 195
    assert rig.joints == rig.registers
    assert "BREAK IN 10" in rig.screen()


def test_out_and_inp_reach_the_latches_that_the_driver_uses():
    rig, below = direct("@STEP 50,1:OUT 152,9:OUT 158,12:OUT 159,3:?INP(152)AND1;INP(159)")
    assert rig.card.latches == [9, 0, 0, 0, 0, 0, 12]
    assert rig.registers[0] == 1
    assert " 1  255" in below


@pytest.mark.parametrize(
    ("card", "line"),
    [
        (CardSettings(), "OUT 152,4:OUT 153,2"),
        (CardSettings(base=0xB8), "OUT 184,4:OUT 185,2"),
        (CardSettings(coil_bits=(0, 1, 2, 3)), "OUT 152,2:OUT 153,4"),
        (CardSettings(order=(Latch.SHOULDER, Latch.BASE, *[None] * 6)), "OUT 153,4:OUT 152,2"),
        (CardSettings(jumper=Jumper.PARALLEL), "OUT 152,4:OUT 152,18"),
    ],
    ids=["default", "base", "bit-order", "port-order", "parallel-jumper"],
)
def test_however_the_card_is_wired_out_and_the_driver_reach_the_same_coils(card, line):
    rig, _ = direct(line + ":@STEP 50,2,-3", RigSettings(card=card))
    # Rows 1 and 3 of Figure 8 by hand, then the driver's own rows 2 and -3.
    assert rig.card.latches[:3] == [0b0110, 0b1000, 0]
    assert rig.state.coils[:3] == (0b0110, 0b1000, 0)


def test_manual_mode_with_a_delay_of_its_own():
    rig = Rig()
    rig.type("@SET 200\r")
    rig.run_until(lambda rig: rig.waiting is Waiting.SET)
    rig.run_for(0.3)
    rig.hold(["2", "Y"], 1.0)
    rig.run_for(1.1)
    assert rig.registers[1] == pytest.approx(1000 / 7.2, abs=1)
    assert rig.registers[5] == -rig.registers[1]


def run(text: str) -> Rig:
    """Run a program to its end on a fresh machine, its hand closed and empty."""
    rig = Rig()
    rig.load_text(text)
    rig.type("RUN\r")
    rig.run_for(0.4)
    assert rig.run_until(lambda rig: rig.waiting is Waiting.COMMAND, 60)
    return rig


def test_an_empty_hand_closes_on_itself_and_a_closed_switch_ends_the_next_close_at_once():
    rig = run("10 @CLOSE\n20 @CLOSE\n")
    # 2 ounces at 52 steps a pound.
    assert rig.registers[5] == -7
    assert rig.state.switch_closed


def test_close_takes_up_a_slack_cable_first():
    """Raising the forearm with OUT alone pays out the cable of a hand that is wide open."""
    rig = run(
        "10 DIM P(7):FOR R=0 TO 7:READ P(R):NEXT:DATA 5,4,6,2,10,8,9,1\n"
        "20 @STEP 50,0,-200,0,0,0,1854\n"
        "30 FOR K=1 TO 80:OUT 154,P(K-INT(K/8)*8):NEXT\n"
        "40 @CLOSE\n"
    )
    assert rig.registers == (0, -200, 0, 0, 0, -80 - 7)
    assert rig.state.switch_closed
    assert rig.pose.opening == 0


def test_a_close_faster_than_the_hand_can_follow_goes_on_until_break():
    rig = Rig()
    rig.load_text("10 @STEP 50,0,0,0,0,0,600\n20 @CLOSE 0\n")
    rig.type("RUN\r")
    rig.run_for(20)
    assert rig.waiting is Waiting.NOTHING
    assert rig.registers[5] < -5000
    rig.hold(["BREAK"], 0.1)
    rig.run_for(0.5)
    assert rig.waiting is Waiting.COMMAND
    assert "BREAK IN 20" in rig.screen()


def test_the_elbow_does_not_change_the_opening():
    rig = run("10 @STEP 50,0,0,0,0,0,600\n20 @STEP 50,0,-100,400\n30 @STEP 50,0,0,-150,0,0,62\n")
    assert rig.pose.opening == pytest.approx(662 / 618, abs=0.002)
    assert rig.registers == rig.joints == (0, -100, 250, 0, 0, 662)
