"""Figure 11: the keys that move the arm in manual mode, on the TRS-80's keyboard."""

from __future__ import annotations

from trs80arm.arm.figures.diagram import Diagram
from trs80arm.arm.figures.drives import does, name
from trs80arm.arm.figures.sheet import Fill, Pen, Sheet
from trs80arm.arm.model import ArmModel
from trs80arm.machine.jog_keys import JogKeys
from trs80arm.machine.keys import ARROWS, INDENTS, PLAIN_ARROWS, ROWS_OF_KEYS, Key

_WIDE = {Key.SPACE: 8.0, Key.SHIFT: 1.6, Key.ENTER: 1.6, Key.CLEAR: 1.5, Key.BREAK: 1.5}
"""Widths of keys that are wider than one."""
_CAPS = {
    **PLAIN_ARROWS,
    Key.BREAK: "BRK",
    Key.CLEAR: "CLR",
    Key.ENTER: "ENT",
    Key.SHIFT: "SHFT",
}
_SIZE = 54.0
_CELLS = 4
"""Columns of a key in text."""


def keyboard(keys: JogKeys, model: ArmModel) -> Diagram:
    """The keys of `@SET`, with what each of them does."""
    roles = _roles(keys)
    return Diagram(tuple(_text(keys, roles, model)), _sheet(keys, roles, model))


def _roles(keys: JogKeys) -> dict[Key, str]:
    """What stands on the keys that do something."""
    roles = {keys.leave: "end"}
    for joint, (plus, minus) in enumerate(zip(keys.positive, keys.negative, strict=True)):
        roles[plus], roles[minus] = f"+J{joint + 1}", f"-J{joint + 1}"
    return roles


def _legend(keys: JogKeys, model: ArmModel) -> list[tuple[str, str, str]]:
    """A row for each joint: its name, and what its two keys do."""
    return [
        (f"J{joint + 1} {name(drive)}", f"{plus}  {does(drive, 1)}", f"{minus}  {does(drive, -1)}")
        for joint, (drive, plus, minus) in enumerate(
            zip(model.drives, keys.positive, keys.negative, strict=True)
        )
    ]


def _text(keys: JogKeys, roles: dict[Key, str], model: ArmModel) -> list[str]:
    lines = []
    for row, indent in zip(ROWS_OF_KEYS[:-1], INDENTS, strict=False):
        caps = [_CAPS.get(key, key.value) for key in row]
        shown = [cap[:_CELLS].center(_CELLS) for cap in caps]
        said = [roles.get(key, "").center(_CELLS) for key in row]
        left = " " * indent
        lines.append(f"{left}|{'|'.join(shown)}|")
        if any(said_of.strip() for said_of in said):
            lines.append(f"{left}|{'|'.join(said)}|")
        lines.append("")
    legend = _legend(keys, model)
    widths = [max(len(each[i]) for each in legend) for i in range(3)]
    for each in legend:
        cells = (cell.ljust(width) for cell, width in zip(each, widths, strict=True))
        lines.append(f"  {'   '.join(cells)}".rstrip())
    return [
        *lines,
        "",
        f"  {keys.leave} ends manual mode. Keys held together move their joints together.",
    ]


def _sheet(keys: JogKeys, roles: dict[Key, str], model: ArmModel) -> Sheet:
    sheet = Sheet(900.0, 560.0)
    top = 500.0
    for number, (row, indent) in enumerate(zip(ROWS_OF_KEYS, INDENTS, strict=True)):
        x = 24.0 + indent * _SIZE / 4
        y = top - number * _SIZE
        for key in row:
            wide = _WIDE.get(key, 1.0) * _SIZE
            role = roles.get(key)
            sheet.box(
                x + 2,
                y - _SIZE + 4,
                wide - 4,
                _SIZE - 6,
                pen=Pen.FIRST if role else Pen.SOFT,
                fill=Fill.SHADE if role else Fill.PAPER,
                width=2.0 if role else 1.0,
            )
            cap = ARROWS.get(key, key.value if key is not Key.SPACE else "")
            cap = cap if len(cap) == 1 else cap.lower()
            if role:
                sheet.words((x + wide / 2, y - 17), cap, at="middle", bold=True, size=15.0)
                sheet.words((x + wide / 2, y - 37), role, at="middle", pen=Pen.FIRST, bold=True)
            else:
                size = 14.0 if len(cap) == 1 else 11.0
                sheet.words((x + wide / 2, y - 27), cap, at="middle", pen=Pen.SOFT, size=size)
            x += wide
    low = top - 5 * _SIZE - 34
    for number, (joint, plus, minus) in enumerate(_legend(keys, model)):
        y = low - number * 22
        sheet.words((30.0, y), joint, bold=True)
        sheet.words((210.0, y), plus)
        sheet.words((480.0, y), minus)
    sheet.words(
        (30.0, low - 6 * 22 - 6),
        f"{keys.leave} ends manual mode. Keys held together move their joints together.",
        pen=Pen.SOFT,
    )
    sheet.words((30.0, 530.0), "@SET: the keys that move the arm", bold=True, size=15.0)
    return sheet
