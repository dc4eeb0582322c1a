"""The program as its user meets it: keys into the machine, commands, dialogs, leaving."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from textual import events
from textual.widgets import Input, OptionList

from tests.own_places import PROGRAMS
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.basic.activity import Waiting
from trs80arm.machine.keys import Key
from trs80arm.options import GlyphSet, KeyMode
from trs80arm.ui.screens.dialog import Ask, AskPath, Choose
from trs80arm.ui.screens.help import HelpScreen
from trs80arm.ui.screens.open import OpenScreen
from trs80arm.ui.terminal.messages import KeyReport, KeyWentDown, KeyWentUp


async def terminal_says(sitting: Sitting, *messages: Any) -> None:
    for message in messages:
        sitting.app.post_message(message)
    await sitting.pilot.pause()


def down(text: str) -> KeyWentDown:
    return KeyWentDown(f"{ord(text)}u", text, text)


def up(text: str) -> KeyWentUp:
    return KeyWentUp(f"{ord(text)}u")


@piloted
async def test_the_first_start_says_on_the_tube_what_to_type(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        tube = sitting.tube
        assert "RADIO SHACK LEVEL II BASIC" in tube
        for word in ("@SET", "F1", "F2", "F5", "F10", "TABLE4"):
            assert word in tube
        assert tube.rstrip().endswith(">_")


@piloted
async def test_typed_keys_reach_the_prompt_in_order(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        for key in ("P", "r", "i", "n", "t", "space", "2", "*", "2", "1", "enter"):
            name = {"*": "asterisk"}.get(key, key)
            text = {"space": " ", "enter": "\r"}.get(key, key)
            sitting.app.desk.tube.post_message(events.Key(name, text))
        await sitting.pilot.pause()
        await sitting.pass_time(1.5)
        assert ">PRINT 2*21\n 42\n" in sitting.tube


@piloted
async def test_a_paste_goes_flat_out_and_then_the_speed_is_what_it_was(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        sitting.app.post_message(events.Paste("PRINT 1\rPRINT 6*7"))
        await sitting.pilot.pause()
        sitting.wall.now += 0.2
        sitting.app.tick()
        await sitting.settle()
        assert sitting.app.pacer.turbo
        assert "turbo" in screen_text(sitting.app)
        await sitting.pass_time(0.3)
        assert "PRINT 6*7" in sitting.tube
        assert not sitting.app.pacer.turbo
        assert sitting.app.pacer.speed == 1


@piloted
async def test_escape_in_a_paste_stops_it_at_once(sit_down: Opener) -> None:
    async with sit_down(turbo=False) as sitting:
        sitting.app.post_message(
            events.Paste("PRINT 1\rPRINT 2222222222222222222222222\rPRINT 3\r")
        )
        await sitting.pilot.pause()
        await sitting.pass_time(3)
        sitting.wall.now += 10
        await sitting.settle()
        assert "to go: Escape stops" in screen_text(sitting.app)
        await sitting.press("escape")
        await sitting.pass_time(5)
        rig = sitting.app.session.rig
        assert rig.waiting is Waiting.COMMAND
        assert not rig.typing
        tube = sitting.tube
        assert "\n 1\n" in tube
        assert "\n 2" not in tube
        assert "\n 3" not in tube
        await sitting.type_line("PRINT 6*7")
        assert "\n 42\n" in sitting.tube


@piloted
async def test_a_paste_is_typed_without_losing_a_character(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        listing = 'new\r\n10 print "ABCDEFGH";\r\n20 goto 30\n30 end\r'
        sitting.app.post_message(events.Paste(listing))
        await sitting.pilot.pause()
        await sitting.pass_time(12)
        rig = sitting.app.session.rig
        assert [number for number, _ in rig.basic.program.lines()] == [10, 20, 30]


@piloted
async def test_two_joints_move_while_two_keys_are_really_held(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        rig = sitting.app.session.rig
        await sitting.begin_manual_mode()
        await terminal_says(sitting, KeyReport(True), down("1"), down("w"))
        await sitting.pass_time(0.5)
        assert rig.held == {Key.N1, Key.W}
        await terminal_says(sitting, up("1"))
        await sitting.pass_time(0.1)
        base, shoulder = rig.registers[:2]
        await terminal_says(sitting, up("w"))
        await sitting.pass_time(0.5)
        assert base > 100
        assert shoulder < -base
        assert rig.registers[0] == base
        assert not rig.held
        await terminal_says(sitting, down("0"), up("0"))
        await sitting.pass_time(0.3)
        assert rig.waiting is Waiting.COMMAND


@piloted
async def test_a_tap_without_releases_jogs_a_tenth_of_a_second(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        rig = sitting.app.session.rig
        await sitting.begin_manual_mode()
        sitting.app.desk.tube.post_message(events.Key("1", "1"))
        await sitting.pilot.pause()
        await sitting.pass_time(1)
        assert 20 < rig.registers[0] < 60


@piloted
async def test_latch_mode_holds_two_joints_until_space(sit_down: Opener) -> None:
    async with sit_down(keys=KeyMode.LATCH) as sitting:
        rig = sitting.app.session.rig
        await sitting.begin_manual_mode()
        for key in ("1", "w"):
            sitting.app.desk.tube.post_message(events.Key(key, key))
        await sitting.pilot.pause()
        await sitting.pass_time(0.5)
        assert rig.held == {Key.N1, Key.W}
        sitting.app.desk.tube.post_message(events.Key("space", " "))
        await sitting.pilot.pause()
        await sitting.pass_time(0.1)
        assert not rig.held


@pytest.mark.parametrize("how", ["blur", "dialog", "palette"])
@piloted
async def test_every_key_is_let_go_when_the_keyboard_goes_elsewhere(
    sit_down: Opener, how: str
) -> None:
    async with sit_down() as sitting:
        rig = sitting.app.session.rig
        await sitting.begin_manual_mode()
        await terminal_says(sitting, KeyReport(True), down("1"), down("w"))
        await sitting.pass_time(0.1)
        assert len(rig.held) == 2
        if how == "blur":
            await terminal_says(sitting, events.AppBlur())
        elif how == "dialog":
            await sitting.press("f1")
        else:
            await sitting.press("ctrl+p")
        await sitting.pass_time(0.1)
        assert not rig.held
        await terminal_says(sitting, down("2"))
        await sitting.pass_time(0.1)
        assert how == "blur" or not rig.held


@piloted
async def test_the_mouse_holds_a_key_until_it_is_let_go_anywhere(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        rig = sitting.app.session.rig
        await sitting.begin_manual_mode()
        await sitting.press("ctrl+k")
        await sitting.settle()
        assert sitting.app.desk.panels["matrix"].key_at(3, 0) is Key.N1
        await sitting.pilot.mouse_down("#matrix", offset=(3, 0))
        await sitting.pass_time(0.2)
        assert rig.held == {Key.N1}
        await sitting.pilot.hover("#tube", offset=(5, 5))
        await sitting.pilot.mouse_up("#tube", offset=(5, 5))
        await sitting.pass_time(0.1)
        assert not rig.held
        assert rig.registers[0] > 0


@piloted
async def test_f5_runs_and_escape_breaks(sit_down: Opener, tmp_path: Path) -> None:
    program = tmp_path / "loop.bas"
    program.write_text("10 GOTO 10\n")
    async with sit_down(program=program) as sitting:
        await sitting.press("f5")
        await sitting.pass_time(1.5)
        assert sitting.app.session.rig.waiting is Waiting.NOTHING
        await sitting.press("escape")
        await sitting.pass_time(0.2)
        assert "BREAK IN 10" in sitting.tube.upper()


@piloted
async def test_opening_a_program_shows_it_first(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("f2")
        assert isinstance(sitting.app.screen, OpenScreen)
        await sitting.press(*"table2.")
        await sitting.pilot.pause()
        preview = sitting.app.screen.query_one("#preview").render()
        assert "@CLOSE" in str(preview)
        await sitting.press("enter")
        await sitting.settle()
        assert sitting.app.session.path == PROGRAMS / "table2.bas"
        assert len(sitting.app.session.program) == 9


@piloted
async def test_leaving_with_an_unsaved_program_asks(sit_down: Opener, tmp_path: Path) -> None:
    async with sit_down() as sitting:
        await sitting.type_line('10 PRINT "MINE"')
        await sitting.press("f10")
        assert isinstance(sitting.app.screen, Ask)
        await sitting.press("enter")
        await sitting.settle()
        assert isinstance(sitting.app.screen, AskPath)
        sitting.app.screen.query_one(Input).value = str(tmp_path / "mine.bas")
        await sitting.press("enter")
        await sitting.pilot.pause()
    assert sitting.app.return_code == 0
    assert (tmp_path / "mine.bas").read_text() == '10 PRINT "MINE"\n'


@piloted
async def test_the_first_letter_of_an_answer_goes_to_it(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.type_line('10 PRINT "MINE"')
        await sitting.press("f10", "x", "b")
        assert isinstance(sitting.app.screen, Ask)
        await sitting.press("enter")
        await sitting.settle()
        assert not isinstance(sitting.app.screen, Ask)
        await sitting.press("f10", "l", "enter")
        await sitting.pilot.pause()
    assert sitting.app.return_value == 0


@piloted
async def test_leaving_with_a_saved_program_does_not_ask(sit_down: Opener) -> None:
    async with sit_down(program=PROGRAMS / "table4.bas") as sitting:
        await sitting.press("f10")
        await sitting.pilot.pause()
    assert sitting.app.return_value == 0


@piloted
async def test_asked_to_leave_twice_it_leaves_and_keeps_a_copy(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.type_line('10 PRINT "MINE"')
        await sitting.press("ctrl+c")
        await sitting.press("ctrl+c")
        await sitting.pilot.pause()
    assert sitting.app.return_value == 0
    assert sitting.app.recovery.program_copy.is_file()


@piloted
async def test_where_no_copy_can_be_kept_asking_twice_does_not_leave(
    sit_down: Opener, tmp_path: Path
) -> None:
    (tmp_path / "state").write_text("a file where a folder should be")
    async with sit_down() as sitting:
        await sitting.type_line('10 PRINT "MINE"')
        await sitting.press("ctrl+c", "ctrl+c")
        await sitting.settle()
        assert isinstance(sitting.app.screen, Ask)
        assert "No recovery copy" in str(next(iter(sitting.app._notifications)).message)


@piloted
async def test_a_file_that_is_not_the_programs_own_is_not_replaced_without_asking(
    sit_down: Opener, tmp_path: Path
) -> None:
    other = tmp_path / "program.bas"
    other.write_text("10 REM SOMETHING ELSE\n")
    async with sit_down() as sitting:
        await sitting.type_line('10 PRINT "MINE"')
        await sitting.press("f3", "enter")
        await sitting.settle()
        assert "SOMETHING ELSE" in other.read_text()
        await sitting.press("enter")
        await sitting.settle()
        assert "MINE" in other.read_text()
        await sitting.type_line('10 PRINT "AGAIN"')
        await sitting.press("f3", "enter")
        await sitting.settle()
        assert "AGAIN" in other.read_text()


@piloted
async def test_a_left_over_copy_is_told_and_offered(sit_down: Opener, tmp_path: Path) -> None:
    state = tmp_path / "state"
    state.mkdir()
    (state / "recovered-20200101-000000.bas").write_text("10 REM LOST\n")
    async with sit_down() as sitting:
        await sitting.press("f2")
        await sitting.settle()
        options = sitting.app.screen.query_one("OptionList")
        assert "Recovered" in str(options.get_option_at_index(0).prompt)


@piloted
async def test_the_speed_is_chosen_from_a_list(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("f8")
        assert isinstance(sitting.app.screen, Choose)
        await sitting.press("down", "down", "enter")
        await sitting.settle()
        assert sitting.app.pacer.speed == 5.0
        before = sitting.app.session.time
        await sitting.pass_time(1)
        assert sitting.app.session.time - before == pytest.approx(5.0, rel=0.05)


@piloted
async def test_the_bench_that_stands_is_marked_in_the_list(
    sit_down: Opener, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(PROGRAMS.parent)
    async with sit_down(program=Path("programs/table4.bas")) as sitting:
        await sitting.press("ctrl+b")
        await sitting.settle()
        options = sitting.app.screen.query_one(OptionList)
        marked = [str(row.prompt) for row in options.options if str(row.prompt)[0] == "*"]
        assert [row.split()[1] for row in marked] == ["table4"]


@piloted
async def test_pause_stops_the_clock(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("f6")
        before = sitting.app.session.time
        await sitting.pass_time(1)
        assert sitting.app.session.time == before


@piloted
async def test_the_choice_of_glyphs_is_remembered(sit_down: Opener, tmp_path: Path) -> None:
    path = tmp_path / "settings.toml"
    async with sit_down(settings_file=path) as sitting:
        await sitting.app.run_action("do('glyphs')")
        await sitting.press("down", "enter")
        await sitting.settle()
        assert sitting.app.desk.tube.glyph_set is GlyphSet.BRAILLE
    assert 'glyphs = "braille"' in path.read_text()


@piloted
async def test_help_is_one_page_that_says_why_keys_work_as_they_do(sit_down: Opener) -> None:
    async with sit_down(100, 30) as sitting:
        await sitting.press("f1")
        assert isinstance(sitting.app.screen, HelpScreen)
        await sitting.press("escape")
        assert sitting.app.at_the_keyboard


@piloted
async def test_a_small_terminal_gets_a_message(sit_down: Opener) -> None:
    async with sit_down(39, 20) as sitting:
        assert not sitting.app.desk.tube.display
        await sitting.type_line("PRINT 6*7")
        await sitting.pass_time(1)
        assert not sitting.app.desk.tube.is_attached
        await sitting.pilot.resize_terminal(80, 24)
        await sitting.settle()
        assert sitting.app.desk.tube.display
        assert " 42" in sitting.tube
        assert " 42" in screen_text(sitting.app)


@piloted
async def test_ctrl_keys_are_not_the_machines(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await terminal_says(
            sitting, KeyReport(True), KeyWentDown("112u", "ctrl+p", None), KeyWentUp("112u")
        )
        await sitting.pass_time(0.2)
        assert sitting.tube.rstrip().endswith(">_")


@piloted
async def test_break_ends_a_pause(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("f6")
        await sitting.press("escape")
        await sitting.pilot.pause()
        assert not sitting.app.pacer.paused


@piloted
async def test_one_statement_at_a_time(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.type_line("10 A=1")
        await sitting.type_line("20 GOTO 10")
        await sitting.press("f5")
        await sitting.pass_time(1.5)
        lines = set()
        for _ in range(4):
            sitting.app.debugger.into()
            stop = sitting.app.debugger.stop
            assert stop is not None
            lines.add(stop.spot and stop.spot.line)
        assert lines == {10, 20}


@piloted
async def test_one_motor_step_at_a_time(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        rig = sitting.app.session.rig
        rig.type("@STEP 50,20\r")
        rig.run_until(lambda rig: rig.registers[0] > 3)
        before = rig.registers[0]
        await sitting.press("shift+f7")
        await sitting.press("shift+f7")
        await sitting.pilot.pause()
        assert rig.registers[0] == before + 2


@piloted
async def test_a_recovered_program_is_unsaved_and_its_copy_goes(
    sit_down: Opener, tmp_path: Path
) -> None:
    left = tmp_path / "state" / "recovered-20200101-000000.bas"
    left.parent.mkdir()
    left.write_text("10 REM LOST\n")
    async with sit_down() as sitting:
        sitting.app.commands.files.load_file(left)
        assert sitting.app.session.unsaved
        assert sitting.app.session.path is None
        assert not left.exists()
        assert sitting.app.recovery.program_copy.is_file()


@piloted
async def test_a_key_ends_the_demonstration_and_is_not_typed(sit_down: Opener) -> None:
    async with sit_down(demo=True) as sitting:
        await sitting.pass_time(1)
        sitting.app.desk.tube.post_message(events.Key("x", "x"))
        await sitting.pilot.pause()
        await sitting.pass_time(1)
        assert sitting.app.session.path is not None
        assert ">X" not in sitting.tube
        sitting.app.desk.tube.post_message(events.Key("y", "y"))
        await sitting.pilot.pause()
        await sitting.pass_time(0.5)
        assert sitting.tube.rstrip().endswith(">Y_")


async def hide_the_tube(sitting: Sitting, how: str) -> None:
    """Bring the program to where the tube is not shown, or was not a moment ago."""
    if how == "zoomed":
        await sitting.press("f11")
    elif how == "zoomed and back":
        await sitting.press("f11", "f11")
    elif how == "a panel large":
        await sitting.app.run_action("do('fill_events')")
    elif how == "too small and back":
        await sitting.pilot.resize_terminal(50, 12)
        await sitting.settle()
        await sitting.pilot.resize_terminal(80, 24)
    elif how == "a click beside it":
        await sitting.pilot.click("#side", offset=(3, 3))
    elif how == "a dialog and back":
        await sitting.press("f1", "escape")
    await sitting.settle()


HIDDEN = [
    *("zoomed", "zoomed and back", "a panel large", "too small and back"),
    *("a click beside it", "a dialog and back"),
]


@pytest.mark.parametrize("how", HIDDEN)
@piloted
async def test_plain_keys_are_the_machines_whatever_is_shown(sit_down: Opener, how: str) -> None:
    async with sit_down() as sitting:
        await hide_the_tube(sitting, how)
        await sitting.press("a", "tab", "b")
        await sitting.pass_time(1)
        assert ">A      B" in sitting.tube


@pytest.mark.parametrize("how", HIDDEN)
@pytest.mark.parametrize("releases", [True, False])
@piloted
async def test_the_arm_is_jogged_and_stopped_whatever_is_shown(
    sit_down: Opener, how: str, releases: bool
) -> None:
    async with sit_down() as sitting:
        rig = sitting.app.session.rig
        await sitting.begin_manual_mode()
        await hide_the_tube(sitting, how)
        if releases:
            await terminal_says(sitting, KeyReport(True), down("1"))
            await sitting.pass_time(0.3)
            await terminal_says(sitting, up("1"), KeyWentDown("27u", "escape", None))
            await sitting.pass_time(0.2)
            await terminal_says(sitting, KeyWentUp("27u"))
        else:
            await sitting.press("1")
            await sitting.pass_time(0.3)
            await sitting.press("escape")
            await sitting.pass_time(0.3)
        assert rig.registers[0] > 10
        assert rig.waiting is Waiting.COMMAND
