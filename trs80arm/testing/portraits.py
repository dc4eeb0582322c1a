"""A rig as one readable text, for snapshots that are reviewed as diffs.

One fact a line, so that a diff shows what changed on the table and nothing else. Virtual times are
left out: a REM more in a program is no other behaviour of the arm.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import acos, atan2, degrees
from typing import Any

from trs80arm.drawing.canvas_ascii import AsciiCanvas
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import text_of
from trs80arm.drawing.side_scene import side_scene
from trs80arm.drawing.viewport import Viewport, draw
from trs80arm.report import report
from trs80arm.rig import Rig

SIDE_VIEW = "side view"
"""The title of the last section."""
_WIDTH, _HEIGHT = 72, 24
"""Cells of the side view."""
_ROOM = (0.0, 0.0, 15.0, 15.0)
"""Inches forward and up that the side view has in any case, so that two of them are of one scale
and a diff shows what moved."""


def portrait(rig: Rig) -> str:
    """Screen, registers beside joints, pose, hand, parts, slips and the side view.

    Lengths in inches, angles in degrees, registers and joints in half-steps, forces in pounds.
    """
    told = report(rig)
    sections = [
        ("screen", [f"|{line}".rstrip() for line in _without_blank_end(told["screen"])]),
        ("motors                register     joint     apart", list(motor_lines(rig))),
        ("pose", [f"{name:<10}{_fixed(value, 3)}" for name, value in told["pose"].items()]),
        ("hand", list(_hand(told["grip"]))),
        ("parts                        x        y        z     turn     tilt", list(_parts(rig))),
        ("devices", [f"{each['name']}: {each['does']}" for each in told["devices"]]),
        ("slips", [_slip(slip) for slip in told["slips"]] or ["none"]),
        ("score", rig.score().text().splitlines() if told["score"] is not None else []),
        (SIDE_VIEW, side_view(rig)),
    ]
    lines = [f"{told['arm']}, bench {told['bench'] or '(none)'}"]
    for title, rows in sections:
        if rows:
            lines += ["", title, *(f"  {row}".rstrip() for row in rows)]
    return "\n".join(lines) + "\n"


def side_view(rig: Rig) -> list[str]:
    """The arm from the side in bare lines."""
    scene, canvas = side_scene(Readings.of(rig)), AsciiCanvas(_WIDTH, _HEIGHT)
    draw(scene, Viewport(_ROOM).window(scene, _WIDTH, _HEIGHT), canvas)
    return [text_of(row).rstrip() for row in canvas.rows()]


def motor_lines(rig: Rig) -> Iterator[str]:
    """A line for each motor: what its register says, where its joint is, and what is between."""
    rows = zip(rig.joint_names, rig.registers, rig.joints, strict=True)
    for number, (name, register, joint) in enumerate(rows, 1):
        yield f"J{number} {name:<14}{register:>10}{joint:>10}{register - joint:>10}"


def _hand(grip: dict[str, Any]) -> Iterator[str]:
    yield f"holds     {grip['held'] or 'nothing'}"
    yield f"force     {_fixed(grip['force'], 2)}"
    yield f"switch    {'closed' if grip['switch'] else 'open'}"


def _parts(rig: Rig) -> Iterator[str]:
    for name, part in rig.parts.items():
        box = part.box
        (along_x, along_y, _), upwards = box.axes[0], box.axes[2][2]
        turn = degrees(atan2(along_y, along_x))
        tilt = degrees(acos(min(1.0, max(-1.0, upwards))))
        places = "".join(f"{_fixed(value, 3):>9}" for value in box.center)
        turns = f"{_fixed(turn, 1):>9}{_fixed(tilt, 1):>9}"
        yield f"{name:<20}{places}{turns}{'  held' if part.held else ''}"


def _slip(slip: dict[str, Any]) -> str:
    times = f" ({slip['count']} times)" if slip["count"] > 1 else ""
    return f"{slip['text']}{times}"


def _fixed(value: float, digits: int) -> str:
    """A number with so many decimals; what rounds to nothing is 0 and not -0."""
    return f"{round(value, digits) + 0.0:.{digits}f}"


def _without_blank_end(lines: list[str]) -> list[str]:
    """The lines up to the last that has anything on it."""
    end = max((number for number, line in enumerate(lines, 1) if line), default=0)
    return lines[:end]
