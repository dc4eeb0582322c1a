"""What the machine has recorded and printed that no file holds: cassettes and paper in memory.

Without a folder for tapes and a file for the printer both are only in memory, and so is what a full
disk did not take. Whoever leaves is asked about them, as about the program.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from trs80arm.machine.tape import SUFFIX, file_content, file_name
from trs80arm.rig import Rig
from trs80arm.saving import write_whole

PAPER = "paper.txt"
"""The name of the file that the printer's paper is saved as."""


class Keepsakes:
    """Cassettes and paper of a machine, as far as they are in memory only.

    Args:
        rig: the machine as it stands on the desk now.
    """

    def __init__(self, rig: Callable[[], Rig]) -> None:
        self._rig = rig
        self._safe: Mapping[str, bytes] = {}

    @property
    def files(self) -> dict[str, bytes]:
        """What is in no file, by the name that its file would have."""
        rig = self._rig()
        found = {name: content for name, content in rig.tape.files.items() if content}
        if paper := rig.printer.in_memory:
            found[PAPER] = paper.encode("latin-1")
        return found

    @property
    def unsaved(self) -> bool:
        """Whether there is any that was neither saved nor given up as it is now."""
        return any(self._safe.get(name) != content for name, content in self.files.items())

    def __str__(self) -> str:
        """What there is, in words: `cassettes A and data, and the printer's paper`."""
        names = sorted(self.files)
        tapes = [name.removesuffix(SUFFIX) for name in names if name != PAPER]
        words = []
        if tapes:
            *most, last = tapes
            listed = f"{', '.join(most)} and {last}" if most else last
            words.append(f"{'cassettes' if most else 'cassette'} {listed}")
        if PAPER in names:
            words.append("the printer's paper")
        return (", and " if len(tapes) > 1 else " and ").join(words)

    def save(self, folder: Path) -> list[Path]:
        """Write them into a folder, which is made if there is none; no file is replaced.

        Returns:
            The files, in order.

        Raises:
            OSError: one cannot be written.
        """
        folder.mkdir(parents=True, exist_ok=True)
        files = self.files
        written = []
        for name, content in files.items():
            path = _unused(folder / name)
            write_whole(path, content if name == PAPER else file_content(name, content))
            written.append(path)
        self._safe = files
        return written

    def know(self, cassette: str) -> None:
        """What is on a cassette came from a file, and is safe there as it is now."""
        name = file_name(cassette)
        if name in (files := self.files):
            self._safe = {**self._safe, name: files[name]}

    def forget(self) -> None:
        """Another machine stands on the desk."""
        self._safe = {}


def _unused(path: Path) -> Path:
    """The path, or the first of `A-2.cas`, `A-3.cas` and so on that is no file yet."""
    number = 2
    while path.exists():
        stem = path.stem if number == 2 else path.stem.rpartition("-")[0]
        path = path.with_stem(f"{stem}-{number}")
        number += 1
    return path
