"""The operator's hands: with its motors off they put an arm wherever they want it.

They put the parts of its bench back too.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import fields, replace
from typing import TYPE_CHECKING

from trs80arm.arm.bench import deep
from trs80arm.arm.contact.carrying import load_at
from trs80arm.arm.contact.table import TABLE
from trs80arm.arm.geometry import JointAngles
from trs80arm.arm.limits import beyond_any_stop
from trs80arm.arm.linkage import said
from trs80arm.arm.model import Motor

if TYPE_CHECKING:
    from trs80arm.arm.minimover import MiniMover
    from trs80arm.arm.world import World

TURNED_BY_HAND = (*(angle.name for angle in fields(JointAngles)), "hand")
"""What the operator's hands can turn one by one."""
STRONGEST = 1000.0
"""Ounces that an operator pulls by at most."""
BY_HAND = 12
"""Half-steps by which an operator turns the hand's motor in a tick."""
LET_GO = 400
"""Ticks in which all comes to rest after the operator's hands, at most."""
SUNK = 0.03
"""Inches to which an arm can be put by hand into what gives."""


class MotorsOn(Exception):  # noqa: N818 (says what is, like OutOfReach)
    """The arm cannot be moved by hand while a motor holds it."""


class InTheWay(Exception):  # noqa: N818 (says what is, like OutOfReach)
    """Something on the bench is where the arm was to be moved by hand."""


def turned(arm: MiniMover, joint: str, value: float) -> tuple[JointAngles, int]:
    """Angles and hand cable of an arm once one joint has been turned.

    Args:
        arm: as it stands.
        joint: one of `TURNED_BY_HAND`.
        value: degrees, or inches of the hand's opening.

    Raises:
        ValueError: if the joint does not go that far, or there is no such joint.
    """
    if not math.isfinite(value):
        raise ValueError(f"{value} is nowhere")
    angles, cable = arm.drive.angles(arm.rotors), arm.drive.cable(arm.rotors)
    if joint == "hand":
        return angles, cable_for(arm, value)
    if joint not in TURNED_BY_HAND:
        raise ValueError(f"no joint {joint}: {', '.join(TURNED_BY_HAND[:-1])} or hand")
    return replace(angles, **{joint: math.radians(value)}), cable


def cable_for(arm: MiniMover, opening: float) -> int:
    """Half-steps of hand cable for an opening in inches.

    Raises:
        ValueError: if the hand does not open that far.
    """
    widest = arm.model.hand.range
    if not 0 <= opening <= widest:
        raise ValueError(f"the hand opens from 0 to {widest:g} in, not {opening:g}")
    return round(opening * arm.model.hand_steps)


def placed(arm: MiniMover, angles: JointAngles, cable: int) -> list[int]:
    """Rotors where the operator's hands have put joints and hand cable; the world is told.

    Raises:
        MotorsOn: while any motor carries current.
        InTheWay: if something on the bench is there.
        ValueError: if that is beyond a stop.
    """
    if any(motor.energised for motor in arm.motors):
        raise MotorsOn("the motors are on: @RESET turns them off")
    rotors = list(arm.drive.rotors(angles, cable))
    stop = beyond_any_stop(arm.drive, rotors)
    if stop is not None:
        raise ValueError(f"that is beyond a stop: {stop}")
    name = _place(arm.world, arm.rotors, rotors)
    if name is not None:
        raise InTheWay(f"{name} is in the way")
    return rotors


def refill(world: World) -> None:
    """Begin again with the parts of a bench where they were; the hand is left empty.

    Raises:
        InTheWay: the arm stands where one of them was; all are left as they are.
    """
    solids = [solid for _, solid in world.linkage.standing(world.wanted)]
    for part in world.bench.beginning:
        if any(deep(mine, other, SUNK) for mine in solids for other in part.placed):
            raise InTheWay(f"the arm is in the way: it stands where {part.name} was")
    world.grip.forget()
    world.bench.refill()
    world.start()


def occupied(world: World) -> str | None:
    """Name of what is where an arm stands."""
    world.bench.lay()
    name = _found_at(world, world.wanted)
    return None if name is None else said(name)


def _place(world: World, before: Sequence[int], rotors: list[int]) -> str | None:
    """Put an arm somewhere else.

    Args:
        world: where it is.
        before: positions as they are.
        rotors: positions to take up; the hand's is changed to where it could get.

    Returns:
        Name of what is there already, or None if the arm now is.
    """
    scene, drive = world.bench.scene, world.drive
    world.show()
    world.settle(LET_GO)
    wanted = drive.cable(rotors)
    if wanted > world.grip.cable:
        _turn_hand(world, list(before), wanted)
    rotors[Motor.HAND] += world.grip.cable - drive.cable(rotors)
    _lift(world)
    name = _found_at(world, [*world.commands(rotors)[:5], scene.joints[5]])
    if name is not None:
        world.let_loose()
        return said(name)
    world.stand(rotors)
    _turn_hand(world, rotors, wanted)
    world.look_anew()
    return None


def _lift(world: World) -> None:
    """Take along what the hand has in its grip, and what rests on that alone."""
    parts = world.bench.parts
    if world.bench.scene.carried:
        return
    taken = {name for name, part in parts.items() if part.held}
    while taken:
        with_them = taken | set(world.linkage.names)
        riders = {
            name
            for name, part in parts.items()
            if name not in taken and part.touching and set(part.touching) <= with_them
        }
        if not riders:
            break
        taken |= riders
    if taken:
        world.carry([name for name in parts if name in taken])


def _turn_hand(world: World, rotors: list[int], wanted: int) -> None:
    """Pay out or pull in hand cable, and let everything come to rest at once.

    Args:
        world: where the arm is.
        rotors: positions as they are; the hand's is changed to where it gets.
        wanted: half-steps of cable.
    """
    model, grip = world.model, world.grip
    hand = model.latch(Motor.HAND)
    while True:
        by = max(-BY_HAND, min(BY_HAND, wanted - grip.cable))
        if by < 0:
            by = max(by, min(0, int(grip.squeeze) - model.hand.most_squeeze))
        if by == 0:
            break
        rotors[hand] += model.drives[hand].sign * by
        world.moved(rotors, hand)
        world.settle(1)
    world.settle(LET_GO)


def _found_at(world: World, joints: list[float]) -> str | None:
    """Name of what an arm and its load would be in with its joints there."""
    scene, linkage = world.bench.scene, world.linkage
    there = scene.driven.at(joints)
    solids = list(zip(linkage.names, there.solids, strict=True))
    for load in scene.carried:
        solids += [("", solid) for solid in load_at(load, there.links[linkage.hand])]
    for name, solid in solids:
        if solid.low[2] < -SUNK:
            return TABLE
        for thing in scene.fixed.values():
            if name not in thing.passes and any(deep(solid, other, SUNK) for other in thing.placed):
                return thing.name
        for body in scene.bodies.values():
            if body.carried is None and any(deep(solid, other, SUNK) for other in body.placed):
                return body.name
    return None
