"""Where everything stands in a terminal of a given size: a pure function from size to regions.

Three arrangements: all panels (from 116 x 36), tube with registers and a switched bottom panel
(from 78 columns), tube with a switched bottom panel. Below 64 x 18 there is room for a message
only.
"""

from __future__ import annotations

from enum import Enum

from textual.geometry import Region

from trs80arm.machine.video import COLUMNS, ROWS

SMALLEST = (COLUMNS, ROWS + 2)
"""Columns and rows below which nothing but a message is shown."""
FURNITURE = 2
"""The status line and the footer."""
EVERYTHING = (116, 36)
SIDE_COLUMN = 14
"""Columns beside the tube from which on registers fit there."""
SHORTEST_BOTTOM = 3
_FRAME = 2
_NUMBERS = 10
"""Rows of a panel of six joints with its heading and title."""

Plan = dict[str, Region]
"""The region of each panel that is shown, by the panel's id, from the top left of the screen."""


class Bottom(Enum):
    """What the switched panel under the tube shows."""

    ARM = "arm"
    MOTORS = "motors"
    LOG = "log"
    NUMBERS = "numbers"
    KEYBOARD = "keyboard"


def shows_everything(width: int, height: int) -> bool:
    """Whether there is room for all panels at once."""
    return width >= EVERYTHING[0] and height >= EVERYTHING[1]


def bottoms(width: int, height: int) -> list[Bottom]:
    """What the bottom panel can be switched to, in order; the first is what it begins with."""
    if shows_everything(width, height):
        return [Bottom.ARM, Bottom.KEYBOARD]
    choices = [Bottom.ARM, Bottom.MOTORS, Bottom.LOG, Bottom.KEYBOARD]
    if width < COLUMNS + SIDE_COLUMN:
        choices.insert(1, Bottom.NUMBERS)
    return choices


def plan(width: int, height: int, bottom: Bottom, zoomed: str | None = None) -> Plan:
    """The regions of the panels.

    Args:
        width: columns of the terminal.
        height: rows of the terminal.
        bottom: what the switched panel shows.
        zoomed: the id of a panel that has the whole room, `arm` for side and top view, or None.
    """
    if width < SMALLEST[0] or height < SMALLEST[1]:
        return {}
    body = height - FURNITURE
    if zoomed == "arm":
        return _arm(Region(0, 0, width, body))
    if zoomed is not None:
        return {zoomed: Region(0, 0, width, body)}
    if shows_everything(width, height):
        return _everything(width, body, bottom)
    return _switched(width, body, bottom)


def _arm(room: Region) -> Plan:
    left = room.width * 3 // 5
    return {
        "side": Region(room.x, room.y, left, room.height),
        "top": Region(room.x + left, room.y, room.width - left, room.height),
    }


def _everything(width: int, body: int, bottom: Bottom) -> Plan:
    tube = Region(0, 0, COLUMNS + _FRAME, ROWS + _FRAME)
    rest = body - tube.height
    third = width * 38 // 120
    right = width - 2 * third
    regions = {
        "tube": tube,
        "side": Region(tube.right, 0, width - tube.width, tube.height),
        "registers": Region(0, tube.height, third, _NUMBERS),
        "pose": Region(0, tube.height + _NUMBERS, third, rest - _NUMBERS),
        "coils": Region(third, tube.height, third, _NUMBERS),
    }
    if bottom is Bottom.KEYBOARD:
        regions["top"] = Region(2 * third, tube.height, right, _NUMBERS)
        regions["matrix"] = Region(third, tube.height + _NUMBERS, width - third, rest - _NUMBERS)
    else:
        regions["top"] = Region(2 * third, tube.height, right, rest)
        regions["events"] = Region(third, tube.height + _NUMBERS, third, rest - _NUMBERS)
    return regions


def _switched(width: int, body: int, bottom: Bottom) -> Plan:
    regions = {"tube": Region(0, 0, COLUMNS, ROWS)}
    beside = width - COLUMNS
    if beside >= SIDE_COLUMN:
        numbers = _NUMBERS - 1
        regions["registers"] = Region(COLUMNS, 0, beside, numbers)
        regions["pose"] = Region(COLUMNS, numbers, beside, ROWS - numbers)
    room = Region(0, ROWS, width, body - ROWS)
    if room.height < SHORTEST_BOTTOM:
        return regions
    half = room.width // 2
    left = Region(0, ROWS, half, room.height)
    right = Region(half, ROWS, room.width - half, room.height)
    if bottom is Bottom.ARM:
        regions |= _arm(room)
    elif bottom is Bottom.MOTORS:
        regions["coils"] = room
    elif bottom is Bottom.LOG:
        regions["events"] = room
    elif bottom is Bottom.KEYBOARD:
        regions["matrix"] = room
    elif beside < SIDE_COLUMN:
        regions |= {"registers": left, "pose": right}
    else:
        regions |= _arm(room)
    return regions
