"""The interface card's lamps: four coils a motor, the auxiliary output, the input nibble."""

from __future__ import annotations

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink, Row, Span
from trs80arm.ui.panels.glyph_panels import LampPanel

_WIDE = 34
_SPACED = 40
_VERY_WIDE = 52


class CoilsPanel(LampPanel):
    """A lamp for every bit that goes down the cable or comes up it."""

    HELP = """
## Coils

A lamp for each of the four coils of each motor, phi 1 to phi 4, as the card's latches hold them:
`●` carries current, `○` does not (`*` and `.` in ASCII). A motor turns by one half-step with each
row of the article's Figure 8. Below are the auxiliary output and the input nibble: `g`, the grip
switch, then the three free inputs, lit when closed or answering.
"""

    def draw(self, readings: Readings, width: int, height: int) -> list[Row]:
        """A row a latch, with what motors, hand and devices do below or beside."""
        wide = width >= _WIDE
        gap = "" if wide and width < _SPACED else " "
        motor_names = readings.model.motor_names
        names = [f"J{joint + 1} {name}" for joint, name in enumerate(motor_names)] + ["auxiliary"]
        rows: list[Row] = [
            (_label(name, wide), *self._lamps(nibble, gap))
            for name, nibble in zip(names, readings.coils, strict=True)
        ]
        rows.append(
            (_label("input g123" if wide else "in", wide), *self._lamps(_answers(readings), gap))
        )
        motors = _state("motors", "ON" if readings.motors_on else "off", readings.motors_on)
        grip = _state(
            "grip", "closed" if readings.switch_closed else "open", readings.switch_closed
        )
        holds = _state("holds", readings.held or "nothing", readings.held is not None)
        if wide:
            devices = [_state(*device, remarkable=False) for device in readings.devices]
            beside = [motors, grip, holds, *devices[: len(rows) - 3]]
            if height < len(rows) and width >= _VERY_WIDE:
                beside += rows[6:]
                del rows[6:]
            for place, state in enumerate(beside):
                rows[place] = (*rows[place], ("  ", Ink.PLAIN), *state)
        else:
            rows += [motors, grip] if height > len(rows) + 1 else [motors]
        if height > len(rows):
            phases = f"1{gap}2{gap}3{gap}4"
            rows.insert(0, ((f"{'phi':{15 if wide else 4}}{phases}", Ink.LABEL),))
        return rows

    def _lamps(self, nibble: int, gap: str) -> list[Span]:
        """Four lamps, phi 1 first."""
        return [self.lamp(bool(nibble >> bit & 1), gap) for bit in (3, 2, 1, 0)]


def _answers(readings: Readings) -> int:
    """The input nibble as lamps, the grip switch first: inputs idle at 1 and answer with 0."""
    return sum((~readings.inputs >> bit & 1) << 3 - bit for bit in range(4))


def _label(name: str, wide: bool) -> Span:
    return (f"{name:15}" if wide else f"{name[:3].strip():4}", Ink.LABEL)


def _state(name: str, value: str, remarkable: bool) -> Row:
    return ((f"{name} ", Ink.LABEL), (value, Ink.STRONG if remarkable else Ink.PLAIN))
