"""What the tests of the cases share, in whatever processes of a run they are done."""

from __future__ import annotations

import os

import pytest

from tests.conformance.told_times import ToldTimes


@pytest.fixture(scope="session")
def told_times(tmp_path_factory: pytest.TempPathFactory) -> ToldTimes:
    """How long the machine took over the cases that any process of this run has played."""
    own = tmp_path_factory.getbasetemp()
    # Each worker of pytest-xdist has its folder inside that of the run.
    worker = os.environ.get("PYTEST_XDIST_WORKER")
    return ToldTimes(own.parent if worker else own, worker or "alone")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Have all cases played before their times are asked for, whichever process plays them."""
    items.sort(key=lambda item: "segments" in getattr(item, "fixturenames", ()))
