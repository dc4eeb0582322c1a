"""The keys of the TeachMover's teach pendant, as its computer sees them."""

from __future__ import annotations

from enum import Enum, IntEnum


class FunctionKey(IntEnum):
    """The function keys, with the codes that `@READ` has for them (TeachMover-Python)."""

    TRAIN = 1
    PAUSE = 2
    GRIP = 3
    OUT = 4
    FREE = 5
    MOVE = 6
    STOP = 7
    STEP = 8
    POINT = 9
    JUMP = 10
    CLEAR = 11
    ZERO = 12
    SPEED = 13
    RUN = 14


class JointKey(Enum):
    """The pairs that move the arm: base, shoulder, elbow, pitch, roll and grip.

    The value is what a tick with the key down adds to J1 to J6. Which way + is, is chosen: base to
    the left, shoulder, elbow and pitch up, roll as the left wrist gear counts, the hand open.
    """

    BASE_PLUS = (1, 0, 0, 0, 0, 0)
    BASE_MINUS = (-1, 0, 0, 0, 0, 0)
    SHOULDER_PLUS = (0, -1, 0, 0, 0, 0)
    SHOULDER_MINUS = (0, 1, 0, 0, 0, 0)
    ELBOW_PLUS = (0, 0, -1, 0, 0, 0)
    ELBOW_MINUS = (0, 0, 1, 0, 0, 0)
    PITCH_PLUS = (0, 0, 0, -1, -1, 0)
    PITCH_MINUS = (0, 0, 0, 1, 1, 0)
    ROLL_PLUS = (0, 0, 0, -1, 1, 0)
    ROLL_MINUS = (0, 0, 0, 1, -1, 0)
    GRIP_PLUS = (0, 0, 0, 0, 0, 1)
    GRIP_MINUS = (0, 0, 0, 0, 0, -1)


PendantKey = FunctionKey | JointKey


def key_named(name: str) -> PendantKey:
    """The key of a name, as `STOP` or `BASE_PLUS`.

    Raises:
        ValueError: the pendant has no such key.
    """
    for keys in (FunctionKey, JointKey):
        if name in keys.__members__:
            return keys[name]
    raise ValueError(f"the pendant has no key {name!r}")


def directions(held: frozenset[JointKey] | set[JointKey]) -> tuple[int, ...]:
    """Which way each motor goes while keys are held: 1, -1 or 0; no motor steps twice a tick."""
    sums = [sum(column) for column in zip(*(key.value for key in held), strict=True)] or [0] * 6
    return tuple((total > 0) - (total < 0) for total in sums)
