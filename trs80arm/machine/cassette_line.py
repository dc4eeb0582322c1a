"""The recorder's line as port FFH has it: pulses, half a millisecond and two apart.

Bit 2 of a byte sent to the port switches the motor, bits 0 and 1 are the level on the line to the
recorder; a pulse that the recorder plays sets a latch, which bit 7 of the port shows until the next
byte is sent. The ROM's 500 baud: each bit has two milliseconds, begun by a pulse; a one has another
in its middle. (The Model I's technical handbook; times as the ROM's routines write them.)
"""

from __future__ import annotations

from typing import Final, Protocol

from trs80arm.machine.clock import Clock

CELL: Final = 3_570
"""T-states of a bit, 2 ms, as the ROM writes them."""
HALF: Final = 1_780
"""From a bit's first pulse to the second of a one."""
GAP: Final = 200
"""By how much the last bit of a byte is longer: CLOAD would miss the first of the next without."""
_SAME_BIT: Final = CELL * 3 // 4
"""A pulse that comes sooner behind a bit's first one is the bit's second."""
_LEADS: Final = 20 * CELL
"""From the motor's start until the tape has its speed."""
_MOTOR, _LEVEL = 0b100, 0b011


class Recorder(Protocol):
    """The cassette recorder, byte by byte."""

    def start_writing(self) -> None:
        """Switch the motor on to record."""

    def write(self, value: int) -> None:
        """Record one byte."""

    def start_reading(self) -> None:
        """Switch the motor on to play."""

    def next_byte(self) -> int | None:
        """Play one byte of whatever cassette comes next; None when there is no more."""

    def stop(self) -> None:
        """Switch the motor off."""


class CassetteLine:
    """Turns pulses at the port into bytes on the tape, and the other way.

    The tape runs while the motor is on: what nobody listens to goes by.
    """

    def __init__(self, clock: Clock, recorder: Recorder) -> None:
        self._clock = clock
        self._recorder = recorder
        self._motor = False
        self._level = 0
        self._reading = False
        self._writing = False
        self._begun = 0
        self._pulse = 0
        """The next pulse that is to be heard: twice the bit's number, and one for its middle."""
        self._byte: int | None = None
        self._latch = False
        self._open = False
        """Whether a bit was begun whose middle has not come yet."""
        self._last = 0
        """When the last bit that is recorded began."""
        self._bits = 1
        """The bits of a byte on its way to the tape, behind a one."""

    def write(self, value: int) -> None:
        """A byte goes to the port."""
        motor, level = bool(value & _MOTOR), value & _LEVEL
        if motor and not self._motor:
            self._reading = self._writing = False
            self._begun = self._clock.now + _LEADS
        elif self._motor and not motor:
            self._stop()
        self._motor = motor
        if motor:
            self._hear()
            if level == 1 and self._level != 1:
                self._record()
        self._level = level
        self._latch = False

    def latch(self) -> bool:
        """Whether a pulse came since a byte was last sent to the port."""
        if self._motor and not self._writing:
            if not self._reading:
                self._reading = True
                self._recorder.start_reading()
                self._pulse, self._byte = 0, self._recorder.next_byte()
            self._hear()
        return self._latch

    def _stop(self) -> None:
        if self._writing:
            if self._open:
                self._bit(0)
            self._open = False
        if self._reading or self._writing:
            self._recorder.stop()
        self._reading = self._writing = False

    # -- recording ----------------------------------------------------------------------------

    def _record(self) -> None:
        now = self._clock.now
        if not self._writing:
            if self._reading:
                self._recorder.stop()
                self._reading = False
            self._writing, self._open, self._bits = True, False, 1
            self._recorder.start_writing()
        if self._open and now - self._last < _SAME_BIT:
            self._bit(1)
            self._open = False
            return
        if self._open:
            self._bit(0)
        self._open, self._last = True, now

    def _bit(self, bit: int) -> None:
        self._bits = self._bits << 1 | bit
        if self._bits & 0x100:
            self._recorder.write(self._bits & 0xFF)
            self._bits = 1

    # -- playing ------------------------------------------------------------------------------

    def _hear(self) -> None:
        """Let the tape go by up to now."""
        if not self._reading:
            return
        now, bits = self._clock.now, 8
        while self._byte is not None:
            cell, middle = divmod(self._pulse, 2)
            if self._begun + cell * CELL + middle * HALF > now:
                return
            if not middle or self._byte >> (bits - 1 - cell) & 1:
                self._latch = True
            self._pulse += 1
            if self._pulse == 2 * bits:
                self._pulse = 0
                self._begun += bits * CELL + GAP
                self._byte = self._recorder.next_byte()
