"""What is said of a bench file that cannot be."""

from __future__ import annotations

import pytest

from trs80arm.arm import BenchError, benchfile


def refusal(bench: str) -> str:
    """The one line that a bench file called b.toml is refused with."""
    with pytest.raises(BenchError) as caught:
        benchfile.parse(bench, "b.toml")
    said = str(caught.value)
    assert "\n" not in said
    return said
