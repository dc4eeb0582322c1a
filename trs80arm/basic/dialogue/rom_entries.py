"""Routines of the ROM that machine code calls, answered by this project's BASIC and drivers.

The addresses are those that the period's books gave to programmers (Level II entry points); the
T-states were measured at them. None of the ROM's code is here: a routine does its work, charges
its time, leaves its results in the registers and returns.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from trs80arm.basic import costs
from trs80arm.basic.addresses import set_word, word
from trs80arm.basic.control import DIRECT
from trs80arm.basic.dialogue import accumulator
from trs80arm.basic.dialogue.line_input import Line
from trs80arm.basic.endings import stop
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.host import Processor
from trs80arm.basic.kinds import DOUBLE, INTEGER, SINGLE, SIZES
from trs80arm.basic.numbers import convert, decimal, double, literal
from trs80arm.basic.outcome import Ending
from trs80arm.basic.state import ColdStart, State
from trs80arm.basic.variables import decode, encode

FC_ERROR: Final = 0x1E4A
"""The ROM's FC error, where USR points until a program sets it."""

# T-states. The display driver charges a character printed by PRINT; these are by how much the
# routines that machine code calls take more or less.
_T_DISPLAY, _T_PRINT, _T_DISPLAY_SAVING = -225, 26, -64
_T_PRINTER, _T_PRINTER_SAVING, _T_PRINTER_DRIVER = -285, -95, -562
_T_NEWLINE, _T_NO_NEWLINE = 91, 28
_T_SCAN, _T_SCAN_SAVING, _T_WAIT, _T_WAIT_SAVING = 748, 823, 780, 855
_T_CLEAR, _T_COLUMN = 170, 62
_T_MESSAGE, _T_MESSAGE_CHARACTER, _T_STRING, _T_STRING_CHARACTER = 62, 57, 1117, 88
_T_DELAY, _T_DELAY_END = 26, 5
T_JUMP, _T_COMPARE, _T_TYPE, _T_NEXT, _T_BLANK = 10, 31, 52, 31, 50
_T_TO_INTEGER, _T_FROM_INTEGER, _T_CONVERT, _T_MOVE = 110, 46, 720, 62
_T_DECIMAL, _T_DECIMAL_DIGIT, _T_DIGIT = 2270, 506, 370
_T_BLOCK, _T_MOTOR, _T_STAR = 596, 126, 43
_T_LOOK = 797

_DISPLAY_BLOCK, _KEYBOARD_BLOCK, _PRINTER_BLOCK = 0x401D, 0x4015, 0x4025
_NUMBER_BUFFER: Final = 0x4130
_STARS: Final = (0x3C3E, 0x3C3F)
_STAR, _BLANK = ord("*"), ord(" ")
_LEADER, _SYNC = 255, 0xA5
_LEADER_LOOP: Final = 0x028A
"""Where the ROM writes a byte of the leader and counts it."""
_PORT, _FLAGS, _MOTOR = 0xFF, 0x403D, 0b100
_LINE_BUFFER: Final = 0x41E8
_WORD: Final = 0xFFFF
BREAK_ROW, BREAK_BIT = 0x3840, 0b100


class Call:
    """A routine of the ROM called by machine code.

    Attributes:
        address: of the routine.
        waits: whether it waits for a key: it is called again when time has passed.
        wants_line: whether a line is to be typed before it returns.
    """

    def __init__(self, state: State, processor: Processor, address: int) -> None:
        self.state = state
        self.processor = processor
        self.registers = processor.registers
        self.address = address
        self.waits = False
        self.wants_line = False

    def spend(self, t_states: int) -> None:
        """Charge time."""
        self.state.clock.now += t_states

    @property
    def break_down(self) -> bool:
        """Whether BREAK is down."""
        return bool(self.state.memory.peek(BREAK_ROW) & BREAK_BIT)

    def pass_time(self) -> None:
        """Let time pass to the limit; with BREAK down only up to the next look at it."""
        clock = self.state.clock
        clock.now = clock.now + _T_LOOK if self.break_down else max(clock.now, clock.limit)

    def back(self, t_states: int = 0) -> None:
        """Charge time and return to the caller."""
        self.spend(t_states)
        self.registers.pc = self.processor.pop()

    def go(self, address: int, t_states: int = T_JUMP) -> None:
        """Go on elsewhere."""
        self.spend(t_states)
        self.registers.pc = address


