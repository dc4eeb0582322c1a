"""Shots of the rig: what is to be seen from one side, and the samples that a camera takes of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from math import cos, radians, sin

import numpy as np
import numpy.typing as npt

from trs80arm.drawing.arm_solids import (
    BAR,
    LEFT_FINGER,
    RIGHT_FINGER,
    UPPER_ARM,
    arm_solids,
    pedestal,
)
from trs80arm.drawing.bench_solids import FIRST_THING, TABLE, solids_of, table
from trs80arm.drawing.camera import Camera
from trs80arm.drawing.canvas_ascii import Point
from trs80arm.drawing.cells import NEVER, NO_INK, Looks, Samples
from trs80arm.drawing.materials import BRIGHT, INK_OF, SHADOW, Material
from trs80arm.drawing.raster import NOWHERE, Faces, Raster
from trs80arm.drawing.readings import Posture, Readings, Thing
from trs80arm.drawing.rows import Ink
from trs80arm.drawing.scene import (
    PLAINLY,
    QUARTER,
    SHOWS,
    Bounds,
    Extras,
)
from trs80arm.drawing.side_scene import RESTING, side_envelope, side_frame
from trs80arm.drawing.solids import NOTHING, Floats, Place, Shape, Solids
from trs80arm.drawing.top_scene import top_envelope, top_frame
from trs80arm.drawing.viewport import ASPECT, Window

AMBIENT = 0.4
"""What of its brightness a face has that no light falls on."""
IN_SHADOW = 0.03
"""How bright the table is in a shadow."""
FADES = 14.0
"""Inches behind the arm's plane at which things in the side view have half their brightness."""
FINE = 6.0
"""Samples an inch below which details are left out: they would be specks."""
THICKEST = 0.6
"""Inches that a finger is never drawn thick: it would hide what is in the hand."""
_FINGERS = (LEFT_FINGER, RIGHT_FINGER)
_DETAILS = (Material.CABLE, Material.MOTOR)
_WITHIN = (Material.CABLE, Material.JOINT, Material.MOTOR)
"""What is so small, or so near to larger things, that it throws no shadow of its own."""
BEHIND = 1000.0
"""How far away table and ghost are taken to be, that they cover nothing of what is real."""


@dataclass(frozen=True, eq=False)
class Mark:
    """Places marked where nothing stands: by a glyph in a cell's upper half, another in its lower.

    Attributes:
        places: in the world, n x 3.
        ink: of the marks.
        glyphs: the two.
        least: rows an inch below which they would be too many to be looked at.
    """

    places: Floats
    ink: Ink
    glyphs: str
    least: float = 0.0


@dataclass(frozen=True)
class Label:
    """A text in the picture, its middle at a place of the world."""

    place: Place
    text: str
    ink: Ink = Ink.LABEL


_TABLE = table()
_TABLE_FROM_THE_SIDE = table(thick=40.0)
"""Its edge, which is as thick as the row that has the scale."""


@dataclass(frozen=True, eq=False)
class Shot:
    """What a camera is to take.

    Attributes:
        camera: where one looks from.
        solids: what there is besides the table.
        sun: where the light comes from, a unit vector.
        bounds: what belongs into the picture, in its plane.
        focus: what a closer look is centred on, in the picture's plane.
        table: it.
        ghost: where the arm was told to be, as far as that is elsewhere.
        shadows: whether they are thrown on the table; else it is darker below what is above it.
        marks: dots on the table and in the air.
        labels: texts.
        resting: as `Scene.resting`.
        fades: whether what is behind the picture's plane is darker.
    """

    camera: Camera
    solids: Solids
    sun: Place
    bounds: Bounds
    focus: Point
    table: Solids = _TABLE
    ghost: Solids = NOTHING
    shadows: bool = True
    marks: Sequence[Mark] = ()
    labels: Sequence[Label] = ()
    resting: float | None = None
    fades: bool = False


@dataclass(frozen=True)
class Orbit:
    """From where the view in space looks: radians round the table, and above it."""

    turn: float = radians(-52)
    tilt: float = radians(24)


