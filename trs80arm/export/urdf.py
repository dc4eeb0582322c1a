"""Arm and bench as URDF, the format of ROS: https://wiki.ros.org/urdf/XML.

A joint of URDF can follow one other (`mimic`): one finger follows the other. The cables that
couple more of them are beyond it; `docs/export.md` has them as sums. Parts are fixed where they
are now. Solids that are no boxes are STL files in a folder beside. Metres, kilograms.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Iterable
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from trs80arm.arm.contact.rotations import STRAIGHT, Quaternion, matrix
from trs80arm.arm.contact.solids import Solid
from trs80arm.arm.shapes import Vector
from trs80arm.export import chain, stage
from trs80arm.export.units import INERTIA, JOULES, KILOGRAMS, METRES, NEWTONS, number, numbers
from trs80arm.rig import Rig

_ROOT = "table"
_TIP = "fingertip"
_THICK = 0.01
"""Of the table, metres."""
_ROOM = 2.0
"""Half the size of the table, metres."""
_COLOURS = {"arm": "0.75 0.72 0.62 1", "fixed": "0.45 0.47 0.5 1", "part": "0.8 0.45 0.2 1"}


def urdf(rig: Rig, folder: str) -> tuple[str, dict[str, bytes]]:
    """The arm of a rig and its bench, as they stand now.

    Args:
        rig: with the arm.
        folder: of the meshes, as the file is to name it.

    Returns:
        The file, and meshes by name.
    """
    writer = _Urdf(rig, folder)
    return writer.text(), writer.meshes


class _Urdf:
    def __init__(self, rig: Rig, folder: str) -> None:
        self._rig = rig
        self._folder = folder
        self.meshes: dict[str, bytes] = {}
        self._root = Element("robot", name=rig.arm.model.name)

    def text(self) -> str:
        """The file."""
        rig, root = self._rig, self._root
        for name, rgba in _COLOURS.items():
            SubElement(SubElement(root, "material", name=name), "color", rgba=rgba)
        links = chain.chain(rig.arm.model, rig.settings.arm)
        taken = {link.name for link in links} | {_ROOT, _TIP, "world"}
        own, obstacles = stage.fixed(rig.arm.bench, taken)
        table = SubElement(root, "link", name=_ROOT)
        size = numbers((2 * _ROOM, 2 * _ROOM, _THICK))
        for use in ("visual", "collision"):
            self._shape(table, use, "fixed", (0.0, 0.0, -_THICK / 2 / METRES), STRAIGHT, size)
        self._thing(own[0].name, "fixed", own)
        self._chain(links, own[0].name)
        for obstacle in obstacles:
            self._thing(obstacle.name, "fixed", [obstacle])
        for part in stage.loose(rig.arm.bench, taken):
            self._thing(part.name, "part", [part])
        ElementTree.indent(root)
        return '<?xml version="1.0"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"

    def _chain(self, links: Iterable[chain.ChainLink], base: str) -> None:
        names: list[str] = []
        for each in links:
            names.append(each.name)
            link = SubElement(self._root, "link", name=each.name)
            a, b, c = each.inertia
            self._inertial(link, each.mass, each.middle, (a, 0, 0, b, 0, c))
            for name, solid in each.solids:
                self._solids(link, "arm", name.replace(" ", "_"), (solid,))
            joint = each.joint
            kind = "prismatic" if joint.slides else "revolute"
            parent = base if each.parent is None else names[each.parent]
            made = self._joint(joint.name, kind, parent, each.name, each.at)
            SubElement(made, "axis", xyz=numbers(joint.axis))
            unit = METRES if joint.slides else 1.0
            SubElement(
                made,
                "limit",
                lower=number(joint.low * unit),
                upper=number(joint.high * unit),
                effort=number(joint.effort * (NEWTONS if joint.slides else JOULES)),
                velocity=number(joint.rate * unit),
            )
            if joint.name == "right_finger":
                SubElement(made, "mimic", joint="left_finger", multiplier="1", offset="0")
        SubElement(self._root, "link", name=_TIP)
        self._joint(_TIP, "fixed", "hand", _TIP, (self._rig.arm.model.hand_length, 0.0, 0.0))

    def _thing(self, name: str, sort: str, things: Iterable[stage.Thing]) -> None:
        """A link of some things that stand fast on the table, in the first one's frame."""
        link = SubElement(self._root, "link", name=name)
        frames = []
        for thing in things:
            frames.append((thing.place, thing.turn))
            if thing.inertia is not None:
                a, b, c, _, e, f, _, _, i = thing.inertia
                self._inertial(link, thing.mass, (0.0, 0.0, 0.0), (a, b, c, e, f, i))
            self._solids(link, sort, thing.name, thing.solids)
        self._joint(f"{name}_on_{_ROOT}", "fixed", _ROOT, name, *frames[0])

    def _joint(
        self,
        name: str,
        kind: str,
        parent: str,
        child: str,
        place: Vector,
        turn: Quaternion = STRAIGHT,
    ) -> Element:
        joint = SubElement(self._root, "joint", name=name, type=kind)
        _origin(joint, place, turn)
        SubElement(joint, "parent", link=parent)
        SubElement(joint, "child", link=child)
        return joint

    def _inertial(
        self, link: Element, mass: float, middle: Vector, moments: tuple[float, ...]
    ) -> None:
        inertial = SubElement(link, "inertial")
        _origin(inertial, middle, STRAIGHT)
        SubElement(inertial, "mass", value=number(mass * KILOGRAMS))
        keys = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
        values = (number(value * INERTIA) for value in moments)
        SubElement(inertial, "inertia", dict(zip(keys, values, strict=True)))

    def _solids(self, link: Element, sort: str, name: str, solids: Iterable[Solid]) -> None:
        for index, solid in enumerate(solids):
            box = stage.as_box(solid)
            if box is None:
                file = f"{name}.stl" if not index else f"{name}.{index}.stl"
                self.meshes[file] = stl(solid)
            for use in ("visual", "collision"):
                if box is not None:
                    size = numbers(box.half, 2 * METRES)
                    self._shape(link, use, sort, box.center, stage.turn_of(box), size)
                else:
                    self._shape(link, use, sort, (0.0, 0.0, 0.0), STRAIGHT, "", file)

    def _shape(
        self,
        link: Element,
        use: str,
        sort: str,
        place: Vector,
        turn: Quaternion,
        size: str,
        mesh: str = "",
    ) -> None:
        shape = SubElement(link, use)
        _origin(shape, place, turn)
        geometry = SubElement(shape, "geometry")
        if mesh:
            SubElement(geometry, "mesh", filename=f"{self._folder}/{mesh}")
        else:
            SubElement(geometry, "box", size=size)
        if use == "visual":
            SubElement(shape, "material", name=sort)


def _origin(parent: Element, place: Vector, turn: Quaternion) -> None:
    SubElement(parent, "origin", xyz=numbers(place, METRES), rpy=numbers(_angles(turn)))


def _angles(turn: Quaternion) -> Vector:
    """Roll, pitch and yaw of a turn, as URDF counts them, radians."""
    m = matrix(turn)
    level = math.hypot(m[0], m[3])
    if level < 1e-9:  # Pitched upright: yaw and roll are one turn.
        return math.atan2(-m[5], m[4]), math.atan2(-m[6], level), 0.0
    return math.atan2(m[7], m[8]), math.atan2(-m[6], level), math.atan2(m[3], m[0])


def stl(solid: Solid) -> bytes:
    """A solid as a binary STL file, metres."""
    faces = stage.triangles(solid)
    packed = [b"trs80arm".ljust(80), struct.pack("<I", len(faces))]
    for normal, corners in faces:
        values = [*normal, *(x * METRES for corner in corners for x in corner)]
        packed.append(struct.pack("<12fH", *values, 0))
    return b"".join(packed)
