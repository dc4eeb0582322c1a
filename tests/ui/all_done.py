"""Waiting, in a test of a Textual program, until nothing is under way any more.

Textual's own pilot waits for a processor without work, in pieces of 20 ms: on a quiet computer far
too long, on a busy one not long enough. Here messages, layouts and drawings are waited for as such:
until only clocks, other threads or keys could bring the program on. The one place that asks the
loop of asyncio and a screen's timer about it.
"""

from __future__ import annotations

import asyncio
from contextlib import suppress
from time import monotonic
from typing import Any

from textual._context import active_app
from textual.app import App, ScreenStackError
from textual.screen import Screen

_ROUNDS = 3
"""Rounds of the loop with nothing to do after which it is taken to have nothing to do."""
_THREAD = 0.001
"""Seconds until a thread is looked at again."""


async def all_done(min_sleep: float = 0.0, max_sleep: float = 1.0) -> None:
    """Wait until everything is done, with what Textual's `wait_for_idle` is given.

    Args:
        min_sleep: of no use here.
        max_sleep: seconds after which a program that never rests is waited for no longer.
    """
    app: App[Any] = active_app.get()
    end = monotonic() + max_sleep
    while monotonic() < end:
        await _all_handled(end)
        with suppress(ScreenStackError):
            screen = app.screen
            if _has_to_draw(screen):
                screen._on_timer_update()
                continue
        if not any(worker._thread_worker and worker.is_running for worker in app.workers):
            return
        await asyncio.sleep(_THREAD)


async def _all_handled(end: float) -> None:
    """Let the loop go round until it has nothing to do but wait, or a moment has come."""
    loop: Any = asyncio.get_running_loop()
    idle = 0
    while idle < _ROUNDS and monotonic() < end:
        await asyncio.sleep(0)
        idle = 0 if loop._ready else idle + 1


def _has_to_draw(screen: Screen[Any]) -> bool:
    """Whether a screen waits for its next frame to lay out or to draw something."""
    return screen.is_running and screen._update_timer._active.is_set()