def side_shot(readings: Readings, extras: Extras = PLAINLY) -> Shot:
    """The plane in which the arm stands, seen from its right.

    The hand, and what is in it, is turned so that its opening can be seen.
    """
    posture = readings.posture
    base = posture.angles.base
    c, s = cos(base), sin(base)
    camera = Camera((0.0, 0.0, 0.0), (c, s, 0.0), (0.0, 0.0, 1.0))
    bounds, focus = side_frame(readings, extras)
    arm = arm_solids(_opened_to_the_eye(posture, base))
    turn = QUARTER - posture.angles.roll
    things = [
        _in_the_hand(solids, posture, turn) if thing.held else solids
        for thing, solids in _things(readings)
    ]
    ghost = NOTHING
    if readings.believed:
        told = arm_solids(_opened_to_the_eye(readings.believed, base))
        ghost = _elsewhere(camera, told, arm)
    marks = []
    if extras.envelope:
        marks.append(Mark(_upright(side_envelope(posture.model), c, s), Ink.FAINT, "++"))
    if extras.trail:
        marks.append(Mark(_upright([at.side for at in extras.trail], c, s), Ink.TRAIL, "`,"))
    return Shot(
        camera,
        Solids.joined((pedestal(readings.fittings, base), arm, *things)),
        camera.towards(-0.4, 0.62, 0.68),
        bounds,
        focus,
        ghost=ghost,
        marks=marks,
        table=_TABLE_FROM_THE_SIDE,
        resting=RESTING,
        shadows=False,
        fades=True,
    )


def top_shot(readings: Readings, extras: Extras = PLAINLY) -> Shot:
    """Table, base and arm from above, the arm's front to the right and its left side up."""
    camera = Camera((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    bounds, focus = top_frame(readings, extras)
    arm = arm_solids(readings.posture)
    things = [solids for _, solids in _things(readings)]
    marks = [_INCHES]
    if extras.envelope:
        marks.append(Mark(_level(top_envelope(readings.model)), Ink.FAINT, "++"))
    if extras.trail:
        marks.append(Mark(_level([at.top for at in extras.trail]), Ink.TRAIL, "`,"))
    return Shot(
        camera,
        Solids.joined((_base(readings), arm, *things)),
        camera.towards(-0.42, 0.5, 0.76),
        bounds,
        focus,
        ghost=_ghost(camera, readings, arm),
        marks=marks,
        labels=_FIVES,
    )


def space_shot(readings: Readings, orbit: Orbit, extras: Extras = PLAINLY) -> Shot:
    """Arm and bench in perspective."""
    camera = Camera.around((4.0, 0.0, 5.0), orbit.turn, orbit.tilt, 48.0)
    arm = arm_solids(readings.posture)
    things = [solids for _, solids in _things(readings)]
    base = _base(readings)
    solids = Solids.joined((base, arm, *things))
    seen = camera.points(solids.corners)
    left, bottom, _ = seen.min(0).tolist()
    right, top, _ = seen.max(0).tolist()
    points = readings.posture.points
    [focus] = camera.points(np.array([points.fingertip])).tolist()
    marks = [_INCHES]
    if extras.envelope:
        c, s = cos(readings.angles.base), sin(readings.angles.base)
        marks.append(Mark(_level(top_envelope(readings.model)), Ink.FAINT, "++"))
        marks.append(Mark(_upright(side_envelope(readings.model), c, s), Ink.FAINT, "++"))
    if extras.trail:
        way = [(*point.top, point.side[1]) for point in extras.trail]
        marks.append(Mark(np.array(way), Ink.TRAIL, "`,"))
    return Shot(
        camera,
        solids,
        _SUN,
        (left, bottom, right, top),
        (focus[0], focus[1]),
        ghost=_ghost(camera, readings, arm),
        marks=marks,
        labels=_FIVES,
    )


_SUN: Place = (-0.3, -0.62, 0.725)
"""From where light comes in space: from behind the arm and its right."""


def _base(readings: Readings) -> Solids:
    return pedestal(readings.fittings, readings.angles.base)


def _things(readings: Readings) -> list[tuple[Thing, Solids]]:
    return [
        (thing, solids_of(thing, body)) for body, thing in enumerate(readings.things, FIRST_THING)
    ]


def _opened_to_the_eye(posture: Posture, base: float) -> Posture:
    """A posture with the hand rolled so that its fingers are above and below each other."""
    return replace(posture, angles=replace(posture.angles, base=base, roll=QUARTER))


def _in_the_hand(solids: Solids, posture: Posture, turn: float) -> Solids:
    """What is in the hand, turned with it."""
    points = posture.points
    axis, tip = np.array(points.pointing), np.array(points.fingertip)
    c, s = cos(turn), sin(turn)
    x, y, z = axis
    skew = np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])
    turned = c * np.eye(3) + s * skew + (1 - c) * np.outer(axis, axis)
    return solids.placed(tip - tip @ turned, turned)


