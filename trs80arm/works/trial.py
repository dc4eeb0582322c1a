"""Whether works that came from outside can be those of a machine."""

from __future__ import annotations

import math
import pickle
from dataclasses import astuple

from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.keys import Key
from trs80arm.snapshot_error import SnapshotError
from trs80arm.works.devices import Works
from trs80arm.works.key_events import KeyEvents
from trs80arm.works.observers import Observers
from trs80arm.works.running import Running

_TRIAL = 1 / 60
"""Virtual seconds that a machine from a snapshot must be able to run for."""
_BREAK = 1 / 10
"""Virtual seconds for which BREAK is then held."""


def try_out(works: Works) -> None:
    """Let a copy of works run for a moment, with nobody looking on.

    Args:
        works: they have no ROM of their own.

    Raises:
        SnapshotError: they cannot.
    """
    try:
        copy: Works = pickle.loads(pickle.dumps(works, pickle.HIGHEST_PROTOCOL))
    except Exception:
        raise SnapshotError("no snapshot: a machine in a state that cannot be") from None
    use_up(copy)


def use_up(works: Works) -> None:
    """Let works run for a moment that are not wanted afterwards.

    Raises:
        SnapshotError: they cannot.
    """
    observers = Observers()
    observers.connect(works)
    keys = KeyEvents(works)
    running = Running(works, keys, observers)

    def pass_time(seconds: float) -> None:
        # From now: the last statement may have taken it far beyond the time that was asked for.
        running.run_to(works.clock.now + round(seconds * T_STATES_PER_SECOND))

    try:
        if works.controller is not None and not works.controller.possible:
            raise ValueError("the computer in the arm's base holds what it cannot")
        pass_time(_TRIAL)
        works.video.lines()
        works.joints, works.basic.waiting  # noqa: B018
        # Whatever it does, its operator can break off.
        keys.hold([Key.BREAK], _BREAK)
        pass_time(_BREAK / 2)
        keys.stop_typing()
        keys.release_all()
        keys.hold([Key.BREAK], _BREAK)
        pass_time(2 * _BREAK)
        if not all(-0x8000 <= count <= 0x7FFF for count in works.driver.registers):
            raise ValueError("registers have 16 bits")
        works.arm.answers(works.clock.now)
        if not all(map(math.isfinite, astuple(works.arm.state().pose))):
            raise ValueError("the hand is nowhere")
    except Exception:
        # Whatever the classes of the machine say to values that they never have.
        raise SnapshotError("no snapshot: a machine in a state that cannot be") from None
