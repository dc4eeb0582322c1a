"""INPUT: the prompt, the answer, and its items into the variables.

The ROM takes READ's way through the items, with `??` where READ looks for the next DATA and ?REDO
where READ is out of step. It looks at a variable only when its item is there, so subscripts see the
items before, and an error in the list comes after the question.
"""

from __future__ import annotations

from typing import Any, Final, Protocol

from trs80arm.basic import costs, number_costs
from trs80arm.basic.activity import Waiting
from trs80arm.basic.characters import BLANKS, COLON, COMMA, END, QUOTE
from trs80arm.basic.dialogue.line_input import LineInput
from trs80arm.basic.execution import break_
from trs80arm.basic.kinds import Kind
from trs80arm.basic.numbers import double, literal
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.state import Activity, State

_T_ASK: Final = 269
_T_ITEM: Final = 2130
"""T-states of an item, beside its conversion and assignment."""


class Target(Protocol):
    """One variable of the list."""

    @property
    def kind(self) -> Kind:
        """`i`, `s`, `d` or `t` for text; looked at, the variable is found, subscripts and all."""

    def assign(self, value: Any) -> None:
        """Give it a number of any type, or bytes."""


class TargetList(Protocol):
    """The list of variables, each found in its turn."""

    def __len__(self) -> int: ...

    def __getitem__(self, number: int) -> Target: ...

    def restart(self) -> None:
        """The answer was no good: none has been found yet."""

    @property
    def at_end(self) -> bool:
        """Whether the statement ends behind the variables found."""


class Items:
    """Items separated by commas, as INPUT and INPUT# read them.

    Args:
        text: without its end; it is begun as if a comma stood before it.
    """

    def __init__(self, text: bytes) -> None:
        self._text = text
        self._place = 0
        self._comma = True
        self.scanning = 0
        """T-states that the scan of the number taken last has cost."""

    @property
    def is_next(self) -> bool:
        """Whether an item, an empty one perhaps, follows."""
        return self._comma

    @property
    def is_rest(self) -> bool:
        """Whether text is left behind the last item taken."""
        return self._comma or self._place < len(self._text)

    def _skip(self) -> int:
        """Go to the next character that is no blank; 0 at the end."""
        text = self._text
        while self._place < len(text) and text[self._place] in BLANKS:
            self._place += 1
        return text[self._place] if self._place < len(text) else 0

    def number(self, kind: Kind) -> Number:
        """The next item as a number; what is none is 0 and stays to be seen behind it."""
        self._skip()
        start: Number = double.ZERO if kind == "d" else 0
        meter = number_costs.LiteralMeter()
        value, self._place = literal.scan(self._text, self._place, start, meter)
        self.scanning = meter.total
        return value

    def string(self) -> bytes:
        """The next item as a string: quoted, or up to a comma or colon."""
        text = self._text
        if self._skip() == QUOTE:
            end = text.find(b'"', self._place + 1)
            end = len(text) if end < 0 else end
            start, self._place = self._place + 1, end + 1
            return text[start:end]
        start = self._place
        while self._place < len(text) and text[self._place] not in (COMMA, COLON):
            self._place += 1
        return text[start : self._place]

    def separator(self) -> bool:
        """Pass the comma behind an item; whether one, or the end, or a colon was there."""
        code = self._skip()
        self._comma = code == COMMA
        self._place += self._comma
        return self._comma or code in (END, COLON)


class InputStatement(Activity):
    """One INPUT from its prompt to its last variable.

    Args:
        prompt: the text in front of the question mark.
        targets: the variables.
    """

    _prompt: bytes
    _targets: TargetList
    _done: int
    _question: bytes | None

    def __init__(self, prompt: bytes, targets: TargetList) -> None:
        self._prompt = prompt
        self._targets = targets
        self._done = 0
        self._question = prompt + b"? "

    def advance(self, state: State) -> None:
        """Ask."""
        question, self._question = self._question, None
        state.clock.now += _T_ASK
        state.output.show(question or b"")
        state.begin(LineInput(Waiting.INPUT))

    def resumed(self, state: State, result: Any) -> None:
        """A line was typed: BREAK breaks, an empty one leaves what is left as it was."""
        if result.text is None:
            break_(state)
        elif not result.text:
            self._targets.restart()
            state.end()
        else:
            self._take(state, Items(result.text))

    def _take(self, state: State, items: Items) -> None:
        while self._done < len(self._targets):
            target = self._targets[self._done]
            kind = target.kind
            if not items.is_next:
                self._question = b"?? "
                return
            state.clock.now += _T_ITEM
            value = items.string() if kind == "t" else items.number(kind)
            if not isinstance(value, bytes):
                state.clock.now += costs.constant(value, items.scanning)
            target.assign(value)
            if not items.separator():
                state.output.show(b"?REDO\r")
                self._done = 0
                self._targets.restart()
                self._question = self._prompt + b"? "
                return
            self._done += 1
        if items.is_rest and self._targets.at_end:
            state.output.show(b"?Extra ignored\r")
        state.end()
