"""Figure 1: the major structural components, with the frame in which places are told."""

from __future__ import annotations

from math import cos, degrees, radians, sin

from trs80arm.arm.figures.diagram import Diagram, Page
from trs80arm.arm.figures.drives import number
from trs80arm.arm.figures.sheet import Fill, Pen, Point, Sheet
from trs80arm.arm.model import ArmModel, Link, Motor
from trs80arm.arm.settings import ArmSettings

_SCALE = 27.0
"""Units to the inch."""
_ORIGIN = (268.0, 74.0)
_ANGLES = (radians(58), radians(-26), radians(-72))
"""Upper arm, forearm and hand to the horizontal, for a picture with everything apart."""


def structure(settings: ArmSettings) -> Diagram:
    """The arm from its right side, to scale, and named."""
    return Diagram(tuple(_text(settings)), _sheet(settings))


def _ranges(model: ArmModel) -> dict[Motor, str]:
    """How far each joint goes, in words."""
    limits = model.limits
    low, high = (round(degrees(angle)) for angle in limits.shoulder)
    bent, straight = (round(degrees(angle)) for angle in limits.elbow)
    return {
        Motor.BASE: f"+-{degrees(limits.base):.0f} deg",
        Motor.SHOULDER: f"{low:+d} to {high:+d} deg",
        Motor.ELBOW: f"{bent:d} to {straight:d} deg",
        Motor.LEFT_WRIST: f"pitch +-{degrees(limits.pitch):.0f} deg",
        Motor.HAND: f"0 to {model.hand.range:g} in",
    }


def _text(settings: ArmSettings) -> list[str]:
    model = settings.arm_model
    ranges = _ranges(model)
    names = {motor: number(model, motor) for motor in Motor}
    gears = " and ".join(sorted((names[Motor.LEFT_WRIST], names[Motor.RIGHT_WRIST])))
    link, height = f"{model.link:g} in", f"{model.shoulder_height:g} in"
    front, rear = f"{settings.base_front:g} in", f"{settings.base_rear:g} in"
    page = Page()
    page.put(0, 35, f"elbow, {names[Motor.ELBOW]}: {ranges[Motor.ELBOW]}")
    page.put(1, 36, "_o_")
    for step in range(9):
        page.put(2 + step, 34 - 2 * step, "_/" if step < 8 else "/")
    for step in range(4):
        page.put(2 + step, 39 + 2 * step, "\\_")
    page.put(4, 11, f"upper arm, {link}")
    page.put(3, 47, f"forearm, {link}")
    page.put(6, 47, f"o  wrist, {gears}: differential")
    page.put(7, 47, f"|  {ranges[Motor.LEFT_WRIST]}")
    page.put(8, 47, "|")
    page.put(9, 46, f"_|_   hand, {model.hand_length:g} in to the tips")
    page.put(10, 45, f"|   |  {names[Motor.HAND]}: {ranges[Motor.HAND]}")
    page.put(11, 45, "'   '")
    page.put(12, 47, "+  fingertip: x, y, z")
    page.put(10, 16, "o")
    page.put(10, 20, f"shoulder, {names[Motor.SHOULDER]}:")
    page.put(11, 20, ranges[Motor.SHOULDER])
    for row in range(4, 18):
        page.put(row, 5, "|")
    page.put(3, 5, "^")
    page.put(2, 5, "z")
    page.put(10, 5, "+- - - - -")
    page.put(13, 0, height.removesuffix(" in"))
    page.put(14, 0, "in")
    page.put(11, 14, "_|:|_")
    for row in (12, 13, 14, 15):
        page.put(row, 13, "[  :  ]")
    page.put(13, 21, "drive units, six motors")
    page.put(15, 21, f"body, turned by {names[Motor.BASE]}: {ranges[Motor.BASE]}")
    page.put(16, 3, "_____________:____")
    page.put(17, 2, "|  base, card  :    |")
    page.put(18, 0, "--'-------------0----'" + "-" * 46 + "> x")
    page.put(19, 2, "table         origin")
    page.put(19, 30, "y points away from you, to the arm's left")
    return [
        *page.lines,
        "",
        "  The origin is where the centerline of the base joint meets the tabletop. The",
        f"  base reaches {front} ahead of it and {rear} behind; the stretched arm",
        f"  reaches {model.reach:g} in from the shoulder.",
    ]


