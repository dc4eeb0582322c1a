"""What the language asks of the engine that executes statements.

`code.CompiledCode` is the engine that there is; another one, a plain walker of the text for
instance, is a class with these methods, handed to `State`. An engine keeps nothing that a snapshot
would have to hold.
"""

from __future__ import annotations

from typing import Any, Protocol


class Place(Protocol):
    """Where an execution is, as the engine moves it on."""

    next: int
    """The separator in front of the next statement."""
    statement: int
    """The separator in front of the last one executed."""


class Engine(Protocol):
    """Executes statements, and is told of everything that it may have taken for granted."""

    stale: bool
    """Whether the text, or the types of names, changed under the running statement."""

    def run(self, place: Place) -> None:
        """Execute statements from `place.next` on until the clock's limit.

        Raises:
            BasicError: of the statement that `place` is left at, its time charged.
            Leave: the statement wants the loop to look around.
        """

    def step(self, address: int) -> int:
        """Execute the statement behind a separator: the address of the next.

        It raises what `run` does.
        """

    def find_target(self, address: int) -> tuple[Any, int]:
        """The variable whose name stands at an address (INPUT's list), and what stands behind it.

        It is made if it is not there, subscripts are evaluated.
        """

    def look_around(self) -> None:
        """The text, the types of names or the mode changed."""

    def cleared(self) -> None:
        """The variables are gone."""

    def created(self) -> None:
        """A variable or an array was made."""

    def forget_direct(self) -> None:
        """Another direct line stands in the buffer."""
