"""What the arm did, in a few lines: what failure messages and failure reports say."""

from __future__ import annotations

from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.rig import Rig
from trs80arm.testing.portraits import motor_lines, side_view

EVENTS = 12
"""How many of the last events are told."""
APART = 8
"""Half-steps between register and joint from which steps were lost: a ring of Figure 8."""


def account(rig: Rig) -> list[str]:
    """How the program stands, where register and joint are apart, and the last events."""
    pose = rig.pose
    lines = [
        f"at {rig.time:.2f} s: {standing(rig)}",
        f"fingertip x {pose.x:.3f} y {pose.y:.3f} z {pose.z:.3f} "
        f"pitch {pose.pitch:.1f} roll {pose.roll:.1f} opening {pose.opening:.3f}",
    ]
    lines += [
        f"{name}: register {register}, joint {joint}"
        for name, register, joint in zip(rig.joint_names, rig.registers, rig.joints, strict=True)
        if abs(register - joint) >= APART
    ]
    return lines + last_events(rig)


def last_events(rig: Rig) -> list[str]:
    """The last things that happened to the arm, each with its virtual time."""
    return [
        f"{event.time / T_STATES_PER_SECOND:9.3f} s  {event.text}" for event in rig.events[-EVENTS:]
    ]


def standing(rig: Rig) -> str:
    """How the program ended, or what the machine is doing."""
    outcome = rig.outcome
    if outcome is None:
        line = rig.basic.next_line
        where = "" if line is None else f" at line {line}"
        waits = rig.waiting.name.replace("_", " ").lower()
        return f"the machine works{where}" if waits == "nothing" else f"it waits ({waits}){where}"
    error = f" ?{outcome.code.letters} Error" if outcome.code else ""
    where = "" if outcome.line is None else f" in line {outcome.line}"
    return f"the program ended ({outcome.ending.value}){error}{where}"


def failure_report(rig: Rig, told: str) -> str:
    """What stands in pytest's report beside a failure: account, motors, tube and side view.

    Args:
        rig: of the test.
        told: what the report says already; an account that is in it is not given again.
    """
    told_of = account(rig)
    return "\n".join(
        [
            *([] if all(line in told for line in told_of) else [*told_of, ""]),
            "motors                register     joint     apart",
            *motor_lines(rig),
            "",
            *(f"|{line}".rstrip() for line in rig.screen() if line),
            "",
            *side_view(rig),
        ]
    )
