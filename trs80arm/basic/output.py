"""Where characters go: to the display, or to the device that 409CH names."""

from __future__ import annotations

from typing import Final

from trs80arm.basic import addresses, costs
from trs80arm.basic.characters import BLANK
from trs80arm.basic.host import Host

_NEWLINE: Final = 13
_LINE_FEED: Final = 10
_CLEAR_SCREEN: Final = (0x1C, 0x1F)


class Output:
    """The display and the printer, as BASIC writes on them."""

    def __init__(self, host: Host) -> None:
        self._host = host
        self._clock = host.clock
        self._ram = host.memory.ram
        self._console = host.console

    @property
    def on_printer(self) -> bool:
        """Whether PRINT goes to the printer."""
        return bool(self._ram[addresses.OUTPUT_DEVICE])

    @property
    def column(self) -> int:
        """The column of the device that PRINT goes to."""
        return self._ram[addresses.PRINTER_COLUMN] if self.on_printer else self._console.column

    def show(self, text: bytes) -> None:
        """Send characters to the display."""
        clock, put = self._clock, self._console.put
        for code in text:
            clock.now += costs.PRINT_CHARACTER
            put(code)

    def newline_if_needed(self) -> None:
        """A newline on the display unless the cursor is at the start of a line (20F9H)."""
        if self._console.column:
            self._console.put(_NEWLINE)

    def clear_screen(self) -> None:
        """Clear the display and go home."""
        for code in _CLEAR_SCREEN:
            self._console.put(code)

    def put(self, text: bytes) -> None:
        """Send characters to the device that PRINT goes to."""
        if not self.on_printer:
            self.show(text)
            return
        for code in text:
            self._clock.now += costs.PRINT_CHARACTER
            self._put_printer(code)

    def to_screen(self) -> None:
        """Send what is printed to the screen."""
        self._ram[addresses.OUTPUT_DEVICE] = 0

    def to_printer(self) -> None:
        """Send what is printed to the printer."""
        self._ram[addresses.OUTPUT_DEVICE] = 1

    def leave_printer(self) -> None:
        """To the screen for good (038BH): the printer gets the end of a line begun."""
        self.to_screen()
        if self._ram[addresses.PRINTER_COLUMN]:
            self._put_printer(_NEWLINE)

    def _put_printer(self, code: int) -> None:
        self._host.printer.put(code)
        column = self._ram[addresses.PRINTER_COLUMN]
        if code in (_NEWLINE, _LINE_FEED):
            column = 0
        elif code >= BLANK:
            column = column + 1 & 0xFF
        self._ram[addresses.PRINTER_COLUMN] = column