Entry = Callable[[Call], None]

# -- the keyboard ----------------------------------------------------------------------------------


def _scan(call: Call, t_states: int) -> int:
    code = call.state.host.console.scan()
    call.spend(t_states)
    if call.break_down:
        # While it is up nobody asks; and a wait comes here as often as time is sliced.
        call.processor.looked = call.state.clock.now
    return code


def _look(t_states: int, block: int | None) -> Entry:
    """A: the code of a key that went down, or 0 at once."""

    def entry(call: Call) -> None:
        registers = call.registers
        registers.a = _scan(call, t_states)
        if block is not None:
            registers.de = block
        registers.flags(zero=not registers.a)
        call.back()

    return entry


def _wait(t_states: int, block: int | None) -> Entry:
    """A: the code of a key that goes down."""

    def entry(call: Call) -> None:
        registers = call.registers
        code = _scan(call, 0)
        if not code:
            call.waits = True  # The program counter stays here.
            if call.state.host.console.quiet:
                call.pass_time()
            else:
                call.spend(_T_LOOK)
            return
        registers.a = code
        if block is not None:
            registers.de = block
        registers.flags()
        call.back(t_states)

    return entry


def _line(call: Call) -> None:
    """A line from the keyboard into a buffer at HL, B characters at most."""
    if call.break_down:
        call.processor.looked = call.state.clock.now
        call.pass_time()
    else:
        call.wants_line = True


def _basic_line(call: Call) -> None:
    """A line from the keyboard into BASIC's own buffer."""
    call.registers.hl = _LINE_BUFFER
    call.registers.b = 240
    _line(call)


def give_line(call: Call, start: int, line: Line) -> None:
    """Leave a typed line in its buffer and return; the carry flag says that BREAK ended it."""
    registers, memory = call.registers, call.state.memory
    text = (line.text or b"")[: registers.b]
    basic = registers.pc == 0x0361
    memory.write(start, text + (b"\0" if basic else b"\r"))
    registers.hl = start - basic
    registers.b = len(text)
    registers.flags(carry=line.text is None)
    call.back()


# -- display and printer ---------------------------------------------------------------------------


def _display(t_states: int, block: int | None) -> Entry:
    def entry(call: Call) -> None:
        call.state.host.console.put(call.registers.a)
        if block is not None:
            call.registers.de = block
        call.back(t_states)

    return entry


def _printer(t_states: int, block: int | None) -> Entry:
    def entry(call: Call) -> None:
        call.state.host.printer.put(call.registers.a)
        if block is not None:
            call.registers.de = block
        call.back(t_states)

    return entry


def _printer_driver(call: Call) -> None:
    call.state.host.printer.put(call.registers.c)
    call.registers.a = call.registers.c
    call.back(_T_PRINTER_DRIVER)


def _print(call: Call) -> None:
    """To the device that PRINT goes to."""
    call.state.output.put(bytes((call.registers.a,)))
    call.back(_T_PRINT - costs.PRINT_CHARACTER)


def _device_in(call: Call) -> None:
    if call.registers.de == _KEYBOARD_BLOCK:
        _look(_T_SCAN - 22, None)(call)
    else:
        call.registers.a = 0
        call.back()


def _device_out(call: Call) -> None:
    if call.registers.de == _DISPLAY_BLOCK:
        _display(_T_DISPLAY - 22, None)(call)
    elif call.registers.de == _PRINTER_BLOCK:
        _printer(_T_PRINTER - 22, None)(call)
    else:
        call.back()


