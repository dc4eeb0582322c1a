"""The article's figures from a whole rig: what `trs80arm figure` draws.

The arm's room draws those of the arm; for Figures 10 and 12 it wants to be shown what the ARMBASIC
driver wrote and where a program took the hand, which only a rig can tell. Figures 7, 9 and 11 are
of the card and the keyboard, and drawn here.
"""

from __future__ import annotations

import numpy as np

from trs80arm.arm import benchfile
from trs80arm.arm.events import EventKind
from trs80arm.arm.figures import Figure, FigureError, figure
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.state import ArmState
from trs80arm.article.interface import block_diagram, drive_circuit
from trs80arm.article.keyboard import keyboard
from trs80arm.bundled import programs_folder
from trs80arm.operator import Operator, parse_holds
from trs80arm.pulses import Series
from trs80arm.rig import Rig, RigSettings

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


NAMES = ("1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "table1")
"""Figures that can be drawn."""


def draw(name: str, settings: RigSettings | None = None) -> Figure:
    """One of the article's figures, from the model that runs.

    Args:
        name: one of `NAMES`.
        settings: of the machine, its card and its arm; the MiniMover 5's unless given.

    Raises:
        FigureError: there is no such figure, it is of another arm than this one, or what it needs
            was not installed.
    """
    settings = settings or RigSettings()
    model = settings.arm.arm_model
    if name not in NAMES:
        raise FigureError(f"no figure {name}: there are {', '.join(NAMES)}")
    if name == "7":
        title = "Figure 7. Simplified stepper motor drive circuit"
        return Figure("7", title, (drive_circuit(settings.card),))
    if name == "9":
        title = "Figure 9. Block diagram of the computer interface"
        return Figure("9", title, (block_diagram(settings.card, model),))
    if name == "11":
        title = "Figure 11. Use of the keyboard to control the arm"
        return Figure("11", title, (keyboard(settings.driver.keys, model),))
    if name == "10":
        return figure(name, settings.arm, writes=_coordinated_move(settings))
    if name == "12" and settings.arm.model == ArmSettings().model:
        return figure(name, path=_pick_and_place())
    return figure(name, settings.arm)


def _coordinated_move(settings: RigSettings) -> list[tuple[int, int, int]]:
    """The writes of the article's example: 21 steps of the base against 3 of the shoulder."""
    rig = Rig(settings)
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
