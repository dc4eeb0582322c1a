"""The tour does just what it says: its words are followed to the letter, at two sizes."""

from __future__ import annotations

import re

import pytest
from textual import events

from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.desk.tour import STEPS, Step
from trs80arm.rig import Waiting

AHEAD = 60.0
"""Virtual seconds for which a step may be waited for."""
KEYS = {"Enter", "Escape", "F2", "F5", "Ctrl+T", "Ctrl+R", "Ctrl+N"}


async def run_ahead(sitting: Sitting) -> None:
    """Let the machine work until it wants its operator, or the step is done."""
    app = sitting.app
    step, rig = app.tour.step, app.session.rig

    def over(_: object) -> bool:
        app.tour.go_on()
        waits = rig.waiting is not Waiting.NOTHING and not rig.typing
        return app.tour.step is not step or waits

    rig.run_until(over, AHEAD)
    app.pacer.forgive()
    await sitting.settle()


async def follow(sitting: Sitting, step: Step) -> None:
    """Do what stands between the backticks, in order."""
    words = " ".join(step.words)
    for match in re.finditer("`([^`]*)`", words):
        token, held = match[1], words[: match.start()].endswith("Hold ")
        if token in KEYS or len(token) == 1:
            await sitting.press(token.casefold().replace("ctrl+", "ctrl+"))
            if held:
                for _ in range(5):
                    await sitting.press(token)
                    await sitting.pass_time(0.1)
            await sitting.settle()
        elif sitting.app.dialog_is_open:
            await sitting.press(*token)
            await sitting.settle()
        else:
            sitting.app.post_message(events.Paste(token))
            await sitting.pilot.pause()
            await sitting.pass_time(0.1)
        if not sitting.app.dialog_is_open:
            await sitting.pass_time(0.2)
            await run_ahead(sitting)


@pytest.mark.parametrize(("width", "height"), [(80, 24), (120, 40)])
@piloted
async def test_who_does_what_the_tour_says_comes_to_its_end(
    sit_down: Opener, width: int, height: int
) -> None:
    async with sit_down(width, height, tour=True) as sitting:
        tour = sitting.app.tour
        for number, step in enumerate(STEPS, 1):
            assert tour.step is step, f"step {number}: {step.words}"
            text = screen_text(sitting.app)
            assert f"{number}/{len(STEPS)}  " in text
            for line in step.words:
                assert line.replace("`", "") in text, "the words are seen whole"
            assert "Ctrl+N: skip, back, leave" in text
            await follow(sitting, step)
        assert tour.step is None
        assert "skip, back, leave" not in screen_text(sitting.app)


@piloted
async def test_a_step_is_skipped_gone_back_to_left_and_resumed(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        tour = sitting.app.tour
        await sitting.press("ctrl+n")
        await sitting.settle()
        assert tour.step is STEPS[0]
        for key in ((), ("down",)):
            await sitting.press("ctrl+n", *key, "enter")
            await sitting.settle()
        assert tour.step is STEPS[0]
        for _ in range(3):
            await sitting.press("ctrl+n", "enter")
            await sitting.settle()
        assert tour.step is STEPS[3]
        await sitting.press("ctrl+n", "end", "enter")
        await sitting.settle()
        assert tour.step is None
        assert "The tour waits" in screen_text(sitting.app)
        await sitting.press("ctrl+n")
        await sitting.settle()
        assert tour.step is STEPS[3]
        await sitting.pilot.click("#guide")
        await sitting.settle()
        assert "From the beginning" in screen_text(sitting.app)


@piloted
async def test_the_tour_is_offered_at_the_first_start_only(sit_down: Opener) -> None:
    async with sit_down(first_time=True) as sitting:
        assert "New here?  Ctrl+N begins a tour" in screen_text(sitting.app)
        await sitting.press("p")
        await sitting.settle()
        assert "New here?" not in screen_text(sitting.app)
    async with sit_down() as sitting:
        assert "New here?  Ctrl+N begins" not in screen_text(sitting.app)


@piloted
async def test_an_offer_is_taken_by_its_key(sit_down: Opener) -> None:
    async with sit_down(first_time=True) as sitting:
        await sitting.press("ctrl+n")
        await sitting.settle()
        assert sitting.app.tour.step is STEPS[0]


@piloted
async def test_nothing_is_offered_to_who_opens_a_program(sit_down: Opener) -> None:
    async with sit_down(first_time=True, demo=True) as sitting:
        assert "New here?" not in screen_text(sitting.app)


@piloted
async def test_in_a_browser_keys_that_it_keeps_to_itself_have_others(
    sit_down: Opener, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TEXTUAL_DRIVER", "a browser's")
    async with sit_down(first_time=True) as sitting:
        await sitting.settle()
        text = screen_text(sitting.app)
        assert "Alt+N begins a tour" in text
        assert "Ctrl+N begins" not in text
        await sitting.press("alt+n")
        await sitting.settle()
        assert sitting.app.tour.step is not None
        await sitting.press("alt+t")
        assert len(sitting.app.lesson) == 1
