"""Work done on all cores, each piece of it in whichever process is free."""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from typing import TypeVar

T = TypeVar("T")
R = TypeVar("R")

_IN_HAND = 4
"""Pieces that wait for each process."""


class EndedFromOutsideError(Exception):
    """One of the processes was ended by somebody else; one clear line."""


def on_all_cores(
    do: Callable[[T], R], pieces: Sequence[T], jobs: int | None = None
) -> Iterator[tuple[int, R]]:
    """Do every piece of some work.

    Args:
        do: is given a piece; a function that another process can be given, too.
        pieces: what there is to do.
        jobs: processes; as many as there are cores unless given, and with one no other process,
            nor where processes cannot have anything in common.

    Yields:
        The number of each piece, from 0, and what came of it, as they are done.

    Raises:
        EndedFromOutsideError: a process was ended before its piece was done.
    """
    jobs = min(jobs or os.cpu_count() or 1, len(pieces))
    if jobs <= 1:
        yield from enumerate(map(do, pieces))
        return
    # A new process has none of this one's threads, as that of a bar. Ctrl+C ends it without a
    # word: the one that waits for it says what is to be said.
    context = multiprocessing.get_context("spawn")
    try:
        pool = ProcessPoolExecutor(jobs, context, signal.signal, (signal.SIGINT, signal.SIG_DFL))
    except (ImportError, NotImplementedError, OSError):
        # Some systems, and boxes that programs are shut in, have no semaphores.
        yield from enumerate(map(do, pieces))
        return
    under_way: dict[Future[R], int] = {}
    ahead = iter(enumerate(pieces))
    try:
        while True:
            while len(under_way) < jobs * _IN_HAND and (piece := next(ahead, None)) is not None:
                under_way[pool.submit(do, piece[1])] = piece[0]
            if not under_way:
                return
            for future in wait(under_way, return_when=FIRST_COMPLETED).done:
                yield under_way.pop(future), future.result()
    except BrokenProcessPool:
        raise EndedFromOutsideError(
            "one of the processes that did the runs was ended from outside"
        ) from None
    finally:
        pool.shutdown(cancel_futures=True)
