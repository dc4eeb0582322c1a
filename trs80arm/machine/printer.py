"""The line printer at 37E8H, and the ROM's driver for it: LPRINT and LLIST end here.

The printer's paper is a file, or memory when there is none. The driver counts the lines of a page.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from trs80arm.machine.clock import Clock
from trs80arm.machine.memory import Memory
from trs80arm.reasons import reason
from trs80arm.saving import open_to_write

PRINTER_START = 0x37E8
PRINTER_STOP = 0x37EC
READY = 0x3F
"""What the printer's address reads: not busy, paper in, selected, no fault; low bits undriven."""

CONTROL_BLOCK = 0x4025
_CONTROL_BLOCK = bytes((0x06, 0x8D, 0x05, 0x43, 0x00, 0x00, 0x50, 0x52))
"""Printer: type 6, driver at 58DH, 67 lines a page, none printed yet, then its name, "PR"."""
LINES_PER_PAGE = 0x4028
LINES_PRINTED = 0x4029

PAPER = 1 << 19
"""Codes that are kept in memory, some 130 pages."""

_LINE_FEED, _VERTICAL_TAB, _FORM_FEED, _CARRIAGE_RETURN = 10, 11, 12, 13

# T-states from the call of the output routine at 32AH to its return, as the ROM takes them.
_T_NOTHING, _T_CODE, _T_RETURN, _T_FULL_PAGE, _T_LINE_FEED_TURNED = 619, 723, 777, 23, 6
_T_VERTICAL_TAB, _T_FORM_FEED, _T_EACH_FEED, _T_NO_PAGE = 674, 664, 94, 704


def _as_text(codes: bytes | bytearray) -> str:
    return codes.decode("latin-1").replace("\r", "\n")


class Printer:
    """A printer and its paper.

    In memory the paper is as long as `PAPER`: what was printed before goes, as it does from a bin
    under the printer that is full. A file has all of it.

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

    def __getstate__(self) -> dict[str, Any]:
        # The file is of the computer and not of the machine.
        return self.__dict__ | {"path": None}

    @property
    def sent(self) -> bytes:
        """Every code sent since power-on, as far as it is still on the paper in memory."""
        return bytes(self._sent)

    @property
    def text(self) -> str:
        r"""What is on the paper in memory: CR as `\n`, other codes as they are."""
        return _as_text(self._sent)

    @property
    def in_memory(self) -> str:
        """The paper that may be in no file: all of it without one, or after a line went amiss."""
        return self.text if self.path is None or self.fault is not None else ""

    def put(self, code: int) -> None:
        """Send one character, 0 to 255; with CR the line goes to the file."""
        self._sent.append(code & 0xFF)
        if code == _CARRIAGE_RETURN or len(self._sent) - self._line_start >= PAPER:
            self.flush()
        if len(self._sent) >= 2 * PAPER:
            self._line_start -= len(self._sent) - PAPER
            del self._sent[:-PAPER]

    def flush(self) -> None:
        """Bring a line that is not ended yet to the file, as tearing off the paper does."""
        text = _as_text(self._sent[self._line_start :])
        self._line_start = len(self._sent)
        if self.path is None or not text:
            return
        try:
            with open_to_write(self.path, append=True) as paper:
                paper.write(text.encode("latin-1"))
        except OSError as error:
            self.fault = f"{self.path}: {reason(error)}"
        else:
            self.fault = None

    def tear_off(self) -> None:
        """Take away the paper that is printed; a file has it, its last line too."""
        self.flush()
        self._sent.clear()
        self._line_start = 0

    def peek(self, address: int) -> int:
        """The printer's state at 37E8H to 37EBH, as programs look at it before printing."""
        return READY

    def poke(self, address: int, value: int) -> None:
        """A byte stored at the printer's address is printed."""
        self.put(value)


class PrinterDriver:
    """The ROM's way to the printer, with its device control block.

    It keeps the number of the line on the page at 4029H, from 0; programs set the lines of a page
    at 4028H.
    """

    def __init__(self, clock: Clock, memory: Memory, printer: Printer) -> None:
        """Connect the driver and write its device control block."""
        self._clock = clock
        self._ram = memory.ram
        self._printer = printer
        self._ram[CONTROL_BLOCK : CONTROL_BLOCK + len(_CONTROL_BLOCK)] = _CONTROL_BLOCK

    def put(self, code: int) -> None:
        """Print one character or control code, 0 to 255, and charge its time.

        10 and 13 end the line; 11 and 12 feed the paper to the next page line by line; 0 does
        nothing. With no lines a page (0 at 4028H) 12 sends a 0.
        """
        ram, printer = self._ram, self._printer
        if code == 0:
            self._clock.now += _T_NOTHING
        elif code in (_LINE_FEED, _CARRIAGE_RETURN):
            printer.put(_CARRIAGE_RETURN)
            spent = _T_RETURN + (_T_LINE_FEED_TURNED if code == _LINE_FEED else 0)
            ram[LINES_PRINTED] = ram[LINES_PRINTED] + 1 & 0xFF
            if ram[LINES_PRINTED] == ram[LINES_PER_PAGE]:
                ram[LINES_PRINTED] = 0
                spent += _T_FULL_PAGE
            self._clock.now += spent
        elif code == _FORM_FEED and ram[LINES_PER_PAGE] == 0:
            printer.put(0)
            self._clock.now += _T_NO_PAGE
        elif code in (_VERTICAL_TAB, _FORM_FEED):
            # The ROM counts down to zero in one byte, so 0 is 256 times.
            feeds = ram[LINES_PER_PAGE] - ram[LINES_PRINTED] & 0xFF or 256
            for _ in range(feeds):
                printer.put(_LINE_FEED)
            ram[LINES_PRINTED] = 0
            start = _T_VERTICAL_TAB if code == _VERTICAL_TAB else _T_FORM_FEED
            self._clock.now += start + feeds * _T_EACH_FEED
        else:
            printer.put(code)
            self._clock.now += _T_CODE
