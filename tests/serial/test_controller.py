"""The arm behind a serial line: what is answered, what moves, and when."""

from __future__ import annotations

import pickle

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.serial.lab import HIGH, SETTINGS, Line
from trs80arm import Rig, RigSettings
from trs80arm.arm import benchfile
from trs80arm.machine.card import Latch
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.driver import Mode
from trs80arm.rig import NoControllerError, SnapshotError
from trs80arm.serial.controller import CHARACTER, WAITING
from trs80arm.serial.memory import Move
from trs80arm.serial.speeds import delay_of

HOLDING = HIGH + '[[part]]\nname = "block"\nat = [9, 0]\nsize = [1, 1, 1]\nweight = 2\n'


def seconds(speed: int, ticks: int) -> float:
    return ticks * (1.2 + 0.03 * delay_of(speed)) / 1000


# -- commands -------------------------------------------------------------------------------------


def test_step_moves_the_arm_and_counts() -> None:
    line = Line()
    begun = line.rig.pose
    assert line.send(b"@STEP 240,200,-100,50,10,-10,-20\r") == b"1\r"
    assert line.rig.registers == line.rig.joints == (200, -100, 50, 10, -10, -20)
    assert line.read()[:6] == [200, -100, 50, 10, -10, -20]
    assert line.send(b"@STEP 240,-200,100,-50,-10,10,20\r") == b"1\r"
    assert line.rig.pose == begun


def test_a_step_takes_its_real_time() -> None:
    line = Line()
    begun = line.controller.clock.now
    line.send(b"@STEP 183,300\r")
    took = (line.heard[-1][0] - begun) / T_STATES_PER_SECOND
    answer = 2 * CHARACTER / T_STATES_PER_SECOND
    assert took == pytest.approx(seconds(183, 300) + answer, abs=1e-5)
    assert took == pytest.approx(300 / 141, rel=0.01)


def test_several_commands_in_a_row_are_done_in_turn() -> None:
    line = Line()
    assert line.send(b"@STEP 240,10\r@STEP 240,0,-10\r", b"@REA", b"D\r\n@NO\r") == (
        b"1\r1\r1\r10,-10,0,0,0,0,255\r0\r"
    )
    first, second = (time for time, _ in line.heard[:2])
    assert (second - first) / T_STATES_PER_SECOND >= seconds(240, 10)


def test_close_ends_where_the_switch_closes_and_read_tells_of_it() -> None:
    line = Line()
    assert line.read()[6] & 1 == 1
    assert line.send(b"@CLOSE\r") == b"1\r"
    *counts, inputs = line.read()
    assert counts[5] == pytest.approx(-2 * 370.8, abs=10)
    assert inputs == 0xFE
    assert line.rig.pose.opening == pytest.approx(0, abs=0.05)


def test_out_goes_to_the_auxiliary_latch_whatever_was_sent() -> None:
    line = Line()
    for sent, held in ((b"5", 5), (b"885465860", 885465860 & 15), (b"-1", 15), (b"0", 0)):
        assert line.send(b"@STEP 240,0,0,0,0,0,0," + sent + b"\r") == b"1\r"
        assert line.rig.card.latches[Latch.AUXILIARY] == held
    line.send(b"@STEP 240,0,0,0,0,0,0,9\r", b"@STEP 240,1\r")
    assert line.rig.card.latches[Latch.AUXILIARY] == 9


def test_reset_clears_the_registers_and_takes_the_current_off() -> None:
    line = Line()
    line.send(b"@STEP 240,5,5,5,5,5,5\r")
    assert any(line.rig.card.latches[:6])
    assert line.send(b"@RESET, 0\r") == b"1\r"
    assert line.read()[:6] == [0] * 6
    assert not any(line.rig.card.latches[:6])


