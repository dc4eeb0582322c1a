"""What rests in the hand alone goes with the hand, for as long as the hand holds it as it does."""

from __future__ import annotations

import math
from collections.abc import Sequence

from trs80arm.arm.contact.bodies import Body, Link
from trs80arm.arm.contact.contacts import Contact
from trs80arm.arm.contact.driven import DrivenArm
from trs80arm.arm.contact.manifold import Placed
from trs80arm.arm.contact.meeting import sliding
from trs80arm.arm.contact.patch import CREEP
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
WIDEST = 100.0
"""More inches of cable than a hand can be tightened by."""
RESERVE = 1.3
"""How many times as hard as friction needs it a hand must press on what goes on resting in it."""
AREA = 3
"""Points on which something lies flat, at least."""
_DOWN: Vector = (0.0, 0.0, -1.0)


class Carrying:
    """How the hand holds what rests in it: carried along, or gripped where it stands.

    Attributes:
        gripped: names of what rests between the fingers and on something else too.
        openings: from where to where the hand can be commanded while what rests in it goes on doing
            so: squeezed harder friction only holds better, and less hard until its reserve is gone.
        flat: whether both fingers lie flat on something of it, and so cannot turn it, however hard
            they squeeze.
    """

    def __init__(self) -> None:
        self.gripped: list[str] = []
        self.openings: tuple[float, float] = (0.0, 0.0)
        self.flat = False
        self._down: Vector = _DOWN
        self._standing: list[float] = [0.0] * 5

    @property
    def found(self) -> tuple[tuple[float, float], bool, Vector, Sequence[float]]:
        """All that is known of how the hand holds, but for the names of what it grips."""
        return self.openings, self.flat, self._down, tuple(self._standing)

    @found.setter
    def found(self, found: tuple[tuple[float, float], bool, Vector, Sequence[float]]) -> None:
        self.openings, self.flat, self._down, standing = found
        self._standing = list(standing)

    def hold(self, arm: DrivenArm, contacts: Sequence[Contact], names: Sequence[str]) -> None:
        """Take note of how the fingers hold something.

        Args:
            arm: whose hand it is.
            contacts: as solved.
            names: of what rests there.
        """
        assert arm.linkage is not None
        force, needed = arm.torques[5], 0.0
        fingers = arm.fingers
        flat: set[str] = set()
        for contact in contacts:
            one, other, _ = contact.key
            if one in fingers and other in names:
                if sum(pressure > 0 for pressure in contact.pressures) >= AREA:
                    flat.add(one)
                # Friction that holds creeps in proportion to what it holds.
                needed = max(needed, sliding(contact) / CREEP)
        self.flat = flat.issuperset(fingers)
        spare = force * max(0.0, 1 - RESERVE * needed)
        commanded = arm.commands[5]
        self.openings = commanded - WIDEST, commanded + spare / arm.linkage.stiffness[5]

    def take(self, body: Body, hand: Link) -> None:
        """Have a body rest in the hand from now on, and go with it."""
        place = apply_back(hand.turn, minus(body.place, hand.place))
        body.carried = place, times(transposed(hand.turn), matrix(body.turn))
        self._down = apply_back(hand.turn, _DOWN)

    def grip(self, names: Sequence[str], commands: Sequence[float]) -> None:
        """Have bodies rest between the fingers, for as long as the arm stands.

        Args:
            names: of them.
            commands: where the motors want the arm.
        """
        self.gripped = list(names)
        self._standing = list(commands[:5])

    def goes_on(self, commands: Sequence[float]) -> bool:
        """Whether what is gripped goes on resting where it is with the arm commanded there."""
        low, high = self.openings
        return list(commands[:5]) == self._standing and low <= commands[5] <= high

    def upright_in(self, hand: Link) -> bool:
        """Whether a load goes on resting in a hand turned like that: as against the vertical."""
        return dot(apply_back(hand.turn, _DOWN), self._down) >= TILT

    def tilt_left(self, hand: Link) -> float:
        """Radians by which a hand turned like that may turn further, at least."""
        now = max(-1.0, min(1.0, dot(apply_back(hand.turn, _DOWN), self._down)))
        return math.acos(TILT) - math.acos(now) - 1e-6


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
