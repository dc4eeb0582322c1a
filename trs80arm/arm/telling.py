"""What is told of parts: that they fell, fell over, were set down, were pushed, and how far.

One piece of news for one happening: it is told when a part has come to rest.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from trs80arm.arm.bench import Bench
from trs80arm.arm.events import EventKind
from trs80arm.arm.fixtures import Part
from trs80arm.arm.shapes import Vector, dot

PUSHED_FAR = 0.02
"""Inches that a part must have been moved for it to be told."""
FELL = 0.25
"""Inches that it must have come down to have fallen."""
TOPPLED = 0.7
"""Cosine of the turn of a part's own vertical beyond which it has fallen over."""


class Telling:
    """News of parts, for the bench's list of them."""

    def __init__(self, bench: Bench) -> None:
        self._bench = bench
        self._moved: dict[str, Vector] = {}
        self._let_go: set[str] = set()
        self._lost: set[str] = set()
        self._riding: tuple[str, ...] = ()

    def clear(self) -> None:
        """Begin anew."""
        self._moved.clear()
        self._let_go.clear()
        self._lost.clear()
        self._riding = ()

    def taken(self, name: str) -> None:
        """A part is in the hand: where it was moved from does not matter any more.

        What the opening hand catches again for a moment, while it falls, is not told.
        """
        if name not in self._let_go | self._lost:
            self._bench.news.append((EventKind.TAKEN, f"{name} in the hand"))
            self._moved.pop(name, None)

    def let_go(self, name: str, part: Part, *, opened: bool) -> None:
        """A part is in the hand no more.

        Args:
            name: of the part.
            part: itself.
            opened: whether the hand has opened; or else it was lost.
        """
        if name in self._let_go | self._lost:
            return
        self._moved[name] = part.place
        (self._let_go if opened else self._lost).add(name)
        part.began = (part.place, part.upwards)

    def look(self, awake: AbstractSet[str], riders: Sequence[str]) -> None:
        """News of what has come to rest.

        Args:
            awake: names of what did not sleep before.
            riders: names of what rides on what is in the hand.
        """
        self._ride(riders)
        parts, scene = self._bench.parts, self._bench.scene
        for body in scene.ordered({*awake, *scene.awake, *self._let_go, *self._lost}):
            name, part = body.name, parts[body.name]
            if not part.asleep:
                if name not in awake:
                    self._moved.setdefault(name, part.place)
                    if part.began is None:
                        part.began = (part.place, part.upwards)
            elif part.held or part.carried is not None:
                self._let_go.discard(name)
                self._lost.discard(name)
            else:
                self._settled(name, part)
        self._bench.deliver()

    def _ride(self, riders: Sequence[str]) -> None:
        """What rides begins where it is when it rides no more, wherever it was taken up."""
        parts = self._bench.parts
        for name in dict.fromkeys((*self._riding, *riders)):
            if (part := parts.get(name)) is None:
                continue
            part.began = (part.place, part.upwards)
            self._moved.pop(name, None)
            if name not in riders:
                self._moved[name] = part.place
        self._riding = tuple(riders)

    def _settled(self, name: str, part: Part) -> None:
        """News of one part that has come to rest."""
        news, began, start = self._bench.news, part.began, self._moved.pop(name, None)
        released = name in self._let_go
        lost = name in self._lost
        self._let_go.discard(name)
        self._lost.discard(name)
        part.began = (part.place, part.upwards)
        if began is None:
            return
        place, up = began
        fell = place[2] - part.place[2]
        far = 0.0 if start is None else math.dist(start, part.place)
        if lost:
            falling = f" and fell {fell:.2f} in" if fell > PUSHED_FAR else ""
            news.append((EventKind.DROPPED, f"{name} slipped out of the hand{falling}"))
        elif dot(up, part.upwards) < TOPPLED:
            news.append((EventKind.TOPPLED, f"{name} fell over"))
        elif fell > FELL:
            news.append((EventKind.DROPPED, f"{name} fell {fell:.2f} in"))
        elif released:
            news.append((EventKind.PLACED, f"{name} set down"))
        elif far > PUSHED_FAR:
            by = self._carrier(part)
            if by is None:
                news.append((EventKind.PUSHED, f"{name} pushed {far:.2f} in"))
            else:
                news.append((EventKind.CARRIED, f"{name} carried {far:.2f} in by {by}"))

    def _carrier(self, part: Part) -> str | None:
        """Name of a device that carries what a part stands on, or what that stands on; or None."""
        devices, parts = self._bench.cell.devices, self._bench.parts
        waiting, seen = [part] if devices else [], {part.name}
        while waiting:
            each = waiting.pop()
            for device in devices:
                if device.carries(each):
                    return device.name
            below = [name for name in each.touching if name in parts and name not in seen]
            seen.update(below)
            waiting += [parts[name] for name in below]
        return None
