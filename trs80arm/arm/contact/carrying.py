"""What rests in the hand alone goes with the hand, for as long as the hand holds it as it does."""

from __future__ import annotations

import math

from trs80arm.arm.contact.bodies import Body, Link
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.rotations import (
    apply,
    apply_back,
    matrix,
    quaternion,
    times,
    transposed,
)
from trs80arm.arm.shapes import Vector, dot, minus, plus

TILT = 0.9962
"""Cosine of the turn of the hand, against the vertical, at which what it carries is looked at
again: five degrees."""
LOOSER, TIGHTER = 1e-9, 0.015
"""Inches of cable by which a hand may let up or tighten before its load is looked at again."""
_DOWN: Vector = (0.0, 0.0, -1.0)


class Carrying:
    """How the hand held what rests in it when that came to rest."""

    def __init__(self) -> None:
        self._down: Vector = _DOWN
        self._opening = 0.0

    def take(self, body: Body, hand: Link, opening: float) -> None:
        """Have a body rest in the hand from now on.

        Args:
            body: that does.
            hand: where it stands.
            opening: to which the hand is commanded.
        """
        place = apply_back(hand.turn, minus(body.place, hand.place))
        body.carried = place, times(transposed(hand.turn), matrix(body.turn))
        self._down = apply_back(hand.turn, _DOWN)
        self._opening = opening

    @property
    def openings(self) -> tuple[float, float]:
        """From where to where the hand can be commanded while what rests in it goes on doing so."""
        return self._opening - TIGHTER, self._opening + LOOSER

    def upright_in(self, hand: Link) -> bool:
        """Whether it does with the hand turned like that: not much against the vertical."""
        return dot(apply_back(hand.turn, _DOWN), self._down) >= TILT

    def tilt_left(self, hand: Link) -> float:
        """Radians by which a hand turned like that may turn further, at least."""
        now = max(-1.0, min(1.0, dot(apply_back(hand.turn, _DOWN), self._down)))
        return math.acos(TILT) - math.acos(now)


def carry(body: Body, hand: Link) -> None:
    """Take along what rests in the hand."""
    assert body.carried is not None
    place, turn = body.carried
    body.put(plus(hand.place, apply(hand.turn, place)), quaternion(times(hand.turn, turn)))


def load_at(load: Body, hand: Link) -> list[Placed]:
    """Where the solids of something carried would be with the hand elsewhere."""
    assert load.carried is not None
    place, turn = load.carried
    at, turned_to = plus(hand.place, apply(hand.turn, place)), times(hand.turn, turn)
    return [Placed(solid, at, turned_to) for solid in load.shape.solids]
