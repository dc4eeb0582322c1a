"""How many T-states of the Z-80 each thing takes that the interpreter in the ROM does.

The compiler adds these numbers up, statement by statement, the way the ROM walks through the text:
every character read, every constant converted, every variable searched for. They were fitted to
the times that the original needed for the programs of the conformance cases and of the benchmarks
(Level II facts, Speed); 1,774,080 T-states are a second.
"""

from __future__ import annotations

import math
from typing import Final

# -- the statement loop ---------------------------------------------------------------------------
STATEMENT: Final = 850
"""One turn of the statement loop: the keyboard looked at, the separator, the jump by token."""
NEW_LINE: Final = 120
"""A new line: its number stored."""
CHARACTER: Final = 60
"""One character of the text passed by the ROM's fetch routine."""
SKIPPED: Final = 30
"""One character of the text passed without a look (REM, DATA, false IF, GOTO's rest of line)."""
LINE_PASSED: Final = 92
"""One line passed in the search for a line number."""
LINE_DIGIT: Final = 160
"""One digit of a line number."""
KEY_LATCHED: Final = 52
"""A key that the statement loop puts aside for INKEY$."""

# -- operands -------------------------------------------------------------------------------------
OPERAND: Final = 350
OPERATOR: Final = 500
PARENTHESES: Final = 400
DATA_LINE: Final = 200
"""A line looked through for DATA, beside its characters."""
CONSTANT: Final = 350
CONSTANT_DIGIT: Final = 260
CONSTANT_DIGIT_SINGLE: Final = 1400
CONSTANT_DIGIT_DOUBLE: Final = 2600
CONSTANT_SCALE_UP: Final = 1200
CONSTANT_SCALE_DOWN: Final = 9000
CONSTANT_SCALE_DOWN_DOUBLE: Final = 24000
STRING_LITERAL: Final = 700
STRING_CHARACTER: Final = 50
VARIABLE: Final = 900
SCALAR_OTHER_KIND: Final = 75
SCALAR_OTHER_NAME: Final = 90
NEW_SCALAR: Final = 1500
ARRAY: Final = 1500
ARRAY_OTHER: Final = 130
SUBSCRIPT: Final = 1300
NEW_ARRAY: Final = 2500
NEW_ARRAY_BYTE: Final = 26
CONVERT: Final = 300
MOVE: Final = 120
MOVE_DOUBLE: Final = 250

# -- arithmetic, by the type of the result --------------------------------------------------------
ADD: Final = {"i": 200, "n": 300, "s": 850, "d": 2600, "x": 1500}
MULTIPLY: Final = {"i": 1200, "n": 1500, "s": 3200, "d": 16000, "x": 6000}
DIVIDE: Final = {"i": 8000, "n": 8000, "s": 8000, "d": 46000, "x": 20000}
COMPARE: Final = {"i": 250, "n": 300, "s": 500, "d": 700, "x": 600, "t": 700}
NEGATE: Final = 150
LOGICAL: Final = 400
POWER: Final = 85000

FUNCTION: Final = 500
FUNCTION_WORK: Final[dict[str, int]] = {
    "SGN": 150,
    "INT": 900,
    "ABS": 150,
    "FRE": 400,
    "INP": 300,
    "POS": 150,
    "SQR": 88000,
    "RND": 13000,
    "LOG": 33000,
    "EXP": 40000,
    "COS": 38000,
    "SIN": 36000,
    "TAN": 85000,
    "ATN": 42000,
    "PEEK": 300,
    "CINT": 300,
    "CSNG": 200,
    "CDBL": 200,
    "FIX": 900,
    "LEN": 250,
    "STR$": 6000,
    "VAL": 3000,
    "ASC": 300,
    "CHR$": 700,
    "LEFT$": 1100,
    "RIGHT$": 1100,
    "MID$": 1300,
    "STRING$": 900,
    "POINT": 1500,
    "INKEY$": 900,
    "MEM": 300,
    "VARPTR": 400,
    "USR": 300,
    "ERR": 150,
    "ERL": 200,
}

