"""Where everything stands in a terminal of a given size: a pure function from size to regions.

Panels stand in groups, and what is switched under the tube is a group. Three arrangements: all
panels (from 116 x 36), tube with registers and a switched group (from 78 columns), tube with a
switched group. Below 64 x 18 there is room for a message only.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

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


TUBE, ARM, NUMBERS, MOTORS, LOG, KEYBOARD = "tube", "arm", "numbers", "motors", "log", "keyboard"
"""The groups that have places of their own where there is room for all; any other one is switched
in at the keyboard's place."""
IN_PLACE = (TUBE, NUMBERS, MOTORS, LOG)

Groups = Mapping[str, Sequence[str]]
"""The ids of the panels of each group, in order."""


def shows_everything(width: int, height: int) -> bool:
    """Whether there is room for all panels at once."""
    return width >= EVERYTHING[0] and height >= EVERYTHING[1]


def bottoms(groups: Groups, width: int, height: int) -> list[str]:
    """The groups that can be shown under the tube, in order; the first is what it begins with."""
    if shows_everything(width, height):
        return [group for group in groups if group not in IN_PLACE]
    beside = (TUBE,) if width < COLUMNS + SIDE_COLUMN else (TUBE, NUMBERS)
    return [group for group in groups if group not in beside]


def plan(groups: Groups, width: int, height: int, bottom: str, zoomed: str | None = None) -> Plan:
    """The regions of the panels.

    Args:
        groups: what there is to be shown.
        width: columns of the terminal.
        height: rows of the terminal.
        bottom: the group that is shown under the tube.
        zoomed: a panel or a group that has the whole room, or None.
    """
    if width < SMALLEST[0] or height < SMALLEST[1]:
        return {}
    body = height - FURNITURE
    if zoomed is not None:
        return _abreast(groups, zoomed, Region(0, 0, width, body))
    if shows_everything(width, height):
        return _everything(groups, width, body, bottom)
    return _switched(groups, width, body, bottom)


def _abreast(groups: Groups, name: str, room: Region) -> Plan:
    """The panels of a group, or one panel, side by side; the arm from the side has most of it."""
    panels = groups.get(name, (name,))
    edges = [room.width * number // len(panels) for number in range(len(panels) + 1)]
    if name == ARM:
        edges[1] = room.width * 3 // 5
    return {
        panel: Region(room.x + left, room.y, right - left, room.height)
        for panel, left, right in zip(panels, edges, edges[1:], strict=False)
    }


def _stacked(panels: Sequence[str], room: Region, first: int) -> Plan:
    """Two panels, the first so many rows high, the other below it."""
    upper, lower = panels
    return {
        upper: Region(room.x, room.y, room.width, first),
        lower: Region(room.x, room.y + first, room.width, room.height - first),
    }


def _everything(groups: Groups, width: int, body: int, bottom: str) -> Plan:
    tube = Region(0, 0, COLUMNS + _FRAME, ROWS + _FRAME)
    rest = body - tube.height
    third = width * 38 // 120
    right = width - 2 * third
    side, top = groups[ARM]
    [coils], [events] = groups[MOTORS], groups[LOG]
    lower = tube.height + _NUMBERS
    regions = {groups[TUBE][0]: tube, side: Region(tube.right, 0, width - tube.width, tube.height)}
    regions |= _stacked(groups[NUMBERS], Region(0, tube.height, third, rest), _NUMBERS)
    regions[coils] = Region(third, tube.height, third, _NUMBERS)
    if bottom == ARM:
        regions[top] = Region(2 * third, tube.height, right, rest)
        regions[events] = Region(third, lower, third, rest - _NUMBERS)
    else:
        regions[top] = Region(2 * third, tube.height, right, _NUMBERS)
        room = Region(third, lower, width - third, rest - _NUMBERS)
        regions |= _abreast(groups, bottom, room)
    return regions


def _switched(groups: Groups, width: int, body: int, bottom: str) -> Plan:
    regions = {groups[TUBE][0]: Region(0, 0, COLUMNS, ROWS)}
    beside = width - COLUMNS
    if beside >= SIDE_COLUMN:
        room = Region(COLUMNS, 0, beside, ROWS)
        regions |= _stacked(groups[NUMBERS], room, _NUMBERS - 1)
    room = Region(0, ROWS, width, body - ROWS)
    if room.height < SHORTEST_BOTTOM:
        return regions
    shown = ARM if beside >= SIDE_COLUMN and bottom == NUMBERS else bottom
    return regions | _abreast(groups, shown, room)