def _ghost(camera: Camera, readings: Readings, arm: Solids) -> Solids:
    if readings.believed is None:
        return NOTHING
    return _elsewhere(camera, arm_solids(readings.believed), arm)


def _elsewhere(camera: Camera, told: Solids, arm: Solids) -> Solids:
    """Of the arm where it was told to be, the links that a picture shows elsewhere."""
    away = np.abs(camera.points(told.corners) - camera.points(arm.corners))[:, :2].max(1)
    moved = np.maximum.reduceat(away, told.shape.first_corner) > SHOWS
    return told.some(np.flatnonzero(moved).tolist()).made_of(Material.GHOST)


def _upright(points: Sequence[Point], c: float, s: float) -> Floats:
    """Points of the arm's plane as places of the world."""
    flat = np.array(points).reshape(-1, 2)
    return np.stack((flat[:, 0] * c, flat[:, 0] * s, flat[:, 1]), axis=1)


def _level(points: Sequence[Point]) -> Floats:
    """Points of the table as places of the world."""
    flat = np.array(points).reshape(-1, 2)
    return np.concatenate((flat, np.zeros((len(flat), 1))), axis=1)


def _inches() -> Floats:
    """An inch apart on lines five inches apart: the scale on the table."""
    (left, low), (right, high) = TABLE
    xs, ys = np.arange(left, right + 1), np.arange(low, high + 1)
    along = [(x, y) for y in ys if y % 5 == 0 for x in xs]
    across = [(x, y) for x in xs if x % 5 == 0 for y in ys]
    return _level([*along, *across])


_INCHES = Mark(_inches(), Ink.FAINT, ".,", least=0.9)
_FIVES = tuple(
    Label((float(x), float(y), 0.0), str(abs(x or y)))
    for x, y in [*((x, 0) for x in (5, 10, 15)), *((0, y) for y in (-10, -5, 5, 10))]
)


def take(shot: Shot, width: int, height: int, samples: tuple[int, int], window: Window) -> Samples:
    """The samples of a shot.

    Args:
        shot: what is taken.
        width: cells.
        height: cells.
        samples: how many a cell has across and down.
        window: which part of the picture's plane the cells show.
    """
    camera = shot.camera
    raster = _bare_table(shot.table, camera, width, height, samples, window).copy()
    # What the arm was told hides the table only, and is hidden by whatever is really there.
    coarse = window.scale * raster.down < FINE
    if shot.ghost.shape.faces:
        raster.draw(shot.ghost, camera.sees(shot.ghost))
        raster.send_back(-BEHIND)
    chosen = ~shot.solids.shape.faces_of(*_DETAILS) if coarse else None
    wide = 1 / (window.scale * min(ASPECT * raster.across, raster.down))
    if BAR < wide < THICKEST:
        # A finger is at least a sample thick, or it would come and go.
        shot = replace(shot, solids=shot.solids.thickened(_FINGERS, (wide - BAR) / 2))
    raster.draw(shot.solids, camera.sees(shot.solids), chosen)
    seen = raster.gathered_seen
    # `NOWHERE` is the last of the faces' looks; what is dark on the table comes before it.
    shown = seen.face
    dark = _shadows(raster, shot, window) if shot.shadows else _below(raster, shot)
    np.copyto(shown, IN_THE_DARK, where=dark & _is_table(shown, shot.table))
    return Samples(shown, seen, _looks(shot))


