"""One look at the rig: everything that the panels and views show, read once a frame.

Panels never hold the rig. The program reads it once and hands the same frozen `Readings` to each.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cached_property
from math import tau
from zlib import crc32

from trs80arm.arm.bench import Bench
from trs80arm.arm.cell.conveyor import Conveyor
from trs80arm.arm.cell.device import Device
from trs80arm.arm.cell.inputs import Answer
from trs80arm.arm.cell.machine import BUSY, Machine
from trs80arm.arm.cell.turntable import Turntable
from trs80arm.arm.events import ArmEvent
from trs80arm.arm.fixtures import Polyhedron
from trs80arm.arm.geometry import ArmPoints, JointAngles, forward, inverse
from trs80arm.arm.loads import Loads, unloaded
from trs80arm.arm.model import ArmModel, Pose
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Box, Vector, upright
from trs80arm.machine.driver import Mode
from trs80arm.machine.jog_keys import JogKeys
from trs80arm.rig import Key, Rig, Waiting
from trs80arm.trace.history import History

RING = 8
"""Half-steps of one ring of Figure 8: what a motor loses, it loses in multiples of these."""

SLAT = 1.0
"""From one slat of a belt to the next, inches."""
COLOURS = 6
"""How many colours parts can have."""
_FLAT = 0.1
"""How high what is let into the table is drawn: feeder, tray, turntable, inches."""


class Kind(Enum):
    """What a thing on the table is."""

    PART = "part"
    FEEDER = "feeder"
    TRAY = "tray"
    OBSTACLE = "obstacle"
    TURNTABLE = "turntable"
    CONVEYOR = "conveyor"
    MACHINE = "machine"
    SENSOR = "sensor"


@dataclass(frozen=True)
class Thing:
    """Something on the table.

    Attributes:
        kind: what it is.
        name: of it.
        box: where it is, and how large: itself, or the box around it.
        held: whether the hand holds it.
        colour: of a part, a number; parts of one feeder have one.
        solids: of which it is made, if it is no box: the corners and faces of each.
        state: of a device, what it does.
        on: whether a device is at work, or a sensor answers.
        moving: which way its upper side moves along its own first axis: 1, -1, or 0 for none.
        gone: how far that has moved, inches.
    """

    kind: Kind
    name: str
    box: Box
    held: bool = False
    colour: int = 0
    solids: tuple[Polyhedron, ...] = ()
    state: str = ""
    on: bool = False
    moving: int = 0
    gone: float = 0.0

    @property
    def corners(self) -> list[Vector]:
        """All its corners, inches."""
        if not self.solids:
            return self.box.corners()
        return [corner for corners, _ in self.solids for corner in corners]


@dataclass(frozen=True)
class Posture:
    """How the arm stands: its joint angles, in radians, and the opening of the hand, in inches."""

    model: ArmModel
    angles: JointAngles
    opening: float

    @cached_property
    def points(self) -> ArmPoints:
        """The joints as points, and the axes of the hand."""
        return forward(self.model, self.angles)


def _switched_on() -> Posture:
    """The arm of the standard settings as it is switched on."""
    model = ArmSettings().arm_model
    start = model.start
    angles = inverse(model, start.x, start.y, start.z, start.pitch, start.roll)
    return Posture(model, angles, start.opening)


@dataclass(frozen=True)
class Readings:
    """What can be seen of the rig at one moment.

    Attributes:
        time: virtual seconds since power-on.
        waiting: what the machine waits for.
        to_type: how many characters of a text are still to be typed.
        mode: what the ARMBASIC driver is doing.
        registers: J1 to J6 as commanded, half-steps.
        joints: J1 to J6 as they truly are, in the same steps from the same zero.
        slipped: how far each rotor is from where its field should have taken it, half-steps.
        coils: the seven latches' nibbles, phi1 as bit 3; the last is the auxiliary output.
        inputs: the input nibble: bit 0 the grip switch, 0 closed; the others free.
        devices: on the auxiliary latch: what each is called, and what it does.
        answers: of the sensors on the free bits, whichever the selector shows.
        bank: that the selector shows; None without one.
        motors_on: whether any motor carries current.
        posture: how the arm truly stands.
        believed: how it would stand had no motor slipped; None while none has.
        pose: where the fingertip truly is.
        force: of the grip, pounds.
        loads: what motors and hand bear, and what they have to bear it with.
        held: the name of the part in the hand, or None.
        things: what stands on the table, the arm's own base left out.
        events: what happened to the arm, oldest first.
        fittings: the measures of base and body.
        keys_down: the keys that are down in the matrix.
        jog: the keys of manual mode.
        history: what latches and arm did lately, for the scope.
    """

    posture: Posture = field(default_factory=_switched_on)
    time: float = 0.0
    waiting: Waiting = Waiting.NOTHING
    to_type: int = 0
    mode: Mode = Mode.IDLE
    registers: tuple[int, ...] = (0,) * 6
    joints: tuple[int, ...] = (0,) * 6
    slipped: tuple[int, ...] = (0,) * 6
    coils: tuple[int, ...] = (0,) * 7
    inputs: int = 0b1111
    devices: tuple[tuple[str, str], ...] = ()
    motors_on: bool = False
    answers: tuple[Answer, ...] = ()
    bank: int | None = None
    believed: Posture | None = None
    pose: Pose = field(default_factory=lambda: ArmSettings().arm_model.start)
    force: float = 0.0
    loads: Loads = field(default_factory=lambda: unloaded(ArmSettings().arm_model))
    held: str | None = None
    things: tuple[Thing, ...] = ()
    events: Sequence[ArmEvent] = ()
    fittings: ArmSettings = field(default_factory=ArmSettings)
    keys_down: frozenset[Key] = frozenset()
    jog: JogKeys = field(default_factory=JogKeys)
    history: History | None = field(default=None, compare=False)

    @property
    def model(self) -> ArmModel:
        """What make of arm it is."""
        return self.posture.model

    @property
    def angles(self) -> JointAngles:
        """The joints' true angles, radians."""
        return self.posture.angles

    @property
    def switch_closed(self) -> bool:
        """Whether the grip switch is closed."""
        return not self.inputs & 1

    @classmethod
    def of(
        cls, rig: Rig, history: History | None = None, *, loads: Loads | None = None
    ) -> Readings:
        """Read the rig, and hand on what is known of its past.

        Args:
            rig: what is looked at.
            history: what latches and arm did lately.
            loads: what motors and hand were found to bear; None to find it.
        """
        state = rig.state
        arm = rig.arm
        answers, selector = arm.answers(rig.clock.now), arm.bench.selector
        believed = None
        if any(abs(steps) >= RING for steps in state.slipped):
            cable = arm.drive.cable(state.fields) / arm.model.hand_steps
            opening = min(max(cable, 0.0), arm.model.hand.range)
            believed = Posture(arm.model, arm.drive.angles(state.fields), opening)
        return cls(
            posture=Posture(arm.model, state.angles, state.pose.opening),
            time=rig.time,
            waiting=rig.waiting,
            to_type=rig.to_type,
            mode=rig.driver.mode,
            registers=rig.registers,
            joints=rig.joints,
            slipped=state.slipped,
            coils=state.coils,
            inputs=arm.inputs(rig.clock.now),
            devices=tuple((each.name, each.state) for each in arm.bench.cell.devices),
            motors_on=state.motors_on,
            believed=believed,
            pose=state.pose,
            force=state.force,
            loads=loads or rig.loads,
            held=state.held,
            things=(*things_of(arm.bench, rig.clock.now), *map(_sensor, answers)),
            answers=answers,
            bank=None if selector is None else selector.bank(arm.bench.cell.nibble),
            events=arm.events,
            fittings=arm.settings,
            keys_down=rig.held,
            jog=rig.settings.driver.keys,
            history=history,
        )


