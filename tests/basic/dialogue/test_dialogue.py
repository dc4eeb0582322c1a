"""The dialogue, statement by statement: prompts, typing, EDIT, AUTO, LIST, INPUT, tape, SYSTEM.

What is expected was seen on the original ROM, except where a test says that the machine of this
project is kinder than the ROM.
"""

from __future__ import annotations

import pytest

from tests.conformance.case import Entry, TimedKey
from tests.conformance.player import Session
from trs80arm.basic.activity import Waiting
from trs80arm.basic.dialogue.boot import MemorySize
from trs80arm.basic.dialogue.command import CommandLevel
from trs80arm.machine.z80 import chip
from trs80arm.rig import Rig, RigSettings


def say(session: Session, *lines: str, seconds: float = 30.0) -> str:
    """Type lines with ENTER, each when the machine waits; what it displayed."""
    for line in lines:
        session.play(Entry(line + "\r"), seconds)
    return session.transcript()


def strike(session: Session, keys: str) -> str:
    session.play(Entry(keys), 30.0)
    return session.transcript()


@pytest.fixture
def session() -> Session:
    return Session()


# -- power-on ------------------------------------------------------------------------------------


def test_memory_size_reserves_from_the_answer_on() -> None:
    rig = Rig(RigSettings(memory_size="30000", armbasic=False))
    assert rig.screen()[:4] == [
        "MEMORY SIZE? 30000",
        "RADIO SHACK LEVEL II BASIC",
        "READY",
        ">_",
    ]
    assert rig.memory.peek(0x40B1) | rig.memory.peek(0x40B2) << 8 == 29998


def test_memory_size_is_asked_until_the_answer_makes_sense(session: Session) -> None:
    session.rig.basic.state.stack[:] = [CommandLevel(), MemorySize()]
    session.wait(1.0)
    assert session.transcript() == "\x1c\x1fMEMORY SIZE? "
    assert strike(session, "\x01") == "\nMEMORY SIZE? "
    assert say(session, "ABC") == "ABC\n?SN Error\x1c\x1fMEMORY SIZE? "
    assert say(session, "17429") == "17429\n?OM Error\x1c\x1fMEMORY SIZE? "
    assert say(session, "40000") == "40000\nMEMORY SIZE? "
    assert say(session, "17430") == "17430\nRADIO SHACK LEVEL II BASIC\nREADY\n>"
    assert " 233 \n" in say(session, "PRINT MEM")


@pytest.mark.parametrize(("ram", "free"), [(4, 3284), (16, 15572), (32, 31956), (48, 48340)])
def test_free_memory_by_ram(ram: int, free: int) -> None:
    assert f" {free} \n" in say(Session(ram), "PRINT MEM")


# -- typing --------------------------------------------------------------------------------------


def test_ready_only_after_direct_commands(session: Session) -> None:
    assert say(session, "10 REM") == "10 REM\n>"
    assert say(session, "") == "\n>"
    assert say(session, "CLS") == "CLS\n\x1c\x1fREADY\n>"


def test_left_arrow_stops_at_the_start_and_at_a_line_feed(session: Session) -> None:
    assert strike(session, "AB\x08\x08\x08REM\nC\x08\x08\r") == "AB\x08\x08REM\nC\x08\nREADY\n>"


def test_a_typed_line_holds_240_characters(session: Session) -> None:
    shown = say(session, "REM" + "A" * 300)
    assert shown == "REM" + "A" * 237 + "\nREADY\n>"


def test_right_arrow_counts_columns_with_the_prompt(session: Session) -> None:
    assert strike(session, "REM\tX\r") == "REM    X\nREADY\n>"


def test_typed_line_lies_in_the_buffer(session: Session) -> None:
    say(session, "10 ABC")
    peek = session.rig.memory.peek
    start = peek(0x40A7) | peek(0x40A8) << 8
    assert bytes(peek(start + place) for place in range(3)) == b"10 "


# -- EDIT ----------------------------------------------------------------------------------------


def test_syntax_error_in_a_line_opens_edit_on_it(session: Session) -> None:
    say(session, "10 PRNT")
    assert say(session, "RUN") == "RUN\n?SN Error in 10\nREADY\n10 "
    assert session.rig.waiting is Waiting.EDIT


def test_quit_keeps_line_and_variables(session: Session) -> None:
    say(session, "10 PRINT 1", "A=5", "EDIT 10")
    assert strike(session, "3DQ") == "!PRI!\nREADY\n>"
    assert say(session, "PRINT A", "LIST").count(" 5 ") == 1
    assert "10 PRINT 1\n" in say(session, "LIST")


