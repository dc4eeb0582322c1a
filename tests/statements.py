"""Statements typed at a machine's keyboard, each when the one before is done."""

from __future__ import annotations

from trs80arm import Rig

LONGEST = 120
"""Seconds that one of them may take."""


def done(rig: Rig, *statements: str) -> Rig:
    """The machine, when it has done some statements."""
    for statement in statements:
        rig.type(statement + "\r")
        rig.run_until_waiting(LONGEST)
    return rig
