"""Work cells for tests: a bench file's text, and the arm or the machine at it."""

from __future__ import annotations

from trs80arm import Rig
from trs80arm.arm import MiniMover, benchfile
from trs80arm.arm.stepping import PulseGenerator


def arm_at(bench: str) -> MiniMover:
    """An arm that works at a bench."""
    return MiniMover(bench=benchfile.parse(bench, "cell.toml"))


def stepping_at(bench: str) -> PulseGenerator:
    """An arm that works at a bench, its coils on where it stands, to be stepped."""
    generator = PulseGenerator(arm_at(bench))
    generator.align()
    return generator


def at_the_cell(bench: str) -> Rig:
    """A machine whose arm works at a bench."""
    return Rig(bench=benchfile.parse(bench, "cell.toml"))


def started(rig: Rig, program: str) -> Rig:
    """The machine with RUN typed for a BASIC program."""
    rig.load_text(program)
    rig.type("RUN\r")
    return rig


def run(rig: Rig, program: str, seconds: float = 600.0) -> str:
    """What a BASIC program prints on the printer."""
    started(rig, program).run_until_waiting(seconds)
    return rig.printer.text
