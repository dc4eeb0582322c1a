"""What the language asks of the machine it runs on: small protocols, met by structural typing.

The language never imports a device. The rig hands it one `Host`, the devices of one TRS-80; tests
hand it plain stand-ins. Every method returns at once: what takes time on the real machine moves
`Clock.now` on, or is an activity that is carried on later (`ArmCommands.advance`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from trs80arm.progress import Progress as Progress


class Clock(Protocol):
    """Virtual time in T-states of the Z-80, 1,774,080 a second."""

    now: int
    """T-states since power-on. A statement adds its cost."""
    limit: int
    """The interpreter leaves its loop at the first statement boundary at which `now >= limit`."""


class Region(Protocol):
    """The owner of a range of addresses."""

    def peek(self, address: int) -> int:
        """The byte at a 16-bit address of the range."""

    def poke(self, address: int, value: int) -> None:
        """Store a byte at a 16-bit address of the range."""


class Memory(Protocol):
    """The memory map of 64K addresses."""

    ram: bytearray
    """65536 bytes, never more or fewer: the storage behind every address that no region claims."""
    view: memoryview
    """The same storage."""
    top: int
    """The first address without RAM: 8000H on a 16K machine."""

    def peek(self, address: int) -> int:
        """The byte that the Z-80 would read at an address, 0 to 65535."""

    def poke(self, address: int, value: int) -> None:
        """Store a byte as the Z-80 would; ROM and empty addresses ignore it."""

    def read(self, address: int, length: int) -> bytes:
        """The bytes that the Z-80 would read from an address on, around the end of memory.

        Within RAM they are those of the storage; regions there are not asked.
        """

    def write(self, address: int, data: bytes) -> None:
        """Store bytes as the Z-80 would from an address on, likewise."""

    def attach(self, start: int, stop: int, region: Region) -> None:
        """Let `region` answer for `start <= address < stop` from now on."""


class Console(Protocol):
    """The ROM's display and keyboard drivers."""

    def put(self, code: int) -> None:
        """Print one character or control code at the cursor, and charge its time."""

    def echo(self, code: int) -> None:
        """The same, for what the line editor and EDIT echo of the user's own typing."""

    def scan(self) -> int:
        """Look at the keyboard once, as the ROM does: the code of one key newly down, or 0.

        A key accepted costs the debounce pause.
        """

    @property
    def quiet(self) -> bool:
        """Whether `scan` would return 0 and change nothing until the next key event."""

    @property
    def cursor(self) -> int:
        """The text cursor, 0 to 1023."""

    @cursor.setter
    def cursor(self, position: int) -> None: ...

    @property
    def column(self) -> int:
        """The cursor's column as PRINT, TAB and POS count it, 0 to 63."""

    def show_cursor(self, on: bool) -> None:
        """Switch the `_` at the cursor on or off (codes 14 and 15)."""

    def point(self, x: int, y: int) -> bool:
        """Whether the graphics block x 0..127, y 0..47 is lit (POINT)."""

    def plot(self, x: int, y: int, lit: bool) -> None:
        """Light or clear a graphics block (SET and RESET)."""


class Printer(Protocol):
    """The line printer."""

    def put(self, code: int) -> None:
        """Send one character."""


class Ports(Protocol):
    """The Z-80's 256 I/O ports, the interface card among them."""

    def read(self, port: int) -> int:
        """INP: the byte at a port, 255 where nothing answers."""

    def write(self, port: int, value: int) -> None:
        """OUT: send a byte to a port."""


class Tape(Protocol):
    """The cassette recorder, byte by byte at the ROM's 500 baud.

    The language writes leader, sync byte and data itself, as the ROM does, and charges the time.
    """

    def start_writing(self) -> None:
        """Switch the motor on to record at the end of what is there."""

    def write(self, value: int) -> None:
        """Record one byte."""

    def start_reading(self) -> None:
        """Switch the motor on to play from where the tape stands."""

    def find_sync(self) -> bool:
        """Play up to and including the next sync byte A5H; False at the end of the tape."""

    def read(self) -> int | None:
        """Play one byte; None when the tape has run out."""

    def stop(self) -> None:
        """Switch the motor off; a recording is now on the tape."""


class ArmCommands(Protocol):
    """The driver behind the five ARMBASIC statements.

    The language evaluates and checks the arguments. `step`, `close` and `set` only begin a motion;
    the language then calls `advance` until it is DONE or the operator pressed BREAK.
    """

    def step(self, delay: int, steps: Sequence[int]) -> None:
        """`@STEP D,J1..J6`: begin a coordinated move of six relative counts."""

    def close(self, delay: int | None) -> None:
        """`@CLOSE [D]`: begin to close the hand until the grip switch closes."""

    def set(self, delay: int | None) -> None:
        """`@SET [D]`: begin manual mode."""

    def reset(self) -> None:
        """`@RESET`: registers to zero, all six motors off."""

    def read(self) -> tuple[int, int, int, int, int, int]:
        """`@READ`: the six position registers."""

    def advance(self) -> Progress:
        """Carry on with the motion until it ends or `Clock.now` reaches `Clock.limit`."""


class Registers(Protocol):
    """The registers of the Z-80 that ROM routines take and give; numbers of 8 and 16 bits."""

    a: int
    b: int
    c: int
    bc: int
    de: int
    hl: int
    sp: int
    pc: int

    def settle(self) -> None:
        """Between two instructions, not halted, interrupts off."""

    @property
    def halted(self) -> bool:
        """Whether the processor has executed a HALT."""

    def flags(self, *, carry: bool = False, zero: bool = False, sign: bool = False) -> None:
        """Set these flags, the others 0."""


class Processor(Protocol):
    """The Z-80 beside BASIC: it executes machine code in RAM, on the machine's own bus.

    The ROM is not there. Code that comes to an address of it is stopped there, and BASIC answers.
    """

    @property
    def registers(self) -> Registers:
        """Its registers."""

    looked: int
    """The T-state at which code last looked at the keyboard row that BREAK is in."""

    @property
    def missing(self) -> str:
        """Why there is none, in one line; empty where there is."""

    def without_rom(self, jumps: Mapping[int, int], t_states: int) -> None:
        """Have `run` return where code comes to the ROM, and note when it looks for BREAK.

        Args:
            jumps: addresses of the ROM from which code only goes on elsewhere, and where: `run`
                need not return there.
            t_states: that such a jump takes.
        """

    def answer_live(self, *ranges: tuple[int, int]) -> None:
        """Let the memory map answer at these ranges of RAM, and not the storage behind it."""

    def run(self, until: int) -> bool:
        """Execute instructions up to the first one that ends at a T-state or later.

        Returns:
            Whether it came to an address of the ROM before.
        """

    def push(self, word: int) -> None:
        """Put a word on the stack."""

    def pop(self) -> int:
        """Take a word from the stack."""

    def peek_word(self, address: int) -> int:
        """A word of memory, low byte first."""


@dataclass
class Host:
    """One machine, as the language sees it."""

    clock: Clock
    memory: Memory
    console: Console
    printer: Printer
    ports: Ports
    tape: Tape
    arm: ArmCommands | None
    """None on a machine without ARMBASIC, where `@` words are ?SN."""
    processor: Processor | None = None
    """None where machine code is none of BASIC's affair."""
