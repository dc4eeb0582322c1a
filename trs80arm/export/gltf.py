"""A run as animated glTF 2.0, which viewers of all kinds show.

https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html. One node a link, each inside the one
before it and turned by its joint; one node a part. Metres; y is up.
"""

from __future__ import annotations

import base64
import json
import math
import struct
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from trs80arm import __version__
from trs80arm.arm.contact.rotations import Quaternion
from trs80arm.arm.contact.solids import Solid, box
from trs80arm.arm.shapes import Vector
from trs80arm.export import chain, stage
from trs80arm.export.look import between_links
from trs80arm.export.recording import Recording
from trs80arm.export.units import METRES
from trs80arm.rig import Rig

Keys = Sequence[tuple[float, tuple[float, ...]]]
"""Times and values of one channel of an animation."""

_COLOURS = {
    "table": (0.30, 0.36, 0.30),
    "fixed": (0.42, 0.44, 0.48),
    "arm": (0.75, 0.70, 0.58),
    "joint": (0.30, 0.31, 0.34),
    "finger": (0.25, 0.25, 0.28),
}
_PARTS = ((0.80, 0.42, 0.16), (0.20, 0.50, 0.72), (0.72, 0.62, 0.16), (0.50, 0.30, 0.60))
_TABLE = (36.0, 36.0, 0.5)
"""Inches."""
_FLOAT, _ARRAY = 5126, 34962
_GONE = (0.0, 0.0, 0.0)
_THERE = (1.0, 1.0, 1.0)
_Z_UP = (-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5))


def gltf(rig: Rig, recording: Recording) -> bytes:
    """The run as one `.gltf` file, its buffer within it."""
    scene = _Scene(rig, recording)
    whole = scene.whole()
    content = base64.b64encode(scene.buffer).decode("ascii")
    whole["buffers"][0]["uri"] = f"data:application/octet-stream;base64,{content}"
    return (json.dumps(whole, indent=1) + "\n").encode("ascii")


def glb(rig: Rig, recording: Recording) -> bytes:
    """The run as one binary `.glb` file."""
    scene = _Scene(rig, recording)
    text = json.dumps(scene.whole(), separators=(",", ":")).encode("ascii")
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(scene.buffer), b"BIN\0") + scene.buffer
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


