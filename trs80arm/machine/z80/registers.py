"""The registers of the Z-80 by name, as whoever answers for a ROM routine reads and writes them."""

from __future__ import annotations

from typing import Final

from trs80arm.machine.z80.chip import HEAD

CARRY, ZERO, SIGN = 0b0000_0001, 0b0100_0000, 0b1000_0000
TICKS_TO_STOP: Final = slice(16, 20)
FRAME_TICK: Final = slice(20, 24)
_HALTED, _PREFIX, _INTERRUPTS = 41, 43, slice(38, 40)


class _Byte:
    def __init__(self, offset: int) -> None:
        self._offset = offset

    def __get__(self, registers: Registers, owner: type) -> int:
        return registers.head[self._offset]

    def __set__(self, registers: Registers, value: int) -> None:
        registers.head[self._offset] = value & 0xFF


class _Word:
    def __init__(self, offset: int) -> None:
        self._offset = offset

    def __get__(self, registers: Registers, owner: type) -> int:
        return registers.head[self._offset] | registers.head[self._offset + 1] << 8

    def __set__(self, registers: Registers, value: int) -> None:
        registers.head[self._offset] = value & 0xFF
        registers.head[self._offset + 1] = value >> 8 & 0xFF


class Registers:
    """The bytes that the chip keeps its registers in, by name.

    Attributes:
        head: those bytes; the chip's own while there is one.
    """

    c, b, e, d, l, h, f, a = (_Byte(offset) for offset in range(8))  # noqa: E741
    bc, de, hl, af, pc, sp = (_Word(offset) for offset in range(0, 12, 2))
    ix, iy = _Word(24), _Word(26)
    bc_, de_, hl_, af_ = (_Word(offset) for offset in range(28, 36, 2))
    r, i = _Byte(36), _Byte(37)

    def __init__(self) -> None:
        self.head: bytearray | memoryview = bytearray(HEAD)

    @property
    def halted(self) -> bool:
        """Whether the processor has executed a HALT."""
        return bool(self.head[_HALTED])

    @property
    def interrupts(self) -> bool:
        """Whether interrupts are enabled; nothing in this machine interrupts."""
        return bool(self.head[_INTERRUPTS.start])

    def content(self) -> bytes:
        """The bytes without the counters, which say how long the chip was last run for."""
        content = bytearray(self.head)
        content[TICKS_TO_STOP] = content[FRAME_TICK] = bytes(4)
        return bytes(content)

    def settle(self) -> None:
        """Between two instructions, not halted, interrupts off: before code is begun anew."""
        self.head[_HALTED] = self.head[_PREFIX] = 0
        self.head[_INTERRUPTS] = bytes(2)

    def flags(self, *, carry: bool = False, zero: bool = False, sign: bool = False) -> None:
        """Set these flags, the others 0."""
        self.f = carry * CARRY | zero * ZERO | sign * SIGN
