"""The work cell: every sensor and answer on the free inputs, and what the devices do."""

from __future__ import annotations

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row
from trs80arm.ui.panels.glyph_panels import LampPanel

_WIDE = 24


class CellPanel(LampPanel):
    """A row an input, with its bit, bank and name; a row a device."""

    HELP = """
## Cell

Sensors and answers on the three free bits of the input nibble: the bit, the bank of the selector
if there is one, a lamp that is lit while it answers (`●`, or `*` in ASCII; the bit is then 0), and
the name. What the selector does not show now is dim: `INP` does not see it. Below are the devices
on the auxiliary output, and what each does.
"""

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """Inputs in the order of bank and bit, then devices."""
        rows = self._inputs(readings, width)
        for thing in readings.things:
            if thing.state:
                state = (thing.state, Ink.STRONG if thing.on else Ink.PLAIN)
                rows.append(((f"{thing.name} ", Ink.LABEL), state))
        return rows or [(("no sensors, no devices", Ink.LABEL),)]

    def _inputs(self, readings: Readings, width: int) -> list[Row]:
        """What is on the input bits."""
        rows: list[Row] = []
        for answer in sorted(readings.answers, key=lambda each: (each.bank, each.bit)):
            seen = readings.bank in (None, answer.bank)
            ink = Ink.LABEL if not seen else Ink.STRONG if answer.given else Ink.PLAIN
            bank = None if readings.bank is None else answer.bank
            where = _where(answer.bit, bank, wide=width >= _WIDE)
            rows.append(((where, Ink.LABEL), self.lamp(answer.given, " "), (answer.name, ink)))
        if readings.bank is not None:
            shown = "the selector shows bank" if width >= _WIDE + 2 else "shows bank"
            rows.insert(0, ((f"{shown} {readings.bank}", Ink.LABEL),))
        return rows


def _where(bit: int, bank: int | None, *, wide: bool) -> str:
    """The bit of an answer, and its bank if there are several."""
    if not wide:
        return f"{bit} " if bank is None else f"{bank}.{bit} "
    return f"bit {bit} " if bank is None else f"bank {bank} bit {bit} "
