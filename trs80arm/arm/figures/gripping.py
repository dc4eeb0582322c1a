"""Figure 5: the control system for gripping: cable, spring, tension switch, links, and back."""

from __future__ import annotations

from trs80arm.arm.figures.diagram import Diagram, Page
from trs80arm.arm.figures.drives import number
from trs80arm.arm.figures.sheet import Fill, Pen, Sheet
from trs80arm.arm.model import ArmModel, Motor


def gripping(model: ArmModel) -> Diagram:
    """From the hand's motor to the grips, and from the switch back to the computer."""
    return Diagram(tuple(_text(model)), _sheet(model))


def _facts(model: ArmModel) -> list[str]:
    """How cable becomes opening, and then force."""
    hand, drive = model.hand, model.drives[model.latch(Motor.HAND)]
    ounces = hand.switch_force * 16
    return [
        f"cable: {drive.steps:g} half-steps to the inch of opening, 0 to {hand.range:g} in",
        f"spring: from the touch on {hand.pound_steps} half-steps to the pound, "
        f"up to {hand.full_grip:g} lb",
        f"switch: closes at {ounces:g} oz, {hand.switch_steps} half-steps after the touch",
    ]


def _text(model: ArmModel) -> list[str]:
    page = Page()
    joint = number(model, Motor.HAND)
    page.put(0, 2, "motor, gears   extension      tension           hand")
    page.put(1, 2, "and drum       spring         switch       housing   links   grips")
    page.put(3, 2, "[M " + joint + "](@)~~~~/\\/\\/\\/\\~~~~~~~~[ / ]~~~~~~~~~[     ]==========[ ]")
    page.put(4, 4, "^     cable               |            [     ]    ____     |")
    page.put(5, 4, "|                         |            [     ]   |part|   gap")
    page.put(6, 4, "|                         |            [     ]   |____|    |")
    page.put(7, 4, "|                         v            [     ]==========[ ]")
    page.put(8, 2, "driver                  input bit     torsion springs open the hand")
    page.put(9, 4, "^   .------------------.  |")
    page.put(10, 4, "'---| computer: @CLOSE |<-'")
    page.put(11, 8, "| a step closer    |")
    page.put(12, 8, "| until it closes  |")
    page.put(13, 8, "'------------------'")
    return [*page.lines, "", *(f"  {line}" for line in _facts(model))]


def _sheet(model: ArmModel) -> Sheet:
    sheet = Sheet(900.0, 440.0)
    y = 300.0
    cable = Pen.FIRST
    # Motor and drum.
    sheet.box(30, y - 34, 84, 68, fill=Fill.SHADE)
    sheet.words((72, y + 8), "hand motor", at="middle", bold=True, size=12.5)
    sheet.words((72, y - 10), f"{number(model, Motor.HAND)}, gears", at="middle", size=12.0)
    sheet.circle((144, y), 20, pen=cable, fill=Fill.PAPER, width=1.8)
    sheet.line((114, y), (124, y), width=4)
    sheet.words((144, y - 34), "drum", at="middle", pen=Pen.SOFT)
    # Cable, spring, switch, idlers.
    sheet.line((144, y + 20), (236, y + 20), pen=cable, width=2)
    _spring(sheet, 236, 346, y + 20)
    sheet.words((291, y + 52), "extension spring", at="middle")
    sheet.line((346, y + 20), (424, y + 20), pen=cable, width=2)
    sheet.box(424, y - 6, 70, 52, fill=Fill.SHADE)
    sheet.line((436, y + 8), (452, y + 8), width=1.6)
    sheet.line((452, y + 8), (470, y + 18), width=1.6)
    sheet.line((472, y + 8), (484, y + 8), width=1.6)
    sheet.line((424, y + 34), (494, y + 34), pen=cable, width=2)
    sheet.line((424, y + 20), (424, y + 34), pen=cable, width=2)
    sheet.words((459, y + 62), "tension switch", at="middle")
    sheet.line((494, y + 34), (604, y + 34), pen=cable, width=2)
    for x in (530.0, 574.0):
        sheet.circle((x, y + 25), 9, fill=Fill.PAPER, width=1.2)
    sheet.words((552, y + 4), "idlers", at="middle", pen=Pen.SOFT)
    _hand(sheet, model, 604.0, y + 10)
    # The way back.
    sheet.box(200, 96, 200, 76, fill=Fill.SHADE)
    sheet.words((300, 152), "computer", at="middle", bold=True)
    sheet.words((300, 133), "@CLOSE: a step closer", at="middle", size=12.0)
    sheet.words((300, 116), "until the switch closes", at="middle", size=12.0)
    sheet.arrow((459, y - 6), (459, 134), (400, 134), pen=Pen.SECOND, width=1.8)
    sheet.words((468, 190), "input bit of the card:", pen=Pen.SECOND)
    sheet.words((468, 173), "the switch, open or closed", pen=Pen.SECOND)
    sheet.arrow((200, 134), (72, 134), (72, y - 34), pen=Pen.THIRD, width=1.8)
    sheet.words((82, 190), "coil patterns", pen=Pen.THIRD)
    sheet.words((82, 173), "by way of the card", pen=Pen.THIRD)
    for order, line in enumerate(_facts(model)):
        sheet.words((30.0, 66.0 - 19 * order), line, pen=Pen.SOFT)
    return sheet


