"""Figure 4: what roll and pitch are, and how the two wrist gears make them."""

from __future__ import annotations

from math import cos, degrees, radians, sin

from trs80arm.arm.figures.diagram import Diagram, Page
from trs80arm.arm.figures.drives import does, number
from trs80arm.arm.figures.sheet import Fill, Pen, Point, Sheet
from trs80arm.arm.model import ArmModel, Motor

_PITCH = -38.0
_ROLL = 35.0
"""Degrees, of the hand that is drawn."""


def roll_and_pitch(model: ArmModel) -> Diagram:
    """The hand from the side, and along its pointing vector."""
    return Diagram(tuple(_text(model)), _sheet(model))


def _gears(model: ArmModel) -> list[str]:
    """What the gears stand at, and how they are counted."""
    left, right = model.latch(Motor.LEFT_WRIST), model.latch(Motor.RIGHT_WRIST)
    limits = model.limits
    return [
        f"left gear, {number(model, Motor.LEFT_WRIST)}: P + R, counting up "
        f"{does(model.drives[left], 1)}; +-{degrees(limits.gear):.0f} deg",
        f"right gear, {number(model, Motor.RIGHT_WRIST)}: P - R, counting up "
        f"{does(model.drives[right], 1)}; +-{degrees(limits.gear):.0f} deg",
        f"P = (left + right) / 2, within +-{degrees(limits.pitch):.0f} deg of the forearm",
        "R = (left - right) / 2",
    ]


def _text(model: ArmModel) -> list[str]:
    page = Page()
    page.put(0, 2, "from its right side")
    page.put(0, 40, "from behind, along the way it points")
    page.put(3, 2, "forearm")
    page.put(4, 2, "============o- - - - - - - - X axis")
    for step in range(6):
        page.put(5 + step, 15 + 2 * step, "\\")
    page.put(5, 24, "|")
    page.put(6, 24, "|  P, pitch:")
    page.put(7, 24, "v  here negative")
    page.put(8, 13, "hand")
    page.put(11, 26, "v  pointing vector")
    page.put(2, 54, "up")
    for row in range(3, 8):
        page.put(row, 54, ":")
    for step in range(4):
        page.put(6 - step, 56 + 2 * step, "/")
    page.put(5, 55, "R>")
    page.put(3, 64, "roll: here")
    page.put(4, 64, "positive")
    page.put(7, 46, ".-------/-------.")
    page.put(8, 40, "left  |       x       |  right")
    page.put(9, 40, "finger'-------:-------'  finger")
    page.put(10, 54, ":")
    return [
        *page.lines,
        "",
        "  Pitch is measured from the horizontal X axis, as the angles of upper arm and",
        "  forearm are; roll about the pointing vector, clockwise seen from behind.",
        "",
        *(f"  {line}" for line in _gears(model)),
    ]


def _sheet(model: ArmModel) -> Sheet:
    sheet = Sheet(860.0, 440.0)
    wrist = (210.0, 300.0)
    _from_the_side(sheet, wrist)
    _from_behind(sheet, (650.0, 270.0))
    for order, line in enumerate(_gears(model)):
        sheet.words((30.0, 92.0 - 20 * order), line, pen=Pen.SOFT)
    sheet.words((30.0, 414.0), "From its right side", bold=True)
    sheet.words((520.0, 414.0), "From behind, along the pointing vector", bold=True)
    return sheet


def _from_the_side(sheet: Sheet, wrist: Point) -> None:
    way = radians(_PITCH)
    forearm = (wrist[0] - 165, wrist[1] + 52)
    sheet.bar(forearm, wrist, 15, fill=Fill.SHADE)
    sheet.line(wrist, (wrist[0] + 190, wrist[1]), pen=Pen.SOFT, dashed=True)
    sheet.words((wrist[0] + 196, wrist[1]), "X axis", pen=Pen.SOFT)
    tip = _on(wrist, 150, way)
    root = _on(wrist, 56, way)
    sheet.bar(wrist, root, 19, fill=Fill.SHADE)
    sheet.bar(root, tip, 8, fill=Fill.SHADE)
    sheet.arrow(wrist, _on(wrist, 215, way), pen=Pen.FIRST, width=2.0)
    end = _on(wrist, 222, way)
    sheet.words((end[0] + 4, end[1] - 8), "pointing vector", pen=Pen.FIRST)
    sheet.arc(wrist, 118, 0, _PITCH + 3, pen=Pen.SECOND, width=2.0, arrow=True)
    middle = _on(wrist, 134, way / 2)
    sheet.words(middle, "P, here negative", pen=Pen.SECOND, bold=True)
    sheet.circle(wrist, 11, fill=Fill.PAPER, width=1.8)
    sheet.circle(wrist, 2.0, fill=Fill.PEN)
    sheet.words((forearm[0], forearm[1] + 30), "forearm")
    sheet.leader((wrist[0] - 70, wrist[1] - 54), _on(wrist, 40, way), "hand", at="end")


def _from_behind(sheet: Sheet, middle: Point) -> None:
    """The pointing vector goes into the page; up is up."""
    sheet.line((middle[0], middle[1] - 96), (middle[0], middle[1] + 112), pen=Pen.SOFT, dashed=True)
    sheet.line(
        (middle[0] - 120, middle[1]), (middle[0] + 120, middle[1]), pen=Pen.SOFT, dashed=True
    )
    sheet.words((middle[0] + 126, middle[1]), "level", pen=Pen.SOFT)
    turn = radians(-_ROLL)

    def turned(x: float, y: float) -> Point:
        c, s = cos(turn), sin(turn)
        return middle[0] + x * c - y * s, middle[1] + x * s + y * c

    housing = [turned(x, y) for x, y in ((-44, -24), (44, -24), (44, 24), (-44, 24))]
    sheet.line(*housing, closed=True, fill=Fill.SHADE)
    for side in (1, -1):
        inner, outer = side * 54, side * 72
        finger = [turned(x, y) for x, y in ((inner, -17), (outer, -17), (outer, 17), (inner, 17))]
        sheet.line(*finger, closed=True, fill=Fill.SHADE)
    sheet.line(middle, turned(0, 112), pen=Pen.SECOND, width=1.6)
    sheet.arc(middle, 96, 90, 90 - _ROLL + 4, pen=Pen.SECOND, width=2.0, arrow=True)
    label = 96 + 16
    angle = radians(90 - _ROLL / 2)
    sheet.words(
        (middle[0] + label * cos(angle) - 2, middle[1] + label * sin(angle) + 4),
        "R, here positive",
        pen=Pen.SECOND,
        bold=True,
    )
    for one, other in (((-5, -5), (5, 5)), ((-5, 5), (5, -5))):
        sheet.line(
            (middle[0] + one[0], middle[1] + one[1]),
            (middle[0] + other[0], middle[1] + other[1]),
            pen=Pen.FIRST,
            width=1.6,
        )
    sheet.circle(middle, 8, pen=Pen.FIRST, width=1.8)
    left, right = turned(-63, -17), turned(63, -17)
    sheet.leader((left[0] - 30, left[1] - 52), left, "left finger", at="end")
    sheet.leader((right[0] + 30, right[1] - 34), right, "right finger")
    sheet.leader(
        (middle[0] - 60, middle[1] + 96),
        (middle[0] - 6, middle[1] + 6),
        "pointing vector, away from you",
        at="end",
    )


def _on(start: Point, length: float, angle: float) -> Point:
    return start[0] + length * cos(angle), start[1] + length * sin(angle)