# -- statements -----------------------------------------------------------------------------------
STATEMENT_WORK: Final[dict[str, int]] = {
    "LET": 500,
    "FOR": 2500,
    "NEXT": 1100,
    "NEXT_INTEGER": 700,
    "GOTO": 400,
    "GOSUB": 650,
    "RETURN": 700,
    "IF": 300,
    "ON": 400,
    "READ": 900,
    "RESTORE": 200,
    "SET": 1500,
    "RESET": 1500,
    "POKE": 500,
    "OUT": 400,
    "CLS": 100,
    "DIM": 300,
    "PRINT": 400,
    "PRINT_ITEM": 300,
    "PRINT@": 400,
    "TAB": 500,
    "CLEAR": 1500,
    "RUN": 1500,
    "ERROR": 600,
    "RESUME": 600,
    "ON ERROR": 500,
    "DEF": 900,
    "RANDOM": 100,
    "END": 300,
}
PRINT_CHARACTER: Final = 68
"""PRINT's own loop for a character, beside the display driver's time."""
NUMBER_TEXT: Final = 2500
NUMBER_DIGIT_INTEGER: Final = 600
NUMBER_SINGLE: Final = 7000
NUMBER_SCALE_SINGLE: Final = 2500
NUMBER_DOUBLE: Final = 60000
NUMBER_SCALE_DOUBLE: Final = 22000
NUMBER_CHARACTER: Final = 200
USING_FIELD: Final = 2500
"""A field of PRINT USING, beside the number's conversion."""

# -- strings --------------------------------------------------------------------------------------
STRING_BYTE: Final = 22
STRING_ASSIGN: Final = 500
CONCATENATE: Final = 1500
COLLECT: Final = 500
COLLECT_PASS: Final = 800
COLLECT_DESCRIPTOR: Final = 180
COLLECT_NUMBER: Final = 60

# -- errors and commands --------------------------------------------------------------------------
ERROR_RAISED: Final = 900
"""From the error to the first character of its message, or to the ON ERROR line."""


def constant(text: bytes, value: object) -> int:
    """T-states to convert a constant each time it is executed.

    Args:
        text: its characters, blanks included.
        value: what it comes to: `int`, `float` or a double.
    """
    digits = sum(0x30 <= code <= 0x39 for code in text)
    total = CONSTANT + CHARACTER * len(text)
    if isinstance(value, int):
        return total + digits * CONSTANT_DIGIT
    body, _, exponent = text.upper().partition(b"E")
    if not exponent:
        body, _, exponent = text.upper().partition(b"D")
    decimals = len(body.partition(b".")[2].rstrip(b"!# "))
    number = b"".join(bytes((c,)) for c in exponent if 0x30 <= c <= 0x39)
    places = (int(number or b"0") * (-1 if b"\xce" in exponent else 1)) - decimals
    if isinstance(value, float):
        total += digits * CONSTANT_DIGIT_SINGLE
        down = CONSTANT_SCALE_DOWN
    else:
        total += digits * CONSTANT_DIGIT_DOUBLE
        down = CONSTANT_SCALE_DOWN_DOUBLE
    return total + (places * CONSTANT_SCALE_UP if places > 0 else -places * down)


def number_text(value: object, text: str) -> int:
    """T-states to turn a number into the characters that PRINT and STR$ show.

    Args:
        value: `int`, `float` or a double.
        text: what it came to.
    """
    total = NUMBER_TEXT + NUMBER_CHARACTER * len(text)
    if isinstance(value, int):
        return total + NUMBER_DIGIT_INTEGER * len(text)
    if isinstance(value, float):
        steps = abs(5 - math.floor(math.log10(abs(value)))) if value else 0
        return total + NUMBER_SINGLE + NUMBER_SCALE_SINGLE * steps
    exponent = getattr(value, "exponent", 0)
    steps = abs(15 - math.floor((exponent - 128) * 0.30103)) if exponent else 0
    return total + NUMBER_DOUBLE + NUMBER_SCALE_DOUBLE * steps
