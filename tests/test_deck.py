"""The recorder as its operator sees it: counter, progress, searching for X, found Y."""

from __future__ import annotations

from trs80arm.deck import Deck, contents, contents_text
from trs80arm.machine.cassette import SystemRecording, encode_data, encode_program, encode_system
from trs80arm.rig import Rig, Waiting

LINE = (10, b"\x8f")
TWO = encode_program(ord("A"), [(n, b"\x93" * 20) for n in range(10, 500, 10)]) + encode_program(
    ord("B"), [LINE]
)


def test_what_is_on_a_cassette_is_named_in_order() -> None:
    tape = TWO + encode_data(b" 1 , 2 \r") + encode_system(SystemRecording(b"GAME", (), 0x5000))
    assert contents_text(tape) == "program A, program B, data, machine code GAME"
    assert contents_text(b"") == "blank"
    assert "damaged" in contents_text(TWO[:1000])
    starts = [recorded.start for recorded in contents(tape)]
    assert starts == sorted(starts)


def test_csave_is_told_with_how_much_of_it_is_done() -> None:
    rig = Rig()
    rig.load_text("10 REM " + "X" * 200)
    rig.type('CSAVE "A"\r')
    assert rig.run_until(lambda rig: rig.tape.running)
    began = Deck.of(rig)
    assert began.doing == "CSAVE on a cassette of its own"
    rig.run_for(4)
    later = Deck.of(rig)
    assert 0.3 < (later.done or 0) < 1
    assert later.progress == f"{later.doing} {later.done:.0%}"
    assert later.counter == "0:04 of 0:04"
    rig.run_until_waiting(30)
    assert Deck.of(rig).doing == ""


def test_a_search_tells_what_it_found_and_goes_on_to_what_is_wanted() -> None:
    rig = Rig()
    rig.insert_cassette("T", TWO)
    rig.type('CLOAD "B"\r')
    told = []

    def look(rig: Rig) -> bool:
        doing = Deck.of(rig).doing if rig.tape.running else ""
        if doing and doing not in told:
            told.append(doing)
        return rig.waiting is Waiting.COMMAND and bool(list(rig.basic.program.lines()))

    rig.run_until(look, 60)
    assert "CLOAD: searching for program B, found program A" in told
    assert told[-1] == "CLOAD: program B"
    assert [number for number, _ in rig.basic.program.lines()] == [10]


def test_a_tape_that_has_run_out_says_so() -> None:
    rig = Rig()
    rig.insert_cassette("T", TWO)
    rig.type('CLOAD "Z"\r')
    rig.run_for(60)
    assert Deck.of(rig).doing == (
        "CLOAD: searching for program Z; the tape is at its end, BREAK stops"
    )
    assert not rig.tape.passes


def test_a_cassette_put_in_while_the_machine_searches_is_read() -> None:
    rig = Rig()
    rig.type("CLOAD\r")
    rig.run_for(3)
    assert "searching for any program" in Deck.of(rig).doing
    rig.insert_cassette("T", encode_program(ord("B"), [LINE]))
    rig.run_until_waiting(30)
    assert [number for number, _ in rig.basic.program.lines()] == [10]


def test_input_from_tape_is_told() -> None:
    rig = Rig()
    rig.insert_cassette("D", encode_data(b" 42 \r"))
    rig.load_text("10 INPUT#-1,A")
    rig.type("RUN\r")
    assert rig.run_until(lambda rig: rig.tape.running and Deck.of(rig).done is not None)
    assert Deck.of(rig).doing == "INPUT#: data"


def test_a_cassette_of_millions_of_recordings_is_looked_at_no_further_than_is_told() -> None:
    assert contents_text(b"\xa5\x0d" * 1_000_000).endswith("data, and more")
