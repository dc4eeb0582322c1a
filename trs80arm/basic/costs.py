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
NEW_LINE: Final = 117
"""A new line: its number stored."""
CHARACTER: Final = 107
"""One character of the text fetched: a letter, a token or a colon."""
LOW_CHARACTER: Final = 122
"""A digit or any other character below the colon, which is looked at more closely."""
BLANK: Final = 42
"""A blank passed on the way to a character."""
SKIPPED: Final = 87
"""One character of the text passed without a look (REM, DATA, false IF, GOTO's rest of line)."""
LINE_PASSED: Final = 129
"""One line passed in the search for a line number."""
LINE_DIGIT: Final = 234
"""One digit of a line number."""
KEY_LATCHED: Final = 52
"""A key that the statement loop puts aside for INKEY$."""

# -- operands -------------------------------------------------------------------------------------
OPERAND: Final = 734
OPERATOR: Final = 571
PARENTHESES: Final = 244
DATA_LINE: Final = 245
"""A line looked through for DATA, beside its characters."""
CONSTANT: Final = {"i": 471, "s": 1540, "d": 1360}
"""A constant of a type, beside what its characters and its value take."""
STRING_LITERAL: Final = 800
STRING_CHARACTER: Final = 55
VARIABLE: Final = 847
SCALAR_OTHER_KIND: Final = 163
SCALAR_OTHER_NAME: Final = 227
NEW_SCALAR: Final = 1540
NEW_SCALAR_BYTE: Final = 93
"""A new simple variable, and each byte of the arrays that it moves up."""
ARRAY: Final = 167
ARRAY_OTHER: Final = 127
SUBSCRIPT: Final = 1560
NEW_ARRAY: Final = 834
NEW_ARRAY_BYTE: Final = 81
CONVERT: Final = {"n": 0, "s": 890, "d": 1380, "x": 655}
"""A number of a type made an integer (CINT, PEEK, AND, subscripts)."""
FLOOR: Final = {"i": 0, "n": 0, "s": 881, "d": 1620, "x": 2000}
"""INT and FIX of a number, beside those of an integer."""
NUMBER_TEXT: Final = {"i": -6990, "s": -6490, "d": -4220}
"""A number's text, beside what its digits take."""
NAME_LETTER: Final = 59
"""A letter or digit of a name behind the first, beside its fetching."""
KIND_BY_LETTER: Final = 78
"""The type of a name without a type sign looked up."""
FETCH: Final = {"i": 76, "s": 117, "d": 414, "t": 0}
"""A variable's value brought in, by its type."""

# -- arithmetic, by the types of the operands -----------------------------------------------------
BINARY: Final[dict[str, dict[str, int]]] = {
    "add": {"ii": 79, "is": 1560, "si": 1560, "ss": 932, "d": 1480, "di": 1030, "ds": 170},
    "sub": {"ii": 132, "is": 1600, "si": 1450, "ss": 838, "d": 1650, "di": 920, "ds": 0},
    "mul": {"ii": 1260, "is": 2460, "si": 2560, "ss": 1800, "d": 1230, "di": 1220, "ds": 291},
    "div": {"ii": 9210, "is": 8660, "si": 8400, "ss": 7800, "d": 863, "di": 2060, "ds": 925},
    "compare": {"ii": 178, "is": 1060, "si": 1250, "ss": 516, "d": 1190, "di": 1060, "ds": 392},
}
"""An operation by the types left and right; with a double on either side `d`, and what the
conversion of the other operand takes."""
STORE: Final = {
    "ii": 234,
    "is": 346,
    "id": 374,
    "ss": 231,
    "si": 843,
    "sd": 699,
    "dd": 413,
    "di": 1240,
    "ds": 544,
}
"""A number put into a variable: the variable's type, then the value's."""
STORE_STRING: Final = 253
COMPARE_STRINGS: Final = 221
NEGATE: Final = 103
LOGICAL: Final = 277
POWER: Final = 79900

FUNCTION: Final = 139
FUNCTION_WORK: Final[dict[str, int]] = {
    "SGN": 186,
    "INT": 196,
    "ABS": 125,
    "FRE": 415,
    "INP": 300,
    "POS": 150,
    "SQR": 73100,
    "RND": 8370,
    "LOG": 34000,
    "EXP": 42000,
    "COS": 43700,
    "SIN": 42200,
    "TAN": 94000,
    "ATN": 50000,
    "PEEK": 292,
    "CINT": 230,
    "CSNG": 193,
    "CDBL": 194,
    "FIX": 411,
    "LEN": 247,
    "STR$": 1060,
    "VAL": 0,
    "ASC": 334,
    "CHR$": 1190,
    "LEFT$": 1790,
    "RIGHT$": 1620,
    "MID$": 2130,
    "STRING$": 1400,
    "POINT": 1520,
    "INKEY$": 1080,
    "MEM": 304,
    "VARPTR": 410,
    "USR": 301,
    "ERR": 154,
    "ERL": 204,
}

# -- statements -----------------------------------------------------------------------------------
STATEMENT_WORK: Final[dict[str, int]] = {
    "LET": 410,
    "FOR": 1620,
    "NEXT": 2320,
    "NEXT_INTEGER": 919,
    "GOTO": 449,
    "GOSUB": 644,
    "RETURN": 687,
    "IF": 238,
    "ON": 449,
    "READ": 1750,
    "RESTORE": 175,
    "SET": 1300,
    "RESET": 1500,
    "POKE": 531,
    "OUT": 661,
    "CLS": 99,
    "DIM": 273,
    "PRINT": 284,
    "PRINT_ITEM": 272,
    "PRINT@": 311,
    "TAB": 313,
    "CLEAR": 1520,
    "RUN": 1310,
    "ERROR": 619,
    "RESUME": 615,
    "ON ERROR": 487,
    "DEF": 319,
    "RANDOM": 100,
    "END": 300,
}
PRINT_CHARACTER: Final = 68
"""PRINT's own loop for a character, beside the display driver's time."""
USING_FIELD: Final = 2930
"""A field of PRINT USING, beside the number's conversion."""

# -- strings --------------------------------------------------------------------------------------
STRING_BYTE: Final = 59
CONCATENATE: Final = 914
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


def number_field(value: Number, places: int, right: int | None) -> int:
    """T-states of a field of PRINT USING.

    Args:
        value: the number.
        places: the characters of the field.
        right: places behind the point; None when the field has an exponent.
    """
    return USING_FIELD + number_text(value, " ")


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
