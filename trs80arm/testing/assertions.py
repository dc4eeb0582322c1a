"""Assertions about a rig, with tolerances; a failure says what the arm did."""

from __future__ import annotations

from typing import NoReturn

from trs80arm.arm.events import EventKind
from trs80arm.rig import Rig
from trs80arm.testing.story import APART, account


def assert_at(
    rig: Rig,
    x: float | None = None,
    y: float | None = None,
    z: float | None = None,
    *,
    pitch: float | None = None,
    roll: float | None = None,
    opening: float | None = None,
    within: float = 0.05,
    degrees: float = 0.5,
) -> None:
    """The hand is truly there; what is None may be anything.

    Args:
        rig: whose hand.
        x: of the fingertip, inches, as y and z.
        y: to the arm's left.
        z: above the table.
        pitch: of the hand, degrees.
        roll: of the hand, degrees.
        opening: of the hand, inches.
        within: tolerance of lengths, inches.
        degrees: tolerance of angles.
    """
    __tracebackhide__ = True
    pose = rig.pose
    _compare(
        rig,
        "the hand",
        [
            ("x", pose.x, x, within),
            ("y", pose.y, y, within),
            ("z", pose.z, z, within),
            ("pitch", pose.pitch, pitch, degrees),
            ("roll", pose.roll, roll, degrees),
            ("opening", pose.opening, opening, within),
        ],
    )


def assert_part_at(
    rig: Rig,
    part: str,
    x: float | None = None,
    y: float | None = None,
    z: float | None = None,
    *,
    within: float = 0.1,
) -> None:
    """The middle of a part of the bench is there, inches; what is None may be anything."""
    __tracebackhide__ = True
    parts = rig.parts
    if part not in parts:
        there = ", ".join(parts) or "none"
        _fail(rig, f"there is no part {part!r} on the bench; there are: {there}")
    at = parts[part].box.center
    _compare(
        rig,
        f"part {part!r}",
        [
            (name, is_, wanted, within)
            for name, is_, wanted in zip("xyz", at, (x, y, z), strict=True)
        ],
    )


def assert_no_slip(rig: Rig) -> None:
    """No motor has lost a step since the machine was switched on."""
    __tracebackhide__ = True
    slips = [event.text for event in rig.events if event.kind is EventKind.SLIP]
    pairs = zip(rig.joint_names, rig.state.slipped, strict=False)
    lost = [f"{name} lost {abs(steps)} half-steps" for name, steps in pairs if abs(steps) >= APART]
    if slips or lost:
        _fail(rig, "\n".join(["motors have slipped", *(f"  {each}" for each in slips or lost)]))


def assert_registers(rig: Rig, *registers: int | None, within: int = 0) -> None:
    """The position registers J1 to J6 say so, in half-steps; None may be anything.

    Args:
        rig: whose registers.
        registers: J1 first, six at most; those left out may be anything.
        within: tolerance, half-steps.
    """
    __tracebackhide__ = True
    names = [f"J{number}" for number in range(1, 1 + len(rig.registers))]
    if len(registers) > len(names):
        raise TypeError(f"there are {len(names)} registers, not {len(registers)}")
    rows = zip(names, rig.registers, registers, strict=False)
    _compare(
        rig, "the registers", [(name, is_, wanted, within) for name, is_, wanted in rows], digits=0
    )


def _compare(
    rig: Rig,
    what: str,
    rows: list[tuple[str, float, float | None, float]],
    digits: int = 3,
) -> None:
    """Fail with a line for each value that is further from what is wanted than it may be."""
    __tracebackhide__ = True
    wrong = [
        f"  {name} is {is_:.{digits}f}, wanted {wanted:.{digits}f} within {within:g}: "
        f"off by {is_ - wanted:+.{digits}f}"
        for name, is_, wanted, within in rows
        if wanted is not None and not abs(is_ - wanted) <= within
    ]
    if wrong:
        _fail(rig, "\n".join([f"{what} is elsewhere", *wrong]))


def _fail(rig: Rig, what: str) -> NoReturn:
    __tracebackhide__ = True
    raise AssertionError("\n".join([what, *account(rig)]))
