"""The input nibble: which sensors and answers are on its three free bits, and how it is read.

Bit 0 is the arm's own grip switch. Whatever else answers is on bit 1, 2 or 3, all at once without
a selector, or bank by bank with one. All idle at 1 and answer with 0, and a bit is 0 as soon as one
of those on it answers, as contacts in parallel to ground would have it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from trs80arm.arm.cell.seen import Seen
from trs80arm.arm.shapes import Box

IDLE = 0b1110
"""Bits 1 to 3 where nothing answers."""


class Answering(Protocol):
    """Something on a bit of the input nibble."""

    @property
    def name(self) -> str:
        """By which people call it."""

    @property
    def bit(self) -> int:
        """Of the input nibble, 1 to 3."""

    @property
    def bank(self) -> int:
        """Of the selector in which it is seen."""

    def answers(self, seen: Seen) -> bool:
        """Whether it answers now."""

    def shown(self, seen: Seen) -> Box:
        """Where drawings have it."""


@dataclass(frozen=True)
class Answer:
    """What a sensor says at a moment, seen or not by the selector.

    Attributes:
        name: of the sensor.
        bit: of the input nibble.
        bank: of the selector in which it is seen.
        given: whether it answers.
        box: where drawings have it.
    """

    name: str
    bit: int
    bank: int
    given: bool
    box: Box

    @classmethod
    def of(cls, each: Answering, seen: Seen) -> Answer:
        """Ask a sensor."""
        return cls(each.name, each.bit, each.bank, each.answers(seen), each.shown(seen))


@dataclass(frozen=True)
class Selector:
    """A multiplexer before the input bits: some output bits select the bank that is seen.

    Attributes:
        bits: of the auxiliary output, the low one first.
    """

    bits: tuple[int, ...]

    @property
    def banks(self) -> int:
        """How many there are."""
        return 1 << len(self.bits)

    def bank(self, output: int) -> int:
        """The bank that is seen with a nibble on the auxiliary output."""
        return sum((output >> bit & 1) << k for k, bit in enumerate(self.bits))


def nibble(
    answering: Sequence[Answering], selector: Selector | None, output: int, seen: Seen
) -> int:
    """Bits 1 to 3 of the input nibble.

    Args:
        answering: all that is on them.
        selector: of the bench, or None.
        output: nibble on the auxiliary output.
        seen: what there is to sense.
    """
    bank = 0 if selector is None else selector.bank(output)
    bits = IDLE
    for each in answering:
        if each.bank == bank and bits >> each.bit & 1 and each.answers(seen):
            bits &= ~(1 << each.bit)
    return bits
