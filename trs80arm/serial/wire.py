"""The wire to an arm that takes lines: what goes out, what comes back, and what can be wrong.

Whoever drives the arm is given the wire from outside: a serial port, or in a test the computer of
another arm. Nothing here knows of ports, clocks or threads.
"""

from __future__ import annotations

from typing import Protocol


class WireError(Exception):
    """The wire or the arm at its end failed; one clear sentence."""


class Wire(Protocol):
    """Lines out, lines in."""

    def send(self, line: bytes, answers: int, seconds: float) -> list[str]:
        """Send one line and wait for its answer.

        Args:
            line: with its CR.
            answers: how many lines come back at most; a first one that is not `1` is the last.
            seconds: how long that may take at most.

        Returns:
            The lines, without CR; fewer than `answers` only where the first is not `1`.

        Raises:
            WireError: there is no wire any more, or no whole answer in time.
        """

    def close(self) -> None:
        """Let go of the wire; nothing is sent."""
