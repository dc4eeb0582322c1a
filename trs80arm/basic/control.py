"""Where a program stands: its loops and subroutines, its error trap, its place in the DATA lines.

One `Control` belongs to the interpreter. It outlives the running of a program, as in the ROM: after
BREAK, STOP or an error the direct mode can look at everything, and CONT goes on.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from trs80arm.basic.variables import Scalar

DIRECT = 0xFFFF
"""The line number of the direct mode (40A2H, ERL)."""
TRACE_ON = 0xAF
"""What TRON puts into its flag."""
FOR_BYTES = 17
GOSUB_BYTES = 5
"""What a loop and a subroutine take on the Z-80's stack (facts, Statements)."""


class ForFrame:
    """An open FOR loop.

    Attributes:
        scalar: its variable.
        limit: of the variable's type.
        step: of the variable's type.
        up: -1, 0 or 1: the sign of the step.
        top: the limit where the step is positive and of usual size, else less than any value: up to
            there NEXT has a short way.
        body: the address of the separator behind the FOR statement.
        line: the number of its line.
    """

    __slots__ = ("body", "limit", "line", "scalar", "step", "top", "up")

    scalar: Scalar
    limit: float
    step: float
    up: int
    top: float
    body: int
    line: int

    def __init__(self, scalar: Scalar, limit: float, step: float, body: int, line: int) -> None:
        self.scalar = scalar
        self.limit = limit
        self.step = step
        self.up = (step > 0) - (step < 0)
        self.top = limit if 1e-30 <= step <= 1e30 else -(2.0**128)
        self.body = body
        self.line = line


class GosubFrame:
    """A subroutine under way.

    Attributes:
        back: the address of the separator behind the GOSUB statement.
        line: the number of its line.
    """

    __slots__ = ("back", "line", "scalar")

    def __init__(self, back: int, line: int) -> None:
        self.back = back
        self.line = line
        self.scalar = None


Frame = ForFrame | GosubFrame

BOTTOM = GosubFrame(0, DIRECT)
"""Always the outermost entry, so that there is a last one to look at."""


@dataclass
class Control:
    """The program's flow, and what an error leaves behind.

    Attributes:
        frames: loops and subroutines, the innermost last, `BOTTOM` first.
        trap: the address of the ON ERROR line's link, 0 without a trap (40F0H).
        handling: whether an error is being handled (40F2H).
        error: the code of the last error less one, times two (ERR).
        error_line: its line (ERL, 40EAH).
        error_address: the statement that RESUME goes back to (40EEH).
        resume_address: where CONT goes on (40F7H), 0 when it cannot.
        resume_line: the line of that place (40F5H).
        data: the address of the separator in front of the next DATA item (40FFH).
        data_line: the line of the DATA statement being read (40DAH).
        dot: the line that `.` means (40ECH).
        trace: the flag of TRON (411BH), 0 when it is off.
        slip: bytes by which RETURN without GOSUB has moved the foot of the Z-80's stack.
    """

    frames: list[Frame] = field(default_factory=lambda: [BOTTOM])
    trap: int = 0
    handling: bool = False
    error: int = 0
    error_line: int = 0
    error_address: int = 0
    resume_address: int = 0
    resume_line: int = 0
    data: int = 0
    data_line: int = 0
    dot: int = 0
    trace: int = 0
    slip: int = 0

    def stack_bytes(self) -> int:
        """What the frames take on the Z-80's stack."""
        # A recursion that fills memory asks this each time: no step of Python for each frame.
        loops = [*map(type, self.frames)].count(ForFrame)
        subroutines = len(self.frames) - 1 - loops
        return loops * FOR_BYTES + subroutines * GOSUB_BYTES - self.slip

    def forget(self, data: int) -> None:
        """No frames, no trap, nothing to CONT; READ begins behind `data` (part of 1B5DH)."""
        self.frames[:] = [BOTTOM]
        self.slip = 0
        self.trap = 0
        self.handling = False
        self.resume_address = 0
        self.data = data
