"""What the machine waits for, as a person at the keyboard would put it."""

from __future__ import annotations

from enum import Enum


class Waiting(Enum):
    """What the activity on top of the machine's stack waits for."""

    NOTHING = "nothing"
    MEMORY_SIZE = "memory size"
    COMMAND = "command"
    AUTO = "auto"
    INPUT = "input"
    EDIT = "edit"
    PAUSE = "pause"
    SET = "manual mode"
    SYSTEM = "system"
