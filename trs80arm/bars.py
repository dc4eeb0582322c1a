"""Bars on standard error, that say how far a command is; nothing where that is no terminal."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, TextIO

from trs80arm.machine.driver import Mode
from trs80arm.rig import Rig

if TYPE_CHECKING:
    from rich.progress import Progress, ProgressColumn

_SOON = 0.4
"""Seconds of the wall's clock after which a run is worth a bar."""
_DOES = {Mode.STEP: "@STEP", Mode.CLOSE: "@CLOSE", Mode.SET: "@SET"}


@contextmanager
def counting(what: str, total: int, done: int = 0) -> Iterator[Callable[[], None]]:
    """A bar over so many things; call what this gives whenever one more is done.

    Args:
        what: the things, in a word.
        total: how many there are.
        done: how many are done already.
    """
    if not sys.stderr.isatty():
        yield lambda: None
        return
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn

    with _progress(
        TextColumn(what), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn()
    ) as progress:
        task = progress.add_task(what, total=total, completed=done)
        yield lambda: progress.advance(task)


@contextmanager
def running(
    program: str, seconds: float | None, stream: TextIO
) -> Iterator[tuple[Callable[[Rig], None] | None, TextIO]]:
    """A bar of one run: its virtual time, and what the program does now.

    Args:
        program: its name.
        seconds: the limit of virtual time, None for a run that has none of its own.
        stream: what the program prints to.

    Yields:
        What to call with the rig now and then, the first time when the run begins, None where there
        is no bar; and what the program is to print to, so that the bar stays below it.
    """
    if not sys.stderr.isatty():
        yield None, stream
        return
    from rich.progress import BarColumn, TextColumn

    limit = "" if seconds is None else f" of {seconds:g}"
    told = TextColumn(f"{{task.fields[time]:.1f}}{limit} s")
    doing = TextColumn("{task.fields[doing]}", markup=False)
    begun: list[float] = []
    with _progress(TextColumn(program, markup=False), BarColumn(), told, doing) as progress:
        task = progress.add_task("", total=seconds, visible=False, time=0.0, doing="")

        def look(rig: Rig) -> None:
            if not begun:
                begun.append(rig.time)
            spent = rig.time - begun[0]
            run = progress.tasks[0]
            late = (run.elapsed or 0.0) > _SOON
            appears = late and not run.visible
            progress.update(task, completed=spent, time=spent, doing=_doing(rig), visible=late)
            if appears:
                progress.refresh()

        above = _Above(progress, stream) if _is_shown_where_the_bar_is(stream) else None
        yield look, above or stream
    if above is not None:
        above.finish()


def _progress(*columns: ProgressColumn) -> Progress:
    from rich.console import Console
    from rich.progress import Progress

    # What is printed in the meantime is none of its business, whatever stream it goes to.
    return Progress(
        *columns,
        console=Console(stderr=True),
        transient=True,
        redirect_stdout=False,
        redirect_stderr=False,
    )


def _doing(rig: Rig) -> str:
    """The line that is being executed, and the motion that is under way."""
    line, motion = rig.basic.line, _DOES.get(rig.driver.mode, "")
    return " ".join(filter(None, ["" if line is None else f"line {line}", motion]))


def _is_shown_where_the_bar_is(stream: TextIO) -> bool:
    """Whether what is printed to a stream is shown on the terminal that the bar is on."""
    try:
        return stream.isatty() and os.path.sameopenfile(stream.fileno(), sys.stderr.fileno())
    except (OSError, ValueError):
        return False


class _Above(io.StringIO):
    """Prints whole lines above the bar, and what is left when it has gone."""

    def __init__(self, progress: Progress, stream: TextIO) -> None:
        super().__init__()
        self._progress, self._stream = progress, stream
        self._line = ""

    def write(self, text: str) -> int:
        """Print the lines that are whole."""
        *lines, self._line = (self._line + text).split("\n")
        for line in lines:
            self._progress.console.print(line, markup=False, highlight=False, soft_wrap=True)
        return len(text)

    def finish(self) -> None:
        """Print what is left."""
        self._stream.write(self._line)
        self._stream.flush()
