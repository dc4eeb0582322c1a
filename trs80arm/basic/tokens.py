"""The tokens that the code names: a word's place in the table of `words`."""

from __future__ import annotations

from trs80arm.basic.words import FIRST as FIRST
from trs80arm.basic.words import TOKENS

RESET = TOKENS["RESET"]
SET = TOKENS["SET"]
DATA = TOKENS["DATA"]
INPUT = TOKENS["INPUT"]
READ = TOKENS["READ"]
GOTO = TOKENS["GOTO"]
IF = TOKENS["IF"]
GOSUB = TOKENS["GOSUB"]
REM = TOKENS["REM"]
ELSE = TOKENS["ELSE"]
ERROR = TOKENS["ERROR"]
CLOSE = TOKENS["CLOSE"]
PRINT = TOKENS["PRINT"]
NEXT = TOKENS["NEXT"]
TAB = TOKENS["TAB("]
TO = TOKENS["TO"]
USING = TOKENS["USING"]
THEN = TOKENS["THEN"]
NOT = TOKENS["NOT"]
STEP = TOKENS["STEP"]
PLUS = TOKENS["+"]
MINUS = TOKENS["-"]
TIMES = TOKENS["*"]
DIVIDE = TOKENS["/"]
POWER = TOKENS["["]
AND = TOKENS["AND"]
OR = TOKENS["OR"]
GREATER = TOKENS[">"]
EQUAL = TOKENS["="]
LESS = TOKENS["<"]
APOSTROPHE = TOKENS["'"]
