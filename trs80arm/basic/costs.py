"""How many T-states of the Z-80 each thing takes that the interpreter in the ROM does.

The compiler adds these numbers up, statement by statement, the way the ROM walks through the text:
every character read, every constant converted, every variable searched for. They were fitted to
the times that the original needed for the programs of the conformance cases and of the benchmarks
(Level II facts, Speed); 1,774,080 T-states are a second.
"""

from __future__ import annotations

from typing import Final

from trs80arm.basic import number_costs, tokens
from trs80arm.basic.numbers.convert import Number

_BLANK, _QUOTE, _COLON = 0x20, 0x22, 0x3A

# -- the statement loop ---------------------------------------------------------------------------
STATEMENT: Final = 1020
"""One turn of the statement loop: the keyboard looked at, the separator, the jump by token."""
NEW_LINE: Final = 124
"""A new line: its number stored."""
CHARACTER: Final = 111
"""One character of the text fetched: a letter, a token or a colon."""
LOW_CHARACTER: Final = 111
"""A digit or any other character below the colon, which is looked at more closely."""
BLANK: Final = 42
"""A blank passed on the way to a character."""
SKIPPED: Final = 81
"""One character of the text passed without a look (REM, DATA, false IF, GOTO's rest of line)."""
LINE_PASSED: Final = 161
"""One line passed in the search for a line number."""
LINE_DIGIT: Final = 261
"""One digit of a line number."""
KEY_LATCHED: Final = 52
"""A key that the statement loop puts aside for INKEY$."""

# -- operands -------------------------------------------------------------------------------------
OPERAND: Final = 709
OPERATOR: Final = 528
PARENTHESES: Final = 268
DATA_LINE: Final = 350
"""A line looked through for DATA, beside its characters."""
CONSTANT: Final = {"i": 436, "s": 1480, "d": 1390}
"""A constant of a type, beside what its characters and its value take."""
STRING_LITERAL: Final = 877
STRING_CHARACTER: Final = 58
VARIABLE: Final = 782
SCALAR_OTHER_KIND: Final = 166
SCALAR_OTHER_NAME: Final = 225
NEW_SCALAR: Final = 1500
NEW_SCALAR_BYTE: Final = 93
"""A new simple variable, and each byte of the arrays that it moves up."""
ARRAY: Final = 120
ARRAY_OTHER: Final = 152
SUBSCRIPT: Final = 1590
NEW_ARRAY: Final = 718
NEW_ARRAY_BYTE: Final = 82
CONVERT: Final = {"n": 0, "s": 1050, "d": 1510, "x": 469}
"""A number of a type made an integer (CINT, PEEK, AND, subscripts)."""
FLOOR: Final = {"i": 0, "n": 0, "s": 1030, "d": 1620, "x": 2000}
"""INT and FIX of a number, beside those of an integer."""
NUMBER_TEXT: Final = {"i": -7030, "s": -6560, "d": -6960}
"""A number's text, beside what its digits take."""
NAME_LETTER: Final = 24
"""A letter or digit of a name behind the first, beside its fetching."""
KIND_BY_LETTER: Final = 92
"""The type of a name without a type sign looked up."""
FETCH: Final = {"i": 117, "s": 97, "d": 439, "t": 0}
"""A variable's value brought in, by its type."""

# -- arithmetic, by the types of the operands -----------------------------------------------------
BINARY: Final[dict[str, dict[str, int]]] = {
    "add": {"ii": 20, "is": 1700, "si": 1710, "ss": 1090, "d": 1570, "di": 932, "ds": 163},
    "sub": {"ii": 92, "is": 1750, "si": 1600, "ss": 991, "d": 1640, "di": 900, "ds": 0},
    "mul": {"ii": 1300, "is": 2560, "si": 2650, "ss": 1950, "d": 1350, "di": 1060, "ds": 260},
    "div": {"ii": 9220, "is": 8780, "si": 8510, "ss": 7960, "d": 797, "di": 1740, "ds": 771},
    "compare": {"ii": 235, "is": 1510, "si": 1510, "ss": 767, "d": 1520, "di": 950, "ds": 223},
}
"""An operation by the types left and right; with a double on either side `d`, and what the
conversion of the other operand takes."""
STORE: Final = {
    "ii": 243,
    "is": 276,
    "id": 291,
    "ss": 319,
    "si": 898,
    "sd": 809,
    "dd": 486,
    "di": 1320,
    "ds": 620,
}
"""A number put into a variable: the variable's type, then the value's."""
STORE_STRING: Final = 192
COMPARE_STRINGS: Final = 216
NEGATE: Final = 53
LOGICAL: Final = 229
POWER: Final = 86500

