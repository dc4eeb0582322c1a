"""The statements that use the cassette recorder: CSAVE, CLOAD, CLOAD?, PRINT#-1 and INPUT#-1.

A recording is 255 zeros and the sync byte A5H; then three D3H, the name's first character and the
program as it lies in memory, or the characters of one PRINT# and a carriage return. A byte takes 16
milliseconds. The ROM cannot be broken off meanwhile; here BREAK switches the motor off.
"""

from __future__ import annotations

from typing import Final

from trs80arm.basic import costs, keyboard
from trs80arm.basic.dialogue.input_statement import Items, TargetList
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.execution import break_
from trs80arm.basic.state import Activity, State

LEADER: Final = 255
SYNC: Final = 0xA5
PROGRAM_MARK: Final = b"\xd3\xd3\xd3"
RECORD_LENGTH: Final = 248
"""Characters that INPUT# takes from one recording."""
_RETURN = 13
_END_ZEROS = 3
_STARS = (0x3C3E, 0x3C3F)
"""The two cells in the corner of the tube: `**` while a program is read, the second one blinks."""
_STAR, _BLANK = 42, 32
_T_LEADER: Final = LEADER * costs.tape_byte(0) + costs.tape_byte(SYNC)


class Writing(Activity):
    """Bytes on their way to the tape.

    Args:
        data: what comes behind leader and sync byte; an error is raised in its place, for the ROM
            records the leader before it looks at what to record.
    """

    _data: bytes
    _error: BasicError | None
    _place: int

    def __init__(self, data: bytes | BasicError) -> None:
        self._data = bytes(LEADER) + bytes((SYNC,))
        self._error = None
        if isinstance(data, BasicError):
            self._error = data
        else:
            self._data += data
        self._place = 0

    @property
    def total(self) -> int:
        """How many bytes it records in all, the leader included."""
        return len(self._data)

    def advance(self, state: State) -> None:
        """Record up to the clock's limit."""
        clock, tape = state.clock, state.host.tape
        if not self._place:
            tape.start_writing()
        while clock.now < clock.limit and self._place < len(self._data):
            value = self._data[self._place]
            tape.write(value)
            self._place += 1
            clock.now += costs.tape_byte(value)
            if keyboard.look_for_break(state) == keyboard.BREAK:
                tape.stop()
                break_(state)
                return
        if self._place == len(self._data):
            tape.stop()
            if self._error is not None:
                raise self._error
            state.end()


class PrintTape(Writing):
    """`PRINT#-1` or `-2`.

    Args:
        data: the items as PRINT shows them with the list's commas, and a carriage return unless
            the list ends in a separator, or what went wrong with them.
    """


class Csave(Activity):
    """`CSAVE "A"`.

    Args:
        name: its first character is the program's name; empty is ?FC.
    """

    _name: bytes | BasicError

    def __init__(self, name: bytes | BasicError) -> None:
        self._name = name or BasicError(Code.FC)

    def advance(self, state: State) -> None:
        """Record the program as it is now."""
        name, program = self._name, state.program
        state.stack.pop()
        if isinstance(name, BasicError):
            state.begin(Writing(name))
            return
        text = bytes(state.memory.ram[program.start : program.end])
        state.begin(Writing(PROGRAM_MARK + name[:1] + text))


class Reading(Activity):
    """Something on its way from the tape; at the end of the tape nothing happens until BREAK."""

    _playing: bool
    _found: bool

    def __init__(self) -> None:
        self._playing = False
        self._found = False

    def advance(self, state: State) -> None:
        """Find the next recording, then take it byte by byte."""
        clock, tape = state.clock, state.host.tape
        if not self._playing:
            tape.start_reading()
            self._playing = True
        while clock.now < clock.limit and self._playing:
            silent = False
            if not self._found:
                self._found = tape.find_sync()
                silent = not self._found
                clock.now += _T_LEADER if self._found else 0
                if self._found:
                    self.found(state)
            else:
                value = tape.read()
                clock.now += costs.tape_byte(value or 0)
                if value is None:
                    self._found = False
                else:
                    self.byte(state, value)
            look = keyboard.next_key if silent else keyboard.look_for_break
            if self._playing and look(state) == keyboard.BREAK:
                self.stop(state)
                self.broken_off(state)
                break_(state)

    def search(self) -> None:
        """Go on to the next recording."""
        self._found = False

    def stop(self, state: State) -> None:
        """Switch the motor off."""
        state.host.tape.stop()
        self._playing = False

    def found(self, state: State) -> None:
        """A recording begins."""

    def broken_off(self, state: State) -> None:
        """BREAK ended the reading before its time."""

    def byte(self, state: State, value: int) -> None:
        """The next byte of it."""
        raise TypeError(f"{type(self).__name__} takes no bytes")


