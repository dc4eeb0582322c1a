"""What the TeachMover's pendant shows, in words: its mode, what it asks for, the program."""

from __future__ import annotations

from trs80arm.serial.controller import Controller
from trs80arm.serial.instructions import told
from trs80arm.serial.memory import STEPS, number_of
from trs80arm.serial.pendant import PendantMode

FIRST = "TRAIN or MOVE first: then the joint keys move the arm."
"""Said of a pendant whose joint keys do nothing yet."""


def state(base: Controller) -> str:
    """Mode, pointer, speed, and what the arm does, in a line."""
    pendant = base.pendant
    doing = f"   doing {base.doing}" if base.doing else ""
    at = pendant.pointer if pendant.pointer <= STEPS else "full"
    return f"Mode {pendant.mode.value.upper()}   Step {at}   SP {base.speed}{doing}"


def message(base: Controller) -> str:
    """What is asked for, with what is typed of it; or what there is to say of the last key."""
    pendant = base.pendant
    if pendant.asks is None:
        resting = pendant.mode is PendantMode.OFF and not base.busy
        return pendant.note or (FIRST if resting else "")
    taken = "".join(f" {number}" for number in pendant.numbers)
    typed = f" {pendant.digits}_" if pendant.digits else ""
    note = f"   {pendant.note}" if pendant.note else ""
    return f"{pendant.asks.name}{taken}: {pendant.wanted}{typed}{note}"


def program(base: Controller, rows: int) -> list[str]:
    """The steps in the memory, so many lines around the one at the pointer."""
    pointer = base.pendant.pointer
    lines: list[str] = []
    at = 0
    for row in base.memory:
        number = number_of(row)
        if number <= pointer:
            at = len(lines)
        lines.append(f"{'>' if number == pointer else ' '}{number:2} {told(row)}")
    if pointer <= STEPS and base.memory.read(pointer) is None:
        at = min(len(lines), at + 1)
        lines.insert(at, f">{pointer:2}")
    begin = max(0, min(at - rows // 2, len(lines) - rows))
    return lines[begin : begin + rows]
