"""A program that is edited and run again does what the same program does that was never another."""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.basic.core.test_random_blocks import LONGEST, WITH_OTHERS, loaded, played, programs
from trs80arm.basic import cruncher

NEW_LINES = st.one_of(
    st.builds(
        "{} {}".format, st.sampled_from((50, 100, 110, 115, 145, 190, 195, 300)), WITH_OTHERS
    ),
    st.sampled_from(("100", "110", "150", "170", "190", "400", "500", "400 DATA 9,8")),
)
"""Lines in the place of others, between them and behind them, and numbers alone, which delete."""


@settings(
    max_examples=60,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
@given(
    programs(),
    st.lists(st.lists(NEW_LINES, min_size=1, max_size=3), min_size=1, max_size=3),
    st.integers(100_000, 900_000),
)
def test_programs_that_are_edited_and_run_again(
    lines: list[str], edits: list[list[str]], portion: int
) -> None:
    machine = loaded(lines)
    text = dict(cruncher.split_line(line.encode()) for line in lines)
    for edit in edits:
        played(machine, [LONGEST, portion])
        machine.load(*edit)
        text |= dict(cruncher.split_line(line.encode()) for line in edit)
        fresh = loaded([f"{number}{text[number].decode()}" for number in text])
        fresh.basic.state.seed = machine.basic.state.seed
        assert played(machine, [portion]) == played(fresh, [portion])
