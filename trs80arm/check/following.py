"""Follows a program without running it, to see where its DATA would send the arm.

Every statement is taken as the machine takes it, as far as values are known; where a decision hangs
on what nobody knows before the run, both ways are gone. Each value carries the DATA that it was
computed from. So a motion that no joint can make leads back to its point, whatever the variables
are called; and so does a decision by which the program itself turns a point away. Such a decision
is told from others by going on as if it had fallen the other way: the arm would then have moved by
that point. All of it is bounded: what is not seen within the bounds is not told.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import Any, Final

from trs80arm.arm.model import ArmModel, Pose
from trs80arm.basic import tokens, words
from trs80arm.basic.characters import FIRST_LETTER
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.kinds import STRING
from trs80arm.basic.numbers import convert
from trs80arm.basic.numbers.double import Double
from trs80arm.check.data import Item, items
from trs80arm.check.expressions import Relation
from trs80arm.check.path import ZERO, Doubt, Key, Loop, Path, Subroutine, Suspicion
from trs80arm.check.reach import Reach
from trs80arm.check.statements import (
    CLEAR,
    DEFINES,
    END,
    FOR,
    LET,
    LPRINT,
    ON,
    OUT,
    POKE,
    RESTORE,
    RETURN,
    STOP,
    Statement,
    Statements,
)
from trs80arm.check.values import Failure, Held, Items, Unknown, Value

_MOST: Final = 20_000
"""Statements that are followed, on all ways."""
_IDLE: Final = 2_000
"""Statements in a row, on one way, in which nothing new is learned."""
_BOTH: Final = 2
"""How often one way goes both ways at one decision; after that it goes one, the other than last."""
_BOTH_IN_ALL: Final = 8
"""How often all ways together do."""
_TOO_OFTEN: Final = 6
"""How often one way comes to a decision with nothing read in between."""
_DEEPEST: Final = 60
"""Loops and subroutines in one another."""
_PARDONS: Final = 200
"""Decisions that are taken the other way."""
_SCREEN, _BEHIND_SYSTEM = 0x3C00, 0x42E9
"""Where a POKE changes nothing that is followed, but for the pointer to the next DATA."""
_DATA_POINTER: Final = (0x40FF, 0x4100)
_MOTOR_PORTS: Final = range(0x98, 0x9E)
_HAND: Final = 5
_LETTERS: Final = re.compile(rb"([A-Z])(?: *" + re.escape(bytes((tokens.MINUS,))) + rb" *([A-Z]))?")
"""A letter, or the first and the last of several, behind DEFINT and so on."""


class _End(Exception):  # noqa: N818
    """The way ends here as the program does."""


class _Abandon(Exception):  # noqa: N818
    """What comes is not followed."""


class Follower:
    """Goes all ways through a program, within bounds.

    Args:
        program: its statements.
        model: of the arm.
        start: where the arm is switched on; None where that is not known.

    Attributes:
        items: of its DATA.
        out_of_reach: DATA, by which the arm cannot go where it is sent, and why.
        short: the READ that finds no DATA.
        unreadable: items that are read into a number and are none.
        read_by: by item, the READ that took it last, and into which of its variables.
    """

    def __init__(self, program: Statements, model: ArmModel, start: Pose | None = None) -> None:
        self.items: list[Item] = list(items(program.all))
        self.out_of_reach: dict[Items, str] = {}
        self.short: Statement | None = None
        self.unreadable: set[int] = set()
        self.read_by: dict[int, tuple[Statement, int]] = {}
        self._program = program
        self._model = model
        self._start = start
        self._moves = any(each.arm and each.word == tokens.STEP for each in program.all)
        self._good: set[Items] = set()
        self._left = _MOST
        self._waiting: list[Path] = []
        self._pardoned: set[tuple[int, Items]] = set()
        self._forked: dict[int, int] = {}

    def follow(self) -> None:
        """Go the ways."""
        if not any(each.word == tokens.READ and not each.arm for each in self._program.all):
            return
        self._waiting.append(Path(Reach(self._model, self._start)))
        while self._waiting and self._left > 0:
            self._go(self._waiting.pop())
        found, told = self.out_of_reach, set[int]()
        self.out_of_reach = {}
        for point, why in found.items():
            # One place by which several motions go, or that is good on another way, is told once
            # or not at all.
            if point not in self._good and not point & told:
                self.out_of_reach[point] = why
                told |= point

    def _go(self, path: Path) -> None:
        """Go one way to its end."""
        statements = self._program.all
        try:
            while path.place < len(statements):
                self._left -= 1
                path.idle += 1
                if self._left <= 0 or path.idle > _IDLE:
                    self._turned_away(path)
                    raise _Abandon
                statement = statements[path.place]
                place = path.place
                try:
                    self._do(statement, path)
                except Failure as failure:
                    self._fail(failure, path, place)
                except BasicError as error:
                    self._fail(Failure(error.code), path, place)
            raise _End
        except _End:
            self._turned_away(path)
            self._good |= path.good - path.bad.keys()
        except _Abandon:
            last = {each for each, read in path.read_in.items() if read == path.reads}
            self._good |= {each for each in path.good - path.bad.keys() if not each & last}
        for each, why in path.bad.items():
            self.out_of_reach.setdefault(each, why)

    def _do(self, statement: Statement, path: Path) -> None:
        table = _ARM if statement.arm else _STATEMENTS
        does = table.get(statement.word)
        if does is None:
            raise _Abandon
        path.place += 1
        does(self, statement, path)

    # -- points that the program turns away ---------------------------------------------------

    def _fail(self, failure: Failure, path: Path, place: int) -> None:
        """The program ends with an error in the statement at a place; by a point perhaps."""
        if path.trapped:
            raise _Abandon
        point = path.latest(failure.items & path.curved)
        if self._moves and point:
            line = self._program.all[place].line
            why = f"line {line} ends with ?{failure.code.letters}"
            # It failed before it changed anything.
            self._pardon(path, place, point, why)
        raise _End

    def _turned_away(self, path: Path) -> None:
        """See whether the decision in doubt is a refusal, by going on the other way."""
        doubt, path.doubt = path.doubt, None
        if doubt is not None:
            why = f"the program turns it away in line {doubt.line}"
            self._pardon(doubt.before, doubt.other, doubt.items, why)

    def _pardon(self, before: Path, place: int, point: Items, why: str) -> None:
        key = place, point
        if key in self._pardoned or len(self._pardoned) >= _PARDONS:
            return
        self._pardoned.add(key)
        other = before.copy()
        other.place, other.doubt, other.idle = place, None, 0
        if other.suspicion is None or not other.suspicion.items & point:
            other.suspicion = Suspicion(point, why)
        other.forgiven |= point
        self._waiting.append(other)

    # -- decisions ----------------------------------------------------------------------------

    def _jump(self, path: Path, line: int) -> None:
        place = self._program.starts.get(line)
        if place is None:
            raise _End
        path.place = place

    def _decide(self, path: Path, value: Value, place: int) -> bool:
        """Whether a condition holds; where nobody knows, another way goes on where it does not.

        Args:
            path: the way; on the other one it stands where it stands now.
            value: of the condition.
            place: of the statement that asks.
        """
        if not isinstance(value.held, Unknown):
            return _true(value.held)
        path.sure = False
        times, last = path.visits.get(place, (0, True))
        if times >= _TOO_OFTEN:
            raise _Abandon
        if times >= _BOTH or self._forked.get(place, 0) >= _BOTH_IN_ALL:
            outcome = not last
        else:
            outcome = True
            self._forked[place] = self._forked.get(place, 0) + 1
            other = path.copy()
            other.place = place
            other.visits[place] = times + 1, False
            other.facts[value.held.name] = 0
            self._waiting.append(other)
        path.visits[place] = times + 1, outcome
        _learn(path, value.held.name, outcome)
        return outcome

    def _if(self, statement: Statement, path: Path) -> None:
        place = path.place - 1
        value = path.value(statement.reads[0])
        holds = self._decide(path, value, place)
        other = path.place if not holds else statement.otherwise
        if not holds:
            path.place = statement.otherwise
        if self._moves and value.known and value.items & path.curved:
            path.doubt = Doubt(path.copy(), other, path.latest(value.items), statement.line)
            path.printed = False

    def _else(self, statement: Statement, path: Path) -> None:
        path.place = statement.otherwise

    def _goto(self, statement: Statement, path: Path) -> None:
        self._jump(path, statement.targets[0])

    def _gosub(self, statement: Statement, path: Path) -> None:
        self._open(path, Subroutine(path.place))
        self._jump(path, statement.targets[0])

    def _return(self, _statement: Statement, path: Path) -> None:
        while path.frames:
            frame = path.frames.pop()
            if isinstance(frame, Subroutine):
                path.place = frame.back
                return
        raise Failure(Code.RG)

    def _on(self, statement: Statement, path: Path) -> None:
        if statement.traps:
            path.trapped = statement.targets[0] != 0
            return
        place = path.place - 1
        value = path.integer(statement.reads[0])
        if value.known:
            choice = convert.to_integer(value.held)
            if 1 <= choice <= len(statement.targets):
                self._choose(statement, path, statement.targets[choice - 1])
            return
        path.sure = False
        times, _ = path.visits.get(place, (0, False))
        if times >= _BOTH:
            raise _Abandon
        path.visits[place] = times + 1, True
        for target in statement.targets:
            if target in self._program.starts:
                other = path.copy()
                self._choose(statement, other, target)
                self._waiting.append(other)

    def _choose(self, statement: Statement, path: Path, target: int) -> None:
        if statement.calls:
            self._open(path, Subroutine(path.place))
        self._jump(path, target)

    # -- loops --------------------------------------------------------------------------------

    @staticmethod
    def _open(path: Path, frame: Subroutine | Loop) -> None:
        if len(path.frames) >= _DEEPEST:
            raise _Abandon
        path.frames.append(frame)

    def _for(self, statement: Statement, path: Path) -> None:
        variable = statement.sets[0]
        start, limit, *steps = (path.value(each) for each in statement.reads)
        path.store(variable, start)
        key = path.key(variable)
        _drop_loop(path, key)
        self._open(path, Loop(key, limit, steps[0] if steps else Value(1), path.place))
        self._pass_empty_loop(path)

    def _pass_empty_loop(self, path: Path) -> None:
        """A loop with nothing in it lets time pass; it is not gone through."""
        statements, loop = self._program.all, path.frames[-1]
        assert isinstance(loop, Loop)
        if path.place >= len(statements):
            return
        behind = statements[path.place]
        if behind.word != tokens.NEXT or len(behind.sets) > 1:
            return
        if behind.sets and path.key(behind.sets[0]) != loop.variable:
            return
        path.frames.pop()
        path.place += 1
        value = path.variables[loop.variable]
        if not (value.known and loop.limit.known and loop.step.known):
            path.variables[loop.variable] = path.unknown(value.items)
            return
        at, limit, step = (_float(each) for each in (value.held, loop.limit.held, loop.step.held))
        if not step:
            raise _Abandon
        times = max(1, int((limit - at) // step) + 1)
        made = convert.to_kind(loop.variable[1], float(at + times * step))
        path.variables[loop.variable] = Value(made, value.items | loop.limit.items)

    def _next(self, statement: Statement, path: Path) -> None:
        place = path.place - 1
        keys: list[Key | None] = [path.key(each) for each in statement.sets] or [None]
        for key in keys:
            loop = _find_loop(path, key)
            if loop is None:
                raise Failure(Code.NF)
            value = path.variables[loop.variable]
            items = value.items | loop.step.items
            if not (value.known and loop.limit.known and loop.step.known):
                path.variables[loop.variable] = path.unknown(items)
                goes_on = self._decide(path, path.unknown(items | loop.limit.items), place)
            else:
                to = convert.add(_number(value.held), _number(loop.step.held))
                path.variables[loop.variable] = Value(convert.to_kind(loop.variable[1], to), items)
                order = convert.compare(to, _number(loop.limit.held))
                up = convert.sign(_number(loop.step.held))
                goes_on = order * up <= 0 if up else order != 0
            if goes_on:
                path.place = loop.body
                return
            path.frames.pop()

    # -- data ---------------------------------------------------------------------------------

    def _read(self, statement: Statement, path: Path) -> None:
        if path.printed:
            # Behind a message the program may have gone on to the next point.
            self._turned_away(path)
        path.doubt = None
        if any(isinstance(each, Loop) and not each.limit.known for each in path.frames):
            # Nobody knows how many are taken.
            raise _Abandon
        path.reads += 1
        path.idle = 0
        path.visits.clear()
        for place, variable in enumerate(statement.sets):
            number = path.next_item
            if number >= len(self.items):
                if path.sure and not path.trapped:
                    self.short = statement
                raise _End
            path.next_item += 1
            item = self.items[number]
            path.read_in[number] = path.reads
            path.read_into[number] = variable.name + variable.kind
            self.read_by[number] = statement, place
            held: Held | None = item.number
            if path.key(variable)[1] is STRING:
                held = item.text
            elif held is None:
                if path.sure and not path.trapped:
                    self.unreadable.add(number)
                raise _End
            path.store(variable, Value(held, frozenset((number,)), as_read=True))

    def _restore(self, _statement: Statement, path: Path) -> None:
        path.next_item = 0

    def _let(self, statement: Statement, path: Path) -> None:
        path.store(statement.sets[0], path.value(statement.reads[0]))

    def _input(self, statement: Statement, path: Path) -> None:
        path.printed = True
        for variable in statement.sets:
            path.store(variable, path.unknown())

    def _define(self, statement: Statement, path: Path) -> None:
        gives = words.BY_TOKEN[statement.word].gives
        assert gives is not None
        for first, last in _LETTERS.findall(statement.text):
            for letter in range(first[0], (last or first)[0] + 1):
                path.types[letter - FIRST_LETTER] = gives

    def _clear(self, _statement: Statement, path: Path) -> None:
        for cleared in (path.variables, path.arrays, path.blurred, path.frames):
            cleared.clear()
        path.next_item = 0

    def _print(self, _statement: Statement, path: Path) -> None:
        path.printed = True

    def _nothing(self, _statement: Statement, path: Path) -> None:
        """What changes nothing that is followed."""

    def _end(self, _statement: Statement, _path: Path) -> None:
        raise _End

    def _poke(self, statement: Statement, path: Path) -> None:
        at = path.value(statement.reads[0])
        if not at.known:
            raise _Abandon
        address = int(_float(at.held)) & 0xFFFF
        if not _SCREEN <= address < _BEHIND_SYSTEM or address in _DATA_POINTER:
            raise _Abandon

    def _out(self, statement: Statement, path: Path) -> None:
        port = path.value(statement.reads[0])
        if not port.known or int(_float(port.held)) in _MOTOR_PORTS:
            path.reach.forget()

    # -- the arm ------------------------------------------------------------------------------

    def _step(self, statement: Statement, path: Path) -> None:
        values = [path.integer(each) for each in statement.reads[1:]]
        values += [ZERO] * (len(path.registers) - len(values))
        counts = [_count(each.held) for each in values]
        for joint, value in enumerate(values):
            path.registers[joint] = _summed(path, path.registers[joint], value)
        met = path.reach.move(counts)
        used = Items().union(*(each.items for each in values))
        if path.suspicion is not None and path.suspicion.items & used:
            path.bad.setdefault(path.suspicion.items, path.suspicion.text)
            path.suspicion = None
        if path.doubt is not None and path.doubt.items & used:
            path.doubt = None
        point = path.latest(used)
        path.motions += 1
        if not point or used & path.forgiven:
            return
        if met:
            path.bad.setdefault(point, met)
        elif point not in path.good:
            path.good.add(point)
            path.idle = 0

    def _close(self, _statement: Statement, path: Path) -> None:
        path.registers[_HAND] = path.unknown()

    def _set(self, _statement: Statement, path: Path) -> None:
        if self._start is not None and not path.motions:
            # The bench has the arm where the program wants it set; 0 is enough.
            return
        path.reach.forget()
        path.registers = [path.unknown() for _ in path.registers]

    def _reset(self, _statement: Statement, path: Path) -> None:
        path.registers = [ZERO for _ in path.registers]

    def _registers(self, statement: Statement, path: Path) -> None:
        for variable, value in zip(statement.sets, path.registers, strict=False):
            path.store(variable, value)


def _true(held: Held) -> bool:
    return bool(held.mantissa if isinstance(held, Double) else held)


def _number(held: Held) -> Any:
    if isinstance(held, (bytes, Unknown)):
        raise Failure(Code.TM)
    return held


def _float(held: Held) -> float:
    return convert.to_single(_number(held))


def _count(held: Held) -> int | None:
    return held if isinstance(held, int) else None


def _summed(path: Path, register: Value, by: Value) -> Value:
    items = register.items | by.items
    if not isinstance(register.held, int) or not isinstance(by.held, int):
        return path.unknown(items)
    return Value((register.held + by.held + 0x8000) % 0x10000 - 0x8000, items)


def _learn(path: Path, name: Any, outcome: bool) -> None:
    """Take down how something unknown was decided, and what an equality says."""
    path.facts[name] = -1 if outcome else 0
    if outcome and isinstance(name, tuple) and name[:2] == (Relation, 2):
        a, b = name[2:]
        if isinstance(a, Unknown) and not isinstance(b, Unknown):
            path.facts[a.name] = b
        elif isinstance(b, Unknown) and not isinstance(a, Unknown):
            path.facts[b.name] = a


def _find_loop(path: Path, key: Key | None) -> Loop | None:
    """The innermost loop, or that of a variable; those inside it are dropped."""
    for place in range(len(path.frames) - 1, -1, -1):
        frame = path.frames[place]
        if isinstance(frame, Subroutine):
            return None
        if key is None or frame.variable == key:
            del path.frames[place + 1 :]
            return frame
    return None


def _drop_loop(path: Path, key: Key) -> None:
    for place in range(len(path.frames) - 1, -1, -1):
        frame = path.frames[place]
        if isinstance(frame, Subroutine):
            return
        if frame.variable == key:
            del path.frames[place:]
            return


_Does = Callable[[Follower, Statement, Path], None]
_IGNORED: Final[Sequence[str]] = (
    *("REM", "DATA", "DIM", "CLS", "SET", "RESET", "RANDOM", "TRON", "TROFF"),
)
_STATEMENTS: Final[dict[int, _Does]] = {
    **{words.TOKENS[word]: Follower._nothing for word in _IGNORED},
    **dict.fromkeys(DEFINES, Follower._define),
    **dict.fromkeys((END, STOP), Follower._end),
    LET: Follower._let,
    FOR: Follower._for,
    tokens.NEXT: Follower._next,
    tokens.IF: Follower._if,
    tokens.ELSE: Follower._else,
    tokens.GOTO: Follower._goto,
    tokens.GOSUB: Follower._gosub,
    RETURN: Follower._return,
    ON: Follower._on,
    tokens.READ: Follower._read,
    RESTORE: Follower._restore,
    tokens.INPUT: Follower._input,
    tokens.PRINT: Follower._print,
    LPRINT: Follower._print,
    CLEAR: Follower._clear,
    POKE: Follower._poke,
    OUT: Follower._out,
}
_ARM: Final[dict[int, _Does]] = {
    tokens.STEP: Follower._step,
    tokens.CLOSE: Follower._close,
    tokens.SET: Follower._set,
    tokens.RESET: Follower._reset,
    tokens.READ: Follower._registers,
}
