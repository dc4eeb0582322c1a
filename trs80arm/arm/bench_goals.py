"""The goals in a bench file, `[[goal]]`: what shall be where at the end.

The reference of the keys is in `docs/arm.md`.
"""

from __future__ import annotations

import re
from fnmatch import fnmatchcase, translate

from trs80arm.arm.bench import Bench
from trs80arm.arm.bench_forms import FAR
from trs80arm.arm.goals import FALLEN, THE_TABLE, UPRIGHT, Goal, PartGoal, Place, TrayGoal
from trs80arm.plain_values import SettingsError, Table

MOST_PLACES = 100
PART_KEYS = "part, at, tolerance, area, turn, turn_tolerance, posture, on"
TRAY_KEYS = "tray, count"


def read_goal(bench: Bench, item: Table) -> Goal:
    """One `[[goal]]`; all that the bench has is on it.

    Raises:
        SettingsError: one line, if it cannot be.
    """
    if "tray" in item.data:
        goal: Goal = TrayGoal(_tray(bench, item), item.integer("count", 1, 1_000_000))
        item.done(TRAY_KEYS)
        return goal
    part = item.text("part")
    if not _there_may_be(bench, part):
        raise item.fail("part", "the name of a part or a pattern as 'block *'; there is none such")
    places = _places(item)
    area = item.vector("area", 4, -FAR, FAR) if "area" in item.data else None
    if area is not None:
        if places:
            raise item.fail("area", "either at or area")
        if min(area[2:]) <= 0:
            raise item.fail("area", "x, y, width and depth, both more than 0")
    posture = item.data.pop("posture", "")
    if posture not in ("", UPRIGHT, FALLEN):
        raise item.fail("posture", f"{UPRIGHT} or {FALLEN}")
    turn = item.number("turn", -360, 360) if "turn" in item.data else None
    goal = PartGoal(
        part,
        places,
        item.number("tolerance", 0.001, FAR, PartGoal.tolerance),
        None if area is None else (area[0], area[1], area[2], area[3]),
        turn,
        item.number("turn_tolerance", 0.1, 180, PartGoal.turn_tolerance),
        posture,
        _on(bench, item),
    )
    item.done(PART_KEYS)
    if not (places or area or posture or goal.on) and turn is None:
        raise item.fail("part", "one of at, area, turn, posture and on beside it")
    return goal


def _places(item: Table) -> tuple[Place, ...]:
    """The key `at`: one place, or several."""
    if "at" not in item.data:
        return ()
    value = item.data.pop("at")
    several = value if isinstance(value, list) and value and isinstance(value[0], list) else [value]
    expected = f"a place [x, y] or [x, y, z], or up to {MOST_PLACES} of them in a list"
    if len(several) > MOST_PLACES:
        raise item.fail("at", expected)
    places = []
    for place in several:
        if not isinstance(place, list) or len(place) not in (2, 3):
            raise item.fail("at", expected)
        one = Table(item.source, item.path, {"at": place})
        try:
            places.append(one.vector("at", len(place), -FAR, FAR))
        except SettingsError:
            raise item.fail("at", f"{expected}; from {-FAR:g} to {FAR:g}") from None
    return tuple(places)


def _there_may_be(bench: Bench, pattern: str) -> bool:
    """Whether a part, or one that a feeder may give, can be called so."""
    if any(fnmatchcase(name, pattern) for name in bench.parts):
        return True
    for feeder in bench.feeders:
        # A feeder's parts are its name and a number.
        given = re.fullmatch(re.escape(feeder.name) + r" ([1-9]\d*)", pattern)
        if given and (feeder.count is None or int(given[1]) <= feeder.count):
            return True
        if re.match(translate(pattern), f"{feeder.name} 1"):
            return True
    return False


def _tray(bench: Bench, item: Table) -> str:
    name = item.text("tray")
    if all(tray.name != name for tray in bench.trays):
        raise item.fail("tray", "the name of a tray of this bench")
    return name


def _on(bench: Bench, item: Table) -> str:
    """The key `on`."""
    if "on" not in item.data:
        return ""
    name = item.text("on")
    things = {THE_TABLE, *bench.parts, *(obstacle.name for obstacle in bench.obstacles)}
    if name not in things:
        raise item.fail("on", f"the name of a part, an obstacle or {THE_TABLE!r}")
    return name
