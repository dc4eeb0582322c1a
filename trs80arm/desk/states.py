"""Saved states: the whole machine under a name, with what was done to bring it there.

A state is a file in a folder of the user's own. It holds a line that says what it is, the lines of
a recording up to that moment, and a snapshot; all three are looked at before anything is used. So
a session that went on from a state can still be saved as a recording.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from trs80arm.desk import recording
from trs80arm.desk.session import Session
from trs80arm.inspection import next_spot
from trs80arm.paths import is_file, read_beginning
from trs80arm.plain_values import SettingsError, Table
from trs80arm.reasons import reason
from trs80arm.rig import SnapshotError
from trs80arm.saving import write_whole
from trs80arm.shown import shown

FORMAT = "trs80arm state 1"
SUFFIX = ".state"
QUICK = "quick"
"""The name of the state that the quick keys save and load."""
BEFORE = "before load"
"""The name under which a machine is saved whose place another one takes."""
LARGEST = 160 << 20
"""Bytes of a state that is read: a recording and a snapshot, each as large as they can be."""
_HEAD = 1000
"""Bytes of the line that says what a state is, at most."""
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9 _.-]{0,39}")
_RESERVED = re.compile(r"(?i)(con|prn|aux|nul|com\d|lpt\d)(\..*)?")


class StateError(ValueError):
    """A state that cannot be saved or loaded; one clear line."""


@dataclass(frozen=True)
class State:
    """A saved state, as a list shows it.

    Attributes:
        name: what its user called it.
        saved: when, in seconds since 1970.
        line: where the program was, as `120: GOSUB 300`; empty if none ran.
    """

    name: str
    saved: float
    line: str


class States:
    """The saved states of a user.

    Args:
        folder: where they are; it is made when there is none.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def save(self, name: str, session: Session) -> State:
        """Save the machine as it stands, in the place of an older state of that name.

        Raises:
            StateError: the name cannot be one, or the file cannot be written.
        """
        path = self._path(name)
        spot = next_spot(session.rig)
        journal = "\n".join(session.recorded).encode("utf-8")
        snapshot = session.rig.snapshot()
        line = "" if spot is None else shown(str(spot))[:60]
        head = {"format": FORMAT, "line": line, "recording": len(journal)}
        try:
            self._folder.mkdir(parents=True, exist_ok=True)
            write_whole(path, json.dumps(head).encode("ascii") + b"\n" + journal + snapshot)
            return State(path.stem, path.stat().st_mtime, line)
        except OSError as error:
            raise StateError(f"{path}: {reason(error)}") from None

    def load(self, name: str, session: Session) -> None:
        """Put the machine of a state on the desk, fittings and bench and all.

        The one that stands there is saved as `BEFORE`, so that nothing is lost.

        Raises:
            StateError: there is none of that name, or it is damaged; the machine stays as it is.
        """
        path = self._path(name)
        if not is_file(path):
            raise StateError(f"there is no state {name.strip()!r}")
        try:
            data = read_beginning(path, LARGEST)
        except OSError as error:
            raise StateError(f"{path}: {reason(error)}") from None
        first, _, rest = data.partition(b"\n")
        try:
            _, length = _head(first)
            if length > len(rest):
                raise StateError("it is cut short")
            journal = rest[:length]
            recording.parse(journal, "its recording")
            lines = journal.decode("utf-8").splitlines()
            if path.stem != BEFORE:
                self.save(BEFORE, session)
            session.take_up(rest[length:], lines)
        except (StateError, SnapshotError, recording.RecordingError) as error:
            raise StateError(f"{path.name}: {error}") from None

    def delete(self, name: str) -> None:
        """Remove a state for ever.

        Raises:
            StateError: there is none of that name, or it cannot be removed.
        """
        path = self._path(name)
        try:
            path.unlink()
        except FileNotFoundError:
            raise StateError(f"there is no state {name.strip()!r}") from None
        except OSError as error:
            raise StateError(f"{path}: {reason(error)}") from None

    def all(self) -> Sequence[State]:
        """The states that there are, the newest first; what is none is left out."""
        found = []
        try:
            paths = [path for path in self._folder.iterdir() if path.suffix == SUFFIX]
        except OSError:
            return []
        for path in paths:
            try:
                line, _ = _head(read_beginning(path, _HEAD).partition(b"\n")[0])
                if _NAME.fullmatch(path.stem):
                    found.append(State(path.stem, path.stat().st_mtime, line))
            except (OSError, StateError):
                continue
        return sorted(found, key=lambda state: (-state.saved, state.name))

    def _path(self, name: str) -> Path:
        name = name.strip()
        if not _NAME.fullmatch(name) or name.endswith((" ", ".")) or _RESERVED.fullmatch(name):
            raise StateError("a name has letters, digits, blanks, -, _ and points, 40 at most")
        return self._folder / (name + SUFFIX)


def _head(line: bytes) -> tuple[str, int]:
    """What stands in the first line: where the program was, and how long the recording is."""
    try:
        head = Table("state", "", json.loads(line))
        if head.data.pop("format", None) != FORMAT:
            raise StateError("no saved state of this version")
        where = head.take("line", str)
        length = head.integer("recording", 0, LARGEST)
        head.done("format, line, recording")
    except (SettingsError, RecursionError, TypeError, ValueError) as error:
        if isinstance(error, StateError):
            raise
        raise StateError("no saved state of this version") from None
    return shown(where)[:60], length
