"""How long Table 4 takes to solve for the joints: the real ROM needs 0.81 to 0.86 s a point.

That is from GOSUB 5000 to the @STEP, with the differences in counts, for every point but the first,
where the variables of the solution are made and the array of the moves goes up for each of them.
The subroutine alone needs 1,120,107 T-states on the ROM where Y is 0 and about 1,198,000 elsewhere.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from trs80arm import Rig
from trs80arm.arm import benchfile
from trs80arm.operator import Operator, parse_holds

PROGRAMS = Path(__file__).parents[2] / "programs"
T_STATES_PER_SECOND = 1_774_080
SUBROUTINE = [1_120_107, 1_120_107, 1_120_107, 1_197_634, 1_199_634, 1_197_634, 1_120_107]
"""T-states that the ROM needs for lines 10010 to 10070 from GOSUB to behind RETURN."""


class Stopwatch:
    """Notes the time from a statement of line 320 to the next one of a later line.

    Attributes:
        solutions: seconds from the GOSUB to the @STEP of line 420.
        subroutines: T-states from the GOSUB to the statement behind it.
    """

    def __init__(self, rig: Rig) -> None:
        self._rig = rig
        self._began = 0
        self._called = False
        self.solutions: list[float] = []
        self.subroutines: list[int] = []

    def statement(self, line: int, address: int) -> None:
        """A statement begins."""
        now = self._rig.clock.now
        if line == 320 and not self._called:
            self._began, self._called = now, True
        elif line == 320:
            self.subroutines.append(now - self._began)
        elif line == 420:
            self.solutions.append((now - self._began) / T_STATES_PER_SECOND)
            self._called = False


@pytest.fixture(scope="module")
def watch() -> Stopwatch:
    """Table 4 run through its seven points."""
    rig = Rig(bench=benchfile.load(PROGRAMS / "table4.toml"))
    rig.load(PROGRAMS / "table4.bas")
    rig.type("RUN\r")
    watch = Stopwatch(rig)
    rig.basic.listeners.append(watch)
    Operator(rig, sets=[parse_holds("6:1.0 0")]).run(60)
    return watch


def test_a_solution_takes_eight_to_nine_and_a_half_tenths_of_a_second(watch: Stopwatch) -> None:
    assert len(watch.solutions) == 7
    assert all(0.80 <= seconds <= 0.95 for seconds in watch.solutions[1:])


def test_the_subroutine_takes_as_long_as_on_the_rom(watch: Stopwatch) -> None:
    assert watch.subroutines == pytest.approx(SUBROUTINE, rel=0.05)
