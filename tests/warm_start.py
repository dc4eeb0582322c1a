"""The program as a process of its own in a terminal, without the half second that imports take.

A server, one for all tests of a pytest process, has imported what the terminal needs, and forks for
each start: the new process has its own session, streams, folder and environment, and then does what
`trs80arm` does. How long imports take and what is imported is another test's matter.
"""

from __future__ import annotations

import contextlib
import os
import sys
from functools import cache
from multiprocessing import get_context
from multiprocessing.context import ForkServerContext, ForkServerProcess
from pathlib import Path

PRELOADED = [
    "numpy",
    "textual.app",
    "textual.drivers.linux_driver",
    "trs80arm.cli.terminal",
    "trs80arm.ui.start",
    "trs80arm.ui.app",
    "tests.warm_start",
]


class Started:
    """A process, with what tests ask of one that `subprocess` has started."""

    def __init__(self, process: ForkServerProcess) -> None:
        assert process.pid is not None
        self._process = process
        self.pid: int = process.pid

    @property
    def returncode(self) -> int | None:
        return self._process.exitcode

    def poll(self) -> int | None:
        return self.returncode

    def wait(self, seconds: float | None = None) -> int:
        self._process.join(seconds)
        assert self.returncode is not None
        return self.returncode

    def kill(self) -> None:
        self._process.kill()


@cache
def _server() -> ForkServerContext:
    context = get_context("forkserver")
    context.set_forkserver_preload(PRELOADED)
    return context


def start(
    script: str, arguments: list[str], terminal: int, folder: Path, environment: dict[str, str]
) -> Started:
    """Run a script in a terminal, in a session of its own.

    Args:
        script: what Python runs.
        arguments: of the script.
        terminal: the side of a pty on which programs are.
        folder: where it runs.
        environment: all that is in its environment.
    """
    given = (script, arguments, os.ttyname(terminal), folder, environment)
    process = _server().Process(target=_run, args=given)
    process.start()
    return Started(process)


def _run(
    script: str, arguments: list[str], terminal: str, folder: Path, environment: dict[str, str]
) -> None:
    """What the new process does."""
    os.setsid()
    slave = os.open(terminal, os.O_RDWR | os.O_NOCTTY)
    for stream in range(3):
        os.dup2(slave, stream)
    os.close(slave)
    sys.stdin = os.fdopen(0, encoding="utf-8", closefd=False)
    sys.stdout = os.fdopen(1, "w", encoding="utf-8", closefd=False)
    sys.stderr = os.fdopen(2, "w", 1, encoding="utf-8", closefd=False)
    vars(sys).update(__stdin__=sys.stdin, __stdout__=sys.stdout, __stderr__=sys.stderr)
    os.environ.clear()
    os.environ.update(environment)
    os.chdir(folder)
    sys.argv = ["-c", *arguments]
    code: object = 0
    try:
        exec(script, {"__name__": "__main__"})
    except SystemExit as ending:
        code = ending.code
    with contextlib.suppress(OSError):
        sys.stdout.flush()
    os._exit(code if isinstance(code, int) else 0 if code is None else 1)