def test_a_program_written_is_dumped_as_it_was_and_run() -> None:
    line = Line()
    rows = [
        Move(240, (50, 0, 0, 0, 0, 0)).row(1),
        Move(200, (50, -40, 0, 0, 0, 0)).row(2),
        Move(240, (-20, 0, 0, 0, 0, 0)).row(7),
    ]
    texts = [",".join(map(str, row)).encode() for row in rows]
    assert line.send(*(b"@QWRITE " + text + b"\r" for text in texts)) == b"1\r1\r1\r"
    assert line.send(b"@QDUMP\r") == b"1\r" + b"".join(text + b"\r" for text in texts)
    begun = line.controller.clock.now
    assert line.send(b"@RUN\r") == b"1\r"
    assert line.rig.registers == line.rig.joints == (-20, 0, 0, 0, 0, 0)
    took = (line.controller.clock.now - begun) / T_STATES_PER_SECOND
    assert took >= seconds(240, 50) + seconds(200, 40) + seconds(240, 70)
    assert line.send(b"@QWRITE 54,1,0,0,0,0,0,0\r") == b"0\r"


def test_an_empty_memory() -> None:
    line = Line()
    assert line.send(b"@QDUMP\r@RUN\r") == b"1\r1\r"


def test_commands_begin_with_the_character_that_arm_chose() -> None:
    line = Line()
    assert line.send(b"@ARM # \r@READ\r#RESET\r") == b"1\r0\r1\r"


def test_delay_makes_answers_slower() -> None:
    line = Line()
    line.send(b"@DELAY 50\r")
    begun = line.controller.clock.now
    line.send(b"@RESET\r")
    took = (line.heard[-1][0] - begun) / T_STATES_PER_SECOND
    assert took == pytest.approx(2 * (0.05 + 10 / 9600), abs=1e-4)


# -- the pendant ----------------------------------------------------------------------------------


def test_set_hands_the_arm_to_the_pendant_until_a_function_key() -> None:
    line = Line()
    rig = line.rig
    rig.receive(b"@SET 200\r")
    rig.run_for(0.5)
    assert rig.driver.mode is Mode.SET
    assert rig.registers == (0, 0, 0, 0, 0, 0)
    rig.press_pendant("BASE_PLUS")
    rig.press_pendant("PITCH_PLUS")
    rig.run_for(0.5)
    rig.release_pendant("BASE_PLUS")
    rig.run_for(0.25)
    rig.release_pendant("PITCH_PLUS")
    rig.run_for(0.5)
    rate = 1 / seconds(200, 1)
    base, shoulder, elbow, right, left, hand = rig.registers
    assert (base, right, left) == pytest.approx((rate / 2, -rate * 3 / 4, -rate * 3 / 4), abs=2)
    assert (shoulder, elbow, hand) == (0, 0, 0)
    assert line.answers == b""
    rig.press_pendant("MOVE")
    line.wait()
    assert line.answers == b"1\r"
    assert line.read()[6] == 6 * 256 + 255
    rig.press_pendant("BASE_PLUS")
    rig.run_for(0.5)
    assert rig.registers[0] == base


def test_the_stop_key_breaks_a_motion_off_and_all_that_waits() -> None:
    line = Line()
    line.rig.receive(b"@STEP 200,500\r@STEP 200,500\r@CLOSE\r@NO")
    line.rig.run_for(0.5)
    line.rig.press_pendant("STOP")
    standing = line.rig.registers
    assert 0 < standing[0] < 500
    line.rig.receive(b"NSENSE\r")
    line.wait()
    assert line.answers == b"2\r2\r2\r0\r"
    assert line.rig.registers == line.rig.joints == standing
    assert any(line.rig.card.latches[:6]), "the motors hold"
    assert line.read()[6] == 7 * 256 + 255
    assert line.send(b"@STEP 240,1\r") == b"1\r"


def test_the_stop_key_ends_set_and_a_program() -> None:
    line = Line()
    line.send(
        b"@QWRITE " + ",".join(map(str, Move(200, (900, 0, 0, 0, 0, 0)).row(1))).encode() + b"\r"
    )
    for sent in (b"@SET\r", b"@RUN\r"):
        line.heard.clear()
        line.rig.receive(sent)
        line.rig.run_for(0.2)
        line.rig.press_pendant("STOP")
        line.wait()
        assert line.answers == b"2\r"
    assert line.rig.registers[0] < 900


def test_the_stop_key_on_an_arm_at_rest_is_only_remembered() -> None:
    line = Line()
    line.rig.press_pendant("STOP")
    line.wait()
    assert line.answers == b""
    assert line.send(b"@STEP 240,1\r") == b"1\r"


