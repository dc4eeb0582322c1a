"""From the marker of a test to the rig that it gets."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from trs80arm.arm.bench import Bench, BenchError
from trs80arm.arm.settings import ArmSettings
from trs80arm.benches import BenchFile, bench_beside
from trs80arm.files import FileFormatError
from trs80arm.reasons import one_line
from trs80arm.rig import RigSettings
from trs80arm.testing.program_rig import ProgramRig

DEFAULT_ARM = ArmSettings().model


class MarkerError(Exception):
    """What a marker says cannot be done; one line."""


def fitted_rig(
    folder: Path,
    program: str | Path | None = None,
    *,
    bench: str | Path | None = None,
    arm: str = DEFAULT_ARM,
    ram: int = 16,
    settings: RigSettings | None = None,
) -> ProgramRig:
    """A rig with a program in memory and a bench before it.

    Args:
        folder: where programs and benches are.
        program: a program file in it; None for an empty memory.
        bench: a bench file in it; the one that is named like the program and stands beside it, if
            there is one, unless given.
        arm: name of the make of arm.
        ram: KiB of memory, 4, 16, 32 or 48.
        settings: all other fittings.

    Raises:
        MarkerError: a file is not there or damaged, or there is no such arm or memory.
    """
    try:
        chosen = settings or RigSettings()
        chosen = replace(chosen, ram_kib=ram, arm=replace(chosen.arm, model=arm))
        path = None if program is None else folder / program
        benchfile = folder / bench if bench is not None else path and bench_beside(path)
        rig = ProgramRig(chosen, _bench(benchfile))
        if path is not None:
            rig.load(path)
    except (OSError, ValueError, TypeError, FileFormatError, BenchError) as error:
        raise MarkerError(one_line(error)) from None
    return rig


def _bench(path: Path | None) -> Bench | None:
    return BenchFile.read(path).bench if path is not None else None


def from_marker(folder: Path, args: tuple[Any, ...], kwargs: dict[str, Any]) -> ProgramRig:
    """The rig that a marker's arguments describe.

    Raises:
        MarkerError: as `fitted_rig`, or the marker has an argument that there is not.
    """
    known = ("program", "bench", "arm", "ram", "settings")
    strange = [name for name in kwargs if name not in known]
    if strange or len(args) > 1:
        raise MarkerError(
            f"@pytest.mark.trs80arm takes one program and {', '.join(known[1:])}"
            + (f", not {', '.join(strange)}" if strange else "")
        )
    return fitted_rig(folder, *args, **kwargs)
