"""The debugger on the screen, by keyboard alone."""

from __future__ import annotations

from pathlib import Path

import pytest
from textual.widgets import Input, OptionList, Static

from tests.sixty_lines import LISTING
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.rig import Waiting
from trs80arm.ui.screens.ask_line import AskLine
from trs80arm.ui.screens.debugger import DebuggerScreen
from trs80arm.ui.screens.states import StatesScreen


def debugger(sitting: Sitting) -> DebuggerScreen:
    """The debugger, which is open."""
    screen = sitting.app.screen
    assert isinstance(screen, DebuggerScreen)
    return screen


def where(sitting: Sitting) -> str:
    """What it says of where the machine stands."""
    return str(debugger(sitting).query_one("#where", Static).visual)


def rows(sitting: Sitting, part: str) -> list[str]:
    """The rows of the listing, the variables or memory."""
    options = debugger(sitting).query_one(f"#{part}", OptionList)
    return [str(options.get_option_at_index(n).prompt) for n in range(options.option_count)]


def variable(sitting: Sitting, name: str) -> str:
    [row] = [row for row in rows(sitting, "variables") if row.split()[0] == name]
    return row.split(maxsplit=1)[1]


async def mark_line(sitting: Sitting, number: int) -> None:
    """Go to a line of the listing with the arrow keys."""
    numbers = [int(row[2:].split()[0]) for row in rows(sitting, "listing")]
    listing = debugger(sitting).query_one("#listing", OptionList)
    far = numbers.index(number) - (listing.highlighted or 0)
    await sitting.press(*["down" if far > 0 else "up"] * abs(far))
    assert listing.highlighted == numbers.index(number)


async def stopped_at(sitting: Sitting, listing: str, line: int) -> None:
    """Load a program, set a breakpoint by keys, run up to it."""
    sitting.app.session.rig.load_text(listing)
    await sitting.press("f7")
    await sitting.settle()
    await mark_line(sitting, line)
    await sitting.press("space", "escape", "f5")
    for _ in range(60):
        await sitting.pass_time(0.1)
        if isinstance(sitting.app.screen, DebuggerScreen):
            return
    pytest.fail("it never stopped")


@pytest.mark.parametrize("size", [(120, 40), (200, 60)])
@piloted
async def test_beside_the_tube_the_debugger_leaves_the_status_line_whole(
    sit_down: Opener, size: tuple[int, int]
) -> None:
    async with sit_down(*size) as sitting:
        notice = "This is as long as notices are, and longer than the tube is wide."
        sitting.app.say(notice)
        await sitting.press("f7")
        await sitting.pass_time(0.3)
        assert debugger(sitting)
        status = screen_text(sitting.app).splitlines()[-2]
        assert status.startswith("0:00")
        assert status.endswith(notice)


@pytest.mark.parametrize("size", [(80, 24), (120, 40), (200, 60)])
@piloted
async def test_a_line_that_is_too_long_goes_on_below_its_statements(
    sit_down: Opener, size: tuple[int, int]
) -> None:
    async with sit_down(*size) as sitting:
        remark = "LONG " * 45
        listing = "".join(
            f"{number} REM {remark[: 5 * (number - 97)]}\n" for number in range(100, 140)
        )
        sitting.app.session.rig.load_text(listing)
        await sitting.app.run_action("do('debugger')")
        await sitting.pass_time(0.3)
        lines = screen_text(sitting.app).splitlines()
        for number, line in enumerate(lines):
            if " REM LONG" in line:
                begin = line.index(" REM LONG") + 1
            elif " LONG" in line:
                assert line.index(" LONG") + 1 == begin, number
        assert any(" LONG" in line and " REM" not in line for line in lines)


@pytest.mark.parametrize(("width", "height"), [(80, 24), (120, 40)])
def test_the_mistake_is_found_by_keys(sit_down: Opener, width: int, height: int) -> None:
    @piloted
    async def find() -> None:
        async with sit_down(width, height) as sitting:
            await stopped_at(sitting, LISTING, 220)
            rig = sitting.app.session.rig
            assert where(sitting) == "Breakpoint before 220: R(I)=W"
            assert variable(sitting, "I%") == "5"
            time, registers, tube = rig.clock.now, rig.registers, rig.screen()
            await sitting.press("b", "b")
            assert where(sitting) == "Back before 550: NEXT I"
            assert variable(sitting, "I%") == "4"
            [breakpoint] = [row for row in rows(sitting, "listing") if row.startswith("*")]
            assert breakpoint.startswith("* 220")
            await sitting.press("f7", "f7")
            assert where(sitting) == "Breakpoint before 220: R(I)=W"
            assert (rig.clock.now, rig.registers, rig.screen()) == (time, registers, tube)

    find()


