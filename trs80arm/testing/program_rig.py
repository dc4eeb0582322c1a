"""A rig with a person in front of it, for tests: it runs a program, answers, waits for words."""

from __future__ import annotations

import io
import re
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

from trs80arm.arm.bench import Bench
from trs80arm.basic.outcome import Ending
from trs80arm.operator import Operator, parse_holds
from trs80arm.rig import Rig, RigSettings
from trs80arm.teletype import ENTER, Teletype
from trs80arm.testing.story import account
from trs80arm.trace import PoseTrace, Trace

LOOK = 1 / 60
"""Virtual seconds between two looks at what was printed."""


@dataclass
class CsvTrace:
    """A trace under way; `text` is the CSV, complete when the trace has ended."""

    text: str = ""


class ProgramRig(Rig):
    """A `Rig` with a scripted operator and an ear for what the program prints.

    Args:
        settings: the machine's fittings.
        bench: what stands on the table.
    """

    def __init__(self, settings: RigSettings | None = None, bench: Bench | None = None) -> None:
        super().__init__(settings, bench)
        self._operator = Operator(self)
        self._printed = io.StringIO()
        self._teletype = Teletype(self._printed)
        self._read = 0
        self.listen(self._hear)

    def _hear(self, code: int, is_echo: bool) -> None:
        # What is typed is not what the program says; its ENTER ends the line all the same.
        if not is_echo or code == ENTER:
            self._teletype(code)

    @property
    def output(self) -> str:
        """All that was printed since the machine was switched on, without what was typed."""
        return self._printed.getvalue()

    def run(self, command: str = "RUN") -> None:
        """Type RUN, or another command. Time passes in `expect`, `finish` and `run_for`."""
        self.type(f"{command}\r")

    def answer(self, *answers: str | float) -> None:
        """Answer the coming INPUTs, in order; each answer is typed with ENTER."""
        for answer in answers:
            self._operator.answer(str(answer))

    def jog(self, holds: str) -> None:
        """What the operator does in the next @SET, as in `trs80arm run --set`: `"6:1.0 1+W:0.5 0"`.

        Raises:
            ScriptError: it cannot be understood.
        """
        self._operator.jog(parse_holds(holds))

    def expect(self, text: str | re.Pattern[str], seconds: float = 60.0) -> str:
        """Let the machine run until the program has printed something.

        Args:
            text: what, or a pattern for it. What was printed before the last match does not count.
            seconds: the most virtual time to spend.

        Returns:
            What was found.

        Raises:
            AssertionError: it was not printed; the message says what was, and what the arm did.
        """
        __tracebackhide__ = True
        pattern = re.compile(re.escape(text)) if isinstance(text, str) else text
        end = self.time + seconds
        while not (found := pattern.search(self.output, self._read)):
            if not self._go_on(end):
                wanted = pattern.pattern if isinstance(text, re.Pattern) else text
                self._fail(f"{wanted!r} was not printed{self._in_time(end, seconds)}")
        self._read = found.end()
        return found[0]

    def finish(self, seconds: float = 600.0, *, error: str | None = None) -> None:
        """Let the program run to its end.

        Args:
            seconds: the most virtual time to spend.
            error: the two letters of the BASIC error that it shall end with, as `UL`.

        Raises:
            AssertionError: it goes on, waits in vain, or ended otherwise.
        """
        __tracebackhide__ = True
        end = self.time + seconds
        while self._go_on(end):
            pass
        outcome = self.outcome
        if outcome is None:
            self._fail(f"the program has not ended{self._in_time(end, seconds)}")
        letters = outcome.code.letters if outcome.ending is Ending.ERROR and outcome.code else None
        if letters != error:
            self._fail(f"the program shall end {f'with ?{error} Error' if error else 'well'}")

    def _go_on(self, end: float) -> bool:
        """Let a little time pass, with the operator's help; whether there is anything to come."""
        left = end - self.time
        if left <= 0 or not self._operator.attend():
            return False
        self.run_for(min(LOOK, left))
        return True

    def _in_time(self, end: float, seconds: float) -> str:
        """What is said of a limit, if it was that which ended a wait."""
        over = self.time >= end
        return f" within {seconds:g} virtual seconds" if over else ", and nothing more is to come"

    def _fail(self, what: str) -> NoReturn:
        __tracebackhide__ = True
        lately = self.output[self._read :].splitlines()[-8:]
        raise AssertionError("\n".join([what, *account(self), "printed since:", *lately]))

    @contextmanager
    def trace(self, kind: str = "pose", rate: float | None = None) -> Iterator[CsvTrace]:
        """Trace the arm or the latches while a block of a test runs.

        Args:
            kind: `pose` or `latches`.
            rate: looks a virtual second at the pose; None for one at each step.

        Raises:
            ValueError: there is no such kind.
        """
        if kind not in ("pose", "latches"):
            raise ValueError(f"a trace is of 'pose' or 'latches', not {kind!r}")
        kept = CsvTrace()
        with tempfile.TemporaryDirectory(prefix="trs80arm-") as folder:
            path = Path(folder) / "trace.csv"
            with PoseTrace(self, path, rate) if kind == "pose" else Trace(self, path):
                yield kept
            kept.text = path.read_text(encoding="ascii")
