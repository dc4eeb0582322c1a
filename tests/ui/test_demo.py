"""The demonstration plays the article's task, and stops at a key."""

from __future__ import annotations

import asyncio

from textual import events

from tests.ui.conftest import Opener
from trs80arm.ui.demo import SCENES, Demo
from trs80arm.ui.session import Session


def test_it_picks_up_a_part_and_puts_it_down() -> None:
    session = Session()
    demo = Demo(session)
    captions: list[str] = []
    held: list[bool] = []
    while demo.caption != SCENES[-1].caption:
        demo.go_on()
        if not captions or captions[-1] != demo.caption:
            captions.append(demo.caption)
        now = session.rig.state.held is not None
        if not held or held[-1] is not now:
            held.append(now)
        session.run_for(0.1)
        assert session.time < 240
    assert captions == [scene.caption for scene in SCENES]
    assert held[:3] == [False, True, False]


def test_every_caption_fits_into_the_status_line() -> None:
    assert max(len(scene.caption) for scene in SCENES) < 76


def test_a_key_ends_it_and_is_not_typed(sit_down: Opener) -> None:
    async def work() -> None:
        async with sit_down(demo=True) as sitting:
            await sitting.pass_time(1)
            sitting.app.tube.post_message(events.Key("x", "x"))
            await sitting.pilot.pause()
            await sitting.pass_time(1)
            assert sitting.app.session.path is not None
            assert ">X" not in sitting.tube
            sitting.app.tube.post_message(events.Key("y", "y"))
            await sitting.pilot.pause()
            await sitting.pass_time(0.5)
            assert sitting.tube.rstrip().endswith(">Y_")

    asyncio.run(work())
