"""Why it slips, or does not: what each motor uses of what it has, and the grip against friction."""

from __future__ import annotations

from trs80arm.arm.loads import NEAR, GripLoad, MotorLoad, per_cent
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, Span
from trs80arm.ui.panels.glyph_panels import GlyphPanel

_WIDE = 36
_ROOMY = 72
_VERY_WIDE = 90
_NAME = 15
"""Cells for a motor's number and name."""
_TORQUE = 29
"""Cells for torques, or for the grip's force."""
_ASCII_BARS = ("#", ".")
_BARS = ("█", "░")


def ink_of(used: float) -> Ink:
    """How a share of what there is is written: a warning from `NEAR` on, an alarm beyond all."""
    return Ink.ALARM if used > 1 else Ink.WARNING if used >= NEAR else Ink.PLAIN


def mark_of(used: float) -> str:
    """The same without colour."""
    return "!!" if used > 1 else "! " if used >= NEAR else "  "


class EffortPanel(GlyphPanel):
    """A bar for each motor: how much of what it has is used."""

    HELP = """
## Effort

How much of what it has each motor uses: 100 % is as much as it can, and beyond it the rotor trails
and soon slips. A motor that turns has the less torque the faster it goes, so load and rate count
together; one that stands has far more, and one without current the friction of its gears. From
85 % on a bar is in the warning colour, marked `!`, and beyond 100 % in that of alarms, marked `!!`.
*peak* is the most since `@RESET`, at any half-step. Beside it stand the torque at the joint and how
much more there is (ounce-inches; ounces at the fingers); where there is room, half-steps a second
and the pull on the motor's cable.

While something is between the fingers the hand's line has the grip's force, and what of it holding
takes: the weight on the pads, by their friction.
"""

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """A row a motor, and the grip where there is room."""
        loads = readings.loads
        rows = [
            self._motor(f"J{place + 1}", load, loads.grip, width)
            for place, load in enumerate(loads.motors)
        ]
        if height > len(rows):
            rows.append(self._grip(loads.grip, width))
        return rows

    def _motor(self, number: str, load: MotorLoad, grip: GripLoad, width: int) -> Row:
        ink, use = ink_of(load.used), f"{load.per_cent:3d} %"
        if width < _WIDE:
            return self._narrow(number, use, load.used, width)
        spans: list[Span] = [
            (f"{f'{number} {load.name}':{_NAME}}", Ink.LABEL),
            (f"{use} {mark_of(load.used)}", ink),
            self._bar(load.used, _bar_width(width)),
            (" peak", Ink.LABEL),
            (f"{load.peak:4d}", ink_of(load.peak / 100)),
        ]
        if width >= _ROOMY and load.grips and grip.used is not None:
            spans.append((_force(grip), ink_of(grip.used)))
        elif width >= _ROOMY:
            bears = round(load.torque, 1) + 0.0
            spans.append((f"{bears:8.1f} {load.unit}, {load.left:.1f} left", Ink.PLAIN))
        if width >= _VERY_WIDE and not load.grips:
            beside = f"{load.rate:6.0f}/s  cable {load.cable:5.1f} oz"
            spans.append((beside.rjust(_TORQUE + 22 - len(spans[-1][0])), Ink.PLAIN))
        return tuple(spans)

    def _narrow(self, name: str, use: str, used: float, width: int) -> Row:
        return (
            (f"{name:3}", Ink.LABEL),
            (use, ink_of(used)),
            (mark_of(used)[:1], ink_of(used)),
            self._bar(used, max(0, width - 9)),
        )

    def _grip(self, grip: GripLoad, width: int) -> Row:
        used = grip.used
        if width < _WIDE:
            if used is None:
                return (("gr ", Ink.LABEL), ("nothing", Ink.PLAIN))
            return self._narrow("gr", f"{per_cent(used):3d} %", used, width)
        if used is None:
            return ((f"{'grip':{_NAME}}", Ink.LABEL), ("nothing between the fingers", Ink.PLAIN))
        spans: list[Span] = [
            (f"{'grip':{_NAME}}", Ink.LABEL),
            (f"{per_cent(used):3d} % {mark_of(used)}", ink_of(used)),
            self._bar(used, _bar_width(width)),
        ]
        if width >= _ROOMY:
            spans.append((_force(grip), Ink.PLAIN))
        return tuple(spans)

    def _bar(self, used: float, cells: int) -> Span:
        full, empty = _ASCII_BARS if self.ascii else _BARS
        lit = min(cells, max(0, round(cells * min(used, 1.0))))
        return full * lit + empty * (cells - lit), ink_of(used)


def _force(grip: GripLoad) -> str:
    return f"  {grip.force:.2f} lb, holding takes {grip.needed:.2f}"


def _bar_width(width: int) -> int:
    """Cells of a bar in the wide forms."""
    fixed = _NAME + 8 + 9
    if width >= _VERY_WIDE:
        fixed += _TORQUE + 22
    elif width >= _ROOMY:
        fixed += _TORQUE
    return max(4, min(20, width - fixed))
