"""The Z-80 on the machine's bus: it runs code in memory until a T-state, or up to a marked address.

It sees what PEEK, POKE, INP and OUT see, at the T-state of each access: keyboard, video memory,
printer, ports, the card. RAM is copied into the chip's own memory for a run and back after it,
which takes a microsecond or two; only addresses at which somebody answers are asked for one by one.
Who runs it (`basic`, or the machine with a user's ROM) says which addresses are to stop it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final, Protocol

from trs80arm.machine.clock import Clock
from trs80arm.machine.keyboard import Matrix
from trs80arm.machine.keys import KEYBOARD_START, KEYBOARD_STOP
from trs80arm.machine.memory import ADDRESSES, EMPTY, RAM_START, Memory
from trs80arm.machine.ports import Ports
from trs80arm.machine.video import VIDEO_START, VIDEO_STOP, Video
from trs80arm.machine.z80 import chip as z80
from trs80arm.machine.z80.registers import FRAME_TICK, TICKS_TO_STOP, Registers

if TYPE_CHECKING:
    from z80 import Z80Machine

LONGEST: Final = 65_536
"""T-states of one run of the chip at most: its own count of them goes to 100,000."""
BREAK_ROW: Final = 0b0100_0000
"""The row of the matrix with BREAK in it, as the low byte of an address selects it."""
_DEVICES_START: Final = 0x3000
"""Behind the ROM: the printer, the keyboard, and what nothing answers at."""
_KEYBOARDS: Final = (KEYBOARD_STOP - KEYBOARD_START) // 256
"""How often the matrix is seen."""
_BREAKPOINT, _READ, _WRITE = 1, 2, 4


class Stops(Protocol):
    """Who may stop code before an instruction: a debugger. True while there is anybody."""

    def __bool__(self) -> bool:
        """Whether anybody is to be asked."""

    def before(self, address: int) -> bool:
        """Whether code is to stop before the instruction at an address."""


class Processor:
    """The Z-80 of one machine.

    Attributes:
        registers: its registers by name.
        stops: who may stop code before an instruction; not part of a snapshot.
        looked: the T-state at which code last looked at the keyboard row that BREAK is in, while
            somebody wants to know (`without_rom`).
    """

    def __init__(
        self, clock: Clock, memory: Memory, matrix: Matrix, video: Video, ports: Ports
    ) -> None:
        self.looked = 0
        self._clock = clock
        self._memory = memory
        self._matrix = matrix
        self._video = video
        self._ports = ports
        self._begin()

    def _begin(self) -> None:
        """Have registers, and no chip yet."""
        self.registers = Registers()
        self.stops: Stops | None = None
        self._live: tuple[tuple[int, int], ...] = ()
        self._keys: bytes | None = None
        self._guarded = False
        self._jumps: Mapping[int, int] = {}
        self._jump_takes = 0
        self._told = False
        self._start = 0
        self._chip: Z80Machine | None = None
        self._head: memoryview = memoryview(b"")
        self._bytes: memoryview = memoryview(b"")

    def __getstate__(self) -> dict[str, Any]:
        made_anew = {
            "stops",
            "registers",
            "_chip",
            "_head",
            "_bytes",
            "_live",
            "_keys",
            "_start",
            "_guarded",
            "_jumps",
            "_jump_takes",
            "_told",
        }
        kept = {name: value for name, value in self.__dict__.items() if name not in made_anew}
        return kept | {"_registers": self.registers.content()}

    def __setstate__(self, state: dict[str, Any]) -> None:
        head = bytes(state.pop("_registers"))
        if len(head) != z80.HEAD:
            raise ValueError("the registers of another processor")
        if "registers" not in self.__dict__:
            self._begin()
        self.__dict__.update(state)
        self.registers.head[:] = head

    # -- the chip -----------------------------------------------------------------------------

    @property
    def missing(self) -> str:
        """Why there is no chip to run code on, in one line; empty where there is."""
        return "" if z80.available() else z80.NOT_INSTALLED

    def power_on(self) -> None:
        """Have a chip.

        Raises:
            NoProcessorError: the package is not installed.
        """
        if self._chip is None:
            self._chip, state = z80.new_chip()
            self._head, self._bytes = state[: z80.HEAD], state[z80.HEAD :]
            self._head[:] = self.registers.head
            self.registers.head = self._head
            # What is no RAM takes no byte as it comes; beyond the ROM devices answer.
            self._chip.mark_addrs(0, RAM_START, _WRITE)
            top = self._memory.top
            self._chip.mark_addrs(top, ADDRESSES - top, _WRITE)
            self._bytes[top:] = self._memory.ram[top:]
            self._chip.mark_addrs(_DEVICES_START, KEYBOARD_START - _DEVICES_START, _READ)

    def read_only(self, content: bytes) -> None:
        """Put a ROM at the address 0."""
        self.power_on()
        self._bytes[: len(content)] = content

    def stop_at(self, start: int, length: int = 1) -> None:
        """Have `run` return when the program counter comes to one of these addresses."""
        self.power_on()
        assert self._chip is not None
        self._chip.mark_addrs(start, length, _BREAKPOINT)

    def pass_by(self, start: int, length: int = 1) -> None:
        """Do not stop at these addresses any more."""
        self.power_on()
        assert self._chip is not None
        self._chip.unmark_addrs(start, length, _BREAKPOINT)

    def without_rom(self, jumps: Mapping[int, int], t_states: int) -> None:
        """Have `run` return where code comes to the ROM, and note when it looks for BREAK.

        Args:
            jumps: addresses of the ROM from which code only goes on elsewhere, and where: `run`
                need not return there.
            t_states: that such a jump takes.
        """
        self._jumps, self._jump_takes = jumps, t_states
        if not self._guarded:
            self.stop_at(0, _DEVICES_START)
            assert self._chip is not None
            self._chip.mark_addrs(KEYBOARD_START, KEYBOARD_STOP - KEYBOARD_START, _READ)
            self._bytes[:_DEVICES_START] = bytes((EMPTY,)) * _DEVICES_START
            self._guarded = True

    def answer_live(self, *ranges: tuple[int, int]) -> None:
        """Let the memory map answer at these ranges of RAM, byte by byte, and at no others.

        There are owners of RAM whose bytes are something else meanwhile: variables that are
        Python values. Each range is its first address and the one behind it.
        """
        self.power_on()
        if ranges != self._live:
            assert self._chip is not None
            for start, stop in self._live:
                self._chip.unmark_addrs(start, stop - start, _READ | _WRITE)
            for start, stop in ranges:
                self._chip.mark_addrs(start, stop - start, _READ | _WRITE)
            self._live = ranges

    # -- running ------------------------------------------------------------------------------

    def run(self, until: int) -> bool:
        """Execute instructions up to the first one that ends at `until` or later.

        The clock then stands where it ended.

        Args:
            until: a T-state.

        Returns:
            Whether it came to an address of `stop_at` before; its instruction is not executed.
            Where somebody of `stops` has it stop, nothing is left of the clock's time.
        """
        return self._run(until, self.stops)

    def _run(self, until: int, stops: Stops | None) -> bool:
        self.power_on()
        clock, chip = self._clock, self._chip
        assert chip is not None
        self._told = False
        self._copy_in()
        # The chip holds what calls it back where nothing collects it: no longer than it runs.
        chip.set_read_callback(self._read)
        chip.set_write_callback(self._write)
        chip.set_input_callback(self._input)
        chip.set_output_callback(self._output)
        head = self._head
        try:
            while clock.now < until:
                self._start = clock.now
                longest = LONGEST
                if stops:
                    if stops.before(self.registers.pc):
                        # Whoever turns the wheel finds that there is no more time.
                        clock.limit = clock.now
                        return False
                    longest = 1
                head[FRAME_TICK] = b"\0\0\0\0"
                head[TICKS_TO_STOP] = min(until - clock.now, longest).to_bytes(4, "little")
                stopped = chip.run() & _BREAKPOINT
                clock.now = self._start + self._passed
                if stopped:
                    target = self._jumps.get(self.registers.pc)
                    # What has been stored where somebody answers may be of consequence.
                    if target is None or self._told or clock.now >= until:
                        return True
                    self.registers.pc = target
                    clock.now += self._jump_takes
            return False
        finally:
            for forget in (chip.set_read_callback, chip.set_input_callback):
                forget(int)
            for forget_pair in (chip.set_write_callback, chip.set_output_callback):
                forget_pair(divmod)  # type: ignore[arg-type]
            self._copy_out()

    def step(self) -> None:
        """Execute one instruction, at an address of `stop_at` too."""
        self.power_on()
        assert self._chip is not None
        pc = self.registers.pc
        self._chip.unmark_addrs(pc, 1, _BREAKPOINT)
        try:
            # Whether to stop here was asked when it came here.
            self._run(self._clock.now + 1, None)
        finally:
            self._chip.mark_addrs(pc, 1, _BREAKPOINT)

    def interrupt(self) -> None:
        """Pull the non-maskable interrupt, as the reset button does: on to 0066H."""
        registers = self.registers
        registers.settle()
        self.push(registers.pc)
        registers.pc = 0x0066
        self._clock.now += 11

    # -- the stack, for whoever answers a call ------------------------------------------------

    def push(self, word: int) -> None:
        """Put a word on the stack."""
        registers, memory = self.registers, self._memory
        registers.sp = sp = registers.sp - 2 & 0xFFFF
        memory.poke(sp, word & 0xFF)
        memory.poke(sp + 1 & 0xFFFF, word >> 8)

    def peek_word(self, address: int) -> int:
        """A word of memory, low byte first."""
        memory = self._memory
        return memory.peek(address & 0xFFFF) | memory.peek(address + 1 & 0xFFFF) << 8

    def pop(self) -> int:
        """Take a word from the stack."""
        registers = self.registers
        word = self.peek_word(registers.sp)
        registers.sp = registers.sp + 2 & 0xFFFF
        return word

    # -- the bus ------------------------------------------------------------------------------

    @property
    def _passed(self) -> int:
        return int.from_bytes(self._head[FRAME_TICK], "little")

    def _copy_in(self) -> None:
        top = self._memory.top
        self._bytes[RAM_START:top] = memoryview(self._memory.ram)[RAM_START:top]
        self._bytes[VIDEO_START:VIDEO_STOP] = self._video.cells
        # No key changes while the chip runs.
        keys = self._matrix.rows
        if keys != self._keys:
            self._keys = keys
            rows = bytes(self._matrix.read(KEYBOARD_START + select) for select in range(256))
            self._bytes[KEYBOARD_START:KEYBOARD_STOP] = rows * _KEYBOARDS

    def _copy_out(self) -> None:
        top = self._memory.top
        memoryview(self._memory.ram)[RAM_START:top] = self._bytes[RAM_START:top]

    def _read(self, address: int) -> int:
        if KEYBOARD_START <= address < KEYBOARD_STOP and address & BREAK_ROW:
            self.looked = self._start + self._passed
        return self._memory.peek(address)

    def _write(self, address: int, value: int) -> None:
        if address < RAM_START or address >= self._memory.top:
            self._memory.poke(address, value)
            if VIDEO_START <= address < VIDEO_STOP:
                self._bytes[address] = self._video.cells[address - VIDEO_START]
            return
        self._told = True
        self._memory.poke(address, value)
        # What lies there in RAM is what is copied back.
        self._bytes[address] = self._memory.ram[address]

    def _input(self, port: int) -> int:
        self._clock.now = self._start + self._passed
        return self._ports.read(port & 0xFF)

    def _output(self, port: int, value: int) -> None:
        self._clock.now = self._start + self._passed
        self._ports.write(port & 0xFF, value)
