"""The ARMBASIC driver in Z-80 code as it stands in the memory of a machine with a ROM of its own.

Where a user's own ROM runs the machine ARMBASIC is what it was in 1980: machine code at the end of
memory, `machine/z80/armbasic.asm`. Here it is put there when the machine is switched on, and known
again by whoever looks on. The offsets are those of its source; a test holds them to it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

from trs80arm import bundled
from trs80arm.basic.addresses import word
from trs80arm.machine import cassette
from trs80arm.machine.card import MOTORS, CardSettings, Jumper
from trs80arm.machine.driver import Counts, wrapped
from trs80arm.machine.half_steps import HALF_STEPS, RING
from trs80arm.machine.memory import Memory

ORIGINS: Final = {16: 31200, 32: 47584, 48: 63968}
"""By K of RAM, where the driver begins: as high as it goes, at a multiple of 32."""
MANUAL: Final = 9
"""Its entry for `@SET`."""
RESET_DONE: Final = 1147
"""The return of its `@RESET`."""
_PORT, _SWITCH, _CLOSED, _RING = 39, 40, 41, 64
"""What is made for a card: the port of J1; the switch's bit; that bit when closed; Figure 8."""
_COUNTS, _ZEROS = 88, 100
"""Half-steps that the six motors have made, and those of them that were made before `@RESET`."""
_ELBOW, _HAND = 2, 5


class DriverError(ValueError):
    """There is no driver for such a machine; one clear sentence."""


def check(ram_kib: int, card: CardSettings) -> None:
    """See that there is a driver for a machine.

    Raises:
        DriverError: it has too little memory, its card is wired in a way that it cannot drive, or
            the tape is not here.
    """
    if ram_kib not in ORIGINS:
        raise DriverError(
            f"with a ROM of its own the machine needs 16 K of RAM for ARMBASIC, not {ram_kib}; "
            "it goes with --no-armbasic"
        )
    if card.jumper is not Jumper.TRS80 or card.order[: len(MOTORS)] != MOTORS:
        raise DriverError(
            "with a ROM of its own the machine's ARMBASIC drives a card on the bus whose latches "
            "J1 to J6 are at six ports one behind the other; it goes with --no-armbasic"
        )
    if not _tape(ram_kib).is_file():
        raise DriverError(f"ARMBASIC for a ROM of one's own is not here: {_tape(ram_kib)}")


def _tape(ram_kib: int) -> Path:
    return bundled.along(f"armbasic-{ram_kib}k.cas")


def put_in(memory: Memory, ram_kib: int, card: CardSettings) -> int:
    """Put the driver where its tape would have, made for a card.

    Returns:
        The address that starts it, for SYSTEM.
    """
    (recording,) = cassette.parse(_tape(ram_kib).read_bytes())
    assert isinstance(recording, cassette.SystemRecording)
    for address, block in recording.blocks:
        memory.write(address, block)
    origin = ORIGINS[ram_kib]
    switch = 1 << card.switch_bit
    for offset, value in (
        (_PORT, card.base),
        (_SWITCH, switch),
        (_CLOSED, switch * card.switch_closed),
        *enumerate(map(card.data, HALF_STEPS), _RING),
    ):
        memory.poke(origin + offset, value)
    return recording.entry


def origin(ram: bytearray, card: CardSettings) -> int | None:
    """Where in memory the driver stands, known by its Figure 8; None where there is none."""
    figure = bytes(map(card.data, HALF_STEPS))
    for place in ORIGINS.values():
        if ram[place + _RING : place + _RING + RING] == figure:
            return place
    return None


def registers(memory: Memory, place: int) -> Counts:
    """The position registers of the driver that begins at an address, as its `@READ` gives them."""
    counts = [
        word(memory.ram, place + _COUNTS + 2 * motor) - word(memory.ram, place + _ZEROS + 2 * motor)
        for motor in range(len(MOTORS))
    ]
    counts[_HAND] += counts[_ELBOW]
    j1, j2, j3, j4, j5, j6 = map(wrapped, counts)
    return j1, j2, j3, j4, j5, j6


def zero(memory: Memory, place: int) -> None:
    """The registers of the driver that begins at an address are zero, as behind its `@RESET`."""
    memory.write(place + _ZEROS, memory.read(place + _COUNTS, _ZEROS - _COUNTS))
