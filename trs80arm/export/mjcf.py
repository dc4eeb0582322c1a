"""Arm and bench as MJCF, MuJoCo's own format: https://mujoco.readthedocs.io/en/stable/XMLreference.html.

The motors are fixed tendons, one a latch, whose length is the motor's half-steps: a step of one
moves the joints as the cables do. Each has a position servo as stiff as its cable, so a control
is a number of half-steps too. Metres, kilograms.
"""

from __future__ import annotations

from collections.abc import Iterable
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from trs80arm.arm.contact.solids import Solid
from trs80arm.arm.linkage import ArmLinkage
from trs80arm.arm.model import Motor
from trs80arm.export import chain, stage
from trs80arm.export.units import (
    GRAVITY,
    INERTIA,
    JOULES,
    KILOGRAMS,
    METRES,
    number,
    numbers,
)
from trs80arm.rig import Rig

_TIMESTEP = 0.0005
_ROOM = 2.0
"""Half the size of the table, metres."""
_PASSED = ("upper_arm", "forearm")
"""Links that are joined to base and body and never meet them."""
_TIP = "fingertip"


def mjcf(rig: Rig) -> str:
    """The arm of a rig and its bench, as they stand now.

    The keyframe `now` has the joints where they are, with the servos that hold them there.
    """
    return _Mjcf(rig).text()


