"""Random sessions with EDIT, the line editor, AUTO, LIST, DELETE and INPUT, recorded from the ROM.

They have the form of the conformance cases; the keys were chosen at random, what came of them is
what the original ROM did.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.conformance import case, player, verdict

SESSIONS = list(case.load(Path(__file__).parent / "sessions"))


@pytest.mark.parametrize("one", SESSIONS, ids=lambda one: one.id)
def test_dialogue_goes_as_on_the_rom(one: case.Case) -> None:
    differences = verdict.compare(one, player.play(one))
    assert not differences, "\n".join(map(str, differences))
