"""The program in memory read without running it: what `trs80arm check` would tell of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from trs80arm.desk.asking import Asking, Choice, ListQuestion, Say
from trs80arm.desk.session import Session
from trs80arm.rig import Waiting

if TYPE_CHECKING:
    from trs80arm.check.findings import Finding

NOTHING_WRONG: Final = "Nothing is wrong in the program, as far as reading it tells."
NO_PROGRAM: Final = "There is no program in memory."


class Proof:
    """Reads the program in memory, and lists the lines of what is found in it.

    Args:
        session: the machine and its bench.
        ask: a way to ask.
        say: a way to say something.
    """

    def __init__(self, session: Session, ask: Asking, say: Say) -> None:
        self._session = session
        self._ask = ask
        self._say = say

    def read(self) -> None:
        """Show what is wrong in the program; LIST is typed for the line that is chosen."""
        # Loaded when asked for: the first frame needs none of it.
        from trs80arm.check.program import bench_at, check_lines

        session = self._session
        rig = session.rig
        lines = rig.basic.program.lines()
        if not lines:
            self._say(NO_PROGRAM)
            return
        settings = rig.settings
        bench = bench_at(session.bench_path)
        found = check_lines(
            lines,
            armbasic=settings.armbasic,
            bench=bench,
            arm=settings.arm.arm_model,
        )
        if not found:
            self._say(NOTHING_WRONG)
            return
        rows = tuple(
            Choice(str(place), f"{each.number} {each.level.value}: {each.text}")
            for place, each in enumerate(found)
        )
        self._ask.choose(
            ListQuestion(_counted(found), rows), lambda place: self._list(found[int(place)])
        )

    def _list(self, finding: Finding) -> None:
        at_prompt = self._session.waiting is Waiting.COMMAND and not self._session.typing
        if at_prompt and finding.number is not None:
            self._session.rig.type(f"LIST {finding.number}\r")
        else:
            self._say(f"{finding.number}: {finding.text}")


def _counted(found: list[Finding]) -> str:
    """How many of each level, in words."""
    from trs80arm.check.findings import Level

    counts = ((level.value, sum(each.level is level for each in found)) for level in Level)
    return ", ".join(f"{count} {name}{'s' * (count > 1)}" for name, count in counts if count)
