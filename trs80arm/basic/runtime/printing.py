"""PRINT, LPRINT and PRINT USING at work: where the characters go, zones, tabs and line ends."""

from __future__ import annotations

from trs80arm.basic import costs, system_area
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import decimal
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.numbers.using import NumberField, StringField, UsingFormat
from trs80arm.basic.runtime.part import Part
from trs80arm.basic.variables import Descriptor

_NEWLINE = 13
_ZONE = 16
_SCREEN_WIDTH = 64
_LAST_SCREEN_ZONE = 48
_LAST_PRINTER_ZONE = 112
_CELLS = 1024


class Printing(Part):
    """Output to the device whose number is in 409CH: the screen (0) or the printer (1)."""

    def to_screen(self) -> None:
        """Send what is printed to the screen."""
        self._ram[system_area.OUTPUT_DEVICE] = 0

    def leave_printer(self) -> None:
        """To the screen for good (038BH): the printer gets the end of a line begun."""
        self._ram[system_area.OUTPUT_DEVICE] = 0
        if self._ram[system_area.PRINTER_COLUMN]:
            self._put_printer(_NEWLINE)

    def to_printer(self) -> None:
        """Send what is printed to the printer."""
        self._ram[system_area.OUTPUT_DEVICE] = 1

    def _put(self, text: bytes) -> None:
        clock = self._clock
        if self._ram[system_area.OUTPUT_DEVICE]:
            for code in text:
                clock.now += costs.PRINT_CHARACTER
                self._put_printer(code)
            return
        put = self._console.put
        for code in text:
            clock.now += costs.PRINT_CHARACTER
            put(code)

    def _put_printer(self, code: int) -> None:
        self._basic.host.printer.put(code)
        column = self._ram[system_area.PRINTER_COLUMN]
        if code in (_NEWLINE, 10):
            column = 0
        elif code >= 0x20:
            column = column + 1 & 0xFF
        self._ram[system_area.PRINTER_COLUMN] = column

    def _column(self) -> int:
        if self._ram[system_area.OUTPUT_DEVICE]:
            return self._ram[system_area.PRINTER_COLUMN]
        return self._console.column

    def print_at(self, place: int) -> None:
        """PRINT @: the cursor to a cell; FC outside 0 to 1023."""
        if not 0 <= place < _CELLS:
            raise BasicError(Code.FC)
        self._console.cursor = place

    def print_newline(self) -> None:
        """The end of a line."""
        self._put(b"\r")

    def print_comma(self) -> None:
        """On to the next zone of 16, or to a new line behind the last one."""
        column = self._column()
        last = _LAST_PRINTER_ZONE if self._ram[system_area.OUTPUT_DEVICE] else _LAST_SCREEN_ZONE
        if column >= last:
            self._put(b"\r")
        else:
            self._put(b" " * (_ZONE - column % _ZONE))

    def print_tab(self, column: int) -> None:
        """TAB: blanks up to a column, none if it is passed."""
        here = self._column()
        column &= _SCREEN_WIDTH - 1
        if column > here:
            self._put(b" " * (column - here))

    def print_string(self, string: Descriptor) -> None:
        """A string."""
        self._put(self._strings.take(string))

    def print_number(self, value: Number) -> None:
        """A number and a blank; on a new line if it would not fit (facts, thing 20)."""
        shown = decimal.number_text(value)
        self._clock.now += costs.number_text(value, shown)
        text = shown.encode("ascii")
        if not self._ram[system_area.OUTPUT_DEVICE]:
            column = self._console.column
            if column and column + len(text) + 1 > _SCREEN_WIDTH:
                self._put(b"\r")
        self._put(text + b" ")

    def clear_screen(self) -> None:
        """CLS."""
        self._console.put(0x1C)
        self._console.put(0x1F)

    def position(self, _argument: object) -> int:
        """POS: the column of the cursor."""
        if isinstance(_argument, list):
            self._strings.free(_argument)
        return self._console.column

    # -- PRINT USING --------------------------------------------------------------------------

    def using(self, layout: Descriptor) -> UsingFormat:
        """The format of a PRINT USING; FC for an empty one."""
        text = self._strings.take(layout)
        if not text:
            raise BasicError(Code.FC)
        return UsingFormat(text.decode("latin-1"))

    def using_literal(self, layout: UsingFormat) -> None:
        """The text up to the next field; FC if there is none."""
        self._clock.now += costs.USING_LITERAL
        self._put(layout.literal().encode("latin-1"))
        layout.demand_field()

    def using_ready(self, layout: UsingFormat) -> UsingFormat:
        """The format at its next field."""
        self.using_literal(layout)
        return layout

    def using_number(self, layout: UsingFormat, value: Number) -> None:
        """A number in the next field."""
        field = layout.demand_field()
        if isinstance(field, NumberField):
            right = field.right or 0
            self._clock.now += costs.number_field(value, field.left, right, field.exponent)
        self._put(layout.field(value).encode("latin-1"))

    def using_string(self, layout: UsingFormat, value: Descriptor) -> None:
        """A string in the next field."""
        field = layout.demand_field()
        if isinstance(field, StringField):
            # What is shown is copied into string space first, as LEFT$ does.
            value = self._strings.part(value, 0, field.width)
        text = self._strings.take(value).decode("latin-1")
        self._clock.now += costs.USING_FIELD["t"] + costs.USING_PLACE * len(text)
        self._put(field.text(text).encode("latin-1"))

    def using_end(self, layout: UsingFormat) -> None:
        """The values are out: the text up to the next field."""
        self._put(layout.rest().encode("latin-1"))

    # -- tape ---------------------------------------------------------------------------------

    def tape_number(self, value: Number) -> bytes:
        """A number as PRINT#-1 writes it."""
        return decimal.number_text(value).encode("ascii") + b" "

    def tape_string(self, value: Descriptor) -> bytes:
        """A string as PRINT#-1 writes it."""
        return self._strings.take(value)
