"""Every case recorded from the ROM; `python -m tests.conformance` shows more."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.conformance import case, player, verdict
from tests.conformance.exceptions import EXCEPTIONS

CASES = list(case.load(Path(__file__).parent / "cases"))
# The tests of a case stand next to each other, so that one process does them and plays it once.
pytestmark = pytest.mark.parametrize("one", CASES, ids=lambda one: one.id, scope="module")


def test_machine_does_what_the_rom_did(one: case.Case) -> None:
    differences = verdict.compare(one, player.play_once(one))
    if one.id in EXCEPTIONS:
        assert differences, f"{one.id} passes: it is no exception any more"
    else:
        assert not differences, "\n".join(map(str, differences))


def test_blocks_and_single_statements_are_one_machine(one: case.Case) -> None:
    """To the last T-state of every segment."""
    assert player.play(one, blocks=False) == player.play_once(one)
