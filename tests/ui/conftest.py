"""What tests of the terminal use."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.own_places import own_places
from tests.ui.sitting import Opener, opener_in

__all__ = ["own_places", "sit_down"]


@pytest.fixture
def sit_down(tmp_path: Path) -> Opener:
    """Opens the program, its state in a folder of the test's own."""
    return opener_in(tmp_path)
