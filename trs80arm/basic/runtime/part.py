"""A part of the runtime: its public methods are names for compiled statements."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter


class Part:
    """Methods that compiled statements call; a trailing `_` in a name only avoids Python's."""

    def __init__(self, basic: Interpreter) -> None:
        self._basic = basic
        self._clock = basic.clock
        self._memory = basic.memory
        self._ram = basic.memory.ram
        self._console = basic.host.console
        self._strings = basic.strings
        self._variables = basic.variables
        self._control = basic.control

    def names(self) -> dict[str, Any]:
        """Every public method by its name."""
        return {
            name: getattr(self, name)
            for name in dir(type(self))
            if not name.startswith("_") and name != "names"
        }
