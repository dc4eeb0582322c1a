"""What a statement has found out before machine code that it calls by USR is done.

Nothing blocks, and a statement is never left in its middle: at USR it is left as a whole, the
machine code runs as an activity of its own, and then the statement is executed again. What it
printed and looked at before the call is not done again: the second time round it is given what it
found the first time.
"""

from __future__ import annotations

from typing import Any, Final

USR: Final = "user_routine"
"""The routine behind USR, by which its result is noted."""


class CodeCalls:
    """The record of the statement that calls machine code.

    Attributes:
        address: of the statement's separator.
        names: of the routines that act on the machine or look at it, in order.
        results: what each of them gave, None for those that only act.
        again: whether the statement is to be executed again with these results.
        place: how many of them it has been given.
        pending: T-states of the statement that were charged when it came to the call, and are
            charged once more by the time that it comes there again.
        resumed: the T-state at which it was begun this time.
        active: whether a statement is being executed that may call machine code.
    """

    def __init__(self) -> None:
        self.address = 0
        self.names: list[str] = []
        self.results: list[Any] = []
        self.again = False
        self.place = 0
        self.pending = 0
        self.resumed = 0
        self.active = False

    def begin(self, address: int, now: int) -> None:
        """The statement at an address is executed: anew, or again."""
        if not (self.again and self.address == address):
            self.forget()
        self.again = False
        self.active = True
        self.address = address
        self.place = 0
        self.resumed = now

    def end(self) -> None:
        """The statement has been left."""
        self.active = False

    def forget(self) -> None:
        """Nothing is to be executed again."""
        self.again = False
        self.names.clear()
        self.results.clear()
        self.place = 0

    def replays(self, name: str) -> bool:
        """Whether the routine that is called now was called there before."""
        if self.place >= len(self.names):
            return False
        if self.names[self.place] == name:
            return True
        # The code has put another statement there.
        del self.names[self.place :], self.results[self.place :]
        return False

    def next(self) -> Any:
        """What the routine gave that is called now."""
        self.place += 1
        return self.results[self.place - 1]

    def note(self, name: str, result: Any) -> None:
        """A routine was called for the first time."""
        self.names.append(name)
        self.results.append(result)
        self.place = len(self.names)

    def returned(self, result: Any) -> None:
        """The machine code has ended: the statement is executed again."""
        self.note(USR, result)
        self.again = True
