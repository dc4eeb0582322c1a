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
STATEMENT: Final = 961
"""One turn of the statement loop: the keyboard looked at, the separator, the jump by token."""
NEW_LINE: Final = 118
"""A new line: its number stored."""
CHARACTER: Final = 52
"""One character of the text fetched: a letter, a token or a colon."""
LOW_CHARACTER: Final = 85
"""A digit or any other character below the colon, which is looked at more closely."""
BLANK: Final = 42
"""A blank passed on the way to a character."""
SKIPPED: Final = 96
"""One character of the text passed without a look (REM, DATA, false IF, GOTO's rest of line)."""
LINE_PASSED: Final = 89
"""One line passed in the search for a line number."""
LINE_DIGIT: Final = 160
"""One digit of a line number."""
KEY_LATCHED: Final = 52
"""A key that the statement loop puts aside for INKEY$."""

# -- operands -------------------------------------------------------------------------------------
OPERAND: Final = 480
OPERATOR: Final = 586
PARENTHESES: Final = 372
DATA_LINE: Final = 206
"""A line looked through for DATA, beside its characters."""
CONSTANT: Final = 439
"""A constant, beside what its characters and its value take."""
STRING_LITERAL: Final = 822
STRING_CHARACTER: Final = 75
VARIABLE: Final = 1070
SCALAR_OTHER_KIND: Final = 111
SCALAR_OTHER_NAME: Final = 186
NEW_SCALAR: Final = 1570
ARRAY: Final = 1460
ARRAY_OTHER: Final = 132
SUBSCRIPT: Final = 1260
NEW_ARRAY: Final = 2340
NEW_ARRAY_BYTE: Final = 78
CONVERT: Final = 300
NAME_LETTER: Final = 80
"""A letter or digit of a name behind the first, beside its fetching."""
KIND_BY_LETTER: Final = 55
"""The type of a name without a type sign looked up."""
FETCH: Final = {"i": 50, "s": 120, "d": 250, "t": 300}
"""A variable's value brought in, by its type."""

# -- arithmetic, by the types of the operands -----------------------------------------------------
BINARY: Final[dict[str, dict[str, int]]] = {
    "add": {"ii": 200, "is": 1000, "si": 1000, "ss": 850, "d": 2600, "di": 3000, "ds": 3000},
    "sub": {"ii": 200, "is": 1000, "si": 1000, "ss": 850, "d": 2600, "di": 3000, "ds": 3000},
    "mul": {"ii": 1200, "is": 3000, "si": 3000, "ss": 2500, "d": 16000, "di": 3000, "ds": 3000},
    "div": {"ii": 9000, "is": 8500, "si": 8500, "ss": 8000, "d": 2600, "di": 3000, "ds": 3000},
    "compare": {"ii": 250, "is": 600, "si": 600, "ss": 400, "d": 600, "di": 700, "ds": 700},
}
"""An operation by the types left and right; with a double on either side `d`, and what the
conversion of the other operand takes."""
STORE: Final = {"ii": 200, "is": 700, "id": 1000, "ss": 250, "si": 600, "sd": 600}
STORE.update({"dd": 400, "di": 900, "ds": 600})
"""A number put into a variable: the variable's type, then the value's."""
STORE_STRING: Final = 500
COMPARE_STRINGS: Final = 700
NEGATE: Final = 150
LOGICAL: Final = 382
POWER: Final = 79900

FUNCTION: Final = 463
FUNCTION_WORK: Final[dict[str, int]] = {
    "SGN": 149,
    "INT": 858,
    "ABS": 149,
    "FRE": 415,
    "INP": 300,
    "POS": 150,
    "SQR": 73100,
    "RND": 8370,
    "LOG": 34000,
    "EXP": 42000,
    "COS": 47000,
    "SIN": 36700,
    "TAN": 88800,
    "ATN": 50000,
    "PEEK": 292,
    "CINT": 300,
    "CSNG": 200,
    "CDBL": 200,
    "FIX": 850,
    "LEN": 249,
    "STR$": 3780,
    "VAL": 2710,
    "ASC": 297,
    "CHR$": 775,
    "LEFT$": 1130,
    "RIGHT$": 1180,
    "MID$": 1370,
    "STRING$": 917,
    "POINT": 1520,
    "INKEY$": 895,
    "MEM": 304,
    "VARPTR": 410,
    "USR": 301,
    "ERR": 154,
    "ERL": 204,
}

# -- statements -----------------------------------------------------------------------------------
STATEMENT_WORK: Final[dict[str, int]] = {
    "LET": 511,
    "FOR": 2110,
    "NEXT": 964,
    "NEXT_INTEGER": 655,
    "GOTO": 414,
    "GOSUB": 644,
    "RETURN": 687,
    "IF": 304,
    "ON": 403,
    "READ": 1220,
    "RESTORE": 200,
    "SET": 1640,
    "RESET": 1500,
    "POKE": 531,
    "OUT": 401,
    "CLS": 100,
    "DIM": 299,
    "PRINT": 354,
    "PRINT_ITEM": 292,
    "PRINT@": 394,
    "TAB": 447,
    "CLEAR": 1520,
    "RUN": 1310,
    "ERROR": 619,
    "RESUME": 615,
    "ON ERROR": 487,
    "DEF": 892,
    "RANDOM": 100,
    "END": 300,
}
PRINT_CHARACTER: Final = 136
"""PRINT's own loop for a character, beside the display driver's time."""
USING_FIELD: Final = 2930
"""A field of PRINT USING, beside the number's conversion."""

# -- strings --------------------------------------------------------------------------------------
STRING_BYTE: Final = 28
CONCATENATE: Final = 1450
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


def constant(text: bytes, is_double: bool = False) -> int:
    """T-states to convert a constant each time it is executed.

    Args:
        text: its characters, blanks included.
        is_double: whether the conversion begins in double precision (VAL).
    """
    return CONSTANT + number_costs.literal(text, is_double)


def number_field(value: Number, places: int, right: int | None) -> int:
    """T-states of a field of PRINT USING.

    Args:
        value: the number.
        places: the characters of the field.
        right: places behind the point; None when the field has an exponent.
    """
    return USING_FIELD + number_costs.text(value, " ")


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
