"""The article's figures of the arm, drawn from its model and from the running arm.

`figure` computes one of them; what it returns can be printed as text or saved as SVG or PNG.
Figures 7, 9 and 11 show the computer's side and are in `article`. Figures 10 and 12 show what a
driver and a program make of the arm, so whoever has those hands in what they wrote and where the
hand went.
"""

from __future__ import annotations

from collections.abc import Sequence

from trs80arm.arm.contact.clock import T_STATES_PER_SECOND
from trs80arm.arm.figures.cabling import cabling
from trs80arm.arm.figures.chart import Chart, Figure, FigureError, Series, Style, Table
from trs80arm.arm.figures.diagram import Diagram
from trs80arm.arm.figures.gripping import gripping
from trs80arm.arm.figures.measured import envelope, grip_curves, phase_table, table1_rows
from trs80arm.arm.figures.structure import structure
from trs80arm.arm.figures.wrist import roll_and_pitch
from trs80arm.arm.model import ArmModel
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.state import ArmState

__all__ = [
    "NAMES",
    "Chart",
    "Diagram",
    "Figure",
    "FigureError",
    "Series",
    "Style",
    "Table",
    "figure",
]

NAMES = ("1", "2", "3", "4", "5", "6", "8", "10", "12", "table1")
"""Figures that can be drawn of an arm."""

ONLY_THE_ARTICLE_S = ("12", "table1")
"""Those that are of the article's own arm: its program, and what it lists."""

Writes = Sequence[tuple[int, int, int]]
Path = Sequence[tuple[int, ArmState]]


def figure(
    name: str,
    settings: ArmSettings | None = None,
    *,
    writes: Writes | None = None,
    path: Path | None = None,
) -> Figure:
    """One of the article's figures.

    Args:
        name: one of `NAMES`.
        settings: of the arm; the MiniMover 5's unless given.
        writes: for Figure 10, the latch writes of a coordinated @STEP as (T-state, latch,
            nibble).
        path: for Figure 12, states of the arm through one cycle of pick and place, as
            (T-state, state).

    Raises:
        FigureError: if there is no such figure, or it lacks what it is to show.
    """
    settings = settings or ArmSettings()
    model = settings.arm_model
    if name in ONLY_THE_ARTICLE_S and settings.model != ArmSettings().model:
        raise FigureError(f"{_called(name)} is the MiniMover 5's own: not of the {model.title}")
    if name == "1":
        return Figure("1", "Figure 1. Major structural components", (structure(settings),))
    if name == "2":
        return Figure("2", f"Figure 2. {model.title} working envelope", envelope(settings))
    if name == "3":
        return Figure("3", "Figure 3. Cabling diagram", (cabling(model),))
    if name == "4":
        title = "Figure 4. Definition of roll and pitch angles"
        return Figure("4", title, (roll_and_pitch(model),))
    if name == "5":
        return Figure("5", "Figure 5. Control system for gripping", (gripping(model),))
    if name == "6":
        title = "Figure 6. Hand opening and grip force against steps"
        return Figure("6", title, grip_curves(settings))
    if name == "8":
        title = "Figure 8. Drive patterns for the stepper motor coils; clockwise downwards"
        return Figure("8", title, (phase_table(),))
    if name == "10":
        if not writes:
            raise FigureError("figure 10 needs the latch writes of a motion")
        return Figure(
            "10", "Figure 10. Step timing of coordinated movement", _timing(writes, model)
        )
    if name == "12":
        if not path:
            raise FigureError("figure 12 needs the way of the hand through a cycle")
        return Figure("12", "Figure 12. The pick-and-place task, side view", _task(path))
    if name == "table1":
        title = "Table 1. Performance characteristics, measured on the arm"
        return Figure("table1", title, (table1_rows(),))
    raise FigureError(f"no figure {name}: there are {', '.join(NAMES)}")


def _called(name: str) -> str:
    """How a figure is spoken of."""
    return f"figure {name}" if name.isdigit() else name


def _timing(writes: Writes, model: ArmModel) -> tuple[Chart, ...]:
    """The pulses of each motor, and its steps, against time in milliseconds."""
    names = model.motor_names
    pulses, steps = [], []
    start = writes[0][0]
    motors = sorted({latch for _, latch, _ in writes})
    for i, latch in enumerate(motors):
        times = tuple((t - start) * 1000 / T_STATES_PER_SECOND for t, m, _ in writes if m == latch)
        label = f"{names[latch]}, {len(times)} steps"
        line = float(len(motors) - i)
        pulses.append(Series(label, times, (line,) * len(times), Style.DOTS, "|"))
        done = tuple(float(k + 1) for k in range(len(times)))
        steps.append(Series(label, times, done, Style.STEPS, _MARKS[latch]))
    return (
        Chart(
            "pulses",
            "milliseconds",
            "one line for each motor, from the top: " + ", ".join(names[latch] for latch in motors),
            tuple(pulses),
            rows=2 * len(motors) + 1,
        ),
        Chart("steps", "milliseconds", "steps done", tuple(steps)),
    )


_MARKS = "*o+x#%@"
"""One for each motor, in text."""


def _task(path: Path) -> tuple[Chart, ...]:
    """Height of the fingertip against its distance from where it closes on the part."""
    states = [state for _, state in path]
    taken = next((s for s in states if s.held is not None), states[0]).pose

    def place(state: ArmState) -> tuple[float, float]:
        pose = state.pose
        return ((pose.x - taken.x) ** 2 + (pose.y - taken.y) ** 2) ** 0.5, pose.z

    # Runs of moving with and without a part, each with the point at which the next begins.
    carried: list[tuple[float, float]] = []
    empty: list[tuple[float, float]] = []
    for state in states:
        (carried if state.held is not None else empty).append(place(state))
    series = []
    if empty:
        series.append(Series("hand empty", *_columns(empty), style=Style.DOTS, mark="."))
    notes: tuple[tuple[float, float, str], ...] = ()
    if carried:
        series.append(Series("carrying the part", *_columns(carried), style=Style.DOTS, mark="*"))
        # A and D are where the part is taken and let go, B and C the heights above them.
        a, d = carried[0], carried[-1]
        top = max(z for _, z in carried)
        notes = ((*a, "A"), (a[0], top, "B"), (d[0], top, "C"), (*d, "D"))
    return (
        Chart(
            "",
            "inches from the pick-up point",
            "height of the fingertip, inches",
            tuple(series),
            notes,
        ),
    )


def _columns(points: list[tuple[float, float]]) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Points as xs and ys."""
    return tuple(x for x, _ in points), tuple(y for _, y in points)
