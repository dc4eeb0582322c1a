"""The value change dump, IEEE 1364's plain format for waveform viewers: one signal per coil."""

from __future__ import annotations

from collections.abc import Sequence
from typing import BinaryIO

from trs80arm.machine.card import Latch
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.pulses import Series

_COILS = ("phi1", "phi2", "phi3", "phi4")
_FIRST_CODE = ord("!")


def nanoseconds(time: int) -> int:
    """A T-state in the dump's time scale, rounded down."""
    return time * 1_000_000_000 // T_STATES_PER_SECOND


class VcdSink:
    """Writes the coils of the seven latches as 28 wires in seven scopes, at 1 ns.

    The auxiliary latch's four lines are named like the coils that they may drive. A coil is listed
    only when it changes. A dump cannot go back in time: when an earlier state is restored, changes
    stand at the latest time until the clock has come to it again.
    """

    def __init__(self, file: BinaryIO, time: int, latches: Sequence[int]) -> None:
        """Begin a dump at a T-state, with what the latches hold."""
        self._file = file
        self._held = list(latches)
        self._now = nanoseconds(time)
        lines = ["$version trs80arm $end", "$timescale 1 ns $end", "$scope module card $end"]
        for latch in Latch:
            lines.append(f"$scope module {latch.name.lower()} $end")
            lines += [
                f"$var wire 1 {_code(latch, coil)} {name} $end" for coil, name in enumerate(_COILS)
            ]
            lines.append("$upscope $end")
        lines += ["$upscope $end", "$enddefinitions $end", f"#{self._now}", "$dumpvars"]
        for place, nibble in enumerate(latches):
            lines += _values(place, nibble, 0b1111)
        lines.append("$end")
        self._put(lines)

    def write(self, times: Series, latches: Series, nibbles: Series) -> None:
        """Add the changes that these writes make."""
        lines: list[str] = []
        for time, latch, nibble in zip(times, latches, nibbles, strict=True):
            changed = self._held[latch] ^ int(nibble)
            if changed:
                self._held[latch] = int(nibble)
                lines += self._moment(int(time))
                lines += _values(latch, int(nibble), changed)
        self._put(lines)

    def finish(self, time: int) -> None:
        """Let the last values last until a T-state."""
        self._put(self._moment(time))

    def _moment(self, time: int) -> list[str]:
        now = nanoseconds(time)
        if now <= self._now:
            return []
        self._now = now
        return [f"#{now}"]

    def _put(self, lines: list[str]) -> None:
        self._file.writelines(f"{line}\n".encode("ascii") for line in lines)


def _code(latch: int, coil: int) -> str:
    return chr(_FIRST_CODE + 4 * latch + coil)


def _values(latch: int, nibble: int, coils: int) -> list[str]:
    """The value lines of those coils of a latch whose bit is set in `coils`."""
    return [
        f"{nibble >> 3 - coil & 1}{_code(latch, coil)}"
        for coil in range(4)
        if coils >> 3 - coil & 1
    ]
