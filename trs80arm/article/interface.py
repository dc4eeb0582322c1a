"""Figures 7 and 9: the drive circuit of a motor, and the card between it and the TRS-80."""

from __future__ import annotations

from trs80arm.arm.figures.diagram import Diagram
from trs80arm.arm.figures.drives import PARTS, name
from trs80arm.arm.figures.sheet import Fill, Pen, Sheet
from trs80arm.arm.model import ArmModel
from trs80arm.machine.card import CardSettings, Jumper, Latch


def drive_circuit(card: CardSettings) -> Diagram:
    """Figure 7: four coils, a power transistor each, from a latch of the card."""
    lines = (
        "                                    +12 V",
        "            .--------------.----------+---.--------------.",
        "            |              |              |              |",
        "           phi1           phi2           phi3           phi4",
        "            )              (              )              (",
        "            )    one       (              )   another    (",
        "            )  magnetic    (              )  magnetic    (",
        "            )    path      (              )    path      (",
        "            |              |              |              |",
        "           /              /              /              /",
        f"  {'      '.join(f'D{bit} -----|' for bit in card.coil_bits)}     a power transistor",
        "           \\>             \\>             \\>             \\>   for each coil",
        "            |              |              |              |",
        "            '--------------'----------+---'--------------'",
        "                                      |",
        "                                     GND",
        "",
        "  D3 to D0 are the bits that the motor's latch holds: 1 switches a coil on. The",
        "  coils of one path oppose each other: no pattern of Figure 8 has both of them.",
    )
    return Diagram(lines, _circuit(card.coil_bits))


def _circuit(bits: tuple[int, ...]) -> Sheet:
    sheet = Sheet(860.0, 500.0)
    xs = (190.0, 340.0, 540.0, 690.0)
    rail, ground = 440.0, 96.0
    sheet.line((xs[0], rail), (xs[-1], rail), width=2)
    sheet.line((440.0, rail), (440.0, rail + 22), width=2)
    sheet.words((440.0, rail + 36), "+12 V", at="middle", bold=True)
    sheet.line((xs[0], ground), (xs[-1], ground), width=2)
    sheet.line((440.0, ground), (440.0, ground - 16), width=2)
    for order, half in enumerate((16, 10, 4)):
        sheet.line((440 - half, ground - 16 - 6 * order), (440 + half, ground - 16 - 6 * order))
    for one, other in ((xs[0], xs[1]), (xs[2], xs[3])):
        # The core on which both coils are wound.
        for side in (-5, 5):
            middle = (one + other) / 2 + side
            sheet.line((middle, 318.0), (middle, 412.0), pen=Pen.SOFT, width=3)
        sheet.words(((one + other) / 2, 302.0), "one magnetic path", at="middle", pen=Pen.SOFT)
    for order, (x, bit) in enumerate(zip(xs, bits, strict=True)):
        inwards = 1 if order % 2 == 0 else -1
        _coil(sheet, x, 412.0, 318.0, inwards)
        sheet.line((x, rail), (x, 412.0), width=1.8)
        sheet.line((x, 318.0), (x, 236.0), width=1.8)
        sheet.words(
            (x - inwards * 16, 366.0),
            f"\N{GREEK SMALL LETTER PHI}{order + 1}",
            at="end" if inwards > 0 else "start",
            bold=True,
            size=16.0,
        )
        _transistor(sheet, x, 204.0, ground, bit)
    sheet.words(
        (30.0, 36.0),
        "D3 to D0: the four bits that the motor's latch holds; 1 switches a coil on.",
        pen=Pen.SOFT,
    )
    sheet.words(
        (30.0, 16.0),
        "Coils of one path oppose each other: no pattern of Figure 8 has both of them.",
        pen=Pen.SOFT,
    )
    return sheet


def _coil(sheet: Sheet, x: float, top: float, low: float, side: int) -> None:
    """A winding, its turns towards the core."""
    turns = 4
    height = (top - low) / turns
    for turn in range(turns):
        middle = top - (turn + 0.5) * height
        if side > 0:
            sheet.arc((x, middle), height / 2, 90, -90, width=2.0)
        else:
            sheet.arc((x, middle), height / 2, 90, 270, width=2.0)


def _transistor(sheet: Sheet, x: float, y: float, ground: float, bit: int) -> None:
    """NPN, its collector at the coil, its emitter on ground, its base at a bit of the latch."""
    sheet.circle((x - 10, y), 26, pen=Pen.SOFT, width=1.2)
    sheet.line((x - 20, y - 16), (x - 20, y + 16), width=3)
    sheet.line((x - 20, y + 8), (x, y + 24), (x, y + 34), width=1.8)
    sheet.arrow((x - 20, y - 8), (x, y - 24), width=1.8)
    sheet.line((x, y - 24), (x, ground), width=1.8)
    sheet.line((x - 20, y), (x - 62, y), width=1.8)
    sheet.words((x - 68, y), f"D{bit}", at="end", pen=Pen.SECOND, bold=True)


# Figure 9


def block_diagram(card: CardSettings, model: ArmModel) -> Diagram:
    """Figure 9: address lines choose a latch, its four bits a motor's coils; inputs come back."""
    rows = _rows(card, model)
    return Diagram(tuple(_block_text(card, rows)), _blocks(card, rows))


def _rows(card: CardSettings, model: ArmModel) -> list[tuple[str, str, str]]:
    """Where each latch is reached, what it is called, and what hangs on it."""
    found = []
    for place, latch in enumerate(card.order):
        if latch is None:
            continue
        at = f"{card.base + place:02X}H" if card.jumper is Jumper.TRS80 else f"{place:d}"
        if latch is Latch.AUXILIARY:
            found.append((at, "auxiliary", "4 outputs, free"))
        else:
            drive = model.drives[latch]
            found.append((at, f"J{latch + 1} {name(drive)}", f"motor of {PARTS[drive.turns]}"))
    return found