def _spring(sheet: Sheet, begin: float, end: float, y: float) -> None:
    turns = 8
    step = (end - begin) / turns
    points = [(begin, y)]
    for turn in range(turns):
        points += [
            (begin + (turn + 0.25) * step, y + 11),
            (begin + (turn + 0.75) * step, y - 11),
        ]
    sheet.line(*points, (end, y), pen=Pen.INK, width=1.6)


def _hand(sheet: Sheet, model: ArmModel, x: float, y: float) -> None:
    """Housing, two pairs of links, grips, a part between them."""
    sheet.box(x, y - 32, 50, 100, fill=Fill.SHADE)
    sheet.words((x + 25, y + 18), "housing", at="middle", pen=Pen.SOFT, size=11.5)
    part = 34.0
    middle = y + 18
    for side in (1, -1):
        root = middle + side * 26
        grip = middle + side * (part / 2 + 8)
        for way in (10, -10):
            one, other = (x + 44, root + way), (x + 150, grip + side * 12 + way)
            sheet.line(one, other, width=5, pen=Pen.SOFT)
            sheet.circle(one, 3.2, fill=Fill.PAPER, width=1.2)
            sheet.circle(other, 3.2, fill=Fill.PAPER, width=1.2)
        sheet.box(x + 142, grip - 8 + (side - 1) * 6, 78, 28, fill=Fill.SHADE)
    sheet.box(
        x + 168, middle - part / 2 - 1, 46, part + 2, pen=Pen.FIFTH, fill=Fill.PAPER, width=1.8
    )
    sheet.words((x + 191, middle), "part", at="middle", pen=Pen.FIFTH, size=12.0)
    for side in (1, -1):
        edge = middle + side * part / 2
        sheet.line((x + 222, edge), (x + 246, edge), pen=Pen.SOFT, width=0.7)
    sheet.arrow((x + 238, middle - part / 2), (x + 238, middle + part / 2), pen=Pen.SOFT, both=True)
    opening = f"0 to {model.hand.range:g} in"
    sheet.words((x + 246, middle), opening, pen=Pen.SOFT)
    sheet.leader((x + 62, y - 66), (x + 92, middle - 38), "links on small pins", at="end")
    sheet.leader((x + 196, y - 66), (x + 176, middle - 30), "grips")
    sheet.leader((x + 96, y + 104), (x + 46, middle + 38), "torsion springs open the hand")
