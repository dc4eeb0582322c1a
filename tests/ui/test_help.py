"""The help opens at what is being done, and is searched."""

from __future__ import annotations

import pytest
from textual.containers import VerticalScroll
from textual.widgets import Input, Markdown
from textual.widgets.markdown import MarkdownFence

from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.options import KeyMode
from trs80arm.ui.help_topics import AFTER_A_SLIP, WHILE_WAITING, Topic, topics
from trs80arm.ui.screens.help import HelpScreen

TOPICS = [Topic("One", "about the ARM"), Topic("Two", "of tapes"), Topic("Three", "arm and tapes")]


async def first_topic(sitting: Sitting) -> str:
    """The heading at the top of the help."""
    await sitting.press("f1")
    await sitting.settle()
    screen = sitting.app.screen
    assert isinstance(screen, HelpScreen)
    await sitting.app.workers.wait_for_complete()
    return seen(screen)[0]


def seen(screen: HelpScreen) -> list[str]:
    """The headings of the topics that are shown, from the top."""
    written = [page.source for page in screen.query(Markdown) if page.display]
    # The first are there, the others when they are scrolled to.
    assert written == [topic.page for topic in screen.found[: len(written)]]
    assert written or not screen.found
    return [topic.title for topic in screen.found]


async def read_through(sitting: Sitting) -> None:
    """Scroll from the top to the end."""
    place = sitting.app.screen.query_one(VerticalScroll)
    for _ in range(200):
        if place.scroll_offset.y == place.max_scroll_y:
            return
        await sitting.press("pagedown")
    pytest.fail("there is no end")


@piloted
async def test_what_is_wanted_first_comes_first_and_the_rest_in_order(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        screen = HelpScreen(TOPICS, "Two")
        await sitting.app.push_screen(screen)
        await sitting.app.workers.wait_for_complete()
        assert seen(screen) == ["Two", "One", "Three"]


@piloted
async def test_typing_leaves_the_topics_with_all_the_words(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        screen = HelpScreen(TOPICS)
        await sitting.app.push_screen(screen)
        # Before all of them are there, too.
        screen.query_one(Input).value = "TAPES arm"
        await sitting.app.workers.wait_for_complete()
        await sitting.settle()
        assert seen(screen) == ["Three"]
        screen.query_one(Input).value = "spoon"
        await sitting.settle()
        assert seen(screen) == []
        assert "Nothing here has spoon." in screen_text(sitting.app)
        screen.query_one(Input).value = ""
        await sitting.settle()
        assert seen(screen) == ["One", "Two", "Three"]
        assert "Nothing here" not in screen_text(sitting.app)


def test_every_topic_that_it_opens_at_is_there() -> None:
    titles = {topic.title for topic in topics(KeyMode.REPEAT, [], [])}
    assert {AFTER_A_SLIP, *WHILE_WAITING.values()} <= titles


def test_what_panels_say_of_themselves_is_found() -> None:
    found = topics(KeyMode.REPEAT, [], ["\n## Coils\n\nA lamp each.\n"])
    assert found[-1] == Topic("Coils", "A lamp each.")


@pytest.mark.parametrize(
    ("lines", "title"),
    [
        ([], "In a minute"),
        (["@SET"], "Manual mode"),
        (["10 INPUT A", "RUN"], "A program asks for something"),
        (["10 PRINT 1", "EDIT 10"], "In EDIT"),
        (["AUTO"], "In AUTO"),
    ],
)
@piloted
async def test_it_opens_at_what_is_being_done(
    sit_down: Opener, lines: list[str], title: str
) -> None:
    async with sit_down() as sitting:
        for line in lines:
            await sitting.type_line(line)
        assert await first_topic(sitting) == title


@piloted
async def test_after_a_slip_it_opens_at_that(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.type_line("@STEP 50,0,0,-3000")
        assert await first_topic(sitting) == AFTER_A_SLIP


@piloted
async def test_no_language_is_guessed_for_its_tables(
    sit_down: Opener, monkeypatch: pytest.MonkeyPatch
) -> None:
    # For that every lexer there is would be loaded while one waits for the page.
    guessed: list[str] = []
    monkeypatch.setattr(
        "textual.highlight.guess_language", lambda code, path: guessed.append(code) or "text"
    )
    async with sit_down() as sitting:
        await first_topic(sitting)
        screen = sitting.app.screen
        assert isinstance(screen, HelpScreen)
        with_tables = [topic for topic in screen.found if "```" in topic.page]
        for topic in with_tables:
            _, table, *_ = topic.text.split("```text")
            screen.query_one(Input).value = f"{topic.title} {table.splitlines()[2]}"
            await sitting.settle()
            await sitting.settle()
        assert len(screen.query(MarkdownFence)) >= len(with_tables) > 1
        assert guessed == []


@piloted
async def test_what_is_scrolled_to_is_written_and_what_is_far_below_is_not(
    sit_down: Opener,
) -> None:
    async with sit_down() as sitting:
        await first_topic(sitting)
        screen = sitting.app.screen
        assert isinstance(screen, HelpScreen)
        assert 1 < len(screen.query(Markdown)) < len(screen.found) / 2
        await read_through(sitting)
        await sitting.settle()
        assert len(screen.query(Markdown)) == len(screen.found) == len(seen(screen))
        *_, last = (line for line in screen.found[-1].text.split() if line.isalpha())
        assert last in screen_text(sitting.app)


@piloted
async def test_typing_searches_it(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("f1")
        await sitting.press(*"cassettes")
        await sitting.settle()
        assert sitting.app.screen.query_one(Input).value == "cassettes"
        text = screen_text(sitting.app)
        assert "Tapes" in text
        assert "In a minute" not in text


@pytest.mark.parametrize(
    ("command", "title"),
    [
        ("teach", "The teach pendant"),
        ("debugger", "The debugger"),
        ("hand_move", "Moving the arm by hand"),
    ],
)
@piloted
async def test_in_front_of_a_page_it_opens_at_that(
    sit_down: Opener, command: str, title: str
) -> None:
    async with sit_down() as sitting:
        sitting.app.action_do(command)
        await sitting.settle()
        assert await first_topic(sitting) == title
        screen = sitting.app.screen
        assert isinstance(screen, HelpScreen)
        assert seen(screen).count(title) == 1
        assert "Manual mode" in seen(screen)
