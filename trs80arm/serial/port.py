"""The wire as a serial port of this computer, by pyserial (extra `serial`)."""

from __future__ import annotations

import contextlib
import os
from importlib import import_module
from typing import TYPE_CHECKING

from trs80arm.reasons import one_line
from trs80arm.serial.wire import WireError
from trs80arm.shown import message

if TYPE_CHECKING:
    import serial

SCHEME = "serial:"
"""What a plug is called that is a serial port."""
BAUD = 9600
"""A TeachMover's own rate, 8 bits, no parity, 1 stop bit."""
LONGEST_LINE = 200
"""Characters of an answer; what goes on longer is noise."""
NOT_INSTALLED = "pyserial is not installed: pip install 'trs80arm[serial]'"


def _dead() -> tuple[type[Exception], ...]:
    """What pyserial raises for a port that is gone, or was closed meanwhile."""
    with contextlib.suppress(ImportError):
        # Where there is no such module, on Windows, it raises its own.
        return OSError, TypeError, ValueError, import_module("termios").error
    return OSError, TypeError, ValueError


class Port:
    """A serial port with a TeachMover at its end.

    Args:
        path: of the port, as `/dev/ttyUSB0`; anything that pyserial can open, `socket://` too.

    Raises:
        WireError: it cannot be opened, or pyserial is not there.
    """

    def __init__(self, path: str) -> None:
        try:
            import serial
        except ImportError:
            raise WireError(NOT_INSTALLED) from None
        self._dead = _dead()
        try:
            self._port: serial.SerialBase = serial.serial_for_url(path, BAUD, write_timeout=2.0)
            self._port.reset_input_buffer()
        except self._dead as error:
            # pyserial says it in its own words, with number and path; the system's are enough.
            number = error.errno if isinstance(error, OSError) else None
            why = os.strerror(number) if number else one_line(error)
            raise WireError(f"{path}: {why}") from None

    def send(self, line: bytes, answers: int, seconds: float) -> list[str]:
        """As in `Wire`."""
        try:
            self._port.reset_input_buffer()
            self._port.write(line)
            self._port.timeout = seconds
            found: list[str] = []
            while len(found) < answers and (not found or found[0].strip() == "1"):
                found.append(self._line(line.split()[0].decode(), seconds))
        except self._dead as error:
            why = error.args[-1] if error.args else type(error).__name__
            raise WireError(f"The wire to the arm is dead: {message(why)}.") from None
        return found

    def _line(self, word: str, seconds: float) -> str:
        got: bytes = self._port.read_until(b"\r", LONGEST_LINE)
        if not got.endswith(b"\r"):
            if len(got) >= LONGEST_LINE:
                raise WireError(f"What came back over the wire after {word} is noise without end.")
            raise WireError(f"The arm on the wire did not answer {word} within {seconds:g} s.")
        return got[:-1].decode("ascii", "replace").strip("\n")

    def close(self) -> None:
        """As in `Wire`."""
        # It may be gone already; and not every kind of port knows how to leave off.
        with contextlib.suppress(*self._dead, AttributeError):
            self._port.cancel_read()
        with contextlib.suppress(*self._dead):
            self._port.close()


def is_port(plug: str) -> bool:
    """Whether a plug is called as serial ports are."""
    return plug.startswith(SCHEME) and len(plug) > len(SCHEME)
