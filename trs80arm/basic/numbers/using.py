"""PRINT USING: a format text that is filled in with one value after another.

The PRINT statement drives a `UsingFormat`: literal text up to the next field, the value in the
field, and so on, the format beginning again when it is used up; when the values are out the text up
to the next field still comes (Level II facts, PRINT USING).
"""

from __future__ import annotations

from dataclasses import dataclass

from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import convert, decimal, double
from trs80arm.basic.numbers.double import Double

MOST_PLACES = 24
"""A numeric field of more places than this (point included) is FC."""
_TOO_LARGE = 1e16
_TOO_LARGE_DOUBLE = double.from_int(10**16)


@dataclass(frozen=True, slots=True)
class StringField:
    """`!` or `% %`: the first `width` characters of a string, padded with blanks."""

    width: int

    def text(self, value: object) -> str:
        """The string cut or padded to the width; TM for a number."""
        if not isinstance(value, str):
            raise BasicError(Code.TM)
        return value[: self.width].ljust(self.width)


@dataclass(frozen=True, slots=True)
class NumberField:
    """A numeric field.

    Attributes:
        left: places before the point; commas, `$$`, `**` and a leading `+` count too.
        right: places behind the point, or None without a point.
        commas: digits are grouped in threes.
        stars: leading blanks are asterisks.
        dollar: a dollar sign stands before the first digit.
        plus: a plus sign is written, too.
        trailing: the sign comes last.
        exponent: the number is written with an exponent of four characters.
    """

    left: int
    right: int | None = None
    commas: bool = False
    stars: bool = False
    dollar: bool = False
    plus: bool = False
    trailing: bool = False
    exponent: bool = False

    def text(self, value: object) -> str:
        """The number in this field, with `%` before it if it is too wide.

        Raises:
            BasicError: FC for a field of more than 24 places, TM for a string.
        """
        if self.left + (0 if self.right is None else self.right + 1) > MOST_PLACES:
            raise BasicError(Code.FC)
        number = convert.to_single(value) if isinstance(value, int) else value
        if not isinstance(number, (float, Double)):
            raise BasicError(Code.TM)
        negative = convert.sign(number) < 0
        magnitude = convert.negate(number) if negative else number
        assert isinstance(magnitude, (float, Double))
        if self.exponent:
            return self._scientific(magnitude, negative)
        if _is_too_large(magnitude):
            return "%" + decimal.number_text(magnitude)
        return self._fitted(self._plain(magnitude), "", negative)

    def _plain(self, magnitude: float | Double) -> str:
        """The magnitude rounded to the places behind the point."""
        right = self.right or 0
        whole, fraction = _fixed(magnitude, right)
        if self.commas:
            head = len(whole) % 3
            groups = [whole[:head]] if head else []
            groups += [whole[i : i + 3] for i in range(head, len(whole), 3)]
            whole = ",".join(groups)
        return whole if self.right is None else f"{whole}.{fraction}"

    def _scientific(self, magnitude: float | Double, negative: bool) -> str:
        """The number with an exponent part.

        One place before the point is kept for a sign that does not trail. Where a field has more
        such places than the number has digits and nothing behind the point, the ROM leaves the last
        zero out, never comes to the point, and takes the number for too wide. Without any place
        for the sign it does not come to the point either, where all digits fit behind it.
        """
        right = self.right or 0
        left = self.left if self.trailing else self.left - 1
        letter = "D" if isinstance(magnitude, Double) else "E"
        count = decimal.DOUBLE_DIGITS if letter == "D" else decimal.SINGLE_DIGITS
        exponent = 0
        figures = "0" * (left + right)
        if convert.sign(magnitude):
            x, places = decimal.scaled(magnitude)
            for _ in range(count - left - right):
                x = decimal.tenth(x)
            figures = str(decimal.cut(x)) + "0" * (left + right - count)
            exponent = count - places - left
        tail = f"{letter}{'-' if exponent < 0 else '+'}{abs(exponent):02d}"
        if left < 0 and left + right >= count:
            return self._fitted(figures.lstrip("0") or "0", tail, negative, too_wide=True)
        if left > count and not right:
            body = figures if self.right is not None else figures[:-1]
            return self._fitted(body.lstrip("0") or "0", tail, negative, too_wide=True)
        figures = figures.lstrip("0").rjust(right + 1, "0")
        split = len(figures) - right
        body = figures[:split]
        if self.right is not None:
            body += "." + figures[split:]
        return self._fitted(body, tail, negative)

    def _fitted(self, body: str, tail: str, negative: bool, *, too_wide: bool = False) -> str:
        """Sign, dollar sign and filling around the digits.

        A lone zero before the point gives way when the field is too narrow. The blank that stands
        for a trailing plus becomes an asterisk like the others.
        """
        mark = "-" if negative else "+" if self.plus else ""
        fill = "*" if self.stars else " "
        front = ("" if self.trailing else mark) + ("$" if self.dollar else "")
        width = self.left + (0 if self.right is None else self.right + 1)
        if len(front + body) > width and body.startswith("0.") and self.right:
            body = body[1:]
        text = front + body
        text = "%" + text if too_wide or len(text) > width else text.rjust(width, fill)
        return text + tail + ((mark or fill) if self.trailing else "")


