"""Where a program can go: what it never reaches, loops and subroutines that do not close.

A way is any row of statements that jumps and branches allow, whatever the conditions are; so what
has no way is certain, and what has one need not ever be gone.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Final

from trs80arm.basic import tokens
from trs80arm.check.expressions import Variable, calls
from trs80arm.check.statements import (
    END,
    FOR,
    NEW,
    ON,
    RESUME,
    RETURN,
    RUN,
    STOP,
    UNREAD,
    VARPTR,
    Statement,
    Statements,
)

_IDLE: Final = frozenset((tokens.REM, tokens.DATA, tokens.ELSE, END, STOP, RETURN))
"""What stands where nothing comes without being meant to run: remarks, data, and ends."""
_LAST: Final = frozenset((tokens.GOTO, END, RETURN, RUN, NEW, RESUME))
"""Behind these a program does not go on, unless an error in them is passed by a RESUME NEXT."""


@dataclass(frozen=True)
class Unreached:
    """Statements in a row that no way leads to; `first` and `last` do something."""

    first: Statement
    last: Statement


class Flow:
    """The ways through a program.

    Args:
        program: its statements.
    """

    def __init__(self, program: Statements) -> None:
        self.program = program
        self._traps = [
            place
            for statement in program.all
            if statement.traps
            for place in self._places(statement.targets)
        ]
        self._onward = any(each.onward for each in program.all)
        self._inside = [list(self._next(place)) for place in range(len(program.all))]

    def _places(self, targets: Iterable[int]) -> Iterator[int]:
        """The places of lines that are there."""
        starts = self.program.starts
        return (starts[target] for target in targets if target in starts)

    def _next(self, place: int) -> Iterator[int]:
        """Where control can be after a statement, with the same subroutines open."""
        statement = self.program.all[place]
        word, behind = statement.word, place + 1
        if statement.arm:
            word = UNREAD
        if word == tokens.ELSE:
            behind = statement.otherwise
        if word == tokens.IF and statement.otherwise < len(self.program.all):
            yield statement.otherwise
        jumps = word in (tokens.GOTO, RESUME)
        if jumps or (word == ON and not statement.calls and not statement.traps):
            yield from self._places(statement.targets)
        goes_on = word not in _LAST or (self._onward and word != RESUME)
        if goes_on and behind < len(self.program.all):
            yield behind

    def _reached(self, starts: Iterable[int], *, calls: bool = False) -> Iterator[int]:
        """The places that ways lead to, near ones first.

        Args:
            starts: where they begin.
            calls: whether a way goes into subroutines and comes back from them, too.
        """
        seen: set[int] = set()
        waiting = [place for place in starts if place < len(self.program.all)]
        while waiting:
            following: list[int] = []
            for place in waiting:
                if place in seen:
                    continue
                seen.add(place)
                yield place
                following += self._inside[place]
                statement = self.program.all[place]
                if calls and (_is_call(statement) or statement.word == RUN):
                    following += self._places(statement.targets)
            waiting = following
            if not waiting and self._traps and not seen.issuperset(self._traps):
                # An error may come anywhere.
                waiting = list(self._traps)

    # -- what is looked for -------------------------------------------------------------------

    def unreached(self) -> Iterator[Unreached]:
        """Statements that nothing leads to."""
        statements = self.program.all
        if not statements:
            return
        reached = set(self._reached([0], calls=True))
        row: list[Statement] = []
        for place, statement in enumerate(statements):
            if place in reached:
                if row:
                    yield Unreached(row[0], row[-1])
                row = []
            elif statement.arm or statement.word not in _IDLE:
                row.append(statement)
        if row:
            yield Unreached(row[0], row[-1])

    def loops_without_next(self) -> Iterator[Statement]:
        """FORs from which no way leads to their NEXT."""
        statements = self.program.all
        for place, statement in enumerate(statements):
            if statement.word == FOR and not any(
                _is_next_of(statements[each], statement.sets[0])
                for each in self._reached([place + 1])
            ):
                yield statement

    def nexts_without_for(self) -> Iterator[Statement]:
        """NEXTs to which no way leads from a FOR of theirs."""
        statements = self.program.all
        loops: dict[tuple[str, str], list[int]] = {}
        for place, statement in enumerate(statements):
            if statement.word == FOR:
                variable = statement.sets[0]
                loops.setdefault((variable.name, variable.kind), []).append(place)
        within = {
            key: set(self._reached(place + 1 for place in places)) for key, places in loops.items()
        }
        for place, statement in enumerate(statements):
            if statement.word == tokens.NEXT and not any(
                place in reached and _is_next_of(statement, statements[loops[key][0]].sets[0])
                for key, reached in within.items()
            ):
                yield statement

    def calls_without_return(self) -> Iterator[tuple[Statement, int]]:
        """GOSUBs, each with the line that it goes to, from where no way leads to a RETURN."""
        known: dict[int, bool] = {}
        for statement in self.program.all:
            if not _is_call(statement):
                continue
            for target in statement.targets:
                if target not in self.program.starts:
                    continue
                if target not in known:
                    start = self.program.starts[target]
                    known[target] = any(
                        self.program.all[each].word in (RETURN, UNREAD)
                        for each in self._reached([start])
                    )
                if not known[target]:
                    yield statement, target


def _is_call(statement: Statement) -> bool:
    return statement.word == tokens.GOSUB or (statement.word == ON and statement.calls)


def _same(one: Variable, other: Variable) -> bool:
    """Whether two names may be one variable; a DEFINT may make A and A% the same."""
    kinds = {one.kind, other.kind}
    arrays = (one.subscripts is None) == (other.subscripts is None)
    return one.name == other.name and arrays and ("" in kinds or len(kinds) == 1)


def _is_next_of(statement: Statement, loop: Variable) -> bool:
    """Whether a statement is the NEXT of a loop's variable, or may be."""
    if statement.word != tokens.NEXT:
        return False
    return not statement.sets or any(_same(each, loop) for each in statement.sets)


def _set_by(statement: Statement) -> Iterator[Variable]:
    """The variables that a statement may give a value; VARPTR hands one on to who knows whom."""
    if statement.word != tokens.NEXT:
        yield from statement.sets
    for expression in statement.reads:
        for call in calls(expression):
            if call.function == VARPTR:
                yield from (each for each in call.arguments if isinstance(each, Variable))


def never_set(program: Statements) -> Iterator[tuple[Statement, Variable]]:
    """Variables that are read and that nothing sets, each where it is read first."""
    by_name: dict[tuple[str, bool], list[Variable]] = {}
    for statement in program.all:
        for variable in _set_by(statement):
            key = variable.name, variable.subscripts is None
            by_name.setdefault(key, []).append(variable)
    told: set[tuple[str, str, bool]] = set()
    for statement in program.all:
        for variable in statement.used():
            plain = variable.subscripts is None
            spelled = variable.name, variable.kind, plain
            setters = by_name.get((variable.name, plain), ())
            if spelled not in told and not any(_same(variable, each) for each in setters):
                told.add(spelled)
                yield statement, variable
