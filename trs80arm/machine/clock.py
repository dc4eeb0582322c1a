"""The one clock of the rig: a count of the Z-80's T-states since power-on.

Whatever takes time on the real machine moves `now` on; nothing here looks at the wall clock.
"""

from __future__ import annotations

T_STATES_PER_SECOND = 1_774_080
"""The Model I's 1.77408 MHz (Level II facts, title)."""
END_OF_TIME = 1 << 60
"""The last T-state that a rig runs to, after 20,592 years: times are kept in 64 bits."""


class Clock:
    """Virtual time.

    Attributes:
        now: T-states since power-on.
        limit: the T-state at which whoever is running should come back to the rig.
    """

    __slots__ = ("limit", "now")

    def __init__(self) -> None:
        self.now = 0
        self.limit = 0

    def __getstate__(self) -> tuple[None, dict[str, int]]:
        # How far whoever is running may go says nothing about the machine.
        return None, {"now": self.now, "limit": 0}

    @property
    def seconds(self) -> float:
        """Virtual seconds since power-on."""
        return self.now / T_STATES_PER_SECOND
