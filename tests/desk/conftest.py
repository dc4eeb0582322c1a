"""Every test of the desk keeps its files in its own folder."""

from pathlib import Path

import pytest

from tests.desk.sitting import Sitting
from tests.own_places import own_places

__all__ = ["own_places", "sitting"]


@pytest.fixture
def sitting(tmp_path: Path) -> Sitting:
    """A desk with a person at it."""
    return Sitting(tmp_path)
