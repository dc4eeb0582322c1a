"""Where everything stands in a terminal of a given size: a pure function from size to regions.

Panels stand in groups, and what is switched in at a key is a group. There is an arrangement for
each shape of window: all in columns (large, huge, wide), in one stack (tall), and two in which tube
and arm share the room, and the one that leads has most of it (compact, middle). Below 40 x 12 there
is room for a message only.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from enum import Enum
from itertools import accumulate, pairwise

from textual.geometry import Region

from trs80arm.machine.video import COLUMNS, ROWS

SMALLEST = (40, 12)
"""Columns and rows below which nothing but a message is shown."""
FURNITURE = 2
"""The status line and the footer."""
SIDE_COLUMN = 14
"""Columns beside the tube from which on registers fit there."""
SHORTEST_BOTTOM = 3
TUBE_LINES = 6
"""The least lines of the tube that are seen while the arm leads: the six registers stand beside."""
_FRAME = 2
_TUBE = COLUMNS + _FRAME
_TUBE_ROWS = ROWS + _FRAME
_NUMBERS = 10
"""Rows of a panel of six joints with its heading and frame."""
_POSE = 12
"""Rows of the pose in one column, with its frame."""
_POSE_WIDE = 34
"""Columns in which the pose has two columns, with its frame."""
_JOINTS = 36
"""Columns of a panel of six joints with their names, with its frame."""
_LISTING = 46
"""Columns of the listing where it has a column of its own."""

Plan = dict[str, Region]
"""The region of each panel that is shown, by the panel's id, from the top left of the screen."""


TUBE, ARM, NUMBERS, MOTORS, LOG, KEYBOARD = "tube", "arm", "numbers", "motors", "log", "keyboard"
LISTING, VARIABLES, PAPER = "listing", "variables", "paper"
SPACE, SCOPE = "space", "scope"
"""The groups that have places of their own where there is room; any other one is switched in."""
LARGE_ONES = (SPACE, SCOPE)
"""Pictures that say nothing in the few rows below a tube: asked for, they have the arm's room."""

Groups = Mapping[str, Sequence[str]]
"""The ids of the panels of each group, in order."""


class Lead(Enum):
    """What has most of the room, and the brightest frame."""

    TUBE = "tube"
    ARM = "arm"


class Frames(Enum):
    """What separates the panels."""

    RULED = "ruled"
    """A line to the left of each panel that does not stand at the edge."""
    TITLED = "titled"
    """A line with a title over each panel."""
    FULL = "framed"
    """A frame around each panel."""


class Arrangement(Enum):
    """The shapes of window that are laid out on purpose."""

    COMPACT = "compact"
    MIDDLE = "middle"
    LARGE = "large"
    TALL = "tall"
    WIDE = "wide"
    HUGE = "huge"


_IN_PLACE: dict[Arrangement, tuple[str, ...]] = {
    Arrangement.COMPACT: (TUBE,),
    Arrangement.MIDDLE: (TUBE, NUMBERS),
    Arrangement.LARGE: (TUBE, NUMBERS, MOTORS, LOG),
    Arrangement.TALL: (TUBE, NUMBERS),
    Arrangement.WIDE: (TUBE, NUMBERS, LOG),
    Arrangement.HUGE: (TUBE, NUMBERS, MOTORS, LOG, LISTING, VARIABLES, PAPER, SPACE, SCOPE),
}
"""The groups that are always seen, so that no key brings them."""


def arrangement(width: int, height: int) -> Arrangement:
    """The arrangement for a window."""
    if width >= 170 and height >= 48:
        return Arrangement.HUGE
    if width >= 116 and height >= 38:
        return Arrangement.LARGE
    if width >= 150:
        return Arrangement.WIDE
    if height >= 40:
        return Arrangement.TALL
    if width >= 100 and height >= 28:
        return Arrangement.MIDDLE
    return Arrangement.COMPACT


def shared(width: int, height: int) -> bool:
    """Whether tube and arm share the room of a window, so that one of them leads."""
    return arrangement(width, height) in (Arrangement.COMPACT, Arrangement.MIDDLE)


def frames(width: int, height: int) -> Frames:
    """What separates the panels in a window."""
    chosen = arrangement(width, height)
    if chosen is Arrangement.COMPACT:
        return Frames.RULED
    narrow = chosen is Arrangement.TALL and width < _TUBE
    return Frames.TITLED if narrow or height < _TUBE_ROWS + FURNITURE else Frames.FULL


