"""Whatever is typed, loaded, POKEd or pressed, the machine goes on: no exception, no standstill.

Every example works a whole rig: it puts nonsense into it, runs for some virtual time, breaks off
and goes through commands that look at everything. Time must have passed and the machine must
listen.
"""

from __future__ import annotations

from pathlib import Path

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.conformance.case import Entry
from tests.conformance.player import Session
from trs80arm.basic import cruncher
from trs80arm.basic.activity import Waiting
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.keys import Key

BOUNDED = settings(
    max_examples=25,
    derandomize=True,
    deadline=None,
    database=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
PROGRAMS = [
    [
        (number, cruncher.crunch(text).text)
        for number, text in (
            cruncher.split_line(line) for line in path.read_bytes().splitlines() if line
        )
        if number is not None
    ]
    for path in sorted((Path(__file__).parent.parent / "programs_of_the_period").glob("*/*.bas"))
]
TYPABLE = "".join(map(chr, range(32, 91))) + "[`abz\x08\x09\n\x18\x19\x1a\x1b\x1f\x01\r"
COMMANDS = (
    "LIST", "PRINT A;A$;MEM;FRE(A$)", "CONT", "EDIT .", "GOTO 10", "NEXT", "RETURN", "CLEAR 100",
    "PRINT ERR;ERL", "READ A$", "RESUME", "RUN", "DELETE -100", "10 PRINT 5", "NEW",
)  # fmt: skip


def type_line(session: Session, text: str, seconds: float = 1.5) -> None:
    session.play(Entry(text + "\r"), seconds)


def press_break(session: Session) -> None:
    session.rig.release_all()
    for _ in range(3):
        session.rig.hold([Key.BREAK], 0.1)
        session.rig.run_for(0.2)


def the_machine_goes_on(session: Session, commands: list[str]) -> None:
    """Break off, look at everything with commands, and see that time passes at each."""
    press_break(session)
    for command in commands:
        before = session.rig.clock.now
        type_line(session, command)
        press_break(session)
        assert session.rig.clock.now > before
        assert session.rig.clock.now - before < 60 * T_STATES_PER_SECOND
    assert isinstance(session.rig.waiting, Waiting)
    session.rig.restore(session.rig.snapshot())


def commands() -> st.SearchStrategy[list[str]]:
    return st.lists(st.sampled_from(COMMANDS), max_size=5)


def crunched_text() -> st.SearchStrategy[bytes]:
    token = st.integers(128, 251)
    sign = st.integers(32, 91)
    return st.lists(token | sign | st.integers(1, 255), min_size=1, max_size=40).map(bytes)


@st.composite
def mutated_programs(draw: st.DrawFn) -> list[tuple[int, bytes]]:
    program = [(number, bytearray(text)) for number, text in draw(st.sampled_from(PROGRAMS))]
    for _ in range(draw(st.integers(1, 12))):
        _, text = draw(st.sampled_from(program))
        place = draw(st.integers(0, len(text)))
        match draw(st.integers(0, 3)):
            case 0:
                text[place : place + 1] = bytes((draw(st.integers(1, 255)),))
            case 1:
                del text[place : place + draw(st.integers(1, 4))]
            case 2:
                text[place:place] = bytes((draw(st.integers(128, 251)),))
            case _:
                other = draw(st.sampled_from(program))[1]
                text[place:place] = other[: draw(st.integers(0, 20))]
    return [(number, bytes(text[:240]) or b":") for number, text in program]


@BOUNDED
@given(st.lists(st.text(TYPABLE, max_size=60), min_size=1, max_size=4), commands())
def test_typed_noise(lines: list[str], then: list[str]) -> None:
    session = Session()
    for line in lines:
        type_line(session, line)
    the_machine_goes_on(session, then)


@BOUNDED
@given(st.dictionaries(st.integers(0, 65529), crunched_text(), max_size=10), commands())
def test_programs_of_crunched_noise(lines: dict[int, bytes], then: list[str]) -> None:
    session = Session()
    session.rig.load_lines(lines.items())
    type_line(session, "RUN", 3)
    the_machine_goes_on(session, then)


@BOUNDED
@given(mutated_programs(), st.text(TYPABLE, max_size=10), commands())
def test_programs_with_typing_errors(
    program: list[tuple[int, bytes]], answer: str, then: list[str]
) -> None:
    session = Session()
    session.rig.load_lines(program)
    type_line(session, "RUN", 4)
    type_line(session, answer)
    the_machine_goes_on(session, then)


@BOUNDED
@given(
    st.sampled_from(PROGRAMS),
    st.lists(
        st.tuples(
            st.integers(0x4000, 0x4300) | st.integers(0x40A0, 0x4110) | st.integers(0, 0xFFFF),
            st.integers(0, 255),
        ),
        max_size=40,
    ),
    commands(),
)
def test_pokes_anywhere(
    program: list[tuple[int, bytes]], pokes: list[tuple[int, int]], then: list[str]
) -> None:
    session = Session()
    session.rig.load_lines(program)
    type_line(session, "RUN", 1)
    for place, (address, value) in enumerate(pokes):
        session.rig.memory.poke(address, value)
        if place % 4 == 0:
            session.rig.run_for(0.05)
    the_machine_goes_on(session, then)


@BOUNDED
@given(
    st.sampled_from(PROGRAMS),
    st.lists(st.tuples(st.sampled_from(list(Key)), st.booleans(), st.floats(0, 0.2)), max_size=40),
    commands(),
)
def test_hands_on_the_keyboard(
    program: list[tuple[int, bytes]],
    presses: list[tuple[Key, bool, float]],
    then: list[str],
) -> None:
    session = Session()
    session.rig.load_lines(program)
    type_line(session, "RUN", 0.5)
    for key, down, seconds in presses:
        (session.rig.press if down else session.rig.release)(key)
        session.rig.run_for(seconds)
    the_machine_goes_on(session, then)
