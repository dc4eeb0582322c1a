"""The TeachMover's teach pendant: what its keys do, and the memory behind them."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.block_bench import BLOCK
from tests.serial.lab import SETTINGS, Line
from tests.serial.test_endpoints import Nobody
from trs80arm import Rig
from trs80arm.arm import benchfile
from trs80arm.machine.card import Latch
from trs80arm.serial.instructions import (
    Close,
    Instruction,
    Jump,
    PutOut,
    Rest,
    instruction_of,
    told,
)
from trs80arm.serial.memory import STEPS, Move, row_of
from trs80arm.serial.pendant import AT_WORK, DIGITS, PendantMode, sp_of
from trs80arm.serial.pendant_keys import FunctionKey, JointKey
from trs80arm.serial.serving import Server
from trs80arm.serial.speeds import delay_of

NAMES = {str(digit): key.name for key, digit in DIGITS.items()}


class Hand:
    """Somebody with the pendant in the hand."""

    def __init__(self, bench: str | None = None) -> None:
        self.line = Line() if bench is None else Line(bench=bench)
        self.rig = self.line.rig
        self.base = self.line.controller

    @property
    def pendant(self):  # type: ignore[no-untyped-def]
        return self.base.pendant

    def press(self, *keys: str) -> Hand:
        """Function keys, numbers as digits, or `BASE_PLUS:0.5` held for so many seconds."""
        for key in keys:
            name, _, seconds = key.partition(":")
            if seconds:
                self.rig.press_pendant(name)
                self.rig.run_for(float(seconds))
                self.rig.release_pendant(name)
                self.rig.run_for(0.01)
            elif key.isdigit():
                self.press(*(NAMES[digit] for digit in key), "RUN")
            else:
                self.rig.press_pendant(name)
                self.rig.release_pendant(name)
                self.rig.run_for(0.01)
        return self

    def wait(self) -> Hand:
        self.line.wait()
        return self

    @property
    def program(self) -> list[str]:
        return [f"{row[0]} {told(row)}" for row in self.base.memory]


def test_joint_keys_move_the_arm_in_move_and_train_and_not_before() -> None:
    hand = Hand()
    hand.press("BASE_PLUS:0.5")
    assert hand.rig.registers == (0,) * 6
    hand.press("MOVE", "BASE_PLUS:0.5")
    base = hand.rig.registers[0]
    assert base == pytest.approx(500 / (1.2 + 0.03 * delay_of(221)), abs=2)
    hand.press("TRAIN", "BASE_MINUS:0.5", "GRIP_PLUS:0.1")
    assert hand.rig.registers[0] == pytest.approx(0, abs=2)
    assert hand.rig.registers[5] > 0
    hand.press("STOP", "BASE_PLUS:0.5")
    assert hand.pendant.mode is PendantMode.OFF
    assert hand.rig.registers[0] == pytest.approx(0, abs=2)
    assert hand.program == [], "nothing was recorded"


def test_speed_3_makes_141_half_steps_a_second() -> None:
    hand = Hand().press("SPEED", "3", "MOVE", "BASE_PLUS:1")
    assert hand.base.speed == sp_of(3) == 183
    assert hand.rig.registers[0] == pytest.approx(141, abs=2)
    assert [delay_of(sp_of(n)) for n in range(1, 10)] == sorted(
        (delay_of(sp_of(n)) for n in range(1, 10)), reverse=True
    )


def test_a_program_is_taught_and_run_round_and_round() -> None:
    hand = Hand().press("TRAIN", "TRAIN", "BASE_PLUS:0.3", "TRAIN", "PAUSE", "2")
    first, second = (Move.of(row).position for row in hand.base.memory.dump()[:2])
    assert first == (0,) * 6
    assert second[0] > 50
    assert hand.program[2] == "3 pause 2 s"
    hand.press("POINT", "1", "RUN")
    begun = hand.rig.time
    seen = set()
    while hand.rig.time < begun + 8:
        hand.rig.run_for(0.05)
        seen.add((hand.pendant.pointer, hand.rig.registers[0]))
    assert {place for place, _ in seen} >= {1, 2, 3}
    bases = [base for _, base in seen]
    assert (min(bases) < 20, max(bases)) == (True, second[0])
    assert hand.base.busy
    hand.press("STOP")
    assert not hand.base.busy


def test_step_does_one_step_and_goes_to_the_next() -> None:
    hand = Hand().press("TRAIN", "BASE_PLUS:0.2", "TRAIN", "BASE_PLUS:0.2", "TRAIN")
    end = hand.rig.registers
    hand.press("POINT", "1", "STEP").wait()
    assert hand.rig.registers[0] < end[0]
    assert hand.pendant.pointer == 2
    hand.press("STEP").wait()
    assert hand.rig.registers == end
    assert hand.pendant.pointer == 3
    hand.press("STEP").wait()
    assert hand.pendant.pointer == 2, "behind the last step comes the first"


def test_grip_out_and_free_are_done_at_once_and_taught_in_train() -> None:
    hand = Hand(BLOCK).press("GRIP").wait().press("OUT", "5")
    assert hand.rig.state.switch_closed
    assert hand.rig.card.latches[Latch.AUXILIARY] == 5
    assert hand.program == []
    registers = hand.rig.registers
    hand.press("FREE")
    assert not hand.rig.state.motors_on
    assert hand.rig.registers == registers
    hand.press("TRAIN", "GRIP").wait().press("OUT", "12")
    assert hand.program == ["1 grip", "2 out 12"]
    assert hand.rig.card.latches[Latch.AUXILIARY] == 12


def test_zero_makes_here_the_place_that_registers_count_from() -> None:
    hand = Hand().press("MOVE", "BASE_PLUS:0.2", "ZERO")
    assert hand.rig.registers == hand.rig.joints == (0,) * 6
    assert hand.rig.state.motors_on


def test_a_jump_is_made_when_its_condition_holds() -> None:
    hand = Hand(BLOCK).press("TRAIN", "JUMP", "3", "4", "PAUSE", "1", "OUT", "9")
    assert hand.program == ["1 jump to 3 if it grips", "2 pause 1 s", "3 out 9"]
    hand.press("POINT", "1", "STEP").wait()
    assert hand.pendant.pointer == 2, "it grips nothing yet"
    hand.press("STOP", "GRIP").wait().press("POINT", "1", "STEP").wait()
    assert hand.pendant.pointer == 3


@pytest.mark.parametrize("there", [True, False])
def test_inputs_are_conditions_too(there: bool) -> None:
    pad = "[[tactile]]\nbit = 2\nat = [4, 7]\nsize = [2, 2]\nheight = 0\n"
    part = '[[part]]\nname = "b"\nat = [4, 7]\nsize = [1, 1, 1]\nweight = 4\n'
    rig = Rig(SETTINGS, benchfile.parse(pad + (part if there else "")))
    rig.run_for(0.5)
    base = rig.controller
    assert base is not None
    assert [base.holds(each) for each in (0, 1, 2, 3, 7)] == [True, False, there, False, False]


def test_clear_wants_run_and_anything_else_leaves_the_memory() -> None:
    hand = Hand().press("TRAIN", "TRAIN", "CLEAR")
    assert hand.pendant.wanted == "RUN clears the memory"
    hand.press("STOP")
    assert len(hand.program) == 1
    hand.press("CLEAR", "RUN")
    assert hand.program == []
    assert hand.pendant.pointer == 1


def test_a_number_that_cannot_be_is_told_and_changes_nothing() -> None:
    hand = Hand().press("TRAIN", "POINT", "60")
    assert hand.pendant.note == "step: 1 to 53, not 60"
    assert hand.pendant.pointer == 1
    hand.press("OUT", "TRAIN", "STEP", "SPEED", "CLEAR", "7")
    assert hand.rig.card.latches[Latch.AUXILIARY] == 7
    assert hand.program == ["1 out 7"]


def test_a_step_taught_at_the_pointer_takes_the_place_of_what_was_there() -> None:
    hand = Hand().press("TRAIN", "OUT", "1", "OUT", "2", "POINT", "1", "OUT", "3")
    assert hand.program == ["1 out 3", "2 out 2"]
    assert hand.pendant.pointer == 2


def test_behind_the_last_step_the_memory_is_full() -> None:
    hand = Hand().press("TRAIN", "POINT", str(STEPS), "OUT", "1", "OUT", "2")
    assert hand.pendant.note == "the memory is full"
    assert hand.program == [f"{STEPS} out 1"]
    assert hand.rig.card.latches[Latch.AUXILIARY] == 1


def test_what_was_taught_is_dumped_and_what_is_written_is_run() -> None:
    hand = Hand().press("TRAIN", "BASE_PLUS:0.2", "TRAIN", "PAUSE", "1", "STOP")
    dumped = hand.line.send(b"@QDUMP\r")
    rows = [row for row in dumped.split(b"\r")[1:] if row]
    assert len(rows) == 2
    base = hand.rig.registers[0]
    other = Hand()
    for row in rows:
        assert other.line.send(b"@QWRITE " + row + b"\r") == b"1\r"
    assert other.line.send(b"@QDUMP\r") == dumped
    assert other.line.send(b"@RUN\r") == b"1\r"
    assert other.rig.registers[0] == base


def test_a_function_key_ends_what_joint_keys_that_are_still_held_do() -> None:
    hand = Hand().press("TRAIN")
    hand.rig.press_pendant("BASE_PLUS")
    hand.rig.run_for(0.3)
    hand.press("TRAIN")
    standing = hand.rig.registers
    hand.rig.run_for(0.3)
    assert hand.rig.registers == standing
    assert Move.of(hand.base.memory.dump()[0]).position == standing
    hand.rig.release_pendant("BASE_PLUS")
    hand.press("BASE_PLUS:0.2")
    assert hand.rig.registers[0] > standing[0]


def test_numbers_can_be_typed_while_the_hand_closes_and_are_taken_when_it_has() -> None:
    hand = Hand().press("TRAIN", "GRIP", "PAUSE", NAMES["4"], "RUN")
    assert hand.pendant.note == AT_WORK
    assert hand.program == ["1 grip"]
    hand.wait().press("RUN")
    assert hand.program == ["1 grip", "2 pause 4 s"]
    hand.press("RUN")
    hand.press("ZERO", "OUT")
    assert hand.pendant.note == AT_WORK
    assert hand.pendant.asks is None


def test_a_line_waits_until_the_pendant_has_done() -> None:
    hand = Hand().press("MOVE")
    hand.rig.press_pendant("BASE_PLUS")
    hand.rig.receive(b"@STEP 240,0,-30\r")
    hand.rig.run_for(0.5)
    assert hand.line.answers == b""
    assert hand.rig.registers[1] == 0
    hand.rig.release_pendant("BASE_PLUS")
    hand.wait()
    assert hand.line.answers == b"1\r"
    assert hand.rig.registers[1] == -30


def test_the_pendant_waits_while_a_command_of_the_line_is_done() -> None:
    hand = Hand()
    hand.rig.receive(b"@STEP 200,300\r")
    hand.rig.run_for(0.1)
    hand.press("TRAIN", "BASE_MINUS:0.1")
    hand.wait()
    assert hand.rig.registers[0] == 300
    assert hand.pendant.mode is PendantMode.OFF


instructions = st.one_of(
    st.builds(Move, st.integers(0, 255), st.tuples(*[st.integers(-32768, 32767)] * 6)),
    st.just(Close()),
    st.builds(PutOut, st.integers(0, 15)),
    st.builds(Rest, st.integers(0, 255)),
    st.builds(Jump, st.integers(1, STEPS), st.integers(0, 4)),
)


@given(instruction=instructions, number=st.integers(1, STEPS))
def test_an_instruction_comes_back_from_its_row(instruction: Instruction, number: int) -> None:
    row = instruction.row(number)
    assert row_of(row) == row
    assert row[0] == number
    assert instruction_of(row) == instruction
    assert told(row)


@given(row=st.tuples(*[st.integers(0, 65535)] * 8))
def test_any_row_says_something(row: tuple[int, ...]) -> None:
    assert told(row)  # type: ignore[arg-type]


keys = st.sampled_from([*(key.name for key in FunctionKey), *(key.name for key in JointKey)])
doings = st.lists(
    st.tuples(st.sampled_from(["press", "release"]), keys, st.sampled_from([0.0, 0.02, 0.2])),
    max_size=40,
)


@settings(max_examples=40, deadline=None)
@given(doings=doings)
def test_any_keys_leave_an_arm_that_can_be_stopped_and_a_program_that_can_be_read(
    doings: list[tuple[str, str, float]],
) -> None:
    line = Line()
    rig, base = line.rig, line.controller
    for what, key, seconds in doings:
        (rig.press_pendant if what == "press" else rig.release_pendant)(key)
        rig.run_for(seconds)
        assert 1 <= base.pendant.pointer <= STEPS + 1
        assert base.pendant.wanted is not None
    again = Rig(SETTINGS)
    again.restore(rig.snapshot())
    assert again.snapshot() == rig.snapshot()
    rig.press_pendant("STOP")
    line.wait()
    assert not base.busy
    rows = [row for row in line.send(b"@QDUMP\r").split(b"\r")[1:] if row]
    assert len(rows) == len(base.memory)
    other = Line()
    other.send(*(b"@QWRITE " + row + b"\r" for row in rows))
    assert other.controller.memory.dump() == base.memory.dump()


def test_in_lines_names_are_keys_and_numbers_answer_what_is_asked_for(
    capsys: pytest.CaptureFixture[str],
) -> None:
    rig = Rig(SETTINGS)
    server = Server(rig, Nobody(), 1.0)
    for typed in ("train", "pause", "12", "jump", "1", "4", "", "12"):
        server.press(typed)
        rig.run_for(0.1)
    assert rig.controller is not None
    assert [told(row) for row in rig.controller.memory] == ["pause 12 s", "jump to 1 if it grips"]
    out, err = capsys.readouterr()
    assert out.splitlines()[1:4] == [
        "Mode TRAIN   Step 1   SP 221   PAUSE: seconds, 0 to 255",
        "Mode TRAIN   Step 2   SP 221   step 1",
        "Mode TRAIN   Step 2   SP 221   JUMP: step, 1 to 53",
    ]
    assert "the pendant has no key '12'" in err, "no number is asked for"
