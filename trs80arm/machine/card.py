"""The Mini Mover 5's interface card: seven 4-bit output latches and one 4-bit input, by address.

The article's Figure 9. OUT and INP of BASIC and the ARMBASIC driver reach the same latches; the
cable to the arm hangs on the card's plug, and a logic analyser can be clipped on from outside.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, IntEnum
from functools import cache
from typing import Any, NamedTuple, Protocol

from trs80arm.machine.clock import Clock
from trs80arm.pulses import Burst, Columns, Series


class Latch(IntEnum):
    """The card's seven output latches, in the order of the commands' joints."""

    BASE = 0
    SHOULDER = 1
    ELBOW = 2
    LEFT_WRIST = 3
    RIGHT_WRIST = 4
    HAND = 5
    AUXILIARY = 6


MOTORS: tuple[Latch, ...] = tuple(Latch)[:6]
"""The latches that hold the coils of J1 to J6."""


class Jumper(Enum):
    """The two settings of the card's internal jumpers (article, Computer Interface)."""

    TRS80 = "trs80"
    """On the TRS-80's bus: the address selects the latch."""
    PARALLEL = "parallel"
    """On an 8-bit parallel port: the high nibble of the byte selects the latch."""


@cache
def _coils_of(coil_bits: tuple[int, int, int, int]) -> tuple[int, ...]:
    """The coil pattern that each value of the low four data bits switches on."""
    return tuple(
        sum((data >> bit & 1) << 3 - coil for coil, bit in enumerate(coil_bits))
        for data in range(16)
    )


@dataclass(frozen=True)
class CardSettings:
    """How the card is wired; every default is a choice where the record is silent.

    Attributes:
        jumper: bus or parallel port.
        base: the first I/O port; 98H is the address of the Robko 01, whose bus is the nearest
            relative known (arm facts, section 2).
        order: the latch at each of the eight addresses, None where nothing is connected.
        coil_bits: the data bit that drives phi1, phi2, phi3, phi4.
        switch_bit: the data bit on which the grip switch is read; the sensor input that would have
            been there is read on bit 0.
        switch_closed: the level, 0 or 1, of that bit when the switch is closed.
    """

    jumper: Jumper = Jumper.TRS80
    base: int = 0x98
    order: tuple[Latch | None, ...] = (*Latch, None)
    coil_bits: tuple[int, int, int, int] = (3, 2, 1, 0)
    switch_bit: int = 0
    switch_closed: int = 0

    def __post_init__(self) -> None:
        if not 0 <= self.base <= 0xFF - self.addresses:
            raise ValueError(f"card base port {self.base} leaves no room below the cassette's 255")
        if len(self.order) != 8:
            raise ValueError("the card's port order must name eight addresses")
        if sorted(self.coil_bits) != [0, 1, 2, 3]:
            raise ValueError("the card's coil bits must be 0 to 3 in some order")
        if not 0 <= self.switch_bit <= 3 or self.switch_closed not in (0, 1):
            raise ValueError("the grip switch is on bit 0 to 3 and its closed level is 0 or 1")

    @property
    def addresses(self) -> int:
        """How many ports the card answers."""
        return 8 if self.jumper is Jumper.TRS80 else 1

    def coils(self, data: int) -> int:
        """The coil pattern, phi1 as bit 3, that the low four data bits switch on."""
        return _coils_of(self.coil_bits)[data & 15]

    def data(self, coils: int) -> int:
        """The four data bits that switch on a coil pattern; the inverse of `coils`."""
        return sum((coils >> 3 - coil & 1) << bit for coil, bit in enumerate(self.coil_bits))

    def inputs(self, plug: int) -> int:
        """The four data bits of the input port for the nibble at the plug."""
        switch = (plug & 1) ^ self.switch_closed
        others = plug & 0b1110 & ~(1 << self.switch_bit)
        if self.switch_bit == 0:
            return others | switch
        return others | switch << self.switch_bit | (plug >> self.switch_bit & 1)


class InputStop(NamedTuple):
    """A burst's stop condition: it ends where `inputs & mask == value` first holds after a write.

    The writes of one T-state are one instant and are all done. The bits are those of the plug: bit
    0 is the grip switch, 0 when closed.
    """

    mask: int
    value: int


GRIP_CLOSED = InputStop(mask=1, value=0)
"""Stop where the grip switch closes."""