def bottoms(groups: Groups, width: int, height: int) -> list[str]:
    """The groups that can be switched in, in order; the first is what it begins with."""
    chosen = arrangement(width, height)
    in_place = _IN_PLACE[chosen]
    if chosen is Arrangement.COMPACT and width >= COLUMNS + SIDE_COLUMN:
        in_place = (TUBE, NUMBERS)
    return [group for group in groups if group not in in_place]


def plan(
    groups: Groups,
    width: int,
    height: int,
    bottom: str,
    zoomed: str | None = None,
    lead: Lead = Lead.TUBE,
) -> Plan:
    """The regions of the panels, their frames included.

    Args:
        groups: what there is to be shown.
        width: columns of the terminal.
        height: rows of the terminal.
        bottom: the group that is switched in.
        zoomed: a panel or a group that has the whole room, or None.
        lead: what has most of the room where tube and arm share it.
    """
    if width < SMALLEST[0] or height < SMALLEST[1]:
        return {}
    room = Region(0, 0, width, height - FURNITURE)
    if zoomed is not None:
        return _abreast(groups, zoomed, room)
    match arrangement(width, height):
        case Arrangement.COMPACT:
            return _compact(groups, room, bottom, lead)
        case Arrangement.MIDDLE:
            return _middle(groups, room, bottom, lead)
        case Arrangement.LARGE:
            return _large(groups, room, bottom)
        case Arrangement.TALL:
            return _tall(groups, room, bottom)
        case Arrangement.WIDE:
            return _wide(groups, room, bottom)
        case Arrangement.HUGE:
            return _huge(groups, room, bottom)


# -- dividing a room -------------------------------------------------------------------------------


def _columns(room: Region, *widths: int) -> list[Region]:
    """The room in columns of these widths; the last one has the rest."""
    return [
        Region(room.x + left, room.y, right - left, room.height)
        for left, right in pairwise(_edges(room.width, widths))
    ]


def _rows(room: Region, *heights: int) -> list[Region]:
    """The room in rows of these heights; the last one has the rest."""
    return [
        Region(room.x, room.y + upper, room.width, lower - upper)
        for upper, lower in pairwise(_edges(room.height, heights))
    ]


def _edges(whole: int, parts: Iterable[int]) -> list[int]:
    """Where parts of these lengths begin, and where the rest of the whole does, and ends."""
    return [*(min(whole, edge) for edge in accumulate(parts, initial=0)), whole]


def _placed(groups: Groups, places: Iterable[tuple[str, Region]]) -> Plan:
    """Groups of one panel in their places; those that there are none of are left out."""
    return {groups[group][0]: region for group, region in places if group in groups}


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
    return dict(zip(panels, _rows(room, first), strict=True))


# -- tube and arm share the room -------------------------------------------------------------------


