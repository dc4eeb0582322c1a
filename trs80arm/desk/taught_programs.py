"""ARMBASIC programs written from taught positions, for the emulated machine and the real one.

Two styles, after the article: Table 3's, a `@STEP` with the differences of the registers for each
move; and Table 4's, DATA lines of coordinates that a person can change, with its subroutine that
computes the joints.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from trs80arm.arm.geometry import OutOfReach, inverse
from trs80arm.arm.model import ArmModel, Motor
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
    repeats: bool = True


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
    return [_move(start, end) for start, end in pairwise(route)]


def _move(start: Position, end: Position) -> Move:
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
    lines.add(f"REM TO {first.name} FROM WHEREVER THE ARM IS")
    lines.add("@READ K1,K2,K3,K4,K5,K6")
    targets = ",".join(f"{value}-K{joint}" for joint, value in enumerate(first.registers, start=1))
    lines.add(f"@STEP S,{targets}")
    if first.grips:
        lines.add("@CLOSE")
    lines.next(200)
    start = lines.number
    for move in moves(positions, manner):
        lines.add(f"REM {move.start.name} TO {move.end.name}")
        if move.before:
            lines.add(f"@STEP S,0,0,0,0,0,{move.before}")
        if any(move.joints):
            lines.add(f"@STEP S, {_listed(move.joints)}")
        if move.closes:
            lines.add("@CLOSE")
        if move.hand:
            lines.add(f"@STEP S,0,0,0,0,0,{move.hand}")
    if manner.repeats and len(positions) > 1:
        lines.add(f"GOTO {start}")
    lines.add("END")
    return lines.text()


def in_data(positions: Sequence[Position], manner: Manner, model: ArmModel) -> str:
    """A program of coordinates in DATA lines, after the article's Table 4.

    The operator sets the arm to the first position by keyboard; then it goes through the others.

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
    data = list(_data_lines(moves(positions, manner), manner.speed))
    blanks = {
        "moves": str(max(1, len(data))),
        "again": "1010" if data and manner.repeats else "2000",
        **_constants(model),
    }
    program = _TABLE_4
    for blank, text in blanks.items():
        program = program.replace(f"{{{blank}}}", text)
    for line in program.splitlines():
        lines.quote(line)
    lines.next(9000)
    lines.add("REM DATA: X, Y, Z, PITCH, ROLL, CLOSE (1) OR NOT (0), STEPS OF HAND, SPEED")
    lines.add(f"REM {first.name}: WHERE THE ARM IS SET TO BEGIN")
    lines.next(10000)
    opening = round(first.pose.opening * model.hand_steps)
    lines.add(f"DATA {_coordinates(first)}, 0, {opening}, {manner.speed}")
    for line in data:
        lines.add(line)
    lines.add("DATA -999, 0, 0, 0, 0, 0, 0, 0")
    return lines.text()


def _data_lines(route: Sequence[Move], speed: int) -> Iterator[str]:
    """A line for each move, and one more where the hand tightens before it."""
    for move in route:
        if move.before:
            yield f"DATA {_coordinates(move.start)}, 0, {move.before}, {speed}"
        hand = move.hand or move.joints[5]
        yield f"DATA {_coordinates(move.end)}, {int(move.closes)}, {hand}, {speed}"


def _first(positions: Sequence[Position]) -> Position:
    if not positions:
        raise ValueError("no position has been taught yet")
    return positions[0]


def _listed(steps: Counts) -> str:
    """Steps as arguments; trailing joints that do not move are left out, but for J5."""
    values = [str(value) for value in steps]
    return ", ".join(values if steps[5] else values[:5])


def _coordinates(position: Position) -> str:
    pose = position.pose
    return ", ".join(_number(value) for value in (pose.x, pose.y, pose.z, pose.pitch, pose.roll))


def _number(value: float) -> str:
    text = f"{round(value, 2) + 0.0:.2f}"
    return text.rstrip("0").rstrip(".")


def _constants(model: ArmModel) -> dict[str, str]:
    """What of Table 4's program tells one arm from another."""
    base, elbow, wrist = (
        model.drives[model.latch(motor)].steps
        for motor in (Motor.BASE, Motor.ELBOW, Motor.LEFT_WRIST)
    )
    counts = (
        f"UU({latch + 1},U)={'-' if drive.sign < 0 else ''}C{drive.turns + 1}"
        for latch, drive in enumerate(model.drives[:5])
    )
    sign = "-" if model.elbow_pays_out > 0 else ""
    return {
        "lengths": f"H={model.shoulder_height}:L={model.link}:LL={model.hand_length}",
        "steps": f"S1={base:.5g}:S3={elbow:.5g}:S4={wrist:.5g}:S6={model.hand_steps:g}",
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
220 W1=INT(S1*T1):W2=INT(S1*T2):W3=INT(S3*T3)
230 W4=INT(S4*T4):W5=INT(S4*T5)
300 REM READ IN NEXT POINT
308 READ X,Y,Z,P,R,K,GR,S
309 IF X < -100 GOTO 1000
320 GOSUB 5000
330 C1=INT(S1*T1)-W1:C2=INT(S1*T2)-W2:C3=INT(S3*T3)-W3
340 C4=INT(S4*T4)-W4:C5=INT(S4*T5)-W5
410 W1=W1+C1:W2=W2+C2:W3=W3+C3:W4=W4+C4:W5=W5+C5
420 U=U+1
430 {counts}
435 UU(6,U)=GR:UU(7,U)=S:UU(8,U)=K
440 I=U
450 GOSUB 3000
460 GOTO 300
1000 GOTO {again}
1010 FOR I=1 TO U
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
