"""The article's figures from a whole rig: what `trs80arm figure` draws.

The arm's room draws them all; for Figures 10 and 12 it wants to be shown what the ARMBASIC driver
wrote and where a program took the hand, which only a rig can tell.
"""

from __future__ import annotations

import numpy as np

from trs80arm.arm import benchfile
from trs80arm.arm.events import EventKind
from trs80arm.arm.figures import Figure, FigureError, figure
from trs80arm.arm.minimover import ArmState
from trs80arm.bundled import programs_folder
from trs80arm.operator import Operator, parse_holds
from trs80arm.pulses import Series
from trs80arm.rig import Rig

_OPEN_THE_HAND = "6:1.0 0"
_CYCLES = 3
"""Parts set down until the cycle runs from the computed angles, and once more around."""
_SAMPLE = 0.01
"""Seconds between two looks at the hand."""


class _Analyser:
    """Collects every latch write."""

    each_step = False

    def __init__(self) -> None:
        self.writes: list[tuple[int, int, int]] = []

    def wrote(self, times: Series, latches: Series, nibbles: Series) -> None:
        """Take a burst."""
        columns = (np.asarray(column).tolist() for column in (times, latches, nibbles))
        self.writes.extend(zip(*columns, strict=True))


def draw(name: str) -> Figure:
    """One of the article's figures, from the running model.

    Args:
        name: `2`, `6`, `8`, `10`, `12` or `table1`.

    Raises:
        FigureError: there is no such figure, or what it needs was not installed.
    """
    if name == "10":
        return figure(name, writes=_coordinated_move())
    if name == "12":
        return figure(name, path=_pick_and_place())
    return figure(name)


def _coordinated_move() -> list[tuple[int, int, int]]:
    """The writes of the article's example: 21 steps of the base against 3 of the shoulder."""
    rig = Rig()
    analyser = _Analyser()
    rig.watch_latches(analyser)
    rig.type("@STEP 50,21,3\r")
    rig.run_until_waiting()
    return analyser.writes


def _pick_and_place() -> list[tuple[int, ArmState]]:
    """The arm through one cycle of Table 4, from one part set down to the next."""
    folder = programs_folder()
    if folder is None:
        raise FigureError("figure 12 needs programs/table4.bas, which was not installed")
    rig = Rig(bench=benchfile.load(folder / "table4.toml"))
    rig.load(folder / "table4.bas")
    rig.type("RUN\r")
    Operator(rig, sets=[parse_holds(_OPEN_THE_HAND)]).run(15)

    def set_down() -> int:
        return sum(event.kind is EventKind.PLACED for event in rig.arm.events)

    rig.run_until(lambda rig: set_down() == _CYCLES - 1, seconds=60)
    path = []
    while set_down() < _CYCLES:
        rig.run_for(_SAMPLE)
        path.append((rig.clock.now, rig.state))
    return path
