"""What the machine prints as plain text, for standard output: a run's and the line mode's."""

from __future__ import annotations

from typing import TextIO

from trs80arm.machine.video import FIRST_GRAPHIC, sextant

ENTER = 13
"""The code with which a line ends."""


class Teletype:
    """The program's output as plain text: what the display is sent, line by line."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._column = 0

    def __call__(self, code: int) -> None:
        """Print one character; the operator's own typing is printed too, as on a teletype."""
        if code in (10, ENTER):
            self._write("\n")
        elif 32 <= code < 128:
            self._write(chr(code))
        elif 128 <= code < 192:
            self._write(sextant(code - FIRST_GRAPHIC))
        elif code >= 192:
            self._write(" " * (code - 192))

    def _write(self, text: str) -> None:
        self._stream.write(text)
        self._column = 0 if text == "\n" else self._column + len(text)

    def end_line(self) -> None:
        """Go to the start of a line, unless there already."""
        if self._column:
            self._write("\n")
        self._stream.flush()
