"""The routines of statements that call machine code, which are executed again when it is done.

What they print and look at before the call is noted, and given to them as it was the second time
(`code_calls`). Everything else that a statement does before a call may be done twice.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from trs80arm.basic.output import Output
from trs80arm.basic.state import State
from trs80arm.basic.variables import NO_STRING

_PRINTING: Final = (
    *("print_newline", "print_comma", "print_tab", "print_string", "print_number"),
    *("print_anything", "using_literal", "using_number", "using_string", "using_end"),
)
"""They are called again with their output switched off: they also take their arguments."""
_ACTING: Final = ("print_at", "dimension")
_LOOKING: Final = (
    *("peek", "read_port", "rnd", "point", "position"),
    *("free_memory", "free_strings", "free_after"),
)
_KEY: Final = "inkey"


class _Silence:
    """An output that goes nowhere."""

    def __init__(self, output: Output) -> None:
        self.on_printer = output.on_printer
        self.column = output.column

    def put(self, text: bytes) -> None:
        """Nothing."""


def recorded(environment: dict[str, Any], state: State) -> dict[str, Any]:
    """The names for statements that call machine code."""
    names = dict(environment)
    for name in _PRINTING:
        names[name] = _printing(name, environment[name], state)
    for name in _ACTING:
        names[name] = _noted(name, environment[name], state)
    for name in _LOOKING:
        names[name] = _noted(name, environment[name], state)
    names[_KEY] = _key(environment[_KEY], state)
    return names


def _printing(name: str, routine: Callable[..., None], state: State) -> Callable[..., None]:
    part: Any = routine.__self__  # type: ignore[attr-defined]

    def print_(*arguments: Any) -> None:
        calls = state.code_calls
        if not calls.replays(name):
            routine(*arguments)
            calls.note(name, None)
            return
        calls.next()
        output = part._output
        part._output = _Silence(output)
        try:
            routine(*arguments)
        finally:
            part._output = output

    return print_


def _noted(name: str, routine: Callable[..., Any], state: State) -> Callable[..., Any]:
    def look(*arguments: Any) -> Any:
        calls = state.code_calls
        if not calls.replays(name):
            result = routine(*arguments)
            calls.note(name, result)
            return result
        for argument in arguments:
            if isinstance(argument, list) and name not in _ACTING:
                state.strings.free(argument)
        return calls.next()

    return look


def _key(routine: Callable[[], Any], state: State) -> Callable[[], Any]:
    def inkey() -> Any:
        calls = state.code_calls
        if calls.replays(_KEY):
            text = calls.next()
            return state.strings.new(text) if text else list(NO_STRING)
        string = routine()
        calls.note(_KEY, state.strings.bytes_of(string))
        return string

    return inkey