def things_of(bench: Bench, time: int = 0) -> Iterator[Thing]:
    """Everything on a bench that is drawn, sensors and the arm's own base and body left out.

    Args:
        bench: as it is.
        time: T-state, for what moves of itself.
    """
    for tray in bench.trays:
        yield Thing(
            Kind.TRAY, tray.name, upright(tray.x, tray.y, 0.0, (tray.width, tray.depth, _FLAT), 0.0)
        )
    for device in bench.cell.devices:
        yield from _device(device, time)
    for feeder in bench.feeders:
        x, y, _ = feeder.size
        yield Thing(
            Kind.FEEDER,
            feeder.name,
            upright(feeder.x, feeder.y, 0.0, (x + 0.5, y + 0.5, _FLAT), feeder.turn),
        )
    for obstacle in bench.obstacles:
        if obstacle.name not in ("base", "body"):
            shape = obstacle.polyhedra
            yield Thing(Kind.OBSTACLE, obstacle.name, obstacle.box, solids=shape)
    colours = _colours(bench)
    for part in bench.parts.values():
        colour = colours[_batch(part.name)]
        yield Thing(Kind.PART, part.name, part.box, part.held, colour, part.polyhedra)


def _sensor(answer: Answer) -> Thing:
    return Thing(Kind.SENSOR, answer.name, answer.box, on=answer.given)


def _device(device: Device, time: int) -> Iterator[Thing]:
    """What is drawn of a device."""
    if isinstance(device, Turntable):
        plate = device.plate
        size = (2 * plate.radius, 2 * plate.radius, _FLAT)
        turn = tau * device.rotor / device.steps
        place = upright(plate.x, plate.y, 0.0, size, turn)
        yield Thing(Kind.TURNTABLE, device.name, place, state=device.state)
    elif isinstance(device, Conveyor):
        speed, gone = device.velocity(time), device.gone(time) % SLAT
        yield Thing(
            Kind.CONVEYOR,
            device.name,
            device.frame.box,
            state=device.state,
            on=speed != 0,
            moving=(speed > 0) - (speed < 0),
            gone=gone,
        )
    elif isinstance(device, Machine):
        nest, works = device.nest, device.phase == BUSY
        bottom = nest.center[2] - nest.half[2]
        floor = replace(
            nest,
            center=(*nest.center[:2], bottom + _FLAT / 4),
            half=(*nest.half[:2], _FLAT / 4),
        )
        for box in (floor, *(each.box for each in device.obstacles if each is not device.hood)):
            yield Thing(Kind.MACHINE, device.name, box, state=device.state, on=works)
        if works:
            hood, shape = device.hood, device.hood.polyhedra
            yield Thing(Kind.MACHINE, hood.name, hood.box, solids=shape, on=True)


def _batch(name: str) -> str:
    """What parts are alike: those of a feeder are called by it and a number."""
    stem, _, number = name.rpartition(" ")
    return stem if stem and number.rstrip("'").isdigit() else name


def _colours(bench: Bench) -> dict[str, int]:
    """A colour for each batch of parts, whoever of them is on the bench; of few parts no two alike.

    It hangs on the names alone where they do not collide, so that no part changes its colour when
    another one is taken away.
    """
    colours: dict[str, int] = {}
    for name in [*(feeder.name for feeder in bench.feeders), *map(_batch, bench.parts)]:
        if name in colours:
            continue
        colour = crc32(name.encode()) % COLOURS
        while colour in colours.values() and len(colours) < COLOURS:
            colour = (colour + 1) % COLOURS
        colours[name] = colour
    return colours
