"""A machine that nobody sits at, with its program in memory: for runs, sweeps and exports."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from trs80arm.arm.bench import Bench
from trs80arm.basic.activity import Waiting
from trs80arm.basic.dialogue.boot import LEAST_TOP
from trs80arm.benches import BenchFile, bench_for
from trs80arm.files import load_program
from trs80arm.machine.cassette import ProgramLine
from trs80arm.machine.memory import RAM_START
from trs80arm.rig import Rig, RigSettings


class NotReadyError(Exception):
    """The machine asks for something before it is ready, and nobody is there; one clear line."""


def ready(settings: RigSettings, bench: Bench | None, lines: Iterable[ProgramLine]) -> Rig:
    """A machine at READY with a program in memory.

    Args:
        settings: its fittings.
        bench: what stands on the table.
        lines: the program.

    Raises:
        NotReadyError: it is given a memory size that it does not take.
    """
    rig = Rig(settings, bench)
    if rig.waiting is Waiting.MEMORY_SIZE:
        raise NotReadyError(
            f"MEMORY SIZE? does not take {settings.memory_size!r}: an address from {LEAST_TOP} to "
            f"{RAM_START + 1024 * settings.ram_kib - 1}, or nothing"
        )
    rig.load_lines(lines)
    return rig


def ready_with(settings: RigSettings, program: Path | None, bench: Path | None) -> Rig:
    """A machine at READY with the program of a file in memory.

    Args:
        settings: its fittings.
        program: the file; None leaves the memory empty.
        bench: a bench file; None takes the one beside the program, if there is one.

    Raises:
        NotReadyError: it is given a memory size that it does not take.
        FileFormatError, BenchError, OSError: a file cannot be used.
    """
    lines = load_program(program) if program else []
    path = bench_for(program, bench)
    return ready(settings, BenchFile.read(path).bench if path else None, lines)
