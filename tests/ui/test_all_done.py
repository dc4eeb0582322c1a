"""The pilot of the tests waits for what is under way, and does not go by the clock."""

from __future__ import annotations

import asyncio
import threading

import pytest
from textual.app import App

from tests.ui import all_done as waiting
from tests.ui.piloted import piloted


class Slow(App[None]):
    """Has a thread do something, and another thing when that is done."""

    def __init__(self) -> None:
        super().__init__()
        self.may_end = threading.Event()
        self.done = False

    async def do_it(self) -> None:
        await asyncio.to_thread(self.may_end.wait)
        self.done = True


@piloted
async def test_what_a_thread_was_given_is_waited_for() -> None:
    app = Slow()
    async with app.run_test() as pilot:
        app.run_worker(app.do_it())
        asyncio.get_running_loop().call_later(0.1, app.may_end.set)
        await pilot.pause()
        assert app.done


@piloted
async def test_what_never_ends_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    app = Slow()
    async with app.run_test() as pilot:
        app.run_worker(app.do_it())
        with monkeypatch.context() as impatient:
            impatient.setattr(waiting, "PATIENCE", 0.05)
            try:
                with pytest.raises(AssertionError, match="never"):
                    await pilot.pause()
            finally:
                app.may_end.set()
            impatient.undo()
