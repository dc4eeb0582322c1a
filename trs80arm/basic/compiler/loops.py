"""FOR and NEXT: loops that a block goes round in itself, loops around it, and any others."""

from __future__ import annotations

import math
from typing import Final

from trs80arm.basic import costs, room, tokens, words
from trs80arm.basic.characters import COMMA
from trs80arm.basic.compiler import rounding
from trs80arm.basic.compiler.assignments import AssignmentCompiler
from trs80arm.basic.compiler.draft import Draft, Mistake
from trs80arm.basic.compiler.emitter import KNOWN_LIMIT, KNOWN_LOOP, Loop
from trs80arm.basic.compiler.expressions import ExpressionCompiler
from trs80arm.basic.compiler.values import Expression
from trs80arm.basic.control import ForFrame
from trs80arm.basic.errors import Code
from trs80arm.basic.kinds import DOUBLE, INTEGER, SINGLE, STRING
from trs80arm.basic.variables import Key
from trs80arm.basic.words import Word

_ALL_EXACT: Final = 2.0**24
"""Up to here every whole number is a single."""
_LONGEST_STRIDE: Final = 2.0**20
"""Whole steps up to this are counted without a look at each."""


class LoopCompiler:
    """FOR and NEXT.

    Args:
        draft: the statement.
        expressions: who reads limits and steps.
        assignments: who reads the variable of a FOR.
        line: the number of the line that is compiled, 65535 for a direct one.
        loops: the variables of the open loops, the guess for a bare NEXT.
    """

    def __init__(
        self,
        draft: Draft,
        expressions: ExpressionCompiler,
        assignments: AssignmentCompiler,
        line: int,
        loops: list[Key],
    ) -> None:
        self._draft = draft
        self._reader = draft.reader
        self._out = draft.out
        self._scope = draft.scope
        self._expressions = expressions
        self._assignments = assignments
        self._line = line
        self._loops = loops

    def _scalar(self, key: Key) -> str:
        """The name of the variable itself, for the loops that it runs."""
        return self._out.constant(self._scope.object(key))

    def for_(self, word: Word) -> None:
        """FOR: variable, limit and step; an open loop of the same variable is dropped."""
        out, reader = self._out, self._reader
        out.cost += word.work
        start = reader.state()
        key = self._expressions.name()
        reader.restore(start)
        target = self._assignments.target(arrays=False)
        self._draft.expect(tokens.EQUAL)
        begins = self._expressions.expression()
        self._assignments.store(target, begins)
        scalar = self._scalar(key)
        out.emit("if frames[-1].scalar is not None:")
        out.emit(f"  drop_loop({scalar})")
        state = reader.state()
        reader.skip_statement()
        body = reader.address
        reader.restore((state[0], out.cost))
        self._draft.expect(tokens.TO)
        if key[1] in (STRING, DOUBLE):
            raise Mistake(Code.TM)
        to_kind = self._expressions.convert.to_kind
        with self._draft.deeper(room.LIMIT):
            ends = to_kind(self._expressions.number(), key[1])
            limit = out.keep(ends.text)
        by: int | float | None = 1 if key[1] == INTEGER else 1.0
        step = repr(by)
        with self._draft.deeper(room.STEP):
            if reader.code == tokens.STEP:
                out.cost += words.BY_TOKEN[tokens.STEP].work
                reader.advance()
                value = to_kind(self._expressions.number(), key[1])
                step, by = value.text, value.constant
        opened = f"open_loop({scalar}, {limit}, {step}, {out.address(body)}, {self._line})"
        self._loops.append(key)
        if by is None or not _usual(by):
            out.emit(opened)
            return
        # A loop that is opened again with the same limit is the same.
        loop, usual, line = self._scope.object(key), by, self._line
        before = out.frame(lambda body: [ForFrame(loop, math.nan, usual, body, line)], body)
        frame = out.keep(f"{before}[0]")
        out.emit(
            f"if {frame}.limit == {limit} and memory_room.plenty and len(frames) < {room.FEW}:"
        )
        out.emit(f"  frames.append({frame})")
        out.emit("else:")
        out.emit(f"  {frame} = {before}[0] = {opened}")
        if out.straight and reader.address == body:
            name = self._scope.cell_name(key)
            whole = self._whole_limit(name, key, by, begins, ends, limit)
            out.begin_loop(Loop(key, body, frame, limit, by, whole, out.lines, len(out.calls)))

    def next_(self, word: Word) -> None:
        """NEXT [names]: step, compare, and go back to the body or on."""
        if self._reader.at_end:
            self._step_loop(word, None)
            del self._loops[-1:]
            return
        while True:
            key = self._expressions.name()
            scalar = self._scope.scalar(key)
            self._out.cost += costs.VARIABLE + self._scope.search(scalar)
            if not self._scope.exists(key):
                self._out.emit(f"create({self._out.constant(key)})")
            self._step_loop(word, key)
            del self._loops[-1:]
            if self._reader.code != COMMA:
                return
            self._reader.advance()

    def _step_loop(self, word: Word, key: Key | None) -> None:
        """One loop's step: at once when the innermost loop is the expected one."""
        out = self._out
        guess = key or (self._loops[-1] if self._loops else None)
        if guess is None or guess[1] in (STRING, DOUBLE):
            out.cost += word.work
            self._slow_step(key, word.work)
            return
        if out.straight and out.loops and out.loops[-1].key == guess:
            self._step_in_block(word, out.loops[-1], key)
            return
        integer = guess[1] == INTEGER
        work = costs.NEXT_INTEGER if integer else word.work
        out.cost += work
        cell = self._scope.scalar(guess).cell
        name = out.cell(self._scope.cell_name(guess), cell, stored=True)
        charged = out.cost
        around = out.around
        known = around and around.scalar is self._scope.object(guess) and _usual(around.step)
        if around and known:
            self._step_around(name, guess, around)
            out.cost = charged
        out.emit("f = frames[-1]")
        out.emit(f"if f.scalar is {self._scalar(guess)}:")
        out.indent += 1
        if integer:
            out.emit(f"{name} = t = integer_step({name}, f.step)")
            out.emit("if (t <= f.limit if f.up > 0 else goes_on(t, f)):")
        else:
            out.emit(f"if {rounding.short_step(name, 'f.step')} <= f.top:")
            out.indent += 1
            out.emit(f"{name} = s")
            out.go_to_loop_body()
            out.indent -= 1
            stepped = rounding.sum_(name, "+", "f.step", f"add({name}, f.step)")
            out.emit(f"{name} = t = {stepped}")
            out.emit("if goes_on(t, f):")
        out.indent += 1
        out.go_to_loop_body()
        out.indent -= 1
        out.emit("frames.pop()")
        out.indent -= 1
        out.emit("else:")
        out.indent += 1
        out.cost = charged
        self._slow_step(key, work)
        out.indent -= 1
        if around and known:
            # The loop is done: who jumps to its body now finds another one.
            out.emit(f"{KNOWN_LIMIT} = {_beyond(around.step)}")

    def _whole_limit(
        self, name: str, key: Key, step: float, begins: Expression, ends: Expression, limit: str
    ) -> str:
        """What a loop of whole numbers that is opened can be compared with and no more.

        Such a loop counts exactly: no step needs to be looked at. The limit where that is certain
        now, a name that is beyond all numbers where it is not so, nothing for other loops.
        """
        most = _counted_to(key, step)
        if not most:
            return ""
        if begins.constant is not None and not _counts(begins.constant, most):
            return ""
        if begins.constant is not None and ends.constant is not None:
            return limit if abs(ends.constant) <= most else ""
        return self._out.keep(_least_limit(name, step, most, limit))

    def _step_around(self, name: str, key: Key, frame: ForFrame) -> None:
        """The short way of the loop whose body begins where this block does."""
        out = self._out
        step, value = frame.step, frame.scalar.cell.cell_contents
        most = _counted_to(key, step)
        certain = not out.loops and out.keeps_frames(0, 0)
        whole = bool(most) and certain and _counts(value, most) and not out.stores(name, 0)
        limit = f"{KNOWN_LOOP}.limit"
        if whole:
            limit = _least_limit(name, step, most, limit)
        whole &= out.know_loop_around(self._scalar(key), step, limit, _beyond(step), whole)
        test = f"(s := {name} + ({step!r})) {_until(step)} {KNOWN_LIMIT}"
        if not whole:
            test = _short_step(name, key, step, KNOWN_LIMIT)
        out.emit(f"if {test}:" if certain else f"if {KNOWN_LOOP} is frames[-1] and {test}:")
        out.indent += 1
        out.emit(f"{name} = s")
        out.go_to_start()
        out.indent -= 1

    def _step_in_block(self, word: Word, loop: Loop, key: Key | None) -> None:
        """The step of a loop whose body is in this function, from its FOR on.

        Args:
            word: NEXT.
            loop: which.
            key: the variable, if it is named.
        """
        out = self._out
        integer = loop.key[1] == INTEGER
        work = costs.NEXT_INTEGER if integer else word.work
        out.cost += work
        name = out.cell(
            self._scope.cell_name(loop.key), self._scope.scalar(loop.key).cell, stored=True
        )
        whole = "" if out.stores(name, loop.start) else loop.whole
        charged = out.cost
        certain = out.keeps_frames(loop.start, loop.calls)
        if not certain:
            out.emit(f"if frames[-1] is {loop.frame}:")
            out.indent += 1
        self._go_round_or_on(name, loop, whole)
        out.emit("frames.pop()")
        if not certain:
            out.indent -= 1
            out.emit("else:")
            out.indent += 1
            out.cost = charged
            self._slow_step(key, work)
            out.indent -= 1
        out.end_loop()

    def step_at(self, address: int) -> None:
        """A jump goes to an address: where the NEXT of the loop at work stands there, its step.

        If the loop does not go on, or needs a closer look, the jump goes to the NEXT itself.
        """
        out, loops = self._out, self._loops
        found = out.next_at(address, loops) if loops and out.next_at else None
        if found is None or found.key not in (None, loops[-1]):
            return
        key, charged = loops[-1], out.cost
        loop, around = out.loops[-1] if out.loops else None, out.around
        frame, limit, step = KNOWN_LOOP, KNOWN_LIMIT, 0.0
        if loop is not None:
            if loop.key != key:
                return
            frame, limit, step = loop.frame, loop.limit, loop.step
        elif around and around.scalar is self._scope.object(key) and _usual(around.step):
            step = around.step
            out.know_loop_around(self._scalar(key), step, f"{frame}.limit", _beyond(step), False)
        else:
            return
        name = out.cell(self._scope.cell_name(key), self._scope.scalar(key).cell, stored=True)
        out.depends_on(address, found.reach)
        out.cost += found.cost
        out.emit(f"if {frame} is frames[-1] and {_short_step(name, key, step, limit)}:")
        out.indent += 1
        out.emit(f"{name} = s")
        if loop is not None:
            out.go_round()
        else:
            out.go_to_start()
        out.indent -= 1
        out.cost = charged

    def _go_round_or_on(self, name: str, loop: Loop, whole: str) -> None:
        """The step, and the body again if the loop goes on."""
        out = self._out
        step, until = loop.step, _until(loop.step)
        if loop.key[1] == INTEGER:
            self._round(f"{_short_step(name, loop.key, step, loop.limit)}", name)
            out.emit(f"{name} = integer_step({name}, {step!r})")
            return
        if whole:
            self._round(f"(s := {name} + ({step!r})) {until} {whole}", name)
            if whole == loop.limit:
                out.emit(f"{name} = s")
                return
            out.emit(f"if {whole} == {loop.limit}:")
            out.emit(f"  {name} = s")
            out.emit("else:")
            out.indent += 1
        self._round(_short_step(name, loop.key, step, loop.limit), name)
        out.emit(f"{name} = t = add({name}, {step!r})")
        self._round(f"t {until} {loop.limit}")
        if whole:
            out.indent -= 1

    def _round(self, test: str, name: str = "") -> None:
        """The loop's body again where a text is true; `s` is the variable's value then."""
        out = self._out
        out.emit(f"if {test}:")
        out.indent += 1
        if name:
            out.emit(f"{name} = s")
        out.go_round()
        out.indent -= 1

    def _slow_step(self, key: Key | None, work: int) -> None:
        """NEXT of whatever loop there is; `work` was charged."""
        wanted = "None" if key is None else self._scalar(key)
        if key is None:
            self._out.charge_found(f"other_step({work})")
        self._out.emit(f"t = step_loop({wanted})")
        self._out.emit("if t:")
        self._out.indent += 1
        self._out.go_to_found("t")
        self._out.indent -= 1


