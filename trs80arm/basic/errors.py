"""The errors of Level II BASIC: twenty-three codes, each with its two letters.

Everything in `basic` that the user can get wrong raises `BasicError`. The interpreter's wheel
hands it to the execution under way, which prints `?SN Error in 10` or goes to the program's ON
ERROR line.
"""

from __future__ import annotations

from enum import IntEnum


class Code(IntEnum):
    """The error codes in the order of the ROM (Level II facts, section Statements, ERROR)."""

    NF = 1  # NEXT without FOR
    SN = 2  # syntax
    RG = 3  # RETURN without GOSUB
    OD = 4  # out of DATA
    FC = 5  # illegal function call
    OV = 6  # overflow
    OM = 7  # out of memory
    UL = 8  # undefined line
    BS = 9  # subscript out of range
    DD = 10  # array dimensioned twice
    DIVISION = 11  # division by zero, shown as /0
    ID = 12  # illegal in direct mode
    TM = 13  # type mismatch
    OS = 14  # out of string space
    LS = 15  # string too long
    ST = 16  # string formula too complex
    CN = 17  # cannot continue
    NR = 18  # no RESUME
    RW = 19  # RESUME without error
    UE = 20  # unprintable error
    MO = 21  # missing operand
    FD = 22  # bad file data
    L3 = 23  # Disk BASIC only

    @property
    def letters(self) -> str:
        """The two characters that the ROM prints, `/0` for a division by zero."""
        return "/0" if self is Code.DIVISION else self.name


class BasicError(Exception):
    """A Level II error on its way to the interpreter's wheel.

    Args:
        code: the error.
    """

    def __init__(self, code: Code) -> None:
        super().__init__(f"?{code.letters} Error")
        self.code = code


class LineError(BasicError):
    """An error that belongs to another line than the one being executed (a wrong DATA item).

    Args:
        code: the error.
        line: where it is reported.
    """

    def __init__(self, code: Code, line: int) -> None:
        super().__init__(code)
        self.line = line
