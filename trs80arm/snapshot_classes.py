"""The classes of which a snapshot may make objects anew, each by a name that stays.

Devices are not among them: they are assembled, and only given their state (`snapshots`). What
comes and goes while the machine works is: activities of the language, its variables and loops,
motions of the driver, key events, what stands on the bench. A class that lacks here is told when a
snapshot is taken (`TypeError`); it belongs into one of the three tables.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from enum import Enum
from math import prod
from typing import Any

from trs80arm.arm import events, fixtures, forces, geometry, goals, motors, shapes
from trs80arm.arm.cell import (
    commanded_feeder,
    conveyor,
    device,
    home,
    inputs,
    machine,
    mounted,
    sensors,
    turntable,
)
from trs80arm.arm.contact import bodies, coasting, solids, table
from trs80arm.arm.linkage import FINGERS
from trs80arm.arm.model import ArmModel, Link, Motor, Pose
from trs80arm.arm.models import MODELS
from trs80arm.arm.settings import ArmSettings
from trs80arm.basic import errors
from trs80arm.basic.activity import Waiting
from trs80arm.basic.control import ForFrame, GosubFrame
from trs80arm.basic.dialogue import edit, line_range
from trs80arm.basic.kinds import Kind
from trs80arm.basic.numbers.double import Double
from trs80arm.basic.outcome import Ending, Outcome
from trs80arm.basic.runtime.data import ListedTarget, Targets
from trs80arm.basic.state import Activity
from trs80arm.basic.variables import Array, Scalar, is_value
from trs80arm.machine import card, coordination, driver
from trs80arm.machine.jog_keys import JogKeys
from trs80arm.machine.keys import Key
from trs80arm.machine.memory import Memory
from trs80arm.machine.z80.rom import Rom
from trs80arm.serial import tasks
from trs80arm.serial.pendant import PendantMode
from trs80arm.serial.pendant_keys import FunctionKey, JointKey
from trs80arm.works.devices import KeyEvent, RigSettings


def _by_name(classes: Iterable[type]) -> dict[str, type]:
    return {cls.__name__.strip("_"): cls for cls in classes}


def _activities(cls: type[Activity] = Activity) -> list[type]:
    """Every class of activity that the language has."""
    found: list[type] = []
    for kind in cls.__subclasses__():
        found += [kind, *_activities(kind)]
    return found


VALUES: dict[str, type] = _by_name(
    (
        RigSettings,
        card.CardSettings,
        driver.DriverSettings,
        JogKeys,
        Rom,
        ArmSettings,
        coordination.Pace,
        coordination.Coordination,
        Outcome,
        line_range.LineRange,
        shapes.Box,
        bodies.Shape,
        solids.Solid,
        coasting.Move,
        geometry.JointAngles,
        Pose,
        geometry.ArmPoints,
        geometry.CableDrive,
        events.ArmEvent,
        events.Happening,
        forces.Burden,
        forces.Strength,
        forces.Curve,
        fixtures.Obstacle,
        inputs.Selector,
        sensors.Proximity,
        sensors.Tactile,
        sensors.LightBeam,
        mounted.TactilePad,
        mounted.PalmProximity,
        mounted.ForceSensor,
        goals.PartGoal,
        goals.TrayGoal,
        Double,
        ForFrame,
        GosubFrame,
        errors.BasicError,
    )
)
"""What never changes: made by calling the class with its `parts_of`."""


def parts_of(cls: type) -> tuple[str, ...]:
    """The attributes of a value that its class is called with, in order."""
    if cls is Double:
        return "exponent", "mantissa"
    if cls is ForFrame:
        return "scalar", "limit", "step", "body", "line"
    if cls is GosubFrame:
        return "back", "line"
    if cls is errors.BasicError:
        return ("code",)
    return tuple(field.name for field in fields(cls))


OBJECTS: dict[str, type] = _by_name(
    (
        *_activities(),
        KeyEvent,
        driver._Step,
        driver._Close,
        driver._Set,
        tasks.Motion,
        tasks.Playing,
        tasks.Manual,
        Scalar,
        Array,
        Targets,
        ListedTarget,
        fixtures.Part,
        fixtures.Feeder,
        fixtures.Tray,
        motors.StepperMotor,
        turntable.Turntable,
        home.HomeSwitch,
        conveyor.Conveyor,
        commanded_feeder.CommandedFeeder,
        machine.Machine,
        device.Lamp,
        bodies.Fixed,
        table.Plate,
        coasting.Coast,
    )
)
"""What has an identity and a state: made without being called, then given its attributes."""


WIRES: dict[type, frozenset[str]] = {Memory: frozenset({"_owners"})}
"""Attributes that say who is wired to whom, from power-on to the end: no part of a state."""


def _wired(sensor: inputs.Answering) -> bool:
    """Whether a sensor is on a bit that a sensor can be on."""
    return 1 <= sensor.bit <= 3 and sensor.bank >= 0


CHECKS: dict[type, Callable[[Any], bool]] = {
    Scalar: lambda scalar: is_value(scalar.kind, scalar.value),
    Array: lambda array: (
        len(array.data) == prod(array.dims)
        and all(is_value(array.kind, value) for value in array.data)
    ),
    inputs.Selector: lambda selector: all(0 <= bit <= 3 for bit in selector.bits),
    **dict.fromkeys(
        (
            turntable.Turntable,
            conveyor.Conveyor,
            commanded_feeder.CommandedFeeder,
            machine.Machine,
        ),
        lambda device: device.possible,
    ),
    device.Lamp: _wired,
    home.HomeSwitch: lambda switch: _wired(switch) and switch.motor in home.JOINTS.values(),
    mounted.TactilePad: lambda pad: _wired(pad) and (pad.face is None or pad.on in FINGERS),
    **dict.fromkeys(
        (
            sensors.Proximity,
            sensors.Tactile,
            sensors.LightBeam,
            mounted.PalmProximity,
            mounted.ForceSensor,
        ),
        _wired,
    ),
}
"""What must hold of some objects, beside the types of their attributes."""

_ENUMS: tuple[type[Enum], ...] = (
    Key,
    card.Latch,
    card.Jumper,
    Waiting,
    Ending,
    Kind,
    errors.Code,
    edit._Mode,
    events.EventKind,
    events.Reason,
    Motor,
    Link,
    mounted.Face,
    mounted.Tension,
    JointKey,
    FunctionKey,
    PendantMode,
)

NAMED: dict[str, tuple[type, Mapping[str, object]]] = {
    cls.__name__.strip("_"): (cls, cls.__members__) for cls in _ENUMS
} | {"ArmModel": (ArmModel, MODELS)}
"""Kinds of thing of which there are just so many: one is written by its name."""
