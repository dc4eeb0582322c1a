"""What things are made of, as far as one can see it: an ink, and how bright it is."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from trs80arm.drawing.rows import PARTS, Ink


@dataclass(frozen=True)
class Finish:
    """How a material looks.

    Attributes:
        ink: its colour.
        bright: how bright it is in full light, 0 to 1.
    """

    ink: Ink
    bright: float = 1.0


class Material(IntEnum):
    """The materials of arm and bench; the parts' follow, one for each of their colours."""

    TABLE = 0
    BASE = 1
    BODY = 2
    MOTOR = 3
    ARM = 4
    JOINT = 5
    CABLE = 6
    HAND = 7
    FINGER = 8
    PAD = 9
    FURNITURE = 10
    OBSTACLE = 11
    SENSOR = 12
    IDLE = 13
    GHOST = 14
    FIRST_PART = 15


_FINISH = {
    Material.TABLE: Finish(Ink.TABLE, 0.17),
    Material.BASE: Finish(Ink.FURNITURE, 0.7),
    Material.BODY: Finish(Ink.FURNITURE, 0.85),
    Material.MOTOR: Finish(Ink.METAL, 0.75),
    Material.ARM: Finish(Ink.ARM, 0.9),
    Material.JOINT: Finish(Ink.METAL, 1.0),
    Material.CABLE: Finish(Ink.METAL, 0.35),
    Material.HAND: Finish(Ink.HAND, 0.8),
    Material.FINGER: Finish(Ink.HAND, 1.0),
    Material.PAD: Finish(Ink.METAL, 0.6),
    Material.FURNITURE: Finish(Ink.FURNITURE, 0.6),
    Material.OBSTACLE: Finish(Ink.OBSTACLE, 0.8),
    Material.SENSOR: Finish(Ink.LAMP_ON),
    Material.IDLE: Finish(Ink.LAMP_OFF, 0.75),
    Material.GHOST: Finish(Ink.GHOST, 0.4),
}
FINISHES: tuple[Finish, ...] = (
    *(_FINISH[Material(place)] for place in range(Material.FIRST_PART)),
    *(Finish(ink) for ink in PARTS),
)
"""How each material looks, by its index."""
INKS: tuple[Ink, ...] = tuple(Ink)
"""Inks by their index in a picture's cells."""
INK_OF = np.array([INKS.index(finish.ink) for finish in FINISHES], dtype=np.int64)
"""The index of each material's ink."""
SHADOW = INKS.index(Ink.SHADOW)
"""The index of the ink of shadows on the table."""
GHOST = INKS.index(Ink.GHOST)
"""The index of the ink of where the arm was told to be."""
BRIGHT = np.array([finish.bright for finish in FINISHES])
"""How bright each material is."""


def part_material(colour: int) -> int:
    """The material of parts of a colour."""
    return Material.FIRST_PART + colour % len(PARTS)