def _usual(step: float) -> bool:
    """Whether a step has a short way."""
    return bool(step) if isinstance(step, int) else rounding.is_near(step)


def _counted_to(key: Key, step: float) -> float:
    """How far from zero a loop of whole singles may be, so that its next value is exact; or 0."""
    if key[1] != SINGLE or step % 1.0 or abs(step) > _LONGEST_STRIDE:
        return 0.0
    return _ALL_EXACT - abs(step)


def _counts(value: float, most: float) -> bool:
    """Whether a loop that begins with a value is one of such whole numbers."""
    return not value % 1.0 and abs(value) <= most


def _least_limit(name: str, step: float, most: float, limit: str) -> str:
    """Text of the limit up to where a loop counts whole numbers, beyond all if it does not."""
    end = most if step > 0 else -most
    least = f"{limit} if {limit} {_until(step)} {end!r} else {end!r}"
    return f"({least}) if not {name} % 1.0 and -{most!r} <= {name} <= {most!r} else {_beyond(step)}"


def _beyond(step: float) -> str:
    """Text of a limit that a loop has passed with any value."""
    return "-1e39" if step > 0 else "1e39"


def _until(step: float) -> str:
    """How a loop's variable is compared with the limit."""
    return "<=" if step > 0 else ">="


def _short_step(name: str, key: Key, step: float, limit: str) -> str:
    """Text that is true where a step is exact and the loop goes on; the next value is `s`."""
    by = f"({step!r})"
    # What does not pass the limit is an integer.
    value = f"(s := {name} + {by})" if key[1] == INTEGER else rounding.short_step(name, by)
    return f"{value} {_until(step)} {limit}"
