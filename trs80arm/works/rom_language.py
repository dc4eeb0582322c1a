"""The whole machine on its processor, with a user's own ROM: what stands in BASIC's place then.

It has what `Interpreter` has for whoever looks on. What the ROM is doing is read from where its
program counter comes by: a few addresses of the ROM, and what its stack and its variables in low
RAM say there. Nothing is changed by looking, not even a T-state.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, Final

from trs80arm.basic.activity import Waiting
from trs80arm.basic.addresses import PROGRAM_END, set_word, word
from trs80arm.basic.code import CompiledCode
from trs80arm.basic.control import DIRECT
from trs80arm.basic.errors import Code
from trs80arm.basic.host import Host
from trs80arm.basic.outcome import Ending, Outcome
from trs80arm.basic.program import LINE_HEAD, Program
from trs80arm.basic.state import Home, Listener, State, Stops
from trs80arm.machine.card import CardSettings
from trs80arm.machine.cassette import encode_lines
from trs80arm.machine.console import Console
from trs80arm.machine.keyboard import Matrix
from trs80arm.machine.keys import Key
from trs80arm.machine.z80.processor import Processor
from trs80arm.machine.z80.rom import Rom
from trs80arm.works import rom_driver, rom_variables

# Where the ROM comes by. It waits for a key in two loops: of the line editor and of everybody else
# who calls 0049H; of EDIT and of the pause.
_WAIT, _WAIT_ENDS = 0x0049, 0x004D
_WAIT_EDIT, _WAIT_EDIT_ENDS = 0x0384, 0x0388
_DISPLAY: Final = 0x0033
_STATEMENT: Final = 0x1D5A
"""A statement begins; HL is at what stands in front of it."""
_MESSAGE, _BREAK_MESSAGE = 0x1A06, 0x1930
"""A message with a line number, and the text of `Break` that HL then points at."""
_READY: Final = 0x1A19
_ERROR: Final = 0x41A6
"""In RAM: the exit for Disk BASIC that every error comes by that is not trapped."""
_ORIGINS: Final = tuple(rom_driver.ORIGINS.values())
"""Where the Z-80 driver of ARMBASIC may stand."""
_MANUAL: Final = tuple(origin + rom_driver.MANUAL for origin in _ORIGINS)
"""Its entry for `@SET`."""
_RESET_DONE: Final = tuple(origin + rom_driver.RESET_DONE for origin in _ORIGINS)
"""Where its `@RESET` returns."""
_SCAN: Final = 0x002B
"""Where the keyboard is scanned; an `@SET` that has ended comes by there."""
_MARKS = (
    _WAIT,
    _WAIT_ENDS,
    _WAIT_EDIT,
    _WAIT_EDIT_ENDS,
    _DISPLAY,
    _MESSAGE,
    _READY,
    _ERROR,
    *_MANUAL,
    *_RESET_DONE,
)
# What the stack holds at 0049H when a line is typed, from its top on.
_IN_LINE_EDITOR, _IN_LINE_INPUT = 0x05E3, 0x0374
_IN_AUTO: Final = 0x1A57
_PAUSED: Final = 0x1DA5
_PRINTED_BY_BASIC: Final = range(0x032A, 0x0348)
"""Where PRINT's own output routine calls the display from; everybody else echoes."""
_STRING_SPACE: Final = 0x40A0
_ROOM: Final = 200
"""Bytes that a program leaves free for the stack at least."""
_LINE_NUMBER, _ERROR_CODE, _ERROR_LINE = 0x40A2, 0x409A, 0x40EA
_HALT_LOOK: Final = 65_536
"""T-states after which it is looked whether the processor has halted."""