def _clear(call: Call) -> None:
    call.state.output.clear_screen()
    call.registers.a = 0x1F
    call.back(_T_CLEAR)


def _newline(call: Call) -> None:
    call.state.host.console.put(13)
    call.registers.a = 0
    call.back(_T_NEWLINE)


def _newline_if_needed(call: Call) -> None:
    if call.state.host.console.column:
        _newline(call)
    else:
        call.registers.a = 0
        call.back(_T_NO_NEWLINE)


def _column(call: Call) -> None:
    call.registers.a = call.state.host.console.column
    call.back(_T_COLUMN)


def _shown(call: Call, ends: bytes, most: int, per_character: int) -> int:
    """Print what stands at HL up to one of some characters; the address of that."""
    memory, place = call.state.memory, call.registers.hl
    for _ in range(most):
        code = memory.peek(place & _WORD)
        if code in ends:
            break
        call.state.output.put(bytes((code,)))
        call.spend(per_character - costs.PRINT_CHARACTER)
        place += 1
    return place & _WORD


def _message(call: Call) -> None:
    """What stands at HL up to a zero."""
    call.registers.hl = _shown(call, b"\0", 0x10000, _T_MESSAGE_CHARACTER)
    call.registers.a = 0
    call.back(_T_MESSAGE)


def _string(call: Call) -> None:
    """What stands at HL up to a zero or a quotation mark."""
    _shown(call, b'\0"', 255, _T_STRING_CHARACTER)
    call.back(_T_STRING)


def _decimal(call: Call) -> None:
    """HL as a number without a sign."""
    text = b"%d" % call.registers.hl
    call.state.output.put(text)
    call.back(_T_DECIMAL + _T_DECIMAL_DIGIT * len(text))


def _block(call: Call) -> None:
    """SET, RESET and POINT: X and what to do on the stack, Y in A; HL is at a `)`."""
    console, registers = call.state.host.console, call.registers
    y = registers.a
    x, what = call.processor.pop() >> 8, call.processor.pop() >> 8
    if y >= 48 or x >= 128:
        raise BasicError(Code.FC)
    if not what:
        accumulator.put(call.state, -1 if console.point(x, y) else 0)
    else:
        console.plot(x, y, lit=what >= 0x80)
    registers.hl += 1
    call.back(_T_BLOCK)


# -- tape ------------------------------------------------------------------------------------------


def _motor(on: bool) -> Entry:
    def entry(call: Call) -> None:
        ram = call.state.memory.ram
        ram[_FLAGS] = ram[_FLAGS] | _MOTOR if on else ram[_FLAGS] & ~_MOTOR & 0xFF
        call.state.host.ports.write(_PORT, ram[_FLAGS])
        if not on:
            call.state.host.tape.stop()
        call.back(_T_MOTOR)

    return entry


def _start_writing(call: Call) -> None:
    """A byte of the leader at a time comes behind it, counted in B as in the ROM."""
    registers = call.registers
    call.state.host.tape.start_writing()
    registers.a, registers.b = 0, _LEADER
    registers.flags(zero=True)
    call.go(_LEADER_LOOP, 0)


def _write_leader(call: Call) -> None:
    """A byte of the leader; the last goes on to the sync byte."""
    registers = call.registers
    call.state.host.tape.write(0)
    call.spend(costs.tape_byte(0))
    registers.b = registers.b - 1 & 0xFF
    if not registers.b:
        registers.a = _SYNC
        _write_byte(call)


def _write_byte(call: Call) -> None:
    call.state.host.tape.write(call.registers.a)
    call.back(costs.tape_byte(call.registers.a))


def _find_sync(call: Call) -> None:
    """Up to the sync byte; at the end of the tape it plays on for ever."""
    state = call.state
    tape = state.host.tape
    tape.start_reading()
    if not tape.find_sync():
        call.pass_time()
        return
    for place in _STARS:
        state.memory.poke(place, _STAR)
    call.spend(costs.tape_byte(0) * 40)
    call.registers.a = _STAR
    call.back()