def _sheet(settings: ArmSettings) -> Sheet:
    model = settings.arm_model
    sheet = Sheet(850.0, 560.0)
    place = _place
    t2, t3, pitch = _ANGLES
    shoulder = (0.0, model.shoulder_height)
    elbow = _on(shoulder, model.link, t2)
    wrist = _on(elbow, model.link, t3)
    tip = _on(wrist, model.hand_length, pitch)
    left, ground = 20.0, _ORIGIN[1]
    # Table and frame.
    sheet.line((left, ground), (830.0, ground), pen=Pen.SOFT, width=1.2)
    sheet.arrow(_ORIGIN, (820.0, ground), pen=Pen.FIRST, width=1.8)
    sheet.words((808.0, ground - 16), "x", pen=Pen.FIRST, bold=True)
    sheet.line(_ORIGIN, place(shoulder), pen=Pen.FIRST, width=1.2, dashed=True)
    sheet.arrow(place(shoulder), (_ORIGIN[0], 545.0), pen=Pen.FIRST, width=1.8)
    sheet.words((_ORIGIN[0] - 16, 538.0), "z", pen=Pen.FIRST, bold=True)
    # Base and body.
    base = place((-settings.base_rear, 0.0))
    wide = (settings.base_rear + settings.base_front) * _SCALE
    sheet.box(*base, wide, settings.base_height * _SCALE, fill=Fill.SHADE)
    body = place((-settings.body_radius, settings.base_height))
    tall = (settings.body_top - settings.base_height) * _SCALE
    sheet.box(*body, 2 * settings.body_radius * _SCALE, tall, fill=Fill.SHADE)
    # Motors behind the body, one for each drive; three on either side.
    for row in range(3):
        x, y = -settings.body_radius - 0.8, settings.body_top - 0.9 - 1.55 * row
        corner = place((x - 0.75, y - 0.6))
        sheet.box(*corner, 1.5 * _SCALE, 1.2 * _SCALE, fill=Fill.PAPER)
        sheet.circle(place((x + 0.1, y)), 0.45 * _SCALE, width=1.0)
    # The bracket that carries the shoulder.
    sheet.line(
        place((-0.9, settings.body_top)),
        place((-0.35, model.shoulder_height)),
        place((0.35, model.shoulder_height)),
        place((0.9, settings.body_top)),
        closed=True,
        fill=Fill.SHADE,
    )
    halves = {solid.link: solid.half[2] for solid in model.solids}
    for start, end, link in (
        (shoulder, elbow, Link.UPPER_ARM),
        (elbow, wrist, Link.FOREARM),
    ):
        half = halves[link] * _SCALE * (0.55 if link is Link.UPPER_ARM else 1.0)
        sheet.bar(place(start), place(end), half, fill=Fill.SHADE)
    _hand(sheet, wrist, tip, pitch)
    for joint, radius in ((shoulder, 0.42), (elbow, 0.36), (wrist, 0.3)):
        sheet.circle(place(joint), radius * _SCALE, fill=Fill.PAPER, width=1.8)
        sheet.circle(place(joint), 2.0, fill=Fill.PEN)
    sheet.circle(_ORIGIN, 4.0, pen=Pen.FIRST, fill=Fill.PEN)
    # y goes into the page.
    y_place = (_ORIGIN[0] + 20, ground - 22)
    sheet.circle(y_place, 7.0, pen=Pen.FIRST, width=1.6)
    for one, other in (((-5, -5), (5, 5)), ((-5, 5), (5, -5))):
        sheet.line(
            (y_place[0] + one[0], y_place[1] + one[1]),
            (y_place[0] + other[0], y_place[1] + other[1]),
            pen=Pen.FIRST,
            width=1.4,
        )
    sheet.words((y_place[0] + 14, y_place[1]), "y, away from you", pen=Pen.FIRST)
    _names(sheet, settings, shoulder, elbow, wrist, tip)
    return sheet


def _hand(sheet: Sheet, wrist: Point, tip: Point, pitch: float) -> None:
    """The hand's housing, and the finger on this side."""
    along = cos(pitch), sin(pitch)
    root = wrist[0] + along[0] * 1.3, wrist[1] + along[1] * 1.3
    sheet.bar(_place(wrist), _place(root), 0.5 * _SCALE, fill=Fill.SHADE)
    knuckle = tip[0] - along[0] * 0.8, tip[1] - along[1] * 0.8
    sheet.bar(_place(root), _place(knuckle), 0.16 * _SCALE, fill=Fill.SHADE)
    sheet.bar(_place(knuckle), _place(tip), 0.3 * _SCALE, fill=Fill.SHADE)


