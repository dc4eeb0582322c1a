"""A program as a list of statements: what each reads and sets, and where it goes.

The statements of all lines stand in one list. An IF is followed by the statements of its THEN, and
knows where those of its ELSE begin; a line number behind THEN or ELSE is a GOTO.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from typing import Final

from trs80arm.basic import characters, tokens, words
from trs80arm.basic.characters import AT, COMMA, NUMBER_SIGN, SEMICOLON
from trs80arm.basic.compiler.arm import JOINTS
from trs80arm.check.expressions import Expression, Text, Unreadable, Variable, variables

END = words.TOKENS["END"]
STOP = words.TOKENS["STOP"]
FOR = words.TOKENS["FOR"]
DIM = words.TOKENS["DIM"]
LET = words.TOKENS["LET"]
RUN = words.TOKENS["RUN"]
NEW = words.TOKENS["NEW"]
ON = words.TOKENS["ON"]
RESUME = words.TOKENS["RESUME"]
RESTORE = words.TOKENS["RESTORE"]
RETURN = words.TOKENS["RETURN"]
LPRINT = words.TOKENS["LPRINT"]
POKE = words.TOKENS["POKE"]
OUT = words.TOKENS["OUT"]
CLEAR = words.TOKENS["CLEAR"]
VARPTR = words.TOKENS["VARPTR"]
DEFINES: Final = frozenset(
    token for token, word in words.BY_TOKEN.items() if word.parser == "assignments.define"
)
UNREAD: Final = 0
"""The word of what could not be read."""


@dataclass(slots=True)
class Statement:
    """One statement.

    Attributes:
        line: the number of its line.
        position: how much of the line's crunched text stands before it.
        word: its token; LET where none is written.
        arm: whether an `@` stands before the word.
        reads: the expressions in it, in the order in which they are evaluated.
        sets: the variables that it sets; of a NEXT, those it names.
        targets: the line numbers in it.
        calls: whether an ON is an ON GOSUB.
        traps: whether an ON is an ON ERROR.
        onward: whether a RESUME is a RESUME NEXT.
        text: of a DEFINT and so on, of a DATA and of a REM, what stands behind the word.
        text_at: how much of the line's crunched text stands before that.
        otherwise: the place in the program of what an IF does when it is false; behind a true one,
            where its ELSE goes on.
    """

    line: int
    position: int
    word: int = UNREAD
    arm: bool = False
    reads: list[Expression] = field(default_factory=list)
    sets: list[Variable] = field(default_factory=list)
    targets: list[int] = field(default_factory=list)
    calls: bool = False
    traps: bool = False
    onward: bool = False
    text: bytes = b""
    text_at: int = 0
    otherwise: int = -1

    def used(self) -> Iterator[Variable]:
        """The variables whose values it reads, those in subscripts of what it sets too."""
        for expression in self.reads:
            yield from variables(expression)
        for variable in self.sets:
            for subscript in variable.subscripts or ():
                yield from variables(subscript)


@dataclass(frozen=True)
class Statements:
    """The statements of a program.

    Attributes:
        all: of them, in order.
        starts: of each line that is there, the place of its first statement.
    """

    all: list[Statement]
    starts: dict[int, int]

    @classmethod
    def read(cls, lines: Iterable[tuple[int, bytes]]) -> Statements:
        """The statements of a program.

        Args:
            lines: line numbers, rising, and crunched texts.
        """
        found: list[Statement] = []
        starts: dict[int, int] = {}
        for number, text in lines:
            first = starts[number] = len(found)
            found += _statements(number, text)
            _join(found, first)
        return cls(found, starts)


def _statements(number: int, line: bytes) -> Iterator[Statement]:
    """The statements of a line; there is one at least."""
    text = Text(line)
    while True:
        statement = Statement(number, text.position)
        try:
            _read(statement, text)
        except (Unreadable, RecursionError):
            statement.word = UNREAD
            text.skip_statement()
        yield statement
        if statement.word in (tokens.IF, tokens.ELSE):
            if characters.is_digit(text.code):
                jump = Statement(number, text.position, tokens.GOTO)
                jump.targets.append(text.line_number() or 0)
                yield jump
                text.skip_statement()
            elif not text.at_end:
                continue
        if text.code != characters.COLON:
            return
        text.advance()


def _join(found: list[Statement], first: int) -> None:
    """Say of the IFs and ELSEs of a line where they go."""
    end = len(found)
    for place in range(first, end):
        statement = found[place]
        if statement.word == tokens.ELSE:
            statement.otherwise = end
        if statement.word != tokens.IF:
            continue
        wanted, statement.otherwise = 1, end
        for behind in range(place + 1, end):
            wanted += (found[behind].word == tokens.IF) - (found[behind].word == tokens.ELSE)
            if not wanted:
                statement.otherwise = behind + 1
                break


def _read(statement: Statement, text: Text) -> None:
    """Read one statement; of an IF and an ELSE the part before the statements inside."""
    code = text.code
    if text.at_end:
        statement.word = tokens.REM
        return
    if characters.is_letter(code):
        statement.word = LET
        _let(statement, text)
    else:
        if code == AT:
            statement.arm = True
            code = text.advance()
        statement.word = code
        text.advance()
        table = _ARM if statement.arm else _READERS
        reader = table.get(code, None if statement.arm else _expressions)
        if reader is None or (not statement.arm and code not in words.STATEMENTS):
            raise Unreadable
        reader(statement, text)
    if statement.word not in (tokens.IF, tokens.ELSE) and not text.at_end:
        raise Unreadable


def _nothing(_statement: Statement, _text: Text) -> None:
    """RETURN, END and so on."""


def _rest(statement: Statement, text: Text) -> None:
    """REM: everything up to the end of the line."""
    statement.text = text.text[text.position :]
    text.position = len(text.text)


def _to_colon(statement: Statement, text: Text) -> None:
    """DATA, DEFINT, LIST: what stands there is not evaluated."""
    start = text.position
    text.skip_statement()
    statement.text = text.text[start : text.position]
    statement.text_at = start


def _expressions(statement: Statement, text: Text) -> None:
    """Expressions with commas between them, or none."""
    while not text.at_end:
        statement.reads.append(text.expression())
        if not text.take(COMMA):
            return


def _step(statement: Statement, text: Text) -> None:
    """@STEP: a delay, and counts of six motors at most."""
    _expressions(statement, text)
    if not 1 <= len(statement.reads) <= 1 + JOINTS:
        raise Unreadable


def _delay(statement: Statement, text: Text) -> None:
    """@CLOSE and @SET: a delay or none."""
    if not text.at_end:
        statement.reads.append(text.expression())


def _two(statement: Statement, text: Text) -> None:
    """POKE and OUT: where, and what."""
    statement.reads.append(text.expression())
    text.expect(COMMA)
    statement.reads.append(text.expression())


def _place(statement: Statement, text: Text) -> None:
    """SET and RESET of a block."""
    text.expect(characters.OPEN)
    _two(statement, text)
    text.expect(characters.CLOSE)


def _variables(statement: Statement, text: Text) -> None:
    while True:
        statement.sets.append(text.variable())
        if not text.take(COMMA):
            return


def _variables_or_none(statement: Statement, text: Text) -> None:
    if not text.at_end:
        _variables(statement, text)


def _input(statement: Statement, text: Text) -> None:
    if text.code == characters.QUOTE:
        text.string()
        text.expect(SEMICOLON)
    elif text.take(NUMBER_SIGN):
        statement.reads.append(text.expression())
        text.expect(COMMA)
    _variables(statement, text)


def _let(statement: Statement, text: Text) -> None:
    statement.sets.append(text.variable())
    text.expect(tokens.EQUAL)
    statement.reads.append(text.expression())


def _for(statement: Statement, text: Text) -> None:
    _let(statement, text)
    text.expect(tokens.TO)
    statement.reads.append(text.expression())
    if text.take(tokens.STEP):
        statement.reads.append(text.expression())


def _if(statement: Statement, text: Text) -> None:
    statement.reads.append(text.expression())
    text.take(COMMA)
    text.take(tokens.THEN)


def _targets(statement: Statement, text: Text) -> None:
    """GOTO, GOSUB: the rest of the statement does not count."""
    statement.targets.append(text.line_number() or 0)
    text.skip_statement()


def _target_or_none(statement: Statement, text: Text) -> None:
    """RUN and RESUME."""
    if characters.is_digit(text.code):
        _targets(statement, text)
    statement.onward = text.take(tokens.NEXT)


def _on(statement: Statement, text: Text) -> None:
    statement.traps = text.take(tokens.ERROR)
    if not statement.traps:
        statement.reads.append(text.expression())
    statement.calls = text.code == tokens.GOSUB and not statement.traps
    text.expect(tokens.GOSUB if statement.calls else tokens.GOTO)
    while True:
        statement.targets.append(text.line_number() or 0)
        if not text.take(COMMA):
            return


def _print(statement: Statement, text: Text) -> None:
    if text.take(NUMBER_SIGN) or text.take(AT):
        statement.reads.append(text.expression())
        text.take(COMMA)
    while not text.at_end:
        if text.code in (COMMA, SEMICOLON):
            text.advance()
        elif text.take(tokens.TAB):
            statement.reads.append(text.expression())
            text.expect(characters.CLOSE)
        elif text.take(tokens.USING):
            statement.reads.append(text.expression())
        else:
            statement.reads.append(text.expression())


_Reader = Callable[[Statement, Text], None]
_READERS: Final[dict[int, _Reader]] = {
    tokens.REM: _rest,
    tokens.DATA: _to_colon,
    tokens.ELSE: _nothing,
    tokens.IF: _if,
    tokens.INPUT: _input,
    tokens.READ: _variables,
    tokens.GOTO: _targets,
    tokens.GOSUB: _targets,
    tokens.NEXT: _variables_or_none,
    tokens.PRINT: _print,
    LPRINT: _print,
    tokens.SET: _place,
    tokens.RESET: _place,
    LET: _let,
    FOR: _for,
    DIM: _variables,
    ON: _on,
    POKE: _two,
    OUT: _two,
    RUN: _target_or_none,
    RESUME: _target_or_none,
    **dict.fromkeys(DEFINES, _to_colon),
    **{
        words.TOKENS[word]: _to_colon
        for word in ("EDIT", "LIST", "LLIST", "DELETE", "AUTO", "CLOAD", "CSAVE")
    },
}
_ARM: Final[dict[int, _Reader]] = {
    tokens.STEP: _step,
    tokens.CLOSE: _delay,
    tokens.SET: _delay,
    tokens.RESET: _nothing,
    tokens.READ: _variables,
}
