"""What the user is told, and where: faults of devices at once, notices beside the state."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from textual import events

from tests.own_places import PROGRAMS
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener
from tests.ui.test_file_dialogs import type_name
from trs80arm.rig import RigSettings, Waiting
from trs80arm.ui.app import NOTICE_SECONDS


@pytest.mark.parametrize(
    ("setting", "said", "line"),
    [("tape_folder", "cassette: ", 'CSAVE "A"'), ("printer_file", "printer: ", 'LPRINT "X"')],
)
@piloted
async def test_what_a_device_cannot_write_is_told_at_once(
    sit_down: Opener, tmp_path: Path, setting: str, said: str, line: str
) -> None:
    (tmp_path / "file").write_text("")
    rig = RigSettings(**{setting: tmp_path / "file" / "none"})
    async with sit_down(120, 40, rig=rig) as sitting:
        await sitting.type_line("10 REM")
        assert said not in screen_text(sitting.app)
        await sitting.type_line(line)
        await sitting.pass_time(0.2)
        assert said in screen_text(sitting.app)
        assert sitting.app.session.rig.waiting is Waiting.COMMAND


@piloted
async def test_a_notice_stands_beside_what_the_machine_waits_for(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.type_line("@SET")
        sitting.app.say("Position 1 is taught.")
        await sitting.pass_time(0.2)
        status = screen_text(sitting.app).splitlines()[-2]
        assert "@SET" in status
        assert "0 ends" in status
        assert "Position 1 is taught." in status


@piloted
async def test_a_notice_that_is_too_long_has_lines_of_its_own_for_as_long_as_it_stands(
    sit_down: Opener,
) -> None:
    async with sit_down(60, 60) as sitting:
        before = screen_text(sitting.app).splitlines()
        sitting.app.say("word " * 15 + "end.")
        await sitting.pass_time(0.3)
        during = screen_text(sitting.app).splitlines()
        assert during[-4].startswith("word word")
        assert during[-3].endswith("word end.")
        assert "at READY" in during[-2]
        assert during[-1] == before[-1]
        assert during[:-4] == before[:-4]
        await sitting.pass_time(NOTICE_SECONDS)
        after = screen_text(sitting.app).splitlines()
        assert after[:-2] == before[:-2]


@piloted
async def test_the_frames_say_which_program_and_bench_there_are(sit_down: Opener) -> None:
    async with sit_down(120, 40, program=PROGRAMS / "table4.bas") as sitting:
        assert "─ table4.bas ─" in screen_text(sitting.app)
        assert "─ bench table4 ─" in screen_text(sitting.app)
        await sitting.type_line("10 REM MINE")
        await sitting.pass_time(0.2)
        assert "─ table4.bas, changed ─" in screen_text(sitting.app)
    async with sit_down(120, 40) as sitting:
        await sitting.type_line("10 REM MINE")
        await sitting.pass_time(0.2)
        assert "─ new program ─" in screen_text(sitting.app)


@piloted
async def test_a_pasted_listing_is_entered_at_once_or_typed_on_demand(sit_down: Opener) -> None:
    listing = "".join(f"{10 * n} PRINT {n}\r" for n in range(1, 101))
    async with sit_down() as sitting:
        rig = sitting.app.session.rig
        sitting.app.post_message(events.Paste(listing))
        await sitting.pilot.pause()
        await sitting.pass_time(0.1)
        assert len(list(rig.basic.program.lines())) == 100
        assert "100 lines" in screen_text(sitting.app)
        assert not rig.typing


@piloted
async def test_a_pipe_is_neither_offered_nor_waited_for(sit_down: Opener, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "zz.bas")
    async with sit_down() as sitting:
        await sitting.press("f2")
        await type_name(sitting, "zz.bas")
        await sitting.press("enter")
        await sitting.settle()
        assert "There is no file zz.bas." in screen_text(sitting.app)
        await sitting.press("escape")
        await sitting.type_line("PRINT 6*7")
        assert "\n 42\n" in sitting.tube


@piloted
async def test_the_score_is_told_when_a_program_ends_and_shown_on_demand(
    sit_down: Opener, tmp_path: Path
) -> None:
    bench = tmp_path / "one.toml"
    bench.write_text(
        "[[part]]\nname='block'\nat=[8, 0]\nsize=[1, 1, 1]\n[[goal]]\npart='block'\nat=[8, 0.5]\n"
    )
    async with sit_down(100, 30, bench=bench) as sitting:
        await sitting.type_line("10 PRINT 2")
        await sitting.type_line("RUN")
        await sitting.pass_time(0.2)
        assert "0 of 1 goal met; error 0.500 in" in screen_text(sitting.app)
        await sitting.app.run_action("do('score')")
        await sitting.pilot.pause()
        assert "NOT  block at (8, 0.5)   0.500 in" in screen_text(sitting.app)


@piloted
async def test_what_is_wrong_in_the_program_is_listed_and_the_line_chosen_is_shown(
    sit_down: Opener,
) -> None:
    async with sit_down(100, 30) as sitting:
        await sitting.type_line("10 PRINT 1")
        await sitting.type_line("20 GOTO 99")
        await sitting.app.run_action("do('check')")
        await sitting.pilot.pause()
        assert "20 error: there is no line 99 (?UL)" in screen_text(sitting.app)
        await sitting.press("enter")
        await sitting.pass_time(1.0)
        assert "LIST 20\n20 GOTO 99" in sitting.tube
