"""The Z-80's 256 I/O ports, which INP and OUT of BASIC reach.

A bare Model I has one: FFH, with the cassette and the 32-column switch on it. The interface card
answers at its own ports when it is plugged in.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from trs80arm.machine.cassette_line import CassetteLine
from trs80arm.machine.clock import Clock
from trs80arm.machine.memory import EMPTY
from trs80arm.machine.video import Video

SYSTEM_PORT = 0xFF
_MODE_SELECT_OUT = 0b0000_1000
_MODE_SELECT_IN = 0b0100_0000
_CASSETTE_IN = 0b1000_0000
_LEVEL = 0b0000_0011
LineListener = Callable[[int, int], None]
"""Is told the T-state and the level, 0 to 3, when the level of the recorder's line changes."""


class PortDevice(Protocol):
    """Something that answers at some of the ports."""

    def owns(self, port: int) -> bool:
        """Whether the device answers at a port, 0 to 255."""

    def read(self, port: int) -> int:
        """The byte at a port that the device owns."""

    def write(self, port: int, value: int) -> None:
        """Take a byte sent to a port that the device owns."""


class SystemPort:
    """Port FFH of the Model I: out, bit 3 switches the tube to 32 characters a line.

    In, bit 6 tells the switch's state (1: 64 characters) and bit 7 the cassette's latch, which is
    at rest between two tape statements; nothing drives the other bits, so they read 1: 127, or 63
    in 32-column mode. Bits 0 and 1 out are the level on the line to the recorder, which programs
    make sound with; bit 2, its motor, moves no tape here: tapes are written and read by the
    language's tape statements as whole bytes.

    Attributes:
        listeners: told the time and the level, 0 to 3, whenever the level changes; they are not
            part of a snapshot.
    """

    def __init__(self, clock: Clock, video: Video, line: CassetteLine | None = None) -> None:
        """The port of one machine.

        Args:
            clock: its time.
            video: what bit 3 switches.
            line: the recorder, where tapes are worked by pulses and not by whole bytes: on a
                machine whose own ROM runs on the processor.
        """
        self.listeners: list[LineListener] = []
        self._line = line
        self._clock = clock
        self._video = video
        self._level = 0

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "listeners": []}

    def owns(self, port: int) -> bool:
        """Whether it is port FFH."""
        return port == SYSTEM_PORT

    def read(self, port: int) -> int:
        """127, or 63 while the tube shows 32 characters a line."""
        pulse = self._line is not None and self._line.latch()
        rest = EMPTY & ~_CASSETTE_IN & ~(_MODE_SELECT_IN if self._video.wide else 0)
        return rest | _CASSETTE_IN if pulse else rest

    def write(self, port: int, value: int) -> None:
        """Switch the tube as bit 3 says, and put a level on the recorder's line.

        The ROM's own flag of the tube's mode at 403DH knows nothing of it.
        """
        self._video.switch(bool(value & _MODE_SELECT_OUT))
        if self._line is not None:
            self._line.write(value)
        level = value & _LEVEL
        if level != self._level:
            self._level = level
            for listener in self.listeners:
                listener(self._clock.now, level)


class Ports:
    """All 256 ports."""

    def __init__(self) -> None:
        self._devices: list[PortDevice] = []

    def attach(self, device: PortDevice) -> None:
        """Plug a device in; where two own a port, the one plugged in last answers."""
        self._devices.insert(0, device)

    def read(self, port: int) -> int:
        """INP: the byte at a port, 0 to 255; 255 where nothing answers."""
        for device in self._devices:
            if device.owns(port):
                return device.read(port) & 0xFF
        return EMPTY

    def write(self, port: int, value: int) -> None:
        """OUT: send a byte to a port, 0 to 255; lost where nothing answers."""
        for device in self._devices:
            if device.owns(port):
                device.write(port, value & 0xFF)
                return
