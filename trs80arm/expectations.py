"""What a run came to, held against what its script expects: a line for each thing that differs."""

from __future__ import annotations

from collections.abc import Iterator
from math import dist
from typing import Any

from trs80arm.script import Expected, Place


def unmet(expected: Expected, told: dict[str, Any]) -> list[str]:
    """What is not as it was expected.

    Args:
        expected: by the script.
        told: the run, as `trs80arm run --json` tells it.

    Returns:
        One line for each, in words; empty where all is met.
    """
    return list(_unmet(expected, told))


def _unmet(expected: Expected, told: dict[str, Any]) -> Iterator[str]:
    ended = told["ended"]
    for key, name in (("how", "ended"), ("line", "line"), ("error", "error")):
        wanted = getattr(expected, name)
        if wanted is not None and ended[key] != wanted:
            yield f"{name}: expected {wanted}, not {_ending(ended)}"
    yield from _texts("output", expected.output, told["output"], in_order=True)
    yield from _texts("screen", expected.screen, "\n".join(told["screen"]), in_order=False)
    for name in ("registers", "joints"):
        wanted = getattr(expected, name)
        if wanted is not None and list(wanted) != told[name]:
            yield f"{name}: expected {_numbers(wanted)}, not {_numbers(told[name])}"
    slips = told["slips"]
    if expected.most_slips is not None and len(slips) > expected.most_slips:
        yield f"slips: expected at most {expected.most_slips}, not {len(slips)}; {slips[0]['text']}"
    if expected.goals is not None:
        yield from _goals(expected.goals, told["score"])
    if expected.pose is not None:
        pose = told["pose"]
        yield from _place(expected.pose, [pose["x"], pose["y"], pose["z"]])
    parts = {part["name"]: part for part in told["parts"]}
    for place in expected.parts:
        part = parts.get(place.name)
        if part is None:
            yield f"{place.name}: there is no part of that name on the bench"
            continue
        yield from _place(place, part["at"])
        if place.held is not None and place.held != part["held"]:
            yield f"{place.name}: expected {'' if place.held else 'not '}to be held"


def _ending(ended: dict[str, Any]) -> str:
    error = f" ?{ended['error']}" if ended["error"] else ""
    line = f" in {ended['line']}" if ended["line"] is not None else ""
    return f"{ended['how']}{error}{line}"


def _texts(name: str, wanted: tuple[str, ...], found: str, *, in_order: bool) -> Iterator[str]:
    start = 0
    for text in wanted:
        place = found.find(text, start)
        if place < 0:
            behind = " behind what was found before" if start else ""
            yield f"{name}: {text!r} is not there{behind}"
        elif in_order:
            start = place + len(text)


def _goals(wanted: bool, score: dict[str, Any] | None) -> Iterator[str]:
    if score is None:
        yield "goals: the bench has none"
    elif wanted != (score["met"] == score["total"]):
        yield f"goals: {score['met']} of {score['total']} are met"


def _place(place: Place, at: list[float]) -> Iterator[str]:
    away = dist(place.at, at)
    if away > place.within:
        yield (
            f"{place.name}: expected at {_numbers(place.at)} within {place.within:g} in, "
            f"not at {_numbers(at)}, {away:.3f} in away"
        )


def _numbers(values: Any) -> str:
    return " ".join(f"{value:.3f}".rstrip("0").rstrip(".") for value in values)
