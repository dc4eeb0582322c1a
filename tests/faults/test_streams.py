"""Standard streams that are closed, full, narrow or gone: one line at most, and no traceback."""

from __future__ import annotations

import os
import shlex
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from trs80arm.cli import main

LISTING = '10 FOR I=1 TO 3000:PRINT "LINE";I:NEXT:PRINT CHR$(191)\n'


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "a.bas"
    path.write_text(LISTING)
    return path


def shell(line: str, **more: str) -> subprocess.CompletedProcess[bytes]:
    """What a shell makes of a command line in which ARM stands for the program's name."""
    command = f"{shlex.quote(sys.executable)} -m trs80arm"
    environment = os.environ | {"TRS80ARM_CONFIG": "/dev/null", "LC_ALL": "C.UTF-8"} | more
    return subprocess.run(
        ["bash", "-c", line.replace("ARM", command)],
        capture_output=True,
        env=environment,
        timeout=120,
        check=False,
    )


def test_a_reader_that_leaves_is_no_error(program: Path) -> None:
    done = shell(f"set -o pipefail; ARM run {shlex.quote(str(program))} | head -1")
    assert done.stdout == b"LINE 1 \n"
    assert done.stderr == b""
    assert done.returncode == 141


def test_a_full_disk_behind_standard_output_is_told_in_one_line(program: Path) -> None:
    done = shell(f"ARM run {shlex.quote(str(program))} > /dev/full")
    assert done.stderr == b"trs80arm: standard output: No space left on device\n"
    assert done.returncode == 2


@pytest.mark.parametrize("closed", [">&-", "2>&-", "<&-", ">&- 2>&- <&-"])
def test_closed_streams_are_no_error(program: Path, closed: str) -> None:
    done = shell(f"ARM run {shlex.quote(str(program))} {closed}")
    assert b"Traceback" not in done.stderr
    assert done.returncode == 0


@pytest.mark.parametrize("closed", ["<&-", "<&- 2>&-", "< /dev/null"])
def test_the_line_mode_ends_when_nobody_types(closed: str) -> None:
    done = shell(f"ARM --plain {closed}")
    assert b"READY" in done.stdout
    assert done.stderr == b""
    assert done.returncode == 0


def test_output_that_knows_ascii_only_has_question_marks_for_the_rest(program: Path) -> None:
    done = shell(f"ARM run {shlex.quote(str(program))}", PYTHONIOENCODING="ascii", LC_ALL="C")
    assert done.stdout.endswith(b"LINE 3000 \n?\n")
    assert done.stderr == b""
    assert done.returncode == 0


def test_typed_bytes_that_are_no_text_are_no_error() -> None:
    done = shell("printf 'PRINT 6*7:REM \\xff\\xfe\\n' | ARM --plain", PYTHONUTF8="1")
    assert b" 42 " in done.stdout
    assert done.returncode == 0


def test_an_interrupt_ends_a_run_without_a_traceback(tmp_path: Path) -> None:
    path = tmp_path / "a.bas"
    path.write_text('10 PRINT "UP"\n20 GOTO 20\n')
    arguments = [sys.executable, "-m", "trs80arm", "run", str(path), "--seconds", "1e9"]
    with subprocess.Popen(
        arguments,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=os.environ | {"TRS80ARM_CONFIG": "/dev/null", "PYTHONUNBUFFERED": "1"},
        # Tests may run in the background of a script, which ignores interrupts.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    ) as running:
        assert running.stdout is not None
        try:
            assert running.stdout.readline() == b"UP\n"
            running.send_signal(signal.SIGINT)
            _, told = running.communicate(timeout=60)
        finally:
            running.kill()
    assert told == b""
    assert running.returncode == 130


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--seconds", "inf"], "--seconds"),
        (["--seconds", "nan"], "--seconds"),
        (["--seconds", "1e300"], "--seconds"),
        (["--trace-rate", "nan", "--trace-pose", "/tmp/never.csv"], "--trace-rate"),
        (["--set", f"1:{'9' * 400}"], "a key can be held for 86400 seconds"),
        (["--option", f"speed={'[' * 5000}"], "--option speed"),
        (["--option", f"speed={'9' * 5000}"], "--option speed"),
        (["--bench", "n\x1b]0;X\a.toml"], "n\\x1b]0;X\\x07.toml: cannot be read"),
        (["--tapes", "a\x1bb", "--option", "fps=\x1b[2J"], "\\x1b[2J"),
    ],
    ids=lambda value: None if isinstance(value, str) else " ".join(value)[:30],
)
def test_odd_options_are_told_in_one_line_without_control_codes(
    program: Path,
    options: list[str],
    told: str,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("TRS80ARM_CONFIG", os.devnull)
    monkeypatch.setattr(sys, "argv", ["trs80arm", "run", str(program), *options])
    with pytest.raises(SystemExit) as ended:
        main()
    assert ended.value.code == 2
    line = capfd.readouterr().err
    assert line.startswith("trs80arm: ")
    assert told in line
    assert line.count("\n") == 1
    assert line[:-1].isprintable()


def test_a_program_called_by_control_codes_is_told_without_them(tmp_path: Path) -> None:
    (tmp_path / "n\x1b]0;X\x07.bas").write_bytes(b"\xff\x01\x01")
    done = shell(f"ARM run {shlex.quote(str(tmp_path))}/n*.bas")
    assert b"\x1b" not in done.stderr
    assert b"\\x1b]0;X\\x07.bas" in done.stderr
    assert done.returncode == 2