class RomLanguage:
    """The machine as its ROM runs it.

    Attributes:
        outcome: how the last program, or direct line, ended; None while one runs.
        waiting: what the machine waits for.
        wait_began: the T-state at which it last began to wait for a key.
        key_taken: the T-state at which the ROM last took a key that it had waited for.
        listeners: watchers of statements; they are not part of a snapshot.
        stops: who may stop a program before a statement; not part of a snapshot either.
        reset_observers: called after each `@RESET` of the driver in memory; nor are they.
    """

    def __init__(
        self,
        host: Host,
        processor: Processor,
        matrix: Matrix,
        console: Console,
        rom: Rom,
        card: CardSettings,
    ) -> None:
        self._host = host
        self._processor = processor
        self._matrix = matrix
        self._console = console
        self._rom = rom
        self._card = card
        self.outcome: Outcome | None = None
        self.waiting = Waiting.NOTHING
        self.wait_began = 0
        self.key_taken = 0
        self.listeners: list[Listener] = []
        self.stops = Stops()
        self.reset_observers: list[Callable[[], None]] = []
        self._pending: Outcome | None = None
        self._before: Outcome | None = None
        self._idle: bytes | None = None
        """The keyboard as it was when the ROM last found no key and began its waiting loop anew."""
        self._passed = 0
        """The mark that the program counter stands at and that was seen already, plus one."""
        self._prepare()
        processor.registers.settle()
        processor.registers.pc = 0

    def _prepare(self) -> None:
        self._program = Program(self._host.memory)
        self._shadow: State | None = None
        self._seen = -1
        processor = self._processor
        processor.read_only(self._rom.content)
        for address in _MARKS:
            processor.stop_at(address)
        self._watched = False

    def __getstate__(self) -> dict[str, Any]:
        made_anew = {"_program", "_shadow", "_seen", "_watched", "stops"}
        kept = {name: value for name, value in self.__dict__.items() if name not in made_anew}
        return kept | {"listeners": [], "reset_observers": []}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._seen = -1

    # -- what a rig looks at ------------------------------------------------------------------

    @property
    def program(self) -> Program:
        """The lines in memory."""
        self._look()
        return self._program

    @property
    def state(self) -> State:
        """The variables as they stand in memory, for whoever looks at them."""
        self._look()
        if self._shadow is None:
            self._shadow = State(self._host, CompiledCode, armbasic=False, blocks=False)
            self._shadow.stack.append(Home())
            rom_variables.read(self._shadow)
        return self._shadow

    def _look(self) -> None:
        """What was read from memory before time went on is read again."""
        now = self._host.clock.now
        if now != self._seen:
            self._seen = now
            self._program.changed()
            self._shadow = None

    @property
    def running(self) -> bool:
        """Whether a program or a direct line is under way."""
        return self.outcome is None and self.waiting not in (
            Waiting.COMMAND,
            Waiting.AUTO,
            Waiting.MEMORY_SIZE,
        )

    @property
    def line(self) -> int | None:
        """The number of the line that is being executed; None when no program runs."""
        number = word(self._host.memory.ram, _LINE_NUMBER)
        return number if self.running and number != DIRECT else None

    @property
    def next_line(self) -> int | None:
        """The number of the line that is executed next, as far as the ROM knows."""
        return self.line

    @property
    def next_address(self) -> int | None:
        """The separator in front of the statement that is under way; None when none runs."""
        return word(self._host.memory.ram, 0x40E6) if self.running else None

    # -- the wheel ----------------------------------------------------------------------------

    def advance(self, until_waiting: bool = False) -> None:
        """Work until the clock reaches its limit.

        Args:
            until_waiting: return as soon as the machine waits for something.
        """
        self._run(until_waiting=until_waiting, statement=False)

    def step_statement(self) -> None:
        """Go on to where the next statement begins, or to the clock's limit."""
        self._run(until_waiting=True, statement=True)

    def _run(self, *, until_waiting: bool, statement: bool) -> None:
        clock, processor = self._host.clock, self._processor
        self._watch(statement or bool(self.listeners) or bool(self.stops))
        if self.waiting is Waiting.SET:
            processor.stop_at(_SCAN)
        while clock.now < clock.limit:
            if self._waits_quietly():
                # Round and round: nothing can happen before a key changes.
                self._pass_time(clock.limit)
                return
            if processor.registers.pc + 1 == self._passed:
                self._passed = 0
                processor.step()
                continue
            grid = clock.now - clock.now % _HALT_LOOK + _HALT_LOOK
            if not processor.run(min(clock.limit, grid)):
                if processor.registers.halted and clock.now >= grid:
                    # The board's HALT line pulls the reset button's circuit.
                    processor.interrupt()
                continue
            place = processor.registers.pc
            self._passed = place + 1
            if self._comes_by(place, statement):
                return
            if until_waiting and place in (_WAIT, _WAIT_EDIT, *_MANUAL):
                return

    def _pass_time(self, until: int) -> None:
        processor = self._processor
        for address in (_WAIT, _WAIT_ENDS, _WAIT_EDIT, _WAIT_EDIT_ENDS):
            processor.pass_by(address)
        try:
            processor.run(until)
        finally:
            for address in (_WAIT, _WAIT_ENDS, _WAIT_EDIT, _WAIT_EDIT_ENDS):
                processor.stop_at(address)
        self._passed = 0

    def _waits_quietly(self) -> bool:
        """Whether the ROM is in a loop that nothing but a key ends, and no key changes."""
        if self._idle != self._matrix.image:
            self._idle = None
        return self.waiting is not Waiting.NOTHING and self._idle is not None

    def _watch(self, wanted: bool) -> None:
        if wanted is not self._watched:
            self._watched = wanted
            (self._processor.stop_at if wanted else self._processor.pass_by)(_STATEMENT)

    def _comes_by(self, place: int, statement: bool) -> bool:
        """Take note of where the ROM is; whether it is to stop there."""
        registers = self._processor.registers
        if place in (_WAIT, _WAIT_EDIT):
            if self.waiting is Waiting.NOTHING:
                self._begin_waiting(place)
                self.wait_began = self._host.clock.now
            self._idle = self._matrix.image if self._console.quiet else None
        elif place in (_WAIT_ENDS, _WAIT_EDIT_ENDS):
            if registers.a:
                self._key_taken()
        elif place in _MANUAL:
            self._begin_manual_mode(place)
        elif place in _RESET_DONE:
            self._reset_done(place)
        elif place == _SCAN:
            self._processor.pass_by(_SCAN)
            self._passed = 0  # To step over it would mark it again.
            self.waiting = Waiting.NOTHING
        elif place == _DISPLAY:
            self._tell(registers.a)
        elif place == _ERROR:
            self._error()
        elif place == _MESSAGE:
            if registers.hl == _BREAK_MESSAGE:
                ending = Ending.BREAK if Key.BREAK in self._matrix.held else Ending.STOP
                self._pending = Outcome(ending, None, self._line_or_none(_LINE_NUMBER))
        elif place == _READY:
            self._before = self.outcome = self._pending or Outcome(Ending.END)
            self._pending = None
        elif place == _STATEMENT:
            return self._statement(statement)
        return False

    def _tell(self, code: int) -> None:
        processor = self._processor
        caller = processor.peek_word(processor.registers.sp)
        is_echo = caller not in _PRINTED_BY_BASIC
        for listener in self._console.listeners:
            listener(code, is_echo)

    def _error(self) -> None:
        number = self._host.memory.ram[_ERROR_CODE] // 2 + 1
        code = Code(number) if number in Code._value2member_map_ else Code.UE
        self._pending = Outcome(Ending.ERROR, code, self._line_or_none(_ERROR_LINE))

    def _line_or_none(self, address: int) -> int | None:
        number = word(self._host.memory.ram, address)
        return None if number == DIRECT else number

    def _begin_waiting(self, place: int) -> None:
        processor = self._processor
        sp = processor.registers.sp
        stack = [processor.peek_word(sp + 2 * depth) for depth in range(5)]
        if place == _WAIT_EDIT:
            self.waiting = Waiting.PAUSE if stack[0] == _PAUSED else Waiting.EDIT
        elif stack[0] != _IN_LINE_EDITOR or stack[2] != _IN_LINE_INPUT:
            self.waiting = Waiting.INPUT
        elif stack[4] < 0x0200:
            self.waiting = Waiting.MEMORY_SIZE
        elif stack[4] < 0x0300:
            self.waiting = Waiting.SYSTEM
        elif stack[4] == _IN_AUTO:
            self.waiting = Waiting.AUTO
        elif 0x2100 <= stack[4] < 0x2300:
            self.waiting = Waiting.INPUT
        else:
            self.waiting = Waiting.COMMAND
            self.outcome = self._before

    def _is_the_drivers(self, place: int, offset: int) -> bool:
        """Whether what stands at an address is in the driver, so far behind its beginning."""
        return rom_driver.origin(self._host.memory.ram, self._card) == place - offset

    def _reset_done(self, place: int) -> None:
        if self._is_the_drivers(place, rom_driver.RESET_DONE):
            for observer in self.reset_observers:
                observer()

    def _begin_manual_mode(self, place: int) -> None:
        if self._is_the_drivers(place, rom_driver.MANUAL):
            self.waiting = Waiting.SET
            self._idle = None
            self._processor.stop_at(_SCAN)

    def _key_taken(self) -> None:
        if self.waiting is Waiting.COMMAND and self._processor.registers.a == 13:
            self.outcome = None
        self.waiting = Waiting.NOTHING
        self.key_taken = self._host.clock.now

    def _statement(self, statement: bool) -> bool:
        ram = self._host.memory.ram
        address, line = self._processor.registers.hl, word(ram, _LINE_NUMBER)
        link = None if line == DIRECT else self.program.find(line)
        if link is not None and address == link + 3:
            address = link - 1
        for listener in self.listeners:
            listener.statement(line, address)
        if self.stops and self.stops.before(address):
            self._host.clock.limit = self._host.clock.now
            self._passed = 0
            return True
        return statement

    # -- instead of the keyboard --------------------------------------------------------------

    def load_lines(self, lines: Iterable[tuple[int, bytes]]) -> None:
        """Replace the program by crunched lines, as a tape that was loaded would.

        What does not fit is left out, from the first such line on.
        """
        memory = self._host.memory
        start = self._program.start
        room = word(memory.ram, _STRING_SPACE) - start - _ROOM
        fitting: list[tuple[int, bytes]] = []
        for number, text in lines:
            room -= len(text) + LINE_HEAD + 1
            if room < 0:
                break
            fitting.append((number, text))
        content = encode_lines(fitting, start)
        memory.ram[start : start + len(content)] = content
        end = start + len(content)
        for pointer in (PROGRAM_END, 0x40FB, 0x40FD):
            set_word(memory.ram, pointer, end)
        set_word(memory.ram, 0x40FF, start - 1)
        set_word(memory.ram, 0x40D6, word(memory.ram, 0x40B1))
        self._seen = -1

    def push_reset(self) -> None:
        """The reset button: the processor goes to 0066H, and the ROM to READY."""
        self._processor.interrupt()
        self.waiting = Waiting.NOTHING
        self._idle = None
        self._passed = 0

    def aside(self, crunched: bytes) -> None:
        """Nothing is done beside what the ROM does."""
        raise ValueError("a machine that runs its own ROM does nothing beside its program")
