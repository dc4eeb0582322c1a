"""Every door by its name."""

from __future__ import annotations

from typing import Final

from tests.fuzz import codes, documents, machines, phrases, windows, wires
from tests.fuzz.target import Target

TARGETS: Final[dict[str, Target]] = {
    target.name: target
    for target in (
        *codes.TARGETS,
        *machines.TARGETS,
        *documents.TARGETS,
        *phrases.TARGETS,
        *wires.TARGETS,
        *windows.TARGETS,
    )
}
