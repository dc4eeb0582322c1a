"""An exception in the core, which must not happen: one sentence, and nothing is lost."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from trs80arm import Rig
from trs80arm.desk import recording
from trs80arm.desk.last_resort import last_words
from trs80arm.desk.session import Session

FAULTY = """
from trs80arm.machine.ports import Ports
def fault(self, port):
    raise KeyError("forced")
Ports.read = fault
from trs80arm.cli import main; main()
"""
"""The program with a fault in it: INP fails."""


def faulty(folder: Path, arguments: list[str], typed: str) -> subprocess.CompletedProcess[str]:
    environment = os.environ | {"TRS80ARM_CONFIG": "/dev/null", "TRS80ARM_STATE": str(folder)}
    return subprocess.run(
        [sys.executable, "-c", FAULTY, *arguments],
        input=typed,
        env=environment,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )


def test_a_fault_in_line_mode_keeps_machine_and_recording(tmp_path: Path) -> None:
    done = faulty(tmp_path, ["--plain"], "10 REM KEPT\nPRINT INP(5)\n")
    assert done.returncode == 3
    assert "Traceback" not in done.stderr
    assert done.stderr.count("\n") == 1
    assert "a fault of the program itself: KeyError" in done.stderr
    assert str(tmp_path) in done.stderr
    report = (tmp_path / "fault-1.txt").read_text()
    assert "KeyError: 'forced'" in report
    assert "Python" in report
    rig = Rig()
    rig.restore((tmp_path / "fault-1.snapshot").read_bytes())
    assert [number for number, _ in rig.basic.program.lines()] == [10]
    played = recording.load(tmp_path / "fault-1.jsonl")
    assert any(done.action == "type" for done in played.inputs)


def test_a_fault_in_a_run_without_a_screen_is_one_sentence(tmp_path: Path) -> None:
    program = tmp_path / "a.bas"
    program.write_text("10 PRINT INP(5)\n")
    done = faulty(tmp_path, ["run", str(program)], "")
    assert done.returncode == 3
    assert done.stderr.startswith("trs80arm: a fault of the program itself: KeyError")
    assert (tmp_path / "fault-1.txt").is_file()


def test_what_cannot_be_kept_is_no_second_fault(tmp_path: Path) -> None:
    session = Session()
    folder = tmp_path / "file"
    folder.write_text("no folder")
    words = last_words(RuntimeError("x"), folder / "state", session)
    assert words == "a fault of the program itself: RuntimeError"


def test_older_reports_are_not_replaced(tmp_path: Path) -> None:
    for number in (1, 2):
        assert f"fault-{number}.txt" in last_words(RuntimeError("x"), tmp_path)
