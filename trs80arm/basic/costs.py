"""How many T-states of the Z-80 each thing takes that the interpreter in the ROM does.

The compiler adds these numbers up, statement by statement, the way the ROM walks through the text:
every character read, every constant converted, every variable searched for. They come from some 950
statements timed on the ROM between two OUT statements (`10 OUT1,0:A=B:OUT1,0`): what could be told
apart alone was measured alone, the rest are least squares over all of them, which they meet within
2 per cent (root mean square). Jumps, new lines and remarks were measured alone, in loops. Commands
and typed lines were fitted to the segments of the conformance cases. What a word takes is in its
row in `words`, what depends on the digits and bits of numbers in `number_costs`. 1,774,080 T-states
are a second (Level II facts, title).
"""

from __future__ import annotations

from typing import Final

from trs80arm.basic import number_costs
from trs80arm.basic.numbers.convert import Number

# -- the statement loop ---------------------------------------------------------------------------
STATEMENT: Final = 1040
"""One turn of the statement loop: the keyboard looked at, the separator, the jump by token."""
NEW_LINE: Final = 124
"""A new line: its number stored."""
CHARACTER: Final = 52
"""One character of the text fetched: a letter, a token or a colon."""
LOW_CHARACTER: Final = 109
"""A digit or any other character below the colon, which is looked at more closely."""
BLANK: Final = 42
"""A blank passed on the way to a character."""
SKIPPED: Final = 64
"""One character of the text passed without a look (REM, DATA, false IF, GOTO's rest of line)."""
LINE_PASSED: Final = 199
"""One line passed in the search for a line number."""
LINE_DIGIT: Final = 226
"""One digit of a line number."""
KEY_LATCHED: Final = 52
"""A key that the statement loop puts aside for INKEY$."""

# -- operands -------------------------------------------------------------------------------------
OPERAND: Final = 727
OPERATOR: Final = 528
PARENTHESES: Final = 301
DATA_LINE: Final = 252
DATA_STATEMENT: Final = 180
"""A line, and a further statement of it, looked through for DATA, beside its characters."""
CONSTANT: Final = {"i": 380, "s": 1360, "d": 1250}
"""A constant of a type, beside what its characters and its value take."""
STRING_LITERAL: Final = 878
STRING_CHARACTER: Final = 56
VARIABLE: Final = 783
SCALAR_OTHER_KIND: Final = 175
SCALAR_OTHER_NAME: Final = 218
NEW_SCALAR: Final = 1370
NEW_SCALAR_BYTE: Final = 94
"""A new simple variable, and each byte of the arrays that it moves up."""
ARRAY: Final = 92
ARRAY_OTHER: Final = 185
SUBSCRIPT: Final = 1700
NEW_ARRAY: Final = 639
NEW_ARRAY_BYTE: Final = 82
CONVERT: Final = {"n": 36, "s": 1150, "d": 1540, "x": 450}
"""A number of a type made an integer (CINT, PEEK, AND, subscripts)."""
FLOOR: Final = {"i": 0, "n": 0, "s": 1080, "d": 1660, "x": 2000}
"""INT and FIX of a number, beside those of an integer."""
NUMBER_TEXT: Final = {"i": -6960, "s": -6420, "d": -7090}
"""A number's text, beside what its digits take."""
NAME_LETTER: Final = 13
"""A letter or digit of a name behind the first, beside its fetching."""
KIND_BY_LETTER: Final = 73
"""The type of a name without a type sign looked up."""
FETCH: Final = {"i": 173, "s": 83, "d": 334, "t": 23}
"""A variable's value brought in, by its type."""

# -- arithmetic, by the types of the operands -----------------------------------------------------
BINARY: Final[dict[str, dict[str, int]]] = {
    "add": {"ii": 9, "is": 1770, "si": 1800, "ss": 1210, "d": 1740, "di": 837, "ds": 162},
    "sub": {"ii": 85, "is": 1810, "si": 1750, "ss": 1160, "d": 1800, "di": 833, "ds": 0},
    "mul": {"ii": 1360, "is": 2650, "si": 2900, "ss": 2060, "d": 1530, "di": 959, "ds": 242},
    "div": {"ii": 9190, "is": 8850, "si": 8580, "ss": 8110, "d": 895, "di": 1630, "ds": 736},
    "compare": {"ii": 258, "is": 1590, "si": 1570, "ss": 891, "d": 1680, "di": 750, "ds": 167},
}
"""An operation by the types left and right; with a double on either side `d`, and what the
conversion of the other operand takes."""
STORE: Final = {
    "ii": 169,
    "is": 232,
    "id": 286,
    "ss": 461,
    "si": 964,
    "sd": 926,
    "dd": 498,
    "di": 1260,
    "ds": 662,
}
"""A number put into a variable: the variable's type, then the value's."""
STORE_STRING: Final = 215
COMPARE_STRINGS: Final = 176
NEGATE: Final = 0
LOGICAL: Final = 138

FUNCTION: Final = 120
SQR: Final = 88300
LOG: Final = 35100
EXP: Final = 47600
COS: Final = 43700
SIN: Final = 42300
TAN: Final = 94400
ATN: Final = 58300
POWER: Final = 87200
"""The functions by polynomials and the power, for a usual argument."""
BY_POLYNOMIAL: Final = {
    "sqr": SQR,
    "log": LOG,
    "exp": EXP,
    "cos": COS,
    "sin": SIN,
    "tan": TAN,
    "atn": ATN,
}
"""The same by their routines."""
EASY_SQR: Final = {0.0: 1200, 1.0: 73700}
EASY_EXP: Final = {0.0: 40900}
EASY_COS: Final = {0.0: 35800}
EASY_SIN: Final = {0.0: 5500}
EASY_TAN: Final = {0.0: 41800}
EASY_ATN: Final = {0.0: 5300}
EASY_LOG: Final = {1.0: 31800}
"""The same for arguments where the ROM multiplies by zero or leaves at once."""
PRODUCT_OF_ZERO: Final = 1700
QUOTIENT_OF_ZERO: Final = 7700
POWER_OF_ZERO: Final = 86400
POWER_OF_ONE: Final = 13300
POWER_BY_ZERO: Final = 45700
"""What a power takes less."""