def _read_byte(call: Call) -> None:
    state = call.state
    value = state.host.tape.read()
    if value is None:
        call.pass_time()
        return
    call.registers.a = value
    call.back(costs.tape_byte(value))


def _read_word(call: Call) -> None:
    low, high = (call.state.host.tape.read() or 0 for _ in range(2))
    call.registers.hl = low | high << 8
    call.back(2 * costs.tape_byte(0))


def _blink(call: Call) -> None:
    memory = call.state.memory
    star = memory.peek(_STARS[1]) == _STAR
    memory.poke(_STARS[1], _BLANK if star else _STAR)
    call.back(_T_STAR)


# -- numbers ---------------------------------------------------------------------------------------


def _to_integer(call: Call) -> None:
    """HL: the accumulator as an integer; OV."""
    value = accumulator.number(call.state)
    number = convert.to_integer(value)
    accumulator.put(call.state, number)
    call.registers.hl = number & _WORD
    call.back(_T_TO_INTEGER if isinstance(value, int) else _T_CONVERT)


def _from_integer(call: Call) -> None:
    """The accumulator is HL."""
    accumulator.put(
        call.state, int.from_bytes(call.registers.hl.to_bytes(2, "little"), "little", signed=True)
    )
    call.back(_T_FROM_INTEGER)


def _type_integer(call: Call) -> None:
    call.state.memory.ram[accumulator.TYPE] = SIZES[INTEGER]
    call.back(_T_MOVE)


def _to_single(call: Call) -> None:
    accumulator.put(call.state, convert.to_single(accumulator.number(call.state)))
    call.back(_T_CONVERT)


def _to_double(call: Call) -> None:
    accumulator.put(call.state, convert.to_double(accumulator.number(call.state)))
    call.back(_T_CONVERT)


def _type(call: Call) -> None:
    """The flags say the type of what is in the accumulator."""
    size = call.state.memory.ram[accumulator.TYPE]
    left = size - 3 & 0xFF
    registers = call.registers
    registers.a = 5 if size == 8 else left
    registers.flags(carry=size < 8, zero=not left, sign=size < 3)
    call.back(_T_TYPE)


def _as_text(call: Call) -> None:
    """HL: the accumulator as text, with a zero behind it."""
    value = accumulator.number(call.state)
    text = decimal.number_text(value)
    call.spend(costs.number_text(value, text))
    call.state.memory.write(_NUMBER_BUFFER, text.encode("ascii") + b"\0")
    call.registers.hl = _NUMBER_BUFFER
    call.registers.a = 0
    call.back()


def _from_text(kind: object) -> Entry:
    """The accumulator is the number that stands at HL; HL is behind it."""

    def entry(call: Call) -> None:
        registers = call.registers
        text = call.state.memory.read(registers.hl, 64).partition(b"\0")[0]
        start = double.ZERO if kind == DOUBLE else 0
        found = literal.scan(text, 0, start)
        value = convert.to_double(found.value) if kind == DOUBLE else found.value
        accumulator.put(call.state, value)
        registers.hl += found.end
        call.back(costs.constant(found.value, 0))

    return entry


def _line_number(call: Call) -> None:
    """DE: the number without sign that stands at HL; HL is behind it."""
    registers, memory = call.registers, call.state.memory
    number, place = 0, registers.hl
    while (code := memory.peek(place & _WORD)) in b"0123456789 ":
        if code != _BLANK:
            number = number * 10 + code - ord("0")
            if number > 65529:
                raise BasicError(Code.SN)
        place += 1
        if place > registers.hl + 64:
            break
    spent = _T_DIGIT * (place - registers.hl)
    registers.de, registers.hl, registers.a = number, place, code
    call.back(spent)


