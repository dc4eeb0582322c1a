"""The debugger without a screen: stopping, stepping, looking, changing, going back."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.sixty_lines import LISTING
from trs80arm import inspection
from trs80arm.desk import recording
from trs80arm.desk.debugger import Condition, Debugger, Reason, Stop
from trs80arm.desk.session import Session
from trs80arm.rig import ChangeError, RigSettings, Waiting

SUBROUTINES = (
    "10 GOSUB 100:A=1\n20 GOSUB 100\n30 END\n100 B=B+1\n110 GOSUB 200\n120 RETURN\n200 RETURN\n"
)
MOVING = """\
5 @STEP 10,0,-300
10 FOR I=1 TO 3
20 @STEP 9,8*I,-4,0,0,0,0:@STEP 9,-8*I,0,0,9,9,9
30 A=A+I:B$="I IS"+STR$(I)
40 IF A>2 THEN GOSUB 100
50 NEXT:@READ J1,J2,J3
60 GOTO 10
100 LPRINT A;RND(9)
110 RETURN
"""


class Desk:
    """A session with a debugger and a program that runs."""

    def __init__(self, listing: str, settings: RigSettings | None = None) -> None:
        self.session = Session(settings)
        self.debugger = Debugger(self.session)
        self.session.rig.load_text(listing)

    def run(self, seconds: float = 5.0) -> Desk:
        """Type RUN, and let time pass until the machine stands."""
        self.session.rig.type("RUN\r")
        return self.pass_time(seconds)

    def pass_time(self, seconds: float) -> Desk:
        for _ in range(round(seconds * 50)):
            self.session.run_for(0.02)
            self.debugger.new_stop()
        return self

    @property
    def stop(self) -> Stop:
        """Why it stands; it has to."""
        assert self.debugger.stop is not None
        return self.debugger.stop

    @property
    def line(self) -> int | None:
        return None if self.stop.spot is None else self.stop.spot.line

    def value(self, name: str) -> str:
        return inspection.value_text(self.session.rig, name)


def stopped(listing: str, line: int, settings: RigSettings | None = None) -> Desk:
    """A desk whose machine stands before a line."""
    desk = Desk(listing, settings)
    desk.debugger.set(line)
    return desk.run()


# -- stopping --------------------------------------------------------------------------------------


def test_a_breakpoint_stops_before_its_line() -> None:
    desk = stopped("10 A=1\n20 A=2\n30 A=3\n", 20)
    assert (desk.line, desk.value("A")) == (20, "1")
    assert desk.stop.reason is Reason.BREAKPOINT


def test_no_time_passes_while_it_stands() -> None:
    desk = stopped("10 A=1\n20 GOTO 10\n", 20)
    now = desk.session.rig.clock.now
    desk.pass_time(1)
    assert desk.session.rig.clock.now == now


def test_a_condition_is_looked_at_each_time() -> None:
    desk = Desk('10 FOR I=1 TO 9\n20 A$=A$+"X"\n30 NEXT\n')
    desk.debugger.set(20, "i > 4")
    assert desk.run().value("I") == "5"
    desk.debugger.set(20, 'A$="XXXXXX"')
    desk.debugger.go()
    assert desk.pass_time(1).value("I") == "7"


@pytest.mark.parametrize("text", ["", "I", "I>", ">3", "I=>3", "5=I", "I>10:GOTO 5"])
def test_what_compares_nothing_is_no_condition(text: str) -> None:
    with pytest.raises(ValueError):
        Condition.parse(text)


def test_a_condition_on_what_is_not_there_does_not_hold_and_makes_nothing() -> None:
    desk = Desk("10 A=1\n20 B=2\n")
    desk.debugger.set(20, "Q(3)=0")
    desk.run(2)
    assert desk.debugger.stop is None
    assert not desk.session.rig.basic.state.variables.arrays


def test_a_breakpoint_stays_with_its_line_when_others_are_typed() -> None:
    desk = Desk("10 A=1\n20 A=2\n")
    desk.debugger.set(20)
    desk.session.rig.type("5 B=7\r15 B=8\r")
    desk.session.rig.run_until_waiting()
    assert desk.run().line == 20


def test_there_is_no_breakpoint_without_a_line() -> None:
    with pytest.raises(ValueError, match="no line 25"):
        Desk("10 A=1\n").debugger.set(25)


def test_breakpoints_are_listed_in_order_and_taken_off() -> None:
    debugger = Desk(SUBROUTINES).debugger
    for line in (100, 20, 110):
        debugger.toggle(line)
    debugger.toggle(20)
    assert list(debugger.breakpoints) == [100, 110]
    debugger.clear()
    assert not debugger.breakpoints
    with pytest.raises(ValueError):
        debugger.clear(100)


def test_nobody_is_asked_while_there_is_nothing_to_stop_for() -> None:
    desk = stopped("10 A=1\n20 GOTO 10\n", 20)
    conditions = desk.session.rig._observers.stops.conditions
    assert conditions
    desk.debugger.clear()
    desk.debugger.go()
    assert not conditions


# -- stepping --------------------------------------------------------------------------------------


def test_each_statement_of_a_line_is_one() -> None:
    desk = stopped("10 A=1:B=2:C=3\n20 D=4\n", 10)
    spots = []
    for _ in range(4):
        spot = desk.debugger.spot
        assert spot is not None
        spots.append((spot.line, spot.number, spot.text))
        desk.debugger.into()
    assert spots == [(10, 1, "A=1"), (10, 2, "B=2"), (10, 3, "C=3"), (20, 1, "D=4")]


def test_a_statement_stands_where_its_line_shows_it() -> None:
    desk = stopped('10 PRINT "A:B":GOTO 10\n', 10)
    desk.debugger.into()
    spot = desk.debugger.spot
    assert spot is not None
    line = inspection.line_text(desk.session.rig.basic.program.lines()[0])
    assert line[spot.start : spot.stop] == spot.text == "GOTO 10"


def test_into_over_and_out_of_gosub() -> None:
    desk = stopped(SUBROUTINES, 10)
    desk.debugger.into()
    assert desk.line == 100
    desk.debugger.out()
    assert (desk.line, desk.debugger.spot and desk.debugger.spot.number) == (10, 2)
    desk.debugger.into()
    desk.debugger.over()
    assert desk.line == 30
    with pytest.raises(ValueError, match="no subroutine"):
        desk.debugger.out()


def test_a_breakpoint_in_a_subroutine_stops_a_step_over_it() -> None:
    desk = stopped(SUBROUTINES, 10)
    desk.debugger.set(200)
    desk.debugger.over()
    assert desk.line == 200


def test_on_to_a_line() -> None:
    desk = stopped(SUBROUTINES, 10)
    desk.debugger.run_to(120)
    assert desk.line == 120
    assert "B" in {variable.name for variable in inspection.elements(desk.session.rig, 4)}


def test_a_motion_ends_before_the_next_statement() -> None:
    desk = stopped("10 @STEP 40,300\n20 A=1\n", 10)
    desk.debugger.into()
    assert (desk.line, desk.session.rig.registers[0]) == (20, 300)


def test_where_an_answer_is_wanted_it_stops_behind_it() -> None:
    desk = stopped("10 INPUT A\n20 B=A\n", 10)
    desk.debugger.into()
    assert desk.debugger.stop is None
    assert desk.debugger.waits_to_stop
    assert desk.session.waiting is Waiting.INPUT
    desk.session.rig.type("42\r")
    assert desk.pass_time(2).line == 20
    assert desk.value("A") == "42"


def test_manual_mode_goes_on_until_it_is_left() -> None:
    desk = stopped("10 @SET\n20 B=1\n", 10)
    desk.debugger.into()
    assert desk.session.waiting is Waiting.SET
    desk.session.rig.type("0")
    assert desk.pass_time(2).line == 20


def test_a_direct_line_is_done_by_statements_too() -> None:
    desk = Desk("10 A=1\n")
    desk.debugger.into()
    desk.session.rig.type("B=1:C=2\r")
    desk.pass_time(2)
    assert str(desk.debugger.spot) == "the direct line: B=1"
    desk.debugger.into()
    assert str(desk.debugger.spot) == "the direct line: C=2"


def test_an_error_stops_it_at_the_statement() -> None:
    desk = stopped("10 A=1\n20 B=1:A=1/0\n", 10)
    desk.debugger.go()
    desk.pass_time(1)
    assert desk.stop.spot is not None
    assert (desk.stop.text, desk.stop.spot.text) == ("?/0 Error in 20", "A=1/0")
    desk.debugger.back()
    assert str(desk.debugger.spot) == "20 (statement 2): A=1/0"


def test_break_stops_it_at_the_line() -> None:
    desk = stopped("10 A=1\n20 GOTO 20\n", 10)
    desk.debugger.go()
    desk.pass_time(0.1)
    desk.session.rig.hold(["BREAK"], 0.2)
    desk.pass_time(1)
    assert (desk.stop.text, desk.line) == ("Break in 20", 20)


def test_who_only_runs_a_program_is_left_alone() -> None:
    desk = Desk("10 A=1/0\n").run(2)
    assert desk.debugger.stop is None


def test_the_end_ends_a_step() -> None:
    desk = stopped("10 A=1\n", 10)
    desk.debugger.into()
    assert desk.stop.text == "The program has ended"


# -- looking and changing --------------------------------------------------------------------------


def test_variables_of_all_types_and_elements_are_seen() -> None:
    desk = stopped('10 A=1.5:B%=3:C$="HI":D#=2:E(1)=7\n20 DIM F$(2,3):F$(1,2)="X"\n30 END\n', 30)
    seen = {each.name: each.value for each in inspection.elements(desk.session.rig, 12)}
    assert seen["C$"] == '"HI"'
    assert seen["F$(1,2)"] == '"X"'
    assert [desk.value(name) for name in ("a", "B%", "D#", "E(1)", "F$(1,2)")] == [
        "1.5",
        "3",
        "2",
        "7",
        '"X"',
    ]


def test_open_loops_and_subroutines_are_seen() -> None:
    desk = stopped("10 FOR I=1 TO 9 STEP 2\n20 GOSUB 50\n50 A=1\n", 50)
    assert inspection.open_frames(desk.session.rig) == ["20  GOSUB", "10  FOR I TO 9 STEP 2"]


def test_a_variable_is_changed_as_the_machine_would() -> None:
    desk = stopped('10 A%=1:B$="X":DIM C(3)\n20 A%=A%+1\n30 END\n', 20)
    rig = desk.session.rig
    now = rig.clock.now
    for statement in ("A%=40", 'B$="LONGER"', "C(2)=1/4", "N#=1"):
        rig.change(statement)
    assert rig.clock.now == now
    assert [desk.value(name) for name in ("A%", "B$", "C(2)", "N#")] == [
        "40",
        '"LONGER"',
        ".25",
        "1",
    ]
    desk.debugger.into()
    assert desk.value("A%") == "41"


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        ("A%=40000", "?OV Error"),
        ('A%="X"', "?TM Error"),
        ("B$=5", "?TM Error"),
        ("C(4)=1", "?BS Error"),
        ("POKE 1,256", "?FC Error"),
        ("A%=1:B=2", "one statement at a time"),
        ("GOTO 10", "only an assignment"),
        ("A%=INP(1)", "INP takes time"),
        ("", "only an assignment"),
        ("A%=", "?MO Error"),
    ],
)
def test_what_the_machine_refuses_changes_nothing(statement: str, said: str) -> None:
    desk = stopped('10 A%=1:B$="X":DIM C(3)\n20 A%=A%+1\n', 20)
    before = desk.session.rig.snapshot()
    with pytest.raises(ChangeError, match=said.replace("?", r"\?")):
        desk.session.rig.change(statement)
    assert desk.session.rig.snapshot() == before


def test_what_the_direct_line_holds_survives_a_change() -> None:
    desk = Desk("10 A=1\n")
    desk.debugger.into()
    desk.session.rig.type("B=1:C=B+D\r")
    desk.pass_time(2)
    desk.debugger.into()
    desk.session.rig.change("D=41")
    desk.debugger.into()
    assert desk.value("C") == "42"


def test_a_change_can_be_recorded_and_played() -> None:
    desk = stopped("10 A=1\n20 B=A\n30 GOTO 30\n", 20)
    desk.session.rig.change("A=7")
    desk.debugger.clear()
    desk.debugger.go()
    desk.pass_time(1)
    end = desk.session.rig.clock.now
    played = recording.parse("\n".join(desk.session.recorded).encode())
    rig = played.rig()
    rig.replay(played.inputs)
    for each in (rig, desk.session.rig):
        each.run_to(end)
    assert rig.snapshot() == desk.session.rig.snapshot()


# -- back ------------------------------------------------------------------------------------------


def test_the_mistake_is_found_two_statements_back() -> None:
    desk = stopped(LISTING, 220)
    rig = desk.session.rig
    assert desk.value("I") == "5"
    there = rig.snapshot()
    time, registers, screen = rig.clock.now, rig.registers, rig.screen()
    desk.debugger.back()
    desk.debugger.back()
    assert str(desk.debugger.spot) == "550: NEXT I"
    assert desk.value("I") == "4"
    desk.debugger.into()
    desk.debugger.into()
    assert (rig.clock.now, rig.registers, rig.screen()) == (time, registers, screen)
    assert rig.snapshot() == there


@settings(max_examples=3, deadline=None)
@given(
    begin=st.integers(6, 40), steps=st.integers(1, 12), back=st.integers(1, 12), fused=st.booleans()
)
def test_steps_back_lead_to_where_one_was(begin: int, steps: int, back: int, fused: bool) -> None:
    desk = Desk(MOVING, RigSettings(blocks=fused))
    rig, debugger = desk.session.rig, desk.debugger
    rig.type("RUN\r")
    desk.pass_time(begin / 20)
    debugger.into()
    there = [rig.snapshot()]
    for _ in range(steps):
        debugger.into()
        there.append(rig.snapshot())
    for place in range(steps - 1, max(-1, steps - 1 - back), -1):
        assert debugger.back()
        assert rig.snapshot() == there[place]
    place = max(0, steps - back)
    for forward in range(place + 1, steps + 1):
        debugger.into()
        assert rig.snapshot() == there[forward]


@pytest.mark.parametrize("fused", [True, False])
def test_a_program_that_was_stepped_has_the_run_of_one_that_was_not(fused: bool) -> None:
    stepped, ran = Desk(MOVING, RigSettings(blocks=fused)), Desk(MOVING)
    for desk in (stepped, ran):
        desk.session.rig.type("RUN\r")
        desk.session.run_for(0.5)
    for _ in range(60):
        stepped.debugger.into()
    ran.session.rig.run_to(stepped.session.rig.clock.now)
    assert ran.session.rig.screen() == stepped.session.rig.screen()
    assert ran.session.rig.clock.now == stepped.session.rig.clock.now
    assert ran.session.rig.registers == stepped.session.rig.registers
    assert ran.session.rig.state == stepped.session.rig.state
    assert ran.session.rig.memory.ram == stepped.session.rig.memory.ram


def test_back_out_of_the_middle_of_a_motion() -> None:
    desk = Desk("10 A=1\n20 @STEP 100,500\n30 GOTO 30\n")
    desk.session.rig.type("RUN\r")
    desk.session.rig.run_until(lambda rig: rig.registers[0] > 200)
    assert desk.debugger.back()
    assert (desk.line, desk.session.rig.registers[0]) == (20, 0)
    desk.debugger.into()
    assert (desk.line, desk.session.rig.registers[0]) == (30, 500)


def test_back_to_the_breakpoint_before() -> None:
    desk = Desk("10 FOR I=1 TO 900\n20 A=A+I\n30 NEXT\n40 GOTO 40\n")
    desk.debugger.set(20, "I=3")
    desk.run()
    desk.debugger.go()
    desk.pass_time(4)
    assert desk.debugger.back_to_stop()
    assert (desk.value("I"), desk.value("A")) == ("3", "3")


def test_before_the_first_statement_there_is_nothing() -> None:
    desk = Desk("10 A=1\n")
    assert not desk.debugger.back()
    assert desk.debugger.stop is None


def test_what_was_changed_is_part_of_the_history() -> None:
    desk = stopped("10 A=1\n20 B=A\n30 C=B\n40 END\n", 20)
    desk.session.rig.change("A=7")
    desk.debugger.into()
    desk.debugger.into()
    desk.debugger.back()
    desk.debugger.back()
    assert desk.value("A") == "7"
    desk.debugger.back()
    assert desk.line == 10
    desk.debugger.into()
    desk.debugger.into()
    assert desk.value("B") == "7"


def test_an_answer_is_given_again_on_the_way_forward() -> None:
    desk = stopped("10 INPUT A\n20 B=A*2\n30 GOTO 30\n", 10)
    desk.debugger.into()
    desk.session.rig.type("21\r")
    desk.pass_time(2)
    desk.debugger.into()
    there = desk.session.rig.snapshot()
    for _ in range(2):
        desk.debugger.back()
    assert desk.line == 10
    for _ in range(2):
        desk.debugger.into()
    assert desk.session.rig.snapshot() == there


def test_manual_mode_is_driven_again_on_the_way_forward() -> None:
    desk = stopped("10 @SET\n20 B=1\n30 GOTO 30\n", 10)
    desk.debugger.into()
    desk.session.rig.hold(["1"], 0.5)
    desk.pass_time(1)
    desk.session.rig.type("0")
    desk.pass_time(1)
    there = desk.session.rig.snapshot()
    assert desk.session.rig.registers[0] > 0
    assert desk.debugger.back()
    assert desk.session.rig.registers[0] == 0
    desk.debugger.into()
    assert desk.line == 20
    assert desk.session.rig.snapshot() == there


def test_who_does_something_else_in_the_past_makes_another_future() -> None:
    desk = stopped("10 INPUT A\n20 B=A*2\n30 GOTO 30\n", 10)
    desk.debugger.into()
    desk.session.rig.type("21\r")
    desk.pass_time(2)
    desk.debugger.back()
    assert desk.session.timeline.behind
    desk.session.rig.change("A=1")
    assert not desk.session.timeline.behind
    desk.debugger.into()
    desk.session.rig.type("4\r")
    desk.pass_time(2)
    assert desk.value("A") == "4"


# -- watches ---------------------------------------------------------------------------------------


def changes(desk: Desk, count: int) -> list[str]:
    """What the next stops say."""
    said = []
    for _ in range(count):
        stop = desk.debugger.stop
        assert stop is not None
        assert stop.reason is Reason.WATCH
        said.append(stop.text)
        desk.debugger.go()
        desk.pass_time(2)
    return said


def test_a_watch_stops_behind_each_change_of_a_variable() -> None:
    desk = Desk("10 FOR I=1 TO 3\n20 A=I*I\n30 NEXT\n40 A=9\n50 END\n")
    desk.debugger.watch("a")
    desk.run()
    assert changes(desk, 3) == [
        "A none -> 1: before 30: NEXT",
        "A 1 -> 4: before 30: NEXT",
        "A 4 -> 9: before 30: NEXT",
    ]
    # 9 for 9 is no change.
    assert desk.debugger.stop is None


def test_a_latch_is_watched_through_out_and_through_a_motion_that_ends_where_it_began() -> None:
    desk = Desk("10 OUT 152,9\n20 OUT 153,1\n30 @STEP 20,16\n40 END\n")
    desk.debugger.watch("latch  Base")
    desk.run()
    first, second = changes(desk, 2)
    assert first.startswith("latch base ")
    assert first.endswith("-> 1001: before 20: OUT 153,1")
    assert "16 times changed: before 40: END" in second or "17 times changed" in second


def test_a_byte_of_memory_is_watched() -> None:
    desk = Desk("10 POKE 20000,7\n20 POKE 20000,8\n30 END\n")
    desk.debugger.watch("4E20H")
    desk.run()
    assert changes(desk, 2)[1] == "4E20H 7 -> 8: before 30: END"


def test_a_watch_goes_back_in_time_with_the_machine() -> None:
    desk = Desk("10 A=1\n20 B=1\n30 A=2\n40 B=2\n50 GOTO 10\n")
    desk.debugger.watch("A")
    desk.run()
    desk.debugger.go()
    desk.pass_time(1)
    stop = desk.debugger.stop
    assert stop is not None
    assert desk.debugger.back()
    assert desk.debugger.back()
    desk.debugger.go()
    desk.pass_time(1)
    assert desk.debugger.stop == stop


@pytest.mark.parametrize("text", ["", "latch nose", "+", "99999", "A B C D(", "3G00H"])
def test_what_cannot_be_watched_is_told(text: str) -> None:
    debugger = Desk("10 END\n").debugger
    with pytest.raises(ValueError) as failed:
        debugger.watch(text)
    assert "\n" not in str(failed.value)
    assert not debugger.watches


def test_a_watch_is_taken_off_by_its_name_and_by_clearing_all() -> None:
    desk = Desk("10 A=1\n20 A=2\n30 END\n")
    assert desk.debugger.toggle_watch("A")
    assert not desk.debugger.toggle_watch("a")
    with pytest.raises(ValueError, match="A is not watched"):
        desk.debugger.unwatch("A")
    desk.debugger.watch("latch hand")
    desk.debugger.clear()
    desk.run()
    assert desk.debugger.stop is None


def test_a_watch_outlives_the_machine() -> None:
    desk = Desk("10 A=1\n20 END\n")
    desk.debugger.watch("A")
    desk.session.rig.reset()
    desk.session.rig.load_text("10 A=5\n20 END\n")
    desk.run()
    assert desk.debugger.stop is not None
    assert desk.debugger.stop.text == "A none -> 5: before 20: END"
