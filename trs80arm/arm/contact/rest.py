"""Coming to rest: what hardly moves for a while falls asleep, with all that it leans on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from trs80arm.arm.contact.bodies import Body, Link
from trs80arm.arm.contact.bounds import greatest_speed
from trs80arm.arm.contact.contacts import Contact
from trs80arm.arm.contact.rotations import Matrix, apply_back, times, transposed
from trs80arm.arm.shapes import Vector, minus

STILL = 0.03
"""Speed of a body's outermost point below which it hardly moves, inches a second."""
AT_REST = 0.0015
"""Speed of it below which it does not move at all."""
SURE = 5
"""How many times as much a tick counts in which it does not."""
CALM_TICKS = 10
"""Ticks for which everything that leans on each other must be still to fall asleep."""


class Group(NamedTuple):
    """Bodies that lean on each other.

    Attributes:
        members: all awake.
        outside: names of what else they lean on.
    """

    members: list[Body]
    outside: set[str]


def leaning(contacts: Iterable[Contact]) -> dict[str, set[str]]:
    """Names of what presses on each thing."""
    found: dict[str, set[str]] = {}
    for contact in contacts:
        if contact.pressure > 0:
            one, other = contact.key[:2]
            found.setdefault(one, set()).add(other)
            found.setdefault(other, set()).add(one)
    return found


def groups(
    awake: Sequence[Body], bodies: Mapping[str, Body], leaning: Mapping[str, set[str]]
) -> list[Group]:
    """All that is awake, by what leans on each other."""
    seen: set[str] = set()
    return [
        _group(body, bodies, leaning, seen)
        for body in awake
        if body.name not in seen and not body.asleep
    ]


def _group(
    body: Body, bodies: Mapping[str, Body], leaning: Mapping[str, set[str]], seen: set[str]
) -> Group:
    members, outside, waiting = [], set(), [body.name]
    while waiting:
        name = waiting.pop()
        if name in seen:
            continue
        member = bodies.get(name)
        if member is None or member.asleep:
            outside.add(name)
            continue
        seen.add(name)
        members.append(member)
        waiting += sorted(leaning.get(name, ()))
    return Group(members, outside)


def calm(body: Body, hand: tuple[Link, Link] | None, seconds: float) -> int:
    """Whether a body hardly moves.

    Args:
        body: as it moved in the last step.
        hand: in which it lies, before the step and now, if it does: it may move with that.
        seconds: length of the step.

    Returns:
        How much a tick counts towards its rest: 0 where it moves.
    """
    velocity, spin = body.velocity, body.spin
    if hand is not None:
        then, now = hand
        here = apply_back(now.turn, minus(body.place, now.place))
        earlier = minus(minus(body.place, then.place), _scaled(velocity, seconds))
        velocity = _scaled(minus(here, apply_back(then.turn, earlier)), 1 / seconds)
        if now.turn != then.turn:
            spin = minus(spin, _spin(then.turn, now.turn, seconds))
    speed = greatest_speed([*velocity, *spin], body.shape.radius)
    return 0 if speed >= STILL else 1 if speed >= AT_REST else SURE


def _scaled(v: Vector, factor: float) -> Vector:
    return v[0] * factor, v[1] * factor, v[2] * factor


def _spin(before: Matrix, now: Matrix, seconds: float) -> Vector:
    """Radians a second at which a frame has turned in the last step."""
    m = times(now, transposed(before))
    half = 1 / (2 * seconds)
    return (m[7] - m[5]) * half, (m[2] - m[6]) * half, (m[3] - m[1]) * half
