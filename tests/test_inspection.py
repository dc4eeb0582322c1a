"""What is in a machine's memory, seen from outside: listing, variables, paper."""

from __future__ import annotations

from tests.statements import done
from trs80arm.inspection import MOST_ELEMENTS, Inspection, Variable, line_text
from trs80arm.rig import Rig


def typed(*lines: str) -> Rig:
    return done(Rig(), *lines)


def test_a_machine_that_was_just_switched_on_has_nothing_in_memory() -> None:
    assert Inspection.of(Rig()) == Inspection()


def test_the_listing_is_as_list_shows_it() -> None:
    lines = Inspection.of(typed("10 print 1:goto 10", "20 REM x")).lines
    assert [line_text(line) for line in lines] == ["10 PRINT 1:GOTO 10", "20 REM X"]


def test_the_line_that_is_executed_next_is_known_while_a_program_runs() -> None:
    rig = typed("10 GOTO 20", "20 INPUT A")
    assert Inspection.of(rig).next_line is None
    done(rig, "RUN")
    assert Inspection.of(rig).next_line is not None


def test_variables_are_named_and_written_as_basic_does() -> None:
    rig = typed("A=1/3", "B%=-7", 'C$="HI"+"!"', "D#=1/3#", "DIM E(2)", "E(1)=5")
    assert Inspection.of(rig).variables == (
        Variable("A", " .333333"),
        Variable("B%", "-7"),
        Variable("C$", '"HI!"'),
        Variable("D#", " .3333333333333333"),
        Variable("E(2)", "0 5 0"),
    )


def test_of_a_long_array_the_beginning_is_shown() -> None:
    [array] = Inspection.of(typed("DIM A(500)")).variables
    assert array.value == " ".join(["0"] * MOST_ELEMENTS) + " ..."


def test_paper_and_cassettes_are_seen() -> None:
    rig = typed("10 REM", 'LPRINT "ONE"', 'LPRINT "TWO"', 'CSAVE "B"')
    seen = Inspection.of(rig)
    assert seen.paper == ("ONE", "TWO")
    assert seen.cassettes == ("B",)


def test_looking_changes_nothing() -> None:
    rig = typed("10 A=1:GOTO 10")
    before = rig.snapshot()
    Inspection.of(rig)
    assert rig.snapshot() == before