def _words(card: CardSettings) -> tuple[str, str, str, str]:
    """What selects a latch, how the addresses are decoded, where data comes from, and inputs."""
    level = card.switch_closed
    switch = f"bit {card.switch_bit}: grip switch, {level} = closed"
    if card.jumper is Jumper.PARALLEL:
        return "D4 to D7", f"port {card.base:02X}H", "D0 to D3", switch
    last = card.base + card.addresses - 1
    return "A0 to A7", f"ports {card.base:02X}H to {last:02X}H", "D0 to D3", switch


def _block_text(card: CardSettings, rows: list[tuple[str, str, str]]) -> list[str]:
    select, ports, data, switch = _words(card)
    free = ", ".join(str(bit) for bit in range(4) if bit != card.switch_bit)
    lines = [
        "  TRS-80          interface card                           arm",
        "",
        f"  {select} =====> [decoder: {ports}]",
        "  OUT, IN  ----->     |",
        "                      | selects one latch",
        "                      v",
    ]
    for order, (at, title, _) in enumerate(rows):
        bus = f"{data} ==+==>" if order == 0 else "           |==>"
        drivers = "=============>" if title == "auxiliary" else "=> 4 drivers =>"
        hangs = "4 outputs, free" if title == "auxiliary" else f"{title} motor, 4 coils"
        lines.append(f"  {bus} [latch {at:>3}] {drivers:15} {hangs}")
    lines += [
        "             |",
        f"             '<== [input, 4 bits] <=========== {switch}",
        f"                   at every port  <=========== bits {free}: free, for sensors",
        "",
        "  A latch holds its four bits until it is written again. Motors take 12 V, 4 A.",
    ]
    return lines


def _blocks(card: CardSettings, rows: list[tuple[str, str, str]]) -> Sheet:
    select, ports, data, switch = _words(card)
    row, count = 44.0, len(rows)
    height = 236.0 + row * count
    sheet = Sheet(900.0, height)
    top = height - 34
    for x, title in ((28.0, "TRS-80"), (300.0, "interface card"), (700.0, "arm")):
        sheet.words((x, top), title, bold=True, size=15.0)
    sheet.line((236.0, 40.0), (236.0, height - 16), pen=Pen.SOFT, dashed=True)
    sheet.line((636.0, 40.0), (636.0, height - 16), pen=Pen.SOFT, dashed=True)
    # The decoder.
    decoder = top - 74
    sheet.box(290, decoder, 190, 50, fill=Fill.SHADE)
    sheet.words((385, decoder + 34), "address decoder", at="middle", bold=True)
    sheet.words((385, decoder + 16), ports, at="middle", size=12.0)
    sheet.arrow((120, decoder + 34), (290, decoder + 34), pen=Pen.SECOND, width=3)
    sheet.words((28, decoder + 34), select, pen=Pen.SECOND, bold=True)
    sheet.arrow((120, decoder + 14), (290, decoder + 14), pen=Pen.SECOND, width=1.4)
    sheet.words((28, decoder + 14), "OUT, IN", pen=Pen.SECOND, bold=True)
    # The latches.
    first = decoder - 46
    bus, chosen = 262.0, 352.0
    last = first - row * (count - 1)
    low = last - 58
    sheet.line((bus, low), (bus, first), pen=Pen.FIRST, width=3)
    sheet.line((chosen, decoder), (chosen, last), pen=Pen.SECOND, width=1.2, dashed=True)
    for order, (at, title, turns) in enumerate(rows):
        y = first - order * row
        sheet.arrow((bus, y), (300, y), pen=Pen.FIRST, width=3)
        sheet.box(300, y - 15, 104, 30, fill=Fill.PAPER)
        sheet.words((352, y), f"latch {at}", at="middle")
        if title == "auxiliary":
            sheet.arrow((404, y), (690, y), pen=Pen.FIRST, width=2)
        else:
            sheet.arrow((404, y), (452, y), pen=Pen.FIRST, width=2)
            sheet.box(452, y - 15, 96, 30, fill=Fill.SHADE)
            sheet.words((500, y), "4 drivers", at="middle")
            sheet.arrow((548, y), (690, y), pen=Pen.FIRST, width=2)
            sheet.circle((704, y), 12, fill=Fill.SHADE)
            sheet.words((704, y), "M", at="middle", size=12.0, bold=True)
        sheet.words((724, y + 8), title, bold=True)
        sheet.words((724, y - 8), turns, pen=Pen.SOFT, size=12.0)
    data_y = first
    sheet.line((120, data_y), (bus, data_y), pen=Pen.FIRST, width=3)
    sheet.words((28, data_y), data, pen=Pen.FIRST, bold=True)
    sheet.words((28, data_y - 18), "both ways", pen=Pen.SOFT, size=12.0)
    # The inputs.
    sheet.box(300, low - 20, 248, 40, fill=Fill.SHADE)
    sheet.words((424, low + 6), "input, 4 bits", at="middle", bold=True)
    sheet.words((424, low - 9), "read at every port", at="middle", size=12.0)
    sheet.arrow((300, low), (bus, low), pen=Pen.THIRD, width=3)
    free = ", ".join(str(bit) for bit in range(4) if bit != card.switch_bit)
    for up, words in ((10, switch), (-10, f"bits {free}: free, for sensors")):
        sheet.arrow((690, low + up), (548, low + up), pen=Pen.THIRD, width=1.6)
        sheet.words((698, low + up), words, size=12.0)
    sheet.words(
        (28.0, 18.0),
        "A latch holds its four bits until it is written again. Motors take 12 V, 4 A.",
        pen=Pen.SOFT,
    )
    return sheet
