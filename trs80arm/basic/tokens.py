"""The reserved words of Level II and the bytes that stand for them in a stored line.

The cruncher turns typed words into tokens, LIST turns them back, and the compiler reads a program
in tokens. The numbering is the ROM's (Level II facts, Crunching).
"""

from __future__ import annotations

from typing import Final

FIRST: Final = 128
"""The token of the first word."""

WORDS: Final[tuple[bytes, ...]] = tuple(
    (
        b"END FOR RESET SET CLS CMD RANDOM NEXT DATA INPUT DIM READ LET GOTO RUN IF RESTORE GOSUB "
        b"RETURN REM STOP ELSE TRON TROFF DEFSTR DEFINT DEFSNG DEFDBL LINE EDIT ERROR RESUME OUT "
        b"ON OPEN FIELD GET PUT CLOSE LOAD MERGE NAME KILL LSET RSET SAVE SYSTEM LPRINT DEF POKE "
        b"PRINT CONT LIST LLIST DELETE AUTO CLEAR CLOAD CSAVE NEW TAB( TO FN USING VARPTR USR ERL "
        b"ERR STRING$ INSTR POINT TIME$ MEM INKEY$ THEN NOT STEP + - * / [ AND OR > = < SGN INT "
        b"ABS FRE INP POS SQR RND LOG EXP COS SIN TAN ATN PEEK CVI CVS CVD EOF LOC LOF MKI$ MKS$ "
        b"MKD$ CINT CSNG CDBL FIX LEN STR$ VAL ASC CHR$ LEFT$ RIGHT$ MID$ '"
    ).split()
)
"""The words in the order of their tokens, 128 to 251."""

TOKENS: Final[dict[bytes, int]] = {word: FIRST + i for i, word in enumerate(WORDS)}
"""Word to token."""


def token(word: str) -> int:
    """The token of a reserved word given in capitals."""
    return TOKENS[word.encode("ascii")]


END = token("END")
FOR = token("FOR")
RESET = token("RESET")
SET = token("SET")
DATA = token("DATA")
INPUT = token("INPUT")
READ = token("READ")
GOTO = token("GOTO")
RUN = token("RUN")
GOSUB = token("GOSUB")
REM = token("REM")
ELSE = token("ELSE")
ERROR = token("ERROR")
CLOSE = token("CLOSE")
PRINT = token("PRINT")
NEXT = token("NEXT")
TAB = token("TAB(")
TO = token("TO")
FN = token("FN")
USING = token("USING")
VARPTR = token("VARPTR")
USR = token("USR")
ERL = token("ERL")
ERR = token("ERR")
STRING = token("STRING$")
INSTR = token("INSTR")
POINT = token("POINT")
TIME = token("TIME$")
MEM = token("MEM")
INKEY = token("INKEY$")
THEN = token("THEN")
NOT = token("NOT")
STEP = token("STEP")
PLUS = token("+")
MINUS = token("-")
TIMES = token("*")
DIVIDE = token("/")
POWER = token("[")
AND = token("AND")
OR = token("OR")
GREATER = token(">")
EQUAL = token("=")
LESS = token("<")
SGN = token("SGN")
APOSTROPHE = token("'")

FUNCTIONS: Final = frozenset(
    {VARPTR, USR, ERL, ERR, STRING, INSTR, POINT, TIME, MEM, INKEY, FN}
) | frozenset(range(SGN, APOSTROPHE))
"""The words that can begin an operand."""