class _Scene:
    """Nodes, meshes and one animation, with the buffer that they lie in.

    Attributes:
        buffer: the bytes that the accessors name.
    """

    def __init__(self, rig: Rig, recording: Recording) -> None:
        self.buffer = bytearray()
        self._recording = recording
        self._views: list[dict[str, Any]] = []
        self._accessors: list[dict[str, Any]] = []
        self._meshes: list[dict[str, Any]] = []
        self._materials: list[dict[str, Any]] = []
        self._colours: dict[tuple[float, ...], int] = {}
        self._nodes: list[dict[str, Any]] = [
            {"name": rig.arm.model.title, "rotation": list(_Z_UP), "children": []}
        ]
        self._samplers: list[dict[str, Any]] = []
        self._channels: list[dict[str, Any]] = []
        self._fixed(rig)
        self._arm(rig)
        self._parts()

    def whole(self) -> dict[str, Any]:
        """The file's object."""
        made: dict[str, Any] = {
            "asset": {"version": "2.0", "generator": f"trs80arm {__version__}"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": self._nodes,
            "meshes": self._meshes,
            "materials": self._materials,
            "accessors": self._accessors,
            "bufferViews": self._views,
            "buffers": [{"byteLength": len(self.buffer)}],
        }
        if self._channels:
            animation = {"name": "run", "channels": self._channels, "samplers": self._samplers}
            made["animations"] = [animation]
        return made

    # What there is

    def _fixed(self, rig: Rig) -> None:
        table = box(_TABLE).moved((0.0, 0.0, -_TABLE[2] / 2))
        self._node(0, "table", self._mesh("table", ([table], _COLOURS["table"])))
        for things in stage.fixed(rig.arm.bench, set()):
            for thing in things:
                mesh = self._mesh(thing.name, (thing.solids, _COLOURS["fixed"]))
                self._node(0, thing.name, mesh)

    def _arm(self, rig: Rig) -> None:
        looks = self._recording.looks
        nodes: list[int] = []
        joints = between_links(rig.arm.model, rig.settings.arm)
        for index, link in enumerate(chain.chain(rig.arm.model, rig.settings.arm)):
            colour = _COLOURS["finger" if link.joint.slides else "arm"]
            solids = [solid for _, solid in link.solids]
            seen = joints.get(link.name, ())
            mesh = self._mesh(link.name, (solids, colour), (seen, _COLOURS["joint"]))
            parent = 0 if link.parent is None else nodes[link.parent]
            node = self._node(parent, link.name, mesh)
            nodes.append(node)
            self._nodes[node]["translation"] = _metres(link.at)
            axis, at = link.joint.axis, link.at
            if link.joint.slides:
                keys = [(look.time, _slid(at, axis, look.joints[index])) for look in looks]
                self._move(node, "translation", keys)
            else:
                keys = [(look.time, _turned(axis, look.joints[index])) for look in looks]
                self._move(node, "rotation", keys)

    def _parts(self) -> None:
        looks, taken = self._recording.looks, set[str]()
        for number, (name, shape) in enumerate(self._recording.parts):
            called = stage.plain(name, taken)
            colour = _PARTS[number % len(_PARTS)]
            node = self._node(0, called, self._mesh(called, (shape.solids, colour)))
            seen = [(look.time, look.parts[number]) for look in looks if number in look.parts]
            places = [(time, tuple(_metres(place))) for time, (place, _) in seen]
            turns = [(time, _xyzw(turn)) for time, (_, turn) in seen]
            self._move(node, "translation", places)
            self._move(node, "rotation", _same_side(turns))
            there = [(look.time, _THERE if number in look.parts else _GONE) for look in looks]
            self._move(node, "scale", there, "STEP")

    # How it is written

    def _node(self, parent: int, name: str, mesh: int) -> int:
        self._nodes.append({"name": name, "mesh": mesh})
        self._nodes[parent].setdefault("children", []).append(len(self._nodes) - 1)
        return len(self._nodes) - 1

    def _mesh(self, name: str, *pieces: tuple[Sequence[Solid], tuple[float, ...]]) -> int:
        """A mesh of some solids, each set of them in a colour."""
        primitives = [self._primitive(solids, colour) for solids, colour in pieces if solids]
        self._meshes.append({"name": name, "primitives": primitives})
        return len(self._meshes) - 1

    def _primitive(self, solids: Iterable[Solid], colour: tuple[float, ...]) -> dict[str, Any]:
        corners: list[Vector] = []
        normals: list[Vector] = []
        for solid in solids:
            for normal, triangle in stage.triangles(solid):
                corners += triangle
                normals += [normal] * 3
        attributes = {
            "POSITION": self._array(np.array(corners) * METRES, _ARRAY, bounds=True),
            "NORMAL": self._array(np.array(normals), _ARRAY),
        }
        return {"attributes": attributes, "material": self._material(colour)}

    def _material(self, colour: tuple[float, ...]) -> int:
        if colour not in self._colours:
            self._colours[colour] = len(self._materials)
            surface = {
                "baseColorFactor": [*colour, 1.0],
                "metallicFactor": 0.1,
                "roughnessFactor": 0.8,
            }
            self._materials.append({"pbrMetallicRoughness": surface})
        return self._colours[colour]

    def _move(self, node: int, path: str, keys: Keys, between: str = "LINEAR") -> None:
        """Have a node go through some values; one that stands still merely has its place."""
        first = keys[0][1]
        if all(value == first for _, value in keys):
            if path != "scale" or first != _THERE:
                self._nodes[node][path] = list(first)
            return
        kept = _bends(keys) if between == "LINEAR" else _changes(keys)
        times = np.array([[time] for time, _ in kept])
        sampler = {
            "input": self._array(times, bounds=True),
            "output": self._array(np.array([value for _, value in kept])),
            "interpolation": between,
        }
        self._samplers.append(sampler)
        target = {"node": node, "path": path}
        self._channels.append({"sampler": len(self._samplers) - 1, "target": target})

    def _array(
        self, values: npt.NDArray[np.float64], target: int | None = None, bounds: bool = False
    ) -> int:
        data = values.astype("<f4")
        view: dict[str, Any] = {
            "buffer": 0,
            "byteOffset": len(self.buffer),
            "byteLength": data.nbytes,
        }
        if target is not None:
            view["target"] = target
        self.buffer += data.tobytes()
        self._views.append(view)
        kind = {1: "SCALAR", 3: "VEC3", 4: "VEC4"}[data.shape[1]]
        accessor: dict[str, Any] = {
            "bufferView": len(self._views) - 1,
            "componentType": _FLOAT,
            "count": len(data),
            "type": kind,
        }
        if bounds:
            accessor["min"] = [float(value) for value in data.min(axis=0)]
            accessor["max"] = [float(value) for value in data.max(axis=0)]
        self._accessors.append(accessor)
        return len(self._accessors) - 1


def _metres(place: Vector) -> list[float]:
    return [value * METRES for value in place]


def _slid(at: Vector, axis: Vector, by: float) -> tuple[float, ...]:
    return tuple((a + by * b) * METRES for a, b in zip(at, axis, strict=True))


def _turned(axis: Vector, angle: float) -> tuple[float, ...]:
    """A turn about an axis as x, y, z, w; of less than two turns, so that it never jumps."""
    sine = math.sin(angle / 2)
    return axis[0] * sine, axis[1] * sine, axis[2] * sine, math.cos(angle / 2)


def _xyzw(turn: Quaternion) -> tuple[float, ...]:
    w, x, y, z = turn
    return x, y, z, w


def _same_side(keys: Iterable[tuple[float, tuple[float, ...]]]) -> Keys:
    """Turns of which each has the sign that is nearer to the one before it."""
    found: list[tuple[float, tuple[float, ...]]] = []
    for time, turn in keys:
        last = found[-1][1] if found else turn
        near = sum(a * b for a, b in zip(turn, last, strict=True)) >= 0
        found.append((time, turn if near else tuple(-value for value in turn)))
    return found


def _bends(keys: Keys) -> Keys:
    """The keys without those between two of the same value."""
    return [
        key
        for i, key in enumerate(keys)
        if i in (0, len(keys) - 1) or not keys[i - 1][1] == key[1] == keys[i + 1][1]
    ]


def _changes(keys: Keys) -> Keys:
    """The keys at which a value begins."""
    return [key for i, key in enumerate(keys) if not i or keys[i - 1][1] != key[1]]