def test_end_of_an_edit_clears_variables(session: Session) -> None:
    say(session, "10 PRINT 1", "A=5", "EDIT 10")
    strike(session, "E")
    assert "\n 0 \n" in say(session, "PRINT A")


def test_count_of_a_command_is_a_byte(session: Session) -> None:
    say(session, "10 REM ABC", "EDIT 10")
    assert strike(session, "257 I!\r") == "R!EM ABC\n>"


# -- AUTO ----------------------------------------------------------------------------------------


def test_auto_stars_a_line_that_exists_and_enter_deletes_it(session: Session) -> None:
    say(session, "20 REM OLD")
    assert say(session, "AUTO 10,10") == "AUTO 10,10\n10 "
    assert strike(session, "REM\r") == "REM\n20*"
    assert strike(session, "\r\x01") == "\n30 \nREADY\n>"
    assert say(session, "LIST") == "LIST\n10 REM\nREADY\n>"


def test_auto_may_be_switched_on_by_poke(session: Session) -> None:
    say(session, "POKE 16612,5:POKE 16610,100:POKE 16609,1")
    assert session.rig.waiting is Waiting.AUTO
    assert strike(session, "\x01") == "\nREADY\n>"


# -- LIST, DELETE --------------------------------------------------------------------------------


def test_list_ends_a_running_program(session: Session) -> None:
    say(session, "10 LIST:PRINT 5")
    assert say(session, "RUN") == "RUN\n10 LIST:PRINT 5\nREADY\n>"


def test_break_ends_a_listing_without_a_line_number(session: Session) -> None:
    for number in range(10, 400, 10):
        say(session, f'{number} PRINT "SOME TEXT THAT TAKES A WHILE"')
    session.play(Entry("LIST\r", (TimedKey(0.5, ("BREAK",), 0.1),)), 30)
    assert session.transcript().endswith("\nBreak\nREADY\n>")


def test_delete_wants_its_last_line_to_exist(session: Session) -> None:
    say(session, "10 REM", "20 REM")
    assert "?FC Error" in say(session, "DELETE 10-15")
    assert "?FC Error" in say(session, "DELETE 10-")
    assert say(session, "PRINT 1;:DELETE -20") == "PRINT 1;:DELETE -20\n 1 READY\n>"


# -- INPUT ---------------------------------------------------------------------------------------


def test_subscripts_see_the_items_before_them(session: Session) -> None:
    say(session, "10 INPUT I,A(I):PRINT A(3)", "RUN")
    assert say(session, "3,7") == "3,7\n 7 \nREADY\n>"


def test_empty_answer_to_a_second_question_leaves_the_rest(session: Session) -> None:
    say(session, "10 B=9:INPUT A,B:PRINT A;B", "RUN", "1")
    assert say(session, "") == "\n 1  9 \nREADY\n>"


def test_input_into_a_double_reads_a_double(session: Session) -> None:
    say(session, "10 INPUT A#:PRINT A#", "RUN")
    assert say(session, ".1") == ".1\n .1 \nREADY\n>"


def test_bad_item_begins_the_whole_input_again(session: Session) -> None:
    say(session, '10 INPUT "N";A,B:PRINT A;B', "RUN")
    assert say(session, "1,X") == "1,X\n?REDO\nN? "
    assert say(session, "3,4") == "3,4\n 3  4 \nREADY\n>"


def test_cont_after_break_asks_again(session: Session) -> None:
    say(session, '10 INPUT "N";A:PRINT A', "RUN")
    assert strike(session, "12\x01") == "12\nBreak in 10\nREADY\n>"
    assert say(session, "CONT") == "CONT\nN? "


# -- the pause -----------------------------------------------------------------------------------


def test_key_that_ends_a_pause_is_inkeys(session: Session) -> None:
    say(session, "10 FOR I=1 TO 500:NEXT", '20 PRINT "(";INKEY$;")"')
    keys = (TimedKey(0.3, ("SHIFT", "@"), 0.1), TimedKey(1.0, ("Q",), 0.1))
    session.play(Entry("RUN\r", keys), 30)
    assert session.transcript().endswith("(Q)\nREADY\n>")


def test_paused_machine_says_so(session: Session) -> None:
    say(session, "10 GOTO 10")
    session.play(Entry("RUN\r", (TimedKey(0.3, ("SHIFT", "@"), 0.1),)), 2)
    assert session.rig.waiting is Waiting.PAUSE
    session.rig.run_for(100)
    assert session.rig.waiting is Waiting.PAUSE


# -- tape ----------------------------------------------------------------------------------------


def test_program_comes_back_from_tape(session: Session) -> None:
    say(session, '10 PRINT "X"', 'CSAVE "A"', "NEW", "A=5")
    assert say(session, 'CLOAD "A"') == 'CLOAD "A"\nREADY\n>'
    assert say(session, "PRINT A", "LIST").count('10 PRINT "X"\n') == 1