class Peripheral(Protocol):
    """Whatever is plugged into the card: the arm."""

    def follow(self, burst: Burst, stop: tuple[int, int] | None = None) -> int:
        """Follow a burst of latch writes in order.

        Args:
            burst: the writes, not before those of the burst before; latches are `Latch`, nibbles
                coils with phi1 as bit 3.
            stop: mask and value; the burst ends with the last write of the first T-state after
                which the input nibble under the mask has the value.

        Returns:
            How many writes were done; all of them unless it was stopped.
        """

    def inputs(self, time: int) -> int:
        """The input nibble at a T-state: bit 0 the grip switch, 0 closed; bits 1 to 3 free."""


class NothingPlugged:
    """The card without a cable: nobody follows, and the inputs float high."""

    def follow(self, burst: Burst, stop: tuple[int, int] | None = None) -> int:
        """Do nothing at all, to the end of the burst."""
        return len(burst)

    def inputs(self, time: int) -> int:
        """All ones: the grip switch open, the sensors idle."""
        return 0b1111


class Observer(Protocol):
    """A logic analyser on the latches; it sees every write and changes nothing."""

    each_step: bool
    """Whether it must look at the arm after every instant of a burst, not only after the burst."""

    def wrote(self, times: Series, latches: Series, nibbles: Series) -> None:
        """These writes have just been done, and the arm has followed them."""


class Card:
    """The card in its slot.

    Attributes:
        settings: how it is wired.
        plug: what hangs on the cable.
        latches: the seven nibbles held, phi1 as bit 3: always what was last written.
        observers: the analysers clipped on; they are not part of a snapshot.
    """

    def __init__(
        self, clock: Clock, settings: CardSettings | None = None, plug: Peripheral | None = None
    ) -> None:
        self.settings = settings or CardSettings()
        self.plug: Peripheral = plug or NothingPlugged()
        self.latches = [0] * len(Latch)
        self.observers: list[Observer] = []
        self._clock = clock

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "observers": []}

    def owns(self, port: int) -> bool:
        """Whether an I/O port, 0 to 255, is one of the card's."""
        return 0 <= port - self.settings.base < self.settings.addresses

    def read(self, port: int) -> int:
        """INP: the input nibble below four ones, at every port of the card alike.

        Nothing drives the upper four lines, and an undriven TRS-80 bus reads as ones.
        """
        return 0xF0 | self.settings.inputs(self.plug.inputs(self._clock.now))

    def write(self, port: int, value: int) -> None:
        """OUT: the low nibble into the latch that the address selects.

        On the parallel jumper the high nibble selects it instead. Selecting nothing does nothing.
        """
        parallel = self.settings.jumper is Jumper.PARALLEL
        place = value >> 4 if parallel else port - self.settings.base
        latch = self.settings.order[place] if place < len(self.settings.order) else None
        if latch is not None:
            self.write_latch(latch, self.settings.coils(value))

    def write_latch(self, latch: Latch, coils: int) -> None:
        """Write one latch now; `coils` has phi1 as bit 3."""
        self.burst(Columns((self._clock.now,), (latch,), (coils,)))

    def grip_closed(self, time: int) -> bool:
        """Whether the grip switch is closed at a T-state."""
        return self.plug.inputs(time) & GRIP_CLOSED.mask == GRIP_CLOSED.value

    def burst(self, burst: Burst, stop: tuple[int, int] | None = None) -> int:
        """Send many writes through the card at once; a single OUT is a burst of one.

        Args and result are those of `Peripheral.follow`. An observer that looks at each step sees
        the arm after all writes of one T-state.
        """
        if not len(burst):
            return 0
        if not self.observers or not any(observer.each_step for observer in self.observers):
            return self._send(burst, stop)
        rest = burst.columns()
        times, begin, total = rest.times, 0, len(burst)
        while begin < total:
            end = begin + 1
            while end < total and times[end] == times[begin]:
                end += 1
            instant, rest = rest.split(end - begin)
            self._send(instant, None)
            begin = end
            if stop and self.plug.inputs(instant.ends) & stop[0] == stop[1]:
                break
        return begin

    def _send(self, burst: Burst, stop: tuple[int, int] | None) -> int:
        done = self.plug.follow(burst, stop)
        if done < len(burst):
            burst = burst.split(done)[0]
        for latch, nibble in burst.held():
            self.latches[latch] = int(nibble)
        if self.observers:
            writes = burst.columns()
            for observer in self.observers:
                observer.wrote(writes.times, writes.latches, writes.nibbles)
        return done
