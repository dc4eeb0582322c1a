"""What `trs80arm export` does: a rig as it stands, or a program's run, for another program."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from trs80arm.arm.bench import BenchError
from trs80arm.export.gltf import glb, gltf
from trs80arm.export.mjcf import mjcf
from trs80arm.export.recording import Recording, record
from trs80arm.export.table import csv_table, npz_table
from trs80arm.export.urdf import urdf
from trs80arm.files import FileFormatError
from trs80arm.operator import ScriptError, parse_holds
from trs80arm.reasons import one_line
from trs80arm.rig import Rig, RigSettings
from trs80arm.saving import expect_to_write, write_whole
from trs80arm.unattended import NotReadyError, ready_with


class ExportError(Exception):
    """It cannot be exported so: one clear line."""


@dataclass(frozen=True)
class Export:
    """What is to be exported.

    Attributes:
        path: the file, whose suffix says the format.
        program: that is run, or whose bench it is.
        bench: a bench file instead of the program's.
        seconds: the most virtual time that is recorded, from when RUN is typed.
        fps: looks a virtual second.
        inputs, sets: what the operator answers, as for `trs80arm run`.
        rig: the machine's fittings, the arm among them.
    """

    path: Path
    program: Path | None = None
    bench: Path | None = None
    seconds: float = 60.0
    fps: float = 30.0
    inputs: tuple[str, ...] = ()
    sets: tuple[str, ...] = ()
    rig: RigSettings = field(default_factory=RigSettings)


def export(asked: Export) -> None:
    """Write the file.

    Raises:
        ExportError: it cannot be done; one line says why.
    """
    suffix = asked.path.suffix.lower()
    try:
        if suffix in STANDING:
            STANDING[suffix](asked)
        elif suffix in _RUNS:
            expect_to_write(asked.path)
            rig, run = _run(asked)
            write_whole(asked.path, _RUNS[suffix](rig, run))
        else:
            raise ExportError(f"{asked.path}: an export is a {', '.join(SUFFIXES)} file")
    except (NotReadyError, FileFormatError, BenchError, ScriptError, OSError) as error:
        raise ExportError(one_line(error)) from None


def _write_mjcf(asked: Export) -> None:
    write_whole(asked.path, mjcf(_rig(asked)).encode("utf-8"))


def _write_urdf(asked: Export) -> None:
    folder = asked.path.with_name(f"{asked.path.stem}-meshes")
    text, meshes = urdf(_rig(asked), folder.name)
    if meshes:
        folder.mkdir(exist_ok=True)
    for name, content in meshes.items():
        write_whole(folder / name, content)
    write_whole(asked.path, text.encode("utf-8"))


def _run(asked: Export) -> tuple[Rig, Recording]:
    """A program's run, and the machine after it."""
    if asked.program is None:
        raise ExportError(f"{asked.path}: a {asked.path.suffix} file is of a run: name a program")
    sets = [parse_holds(holds) for holds in asked.sets]
    rig = _rig(asked)
    return rig, record(rig, asked.fps, asked.seconds, asked.inputs, sets)


def _rig(asked: Export) -> Rig:
    """A machine with the arm on its bench, and the program in memory."""
    return ready_with(asked.rig, asked.program, asked.bench)


STANDING: dict[str, Callable[[Export], None]] = {
    ".xml": _write_mjcf,
    ".mjcf": _write_mjcf,
    ".urdf": _write_urdf,
}
"""Of the arm and its bench as they stand, by suffix."""
_RUNS: dict[str, Callable[[Rig, Recording], bytes]] = {
    ".gltf": gltf,
    ".glb": glb,
    ".csv": lambda _, run: csv_table(run),
    ".npz": lambda _, run: npz_table(run),
}
"""Of a program's run, by suffix."""
FILM = ".cast"
"""What is filmed in the terminal, which `trs80arm.ui.filming` does."""
SUFFIXES = (*STANDING, *_RUNS, FILM)