def test_cload_verifies(session: Session) -> None:
    say(session, "10 PRINT 1", 'CSAVE "A"')
    assert say(session, "CLOAD?") == "CLOAD?\nREADY\n>"
    say(session, "10 PRINT 2")
    assert say(session, "CLOAD?") == "CLOAD?\nBAD\nREADY\n>"


def test_stars_show_that_a_tape_is_being_read(session: Session) -> None:
    say(session, "10 REM", 'CSAVE "A"', "CLS:CLOAD")
    assert session.rig.screen()[0] == "READY" + " " * 57 + "**"


def test_break_ends_a_search_on_an_empty_tape_kinder_than_the_rom(session: Session) -> None:
    session.play(Entry("CLOAD\r", (TimedKey(5.0, ("BREAK",), 0.1),)), 20)
    assert session.transcript().endswith("Break\nREADY\n>")


def test_half_a_program_from_tape_is_none(session: Session) -> None:
    say(session, *(f'{number} PRINT "SOME TEXT"' for number in range(10, 100, 10)), 'CSAVE "A"')
    session.play(Entry("CLOAD\r", (TimedKey(5.0, ("BREAK",), 0.1),)), 20)
    assert session.transcript().endswith("Break\nREADY\n>")
    assert say(session, "LIST") == "LIST\nREADY\n>"


def test_items_of_a_recording(session: Session) -> None:
    say(session, '10 PRINT#-1,1,"A B","C,D",""', "RUN")
    say(session, "10 INPUT#-1,A,B$,C$,D$:PRINT A;B$;C$;D$")
    assert say(session, "RUN") == "RUN\n?Extra ignored\n 1 A BCD\nREADY\n>"
    say(session, "10 INPUT#-1,A,B$,C$,D$,E$,F$")
    assert say(session, "RUN") == "RUN\n?OD Error in 10\nREADY\n>"


@pytest.mark.parametrize(
    ("count", "deleted"),
    [("3", 3), ("256", 1), ("258", 2), ("300", 45), ("1022", 1), ("12345", 83)],
)
def test_a_count_of_edit_is_rotated_through_a_byte(
    session: Session, count: str, deleted: int
) -> None:
    text = "A" * 100
    say(session, f"10 {text}", "EDIT 10")
    shown = strike(session, f"{count}D")
    assert shown == f"!{text[:deleted]}!"


# -- SYSTEM --------------------------------------------------------------------------------------


@pytest.mark.parametrize("line", ["SYSTEMX", 'SYSTEM "CODE"', "SYSTEM 5:PRINT 6"])
def test_what_stands_behind_system_is_not_looked_at(session: Session, line: str) -> None:
    assert say(session, line) == f"{line}\n\n*? "
    assert session.rig.waiting is Waiting.SYSTEM


def test_system_leaves_by_the_roms_own_addresses(session: Session) -> None:
    assert say(session, "SYSTEM") == "SYSTEM\n\n*? "
    assert session.rig.waiting is Waiting.SYSTEM
    assert say(session, "/A") == "/A\n\n*? "
    assert say(session, "/6681") == "/6681\nREADY\n>"


@pytest.mark.parametrize(
    ("answer", "shown"),
    [
        (":X", ":X\n?SN Error\nREADY\n>"),
        ("/114:X", "/114:X\nREADY\n>"),
        ("/114 X", "/114 X\n\n*? "),
    ],
)
def test_a_colon_ends_an_answer_to_system(session: Session, answer: str, shown: str) -> None:
    say(session, "SYSTEM")
    assert say(session, answer) == shown


def test_without_the_extra_a_jump_to_code_is_fc_and_says_what_it_needs(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(chip, "available", lambda: False)
    say(session, "SYSTEM")
    assert say(session, "/32000") == (
        "/32000\nmachine code needs the extra z80: pip install 'trs80arm[z80]'\n?FC Error\nREADY\n>"
    )


def test_system_tape_is_loaded_where_it_says(session: Session) -> None:
    tape = session.rig.tape
    tape.start_writing()
    block = bytes((3, 0x00, 0x7D, 0xC9, 1, 2))
    for value in bytes(255) + b"\xa5\x55CODE  \x3c" + block + bytes((0x4B, 0x78, 0x00, 0x7D)):
        tape.write(value)
    tape.stop()
    say(session, "SYSTEM", "CODE")
    assert session.rig.waiting is Waiting.SYSTEM
    assert [session.rig.memory.peek(0x7D00 + place) for place in range(3)] == [0xC9, 1, 2]
    assert [session.rig.memory.peek(0x40DF + place) for place in range(2)] == [0x00, 0x7D]
