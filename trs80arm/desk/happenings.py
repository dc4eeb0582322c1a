"""What happens to the arm, told as it happens: each thing once, when it is over.

A slip or a push that goes on is one event, and is told when it has ended or the machine waits, so
that all of it is in one sentence.
"""

from __future__ import annotations

from collections.abc import Iterator

from trs80arm.arm.events import ArmEvent, EventKind
from trs80arm.desk.session import Session
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.rig import Waiting

LULL = T_STATES_PER_SECOND // 4
"""T-states without more of it after which a thing is over."""
_AT_ONCE = {EventKind.TAKEN, EventKind.PLACED, EventKind.DROPPED, EventKind.FED}


class Happenings:
    """Remembers which events of a session were told.

    Args:
        session: whose arm it is.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._untold = 0
        session.watch_machine(self._start_afresh)
        self._start_afresh()

    def _start_afresh(self) -> None:
        """Nothing of what has happened so far is told."""
        self._untold = self._session.rig.arm.event_count

    def new(self) -> Iterator[ArmEvent]:
        """The events that are over and were not told, oldest first."""
        rig = self._session.rig
        waits = self._session.waiting is not Waiting.NOTHING
        if rig.arm.event_count < self._untold:
            self._start_afresh()
        for event in rig.arm.events:
            if event.number < self._untold:
                continue
            over = waits or event.kind in _AT_ONCE or event.until + LULL < rig.clock.now
            if not over:
                return
            self._untold = event.number + 1
            yield event
