"""Copies of what is unsaved, kept where a crash does not take them.

A sitting keeps one of the program in memory, one of the positions taught, and a folder of cassettes
and paper that no file holds. They go when their owner has saved the thing or given it up; programs
that a sitting that ended badly has left are offered again. As long as a sitting lasts it holds a
file of its own in the state folder, so that no other takes its copies for left ones.
"""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

from trs80arm.desk.asking import Say
from trs80arm.desk.session import Session
from trs80arm.desk.taught_programs import Manner, in_steps
from trs80arm.desk.teach import Lesson
from trs80arm.files import FileFormatError, Kind, save_program
from trs80arm.locks import hold, is_held, remove_unheld
from trs80arm.paths import is_file, is_folder
from trs80arm.reasons import reason
from trs80arm.saving import write_whole

_LOCK = ".sitting"
"""The ending of the file that a sitting holds."""
_TAUGHT = "-taught"
_NAME = re.compile(r"recovered-(\d{4})(\d\d)(\d\d)-(\d\d)(\d\d)\d\d(.*)")


class Recovery:
    """The recovery copies of one sitting.

    Args:
        session: whose program is kept.
        lesson: the positions taught, kept as a program of them.
        folder: where copies are.
        name: what tells this sitting from others: a time and a number.
        say: tells its user when no copy can be kept.

    Attributes:
        program_copy: where the program is kept while it is unsaved.
        lesson_copy: where a program of the positions is kept while none is written.
        keepsakes_copy: the folder where cassettes and paper are kept while they are in no file.
    """

    def __init__(self, session: Session, lesson: Lesson, folder: Path, name: str, say: Say) -> None:
        self._session = session
        self._lesson = lesson
        self._folder = folder
        self._say = say
        self._told = False
        self._lock = folder / f"recovered-{name}{_LOCK}"
        self._held: BinaryIO | None = None
        self.program_copy = folder / f"recovered-{name}.bas"
        self.lesson_copy = folder / f"recovered-{name}{_TAUGHT}.bas"
        self.keepsakes_copy = folder / f"recovered-{name}-tapes"
        self._kept_tapes: dict[str, bytes] = {}

    def keep(self) -> bool:
        """Keep what is unsaved, and nothing else; say so once if that cannot be.

        Returns:
            Whether all is kept that is unsaved.
        """
        try:
            self._keep_program()
            self._keep_lesson()
            self._keep_keepsakes()
        except (OSError, FileFormatError) as error:
            if not self._told:
                self._told = True
                why = reason(error) if isinstance(error, OSError) else error
                self._say(f"No recovery copy in {self._folder}: {why}", error=True)
            return False
        self._told = False
        return True

    def tell_again(self) -> None:
        """Say it the next time, too, if no copy can be kept."""
        self._told = False

    def _keep_program(self) -> None:
        if self._session.unsaved:
            self._hold()
            save_program(self.program_copy, self._session.program, Kind.CRUNCHED)
        else:
            _remove(self.program_copy)

    def _keep_lesson(self) -> None:
        if self._lesson.unwritten:
            self._hold()
            text = in_steps(self._lesson.positions, Manner())
            write_whole(self.lesson_copy, text.encode("ascii"))
        else:
            _remove(self.lesson_copy)

    def _keep_keepsakes(self) -> None:
        keepsakes = self._session.keepsakes
        wanted = keepsakes.files if keepsakes.unsaved else {}
        if wanted == self._kept_tapes:
            return
        for name in self._kept_tapes.keys() - wanted.keys():
            _remove(self.keepsakes_copy / name)
        for name, content in wanted.items():
            if self._kept_tapes.get(name) != content:
                self._hold()
                self.keepsakes_copy.mkdir(parents=True, exist_ok=True)
                write_whole(self.keepsakes_copy / name, content)
        self._kept_tapes = wanted
        if not wanted:
            _remove_folder(self.keepsakes_copy)

    def _hold(self) -> None:
        """Make the state folder, and hold this sitting's file in it from now on."""
        self._folder.mkdir(parents=True, exist_ok=True)
        if self._held is None:
            self._held = self._lock.open("wb")
            hold(self._held)

    def let_go(self) -> None:
        """The sitting is over: what it leaves is for the next."""
        if self._held is not None:
            self._held.close()
            self._held = None
            if not any(self.kept()):
                _remove(self._lock)

    def drop(self) -> None:
        """Remove all copies: their owner gave them up."""
        _remove(self.program_copy)
        _remove(self.lesson_copy)
        for name in self._kept_tapes:
            _remove(self.keepsakes_copy / name)
        _remove_folder(self.keepsakes_copy)
        self._kept_tapes = {}
        self.let_go()

    def kept(self) -> Iterator[tuple[str, Path]]:
        """What is kept now: what it is, in words, and where."""
        for what, path in (
            ("the program in memory is kept", self.program_copy),
            ("the positions taught are kept as a program", self.lesson_copy),
            ("cassettes and paper are kept", self.keepsakes_copy),
        ):
            if is_file(path) or is_folder(path):
                yield what, path

    def left_over(self) -> list[Path]:
        """Copies that sittings that ended badly have left, newest first."""
        try:
            names = os.listdir(self._folder)
        except OSError:
            return []
        there = [self._folder / name for name in names if name.startswith("recovered-")]
        in_use = {path.stem for path in there if path.suffix == _LOCK and is_held(path)}
        in_use.add(self.program_copy.stem)
        copies = [
            path
            for path in there
            if path.suffix == ".bas" and path.stem.removesuffix(_TAUGHT) not in in_use
        ]
        return sorted(copies, key=lambda path: path.name, reverse=True)

    def discard(self, path: Path) -> None:
        """Remove a copy that was left, for its owner does not want it."""
        if path in self.left_over():
            self._remove_left(path)

    def take_over(self, path: Path) -> None:
        """The program of an older copy is in memory now: remove it once an own copy is kept."""
        if self.keep() and is_file(self.program_copy):
            self._remove_left(path)

    def _remove_left(self, path: Path) -> None:
        """Remove a copy that was left, and the file that its sitting held."""
        _remove(path)
        remove_unheld(path.with_name(path.stem.removesuffix(_TAUGHT) + _LOCK))


def copy_label(path: Path) -> str:
    """What a copy is, by its name: when it was kept, and whether it is of a lesson."""
    match = _NAME.match(path.stem)
    if match is None:
        return path.name
    year, month, day, hour, minute, rest = match.groups()
    what = "recovered positions" if rest.endswith(_TAUGHT) else "recovered program"
    return f"{year}-{month}-{day} {hour}:{minute}  {what}"


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):
        path.unlink()


def _remove_folder(path: Path) -> None:
    with contextlib.suppress(OSError):
        path.rmdir()
