"""The string functions."""

from __future__ import annotations

from trs80arm.basic import addresses, costs, number_costs
from trs80arm.basic.characters import BLANKS
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import decimal, double, literal
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.runtime.part import Part
from trs80arm.basic.variables import NO_STRING, Descriptor

Characters = bytes | bytearray
_SIGNS = (b"+", b"-")


def _compared(first: Characters, second: Characters) -> int:
    """How many pairs of bytes are looked at until the order is known."""
    count = 0
    for one, other in zip(first, second, strict=False):
        count += 1
        if one != other:
            return count
    return count


class StringFunctions(Part):
    """Functions that take or give strings; a string is its descriptor."""

    def assign(self, target: Descriptor, string: Descriptor) -> None:
        """LET of a string."""
        self._strings.assign(target, string, self._state.program.start)

    def string_equal(self, left: Descriptor, right: Descriptor) -> bool:
        """Whether two strings are the same."""
        strings = self._strings
        second = strings.take(right)
        return self.alike(strings.take(left), second)

    def string_compare(self, left: Descriptor, right: Descriptor) -> int:
        """-1, 0 or 1, by bytes, the shorter first."""
        strings = self._strings
        second = strings.take(right)
        return self.order(strings.take(left), second)

    def alike(self, first: Characters, second: Characters) -> bool:
        """Whether the characters of two strings are the same."""
        if first == second:
            self._clock.now += costs.STRING_COMPARED * len(first)
            return True
        self._clock.now += costs.STRING_COMPARED * _compared(first, second)
        return False

    def order(self, first: Characters, second: Characters) -> int:
        """-1, 0 or 1 for the characters of two strings."""
        self._clock.now += costs.STRING_COMPARED * _compared(first, second)
        return (first > second) - (first < second)

    def left(self, string: Descriptor, count: int) -> Descriptor:
        """LEFT$."""
        return self._strings.part(string, 0, count)

    def right(self, string: Descriptor, count: int) -> Descriptor:
        """RIGHT$."""
        return self._strings.part(string, max(0, string[0] - count), count)

    def middle(self, string: Descriptor, start: int, count: int = 255) -> Descriptor:
        """MID$; FC for position 0."""
        if not start:
            raise BasicError(Code.FC)
        return self._strings.part(string, min(start - 1, string[0]), count)

    def len_(self, string: Descriptor) -> int:
        """LEN."""
        length = string[0]
        self._strings.free(string)
        return length

    def asc_(self, string: Descriptor) -> int:
        """ASC; FC for an empty string."""
        return self.first_code(string)

    def first_code(self, string: Descriptor) -> int:
        """The code of the first character; FC for an empty string."""
        text = self._strings.take(string)
        if not text:
            raise BasicError(Code.FC)
        return text[0]

    def val_(self, string: Descriptor) -> Number:
        """VAL: the number at the start of a string, scanned as a double.

        A sign counts only as the very first character: VAL(" -5") is 0. For an empty string it is
        an integer 0. While it scans, the ROM ends the string with a zero in the byte behind it; an
        overflow leaves that zero, in a literal where the closing quote was.
        """
        behind = sum(string) & 0xFFFF
        text = self._strings.take(string)
        if not text:
            return 0
        if text[0] in BLANKS and text.lstrip(BLANKS)[:1] in _SIGNS:
            return 0
        meter = number_costs.LiteralMeter()
        try:
            found = literal.scan(text.partition(b"\0")[0], 0, double.ZERO, meter)
        except BasicError:
            self._state.memory.poke(behind, 0)
            raise
        self._clock.now += costs.constant(found.value, meter.total)
        return found.value

    def chr_(self, code: int) -> Descriptor:
        """CHR$."""
        return self._strings.new(bytes((code,)))

    def str_(self, value: Number) -> Descriptor:
        """STR$."""
        text = decimal.number_text(value)
        self._clock.now += costs.number_text(value, text)
        return self._strings.new(text.encode("ascii"))

    def shown(self, text_and_time: tuple[bytes, int]) -> Descriptor:
        """STR$ of a number whose text is remembered."""
        text, time = text_and_time
        self._clock.now += time + costs.STRING_BYTE * len(text)
        return self._strings.new(text)

    def string_of(self, count: int, code: int) -> Descriptor:
        """STRING$."""
        self._clock.now += costs.STRING_FILLED * count
        return self._strings.new(bytes((code,)) * count)

    def inkey(self) -> Descriptor:
        """INKEY$: the key remembered by the statement loop, or one that goes down now."""
        ram = self._ram
        key = ram[addresses.KEY_LATCH]
        if key:
            ram[addresses.KEY_LATCH] = 0
        else:
            key = self._console.scan()
        return self._strings.new(bytes((key,))) if key else list(NO_STRING)

    def free_strings(self, string: Descriptor) -> float:
        """FRE of a string: collect, and count the free string space."""
        self._strings.free(string)
        return float(self._strings.free_bytes())

    def text_at(self, length: int, address: int) -> bytes:
        """Characters of the program text."""
        return self._memory.read(address, length)
