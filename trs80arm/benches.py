"""Benches as files beside programs: which one belongs to a program, its text and what it sets up.

A run without a screen and a sitting at the machine read their benches here.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from trs80arm.arm import benchfile
from trs80arm.arm.bench import Bench
from trs80arm.paths import beside, is_file
from trs80arm.script import SUFFIX


def bench_beside(program: Path) -> Path | None:
    """The bench file that is named like a program and stands beside it, if there is one."""
    return beside(program, ".toml")


def bench_for(program: Path | None, named: Path | None) -> Path | None:
    """The bench file that is named, or else the one beside the program, if there is one."""
    if named is not None or program is None:
        return named
    return bench_beside(program)


def bench_files(folder: Path) -> list[Path]:
    """The bench files of a folder and of the folder `benches` in it."""
    try:
        found = [*folder.glob("*.toml"), *folder.glob("benches/*.toml")]
    except (OSError, ValueError):
        return []
    return [
        path
        for path in found
        if path.name != "pyproject.toml" and not path.name.endswith(SUFFIX) and is_file(path)
    ]


@dataclass(frozen=True)
class BenchFile:
    """A bench with the text that it came from, for a recording keeps the text.

    Attributes:
        path: the file.
        text: what it said.
        bench: what that sets up.
    """

    path: Path
    text: str
    bench: Bench

    @classmethod
    def read(cls, path: Path) -> BenchFile:
        """Read a bench file.

        Raises:
            BenchError: it cannot be read or is no bench; one line that begins with its path.
        """
        text = benchfile.read(path)
        return cls(path, text, benchfile.parse(text, str(path)))