FUNCTION: Final = 100
FUNCTION_WORK: Final[dict[str, int]] = {
    "SGN": 303,
    "INT": 162,
    "ABS": 119,
    "FRE": 221,
    "INP": 332,
    "POS": 142,
    "SQR": 87700,
    "RND": 4980,
    "LOG": 34800,
    "EXP": 47600,
    "COS": 43700,
    "SIN": 42300,
    "TAN": 94400,
    "ATN": 58300,
    "PEEK": 231,
    "CINT": 180,
    "CSNG": 207,
    "CDBL": 210,
    "FIX": 337,
    "LEN": 242,
    "STR$": 1220,
    "VAL": 0,
    "ASC": 357,
    "CHR$": 1460,
    "LEFT$": 2120,
    "RIGHT$": 2080,
    "MID$": 2500,
    "STRING$": 1820,
    "POINT": 1370,
    "INKEY$": 1180,
    "MEM": 174,
    "VARPTR": 215,
    "USR": 301,
    "ERR": 133,
    "ERL": 279,
}

RND_OF_NUMBER: Final = 6070
"""RND of anything but a plain 0: the product with its argument, and INT."""

# -- statements -----------------------------------------------------------------------------------
STATEMENT_WORK: Final[dict[str, int]] = {
    "LET": 435,
    "FOR": 1650,
    "STEP": 534,
    "NEXT": 2360,
    "NEXT_INTEGER": 929,
    "GOTO": 370,
    "GOSUB": 644,
    "RETURN": 687,
    "IF": 298,
    "ON": 478,
    "READ": 2650,
    "RESTORE": 143,
    "SET": 1400,
    "RESET": 1500,
    "POKE": 490,
    "OUT": 819,
    "CLS": 97,
    "DIM": 259,
    "PRINT": 300,
    "PRINT_ITEM": 311,
    "PRINT@": 313,
    "TAB": 256,
    "CLEAR": 1520,
    "RUN": 1310,
    "ERROR": 619,
    "RESUME": 615,
    "ON ERROR": 487,
    "DEF": 251,
    "RANDOM": 100,
    "END": 300,
}
PRINT_CHARACTER: Final = 68
"""PRINT's own loop for a character, beside the display driver's time."""
USING_LITERAL: Final = 69
"""The search of a format for its next field, beside what it shows on the way."""
USING_FIELD: Final = {"i": 1040, "s": 1850, "d": 0, "t": 1930}
"""A field of PRINT USING by the value's type, beside the number's conversion."""
USING_PLACE: Final = 163
"""Each place of the field."""

# -- strings --------------------------------------------------------------------------------------
STRING_BYTE: Final = 48
CONCATENATE: Final = 1090
COLLECT: Final = 524
COLLECT_PASS: Final = 898
COLLECT_DESCRIPTOR: Final = 191
COLLECT_NUMBER: Final = 60

# -- typed lines ----------------------------------------------------------------------------------
CRUNCH_FOUND: Final = 714
"""A word found in the table of reserved words."""
CRUNCH_PASSED: Final = 33
"""One letter of the table passed in the search; a character that begins no word passes them all."""
CRUNCH_PLAIN: Final = 149
"""A character that is copied without a search: digits, blanks, quotes, REM and DATA."""
STORE_LINE: Final = 1410
"""A numbered line put in or taken out, beside what follows."""
STORE_BYTE: Final = 48
"""One byte of the program behind the line, which moves."""
LINK_LINE: Final = 129
LINK_BYTE: Final = 48
"""One line, and one byte of the program, passed when the links are set anew."""

# -- errors and commands --------------------------------------------------------------------------
ERROR_RAISED: Final = 1040
"""From the error to the first character of its message, or to the ON ERROR line."""

MOST_OF_DOUBLE: Final = 100_000
"""What double arithmetic takes at most beside that, by the bits of its operands."""

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


def constant(text: bytes, value: Number, is_double: bool = False) -> int:
    """T-states to convert a constant each time it is executed.

    Args:
        text: its characters, blanks included.
        value: what it comes to.
        is_double: whether the conversion begins in double precision (VAL).
    """
    return CONSTANT[_kind(value)] + number_costs.literal(text, is_double)


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


_PASSED: Final = tuple(
    sum(len(word) for word in tokens.WORDS[:place]) for place in range(len(tokens.WORDS) + 1)
)


def crunching(crunched: bytes) -> int:
    """T-states to crunch a typed line.

    Args:
        crunched: what it came to.
    """
    total = 0
    quoted = in_data = False
    for place, code in enumerate(crunched):
        quoted ^= code == _QUOTE
        in_data = in_data and (quoted or code != _COLON)
        if quoted or in_data or 0x30 <= code < 0x3C or code in (_QUOTE, _BLANK):
            total += CRUNCH_PLAIN
        elif code < tokens.FIRST:
            total += CRUNCH_FOUND + CRUNCH_PASSED * _PASSED[-1]
        else:
            index = min(code, tokens.APOSTROPHE) - tokens.FIRST
            total += CRUNCH_FOUND + CRUNCH_PASSED * _PASSED[index]
            if code in (tokens.REM, tokens.APOSTROPHE):
                return total + CRUNCH_PLAIN * (len(crunched) - place - 1)
            in_data = code == tokens.DATA
    return total


def storing(moved: int, lines: int, size: int) -> int:
    """T-states to put a line into the program or take one out.

    Args:
        moved: bytes of the program behind it.
        lines: lines of the program.
        size: bytes of the program.
    """
    return STORE_LINE + STORE_BYTE * moved + LINK_LINE * lines + LINK_BYTE * size