# -- statements -----------------------------------------------------------------------------------
NEXT_INTEGER: Final = 976
"""NEXT of an integer variable."""
ON_ERROR: Final = 487
PRINT_AT: Final = 365
PRINT_ITEM: Final = 313
PRINT_CHARACTER: Final = 68
"""PRINT's own loop for a character, beside the display driver's time."""
USING_LITERAL: Final = 69
"""The search of a format for its next field, beside what it shows on the way."""
USING_FIELD: Final = {"i": 1040, "s": 1850, "d": 0, "t": 1930}
"""A field of PRINT USING by the value's type, beside the number's conversion."""
USING_PLACE: Final = 163
"""Each place of the field."""

# -- strings --------------------------------------------------------------------------------------
STRING_BYTE: Final = 52
"""A byte copied into string space."""
STRING_FILLED: Final = 34
"""A byte that STRING$ writes."""
STRING_COMPARED: Final = 109
"""A pair of bytes compared."""
MOST_COMPARED: Final = 255 * STRING_COMPARED
CONCATENATE: Final = 1260
COLLECT_PASS: Final = 300
"""One look through all variables for the highest string that is left; there is one for each live
string, and a last one that finds none."""
COLLECT_STRING: Final = 225
COLLECT_NUMBER: Final = 171
COLLECT_ARRAY: Final = 239
COLLECT_STRING_ARRAY: Final = 150
COLLECT_ELEMENT: Final = 168
"""A simple variable, an array, an element of a string array passed in that look."""
COLLECT_BYTE: Final = 21
COLLECT_LIVE: Final = 440
COLLECT_COMPARED: Final = 166
"""A string moved, and one compared with the highest so far; every look but the last ones meets
about half of them."""

# -- typed lines ----------------------------------------------------------------------------------
TYPED_NUMBER: Final = 394
TYPED_DIGIT: Final = 335
"""The number in front of a typed line, and each of its digits."""
STORE_LINE: Final = 1507
"""A numbered line put in or taken out, beside what `editing_costs` says of its place."""
NEW_LINE_NUMBER: Final = 24
"""A line typed under a number that there is not yet."""

# -- errors and commands --------------------------------------------------------------------------
ERROR_RAISED: Final = 1040
"""From the error to the first character of its message. The way to the ON ERROR line takes about as
long as what the failed statement had still to do."""

MOST_OF_CALL: Final = 100_000
"""What double arithmetic, or a function, takes at most beside that."""

_TAKEN_FOR = {"n": "i", "x": "d"}
"""What a number is taken for whose type is known only when it is there: arithmetic on integers
seldom leaves their range, VAL gives doubles."""


def binary(name: str, left: str, right: str) -> int:
    """T-states of `add`, `sub`, `mul`, `div` or `compare` for two types of operands."""
    table = BINARY[name]
    left, right = _TAKEN_FOR.get(left, left), _TAKEN_FOR.get(right, right)
    if "d" not in (left, right):
        return table[left + right]
    other = left if right == "d" else right
    return table["d"] + (0 if other == "d" else table["d" + other])


def store(target: str, value: str) -> int:
    """T-states to put a number of one type into a variable of another."""
    return STORE[target + _TAKEN_FOR.get(value, value)]


def constant(value: Number, scanning: int) -> int:
    """T-states to convert a constant each time it is executed.

    Args:
        value: what it comes to.
        scanning: what the scan of its characters takes (`number_costs.LiteralMeter`).
    """
    return CONSTANT[_kind(value)] + scanning


def read(target: str, value: Number) -> int:
    """T-states to put a number that was read into a variable of a type."""
    return store(target, _kind(value))


def _kind(value: Number) -> str:
    return "i" if isinstance(value, int) else "s" if isinstance(value, float) else "d"


def number_text(value: Number, shown: str) -> int:
    """T-states to turn a number into the characters that PRINT and STR$ show."""
    return NUMBER_TEXT[_kind(value)] + number_costs.text(value, shown)


def number_field(value: Number, left: int, right: int, exponent: bool) -> int:
    """T-states of a number in a field of PRINT USING, beside its display.

    Args:
        value: the number.
        left: places in front of the point.
        right: places behind it.
        exponent: whether the field shows an exponent.
    """
    total = USING_FIELD[_kind(value)] + USING_PLACE * (left + right)
    if exponent:
        value = float(value) if isinstance(value, int) else value
    # A zero is written like any other number here, other than by PRINT.
    total += number_text(value if value or not isinstance(value, int) else 1, " ")
    return total + number_costs.field(value, left, right, exponent)


# -- the cassette ---------------------------------------------------------------------------------
_TAPE_BYTE: Final = 28_677
"""A byte of eight zeros at 500 baud: the instructions of the routine at 264H, called and left."""
_TAPE_ONE: Final = 13
"""What a one takes less than a zero: a second pulse in place of the pause."""
_TAPE_TURN: Final = 13
"""One turn of the loop around it."""


def tape_byte(value: int) -> int:
    """One byte, 0 to 255, recorded or played."""
    return _TAPE_BYTE - _TAPE_ONE * value.bit_count() + _TAPE_TURN
