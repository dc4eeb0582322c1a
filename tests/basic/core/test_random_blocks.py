"""Programs that jump anywhere, also into and out of loops: blocks do what single statements do.

Loops of whole numbers and of others, whose variable is assigned in them, that are opened again
from within, left by jumps and entered by jumps; the last of 24 bits and beyond; subroutines left
without RETURN; errors and their traps.
"""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.basic.machine import Machine
from trs80arm.basic.activity import Waiting

LINES = range(100, 200, 10)
LONGEST = 3_000_000
"""T-states of one run."""
VARIABLES = ("I", "J", "K%", "X")
NUMBERS = st.sampled_from(
    ("0", "1", "2", "-1", "3", ".5", "16777214", "16777216", "-16777215", "3.3E7", "1E38", "X", "J")
)
STEPS = st.sampled_from(("", "", " STEP 2", " STEP -1", " STEP .3", " STEP 1048577", " STEP 0"))
TARGETS = st.sampled_from(LINES).map(str)
NAMES = st.sampled_from(VARIABLES)
FORS = st.one_of(
    st.tuples(NAMES, st.integers(-3, 3), st.integers(-3, 6), STEPS).map(
        lambda p: f"FOR {p[0]}={p[1]} TO {p[2]}{p[3]}"
    ),
    st.tuples(NAMES, NUMBERS, NUMBERS, STEPS).map(lambda p: f"FOR {p[0]}={p[1]} TO {p[2]}{p[3]}"),
)
NEXTS = st.sampled_from(("NEXT", "NEXT I", "NEXT J", "NEXT J,I", "NEXT I", "NEXT K%", "NEXT X"))
NUMERIC = st.one_of(
    st.sampled_from(("S=S+I", "X=X+J", "I=I+.5", "J=J+1", "S=S-J*X", "F(K% AND 7)=I", "S=S+F(J)")),
    st.sampled_from(("X=SIN(I)", "I=0", "S=S+RND(0)", "X=I/J", "X=INT(X)", "X=J[2", "K%=K%+1")),
    st.sampled_from(("X=SQR(S)", "S=0")),
)
POKED = 'A$=B$+"Z":Q=PEEK(VARPTR(A$)+1)+256*PEEK(VARPTR(A$)+2):POKE Q+65536*(Q>32767),66:B$=A$'
STRINGS = st.sampled_from(
    (
        *("A$=STR$(I)", 'B$=LEFT$(A$,2)+"X"', 'A$="ROBOT"', "B$=A$", 'A$=A$+"Z"', POKED),
        *("B$=MID$(A$,J,2)+B$", "S=S+LEN(A$)", "A$=CHR$(65+(N AND 7))", "S=S+FRE(B$)"),
        *("A$=B$+RIGHT$(A$,2)", 'IF A$<B$ THEN A$=B$+"!"'),
    )
)
OTHERS = st.one_of(
    STRINGS,
    STRINGS,
    st.sampled_from(("READ X", "READ A$", "POKE 16000,PEEK(16000)+1 AND 255", "D#=D#+I")),
)
JUMPS = st.one_of(
    TARGETS.map(lambda line: f"GOTO {line}"),
    TARGETS.map(lambda line: f"GOSUB {line}"),
    st.just("RETURN"),
    TARGETS.map(lambda line: f"ON J GOTO {line},170"),
)
CONDITIONS = st.sampled_from(
    ("I<2", "J>1", "S<40", "X", "K%=2", "N/3=INT(N/3)", "LEN(A$)>3", "A$=B$")
)


def texts(simple: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    """Lines of such statements, loops and jumps."""
    branches = st.one_of(
        st.tuples(CONDITIONS, TARGETS).map(lambda p: f"IF {p[0]} THEN {p[1]}"),
        st.tuples(CONDITIONS, simple, st.one_of(NEXTS, simple)).map(
            lambda p: f"IF {p[0]} THEN {p[1]} ELSE {p[2]}"
        ),
        st.tuples(CONDITIONS, NEXTS).map(lambda p: f"IF {p[0]} THEN {p[1]}"),
    )
    loops = st.tuples(NAMES, NUMBERS, NUMBERS, STEPS, simple, st.one_of(simple, branches)).map(
        lambda p: f"FOR {p[0]}={p[1]} TO {p[2]}{p[3]}:{p[4]}:{p[5]}:NEXT"
    )
    nests = st.tuples(st.integers(0, 4), STEPS, loops, simple).map(
        lambda p: f"FOR N={p[0]} TO 6{p[1]}:{p[2]}:{p[3]}:NEXT N"
    )
    anything = st.one_of(FORS, NEXTS, NEXTS, simple, branches, JUMPS)
    several = st.lists(anything, min_size=1, max_size=3).map(":".join)
    return st.one_of(several, simple, loops, loops, nests)


NUMBERS_ALONE, WITH_OTHERS = texts(NUMERIC), texts(st.one_of(NUMERIC, OTHERS, OTHERS))


@st.composite
def programs(draw: st.DrawFn) -> list[str]:
    """Lines of anything, and a trap that goes on behind an error."""
    lines = draw(st.sampled_from((NUMBERS_ALONE, WITH_OTHERS)))
    body = draw(st.lists(lines, min_size=len(LINES), max_size=len(LINES)))
    return [
        "5 CLEAR 60:ON ERROR GOTO 500",
        '10 DIM F(9):I=1:J=2:K%=0:X=1.5:S=0:N=0:E=0:A$="":B$="":D#=0',
        "20 N=N+1:RESTORE:IF N>6 THEN END",
        *(f"{line} {text}" for line, text in zip(LINES, body, strict=True)),
        "200 GOTO 20",
        "400 DATA 1,2.5,-3,7",
        "500 E=E+ERR+ERL/7:IF E>9E3 THEN END ELSE RESUME NEXT",
    ]


def played(machine: Machine, slices: list[int]) -> tuple[object, ...]:
    """RUN, in slices of so many T-states in turn: what came of it, and in what time."""
    printed = len(machine.screen.printed)
    machine.screen.cursor = 0
    clock = machine.clock
    start = clock.now
    machine.do("RUN", seconds=0)
    end, turn = clock.now + LONGEST, 0
    while clock.now < end and machine.basic.waiting is not Waiting.COMMAND:
        clock.limit = min(end, clock.now + slices[turn % len(slices)])
        machine.basic.advance(until_waiting=True)
        turn += 1
    state = machine.basic.state
    scalars = [
        (each.name, each.kind, repr(each.cell.cell_contents)) for each in state.variables.order
    ]
    arrays = [repr(each.data) for each in state.variables.arrays.values()]
    frames = [
        (repr(frame.scalar and frame.scalar.name), frame.line) for frame in state.control.frames
    ]
    screen = bytes(machine.screen.printed[printed:])
    return screen, clock.now - start, scalars, arrays, frames, state.seed


def loaded(lines: list[str], *, blocks: bool = True) -> Machine:
    """A machine with a program."""
    machine = Machine(blocks=blocks)
    machine.load(*lines)
    return machine


@settings(
    max_examples=60,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
@given(programs(), st.lists(st.integers(100_000, 900_000), min_size=1, max_size=3))
def test_programs_that_jump_anywhere(lines: list[str], slices: list[int]) -> None:
    alone = played(loaded(lines, blocks=False), [LONGEST])
    assert played(loaded(lines), [LONGEST]) == alone
    assert played(loaded(lines), slices) == alone