@piloted
async def test_statements_of_one_line_are_marked_in_it(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await stopped_at(sitting, "10 A=1:B=2\n20 END\n", 10)
        listing = debugger(sitting).query_one("#listing", OptionList)

        def marked() -> str:
            prompt = listing.get_option_at_index(0).prompt
            [span] = [span for span in prompt.spans if "reverse" in str(span.style)]
            return prompt.plain[span.start : span.end]

        assert marked() == "A=1"
        await sitting.press("f7")
        assert marked() == "B=2"


@piloted
async def test_over_out_and_to_a_line(sit_down: Opener) -> None:
    program = "10 GOSUB 50\n20 GOSUB 50\n30 A=1\n40 END\n50 B=B+1\n60 RETURN\n"
    async with sit_down() as sitting:
        await stopped_at(sitting, program, 10)
        await sitting.press("f7")
        assert where(sitting) == "Before 50: B=B+1"
        await sitting.press("u")
        assert where(sitting) == "Before 20: GOSUB 50"
        await sitting.press("o")
        assert where(sitting) == "Before 30: A=1"
        await mark_line(sitting, 40)
        await sitting.press("t")
        assert where(sitting) == "Before 40: END"
        await sitting.press("u")
        assert "subroutine" in str(debugger(sitting).query_one(".wrong", Static).visual)


@piloted
async def test_a_variable_is_changed_and_the_machine_checks_it(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await stopped_at(sitting, "10 A%=1\n20 A%=A%+1\n30 END\n", 20)
        await sitting.press("right", "enter")
        ask = sitting.app.screen
        assert isinstance(ask, AskLine)
        assert ask.query_one(Input).value == "A%=1"
        ask.query_one(Input).value = "A%=99999"
        await sitting.press("enter")
        assert "?OV Error" in str(ask.query_one(".wrong", Static).visual)
        ask.query_one(Input).value = "A%=41"
        await sitting.press("enter")
        assert variable(sitting, "A%") == "41"
        await sitting.press("f7")
        assert variable(sitting, "A%") == "42"


@piloted
async def test_memory_is_seen_and_poked(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await stopped_at(sitting, "10 CLS\n20 END\n", 20)
        await sitting.press("m")
        assert rows(sitting, "memory")[0] == "3C00  20 20 20 20 20 20 20 20          "
        await sitting.press("enter", "6", "6", "enter")
        assert rows(sitting, "memory")[0].startswith("3C00  42 20")
        await sitting.press("a", *"42E9", "H", "enter")
        assert rows(sitting, "memory")[0].startswith("42E9  ")
        await sitting.press("m")
        assert not debugger(sitting).query_one("#memory").display


@piloted
async def test_a_condition_is_given_to_a_breakpoint(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await stopped_at(sitting, "10 FOR I=1 TO 9\n20 A=I\n30 NEXT\n", 20)
        await sitting.press("i", *"I", "greater_than_sign", *"6", "enter")
        assert rows(sitting, "listing")[1].startswith("?>20")
        await sitting.press("g")
        await sitting.pass_time(1)
        assert variable(sitting, "I") == "7"


@piloted
async def test_where_an_answer_is_wanted_the_machine_is_seen_and_the_debugger_comes_back(
    sit_down: Opener,
) -> None:
    async with sit_down() as sitting:
        await stopped_at(sitting, "10 INPUT A\n20 END\n", 10)
        await sitting.press("f7")
        await sitting.pass_time(0.3)
        assert sitting.app.at_the_keyboard
        assert sitting.app.session.waiting is Waiting.INPUT
        await sitting.press("7", "enter")
        await sitting.pass_time(2)
        assert where(sitting) == "Before 20: END"
        assert variable(sitting, "A") == "7"


@piloted
async def test_an_error_brings_the_debugger_to_the_statement(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await stopped_at(sitting, "10 A=1\n20 B=1:A=A/0\n", 10)
        await sitting.press("g")
        await sitting.pass_time(1)
        assert where(sitting) == "?/0 Error in 20"
        await sitting.press("b")
        assert where(sitting) == "Back before 20 (statement 2): A=A/0"


@piloted
async def test_a_click_sets_a_breakpoint_and_takes_it_off(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await stopped_at(sitting, "10 A=1\n20 B=2\n30 END\n", 10)
        listing = debugger(sitting).query_one("#listing", OptionList)
        for breakpoints in ([10, 20], [10]):
            await sitting.pilot.click(listing, offset=(8, 1))
            await sitting.settle()
            assert list(sitting.app.debugger.breakpoints) == breakpoints


@piloted
async def test_closed_it_stands_and_goes_on_with_f6(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await stopped_at(sitting, "10 A=1\n20 GOTO 20\n", 20)
        await sitting.press("space", "escape")
        rig = sitting.app.session.rig
        now = rig.clock.now
        await sitting.pass_time(1)
        assert rig.clock.now == now
        await sitting.press("f7")
        assert rig.basic.next_line == 20
        now = rig.clock.now
        await sitting.press("f6")
        await sitting.pass_time(1)
        assert rig.clock.now > now


@piloted
async def test_the_machine_behind_is_seen_until_a_key(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await stopped_at(sitting, "10 A=1\n20 END\n", 20)
        await sitting.press("v")
        box = debugger(sitting).query_one(".dialog")
        assert not box.display
        await sitting.press("f7")
        assert box.display
        assert where(sitting) == "Breakpoint before 20: END"


@piloted
async def test_states_are_saved_loaded_and_removed_by_keys(
    sit_down: Opener, tmp_path: Path
) -> None:
    async with sit_down() as sitting:
        await stopped_at(sitting, "10 A=A+1\n20 GOTO 10\n", 20)
        rig = sitting.app.session.rig
        before = rig.snapshot()
        await sitting.press("w", "s")
        ask = sitting.app.screen
        ask.query_one(Input).value = "first"
        await sitting.press("enter")
        assert (tmp_path / "state" / "states" / "first.state").is_file()
        await sitting.press("escape", "f7", "f7", "shift+f3", "w")
        states = sitting.app.screen
        assert isinstance(states, StatesScreen)
        await sitting.press("down", "enter")
        assert rig.snapshot() == before
        await sitting.press("shift+f2")
        assert variable(sitting, "A") == "2"
        await sitting.press("w", "x", "x", "x")
        assert not list((tmp_path / "state" / "states").iterdir())


@piloted
async def test_a_bad_state_is_told_in_a_line(sit_down: Opener, tmp_path: Path) -> None:
    folder = tmp_path / "state" / "states"
    folder.mkdir(parents=True)
    (folder / "quick.state").write_bytes(b"nonsense")
    async with sit_down() as sitting:
        sitting.app.commands.debug.quick_load()
        await sitting.settle()
        assert "quick.state: no saved state of this version" in sitting.app._notice


@piloted
async def test_back_from_the_desk_takes_the_arm_with_it(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.run_program("10 @STEP 9,300\n20 GOTO 20\n", 2.5)
        assert sitting.app.session.rig.registers[0] == 300
        sitting.app.debugger.set(10)
        await sitting.press("ctrl+x", "r")
        assert where(sitting) == "Back before 10: @STEP 9,300"
        assert sitting.app.session.rig.registers[0] == 0
        await sitting.press("f7")
        assert sitting.app.session.rig.registers[0] == 300


@pytest.mark.parametrize(("width", "height"), [(80, 24), (120, 40)])
def test_a_watch_is_set_by_keys_and_stops_with_what_changed(
    sit_down: Opener, width: int, height: int
) -> None:
    @piloted
    async def watch() -> None:
        async with sit_down(width, height) as sitting:
            sitting.app.session.rig.load_text("10 A=1\n20 OUT 152,9\n30 A=2\n40 GOTO 40\n")
            await sitting.press("f7")
            await sitting.settle()
            for what in ("A", "latch base"):
                await sitting.press("e")
                await sitting.settle()
                asked = sitting.app.screen
                assert isinstance(asked, AskLine)
                asked.query_one(Input).value = what
                await sitting.press("enter")
                await sitting.settle()
            assert rows(sitting, "variables")[:2] == ["* A none", "* latch base 0000"]
            await sitting.press("escape", "f5")
            told = []
            for _ in range(3):
                for _ in range(60):
                    await sitting.pass_time(0.1)
                    if isinstance(sitting.app.screen, DebuggerScreen):
                        break
                told.append(where(sitting).splitlines()[0])
                assert told[-1].split(":")[0] in screen_text(sitting.app)
                await sitting.press("g")
            assert told == [
                "A none -> 1: before 20: OUT 152,9",
                "latch base 0000 -> 1001: before 30: A=2",
                "A 1 -> 2: before 40: GOTO 40",
            ]

    watch()
