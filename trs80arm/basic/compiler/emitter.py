"""The Python text of one compiled function, line by line, and the function made of it.

A compiled statement is a function without arguments that does the statement's work and returns the
address of the next one. It shares the variables' cells with all other statements; what it alone
needs, as the frame that a GOSUB opens, is in cells of its own. What a statement costs is added to
the clock where it leaves; the emitter knows for every line how much had come together by then, so
that a statement that fails is charged for what it has done.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache
from types import CellType, CodeType
from typing import Any, Final, NamedTuple

from trs80arm.basic.compiler import relocation
from trs80arm.basic.compiler.relocation import (
    Framed,
    Location,
    Relocatable,
    Search,
    placeholder,
    with_addresses,
)
from trs80arm.basic.control import ForFrame, Frame
from trs80arm.basic.errors import Code
from trs80arm.basic.numbers.functions import OF_ONE_EXPONENT
from trs80arm.basic.variables import Key

MARGIN: Final = 200_000
"""T-states that a block of statements may take without looking at the clock itself; near the
clock's limit single statements are executed instead, so that both ways stop at the same one."""
_KEPT: Final = 2000
"""Texts whose code is kept: a machine that runs again what it or another one ran, as each of a
sweep does, does not wait for Python to read the same text."""
_LOOP_BODY: Final = "f.body"
"""Where NEXT goes back to, in generated text."""
KNOWN_LOOP, KNOWN_LIMIT = "around", "last"
"""The frame and the limit of the loop around a block, in generated text."""
ATTRIBUTES: Final = frozenset(
    {
        *("now", "soft"),  # the clock's, the pace's
        *("append", "pop", "plenty"),  # the stack's of loops and subroutines, the room's
        *("scalar", "body", "limit", "step", "top", "up", "back"),  # a frame's
        *("bottom", "next", "temporaries"),  # string space's
        "mantissa",  # a double's
    }
)
"""Attributes that generated text may use, beside the names of its environment."""
QUIET: Final = frozenset(
    {
        *("abs", "float", "int", "len", "fail", "byte", "below", "subscript", "bad", "always"),
        "from_one",
        *("floor", "to_kind", "to_single", "to_double", "narrow", "negate", "absolute", "sign"),
        *("any_floor", "fix", "compare", "any_add", "any_sub", "any_mul", "any_div"),
        *("integer_add", "integer_sub", "integer_mul", "integer_step"),
        *("add", "sub", "mul", "div", "double_compare", "double_negate", "rnd"),
        *("sin", "cos", "tan", "atn", "log", "exp", "sqr", "power"),
        *OF_ONE_EXPONENT.values(),
        *("room", "open_subroutine", "close_subroutine"),
        *("frames", "open_loop", "drop_loop", "step_loop", "other_step"),
        *("goes_on", "space", "view", "characters_of", "characters"),
        *("shown_integers", "shown_singles", "literal"),
    }
)
"""Routines that take no time of their own: they may give back what was charged, no more, and do not
ask what time it is. Where a block calls no others, its time is summed up in a local name."""
_KEEPING_FRAMES: Final = (QUIET - {"drop_loop", "step_loop"}) | {
    *("assign", "concatenate", "left", "right", "middle", "str_", "chr_", "val_", "asc_", "len_"),
    *("shown", "string_of", "first_code"),
    *("alike", "order", "string_equal", "string_compare", "peek", "poke", "point", "plot"),
    *("read_port", "write_port", "now_at", "to_screen", "print_newline", "print_comma"),
    *("print_string", "print_number", "print_anything", "print_tab", "print_at"),
    *("begin_read", "read_number", "read_string", "end_item", "end_read"),
}
"""Routines behind which the loop or subroutine that was open last is still that."""
_CALLED: Final = re.compile(r"(?<![\w.])[a-z_]+(?=[(\[])")
"""A name of the environment that is called, or looked something up in, in generated text."""


class Mark(NamedTuple):
    """What is known of a line of generated text.

    Attributes:
        statement: the index of the address of the statement that it belongs to.
        cost: T-states not yet charged when it runs.
    """

    statement: int
    cost: int


