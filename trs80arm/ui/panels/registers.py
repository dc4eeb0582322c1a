"""The six position registers beside where the joints truly are: the heart of an open loop."""

from __future__ import annotations

from trs80arm.arm.loads import NEAR
from trs80arm.drawing.readings import RING, Readings
from trs80arm.drawing.rows import Ink, Row
from trs80arm.ui.panels.panel import Panel

_WIDE = 34
_ROOMY = 16
_SLIPPED, _MOVED = "!", "~"


class RegistersPanel(Panel):
    """J1 to J6: commanded, true, and what the motors have lost."""

    HELP = """
## Position registers

The registers count the half-steps that were *commanded* since `@RESET`; nothing on the arm tells
the computer whether they were made. Beside them stands where each joint *truly* is, in the same
steps. `!` marks a motor that has slipped, by multiples of 8 half-steps; `~` a joint that was moved
otherwise: by hand, or by OUT. `@RESET` sets both to zero. The last line names the motor that is
near to slipping, and how much of what it has it uses; all of them are in the panel Effort.
"""

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """A line a joint, with a heading where there is room for one."""
        wide = width >= _WIDE
        rows: list[Row] = []
        for joint in range(6):
            rows.append(
                _wide_row(readings, joint, width) if wide else _narrow_row(readings, joint, width)
            )
        if height > len(rows):
            heading = _wide_heading(width) if wide else _narrow_heading(width)
            rows.insert(0, ((heading, Ink.LABEL),))
        if height > len(rows) + 1:
            rows.append(())
            rows.append(_summary(readings, width))
        return rows


def _mark(readings: Readings, joint: int) -> tuple[str, Ink]:
    if abs(readings.slipped[joint]) >= RING:
        return _SLIPPED, Ink.ALARM
    if readings.registers[joint] != readings.joints[joint]:
        return _MOVED, Ink.STRONG
    return " ", Ink.PLAIN


def _column(width: int) -> int:
    """Cells for a number in the narrow form: six and a blank, or less where that does not fit."""
    return 7 if width >= _ROOMY else 6


def _slip_column(width: int) -> int:
    """Cells for the steps lost in the wide form, with a blank before them where that fits."""
    return min(7, width - _WIDE + 5)


def _narrow_heading(width: int) -> str:
    column = _column(width)
    return f"{'reg':>{column + 2}} {'true':>{column - 1}}"


def _wide_heading(width: int) -> str:
    return f"joint        register   true{'slip':>{_slip_column(width)}}"


def _narrow_row(readings: Readings, joint: int, width: int) -> Row:
    mark, ink = _mark(readings, joint)
    register, true = readings.registers[joint], readings.joints[joint]
    column = _column(width)
    numbers = f"{register:{column}d}{true:{column - 1}d}{mark}"
    return ((f"J{joint + 1}", Ink.LABEL), (numbers, ink))


def _wide_row(readings: Readings, joint: int, width: int) -> Row:
    mark, ink = _mark(readings, joint)
    register, true = readings.registers[joint], readings.joints[joint]
    slipped = readings.slipped[joint]
    column = _slip_column(width)
    lost = f"{slipped:+{column}d}" if abs(slipped) >= RING else " " * column
    return (
        (f"J{joint + 1} {readings.model.motor_names[joint]:11}", Ink.LABEL),
        (f"{register:7d}{true:7d}{lost}{mark}", ink),
    )


def _summary(readings: Readings, width: int) -> Row:
    lost = [joint for joint in range(6) if abs(readings.slipped[joint]) >= RING]
    if lost:
        names = ",".join(f"J{joint + 1}" for joint in lost)
        text = f"slipped: {names}"
        return ((text if len(text) <= width else f"slip {len(lost)} motors", Ink.ALARM),)
    hardest = readings.loads.hardest
    if hardest.used >= NEAR:
        use = f" {hardest.per_cent} %"
        name = hardest.name
        if len(name) + len(use) > width:
            name = f"J{readings.loads.motors.index(hardest) + 1}"
        return ((name + use, Ink.ALARM if hardest.used > 1 else Ink.WARNING),)
    moved = any(
        register != true for register, true in zip(readings.registers, readings.joints, strict=True)
    )
    return (("moved by hand" if moved else "no step lost", Ink.LABEL),)