def _is_too_large(magnitude: float | Double) -> bool:
    if isinstance(magnitude, float):
        return magnitude >= _TOO_LARGE
    return double.compare(magnitude, _TOO_LARGE_DOUBLE) >= 0


def _fixed(magnitude: float | Double, right: int) -> tuple[str, str]:
    """The digits before and behind the point, rounded as the machine rounds."""
    if not convert.sign(magnitude):
        return "0", "0" * right
    x, places = decimal.scaled(magnitude)
    for _ in range(places - right):
        x = decimal.tenth(x)
    figures = str(decimal.cut(x)) + "0" * (right - places)
    figures = figures.lstrip("0").rjust(right + 1, "0")
    split = len(figures) - right
    return figures[:split], figures[split:]


Field = StringField | NumberField


def find_field(text: str, position: int) -> tuple[str, Field | None, int]:
    """Look for the next field of a format, as the ROM does.

    A plus sign is held back until it is known whether a numeric field follows. The last character
    can only be `#` or `!` if it is to be a field of its own.

    Args:
        text: the format.
        position: where to begin.

    Returns:
        The literal text before the field, the field or None, and the place behind the field.
    """
    literal = ""
    held = ""
    end = len(text)
    while position < end:
        char = text[position]
        follower = text[position + 1 : position + 2]
        if char == "!":
            return literal + held, StringField(1), position + 1
        if char == "#" or (char == "." and follower == "#") or (char in "$*" and char == follower):
            field, position = _number_field(text, position, bool(held))
            return literal, field, position
        if char == "%":
            close = position + 1
            while text[close : close + 1] == " ":
                close += 1
            if text[close : close + 1] == "%":
                return literal + held, StringField(close + 1 - position), close + 1
        if char == "+" and follower:
            literal, held = literal + held, char
        else:
            literal, held = literal + held + char, ""
        position += 1
    return literal, None, position


def _number_field(text: str, position: int, plus: bool) -> tuple[NumberField, int]:
    """The numeric field that begins at `position`, and the place behind it."""
    left = int(plus)
    right: int | None = None
    stars = text.startswith("**", position)
    dollar = text.startswith("**$" if stars else "$$", position)
    commas = trailing = False
    if stars or dollar:
        places = 3 if stars and dollar else 2
        left += places
        position += places
    while (char := text[position : position + 1]) and char in "#,":
        commas = commas or char == ","
        left += 1
        position += 1
    if char == ".":
        position += 1
        right = 0
        while text[position : position + 1] == "#":
            right += 1
            position += 1
    exponent = text.startswith("[[[[", position)
    if exponent:
        position += 4
    if not plus and (char := text[position : position + 1]) and char in "+-":
        trailing = True
        plus = char == "+"
        position += 1
    field = NumberField(left, right, commas, stars, dollar, plus, trailing, exponent)
    return field, position


class UsingFormat:
    """A format text and the place reached in it.

    PRINT goes, for each value of its list: print `literal()`, call `demand_field()`, evaluate the
    value, print `field(value)`. When the list is at its end it prints `rest()`.

    Attributes:
        text: the format.
    """

    __slots__ = ("_field", "_position", "text")

    def __init__(self, text: str) -> None:
        self.text = text
        self._position = 0
        self._field: Field | None = None

    def literal(self) -> str:
        """The text up to the next field; behind the last field the format begins again.

        A format without any field gives its whole text; `demand_field` then raises.
        """
        literal, self._field, position = find_field(self.text, self._position)
        if self._field is None and self._position:
            again, self._field, position = find_field(self.text, 0)
            literal += again
        self._position = position
        return literal

    def demand_field(self) -> Field:
        """The field that `literal` has come to; FC if the format has none."""
        if self._field is None:
            raise BasicError(Code.FC)
        return self._field

    def field(self, value: object) -> str:
        """The value in the field that `literal` has come to; FC, TM, OV."""
        return self.demand_field().text(value)

    def rest(self) -> str:
        """The text up to the next field or the end, for a list whose values are out."""
        return find_field(self.text, self._position)[0]
