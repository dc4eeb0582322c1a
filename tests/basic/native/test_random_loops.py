"""Loops of any numbers: native, in Python, whole and in slices they come to the same."""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.basic.native.machines import finish, left

SINGLES = ("A", "B", "X", "Y1")
INTEGERS = ("I%", "J%", "K%")
MANY = settings(
    max_examples=25,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)


def numbers() -> st.SearchStrategy[str]:
    """Constants as typed: small and large, whole and not, of one bit and of 24."""
    return st.one_of(
        st.integers(0, 40).map(str),
        st.sampled_from(
            ("32767", "32768", "255.5", ".1", "1E-3", "16777215", "8388609", "3.14159", "1E19")
        ),
        st.floats(1e-4, 1e6).map(lambda value: f"{value:.6g}".upper()),
    )


def operands(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    subscript = st.sampled_from((*INTEGERS, "ABS(A)", "2", "K%-1"))
    return st.one_of(
        st.tuples(inner, st.sampled_from("+-*/"), inner).map("".join),
        st.tuples(inner, st.sampled_from((" AND ", " OR ", "<", ">=", "=", "<>")), inner).map(
            lambda parts: f"({''.join(parts)})"
        ),
        st.tuples(st.sampled_from(("INT", "FIX", "ABS", "SGN", "-", "NOT ")), inner).map(
            lambda parts: f"{parts[0]}({parts[1]})"
        ),
        inner.map(lambda text: f"({text})"),
        subscript.map(lambda text: f"F({text})"),
        st.tuples(subscript, subscript).map(lambda pair: f"G%({pair[0]},{pair[1]})"),
    )


EXPRESSIONS = st.recursive(
    st.one_of(st.sampled_from(SINGLES + INTEGERS), numbers()), operands, max_leaves=5
)
ASSIGNMENTS = st.tuples(
    st.sampled_from((*SINGLES, *INTEGERS, "F(I%)", "F(2)", "G%(J%,1)")), EXPRESSIONS
).map("=".join)
BRANCHES = st.tuples(EXPRESSIONS, ASSIGNMENTS, ASSIGNMENTS).map(
    lambda parts: f"IF {parts[0]} THEN {parts[1]} ELSE {parts[2]}"
)
CALLS = st.sampled_from(("GOSUB 900", "ON I%-4 GOSUB 900,910"))
STATEMENTS = st.one_of(ASSIGNMENTS, ASSIGNMENTS, BRANCHES, CALLS)
LOOPS = st.tuples(
    st.sampled_from(("A", "K%")),
    st.integers(-3, 3),
    st.integers(-3, 9),
    st.sampled_from(("", "", " STEP 2", " STEP -1", " STEP .3")),
    STATEMENTS,
).map(lambda p: f"FOR {p[0]}={p[1]} TO {p[2]}{p[3]}:{p[4]}:NEXT {p[0]}")


@st.composite
def programs(draw: st.DrawFn) -> list[str]:
    """Rounds of assignments, choices, loops and calls, that begin again and again."""
    body = draw(st.lists(st.one_of(STATEMENTS, STATEMENTS, LOOPS), min_size=1, max_size=6))
    begun = draw(st.lists(ASSIGNMENTS, max_size=3))
    lines = [
        "5 ON ERROR GOTO 990",
        "10 DIM F(9),G%(9,3):A=1:B=2.5:X=1E5:Y1=0:I%=3:J%=1:K%=0",
        *(f"{number} {text}" for number, text in enumerate(begun, 20)),
        *(f"{number} {text}" for number, text in enumerate(body, 100)),
        "200 N=N+1:IF N<25 THEN 100",
        "210 END",
        "900 J%=J%+1:IF J%>9 THEN J%=0",
        "910 X=X-.1:RETURN",
        "990 E=E+ERR:RESUME NEXT",
    ]
    return [line for line in lines if len(line) < 200]


@MANY
@given(programs())
def test_a_loop_of_any_numbers_comes_to_the_same_when_it_is_native(lines: list[str]) -> None:
    assert left(finish(lines, native=True)) == left(finish(lines, native=False))


@MANY
@given(programs(), st.lists(st.integers(200_500, 900_000), min_size=1, max_size=3))
def test_slices_of_a_native_loop_of_any_numbers_make_the_whole(
    lines: list[str], slices: list[int]
) -> None:
    native = finish(lines, native=True, slices=slices, moves=2)
    assert left(native) == left(finish(lines, native=False, slices=slices, blocks=False))
