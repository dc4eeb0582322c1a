"""Lets a test of a Textual program be written as a coroutine, without a plug-in."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from functools import wraps
from typing import Any, ParamSpec
from unittest.mock import patch

from textual.css.stylesheet import Stylesheet
from textual.pilot import Pilot

from tests.ui.all_done import all_done, know_threads, screen_done
from tests.ui.parsed_once import parse_once

Arguments = ParamSpec("Arguments")


def piloted(
    test: Callable[Arguments, Coroutine[Any, Any, None]],
) -> Callable[Arguments, None]:
    """Run the coroutine of a test to its end; its pilot waits for all to be done, no longer."""

    async def prepared(*args: Arguments.args, **kwargs: Arguments.kwargs) -> None:
        know_threads()
        await test(*args, **kwargs)

    @wraps(test)
    def run(*args: Arguments.args, **kwargs: Arguments.kwargs) -> None:
        with (
            patch("textual.pilot.wait_for_idle", all_done),
            patch("textual.app.wait_for_idle", all_done),
            patch.object(Pilot, "_wait_for_screen", screen_done),
            patch.object(Stylesheet, "_parse_rules", parse_once),
        ):
            asyncio.run(prepared(*args, **kwargs))

    return run
