"""What is remembered of forces: those of the last step, from which the solver sets out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from trs80arm.arm.contact.bodies import Body
from trs80arm.arm.contact.contacts import Contact, Key
from trs80arm.arm.shapes import Vector

Pressures = list[tuple[Vector, float]]
"""Where two things press on each other, in the frame of the second if that is a body, and with how
much (impulse a second)."""


class Memory:
    """Forces of contact of the last step, and of what sleeps as it was when it fell asleep.

    Attributes:
        last: of the last step.
        resting: of what sleeps, by its name.
    """

    def __init__(self) -> None:
        self.last: dict[Key, Pressures] = {}
        self.resting: dict[str, dict[Key, Pressures]] = {}

    def known(self, key: Key) -> Pressures:
        """Where two things pressed in the last step, and with how much."""
        return self.last.get(key, [])

    def pressed(self, name: str) -> Iterator[tuple[Key, float]]:
        """What pressed on a thing in the last step, sleepers too: impulse a second, all points."""
        for pressures in (self.last, *self.resting.values()):
            for key, points in pressures.items():
                if name in key[:2]:
                    yield key, sum(pressure for _, pressure in points)

    def keep(self, contacts: Sequence[Contact], seconds: float, bodies: Mapping[str, Body]) -> None:
        """Remember the forces for the next step.

        Args:
            contacts: as solved.
            seconds: length of the step.
            bodies: of the scene.
        """
        kept: dict[Key, Pressures] = {}
        for contact in contacts:
            mobile = contact.second.mobile
            if mobile is None or not contact.pressure:
                continue
            kept.setdefault(contact.key, []).extend(
                (mobile.within(point), pressure / seconds)
                for (point, _), pressure in zip(contact.points, contact.pressures, strict=True)
                if pressure > 0
            )
        for key, pressures in self.last.items():
            # What sleeps still presses.
            body = bodies.get(key[1])
            if key not in kept and body is not None and body.asleep:
                self.resting.setdefault(body.name, {})[key] = pressures
        self.last = kept

    def wake(self, name: str) -> None:
        """A sleeper wakes: it presses as it did."""
        self.last.update(self.resting.pop(name, {}))

    def forget(self, name: str) -> None:
        """A body is gone."""
        self.resting.pop(name, None)
        for pressures in (self.last, *self.resting.values()):
            for key in [key for key in pressures if name in key[:2]]:
                del pressures[key]

    def clear(self) -> None:
        """All of them are."""
        self.last.clear()
        self.resting.clear()
