"""What there is to sense at one moment, for whatever answers on the input bits."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from trs80arm.arm.contact.bodies import Link as Placement
from trs80arm.arm.contact.pressing import pressing
from trs80arm.arm.forces import torques
from trs80arm.arm.geometry import forward
from trs80arm.arm.model import Link, LinkSolid
from trs80arm.arm.shapes import Vector, cross, plus
from trs80arm.arm.trigonometry import sin_cos

if TYPE_CHECKING:
    from trs80arm.arm.contact.manifold import Placed
    from trs80arm.arm.world import World


class Seen:
    """What there is to sense at one moment; each thing is worked out only if a sensor asks.

    It is the true state of arm and bench: nothing of registers, nor of what was commanded.

    Attributes:
        time: T-states.
        model: of the arm.
    """

    def __init__(self, world: World, time: int, pull: Vector | None = None) -> None:
        self.time = time
        self.model = world.model
        self._world = world
        self._pull = pull

    # What stands on the bench

    @cached_property
    def parts(self) -> list[Placed]:
        """The solids of all parts where they are."""
        return [solid for part in self._world.bench.parts.values() for solid in part.placed]

    @property
    def standing(self) -> Iterator[Placed]:
        """The solids of all that stands fast."""
        for thing in self._world.bench.scene.fixed.values():
            yield from thing.placed

    # Where the arm is

    @cached_property
    def segments(self) -> list[tuple[Vector, Vector]]:
        """Forearm, palm, roots of the fingers and fingers as lines."""
        return list(self._world.body.segments[1:])

    @cached_property
    def facing(self) -> tuple[Vector, Vector]:
        """The ways in which the arm's plane lies: ahead, and to its left."""
        s, c = sin_cos(self._world.angles.base)
        return (c, s, 0.0), (-s, c, 0.0)

    def solid(self, link: Link) -> LinkSolid:
        """The box that a link is."""
        return self.model.solids[self._number(link)]

    def place(self, link: Link) -> Vector:
        """Where the frame of a link begins, inches."""
        return self._links[self._number(link)].place

    def frame(self, link: Link) -> tuple[Vector, Vector, Vector]:
        """The axes of a link's frame: along it, across to its left, and up."""
        a, b, c, d, e, f, g, h, i = self._links[self._number(link)].turn
        return (a, d, g), (b, e, h), (c, f, i)

    def _number(self, link: Link) -> int:
        return next(n for n, solid in enumerate(self.model.solids) if solid.link is link)

    @cached_property
    def _links(self) -> Sequence[Placement]:
        world = self._world
        linkage = world.bench.scene.driven.linkage
        assert linkage is not None
        return linkage.links([*world.angles.driven, world.grip.opening])

    # What presses

    @property
    def grip_force(self) -> float:
        """Ounces with which the hand's cable pulls the fingers together."""
        return 16 * self._world.grip.force

    @property
    def squeeze(self) -> float:
        """Ounces with which both fingers press on something rigid between them."""
        grip = self._world.grip
        return 16 * max(0, grip.contact - grip.cable) / self.model.hand.pound_steps

    def pushes(self, link: Link) -> list[tuple[Vector, float]]:
        """What presses on a link, but for what the hand grips: which way it pushes, and ounces."""
        return pressing(self._world.bench.scene, self._number(link))

    @cached_property
    def strains(self) -> list[float]:
        """What strains the cables of the five joints beyond the arm's own weight, ounce-inches."""
        world, angles = self._world, self._world.angles
        total = list(world.torques[:5])
        points = forward(self.model, angles)
        tip, along, across = points.fingertip, points.pointing, points.across
        axes = (along, across, cross(along, across))
        forces = [(tip, self._pull)] if self._pull is not None else []
        for burden in world.burdens():
            place = tip
            for axis, by in zip(axes, burden.place, strict=True):
                place = plus(place, axis, by)
            forces.append((place, (0.0, 0.0, -burden.weight)))
        for place, force in forces:
            more = torques(self.model, angles, Link.HAND, place, force)
            total = [a + b for a, b in zip(total, more, strict=False)]
        return total
