"""ARMBASIC programs written from taught positions, for the emulated machine and the real one.

Two styles, after the article: Table 3's, a `@STEP` with the differences of the registers for each
move; and Table 4's, DATA lines of coordinates that a person can change, with its subroutine that
computes the joints.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from trs80arm.arm.geometry import JointAngles, OutOfReach, forward, inverse
from trs80arm.arm.model import ArmModel, Motor, Pose
from trs80arm.desk.teach import Lesson, Position, steps_between
from trs80arm.rig import Counts


@dataclass(frozen=True)
class Manner:
    """How a program is to be written.

    Attributes:
        speed: the D of every `@STEP`.
        repeats: whether the arm goes round and round, as in Tables 3 and 4, or stops at the end.
    """

    speed: int = 50
    repeats: bool = False


@dataclass(frozen=True)
class Written:
    """A program of a lesson, or why there is none.

    Attributes:
        listing: the program; empty if there is none.
        problem: why there is none.
        warning: why it will not do what was taught.
    """

    listing: str = ""
    problem: str = ""
    warning: str = ""


def written(lesson: Lesson, manner: Manner, model: ArmModel, *, in_coordinates: bool) -> Written:
    """The program of a lesson in the style of Table 4, in coordinates, or of Table 3, in steps."""
    positions = lesson.positions
    try:
        listing = (
            in_data(positions, manner, model) if in_coordinates else in_steps(positions, manner)
        )
    except OutOfReach as error:
        return Written(problem=f"Cannot be given in coordinates: {error}")
    except ValueError as error:
        return Written(problem=str(error))
    strays = [] if in_coordinates else lesson.strays()
    warning = f"{', '.join(strays)}: registers count from elsewhere than the first one's."
    return Written(listing, warning=warning if strays else "")


@dataclass(frozen=True)
class Move:
    """What happens between two positions.

    Attributes:
        start: the position before.
        end: the position after.
        joints: steps of J1 to J5, and of J6 where the hand opens or closes freely on the way.
        closes: whether the hand closes by `@CLOSE` on arrival.
        hand: steps of the hand on arrival: the squeeze after a `@CLOSE`, or the opening.
        before: steps of the hand before setting off, where it holds more tightly from here on.
    """

    start: Position
    end: Position
    joints: Counts
    closes: bool = False
    hand: int = 0
    before: int = 0


def moves(positions: Sequence[Position], manner: Manner) -> list[Move]:
    """The moves from the first position through all others, and back to it if the arm repeats.

    The hand moves along with the arm while it holds nothing. It takes hold after the arm has
    arrived, and lets go after it has arrived. While it holds, its motor only makes up for another
    squeeze: a tighter one before the arm sets off, a looser one after it has arrived.
    """
    route = list(positions)
    if manner.repeats and len(route) > 1:
        route.append(route[0])
    return [move_between(start, end) for start, end in pairwise(route)]


def move_between(start: Position, end: Position) -> Move:
    """The move from one position to another."""
    *arm, hand = steps_between(start.registers, end.registers)
    a, b, c, d, e = arm
    held = (a, b, c, d, e, 0)
    if end.grips and not start.grips:
        return Move(start, end, held, closes=True, hand=-end.squeeze)
    if start.grips and not end.grips:
        return Move(start, end, held, hand=hand)
    if start.grips:
        tighter = start.squeeze - end.squeeze
        return Move(start, end, held, hand=max(0, tighter), before=min(0, tighter))
    return Move(start, end, (a, b, c, d, e, hand))


def step_command(delay: object, steps: Sequence[int]) -> str:
    """A `@STEP`; trailing joints that do not move are left out."""
    values = list(steps)
    while len(values) > 1 and not values[-1]:
        values.pop()
    return f"@STEP {delay},{','.join(map(str, values))}"


def hand_command(delay: object, steps: int) -> str:
    """A `@STEP` of the hand alone."""
    return step_command(delay, (0, 0, 0, 0, 0, steps))


def commands(move: Move, speed: object, *, back: bool = False) -> list[str]:
    """The commands of a move.

    Args:
        move: what to do.
        speed: the D of its `@STEP`s, a number or a variable's name, unless its end has its own.
        back: whether it undoes the move from `end` to `start`: what the hand did there on arrival
            is undone before the arm sets off.
    """
    delay = speed if move.end.delay is None or back else move.end.delay
    before = [hand_command(delay, move.before)] if move.before else []
    arm = [step_command(delay, move.joints)] if any(move.joints) else []
    hand = ["@CLOSE"] if move.closes else []
    if move.hand:
        hand.append(hand_command(delay, move.hand))
    return before + (hand + arm if back else arm + hand)


def in_steps(positions: Sequence[Position], manner: Manner) -> str:
    """A program of `@STEP` differences, after the article's Table 3.

    It goes from wherever the arm is to the first position by the registers, so they must still
    count from the place where they were zero when the positions were taught.

    Raises:
        ValueError: nothing was taught.
    """
    first = _first(positions)
    lines = _Lines()
    lines.add("REM *****")
    lines.add("REM *")
    lines.add("REM * MINI MOVER 5")
    lines.add("REM *")
    lines.add("REM * TAUGHT POSITIONS, @STEP BY @STEP")
    lines.add("REM *")
    lines.add("REM *****")
    lines.add("REM THE REGISTERS MUST COUNT FROM WHERE THEY WERE ZERO IN TEACHING")
    lines.next(100)
    lines.add(f"S={manner.speed}: REM SPEED")
    lines.add(f"REM TO {first.name} FROM WHEREVER THE ARM IS{_comment(first)}")
    lines.add("@READ K1,K2,K3,K4,K5,K6")
    targets = ",".join(f"{value}-K{joint}" for joint, value in enumerate(first.registers, start=1))
    lines.add(f"@STEP {'S' if first.delay is None else first.delay},{targets}")
    if first.grips:
        lines.add("@CLOSE")
        if first.squeeze:
            lines.add(hand_command("S", -first.squeeze))
    lines.next(200)
    start = lines.number
    for move in moves(positions, manner):
        lines.add(f"REM {move.start.name} TO {move.end.name}{_comment(move.end)}")
        for command in commands(move, "S"):
            lines.add(command)
    if manner.repeats and len(positions) > 1:
        lines.add(f"GOTO {start}")
    lines.add("END")
    return lines.text()


def _comment(position: Position) -> str:
    return f": {position.comment}" if position.comment else ""


def in_data(positions: Sequence[Position], manner: Manner, model: ArmModel) -> str:
    """A program of coordinates in DATA lines, after the article's Table 4.

    It asks the operator to set the arm to where its registers were zero in teaching, which is where
    it stands already on a machine that was just switched on; then it goes through the positions. Of
    positions whose zero cannot be given in coordinates the first one is where it begins.

    Args:
        positions: as taught.
        manner: how the program is to be written.
        model: of the arm that is to run it; its measures and signs stand in the program.

    Raises:
        ValueError: nothing was taught.
        OutOfReach: a position cannot be given in coordinates; the text names it.
    """
    first = _first(positions)
    for position in positions:
        pose = position.pose
        try:
            inverse(model, pose.x, pose.y, pose.z, pose.pitch, pose.roll)
        except OutOfReach as error:
            raise OutOfReach(f"{position.name}: {error}") from None
    lines = _Lines()
    for text in ("REM *****", "REM *", "REM * MINI MOVER 5", "REM *"):
        lines.add(text)
    for text in ("REM * TAUGHT POSITIONS IN CARTESIAN COORDINATES", "REM *", "REM *****"):
        lines.add(text)
    home = _home(first, model)
    route = moves(positions, manner)
    if home is not None:
        route.insert(0, move_between(home, first))
    data = list(_data_lines(route, manner.speed))
    count = sum(line.startswith("DATA") for line in data)
    blanks = {
        "moves": str(max(1, count)),
        "again": "1010" if count and manner.repeats and len(positions) > 1 else "2000",
        # As in Table 4 the way to where the round begins is no part of it.
        "first": str(1 if home is None else 1 + len(_move_data(move_between(home, first), 0))),
        **_constants(model),
    }
    program = _TABLE_4
    for blank, text in blanks.items():
        program = program.replace(f"{{{blank}}}", text)
    for line in program.splitlines():
        lines.quote(line)
    lines.next(9000)
    start = home or first
    lines.add("REM DATA: X, Y, Z, PITCH, ROLL, CLOSE (1) OR NOT (0), STEPS OF HAND, SPEED")
    lines.add(f"REM {start.name}: WHERE THE ARM IS SET TO BEGIN")
    lines.next(10000)
    opening = round(start.pose.opening * model.hand_steps)
    lines.add(f"DATA {_coordinates(start)}, 0, {opening}, {manner.speed}")
    for line in data:
        lines.add(line)
    lines.add("DATA -999, 0, 0, 0, 0, 0, 0, 0")
    return lines.text()


HOME = "START"
"""What the place is called where the registers were zero."""


def _home(position: Position, model: ArmModel) -> Position | None:
    """Where the registers of a position are zero; None if it has no coordinates."""
    if not position.zero:
        return None
    x, y, z = forward(model, angles := JointAngles.of_gears(*position.zero)).fingertip
    opening = position.pose.opening - position.registers[5] / model.hand_steps
    pitch, roll = math.degrees(angles.pitch), math.degrees(angles.roll - angles.base)
    pose = Pose(x, y, z, pitch, roll, min(max(0.0, opening), model.hand.range))
    try:
        inverse(model, *(round(value, 2) for value in (x, y, z, pitch, roll)))
    except OutOfReach:
        return None
    return Position(HOME, (0, 0, 0, 0, 0, 0), pose, zero=position.zero)


def _data_lines(route: Sequence[Move], speed: int) -> Iterator[str]:
    """What each move is called, and its data."""
    for move in route:
        yield f"REM {move.end.name}{_comment(move.end)}"
        yield from _move_data(move, speed)


def _move_data(move: Move, speed: int) -> list[str]:
    """A line for a move, and one more where the hand tightens before it."""
    delay = speed if move.end.delay is None else move.end.delay
    hand = move.hand or move.joints[5]
    line = f"DATA {_coordinates(move.end)}, {int(move.closes)}, {hand}, {delay}"
    if not move.before:
        return [line]
    return [f"DATA {_coordinates(move.start)}, 0, {move.before}, {delay}", line]


def _first(positions: Sequence[Position]) -> Position:
    if not positions:
        raise ValueError("no position has been taught yet")
    return positions[0]


def _coordinates(position: Position) -> str:
    pose = position.pose
    return ", ".join(_number(value) for value in (pose.x, pose.y, pose.z, pose.pitch, pose.roll))


def _number(value: float) -> str:
    text = f"{round(value, 2) + 0.0:.2f}"
    return text.rstrip("0").rstrip(".")


def _constants(model: ArmModel) -> dict[str, str]:
    """What of Table 4's program tells one arm from another."""
    base, shoulder, elbow, wrist = (
        model.drives[model.latch(motor)].steps
        for motor in (Motor.BASE, Motor.SHOULDER, Motor.ELBOW, Motor.LEFT_WRIST)
    )
    # The article's arm has one number for both.
    apart = f":S2={shoulder:.5g}" if shoulder != base else ""
    counts = (
        f"UU({latch + 1},U)={'-' if drive.sign < 0 else ''}C{drive.turns + 1}"
        for latch, drive in enumerate(model.drives[:5])
    )
    sign = "-" if model.elbow_pays_out > 0 else ""
    return {
        "lengths": f"H={model.shoulder_height}:L={model.link}:LL={model.hand_length}",
        "steps": f"S1={base:.5g}{apart}:S3={elbow:.5g}:S4={wrist:.5g}:S6={model.hand_steps:g}",
        "shoulder": "S2" if apart else "S1",
        "counts": ":".join(counts),
        # Where @STEP does not take the hand along with the elbow the program does.
        "hand": "" if model.compensated else f",{sign}UU(3,I)",
    }


