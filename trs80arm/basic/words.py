"""The reserved words of Level II: one table, a row a word.

The cruncher turns typed words into tokens, LIST turns them back, and the compiler reads a program
in tokens; a word's token is its place in the table (Level II facts, Crunching). A row also says how
the compiler reads the word, what it gives, which routine of the runtime does its work and what that
takes: a new function is a row here and its routine there. The T-states come from the same
measurements as those in `costs`.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Final

from trs80arm.basic.kinds import ANY, DOUBLE, INTEGER, NUMBER, SINGLE, STRING, Kind

FIRST: Final = 128
"""The token of the first word."""


class Role(Enum):
    """What a word is in a line."""

    STATEMENT = "begins a statement"
    DISK = "begins a statement of Disk BASIC"
    FUNCTION = "begins an operand"
    OPERATOR = "stands between operands"
    PART = "belongs to the statement around it"


@dataclass(frozen=True)
class Word:
    """One row.

    Attributes:
        spelling: in capitals.
        role: what it is.
        parser: how it is read. For a statement the part of the statement compiler and its method,
            for a function the method of the function compiler.
        gives: the kind of its result; for DEFINT and so on, the type of names.
        calls: the routine of the runtime that does its work.
        work: T-states beside its characters and operands; what else it takes the routine charges.
        unless_zero: T-states more unless its argument is a plain 0.
        observes: whether it looks at the machine, so that the clock must be right.
        plain: whether it may stand in a block, unless something in it may not.
        paced: whether it may take any time, as what collects garbage: in a block the clock is
            looked at behind its statement.
    """

    spelling: str
    role: Role
    parser: str = ""
    gives: Kind | None = None
    calls: str = ""
    work: int = 0
    unless_zero: int = 0
    observes: bool = False
    plain: bool = False
    paced: bool = False


def _statement(
    spelling: str,
    parser: str,
    calls: str = "",
    *,
    work: int = 0,
    gives: Kind | None = None,
    observes: bool = False,
    plain: bool = False,
    paced: bool = False,
) -> Word:
    kind = Role.STATEMENT
    return Word(spelling, kind, parser, gives, calls, work, 0, observes, plain, paced)


def _function(
    spelling: str,
    parser: str,
    calls: str,
    gives: Kind | None,
    work: int,
    *,
    unless_zero: int = 0,
    observes: bool = False,
    plain: bool = True,
    paced: bool = False,
) -> Word:
    kind = Role.FUNCTION
    return Word(spelling, kind, parser, gives, calls, work, unless_zero, observes, plain, paced)


def _disk(*spellings: str) -> tuple[Word, ...]:
    """Statements of Disk BASIC: ?L3."""
    return tuple(Word(spelling, Role.DISK) for spelling in spellings)


def _disk_function(*spellings: str) -> tuple[Word, ...]:
    """Functions of Disk BASIC: ?L3 when their argument has been evaluated."""
    return tuple(_function(spelling, "disk_of_argument", "", None, 0) for spelling in spellings)


def _part(spelling: str, work: int = 0) -> Word:
    return Word(spelling, Role.PART, work=work)


def _operator(spelling: str) -> Word:
    return Word(spelling, Role.OPERATOR)


TABLE: Final[tuple[Word, ...]] = (
    _statement("END", "commands.end"),
    _statement("FOR", "loops.for_", work=1850, plain=True),
    _statement("RESET", "hardware.reset_block", "plot", work=1480, observes=True, plain=True),
    _statement("SET", "hardware.set_block", "plot", work=1480, observes=True, plain=True),
    _statement("CLS", "hardware.clear_screen", "clear_screen", work=95),
    *_disk("CMD"),
    _statement("RANDOM", "hardware.random", "randomize"),
    _statement("NEXT", "loops.next_", work=2440, plain=True),
    _statement("DATA", "commands.data", plain=True),
    _statement("INPUT", "assignments.input"),
    _statement("DIM", "assignments.dim", "dimension", work=243),
    _statement("READ", "assignments.read", work=1315, plain=True, paced=True),
    _statement("LET", "assignments.let", work=453, plain=True),
    _statement("GOTO", "flow.goto_statement", work=637, plain=True),
    _statement("RUN", "flow.run", "start_program", work=1310),
    _statement("IF", "flow.if_", work=429, plain=True),
    _statement("RESTORE", "flow.restore", "restore", work=131, plain=True),
    _statement("GOSUB", "flow.gosub_statement", work=895, plain=True),
    _statement("RETURN", "flow.return_", "close_subroutine", work=415, plain=True),
    _statement("REM", "commands.remark", work=114, plain=True),
    _statement("STOP", "commands.stop"),
    _statement("ELSE", "commands.remark", plain=True),
    _statement("TRON", "commands.trace_on", "trace"),
    _statement("TROFF", "commands.trace_off", "trace"),
    _statement("DEFSTR", "assignments.define", "define", work=257, gives=STRING),
    _statement("DEFINT", "assignments.define", "define", work=257, gives=INTEGER),
    _statement("DEFSNG", "assignments.define", "define", work=257, gives=SINGLE),
    _statement("DEFDBL", "assignments.define", "define", work=257, gives=DOUBLE),
    *_disk("LINE"),
    _statement("EDIT", "commands.with_text", "edit_line"),
    _statement("ERROR", "flow.error", "raise_error", work=619),
    _statement("RESUME", "flow.resume", work=250),
    _statement("OUT", "hardware.out", "write_port", work=897, observes=True, plain=True),
    _statement("ON", "flow.on", work=605, plain=True),
    *_disk("OPEN", "FIELD", "GET", "PUT", "CLOSE", "LOAD", "MERGE", "NAME", "KILL", "LSET"),
    *_disk("RSET", "SAVE"),
    _statement("SYSTEM", "tape.system", "begin_system"),
    _statement("LPRINT", "output.lprint", work=360),
    *_disk("DEF"),
    _statement("POKE", "hardware.poke", "poke", work=527, observes=True, plain=True),
    _statement("PRINT", "output.print", work=360),
    _statement("CONT", "commands.cont", "continue_program"),
    _statement("LIST", "commands.with_text", "list_lines"),
    _statement("LLIST", "commands.with_text", "list_printer"),
    _statement("DELETE", "commands.with_text", "delete_lines"),
    _statement("AUTO", "commands.with_text", "auto_lines"),
    _statement("CLEAR", "assignments.clear", work=1520),
    _statement("CLOAD", "tape.cload", "begin_cload"),
    _statement("CSAVE", "tape.csave", "begin_csave"),
    _statement("NEW", "commands.new", "new_program"),
    _part("TAB(", work=251),
    _part("TO"),
    _function("FN", "disk", "", None, 0),
    _part("USING"),
    _function("VARPTR", "varptr", "", INTEGER, 181),
    _function("USR", "of_anything", "user_routine", ANY, 301, observes=True, plain=False),
    _function("ERL", "of_nothing", "error_line", SINGLE, 421),
    _function("ERR", "of_nothing", "error_code", NUMBER, 117),
    _function("STRING$", "characters", "string_of", STRING, 2230, paced=True),
    _function("INSTR", "disk", "", None, 0),
    _function("POINT", "of_place", "point", INTEGER, 1500, observes=True),
    _function("TIME$", "disk", "", None, 0),
    _function("MEM", "memory", "free_memory", SINGLE, 128),
    _function("INKEY$", "of_nothing", "inkey", STRING, 1370, observes=True, paced=True),
    _part("THEN"),
    _operator("NOT"),
    _part("STEP", work=480),
    *(_operator(sign) for sign in ("+", "-", "*", "/", "[", "AND", "OR", ">", "=", "<")),
    _function("SGN", "of_number", "sign", INTEGER, 430),
    _function("INT", "rounding", "any_floor", None, 145),
    _function("ABS", "magnitude", "absolute", None, 129),
    _function("FRE", "free_space", "free_after", SINGLE, 156, paced=True),
    _function("INP", "of_byte", "read_port", INTEGER, 389, observes=True),
    _function("POS", "of_anything", "position", INTEGER, 142),
    _function("SQR", "of_single", "sqr", SINGLE, 0),
    _function("RND", "of_integer", "rnd", SINGLE, 4940, unless_zero=6080),
    _function("LOG", "of_single", "log", SINGLE, 0),
    _function("EXP", "of_single", "exp", SINGLE, 0),
    _function("COS", "of_single", "cos", SINGLE, 0),
    _function("SIN", "of_single", "sin", SINGLE, 0),
    _function("TAN", "of_single", "tan", SINGLE, 0),
    _function("ATN", "of_single", "atn", SINGLE, 0),
    _function("PEEK", "of_integer", "peek", INTEGER, 222, observes=True),
    *_disk_function("CVI", "CVS", "CVD", "EOF", "LOC", "LOF", "MKI$", "MKS$", "MKD$"),
    _function("CINT", "converted", "", INTEGER, 169),
    _function("CSNG", "converted", "", SINGLE, 220),
    _function("CDBL", "converted", "", DOUBLE, 247),
    _function("FIX", "rounding", "fix", None, 306),
    _function("LEN", "length", "len_", INTEGER, 254),
    _function("STR$", "of_shown", "str_", STRING, 1360, paced=True),
    _function("VAL", "of_string", "val_", ANY, 3, paced=True),
    _function("ASC", "of_string", "asc_", INTEGER, 425),
    _function("CHR$", "of_code", "chr_", STRING, 1620, paced=True),
    _function("LEFT$", "part_of_string", "left", STRING, 2300, paced=True),
    _function("RIGHT$", "part_of_string", "right", STRING, 2320, paced=True),
    _function("MID$", "part_of_string", "middle", STRING, 2760, paced=True),
    _part("'"),
)
"""The words in the order of their tokens, 128 to 251."""

SPELLINGS: Final = tuple(word.spelling.encode("ascii") for word in TABLE)
"""The words as typed, in the order of their tokens."""
BY_TOKEN: Final = dict(enumerate(TABLE, FIRST))
TOKENS: Final = {row.spelling: token for token, row in BY_TOKEN.items()}
FUNCTIONS: Final = frozenset(t for t, row in BY_TOKEN.items() if row.role is Role.FUNCTION)
"""The tokens that can begin an operand."""
DISK: Final = frozenset(t for t, row in BY_TOKEN.items() if row.role is Role.DISK)
"""The tokens of Disk BASIC's statements."""
STATEMENTS: Final = frozenset(t for t, row in BY_TOKEN.items() if row.role is Role.STATEMENT)
"""The tokens that can begin a statement."""
CALLS: Final = frozenset(row.calls for row in TABLE if row.calls)
"""The routines of the runtime that rows name."""


def word(spelling: str) -> Word:
    """The row of a word in capitals."""
    return BY_TOKEN[TOKENS[spelling]]
