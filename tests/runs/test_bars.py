"""Bars on standard error: what they say, and that they change nothing of a run."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import pytest

from trs80arm import bars
from trs80arm.batch import BatchOptions, run_program
from trs80arm.operator import Operator, parse_holds
from trs80arm.rig import Rig

PROGRAM = '10 PRINT "A":@STEP 50,400\n20 INPUT A\n30 @SET\n40 PRINT "B";\n'


class Screen(io.StringIO):
    """A terminal."""

    def isatty(self) -> bool:
        return True


@pytest.fixture
def options(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[BatchOptions]:
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "100")
    monkeypatch.setattr(bars, "_SOON", -1.0)
    (tmp_path / "task.bas").write_text(PROGRAM)
    return BatchOptions(tmp_path / "task.bas", inputs=("5",), sets=("1:1 2:0.4 0",), seconds=60)


def everything_of(terminal: int) -> str:
    """What a terminal was sent that nobody writes to any more."""
    shown = b""
    with suppress(OSError):  # Which is how some systems tell the end.
        while some := os.read(terminal, 1 << 16):
            shown += some
    os.close(terminal)
    return shown.decode()


def test_a_run_says_how_far_it_is_and_what_it_does(
    options: BatchOptions, monkeypatch: pytest.MonkeyPatch
) -> None:
    screen, printed = Screen(), io.StringIO()
    monkeypatch.setattr(sys, "stderr", screen)
    # It ends in the middle of a motion, and so does what was shown last.
    assert run_program(replace(options, seconds=1.0), printed) == 0
    shown = screen.getvalue()
    assert "task" in shown
    assert " of 1 s line 10 @STEP" in shown
    assert "A\n" not in shown, "what is printed elsewhere does not come here"
    assert printed.getvalue() == "A\n"


def test_where_standard_error_is_no_terminal_there_is_no_bar_and_the_run_is_the_same(
    options: BatchOptions, monkeypatch: pytest.MonkeyPatch
) -> None:
    log, printed = io.StringIO(), io.StringIO()
    monkeypatch.setattr(sys, "stderr", log)
    assert run_program(options, printed) == 0
    assert (log.getvalue(), printed.getvalue()) == ("", "A\n? 5\nB\n")


def test_a_quick_run_has_none(options: BatchOptions, monkeypatch: pytest.MonkeyPatch) -> None:
    screen = Screen()
    monkeypatch.setattr(sys, "stderr", screen)
    monkeypatch.setattr(bars, "_SOON", 1000.0)
    assert run_program(options, io.StringIO()) == 0
    assert "task" not in screen.getvalue()


def test_on_one_terminal_what_is_printed_stays_above_the_bar(
    options: BatchOptions, monkeypatch: pytest.MonkeyPatch
) -> None:
    master, slave = os.openpty()
    with os.fdopen(slave, "w") as terminal:
        monkeypatch.setattr(sys, "stderr", terminal)
        assert run_program(options, terminal) == 0
    shown = everything_of(master)
    assert "task" in shown
    printed = [line.rsplit("\x1b[2K")[-1] for line in shown.split("\r\n")]
    assert [line for line in printed if line in ("A", "? 5", "B")] == ["A", "? 5", "B"]


def test_who_looks_on_changes_nothing_of_a_run() -> None:
    def end(look: Callable[[Rig], None] | None) -> tuple[object, ...]:
        rig = Rig()
        rig.load_text(PROGRAM)
        rig.type("RUN\r")
        sets = [parse_holds("1:1 2:0.4 0")]
        Operator(rig, ["5"], sets, [(9.0, parse_holds("Q")[0])], look).run(60)
        return rig.clock.now, rig.registers, rig.joints, tuple(rig.screen())

    seen: list[float] = []
    assert end(lambda rig: seen.append(rig.time)) == end(None)
    assert len(seen) > 8


def test_things_done_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    for stream, shown in ((Screen(), True), (io.StringIO(), False)):
        monkeypatch.setattr(sys, "stderr", stream)
        with bars.counting("programs", 2, 1) as advance:
            advance()
        assert ("programs" in stream.getvalue()) is shown
        assert ("2/2" in stream.getvalue()) is shown
