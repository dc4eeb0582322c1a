"""A thousand poses of an arm, by motors' half-steps, within its ranges."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from random import Random

from trs80arm.arm.bench import Bench
from trs80arm.arm.benchfile import parse
from trs80arm.arm.contact.rotations import Matrix
from trs80arm.arm.geometry import JointAngles
from trs80arm.arm.linkage import ArmLinkage
from trs80arm.arm.model import ArmModel
from trs80arm.arm.models import MODELS
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.shapes import Vector
from trs80arm.rig import Rig, RigSettings

ARMS = tuple(MODELS)
CLOSE = 1e-9
"""Inches."""

BENCH = """
[[part]]
name = "a block, 'turned' <&>"
at = [8.0, 3.0]
size = [1.0, 0.5, 0.75]
turn = 30.0
weight = 3.0

[[part]]
name = "disc"
shape = "disc"
at = [9.0, -4.0]
diameter = 1.5
height = 0.25
weight = 1.0

[[part]]
name = "tray"
shape = "tray"
at = [3.0, 8.0]
size = [3.0, 2.0, 0.5]
wall = 0.125

[[obstacle]]
name = "wall"
at = [13.0, 0.0]
size = [0.5, 4.0, 2.0]
turn = 20.0
"""


def rig_of(arm: str, bench: str = BENCH) -> Rig:
    """A rig with an arm and a bench."""
    return Rig(RigSettings(arm=ArmSettings(model=arm)), _bench(bench))


def _bench(text: str) -> Bench:
    return parse(text, "bench")


def poses(model: ArmModel) -> Iterator[tuple[JointAngles, float]]:
    """A thousand poses: angles and openings."""
    random, limits = Random(1), model.limits
    for _ in range(1000):
        shoulder = random.uniform(*limits.shoulder)
        elbow = shoulder + random.uniform(*limits.elbow)
        pitch = elbow + random.uniform(-limits.pitch, limits.pitch)
        base, roll = random.uniform(-limits.base, limits.base), random.uniform(-pi, pi)
        opening = random.uniform(0, model.hand.range)
        yield JointAngles(base, shoulder, elbow, pitch, roll), opening


def frames(
    model: ArmModel, angles: JointAngles, opening: float
) -> Iterator[tuple[str, Vector, Matrix]]:
    """Where the arm's own kinematics has the links' frames."""
    linkage = ArmLinkage(model, ArmSettings(model=model.name))
    links = linkage.links((*angles.driven, opening))
    for solid, link in zip(model.solids, links, strict=True):
        yield solid.name.replace(" ", "_"), link.place, link.turn