def test_keys_that_no_pendant_has() -> None:
    line = Line()
    with pytest.raises(ValueError, match="no key 'ENTER'"):
        line.rig.press_pendant("ENTER")


# -- the line -------------------------------------------------------------------------------------


def test_who_hangs_up_in_mid_motion_stops_the_arm() -> None:
    line = Line()
    line.rig.receive(b"@STEP 240,400\r@STEP 240,0,-400\r@STEP 240,")
    line.rig.run_for(0.3)
    line.rig.hang_up()
    standing = line.rig.registers
    assert 0 < standing[0] < 400
    line.rig.run_for(3)
    assert line.answers == b""
    assert line.rig.registers == line.rig.joints == standing
    assert line.send(b"1\r@READ\r").startswith(b"0\r1\r")


def test_every_line_of_a_flood_is_answered_and_few_are_held() -> None:
    line = Line()
    line.rig.receive(b"@READ\r" * 5000)
    assert line.controller.room == 0
    line.rig.receive(b"@RESET\r")
    line.wait()
    assert line.answers.count(b"1\r0,0,0,0,0,0,255\r") == WAITING
    assert line.answers.count(b"0\r") == 5001 - WAITING
    assert line.controller.room == WAITING


def test_an_arm_without_a_computer_has_no_line_and_no_pendant() -> None:
    rig = Rig()
    assert rig.controller is None
    for reach in (
        lambda: rig.receive(b"@READ\r"),
        rig.hang_up,
        lambda: rig.press_pendant("STOP"),
        lambda: rig.release_pendant("STOP"),
    ):
        with pytest.raises(NoControllerError):
            reach()


# -- beside the TRS-80 ----------------------------------------------------------------------------


def test_the_trs_80_has_neither_card_nor_armbasic_and_runs_beside_it() -> None:
    line = Line()
    rig = line.rig
    rig.load_text(
        '10 FOR I=1 TO 300:OUT 152,I AND 15:NEXT\n20 PRINT "INPUT";INP(152)\n30 @STEP 50,9'
    )
    rig.receive(b"@STEP 200,300\r")
    rig.type("RUN\r")
    rig.run_until_waiting()
    line.wait()
    assert line.rig.registers == line.rig.joints == (300, 0, 0, 0, 0, 0)
    assert any("?SN ERROR IN 30" in row for row in rig.screen()), rig.screen()
    assert rig.events == []


def test_the_trs_80_can_be_switched_off_in_mid_motion() -> None:
    line = Line()
    line.rig.receive(b"@STEP 200,300\r")
    line.rig.run_for(0.4)
    line.rig.reset()
    line.wait()
    assert line.answers == b"1\r"
    assert line.rig.registers == line.rig.joints == (300, 0, 0, 0, 0, 0)


def test_another_bench_breaks_a_motion_off() -> None:
    line = Line()
    line.rig.receive(b"@STEP 200,300\r@READ\r")
    line.rig.run_for(0.4)
    line.rig.set_bench(benchfile.parse(HIGH, "bench"))
    line.wait()
    assert line.answers == b"2\r2\r"
    assert line.rig.registers == (0, 0, 0, 0, 0, 0)


# -- the same however it is cut -------------------------------------------------------------------

SESSION: list[tuple[float, str, tuple[object, ...]]] = [
    (0.1, "receive", (b"@STEP 230,60,-50,20,3,-4,-200\r@CLO",)),
    (0.2, "receive", (b" 235\r@QWRITE 1,5121,0,0,0,0,0,0\r",)),
    (1.9, "receive", (b"@RUN\r@SET 210\r@READ\r@noise\r",)),
    (2.5, "press_pendant", ("ELBOW_PLUS",)),
    (3.4, "press_pendant", ("ROLL_PLUS",)),
    (4.0, "release_pendant", ("ELBOW_PLUS",)),
    (4.5, "press_pendant", ("OUT",)),
    (5.0, "receive", (b"@STEP 100,400\r@READ\r",)),
    (5.6, "press_pendant", ("STOP",)),
    (5.7, "receive", (b"@STEP 240,-100,0,0,0,0,0,3\r",)),
    (5.8, "hang_up", ()),
]
END = 6.5