def _load_single(call: Call) -> None:
    """The accumulator is the single in BC and DE."""
    ram = call.state.memory.ram
    set_word(ram, 0x4121, call.registers.de)
    set_word(ram, 0x4123, call.registers.bc)
    call.back(_T_MOVE)


def _load_single_from(call: Call) -> None:
    """The accumulator is the single at HL."""
    memory, registers = call.state.memory, call.registers
    memory.ram[0x4121:0x4125] = memory.read(registers.hl, 4)
    registers.hl += 4
    call.back(137)


def _fetch_single(call: Call) -> None:
    """BC and DE are the single in the accumulator."""
    ram, registers = call.state.memory.ram, call.registers
    registers.de, registers.bc = word(ram, 0x4121), word(ram, 0x4123)
    registers.hl = 0x4125
    call.back(72)


def _fetch_single_from(call: Call) -> None:
    """BC and DE are the single at HL."""
    registers = call.registers
    data = call.state.memory.read(registers.hl, 4)
    registers.de, registers.bc = data[0] | data[1] << 8, data[2] | data[3] << 8
    registers.hl += 4
    call.back(_T_MOVE)


def _single_arithmetic(routine: Callable[..., object], t_states: int) -> Entry:
    """The accumulator: the single in BC and DE, and the one that was there."""

    def entry(call: Call) -> None:
        registers, ram = call.registers, call.state.memory.ram
        data = registers.de.to_bytes(2, "little") + registers.bc.to_bytes(2, "little")
        left, right = decode(SINGLE, data), decode(SINGLE, bytes(ram[0x4121:0x4125]))
        result = convert.to_single(routine(left, right))
        ram[0x4121:0x4125] = encode(SINGLE, result)
        ram[accumulator.TYPE] = SIZES[SINGLE]
        call.back(t_states)

    return entry


# -- BASIC itself ----------------------------------------------------------------------------------


def _jump(address: int) -> Entry:
    return lambda call: call.go(address)


def _next_character(call: Call) -> None:
    """HL goes on to the next character that is no blank; A and the flags say what it is."""
    registers, memory = call.registers, call.state.memory
    for _ in range(0x10000):
        registers.hl += 1
        code = memory.peek(registers.hl)
        if code not in (0x20, 0x09, 0x0A):
            break
        call.spend(_T_BLANK)
    registers.a = code
    registers.flags(carry=0x30 <= code < 0x3A, zero=code in (0, 0x3A))
    call.back(_T_NEXT)


def _expect(call: Call) -> None:
    """The character behind the call must stand at HL; SN."""
    registers, memory = call.registers, call.state.memory
    behind = call.processor.pop()
    if memory.peek(registers.hl) != memory.peek(behind):
        raise BasicError(Code.SN)
    call.processor.push(behind + 1 & _WORD)
    _next_character(call)


def _compare(call: Call) -> None:
    """HL and DE as numbers without sign."""
    registers = call.registers
    high, low = (registers.hl >> 8) - (registers.de >> 8), (registers.hl - registers.de) & 0xFF
    registers.a = high & 0xFF if high else low
    registers.flags(
        carry=registers.hl < registers.de,
        zero=registers.hl == registers.de,
        sign=bool(registers.a & 0x80),
    )
    call.back(_T_COMPARE)


