"""What the machine's listings are timed beside does the same work."""

from __future__ import annotations

import pytest

from benchmarks.by_hand import BY_HAND
from benchmarks.language import STANDARD, listing
from benchmarks.machine import loaded, run
from trs80arm.works.named_variables import stored_value

BY_THE_PROCESSOR = 1e-4
"""How far functions of `math` lead from the ROM's, beside the whole: most in `ahl`."""


def test_each_of_the_thirteen_is_translated() -> None:
    assert sorted(BY_HAND) == sorted(STANDARD)


@pytest.mark.parametrize("name", STANDARD)
def test_the_translation_leaves_what_the_listing_leaves(name: str) -> None:
    basic = loaded(listing(name, 1))
    run(basic)
    left = BY_HAND[name]()
    assert left
    for variable, value in left.items():
        expected = value if isinstance(value, str) else pytest.approx(value, rel=BY_THE_PROCESSOR)
        assert stored_value(basic, variable) == expected, variable
