"""A string expression put together in one go leaves what the routines leave, byte for byte."""

from __future__ import annotations

from unittest import mock

from hypothesis import given, settings
from hypothesis import strategies as st

from tests.basic.machine import Machine
from trs80arm.basic.compiler import pieces

numbers = st.one_of(
    st.integers(0, 9).map(str), st.sampled_from(["I", "I%", "I+1", "LEN(A$)", "I/2", "255", "256"])
)
leaves = st.one_of(
    st.sampled_from(["A$", "B$", "C$(1)", "C$(I)", '""', '"ROBOT"', '"MINIMOVER 5"']),
    st.sampled_from(["I", "I%", "-I%", "I*1.5", "1E9", "I#"]).map(lambda x: f"STR$({x})"),
    numbers.map(lambda x: f"CHR$({x})"),
)
expressions = st.recursive(
    leaves,
    lambda inner: st.one_of(
        st.builds("LEFT$({},{})".format, inner, numbers),
        st.builds("RIGHT$({},{})".format, inner, numbers),
        st.builds("MID$({},{})".format, inner, numbers),
        st.builds("MID$({},{},{})".format, inner, numbers, numbers),
        st.builds("{}+{}".format, inner, inner),
    ),
    max_leaves=8,
)


def _after(room: int, targets: list[str], texts: list[str], compared: str) -> tuple[object, ...]:
    machine = Machine()
    lines = [
        f"{20 + i} {name}={text}"
        for i, (name, text) in enumerate(zip(targets, texts, strict=False))
    ]
    machine.load(
        f'10 CLEAR {room}:A$="ARM"+"BASIC":C$(1)="X"+A$:FOR I=0 TO 5:I%=7-I:I#=I/3',
        *lines,
        f"70 T=T*4-(A$={compared})-2*(B$<{compared})-(A$<>B$)+LEN(A$)",
        "80 NEXT:PRINT T;FRE(A$)",
    )
    machine.do("RUN", seconds=100)
    state = machine.basic.state
    strings = state.strings
    held = [scalar.value for scalar in state.variables.order]
    arrays = [array.data for array in state.variables.arrays.values()]
    space = bytes(state.memory.ram[strings.bottom : strings.top + 1])
    return machine.clock.now, bytes(machine.screen.printed), space, strings.next, held, arrays


@settings(max_examples=40, deadline=None)
@given(
    st.integers(15, 400),
    st.lists(st.sampled_from(["A$", "B$", "C$(1)", "C$(I)"]), min_size=1, max_size=3),
    st.lists(expressions, min_size=3, max_size=3),
    leaves,
)
def test_put_together_or_step_by_step_is_the_same(
    room: int, targets: list[str], texts: list[str], compared: str
) -> None:
    at_once = _after(room, targets, texts, compared)
    with mock.patch.object(pieces, "_room", return_value="(size := 0)"):
        assert _after(room, targets, texts, compared) == at_once
    with mock.patch.object(pieces, "with_piece", lambda value, *_: value):
        assert _after(room, targets, texts, compared) == at_once