def _delay(call: Call) -> None:
    """BC turns of a loop of 26 T-states."""
    state, registers = call.state, call.registers
    turns = registers.bc or 0x10000
    most = _T_LOOK if call.break_down else state.clock.limit - state.clock.now
    room = max(1, -(-most // _T_DELAY))
    done = min(turns, room)
    call.spend(done * _T_DELAY)
    registers.bc = turns - done
    if done == turns:
        registers.a = 0
        registers.flags(zero=True)
        call.back(_T_DELAY_END)


def _ready(call: Call) -> None:
    stop(call.state, DIRECT, 0, Ending.END)


def _power_on(call: Call) -> None:
    raise ColdStart


def _new(call: Call) -> None:
    call.state.clear_program()
    call.back(costs.STATEMENT)


def _clear_variables(call: Call) -> None:
    call.state.clear_all()
    call.back(costs.STATEMENT)


def _error(code: Code) -> Entry:
    def entry(call: Call) -> None:
        raise BasicError(code)

    return entry


def _error_in_e(call: Call) -> None:
    number = (call.registers.de & 0xFF) // 2 + 1
    raise BasicError(Code(number) if number in Code._value2member_map_ else Code.UE)


JUMPS: Final = {
    0x0008: 0x4000,
    0x0010: 0x4003,
    0x0018: 0x4006,
    0x0020: 0x4009,
    0x0028: 0x400C,
    0x0030: 0x400F,
    0x0038: 0x4012,
}
"""Where the restarts are that only jump, and where to: vectors in RAM."""
ENTRIES: Final[dict[int, Entry]] = {
    **{address: _jump(target) for address, target in JUMPS.items()},
    0x0000: _power_on,
    0x0013: _device_in,
    0x001B: _device_out,
    0x002B: _look(_T_SCAN, _KEYBOARD_BLOCK),
    0x0033: _display(_T_DISPLAY, _DISPLAY_BLOCK),
    0x003B: _printer(_T_PRINTER, _PRINTER_BLOCK),
    0x0040: _line,
    0x0049: _wait(_T_WAIT, _KEYBOARD_BLOCK),
    0x0060: _delay,
    0x0066: _ready,
    0x0072: _ready,
    0x0150: _block,
    0x01C9: _clear,
    0x01F8: _motor(on=False),
    0x01FE: _motor(on=True),
    0x0212: _motor(on=True),
    0x022C: _blink,
    0x0235: _read_byte,
    0x0264: _write_byte,
    0x0284: _start_writing,
    0x0287: _start_writing,
    _LEADER_LOOP: _write_leader,
    0x0293: _find_sync,
    0x0296: _find_sync,
    0x0314: _read_word,
    0x032A: _print,
    0x033A: _display(_T_DISPLAY_SAVING, None),
    0x0348: _column,
    0x0358: _look(_T_SCAN_SAVING, None),
    0x0361: _basic_line,
    0x0384: _wait(_T_WAIT_SAVING, None),
    0x039C: _printer(_T_PRINTER_SAVING, None),
    0x058D: _printer_driver,
    0x05D9: _line,
    0x06CC: _ready,
    0x0713: _single_arithmetic(convert.sub, 690),
    0x0716: _single_arithmetic(convert.add, 674),
    0x07B2: _error(Code.OV),
    0x0847: _single_arithmetic(convert.mul, 1735),
    0x08A2: _single_arithmetic(convert.div, 8000),
    0x09B1: _load_single_from,
    0x09B4: _load_single,
    0x09BF: _fetch_single,
    0x09C2: _fetch_single_from,
    0x0A7F: _to_integer,
    0x0A9A: _from_integer,
    0x0A9D: _type_integer,
    0x0AB1: _to_single,
    0x0ADB: _to_double,
    0x0AF6: _error(Code.TM),
    0x0E65: _from_text(DOUBLE),
    0x0E6C: _from_text(None),
    0x0FAF: _decimal,
    0x0FBD: _as_text,
    0x1997: _error(Code.SN),
    0x199A: _error(Code.DIVISION),
    0x19A2: _error_in_e,
    0x1A18: _ready,
    0x1A19: _ready,
    0x1B4D: _new,
    0x1B5D: _clear_variables,
    0x1B61: _clear_variables,
    0x1C90: _compare,
    0x1C96: _expect,
    0x1D78: _next_character,
    0x1E4A: _error(Code.FC),
    0x1E5A: _line_number,
    0x20F9: _newline_if_needed,
    0x20FE: _newline,
    0x25D9: _type,
    0x28A7: _string,
    0x2B75: _message,
}
"""Routines by their addresses."""
