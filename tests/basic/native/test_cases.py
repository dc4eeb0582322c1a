"""What the ROM did in recorded cases with loops, done with every loop native from the start."""

from __future__ import annotations

from itertools import islice
from pathlib import Path

import pytest

from tests.basic.native.machines import at_once
from tests.conformance import case, player, verdict
from tests.conformance.exceptions import EXCEPTIONS

FOLDER = Path(__file__).parents[2] / "conformance" / "cases"
WITH_LOOPS = (
    one
    for one in case.load(FOLDER)
    if any(word in line for line in one.program for word in ("FOR", "GOTO", "THEN"))
    and one.id not in EXCEPTIONS
)
SHARE = list(islice(WITH_LOOPS, 0, None, 9))


@pytest.mark.parametrize("one", SHARE, ids=lambda one: one.id)
def test_a_recorded_case_with_native_loops_is_as_the_rom_had_it(one: case.Case) -> None:
    with at_once():
        played = player.play(one)
    assert not verdict.compare(one, played)
    assert played == player.play(one, blocks=False)
