"""PRINT, LPRINT and PRINT USING at work: where the characters go, zones, tabs and line ends."""

from __future__ import annotations

from typing import Any

from trs80arm.basic import costs
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import decimal
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.numbers.using import NumberField, StringField, UsingFormat
from trs80arm.basic.runtime.part import Part
from trs80arm.basic.variables import Descriptor

_ZONE = 16
_SCREEN_WIDTH = 64
_LAST_SCREEN_ZONE = 48
_LAST_PRINTER_ZONE = 112
_CELLS = 1024


class Printing(Part):
    """Output to the device whose number is in 409CH: the screen (0) or the printer (1)."""

    def to_screen(self) -> None:
        """Send what is printed to the screen."""
        self._output.to_screen()

    def to_printer(self) -> None:
        """Send what is printed to the printer."""
        self._output.to_printer()

    def print_at(self, place: int) -> None:
        """PRINT @: the cursor to a cell; FC outside 0 to 1023."""
        if not 0 <= place < _CELLS:
            raise BasicError(Code.FC)
        self._console.cursor = place

    def print_newline(self) -> None:
        """The end of a line."""
        self._output.put(b"\r")

    def print_comma(self) -> None:
        """On to the next zone of 16, or to a new line behind the last one."""
        column = self._output.column
        last = _LAST_PRINTER_ZONE if self._output.on_printer else _LAST_SCREEN_ZONE
        if column >= last:
            self._output.put(b"\r")
        else:
            self._output.put(b" " * (_ZONE - column % _ZONE))

    def print_tab(self, column: int) -> None:
        """TAB: blanks up to a column, none if it is passed."""
        here = self._output.column
        column &= _SCREEN_WIDTH - 1
        if column > here:
            self._output.put(b" " * (column - here))

    def print_string(self, string: Descriptor) -> None:
        """A string."""
        self._output.put(self._strings.take(string))

    def print_number(self, value: Number) -> None:
        """A number and a blank; on a new line if it would not fit (facts, thing 20)."""
        shown = decimal.number_text(value)
        self._clock.now += costs.number_text(value, shown)
        text = shown.encode("ascii")
        if not self._output.on_printer:
            column = self._console.column
            if column and column + len(text) + 1 > _SCREEN_WIDTH:
                self._output.put(b"\r")
        self._output.put(text + b" ")

    def print_anything(self, value: Any) -> None:
        """What USR gave: a number or a string."""
        if isinstance(value, list):
            self.print_string(value)
        else:
            self.print_number(value)

    def clear_screen(self) -> None:
        """CLS."""
        self._output.clear_screen()

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
        self._output.put(layout.literal().encode("latin-1"))
        layout.demand_field()

    def using_number(self, layout: UsingFormat, value: Number) -> None:
        """A number in the next field."""
        field = layout.demand_field()
        if isinstance(field, NumberField):
            right = field.right or 0
            self._clock.now += costs.number_field(value, field.left, right, field.exponent)
        self._output.put(layout.field(value).encode("latin-1"))

    def using_string(self, layout: UsingFormat, value: Descriptor) -> None:
        """A string in the next field."""
        field = layout.demand_field()
        if isinstance(field, StringField):
            # What is shown is copied into string space first, as LEFT$ does.
            value = self._strings.part(value, 0, field.width)
        text = self._strings.take(value).decode("latin-1")
        self._clock.now += costs.USING_FIELD["t"] + costs.USING_PLACE * len(text)
        self._output.put(field.text(text).encode("latin-1"))

    def using_end(self, layout: UsingFormat) -> None:
        """The values are out: the text up to the next field."""
        self._output.put(layout.rest().encode("latin-1"))

    # -- tape ---------------------------------------------------------------------------------

    def tape_number(self, value: Number) -> bytes:
        """A number as PRINT#-1 writes it."""
        return decimal.number_text(value).encode("ascii") + b" "

    def tape_string(self, value: Descriptor) -> bytes:
        """A string as PRINT#-1 writes it."""
        return self._strings.take(value)
