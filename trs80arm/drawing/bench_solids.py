"""The bench as solids: the table, and everything that stands or lies on it."""

from __future__ import annotations

from functools import lru_cache

from trs80arm.arm.shapes import Box
from trs80arm.drawing.materials import Material, part_material
from trs80arm.drawing.readings import SLAT, Kind, Thing
from trs80arm.drawing.solids import Solids, box, cylinder

FIRST_THING = 10
"""The body number of the first thing; the arm's own are below."""
TABLE = ((-10.0, -15.0), (20.0, 15.0))
"""Two corners of the table, inches: the arm reaches 17.5."""
BELT_WIDE = 0.9
"""Part of a conveyor's width that its belt has."""
SLAT_WIDE, SLAT_HIGH = 0.25, 0.02
"""Of the slats that show how a belt moves, inches."""
THICK = 0.6
"""Thickness of the table's top, inches."""

_MATERIAL = {
    Kind.FEEDER: Material.FURNITURE,
    Kind.TRAY: Material.FURNITURE,
    Kind.OBSTACLE: Material.OBSTACLE,
    Kind.TURNTABLE: Material.FURNITURE,
    Kind.CONVEYOR: Material.FURNITURE,
    Kind.MACHINE: Material.FURNITURE,
    Kind.SENSOR: Material.IDLE,
}
_FACES = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
"""Of a box, by the corners as `Box.corners` lists them, counter-clockwise from outside."""


def table(thick: float = THICK) -> Solids:
    """The table's top, its upper side at height 0, so many inches thick."""
    (left, right), (front, back) = TABLE
    return box((left, right, -thick), (front, back, 0.0), Material.TABLE, 0)


@lru_cache(256)
def solids_of(thing: Thing, body: int) -> Solids:
    """The true shape of a thing, where it is: the one place that knows how shapes are kept.

    Args:
        thing: on the bench.
        body: the number by which the picture tells it from others.
    """
    material = part_material(thing.colour) if thing.kind is Kind.PART else _MATERIAL[thing.kind]
    if thing.kind is Kind.SENSOR and thing.on:
        material = Material.SENSOR
    if thing.kind is Kind.TURNTABLE:
        return _plate(thing.box, material, body)
    if thing.kind is Kind.CONVEYOR:
        return _belt(thing, material, body)
    if thing.solids:
        return Solids.joined(
            tuple(Solids.of(corners, faces, material, body) for corners, faces in thing.solids)
        )
    return Solids.of(thing.box.corners(), _FACES, material, body)


def _belt(thing: Thing, material: int, body: int) -> Solids:
    """A belt on its frame, with slats across it that go along with it."""
    (length, width, height), place = thing.box.half, thing.box
    top, inner = height + SLAT_HIGH, width * BELT_WIDE
    solids = [
        box((-length, -width, -height), (length, width, height), material, body),
        box((-length, -inner, height), (length, inner, top), Material.CABLE, body),
    ]
    at = thing.gone - length
    while at + SLAT_WIDE < length:
        low, high = (at, -inner, top), (at + SLAT_WIDE, inner, top + SLAT_HIGH)
        solids.append(box(low, high, Material.JOINT, body))
        at += SLAT
    return Solids.joined(tuple(one.placed(place.center, place.axes) for one in solids))


def _plate(shape: Box, material: int, body: int) -> Solids:
    """A turntable with a bar across it that shows how far it has turned."""
    (x, y, z), (radius, _, half) = shape.center, shape.half
    plate = cylinder((x, y), radius, z - half, z + half, material, body, sides=24)
    bar = box((0.0, -0.1, half), (radius * 0.95, 0.1, half + 0.05), Material.JOINT, body)
    return Solids.joined((plate, bar.placed(shape.center, shape.axes)))
