"""Arm and bench in lines: where they are, the operator's hands, another bench, the way back."""

from __future__ import annotations

from pathlib import Path

from trs80arm.arm.loads import NEAR, per_cent
from trs80arm.bundled import BENCH_SUFFIX, named
from trs80arm.desk.hands import joint_values, move_by_hand, typed_move
from trs80arm.desk.workbench import STANDARD_BENCH
from trs80arm.plain.command import Group, LineCommand, Sitting
from trs80arm.plain.machine import at_file
from trs80arm.rig import TURNED_BY_HAND

LATEST = 5
"""Events that are told again."""
HAND = TURNED_BY_HAND[-1]


def show_registers(sitting: Sitting, _: str) -> None:
    """Each joint's register, and where it truly is."""
    rig = sitting.session.rig
    for name, register, true in zip(rig.joint_names, rig.registers, rig.joints, strict=True):
        lost = "" if register == true else f", {register - true} lost"
        sitting.tell(f"{name}: {register}, true {true}{lost}")


def show_pose(sitting: Sitting, _: str) -> None:
    """Where the hand is."""
    state = sitting.session.rig.state
    pose = state.pose
    held = f", holds {state.held}" if state.held else ""
    sitting.tell(
        f"X {pose.x:.2f}, Y {pose.y:.2f}, Z {pose.z:.2f} inches, pitch {pose.pitch:.1f}, "
        f"roll {pose.roll:.1f} degrees, hand open {pose.opening:.2f} inches{held}"
    )


def show_effort(sitting: Sitting, _: str) -> None:
    """What each motor uses of what it has, and the grip."""
    loads = sitting.session.rig.loads
    for load in loads.motors:
        does = f"turning {abs(load.rate):.0f} a second" if load.rate else "standing"
        if not load.energised:
            does = "off"
        bears = round(load.torque, 1) + 0.0
        sitting.tell(
            f"{load.name}: {load.per_cent} %{_WARNINGS[load.used > 1, load.used >= NEAR]}, "
            f"peak {load.peak} %, {does}, bears {bears:.1f} {load.unit}, {load.left:.1f} left, "
            f"cable {load.cable:.1f} oz"
        )
    grip = loads.grip
    if grip.used is None:
        sitting.tell("grip: nothing between the fingers")
    else:
        sitting.tell(
            f"grip: {grip.force:.2f} lb, holding takes {grip.needed:.2f}, {per_cent(grip.used)} %"
        )


_WARNINGS = {
    (False, False): "",
    (False, True): ", near its limit",
    (True, True): ", more than it can",
}
"""What is said beside a share, by whether it is more than all, and whether it is near."""


def _events(sitting: Sitting, _: str) -> None:
    for event in sitting.session.rig.arm.events[-LATEST:]:
        sitting.tell(event.text)


def _parts(sitting: Sitting, words: str) -> None:
    if words.casefold() == "back":
        sitting.workbench.refill()
        return
    parts = sitting.session.rig.arm.bench.parts
    if not parts:
        sitting.tell("There are no parts.")
    for name, part in parts.items():
        x, y, z = part.box.center
        where = "in the hand" if part.held else f"at X {x:.2f}, Y {y:.2f}, its middle {z:.2f} high"
        sitting.tell(f"{name}: {part.weight:.1f} oz, {where}")


def _sensors(sitting: Sitting, _: str) -> None:
    rig = sitting.session.rig
    selector = rig.arm.bench.selector
    for sensor in rig.sensors.values():
        bank = "" if selector is None else f" in bank {sensor.bank}"
        answers = "answers" if sensor.given else "idle"
        sitting.tell(f"{sensor.name}: bit {sensor.bit}{bank}, {answers}")
    if not rig.sensors:
        sitting.tell("There are no sensors.")


def _score(sitting: Sitting, _: str) -> None:
    sitting.tell(sitting.session.rig.score().text())


def _bench(sitting: Sitting, name: str) -> None:
    def set_up(path: Path) -> None:
        sitting.workbench.set_up_bench(named(path, BENCH_SUFFIX))

    if name.casefold() == STANDARD_BENCH:
        sitting.workbench.set_up_bench(None)
    else:
        at_file(sitting, name, set_up, to_write=False, ask=sitting.workbench.choose_bench)


def _hand(sitting: Sitting, words: str) -> None:
    rig = sitting.session.rig
    joint, _, value = words.partition(" ")
    joint = joint.casefold()
    if words:
        named_joint = joint in TURNED_BY_HAND
        try:
            move = typed_move(value if named_joint else words, joint, rig.pose)
        except ValueError as error:
            sitting.tell(str(error))
            return
        if refused := move_by_hand(sitting.session, move):
            sitting.tell(refused)
            return
    values = zip(TURNED_BY_HAND, joint_values(rig.state.angles, rig.pose.opening), strict=True)
    told = (f"{name} {at:.2f} in" if name == HAND else f"{name} {at:.1f}°" for name, at in values)
    sitting.tell(", ".join(told))


def _back(sitting: Sitting, _: str) -> None:
    sitting.workbench.come_back()


GROUP = Group(
    "Arm and bench",
    (
        LineCommand("registers", "counted and true steps", show_registers),
        LineCommand("pose", "where the hand is", show_pose),
        LineCommand(
            "effort",
            "what each motor uses of what it has, and the grip",
            show_effort,
            more="100 % is as much as a motor can at its rate; beyond that it slips. The peak is "
            "the most since @RESET.",
        ),
        LineCommand("events", "what happened last; it is told as it happens, too", _events),
        LineCommand(
            "hand",
            "move the arm by hand, while its motors are off",
            _hand,
            "[JOINT] [FIGURES]",
            f"JOINT is one of {', '.join(TURNED_BY_HAND)}, with degrees, or inches for the hand: "
            ".hand base 20\nWithout one the figures are a pose, X Y Z and then pitch, roll and "
            "opening: .hand 8 0 1.5 -90 0 0.5\nWithout any it says how the joints stand. @RESET "
            "turns the motors off.",
        ),
        LineCommand("parts", "where the parts are; back puts them back", _parts, "[back]"),
        LineCommand("sensors", "what the sensors on the free inputs say", _sensors),
        LineCommand("score", "how well the goals of the bench are met", _score),
        LineCommand(
            "bench",
            "set up another bench",
            _bench,
            "[NAME]",
            f"A bench file or one that comes along; {STANDARD_BENCH} is the standard one. "
            "Without a name: a list.",
        ),
        LineCommand("recover", "after a slip: what is lost, and the way back", _back),
    ),
)
