"""Programs of the period run as they did on the machine they were written for."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.conformance.case import Entry, entry
from tests.conformance.player import Session
from trs80arm.basic.activity import Waiting
from trs80arm.machine.clock import T_STATES_PER_SECOND

FOLDER = Path(__file__).parent / "programs"
NAMES = sorted(path.stem for path in FOLDER.glob("*.bas"))
LONGEST = 120.0
"""Virtual seconds that one entry of a script may take."""
SLICED = 3 * T_STATES_PER_SECOND


def shown(text: str) -> str:
    """Text of the tube in ASCII: codes that are no signs as `\\xNN`."""
    return "".join(
        sign if " " <= sign < "\x7f" or sign == "\n" else f"\\x{ord(sign):02x}"
        for sign in text.replace("\\", "\\\\")
    )


def picture(session: Session) -> list[str]:
    """The sixteen lines of video memory as the CPU reads them, trailing blanks removed."""
    peek = session.rig.memory.peek
    starts = range(0x3C00, 0x4000, 64)
    return [
        "".join(chr(peek(start + place)) for place in range(64)).rstrip(" ") for start in starts
    ]


def listing(name: str) -> list[str]:
    return (FOLDER / f"{name}.bas").read_text(encoding="ascii").splitlines()


@pytest.mark.parametrize("name", NAMES)
def test_program_prints_what_the_rom_printed(name: str) -> None:
    session = Session()
    for line in listing(name):
        session.play(Entry(line + "\r"), LONGEST)
    session.transcript()
    for item in json.loads((FOLDER / f"{name}.script.json").read_text(encoding="ascii")):
        session.play(entry(item), LONGEST)
    assert session.rig.waiting is not Waiting.NOTHING
    found = shown(session.transcript()) + "\n--- the tube ---\n"
    found += "".join(f"|{shown(line)}\n" for line in picture(session))
    assert found == (FOLDER / f"{name}.golden.txt").read_text(encoding="ascii")


@pytest.mark.parametrize("name", NAMES)
def test_time_may_be_cut_into_any_slices(name: str) -> None:
    states = []
    for slices in (1, 7, 900):
        session = Session()
        session.rig.load_text("\n".join(listing(name)))
        for character in "RUN\r":
            session.press(character)
        session.rig.run_for(0.1)
        start = session.rig.clock.now
        for count in range(1, slices + 1):
            session.rig.run_to(start + SLICED * count // slices)
        states.append((session.rig.clock.now, session.transcript(), picture(session)))
    assert states[0] == states[1] == states[2]


@pytest.mark.parametrize("name", NAMES)
def test_listing_loads_to_the_bytes_that_typing_makes(name: str) -> None:
    typed = Session()
    for line in listing(name):
        typed.play(Entry(line + "\r"), LONGEST)
    expected = list(typed.rig.basic.program.lines())
    loaded = Session()
    loaded.rig.load_text("\r\n".join(listing(name)))
    assert list(loaded.rig.basic.program.lines()) == expected


def test_there_are_twenty_of_thirty_lines_and_more() -> None:
    assert len(NAMES) == 20
    assert all(30 <= len(listing(name)) <= 100 for name in NAMES)