def session(
    cuts: list[float], moves: set[int] = frozenset()
) -> tuple[bytes, list[tuple[int, bytes]]]:  # type: ignore[assignment]
    """The machine after the session and what was answered, run in slices that end at `cuts`."""
    line = Line(bench=HOLDING)
    rig, heard = line.rig, line.heard
    begun = rig.time
    todo = sorted([*SESSION, *((cut, "", ()) for cut in [*cuts, END])], key=lambda each: each[0])
    for number, (time, action, arguments) in enumerate(todo):
        rig.run_to(round((begun + time) * T_STATES_PER_SECOND))
        if number in moves:
            state = rig.snapshot()
            line = Line()
            rig = line.rig
            rig.restore(state)
            line.heard = heard
        if action:
            getattr(rig, action)(*arguments)
    return rig.snapshot(), heard


@settings(max_examples=15)
@given(
    st.lists(st.floats(0, END), max_size=12),
    st.sets(st.integers(0, 20), max_size=3),
)
def test_the_same_in_slices_and_taken_up_elsewhere(cuts: list[float], moves: set[int]) -> None:
    whole, heard = session([])
    cut, heard_cut = session(cuts, moves)
    assert heard_cut == heard
    assert cut == whole


def test_the_session_is_one_in_which_something_happens() -> None:
    _, heard = session([])
    assert [answer for _, answer in heard][:5] == [b"1\r"] * 5
    assert b"".join(answer for _, answer in heard).count(b"2\r") == 2


def test_what_is_done_over_the_line_can_be_recorded_and_done_again() -> None:
    line = Line()
    inputs: list[object] = []
    line.rig.record(inputs.append)
    line.rig.receive(b"@STEP 220,80\r")
    line.rig.run_for(0.1)
    line.rig.press_pendant("STOP")
    line.rig.run_for(0.1)
    line.rig.release_pendant("STOP")
    line.rig.hang_up()
    again = Line()
    again.rig.replay(inputs)  # type: ignore[arg-type]
    assert again.rig.snapshot() == line.rig.snapshot()
    assert again.heard == line.heard


def test_works_with_a_computer_in_the_arm_can_be_copied() -> None:
    rigs = [Rig(SETTINGS) for _ in range(3)]
    assert len({rig.snapshot() for rig in rigs}) == 1
    line = Line(rigs[2])
    line.rig.receive(b"@STEP 220,80\r")
    line.rig.run_for(0.1)
    controller = pickle.loads(pickle.dumps(line.controller))
    assert controller.busy
    assert controller.driver.registers == line.rig.registers


def test_an_arm_of_the_other_make_can_have_a_computer_too() -> None:
    line = Line(Rig(RigSettings(controller=True), benchfile.parse(HIGH, "bench")))
    assert line.send(b"@STEP 230,100,0,50\r") == b"1\r"
    assert line.rig.registers == line.rig.joints == (100, 0, 50, 0, 0, 0)


@pytest.mark.parametrize(
    ("place", "value"),
    [
        ("_lines", 7),
        ("_lines", b"x" * 256),
        ("_stopped", 5),
        ("delimiter", "@@"),
        ("delay", -1),
        ("speed", 300),
        ("last_key", 15),
        ("held", "BASE_PLUS"),
        ("memory", (2, 0, 0, 0, 0, 0, 0, 0)),
        ("memory", (1, -1, 0, 0, 0, 0, 0, 0)),
    ],
)
def test_a_snapshot_of_a_computer_that_cannot_be_is_refused(place: str, value: object) -> None:
    line = Line()
    line.rig.receive(b"@STEP 200,900\r@READ\r")
    line.rig.run_for(0.2)
    controller = line.controller
    assert controller.possible
    Rig().restore(line.rig.snapshot())
    match place:
        case "_lines":
            controller._lines.append(value)  # type: ignore[arg-type]
        case "held":
            controller.held.add(value)  # type: ignore[arg-type]
        case "memory":
            controller.memory.rows[1] = value  # type: ignore[assignment]
        case _:
            setattr(controller, place, value)
    assert not controller.possible
    with pytest.raises(SnapshotError):
        Rig().restore(line.rig.snapshot())