class Call(NamedTuple):
    """A subroutine that the function under construction has gone into.

    Attributes:
        frame: the name of its frame.
        back: the address behind the GOSUB.
    """

    frame: str
    back: int


class Loop(NamedTuple):
    """A FOR loop whose body the function under construction goes round in.

    Attributes:
        key: its variable.
        body: the address of the separator behind the FOR.
        frame: the name of its frame.
        limit: the name of its limit.
        step: a number of usual size.
        whole: the name of a limit that shows as long as it is not passed that the loop counts whole
            numbers and is exact; empty if it is no such loop.
        start: how many lines the function had before the body.
        calls: how many subroutines it had gone into.
    """

    key: Key
    body: int
    frame: str
    limit: str
    step: float
    whole: str
    start: int
    calls: int


class Next(NamedTuple):
    """A NEXT that a jump goes to.

    Attributes:
        key: the variable, None where none is named.
        cost: T-states from the beginning of its line.
        reach: the highest address of its text.
    """

    key: Key | None
    cost: int
    reach: int


class UnlistedName(Exception):  # noqa: N818 - never raised unless the compiler is wrong
    """Generated text uses a name that is in no list."""


class TooDeep(Exception):  # noqa: N818 - the text can be written another way
    """An expression is nested more deeply than Python can read."""


