"""Every case recorded from the ROM, group by group; `python -m tests.conformance` shows more."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.conformance import case, player, verdict

CASES = list(case.load(Path(__file__).parent / "cases"))


@pytest.mark.parametrize("one", CASES, ids=lambda one: one.id)
def test_machine_does_what_the_rom_did(one: case.Case) -> None:
    differences = verdict.compare(one, player.play(one))
    assert not differences, "\n".join(map(str, differences))