class Cload(Reading):
    """`CLOAD`, or `CLOAD?`, which compares instead of storing.

    Args:
        name: the program's name, of which the first character counts; None takes the next program.
        verify: whether it is `CLOAD?`.
    """

    _name: bytes | BasicError | None
    _verify: bool
    _head: bytearray
    _address: int
    _zeros: int

    def __init__(self, name: bytes | BasicError | None, *, verify: bool) -> None:
        super().__init__()
        self._name = name
        self._verify = verify
        self._head = bytearray()
        self._address = 0
        self._zeros = 0

    @property
    def wanted(self) -> int | None:
        """The code of the name that is looked for; None for any."""
        return self._name[0] if isinstance(self._name, bytes) and self._name else None

    @property
    def statement(self) -> str:
        """As it is typed."""
        return "CLOAD?" if self._verify else "CLOAD"

    def found(self, state: State) -> None:
        """The name is only looked at now; a program in memory goes before another comes."""
        _show_stars(state)
        self._head.clear()
        if isinstance(self._name, BasicError):
            self.stop(state)
            raise self._name
        if self._name == b"":
            self.stop(state)
            raise BasicError(Code.FC)

    def broken_off(self, state: State) -> None:
        """Half a program is none."""
        if self._address and not self._verify:
            state.program.clear()
            state.clear_all()

    def byte(self, state: State, value: int) -> None:
        """Three marks, the name, then the program up to three zeros in a row."""
        if len(self._head) <= len(PROGRAM_MARK):
            self._head.append(value)
            if len(self._head) > len(PROGRAM_MARK):
                self._check_head(state)
            return
        memory = state.memory
        if self._verify:
            if memory.peek(self._address & 0xFFFF) != value:
                self.stop(state)
                state.output.show(b"BAD\r")
                state.return_to_command()
                return
        elif self._address >= state.strings.bottom:
            self.stop(state)
            state.program.clear()
            state.clear_all()
            raise BasicError(Code.OM)
        else:
            memory.ram[self._address] = value
        self._address += 1
        self._zeros = 0 if value else self._zeros + 1
        if value == 0:
            _blink(state)
        if self._zeros == _END_ZEROS:
            self._end(state)

    def _check_head(self, state: State) -> None:
        wanted = self._name[:1] if isinstance(self._name, bytes) else self._head[-1:]
        if self._head != PROGRAM_MARK + wanted:
            self.search()
            return
        if not self._verify:
            state.program.clear()
            state.clear_all()
        self._address = state.program.start
        self._zeros = 0

    def _end(self, state: State) -> None:
        self.stop(state)
        if not self._verify:
            state.program.end = self._address
            state.program.mend()
        state.clear_all()
        state.output.show(b"READY\r")
        state.return_to_command(ready=False)


class InputTape(Reading):
    """`INPUT#-1` or `-2`: the items of one recording.

    Args:
        targets: the variables.
    """

    _targets: TargetList
    _text: bytearray

    def __init__(self, targets: TargetList) -> None:
        super().__init__()
        self._targets = targets
        self._text = bytearray()

    def found(self, state: State) -> None:
        """A recording begins."""
        _show_stars(state)
        self._text.clear()

    def byte(self, state: State, value: int) -> None:
        """Characters up to the carriage return."""
        if value != _RETURN and len(self._text) < RECORD_LENGTH:
            self._text.append(value)
            return
        self.stop(state)
        self._assign(state, Items(bytes(self._text)))
        state.end()

    def _assign(self, state: State, items: Items) -> None:
        for number in range(len(self._targets)):
            target = self._targets[number]
            kind = target.kind
            if not items.is_next:
                raise BasicError(Code.OD)
            value = items.string() if kind == "t" else items.number(kind)
            target.assign(value)
            if not items.separator():
                raise BasicError(Code.FD)
        if items.is_rest:
            state.output.show(b"?Extra ignored\r")


def _show_stars(state: State) -> None:
    for address in _STARS:
        state.memory.poke(address, _STAR)


def _blink(state: State) -> None:
    memory = state.memory
    memory.poke(_STARS[1], _BLANK if memory.peek(_STARS[1]) == _STAR else _STAR)
