"""The line printer at 37E8H: LPRINT and LLIST end here.

Its paper is a file, or memory when there is none.
"""

from __future__ import annotations

from pathlib import Path

PRINTER_START = 0x37E8
PRINTER_STOP = 0x37EC
READY = 0x3F
"""What the printer's address reads: not busy, paper in, selected, no fault; low bits undriven."""

_CARRIAGE_RETURN = 13


def _as_text(codes: bytes | bytearray) -> str:
    return codes.decode("latin-1").replace("\r", "\n")


class Printer:
    """A printer and its paper.

    Attributes:
        path: the file that the paper goes to, appended line by line; None for no file.
        fault: why the last line did not reach the file, in one line; None when all is well. It
            is no error of the machine's, and the line stays on the paper in memory.
    """

    def __init__(self, path: Path | None = None) -> None:
        self.path = path
        self.fault: str | None = None
        self._sent = bytearray()
        self._line_start = 0

    @property
    def sent(self) -> bytes:
        """Every code sent since power-on."""
        return bytes(self._sent)

    @property
    def text(self) -> str:
        r"""All that was printed since power-on: CR as `\n`, other codes as they are."""
        return _as_text(self._sent)

    def put(self, code: int) -> None:
        """Send one character, 0 to 255; with CR the line goes to the file."""
        self._sent.append(code & 0xFF)
        if code == _CARRIAGE_RETURN:
            self.flush()

    def flush(self) -> None:
        """Bring a line that is not ended yet to the file, as tearing off the paper does."""
        text = _as_text(self._sent[self._line_start :])
        self._line_start = len(self._sent)
        if self.path is None or not text:
            return
        try:
            with self.path.open("a", encoding="latin-1", newline="") as paper:
                paper.write(text)
        except OSError as error:
            self.fault = f"{self.path}: {error.strerror or error}"
        else:
            self.fault = None

    def peek(self, address: int) -> int:
        """The printer's state at 37E8H to 37EBH, as programs look at it before printing."""
        return READY

    def poke(self, address: int, value: int) -> None:
        """A byte stored at the printer's address is printed."""
        self.put(value)