def _is_table(shown: Faces, table: Solids) -> npt.NDArray[np.bool_]:
    """Which samples show the table, whose faces are the first."""
    return shown.view(np.uint32) < table.shape.faces


IN_THE_DARK = NOWHERE - 1
"""The number, among all looks, of the table in a shadow."""


def _looks(shot: Shot) -> Looks:
    """How each face looks, and after them the table in the dark, and nothing."""
    ink, body, bright, fades = _finishes(
        (shot.table.shape, shot.ghost.shape, shot.solids.shape), fades=shot.fades
    )
    light = np.full(len(ink), IN_SHADOW, dtype=np.float32)
    normals = np.concatenate((shot.table.normals, shot.ghost.normals, shot.solids.normals))
    shade = np.maximum(0.0, normals @ np.array(shot.sun))
    light[:IN_THE_DARK] = bright * (AMBIENT + (1 - AMBIENT) * shade)
    light[NOWHERE] = 0.0
    return Looks(ink, light, body, fades)


@lru_cache(16)
def _finishes(
    shapes: tuple[Shape, ...], *, fades: bool
) -> tuple[npt.NDArray[np.int8], npt.NDArray[np.int16], Floats, npt.NDArray[np.float32] | None]:
    """Of all faces ink, body, brightness, and where it fades; all but brightness as of `_looks`."""
    material = np.concatenate([shape.face_materials for shape in shapes])
    body = np.concatenate([*(shape.face_bodies for shape in shapes), [0, -1]]).astype(np.int16)
    ink = np.append(INK_OF[material], [SHADOW, NO_INK]).astype(np.int8)
    far = np.where(body >= FIRST_THING, np.float32(FADES), NEVER)
    return ink, body, BRIGHT[material], far if fades else None


@lru_cache(4)
def _bare_table(
    table: Solids,
    camera: Camera,
    width: int,
    height: int,
    samples: tuple[int, int],
    window: Window,
) -> Raster:
    """The table alone, far away: the same in every frame while nobody looks elsewhere."""
    raster = Raster(width, height, samples, window)
    raster.draw(table, camera.sees(table))
    raster.send_back(-BEHIND)
    return raster


def _shadows(raster: Raster, shot: Shot, window: Window) -> npt.NDArray[np.bool_]:
    """Which samples of the table are in the shadow; found for half as many each way."""
    across, down = max(1, raster.across // 2), max(1, raster.down // 2)
    coarse = Raster(raster.width, raster.height, (across, down), window)
    solids = shot.solids
    casts = ~solids.shape.faces_of(*_WITHIN)
    covered = coarse.covered(solids, shot.camera.shades(solids, shot.sun), casts)
    columns, rows = np.arange(raster.across), np.arange(raster.down)
    finer = rows[:, None] * down // raster.down * across + columns * across // raster.across
    return coarse.gathered(covered).take(finer.ravel(), 0)


def _below(raster: Raster, shot: Shot) -> npt.NDArray[np.bool_]:
    """Which samples are below something: a table seen edge on is darker there."""
    solids = shot.solids
    boxes = shot.camera.points(solids.corners)[:, 0]
    over = solids.shape.bodies >= UPPER_ARM
    left = np.minimum.reduceat(boxes, solids.shape.first_corner)[over, None]
    right = np.maximum.reduceat(boxes, solids.shape.first_corner)[over, None]
    above = ((raster.x >= left) & (raster.x <= right)).any(0)
    columns = above.reshape(raster.width, raster.across).T
    return np.tile(columns, (raster.down, 1))[:, None, :]
