"""What the tube shows at a start without a program: what to type next, in the machine's own way."""

from __future__ import annotations

from typing import Protocol

GREETING = (
    "",
    "ARMBASIC IS LOADED. TYPE ONE OF THESE AND PRESS ENTER:",
    "  @SET             HOLD 1 TO 6, Q TO Y TO MOVE THE ARM; 0 ENDS",
    "  @STEP 50,400     TURN THE BASE LEFTWARDS",
    "  PRINT 355/113    ANYTHING ELSE IS LEVEL II BASIC",
    "KEYS OF THE TERMINAL: F2 OPENS A PROGRAM (TRY TABLE4), F5 RUNS",
    "IT, ESCAPE IS BREAK, F1 IS HELP, CTRL+N A TOUR, F10 LEAVES.",
    "",
)
"""Lines of at most 63 characters, so that none wraps."""


class Display(Protocol):
    """What prints on the tube."""

    def put(self, code: int) -> None:
        """Print one character or control code."""


def greet(console: Display) -> None:
    """Print the greeting, and the prompt under it, on a machine that stands at its prompt."""
    for line in GREETING:
        for code in (*line.encode("ascii"), 13):
            console.put(code)
    for code in b"READY\r>":
        console.put(code)
