"""Readings made by hand, so that drawings can be tested without a rig."""

from __future__ import annotations

from math import radians

from trs80arm.arm.cell.inputs import Answer
from trs80arm.arm.events import ArmEvent, EventKind, Reason
from trs80arm.arm.geometry import JointAngles, pose_of
from trs80arm.arm.loads import GripLoad, Loads, MotorLoad
from trs80arm.arm.model import Motor
from trs80arm.arm.models import MINIMOVER5
from trs80arm.arm.shapes import upright
from trs80arm.drawing.readings import Kind, Posture, Readings, Thing
from trs80arm.drawing.rows import Row, fitted, text_of

PART = Thing(Kind.PART, "block", upright(8.0, 0.0, 0.0, (1.0, 1.0, 1.0), 0.0))
FAR_PART = Thing(Kind.PART, "other", upright(6.0, 5.0, 0.0, (1.0, 1.0, 1.0), 0.0))
TRAY = Thing(Kind.TRAY, "tray", upright(6.0, 5.0, 0.0, (3.0, 3.0, 0.1), 0.0))


def posture(
    base: float, shoulder: float, elbow: float, pitch: float, roll: float, opening: float
) -> Posture:
    """A posture from degrees and inches."""
    angles = (base, shoulder, elbow, pitch, roll)
    return Posture(MINIMOVER5, JointAngles(*map(radians, angles)), opening)


ABOVE_THE_PART = posture(0.0, 31.0, -73.4, -90.0, 0.0, 1.3)
AT_THE_PART = posture(0.0, 22.9, -77.2, -90.0, 0.0, 1.0)
TO_THE_LEFT = posture(39.8, 31.5, -74.8, -90.0, 130.0, 1.0)
STRETCHED_OUT = posture(0.0, 60.0, 10.0, 0.0, 0.0, 2.0)

EVENTS = (
    ArmEvent(
        0, 1_000_000, EventKind.CONTACT, 1, 0, Reason.CONTACT, "shoulder blocked by the table"
    ),
    ArmEvent(1, 1_900_000, EventKind.SLIP, 1, 16, Reason.CONTACT, "shoulder slipped 16 steps"),
    ArmEvent(2, 1_990_000, EventKind.SLIP, 1, 24, Reason.CONTACT, "shoulder slipped 24 steps"),
    ArmEvent(3, 240_000_000, EventKind.TAKEN, None, 0, None, "block in the hand"),
)

_ANYWHERE = upright(0.0, 0.0, 0.0, (0.1, 0.1, 0.1), 0.0)
ANSWERS = (
    Answer("left tip", 1, 0, False, _ANYWHERE),
    Answer("palm", 3, 0, True, _ANYWHERE),
    Answer("shoulder", 2, 1, True, _ANYWHERE),
)
BELT = Thing(Kind.CONVEYOR, "belt", upright(6, -6, 0.0, (6, 2, 0.5), 0.0), state="runs", on=True)


LOADS = Loads(
    tuple(
        MotorLoad(name, motor, *values, energised=True)
        for name, motor, values in (
            ("base", Motor.BASE, (0.0, 0.0, 0.0, 370.0, 0.0, 31.0, 0.884, 89)),
            ("shoulder", Motor.SHOULDER, (232.0, 3.78, 154.7, -238.0, 232.0, 230.1, 1.008, 104)),
            ("elbow", Motor.ELBOW, (-27.2, -0.75, 30.8, 120.0, 0.0, 170.0, 0.035, 12)),
            ("left wrist", Motor.LEFT_WRIST, (9.6, 0.72, 29.5, 0.0, 9.6, 122.0, 0.079, 8)),
            ("right wrist", Motor.RIGHT_WRIST, (9.6, 0.72, 29.5, 0.0, 9.6, 122.0, 0.079, 8)),
            ("hand", Motor.HAND, (-9.3, -0.23, 9.4, 0.0, 9.3, 48.0, 0.194, 21)),
        )
    ),
    GripLoad(0.58, 12.0, 0.75),
)


def readings(stands: Posture = ABOVE_THE_PART, **others: object) -> Readings:
    """Readings of an arm on a bench with two parts and a tray."""
    values: dict[str, object] = {
        "posture": stands,
        "pose": pose_of(MINIMOVER5, stands.angles, stands.opening),
        "things": (TRAY, PART, FAR_PART),
    }
    return Readings(**{**values, **others})  # type: ignore[arg-type]


def slipped() -> Readings:
    """Readings of an arm whose shoulder and elbow have slipped while it carried a part."""
    held = Thing(Kind.PART, "block", upright(8.0, 0.0, 0.5, (1.0, 1.0, 1.0), 0.0), held=True)
    return readings(
        AT_THE_PART,
        time=83.456,
        registers=(651, -8, -13, -461, -462, -30),
        joints=(651, 16, -21, -461, -462, -30),
        slipped=(0, 24, -8, 0, 0, 0),
        coils=(5, 4, 6, 2, 10, 9, 1),
        inputs=0b1110,
        motors_on=True,
        believed=ABOVE_THE_PART,
        force=0.58,
        held="block",
        loads=LOADS,
        things=(TRAY, held, FAR_PART),
        answers=ANSWERS,
        bank=1,
        events=EVENTS,
    )


def picture(rows: list[Row], width: int, height: int) -> str:
    """Rows as text between bars, as the panel would show them."""
    rows = rows[:height] + [()] * (height - len(rows))
    return "".join(f"|{text_of(fitted(row, width))}|\n" for row in rows)
