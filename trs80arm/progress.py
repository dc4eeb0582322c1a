"""How far a motion of the arm has come: the one word that language and driver share.

The ARMBASIC driver says it after every turn; the language, which knows no driver, waits for it.
"""

from __future__ import annotations

from enum import Enum


class Progress(Enum):
    """How far an arm command has come."""

    DONE = "done"
    BUSY = "busy"
    BREAK = "break"
