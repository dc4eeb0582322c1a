"""A part of the runtime: its public methods are the routines that compiled statements call."""

from __future__ import annotations

from trs80arm.basic.state import State


class Part:
    """Routines of one machine; a trailing `_` in a name only avoids Python's own."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._clock = state.clock
        self._output = state.output
        self._memory = state.memory
        self._ram = state.memory.ram
        self._console = state.host.console
        self._strings = state.strings
        self._variables = state.variables
        self._control = state.control