def _names(
    sheet: Sheet,
    settings: ArmSettings,
    shoulder: Point,
    elbow: Point,
    wrist: Point,
    tip: Point,
) -> None:
    """What everything is called, and how long it is."""
    model = settings.arm_model
    ranges = _ranges(model)
    names = {motor: number(model, motor) for motor in Motor}
    gears = " and ".join(sorted((names[Motor.LEFT_WRIST], names[Motor.RIGHT_WRIST])))
    place = _place
    t2, t3, pitch = _ANGLES
    link, hand = f"L = {model.link:g} in", f"LL = {model.hand_length:g} in"
    sheet.measure(place(shoulder), place(elbow), link, off=_off(t2, -46))
    sheet.measure(place(elbow), place(wrist), link, off=_off(t3, 40))
    sheet.measure(place(wrist), place(tip), hand, off=_off(pitch, 58))
    low = place((-settings.base_rear, 0.0))[0] - 26
    height = f"H = {model.shoulder_height:g} in"
    sheet.measure(_ORIGIN, place(shoulder), height, off=(low - _ORIGIN[0], 0.0))
    at = place(elbow)
    sheet.leader((at[0] + 24, at[1] + 77), at, f"elbow joint, {names[Motor.ELBOW]}")
    sheet.words((at[0] + 24, at[1] + 61), f"{ranges[Motor.ELBOW]} from the upper arm", pen=Pen.SOFT)
    at = place(shoulder)
    sheet.leader((at[0] - 50, at[1] + 44), at, f"shoulder joint, {names[Motor.SHOULDER]}", at="end")
    range_of = f"{ranges[Motor.SHOULDER]} to the horizontal"
    sheet.words((at[0] - 50, at[1] + 28), range_of, pen=Pen.SOFT, at="end")
    at = place(wrist)
    sheet.leader((at[0] + 70, at[1] + 40), at, f"wrist joint, {gears}: differential")
    range_of = f"{ranges[Motor.LEFT_WRIST]} from the forearm"
    sheet.words((at[0] + 70, at[1] + 24), range_of, pen=Pen.SOFT)
    sheet.leader((at[0] - 70, at[1] - 52), place(_on(wrist, 0.9, pitch)), "hand", at="end")
    grips = f"grips, {names[Motor.HAND]}: {ranges[Motor.HAND]}"
    tips = place(_on(wrist, model.hand_length - 0.4, pitch))
    sheet.leader((at[0] - 70, place(tip)[1] + 4), tips, grips, at="end")
    one = place(_between(shoulder, elbow, 0.5))
    sheet.leader((one[0] - 84, one[1] + 34), one, "upper arm", at="end")
    two = place(_between(elbow, wrist, 0.62))
    sheet.leader((two[0] - 20, two[1] - 44), two, "forearm", at="middle")
    drive = place((-settings.body_radius - 1.4, settings.body_top - 0.9 - 1.55))
    sheet.leader((drive[0] - 22, drive[1] + 40), drive, "drive units", at="end")
    body = place((0.6, settings.base_height + 1.9))
    sheet.leader((body[0] + 74, body[1] + 16), body, "body, turned by the base joint")
    turned = f"{names[Motor.BASE]}: {ranges[Motor.BASE]}"
    sheet.words((body[0] + 74, body[1]), turned, pen=Pen.SOFT)
    card = place((-settings.base_rear + 0.4, settings.base_height / 2))
    sheet.words(card, "base, with the interface card", size=12.0)
    sheet.words((_ORIGIN[0] - 8, _ORIGIN[1] - 22), "origin", at="end", pen=Pen.FIRST)
    sheet.words((700.0, _ORIGIN[1] - 22), "table", pen=Pen.SOFT)
    sheet.words((20.0, 20.0), f"{model.title}, to scale", pen=Pen.SOFT)


def _place(point: Point) -> Point:
    """Inches ahead of the base's axis and above the table, on the sheet."""
    return _ORIGIN[0] + point[0] * _SCALE, _ORIGIN[1] + point[1] * _SCALE


def _on(start: Point, length: float, angle: float) -> Point:
    return start[0] + length * cos(angle), start[1] + length * sin(angle)


def _between(one: Point, other: Point, share: float) -> Point:
    return one[0] + (other[0] - one[0]) * share, one[1] + (other[1] - one[1]) * share


def _off(angle: float, units: float) -> Point:
    """So far to the left of a direction."""
    return -sin(angle) * units, cos(angle) * units
