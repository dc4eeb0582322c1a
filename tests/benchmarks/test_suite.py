"""The table of the tests: how many, how long, and in which rooms."""

from __future__ import annotations

import subprocess

import pytest

from benchmarks.suite import of_tests


def test_tests_are_counted_and_timed_room_by_room() -> None:
    whole, *rooms = of_tests(["tests/test_shown.py", "tests/trace/test_history.py"], 1)
    assert whole.measures.keys() == {"tests", "s", "s of a core"}
    assert {row.name for row in rooms} == {"trace", "of all rooms"}
    assert sum(row.measures["tests"] for row in rooms) == whole.measures["tests"]
    assert 0 < sum(row.measures["s of a core"] for row in rooms) < whole.measures["s of a core"]


def test_what_fails_is_no_time() -> None:
    with pytest.raises(subprocess.SubprocessError):
        list(of_tests(["tests/no_such_room"], 1))
