"""The panels of the screen, a row each: the one place that names them all.

A panel is a widget of a module of its own and a row here. The row gives it its place, its title,
its pace, and its commands in the palette.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from enum import Enum

from trs80arm.ui import layout
from trs80arm.ui.panels.cell import CellPanel
from trs80arm.ui.panels.coils import CoilsPanel
from trs80arm.ui.panels.effort import EffortPanel
from trs80arm.ui.panels.events import EventsLog
from trs80arm.ui.panels.inspector import ListingPanel, PaperPanel, VariablesPanel
from trs80arm.ui.panels.matrix import MatrixView
from trs80arm.ui.panels.panel import Panel
from trs80arm.ui.panels.pose import PosePanel
from trs80arm.ui.panels.registers import RegistersPanel
from trs80arm.ui.panels.scope_panel import ScopePanel
from trs80arm.ui.panels.side_view import SideView
from trs80arm.ui.panels.space_view import SpaceView
from trs80arm.ui.panels.tapes import TapesPanel
from trs80arm.ui.panels.top_view import TopView
from trs80arm.ui.panels.tube import Tube

AnyPanel = Panel | MatrixView | Tube


class Cadence(Enum):
    """How often a panel is shown new readings."""

    FRAME = "each frame"
    """What moves."""
    PICTURE = "every second frame"
    """What moves, and takes time to draw."""
    NUMBERS = "ten times a second"
    """What is to be read."""


@dataclass(frozen=True)
class PanelRow:
    """A panel.

    Attributes:
        id: of the widget.
        title: over it, where there is room.
        make: makes the widget with that id.
        cadence: how often it is shown new readings.
        group: the group in which it stands; panels of a group are shown together.
        shows: what its group shows, for a command that brings it under the tube; empty for none.
        key: of that command.
        fills: what is said of a command that lets it fill the screen; empty for none.
    """

    id: str
    title: str
    make: Callable[..., AnyPanel]
    cadence: Cadence
    group: str
    shows: str = ""
    key: str = ""
    fills: str = ""


PANELS: tuple[PanelRow, ...] = (
    PanelRow("tube", "TRS-80", Tube, Cadence.FRAME, layout.TUBE),
    PanelRow(
        "side",
        "Arm from the side",
        SideView,
        Cadence.PICTURE,
        layout.ARM,
        shows="The arm from the side and from above.",
    ),
    PanelRow("top", "From above", TopView, Cadence.PICTURE, layout.ARM),
    PanelRow(
        "space",
        "In space",
        SpaceView,
        Cadence.PICTURE,
        "space",
        shows="The arm in space.",
        fills="The arm in space fills the screen.",
    ),
    PanelRow(
        "registers",
        "Registers",
        RegistersPanel,
        Cadence.NUMBERS,
        layout.NUMBERS,
        fills="Registers fill the screen.",
    ),
    PanelRow(
        "pose",
        "Pose",
        PosePanel,
        Cadence.NUMBERS,
        layout.NUMBERS,
        fills="The pose fills the screen.",
    ),
    PanelRow(
        "effort",
        "Effort",
        EffortPanel,
        Cadence.NUMBERS,
        "effort",
        shows="What each motor uses of what it has, and the grip: why it slips.",
        key="shift+f4,f16,ctrl+f4",
        fills="The motors' effort fills the screen.",
    ),
    PanelRow(
        "coils",
        "Motors",
        CoilsPanel,
        Cadence.NUMBERS,
        layout.MOTORS,
        shows="The coils of the motors, and the inputs.",
        fills="The coils fill the screen.",
    ),
    PanelRow(
        "cell",
        "Cell",
        CellPanel,
        Cadence.NUMBERS,
        "cell",
        shows="What answers on the free inputs, and what the devices do.",
        fills="Inputs and devices fill the screen.",
    ),
    PanelRow(
        "scope",
        "Scope",
        ScopePanel,
        Cadence.NUMBERS,
        "scope",
        shows="The latches over time, and what the joints did.",
        fills="The scope fills the screen.",
    ),
    PanelRow(
        "events",
        "Log",
        EventsLog,
        Cadence.NUMBERS,
        layout.LOG,
        shows="What happened to the arm.",
        fills="The log fills the screen.",
    ),
    PanelRow(
        "matrix",
        "Keyboard",
        MatrixView,
        Cadence.FRAME,
        layout.KEYBOARD,
        shows="The TRS-80's keys, to see and to click.",
        key="ctrl+k",
    ),
    PanelRow(
        "listing",
        "Listing",
        ListingPanel,
        Cadence.NUMBERS,
        layout.LISTING,
        shows="The program in memory, and where it is.",
        key="alt+l",
        fills="The listing fills the screen.",
    ),
    PanelRow(
        "variables",
        "Variables",
        VariablesPanel,
        Cadence.NUMBERS,
        layout.VARIABLES,
        shows="The program's variables and what they hold.",
        fills="The variables fill the screen.",
    ),
    PanelRow(
        "paper",
        "Paper",
        PaperPanel,
        Cadence.NUMBERS,
        layout.PAPER,
        shows="What was printed.",
        fills="The paper fills the screen.",
    ),
    PanelRow(
        "tapes",
        "Tapes",
        TapesPanel,
        Cadence.NUMBERS,
        "tapes",
        shows="The cassette recorder, and the cassettes.",
        fills="The recorder and its cassettes fill the screen.",
    ),
)


def groups(panels: Iterable[PanelRow]) -> dict[str, tuple[str, ...]]:
    """The ids of the panels of each group, in the order of the rows."""
    found: dict[str, tuple[str, ...]] = {}
    for row in panels:
        found[row.group] = (*found.get(row.group, ()), row.id)
    return found
