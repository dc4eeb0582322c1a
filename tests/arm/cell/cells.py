"""Work cells for tests: a bench file's text, and the machine at it, driven from BASIC."""

from __future__ import annotations

from trs80arm import Rig
from trs80arm.arm import benchfile


def at_the_cell(bench: str) -> Rig:
    """A machine whose arm works at a bench."""
    return Rig(bench=benchfile.parse(bench, "cell.toml"))


def run(rig: Rig, program: str, seconds: float = 600.0) -> str:
    """What a BASIC program prints on the printer."""
    rig.load_text(program)
    rig.type("RUN\r")
    rig.run_until_waiting(seconds)
    return rig.printer.text