class _Mjcf:
    def __init__(self, rig: Rig) -> None:
        self._model = rig.arm.model
        self._settings = rig.settings.arm
        self._bench = rig.arm.bench
        self._links = chain.chain(self._model, self._settings)
        self._values = chain.joint_values(rig.state.angles, rig.state.pose.opening)
        self._taken = {link.name for link in self._links} | {"table", _TIP, "world"}
        self._root = Element("mujoco", model=self._model.name)
        self._assets = Element("asset")

    def text(self) -> str:
        """The file."""
        root = self._root
        SubElement(root, "compiler", angle="radian", autolimits="true")
        SubElement(
            root,
            "option",
            gravity=numbers((0, 0, -GRAVITY)),
            timestep=number(_TIMESTEP),
            integrator="implicitfast",
            cone="elliptic",
        )
        self._defaults()
        root.append(self._assets)
        self._world()
        self._contact()
        equality = SubElement(root, "equality")
        SubElement(
            equality,
            "joint",
            name="fingers",
            joint1="right_finger",
            joint2="left_finger",
            polycoef="0 1 0 0 0",
        )
        self._motors()
        self._now()
        if not len(self._assets):
            root.remove(self._assets)
        ElementTree.indent(root)
        return ElementTree.tostring(root, encoding="unicode") + "\n"

    def _defaults(self) -> None:
        default = SubElement(self._root, "default")
        # Arm and arm never meet; all else does.
        for name, rgba, kind, against in (
            ("arm", "0.75 0.72 0.62 1", "2", "1"),
            ("fixed", "0.45 0.47 0.5 1", "1", "3"),
            ("part", "0.8 0.45 0.2 1", "1", "3"),
        ):
            of = SubElement(default, "default", {"class": name})
            SubElement(of, "geom", rgba=rgba, contype=kind, conaffinity=against, condim="4")

    def _world(self) -> None:
        world = SubElement(self._root, "worldbody")
        SubElement(world, "light", pos="0 0 2", directional="true")
        SubElement(
            world,
            "geom",
            {
                "class": "fixed",
                "name": "table",
                "type": "plane",
                "size": numbers((_ROOM, _ROOM, 0.05)),
                "rgba": "0.35 0.4 0.35 1",
                "friction": self._friction(self._settings.table_friction),
            },
        )
        own, obstacles = stage.fixed(self._bench, self._taken)
        base = SubElement(world, "body", name="base")
        for thing in own:
            self._geoms(base, "fixed", thing.name, thing.solids, thing.friction)
        self._chain(base)
        for thing in obstacles:
            body = SubElement(world, "body", name=thing.name)
            self._geoms(body, "fixed", thing.name, thing.solids, thing.friction)
        self._parts = stage.loose(self._bench, self._taken)
        for part in self._parts:
            self._part(world, part)

    def _chain(self, base: Element) -> None:
        linkage = ArmLinkage(self._model, self._settings)
        names = (solid.name for solid in self._model.solids)
        friction = dict(zip(names, linkage.frictions, strict=True))
        bodies: list[Element] = []
        for link in self._links:
            parent = base if link.parent is None else bodies[link.parent]
            body = SubElement(parent, "body", name=link.name, pos=numbers(link.at, METRES))
            bodies.append(body)
            SubElement(
                body,
                "inertial",
                pos=numbers(link.middle, METRES),
                mass=number(link.mass * KILOGRAMS),
                diaginertia=numbers(link.inertia, INERTIA),
            )
            joint = link.joint
            unit = METRES if joint.slides else 1.0
            SubElement(
                body,
                "joint",
                name=joint.name,
                type="slide" if joint.slides else "hinge",
                axis=numbers(joint.axis),
                range=numbers((joint.low, joint.high), unit),
            )
            for name, solid in link.solids:
                self._geoms(body, "arm", name.replace(" ", "_"), (solid,), friction[name])
            if link.name == "hand":
                tip = numbers((self._model.hand_length, 0, 0), METRES)
                SubElement(body, "site", name=_TIP, pos=tip, size="0.002")

    def _part(self, world: Element, part: stage.Thing) -> None:
        body = SubElement(
            world,
            "body",
            name=part.name,
            pos=numbers(part.place, METRES),
            quat=numbers(part.turn),
        )
        SubElement(body, "freejoint", name=part.name)
        if part.inertia is not None:
            a, b, c, _, e, f, _, _, i = part.inertia
            SubElement(
                body,
                "inertial",
                pos="0 0 0",
                mass=number(part.mass * KILOGRAMS),
                fullinertia=numbers((a, e, i, b, c, f), INERTIA),
            )
        self._geoms(body, "part", part.name, part.solids, part.friction)

    def _geoms(
        self, body: Element, sort: str, name: str, solids: Iterable[Solid], friction: float
    ) -> None:
        for index, solid in enumerate(solids):
            called = name if not index else f"{name}.{index}"
            geom = SubElement(body, "geom", {"class": sort, "name": called})
            box = stage.as_box(solid)
            if box is not None:
                geom.set("type", "box")
                geom.set("size", numbers(box.half, METRES))
                geom.set("pos", numbers(box.center, METRES))
                geom.set("quat", numbers(stage.turn_of(box)))
            else:
                geom.set("type", "mesh")
                geom.set("mesh", called)
                corners = numbers((x for corner in solid.vertices for x in corner), METRES)
                SubElement(self._assets, "mesh", name=called, vertex=corners)
            geom.set("friction", self._friction(friction))

    def _friction(self, coefficient: float) -> str:
        return numbers((coefficient, 0.002, 0.0001))

    def _contact(self) -> None:
        contact = SubElement(self._root, "contact")
        for link in _PASSED:
            SubElement(contact, "exclude", body1="base", body2=link)

    def _motors(self) -> None:
        tendons, actuators = SubElement(self._root, "tendon"), SubElement(self._root, "actuator")
        gear = self._model.limits.gear
        stiffness = chain.stiffnesses(self._model)
        for latch, (drive, sums) in enumerate(
            zip(self._model.drives, chain.motors(self._model), strict=True)
        ):
            name = f"J{latch + 1}"
            tendon = SubElement(tendons, "fixed", name=name)
            if drive.turns in (Motor.LEFT_WRIST, Motor.RIGHT_WRIST):
                tendon.set("range", numbers((-gear * drive.steps, gear * drive.steps)))
            for joint, steps in sums.items():
                unit = METRES if joint.endswith("finger") else 1.0
                SubElement(tendon, "joint", joint=joint, coef=number(steps / unit))
            SubElement(
                actuators,
                "position",
                name=name,
                tendon=name,
                kp=number(stiffness[latch] * JOULES),
                dampratio="1",
            )

    def _now(self) -> None:
        """The state as it is now: joints, parts, and the half-steps at which the motors hold it."""
        at = [number(value) for value in self._values[:5]]
        at += [number(value * METRES) for value in self._values[5:]]
        for part in self._parts:
            at += [numbers(part.place, METRES), numbers(part.turn)]
        SubElement(
            SubElement(self._root, "keyframe"),
            "key",
            name="now",
            qpos=" ".join(at),
            ctrl=numbers(chain.counts(self._model, self._values)),
        )
