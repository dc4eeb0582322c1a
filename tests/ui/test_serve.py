"""The terminal in a browser."""

from __future__ import annotations

import asyncio
import os
import signal
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import pytest

from trs80arm.ui.serve import LIMITS, OWN_FILES, ServeError, serve_terminal

PATIENCE = 60.0
"""Seconds of the wall after which a server that does not answer is none."""


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def answer_of(address: str, process: subprocess.Popen[str]) -> str:
    """The first page, as soon as there is one."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end and process.poll() is None:
        try:
            with urllib.request.urlopen(address, timeout=5) as page:
                return str(page.read().decode())
        except OSError:
            time.sleep(0.02)
    raise AssertionError("nobody answers")


def test_a_browser_gets_a_page_with_a_terminal(tmp_path: Path) -> None:
    port = free_port()
    process = subprocess.Popen(
        [sys.executable, "-m", "trs80arm", "serve", "--port", str(port)],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        cwd=tmp_path,
        env=os.environ | {"PYTHONUNBUFFERED": "1"},
    )
    assert process.stdout is not None
    try:
        told = "".join(process.stdout.readline() for _ in LIMITS.splitlines())
        address = told.split()[2]
        page = answer_of(address, process)
    finally:
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=PATIENCE)
    assert address.startswith(f"http://127.0.0.1:{port}/?token=")
    assert f"ws://127.0.0.1:{port}/ws" in page
    assert told.rstrip("\n") == LIMITS.format(address=address, files=OWN_FILES)


def test_without_the_extra_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "textual_serve.server", None)
    with pytest.raises(ServeError, match=r"pip install 'trs80arm\[web\]'"):
        serve_terminal("127.0.0.1", 8000, None)


def test_a_program_that_is_not_there_is_told_before_serving() -> None:
    with pytest.raises(ServeError, match=r"nowhere.bas: No such file"):
        serve_terminal("127.0.0.1", 8000, Path("nowhere.bas"))


def test_a_port_that_is_taken_is_told_in_one_line(tmp_path: Path) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = str(taken.getsockname()[1])
        done = subprocess.run(
            [sys.executable, "-m", "trs80arm", "serve", "--port", port],
            capture_output=True,
            text=True,
            cwd=tmp_path,
            timeout=PATIENCE,
            check=False,
        )
    assert done.returncode == 2
    assert done.stderr.startswith(f"trs80arm: 127.0.0.1:{port}: ")
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize("allow_files", [False, True])
def test_an_address_for_others_is_warned_of(
    capsys: pytest.CaptureFixture[str], allow_files: bool
) -> None:
    # textual-serve closes the loop that it has found.
    asyncio.set_event_loop(asyncio.new_event_loop())
    with pytest.raises(ServeError, match=r"192\.0\.2\.1:8000: "):
        serve_terminal("192.0.2.1", 8000, None, allow_files=allow_files)
    told = capsys.readouterr().out
    assert "Careful: 192.0.2.1 is not this computer alone." in told
    assert ("read and write the files" in told) == allow_files