class _Lines:
    """A listing in the making, numbered by tens."""

    def __init__(self) -> None:
        self._lines: list[str] = []
        self.number = 10

    def next(self, number: int) -> None:
        """Go on at a line number, or where the listing is if that is further."""
        self.number = max(self.number, number)

    def add(self, text: str) -> None:
        """Add a line."""
        self._lines.append(f"{self.number} {text}")
        self.number += 10 - self.number % 10

    def quote(self, line: str) -> None:
        """Add a line that has its number already."""
        self._lines.append(line)

    def text(self) -> str:
        """The listing."""
        return "\n".join(self._lines) + "\n"


_TABLE_4 = """\
100 REM DEFINE ARM CONSTANTS
101 {lengths}
102 PI=3.14159:C=180/PI:R1=1
103 {steps}
110 DIM UU(8,{moves})
111 U=0
112 @RESET
120 READ X,Y,Z,P,R,K,GR,S
130 PRINT "SET ARM TO THE FOLLOWING POSITION & ORIENTATION"
131 PRINT " USING KEYBOARD, TYPE 0 WHEN FINISHED"
132 PRINT " X = "; X; "INCHES"
133 PRINT " Y = "; Y; "INCHES"
134 PRINT " Z = "; Z; "INCHES"
135 PRINT " PITCH = "; P; "DEGREES"
136 PRINT " ROLL = "; R; "DEGREES"
137 PRINT " HAND = "; GR/S6; "INCHES"
140 @SET
200 GOSUB 5000
210 REM W IS WHERE WE ARE AT
220 W1=INT(S1*T1):W2=INT({shoulder}*T2):W3=INT(S3*T3)
230 W4=INT(S4*T4):W5=INT(S4*T5)
300 REM READ IN NEXT POINT
308 READ X,Y,Z,P,R,K,GR,S
309 IF X < -100 GOTO 1000
320 GOSUB 5000
330 C1=INT(S1*T1)-W1:C2=INT({shoulder}*T2)-W2:C3=INT(S3*T3)-W3
340 C4=INT(S4*T4)-W4:C5=INT(S4*T5)-W5
410 W1=W1+C1:W2=W2+C2:W3=W3+C3:W4=W4+C4:W5=W5+C5
420 U=U+1
430 {counts}
435 UU(6,U)=GR:UU(7,U)=S:UU(8,U)=K
440 I=U
450 GOSUB 3000
460 GOTO 300
1000 GOTO {again}
1010 FOR I={first} TO U
1020 GOSUB 3000
1030 NEXT I
1040 GOTO 1010
2000 END
3000 REM MAKE MOVE I, THEN CLOSE THE HAND IF SO WISHED, THEN STEP IT
3010 @STEP UU(7,I),UU(1,I),UU(2,I),UU(3,I),UU(4,I),UU(5,I){hand}
3020 IF UU(8,I)=1 THEN @CLOSE
3030 IF UU(6,I)<>0 THEN @STEP UU(7,I),0,0,0,0,0,UU(6,I)
3040 RETURN
5000 REM SUBROUTINE TO CALCULATE JOINT COORDINATES
5020 P=P/C:R=R/C
5030 RR=SQR(X*X+Y*Y)
5040 IF RR<.25 THEN 6000
5050 IF X=0 THEN T1=SGN(Y)*PI/2 ELSE T1=ATN(Y/X)
5060 IF X<0 GOTO 6000
5070 T4=P+R+R1*T1
5080 T5=P-R-R1*T1
5090 IF T4<-270/C OR T4>270/C GOTO 6000
5100 IF T5<-270/C OR T5>270/C GOTO 6000
5110 R0=RR-LL*COS(P)
5120 Z0=Z-LL*SIN(P)-H
5130 IF R0<.25 GOTO 6000
5140 G=ATN(Z0/R0)
5150 A=R0*R0 + Z0*Z0
5160 A=4*L*L/A-1
5170 IF A<0 GOTO 6000
5180 A=ATN(SQR(A))
5190 T2=A+G
5200 T3=G-A
5210 IF T2>144/C OR T2<-127/C GOTO 6000
5220 IF (T2-T3)<0 OR (T2-T3)>149/C GOTO 6000
5230 RETURN
6000 PRINT "***** OUT OF REACH *****"
6010 END
"""
