"""Work on all cores: each piece with its number, and a process that somebody ends."""

from __future__ import annotations

import multiprocessing
import os

import pytest

from trs80arm import cores
from trs80arm.cores import EndedFromOutsideError, on_all_cores


@pytest.mark.parametrize("jobs", [1, 2])
def test_every_piece_is_done_and_told_with_its_number(jobs: int) -> None:
    done = dict(on_all_cores(abs, range(-20, 0), jobs))
    assert done == dict(enumerate(range(20, 0, -1)))


@pytest.mark.parametrize("fault", [ImportError, NotImplementedError, PermissionError])
def test_where_there_are_no_semaphores_it_is_done_here(
    fault: type[Exception], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object) -> None:
        raise fault

    monkeypatch.setattr(cores, "ProcessPoolExecutor", refuse)
    done = list(on_all_cores(lambda _: os.getpid(), range(3), 2))
    assert done == [(number, os.getpid()) for number in range(3)]


def test_without_work_there_is_nothing_to_do() -> None:
    assert list(on_all_cores(abs, [])) == []


def test_a_process_that_is_ended_is_told_of() -> None:
    try:
        multiprocessing.Lock()
    except (ImportError, OSError):
        pytest.skip("there are no semaphores here, and so no other processes")
    with pytest.raises(EndedFromOutsideError, match="ended from outside"):
        list(on_all_cores(os._exit, [0, 0], 2))
