"""The way back to the command level, from wherever the machine is.

Everything that ends a program or a command goes through here; the command level itself is the
bottom of the interpreter's stack.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from trs80arm.basic.activity import Activity

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter


class Home(Activity):
    """The bottom of the stack: what it does next can be set from outside."""

    def __init__(self) -> None:
        self._ready = True

    def come_back(self, ready: bool) -> None:
        """Begin again, with READY or with a prompt alone."""
        self._ready = ready


def return_to_command(basic: Interpreter, *, ready: bool = True) -> None:
    """End everything under way: READY and `>`.

    Args:
        basic: the interpreter.
        ready: whether READY is printed; after a stored line there is `>` alone.
    """
    bottom = basic.stack[0]
    assert isinstance(bottom, Home)
    del basic.stack[1:]
    bottom.come_back(ready)