class Emitter:
    """Collects the body of one function.

    Args:
        flat: whether every operation is to be a line of its own. Such a function is slower, but no
            expression is too long for it: Python's parser ends at 200 parentheses.

    Attributes:
        flat: the same.
        cost: T-states that came together since the clock was last charged.
        most_cost: the most that came together on one way through the function.
        statement: the address of the statement whose text is being written (`begin`).
        marks: what is known of each line.
        calls: the subroutines that a block has gone into.
        loops: the loops that it goes round in, the innermost last.
        calls_code: whether machine code may be called.
        followed: where a jump goes that the block is to go on behind, instead of leaving.
        around: the open loop whose body begins where the block does, if there is one.
        strings: text of the characters of string variables that a block knows, by their names.
        next_at: tells of a block's jumps whether they go to a NEXT, while certain loops are open.
    """

    def __init__(self, *, flat: bool = False) -> None:
        self.flat = flat
        self.cost = 0
        self.statement = 0
        self._statement = 0
        self.most_cost = 0
        self.marks: list[Mark] = []
        self.indent = 1
        self._lines: list[str] = []
        self._counted: dict[int, str] = {}
        self._cells: dict[str, CellType] = {}
        self._stored: set[str] = set()
        self._constants: dict[int, str] = {}
        self._temporaries = 0
        self._addresses: dict[int, int] = {}
        self._spans: list[tuple[int, int]] = []
        self._searches: list[Search] = []
        self._frames: dict[str, tuple[Framed, int]] = {}
        self._leader: int | None = None
        self.around: ForFrame | None = None
        self._head: list[str] = []
        self._head_whole = False
        self._asks = False
        self._base = 0
        self.calls: list[Call] = []
        self.loops: list[Loop] = []
        self.followed: int | None = None
        self.calls_code = False
        self.strings: dict[str, str] = {}
        self.next_at: Callable[[int, list[Key]], Next | None] | None = None
        self._charged = 0

    def lead(self, address: int, frame: Frame) -> None:
        """The function begins a block: a jump to its own start goes round inside it.

        Args:
            address: where it begins.
            frame: the innermost loop or subroutine that is open then.
        """
        self._leader = address
        self.address(address)
        if isinstance(frame, ForFrame) and frame.body == address:
            self.around = frame
        self.emit("while True:")
        self.indent += 1
        self._base = self.indent

    @property
    def _known_leader(self) -> int:
        assert self._leader is not None
        return self._leader

    @property
    def in_block(self) -> bool:
        """Whether the function is a block, and not one statement."""
        return self._leader is not None

    @property
    def straight(self) -> bool:
        """Whether what is written now is executed by a block on every way that comes here."""
        return self._leader is not None and self.indent == self._base

    def begin_loop(self, loop: Loop) -> None:
        """What follows is the body of a loop, up to its NEXT."""
        self.charge()
        self.emit("while True:")
        self.indent += 1
        self._base = self.indent
        self.loops.append(loop)
        self.strings = {}

    def know_loop_around(
        self, scalar: str, step: float, limit: str, beyond: str, whole: bool
    ) -> bool:
        """Have the loop around the block looked at where the block begins.

        Args:
            scalar: the name of its variable.
            step: what it must go on by.
            limit: text of its limit.
            beyond: what is its limit if it is another loop.
            whole: whether the limit shows that the loop counts whole numbers.

        Returns:
            Whether it shows that: what was asked for first holds.
        """
        if self._head:
            return self._head_whole
        self._head_whole = whole
        frame = KNOWN_LOOP
        leader = self.address(self._known_leader)
        same = f"{frame}.scalar is {scalar} and {frame}.body == {leader}"
        self._head = [
            f"{frame} = frames[-1]",
            f"if {same} and {frame}.step == {step!r}: {KNOWN_LIMIT} = {limit}",
            f"else: {KNOWN_LIMIT} = {beyond}",
        ]
        return whole

    @property
    def lines(self) -> int:
        """How many lines have been written."""
        return len(self._lines)

    def keeps_frames(self, since: int, calls: int) -> bool:
        """Whether the innermost frame is the same where the lines written since come to their end.

        Args:
            since: how many lines there were before.
            calls: how many subroutines the function had gone into then.
        """
        if len(self.calls) != calls:
            return False
        return self.straight and all(
            _KEEPING_FRAMES.issuperset(_CALLED.findall(line)) for line in self._lines[since:]
        )

    def stores(self, name: str, since: int) -> bool:
        """Whether one of the lines written since gives a variable a value."""
        assignment = f"{name} = "
        return any(line.lstrip().startswith(assignment) for line in self._lines[since:])

    def go_round(self) -> None:
        """The innermost loop's body again."""
        self._leave(self.address(self.loops[-1].body), again="")

    def end_loop(self) -> None:
        """The innermost loop is done."""
        self.charge()
        self.emit("break")
        self.indent -= 1
        self._base = self.indent
        self.loops.pop()
        self.strings = {}

    def state(self) -> tuple[Any, ...]:
        """What `restore` needs to take back what will be written."""
        return (
            len(self._lines),
            (self.cost, self.most_cost, self._charged, self._temporaries, self.indent, self._base),
            (dict(self._cells), set(self._stored), dict(self._constants)),
            (list(self.calls), list(self.loops), self._head, self._head_whole),
            (len(self._spans), len(self._searches), dict(self._frames)),
            dict(self.strings),
        )

    def restore(self, state: tuple[Any, ...]) -> None:
        """Take back what was written since."""
        length, numbers, (cells, stored, constants), flow, location, self.strings = state
        del self._lines[length:], self.marks[length:]
        for line in [line for line in self._counted if line >= length]:
            del self._counted[line]
        self.cost, self.most_cost, self._charged, self._temporaries, self.indent, self._base = (
            numbers
        )
        self._cells, self._stored, self._constants = cells, stored, constants
        self.calls, self.loops, self._head, self._head_whole = flow
        spans, searches, self._frames = location
        del self._spans[spans:], self._searches[searches:]
        self.followed = None

    def emit(self, text: str) -> None:
        """Add a line."""
        self._lines.append("  " * self.indent + text)
        self.marks.append(Mark(self._statement, self.cost))

    def _emit_timed(self, text: str, counted: str) -> None:
        """Add a line that has to do with the clock.

        Args:
            text: the line.
            counted: what stands there in a block that counts down what is to `spare` of `given`
                T-states, and tells the clock when it is left.
        """
        self._counted[len(self._lines)] = "  " * self.indent + counted
        self.emit(text)

    def know_string(self, name: str, text: str | None) -> None:
        """A string variable was given a value: text of its characters, if they are known.

        What is assigned on one of several ways leaves a block there.
        """
        if text is not None and self.straight:
            self.strings[name] = text
        elif self.straight:
            self.strings.pop(name, None)

    def charge(self) -> None:
        """Write what has come together to the clock."""
        if self.cost:
            cost, self.cost = self.cost, 0
            self._charged += cost
            self._emit_timed(f"clock.now += {cost}", f"spare -= {cost}")

    def charge_found(self, text: str) -> None:
        """Write T-states that are found at run time to the clock."""
        self._emit_timed(f"clock.now += {text}", f"spare -= {text}")

    def allow(self, most: int) -> None:
        """Reckon with T-states that a call will charge by itself, at most so many."""
        self._charged += most

    def note_cost(self) -> None:
        """One way through the function ends here."""
        self.most_cost = max(self.most_cost, self._charged + self.cost)

    # -- where it stands ----------------------------------------------------------------------

    def begin(self, address: int) -> None:
        """What follows belongs to the statement behind a separator."""
        self.statement = address
        self.address(address)
        self._statement = self._addresses[address]

    def address(self, address: int) -> str:
        """What stands in the text for an address."""
        index = self._addresses.setdefault(address, len(self._addresses))
        return placeholder(index)

    def depends_on(self, first: int, last: int) -> None:
        """The function holds only as long as the program is the same from here to there."""
        self._spans.append((first, last))

    def passes(self, search: Search) -> None:
        """A jump of the function is charged for the lines that it passes."""
        self._searches.append(search)

    @property
    def reach(self) -> int:
        """The highest address of the program that the function was made from."""
        return max((last for _, last in self._spans), default=0)

    def location(self) -> Location:
        """Where the function stands."""
        addresses, spans = tuple(self._addresses), tuple(self._spans)
        return Location(addresses, spans, self.reach, tuple(self._searches))

    # -- leaving ------------------------------------------------------------------------------

    def go(self, address: int) -> None:
        """Go on at an address: a block follows where all ways do, others leave the function."""
        if self.straight:
            self.note_cost()
            self.followed = address
            return
        self.leave_for(address)

    def leave_for(self, address: int) -> None:
        """Leave the function for the statement at an address."""
        home = address == self._leader and not self.loops and not self.calls
        again = "" if home else None
        self._leave(self.address(address), again)

    def look_at_clock(self, address: int) -> None:
        """Leave for the statement at an address if too little time is left for more."""
        self.charge()
        self._asks = True
        to = self.address(address)
        self._emit_timed(
            f"if clock.now >= soft: return {to}",
            f"if spare <= 0: clock.now += given - spare; return {to}",
        )

    def go_to_found(self, text: str) -> None:
        """Leave the function for an address found at run time."""
        self._leave(text)

    def go_to_start(self) -> None:
        """Go round to the block's own start."""
        self.leave_for(self._known_leader)

    def go_to_loop_body(self) -> None:
        """Leave the function for the body of the loop in `f`."""
        again = None
        if self._leader is not None and not self.loops:
            again = f"{_LOOP_BODY} == {self.address(self._leader)} and "
        self._leave(_LOOP_BODY, again)

    def _leave(self, to: str, again: str | None = None) -> None:
        """Charge what has come together and leave; go round at once if there is time.

        Args:
            to: text of the address to go on at.
            again: what must be true besides, with its ` and `; None if it is not to go round.
        """
        self.note_cost()
        cost = self.cost
        if again is not None:
            self._asks = True
            self._emit_timed(f"clock.now = now = clock.now + {cost}", f"spare -= {cost}")
            self._emit_timed(f"if {again}now < soft: continue", f"if {again}spare > 0: continue")
        elif cost:
            self._emit_timed(f"clock.now += {cost}", f"spare -= {cost}")
        self._emit_timed(f"return {to}", f"clock.now += given - spare; given = spare; return {to}")

    def fail(self, code: Code) -> None:
        """Raise a Level II error."""
        self.emit(f"fail({int(code)})")

    # -- names --------------------------------------------------------------------------------

    def temporary(self) -> str:
        """A new local name."""
        self._temporaries += 1
        return f"t{self._temporaries}"

    def keep(self, text: str) -> str:
        """Evaluate an expression now; the local name that holds its value."""
        name = self.temporary()
        self.emit(f"{name} = {text}")
        return name

    def cell(self, name: str, cell: CellType, stored: bool = False) -> str:
        """Use a shared cell under a name."""
        self._cells[name] = cell
        if stored:
            self._stored.add(name)
        return name

    def constant(self, value: object) -> str:
        """A name for an object that the function keeps for itself."""
        name = self._constants.get(id(value))
        if name is None:
            name = self._constants[id(value)] = f"k{len(self._constants)}"
            self._cells[name] = CellType(value)
        return name

    def frame(self, framed: Framed, address: int) -> str:
        """A name for what the function opens a loop or a subroutine with.

        Args:
            framed: makes it by where the loop or the subroutine goes back to.
            address: that.
        """
        name = self.constant(framed(address))
        self.address(address)
        self._frames[name] = framed, self._addresses[address]
        return name

    @property
    def constants(self) -> dict[str, Any]:
        """The objects that the function keeps for itself, by their names."""
        return {name: self._cells[name].cell_contents for name in self._constants.values()}

    # -- the function -------------------------------------------------------------------------

    def source(self) -> str:
        """The Python text of the function, inside one that declares its cells."""
        return with_addresses(self._text()[0], tuple(self._addresses))

    def _text(self) -> tuple[str, int]:
        """The same, and the number of its lines in front of the emitted ones."""
        names = list(self._cells)
        out = ["def cells():"]
        if names:
            out.append(f" {' = '.join(names)} = None")
        out.append(" def statement():")
        if self._stored:
            out.append(f"  nonlocal {', '.join(sorted(self._stored))}")
        counting = self._asks and all(
            number in self._counted or _simple(line) or _is_quiet(line)
            for number, line in enumerate(self._lines)
        )
        head = self._pace(counting) + self._head
        out += [f"  {line}" for line in head]
        lines = self._lines
        if counting:
            lines = [self._counted.get(i) or _told(line) for i, line in enumerate(lines)]
        return "\n".join([*out, *lines, " return statement\n"]), len(out)

    def _pace(self, counting: bool) -> list[str]:
        """The lines of a block that find out until when it may go on."""
        more = self.most_cost - MARGIN
        lines = []
        if self._leader is not None and more > 0:
            # It takes longer than the loop that called it reckons with.
            alone = f"if clock.now >= soft: return alone({self.address(self._leader)})"
            lines = [f"soft = pace.soft - {more}", alone]
        elif self._asks:
            lines = ["soft = pace.soft"]
        return [*lines, "spare = given = soft - clock.now"] if counting else lines

    def build(self, environment: dict[str, Any]) -> Relocatable:
        """The function.

        Args:
            environment: the names that it may use, and what they stand for.

        Raises:
            TooDeep: the text must be written flat.
        """
        source, first_line = self._text()
        try:
            code = _code(source)
        except (SyntaxError, RecursionError, MemoryError):
            if not self.flat:
                raise TooDeep from None
            # A hundred IFs in one another: out of memory here.
            del self._lines[:], self.marks[:]
            self._counted.clear()
            self.indent = 1
            self.fail(Code.OM)
            source, first_line = self._text()
            code = _code(source)
        for name in code.code.co_names:
            if name not in environment and name not in ATTRIBUTES:
                raise UnlistedName(name)
        names = code.code.co_freevars
        cells = tuple([self._cells[name] for name in names])
        frames = tuple([(i, *self._frames[n]) for i, n in enumerate(names) if n in self._frames])
        return Relocatable(code, environment, cells, frames, first_line)


def _is_quiet(line: str) -> bool:
    """Whether a line calls nothing that takes time of its own."""
    return QUIET.issuperset(_CALLED.findall(line))


def _simple(line: str) -> bool:
    """Whether a line is a statement that others can stand beside."""
    return not line.endswith(":")


def _told(line: str) -> str:
    """A line of a block that counts: if it takes time, the clock is right before it."""
    if _is_quiet(line):
        return line
    text = line.lstrip()
    indent = line[: len(line) - len(text)]
    told = "clock.now += given - spare; given = spare"
    return f"{indent}{told}; {text}; spare = given = soft - clock.now"


@lru_cache(_KEPT)
def _code(source: str) -> relocation.Code:
    """What Python makes of the text of a function: the same for the same text."""
    module = compile(source, "<statement>", "exec")
    return relocation.Code.of(_inner(_inner(module, "cells"), "statement"))


def _inner(code: CodeType, name: str) -> CodeType:
    for constant in code.co_consts:
        if isinstance(constant, CodeType) and constant.co_name == name:
            return constant
    raise LookupError(name)
