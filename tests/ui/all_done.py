"""Waiting, in a test of a Textual program, until nothing is under way any more.

Textual's own pilot waits for a processor without work, in pieces of 20 ms: on a quiet computer far
too long, on a busy one not long enough. Here messages, layouts, drawings and what threads were
given to do are waited for as such: until only clocks or keys could bring the program on, however
long that takes. The one place that asks the loop of asyncio and a screen's timer about it.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import Executor
from contextlib import suppress
from time import monotonic
from typing import Any
from weakref import WeakKeyDictionary

from textual._context import active_app
from textual.app import ScreenStackError
from textual.pilot import Pilot
from textual.screen import Screen

PATIENCE = 120.0
"""Seconds after which a program is taken to never rest, which is an error; no computer is so busy
that it matters otherwise."""
_ROUNDS = 3
"""Rounds of the loop with nothing to do after which it is taken to have nothing to do."""
_THREAD = 0.001
"""Seconds until a thread is looked at again."""
_in_threads: WeakKeyDictionary[asyncio.AbstractEventLoop, set[asyncio.Future[Any]]] = (
    WeakKeyDictionary()
)


def know_threads() -> None:
    """Have what the running loop gives to threads from now on be waited for as well."""
    loop: Any = asyncio.get_running_loop()
    pending = _in_threads.setdefault(loop, set())
    give = loop.run_in_executor

    def run_in_executor(
        executor: Executor | None, task: Callable[..., Any], *args: Any
    ) -> asyncio.Future[Any]:
        future: asyncio.Future[Any] = give(executor, task, *args)
        pending.add(future)
        future.add_done_callback(pending.discard)
        return future

    loop.run_in_executor = run_in_executor


async def all_done(min_sleep: float = 0.0, max_sleep: float = 1.0) -> None:
    """Wait until everything is done, with what Textual's `wait_for_idle` is given.

    Args:
        min_sleep: of no use here.
        max_sleep: of no use here; `PATIENCE` takes its place.

    Raises:
        AssertionError: the program never rests.
    """
    pending = _in_threads.get(asyncio.get_running_loop(), set())
    end = monotonic() + PATIENCE
    while True:
        await _all_handled(end)
        with suppress(ScreenStackError):
            # What is behind a dialog comes first, for it is seen through the dialog.
            waiting = [screen for screen in active_app.get().screen_stack if _has_to_draw(screen)]
            if waiting:
                waiting[0]._on_timer_update()
                continue
        if not pending:
            return
        assert monotonic() < end, "what was given to threads never ends"
        await asyncio.sleep(_THREAD)


async def screen_done(pilot: Pilot[Any], timeout: float = 30.0) -> bool:
    """The same in the place of `Pilot._wait_for_screen`, which sends a message to every widget.

    A third of all messages were such.
    """
    await all_done()
    return True


async def _all_handled(end: float) -> None:
    """Let the loop go round until it has nothing to do but wait."""
    loop: Any = asyncio.get_running_loop()
    idle = 0
    while idle < _ROUNDS:
        assert monotonic() < end, "the program never rests"
        await asyncio.sleep(0)
        idle = 0 if loop._ready else idle + 1


def _has_to_draw(screen: Screen[Any]) -> bool:
    """Whether a screen waits for its next frame to lay out or to draw something."""
    return screen.is_running and screen._update_timer._active.is_set()
