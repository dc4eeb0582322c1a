"""What `trs80arm export` does: a rig as it stands, as a file for another program."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from trs80arm.arm.bench import BenchError
from trs80arm.benches import BenchFile, bench_beside
from trs80arm.export.mjcf import mjcf
from trs80arm.export.urdf import urdf
from trs80arm.files import FileFormatError, load_program
from trs80arm.reasons import one_line
from trs80arm.rig import Rig, RigSettings
from trs80arm.saving import write_whole


class ExportError(Exception):
    """It cannot be exported so: one clear line."""


@dataclass(frozen=True)
class Export:
    """What is to be exported.

    Attributes:
        path: the file, whose suffix says the format.
        program: whose bench it is, unless another is given.
        bench: a bench file.
        rig: the machine's fittings, the arm among them.
    """

    path: Path
    program: Path | None = None
    bench: Path | None = None
    rig: RigSettings = field(default_factory=RigSettings)


def export(asked: Export) -> None:
    """Write the file.

    Raises:
        ExportError: it cannot be done; one line says why.
    """
    write = WRITERS.get(asked.path.suffix.lower())
    if write is None:
        raise ExportError(f"{asked.path}: an export is a {', '.join(WRITERS)} file")
    try:
        write(asked)
    except (FileFormatError, BenchError, OSError) as error:
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


def _rig(asked: Export) -> Rig:
    """A machine with the arm on its bench, and the program in memory."""
    lines = load_program(asked.program) if asked.program else []
    bench = asked.bench or (bench_beside(asked.program) if asked.program else None)
    rig = Rig(asked.rig, BenchFile.read(bench).bench if bench else None)
    rig.load_lines(lines)
    return rig


WRITERS: dict[str, Callable[[Export], None]] = {
    ".xml": _write_mjcf,
    ".mjcf": _write_mjcf,
    ".urdf": _write_urdf,
}
"""By suffix."""