def _compact(groups: Groups, room: Region, bottom: str, lead: Lead) -> Plan:
    tube_width = min(COLUMNS, room.width)
    beside = room.width - tube_width
    with_numbers = beside >= SIDE_COLUMN
    if lead is Lead.ARM and bottom in (ARM, *LARGE_ONES):
        lines = max(TUBE_LINES, room.height // 3)
        upper, lower = _rows(room, room.height - lines)
        tube, rest = _columns(lower, tube_width)
        regions = _placed(groups, [(TUBE, tube)]) | _abreast(groups, bottom, upper)
        return regions | ({groups[NUMBERS][0]: rest} if with_numbers else {})
    upper, lower = _rows(room, min(ROWS, room.height))
    tube, rest = _columns(upper, tube_width)
    regions = _placed(groups, [(TUBE, tube)])
    if with_numbers:
        regions |= _stacked(groups[NUMBERS], rest, _NUMBERS - 1)
    if lower.height < SHORTEST_BOTTOM:
        return regions
    shown = ARM if with_numbers and bottom == NUMBERS else bottom
    return regions | _abreast(groups, shown, lower)


def _middle(groups: Groups, room: Region, bottom: str, lead: Lead) -> Plan:
    left, right = _columns(room, _TUBE)
    side, top = groups[ARM]
    upper, lower = _rows(right, right.height - 2 * _NUMBERS + 3)
    regions = {top: upper} | _stacked(groups[NUMBERS], lower, _NUMBERS - 1)
    leads = lead is Lead.ARM and bottom in (ARM, *LARGE_ONES)
    first, second = _rows(left, left.height - TUBE_LINES - _FRAME if leads else _TUBE_ROWS)
    tube, other = (second, first) if leads else (first, second)
    regions |= _placed(groups, [(TUBE, tube)])
    return regions | ({side: other} if bottom == ARM else _abreast(groups, bottom, other))


# -- room for all ----------------------------------------------------------------------------------


def _numbers_and_motors(groups: Groups, room: Region, last: str) -> Plan:
    """Registers and coils, and beside them the pose and one more panel, 18 rows or more."""
    registers, pose = groups[NUMBERS]
    left, right = _columns(room, _JOINTS)
    first = min(room.height // 2, room.height - _NUMBERS)
    regions = _stacked((registers, groups[MOTORS][0]), left, first)
    if last not in groups:
        return regions | {pose: right}
    return regions | _stacked((pose, groups[last][0]), right, _POSE)


def _large(groups: Groups, room: Region, bottom: str) -> Plan:
    left, right = _columns(room, _TUBE)
    tube, lower = _rows(left, _TUBE_ROWS)
    regions = _placed(groups, [(TUBE, tube)])
    regions |= _stacked(groups[ARM], right, room.height * 3 // 5)
    if bottom == ARM:
        return regions | _numbers_and_motors(groups, lower, LOG)
    if bottom in LARGE_ONES:
        return regions | _abreast(groups, bottom, lower)
    numbers, rest = _rows(lower, _NUMBERS)
    sides = _columns(numbers, numbers.width - _POSE_WIDE)
    regions |= dict(zip(groups[NUMBERS], sides, strict=True))
    return regions | _abreast(groups, bottom, rest)


def _huge(groups: Groups, room: Region, bottom: str) -> Plan:
    left, middle, right = _columns(room, _TUBE, room.width - _TUBE - _LISTING)
    tube, block, corner = _rows(left, _TUBE_ROWS, 2 * _NUMBERS)
    listing, variables = _rows(right, right.height * 3 // 5)
    regions = _numbers_and_motors(groups, block, PAPER)
    lowest = SCOPE if bottom == ARM else bottom
    upper, lower = _rows(middle, middle.height * 3 // 4 if lowest in groups else middle.height)
    if lowest in groups:
        regions |= _abreast(groups, lowest, lower)
    side, top = groups[ARM]
    first, second = _rows(upper, upper.height * 2 // 3)
    log = corner
    if SPACE in groups:
        # A picture has the corner, and a log the few rows that say nothing of a picture.
        second, log = _columns(second, second.width // 2)
        regions |= _placed(groups, [(SPACE, corner)])
    return (
        regions
        | {side: first, top: second}
        | _placed(groups, [(TUBE, tube), (LOG, log), (LISTING, listing), (VARIABLES, variables)])
    )


def _wide(groups: Groups, room: Region, bottom: str) -> Plan:
    left, numbers, right = _columns(room, _TUBE, _JOINTS)
    tube, log = _rows(left, min(_TUBE_ROWS, room.height))
    regions = _placed(groups, [(TUBE, tube)])
    if log.height >= SHORTEST_BOTTOM:
        regions |= _placed(groups, [(LOG, log)])
    regions |= _stacked(groups[NUMBERS], numbers, min(_NUMBERS, room.height // 2))
    if bottom == ARM:
        return regions | _abreast(groups, ARM, right)
    side, _ = groups[ARM]
    first, second = _columns(right, right.width // 2)
    return regions | {side: first} | _abreast(groups, bottom, second)


def _tall(groups: Groups, room: Region, bottom: str) -> Plan:
    framed = room.width >= _TUBE
    tube_rows = _TUBE_ROWS if framed else ROWS + 1
    first, rest = _rows(room, tube_rows)
    side, top = groups[ARM]
    tube, beside = _columns(first, min(_TUBE, room.width))
    regions = _placed(groups, [(TUBE, tube)])
    if beside.width >= SIDE_COLUMN + _FRAME:
        regions |= _stacked(groups[NUMBERS], beside, _NUMBERS - 1)
        arms, lowest = _rows(rest, rest.height * 4 // 5)
        shown = LOG if bottom == ARM else bottom
    else:
        arms, lowest = _rows(rest, rest.height - _NUMBERS - 1)
        shown = NUMBERS if bottom == ARM else bottom
    regions |= _stacked((side, top), arms, arms.height * 3 // 5)
    return regions | _abreast(groups, shown, lowest)
