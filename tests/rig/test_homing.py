"""The program that finds its zero by home switches: from anywhere, and after a collision."""

from __future__ import annotations

import math

from tests.own_places import PROGRAMS
from trs80arm import Rig
from trs80arm.arm import EventKind, benchfile

SECONDS = 120.0
"""Virtual ones that the program takes at most."""
MARKS = (0.0, 60.0, -60.0, -90.0, -90.0)
"""Degrees at which the bench's home switches close."""


def running(text: str) -> Rig:
    """A rig whose program has begun to find the marks of its joints."""
    rig = Rig(bench=benchfile.parse(text, "homing.toml"))
    rig.load(PROGRAMS / "homing.bas")
    rig.type("RUN\r")
    return rig


def bench_file() -> str:
    return (PROGRAMS / "homing.toml").read_text(encoding="utf-8")


def prints(rig: Rig, words: str) -> bool:
    """Whether the program comes to print some words."""
    return rig.run_until(lambda rig: any(words in line for line in rig.screen()), SECONDS)


def off(rig: Rig) -> list[float]:
    """Half-steps by which each joint stands beyond its mark."""
    arm = rig.arm
    return [
        math.degrees(angle - math.radians(mark)) * drive.steps * math.pi / 180
        for angle, mark, drive in zip(
            rig.state.angles.driven, MARKS, arm.model.drives[:5], strict=True
        )
    ]


def test_after_the_shoulder_has_slipped_each_joint_is_found_within_a_half_step() -> None:
    rig = running(bench_file())
    assert prints(rig, "LOST")
    lost = rig.state.slipped
    assert lost[1] <= -40
    assert {event.kind for event in rig.arm.events} >= {EventKind.CONTACT, EventKind.SLIP}
    assert prints(rig, "SHOULDER WAS OFF")
    assert all(0 <= steps < 1 for steps in off(rig))
    said = next(line for line in rig.screen() if "SHOULDER" in line)
    assert abs(int(said.split("BY")[1].split()[0]) - lost[1]) <= 1
    assert rig.run_until(lambda rig: rig.outcome is not None, SECONDS)
    # As good as before: where it says, to the half-step.
    pose = rig.pose
    assert math.dist((pose.x, pose.y, pose.z), (7, 0, 4.6)) < 0.025
    assert rig.score().perfect


def test_it_finds_its_zero_wherever_the_arm_stood_when_switched_on() -> None:
    text = bench_file().replace(
        "at = [6.0, 3.0, 3.0]\npitch = -70.0\nroll = 20.0\nopening = 0.4",
        "at = [9.0, -5.0, 5.0]\npitch = -20.0\nroll = -60.0\nopening = 2.0",
    )
    assert "-60.0\nopening = 2.0" in text
    rig = running(text)
    assert prints(rig, "FIRST PART DONE")
    assert rig.state.slipped == (0,) * 6
    first, _ = rig.score().marks
    assert first.met
