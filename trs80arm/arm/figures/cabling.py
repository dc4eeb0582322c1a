"""Figure 3: how each motor's cable goes over the joints to what it turns, and what that couples."""

from __future__ import annotations

from itertools import pairwise

from trs80arm.arm.figures.diagram import Diagram
from trs80arm.arm.figures.drives import PARTS, does, name
from trs80arm.arm.figures.sheet import Fill, Pen, Sheet
from trs80arm.arm.model import ArmModel, Drive, Motor

_ENDS = {
    Motor.BASE: 0,
    Motor.SHOULDER: 1,
    Motor.ELBOW: 2,
    Motor.LEFT_WRIST: 3,
    Motor.RIGHT_WRIST: 3,
    Motor.HAND: 4,
}
"""The axis at which each cable ends (article, on the joints); the hand is beyond the last."""
_PENS = (Pen.FIRST, Pen.SECOND, Pen.THIRD, Pen.FOURTH, Pen.FIFTH, Pen.SIXTH)
_X = (96.0, 210.0, 350.0, 490.0, 620.0)
"""Where drums and axes stand on the sheet, units."""
_TOP = 440.0
_ROW = 62.0
_SCALE = 17.0
"""Units to the inch of a pulley."""
_IDLER = 8.0


def cabling(model: ArmModel) -> Diagram:
    """The six cables, side by side."""
    return Diagram(tuple(_text(model)), _sheet(model))


def _couplings(model: ArmModel) -> list[str]:
    """What moves along with something else, and what makes up for it."""
    way = "out" if model.elbow_pays_out * model.drives[model.latch(Motor.ELBOW)].sign > 0 else "in"
    back = (
        "@STEP takes back as many of J6 by itself"
        if model.compensated
        else "a program has to take back as many of J6"
    )
    return [
        "Idlers take each cable around the joints before its own: shoulder, elbow and",
        "wrist keep their angles to the horizontal while a joint before them turns.",
        f"Raising the forearm by a half-step pays {way} a half-step of hand cable;",
        f"{back}.",
    ]


def _text(model: ArmModel) -> list[str]:
    lines = [
        "                drum     shoulder    elbow     wrist",
        "                            :         :         :",
    ]
    for latch, drive in enumerate(model.drives):
        end = _ENDS[drive.turns]
        run = f"J{latch + 1} {name(drive):12}[M]"
        for station in range(4):
            if station == 0:
                run += "---oo--(O) the base" if end == 0 else "-------"
            elif station < end:
                run += "---o------" if end > station else ""
            elif station == end:
                run += f"--(O) {PARTS[drive.turns]}"
        if end == 4:
            run += f"---> {PARTS[drive.turns]}"
        lines.append(run)
    lines += ["", "  [M] motor, gears, drum    o idler    (O) pulley, its radius below", ""]
    heading = ("", "turns", "half-steps", "pulley", "counting up")
    rows = [
        (
            f"J{latch + 1}",
            PARTS[drive.turns],
            _steps(drive),
            f"{drive.pulley:.2f} in" if drive.turns is not Motor.HAND else "-",
            does(drive, 1),
        )
        for latch, drive in enumerate(model.drives)
    ]
    widths = [max(len(row[i]) for row in (heading, *rows)) for i in range(5)]
    for row in (heading, *rows):
        cells = (cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        lines.append("  ".join(cells).rstrip())
    return [*lines, "", *(f"  {line}" for line in _couplings(model))]


def _steps(drive: Drive) -> str:
    unit = "inch" if drive.turns is Motor.HAND else "radian"
    return f"{drive.steps:.1f} / {unit}"


def _sheet(model: ArmModel) -> Sheet:
    sheet = Sheet(900.0, 590.0)
    bottom = _TOP - 5 * _ROW - 26
    for x, title in zip(_X, ("drive units", "base", "shoulder", "elbow", "wrist"), strict=True):
        if title != "drive units":
            sheet.line((x, bottom), (x, _TOP + 52), pen=Pen.SOFT, width=0.9, dashed=True)
        sheet.words((x, _TOP + 68), title, at="middle", bold=True)
    sheet.words((_X[-1] + 50, _TOP + 68), "turns", bold=True)
    for latch, (drive, pen) in enumerate(zip(model.drives, _PENS, strict=True)):
        _cable(sheet, f"J{latch + 1}", drive, _TOP - latch * _ROW, pen)
    for order, line in enumerate(_couplings(model)):
        sheet.words((20.0, 72.0 - order * 18), line, pen=Pen.SOFT, size=12.5)
    sheet.words(
        (20.0, 566.0),
        f"{model.title}: pulleys to scale, a guess but for their ratios",
        pen=Pen.SOFT,
    )
    return sheet


def _cable(sheet: Sheet, number: str, drive: Drive, y: float, pen: Pen) -> None:
    """One motor's cable, out and back."""
    end = _ENDS[drive.turns]
    drum = 11.0
    radius = drive.pulley * _SCALE if drive.turns is not Motor.HAND else 6.0
    of_hand, of_base = drive.turns is Motor.HAND, drive.turns is Motor.BASE
    last = _X[4] + 34 if of_hand else _X[end + 1]
    stations = [] if of_base else [x for x in _X[2:] if x < last]
    lines = [(_X[0], drum)]
    lines += [(x, _IDLER) for x in stations]
    if of_base:
        lines.append((last - 44, _IDLER))
    lines.append((last, radius))
    for (one, here), (other, there) in pairwise(lines):
        for side in (1, -1):
            sheet.line((one, y + side * here), (other, y + side * there), pen=pen, width=1.6)
    sheet.box(_X[0] - 46, y - 15, 34, 30, fill=Fill.SHADE)
    sheet.words((_X[0] - 29, y), number, at="middle", bold=True)
    sheet.circle((_X[0], y), drum, pen=pen, fill=Fill.PAPER, width=1.8)
    for x, _ in lines[1:-1]:
        # Below the base's pulley two of them bend the cable by a right angle.
        for aside in (-6.5, 6.5) if of_base else (0.0,):
            sheet.circle((x, y + aside), 6.0 if of_base else _IDLER, fill=Fill.PAPER, width=1.2)
            sheet.circle((x, y + aside), 1.5, fill=Fill.PEN)
    if of_hand:
        sheet.arrow((last - 16, y), (last + 10, y), pen=pen, width=1.6)
    else:
        sheet.circle((last, y), radius, pen=pen, fill=Fill.SHADE, width=2.2)
        sheet.circle((last, y), 2.0, fill=Fill.PEN)
    sheet.words(
        (_X[-1] + 50, y + 9), PARTS[drive.turns].removeprefix("the ").capitalize(), bold=True
    )
    size = "" if drive.turns is Motor.HAND else f", pulley {drive.pulley:.2f} in"
    sheet.words((_X[-1] + 50, y - 8), f"{_steps(drive)}{size}", pen=Pen.SOFT, size=12.0)
