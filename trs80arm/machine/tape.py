"""The cassette recorder.

The language records and plays bytes; which cassette is in the recorder is the operator's affair. A
program can reach no other file: it never names one.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from trs80arm.machine import cassette, tape_files
from trs80arm.machine.shelves import (
    SUFFIX,
    FolderShelf,
    MemoryShelf,
    PastShelf,
    Shelf,
    file_name,
    is_cassette_name,
)
from trs80arm.machine.tape_files import LONGEST
from trs80arm.reasons import reason

__all__ = [
    "DATA_CASSETTE",
    "LONGEST",
    "SUFFIX",
    "BadCassetteName",
    "Tape",
    "file_content",
    "file_name",
    "is_cassette_name",
]

DATA_CASSETTE = "data"
"""Where PRINT#-1 records while no cassette was put in by hand."""


class BadCassetteName(ValueError):  # noqa: N818
    """No name for a cassette: one that could be another folder's, or no file's at all."""


class Tape:
    """A recorder.

    Put in a cassette by hand (`insert`), and everything is recorded behind what is on it and
    played from where it stands, as on the real thing. With none put in the recorder helps itself:
    CSAVE "A" makes the cassette `A` anew (the file it replaces is kept with a `~`), PRINT#-1
    records behind what is on the cassette `data`, and playing goes on through all cassettes of
    the shelf. In both cases:

    - what was just recorded is played back next, without rewinding by hand;
    - at the end of the tape, playing begins again at its start.

    Attributes:
        running: whether the motor is on.
        position: where the tape stands, in bytes from its start.
        fault: why a cassette could not be read or written, in one line; None when all is well. It
            is no error of the machine's, which never notices a bad recorder; what could not be
            written is kept in the recorder and can be played.
        replaced: the cassettes of the folder that were recorded on, in order, with what was on
            them before; not part of a snapshot.
    """

    def __init__(self, folder: Path | None = None) -> None:
        """A recorder without a cassette put in by hand.

        Args:
            folder: where the cassettes are; None keeps them in memory.
        """
        self._shelf: Shelf = MemoryShelf() if folder is None else FolderShelf(folder)
        self._by_hand = False
        self._name: str | None = None
        self._content = b""
        self._recording: bytearray | None = None
        self._recorded_from: int | None = None
        self._unheard: list[str] = []
        self._unsaved: dict[str, bytes] = {}
        self.running = False
        self.position = 0
        self.fault: str | None = None
        self.replaced: list[tuple[str, bytes]] = []

    def use_past(self, folder: Path, contents: Mapping[str, bytes]) -> None:
        """Keep the cassettes as they were once in a folder, and no file from now on."""
        self._shelf = PastShelf(folder, contents)

    def use_folder(self, folder: Path) -> None:
        """Keep the cassettes in a folder from now on; the one in the recorder stays in."""
        self._shelf = FolderShelf(folder)

    def __getstate__(self) -> dict[str, Any]:
        # A folder is of the computer and not of the machine.
        kept = self._shelf if isinstance(self._shelf, MemoryShelf) else MemoryShelf()
        return self.__dict__ | {"_shelf": kept, "replaced": []}

    # -- the operator ---------------------------------------------------------------------------

    @property
    def cassettes(self) -> list[str]:
        """The names of the cassettes on the shelf."""
        return self._shelf.names()

    @property
    def cassette(self) -> str | None:
        """The name of the cassette that is in the recorder, by hand or by itself."""
        return self._name

    @property
    def by_hand(self) -> bool:
        """Whether the cassette was put in by hand, and so stays in."""
        return self._by_hand

    @property
    def length(self) -> int:
        """How much is on the cassette, in bytes."""
        return len(self._content)

    @property
    def content(self) -> bytes:
        """What is on the cassette that is in the recorder."""
        return self._content

    @property
    def recorded(self) -> int | None:
        """How many bytes of a recording under way are on the tape; None while none is."""
        return None if self._recording is None else len(self._recording)

    @property
    def passes(self) -> bool:
        """Whether tape with something on it goes past the head; not at its silent end."""
        more = self._recording is not None or self.position < self.length or bool(self._unheard)
        return self.running and more

    def sound_length(self, name: str) -> float | None:
        """How long the sound is that a cassette is in, in seconds; None if it is none.

        Raises:
            OSError: its file cannot be read.
        """
        return None if name in self._unsaved else self._shelf.sound_length(name)

    def look_at(self, name: str) -> bytes:
        """What is on a cassette of the shelf; OSError if it cannot be read."""
        return self._unsaved[name] if name in self._unsaved else self._shelf.load(name)

    @property
    def in_memory(self) -> dict[str, bytes]:
        """The cassettes that no file holds: all, without a folder, or what failed to be written."""
        return {**self._shelf.in_memory, **self._unsaved}

    @property
    def files(self) -> dict[str, bytes]:
        """The same by the names that their files would have."""
        return {file_name(name): content for name, content in self.in_memory.items()}

    def insert(self, name: str, content: bytes | None = None) -> None:
        """Put in a cassette, rewound; it is a new one if there is none of that name.

        A machine that is reading goes on with it; a recording under way ends on the old one.

        Args:
            name: of the cassette.
            content: what is on it; None takes it from the shelf.

        Raises:
            BadCassetteName: the name cannot be one.
        """
        name = name.removesuffix(SUFFIX).removesuffix(SUFFIX.upper())
        if not is_cassette_name(name):
            raise BadCassetteName(
                f"{name!r} is no name for a cassette: it must be a plain file name"
            )
        self._change()
        self._by_hand = True
        self._put_in(name)
        if content is not None and content != self._content:
            self._unsaved[name] = self._content = content

    def eject(self) -> None:
        """Take the cassette out; the recorder helps itself from the next tape statement on."""
        self._change()
        self._by_hand = False
        self._name = None
        self._content = b""
        self.rewind()

    def _change(self) -> None:
        """The hand is at the cassette: what was recorded is on the old one."""
        if self._recording is not None:
            self.stop()
        self._unheard = []

    def rewind(self) -> None:
        """Go to the start of the tape; a recording under way ends before."""
        if self._recording is not None:
            self.stop()
        self.position = 0
        self._recorded_from = None

    # -- the machine ----------------------------------------------------------------------------

    def start_writing(self) -> None:
        """Switch the motor on to record at the end of what is there."""
        self.stop()
        self.running = True
        self._recording = bytearray()

    def write(self, value: int) -> None:
        """Record one byte; nothing if the motor is off."""
        if self._recording is not None:
            self._recording.append(value & 0xFF)

    def start_reading(self) -> None:
        """Switch the motor on to play from where the tape stands."""
        self.stop()
        self.running = True
        if self._name is not None:
            self._reload()
        if self._recorded_from is not None:
            self.position = self._recorded_from
            self._recorded_from = None
        if self._by_hand:
            self._unheard = []
            if self.position >= self.length:
                self.rewind()
            return
        names = self.cassettes
        if self._name is None:
            self._unheard = names
        else:
            # The others in order from here on, and this one again from its start.
            later = [name for name in names if name > self._name]
            earlier = [name for name in names if name < self._name]
            self._unheard = [*later, *earlier, self._name]

    def find_sync(self) -> bool:
        """Play up to and including the next sync byte A5H; False at the end of the tape."""
        while self.running and self._recording is None:
            found = self._content.find(cassette.SYNC, self.position)
            if found >= 0:
                self.position = found + 1
                return True
            self.position = self.length
            if not self._unheard:
                break
            self._put_in(self._unheard.pop(0))
        return False

    def read(self) -> int | None:
        """Play one byte; None when the tape has run out."""
        if not self.running or self._recording is not None or self.position >= self.length:
            return None
        value = self._content[self.position]
        self.position += 1
        return value

    def next_byte(self) -> int | None:
        """Play one byte, of the next cassette where one has run out; None at the end of all."""
        value = self.read()
        while value is None and self.running and self._recording is None and self._unheard:
            self._put_in(self._unheard.pop(0))
            value = self.read()
        return value

    def stop(self) -> None:
        """Switch the motor off; a recording is now on the tape."""
        self.running = False
        recorded, self._recording = self._recording, None
        if recorded:
            self._keep(bytes(recorded))

    def _keep(self, recorded: bytes) -> None:
        name = self._name
        if not self._by_hand or name is None:
            code = cassette.program_name(recorded)
            name = DATA_CASSETTE if code is None else _program_cassette(code)
            if name != self._name:
                self._put_in(name)
            else:
                self._reload()
            before = self._content
            if code is not None:
                try:
                    self._shelf.set_aside(name)
                except OSError as error:
                    self._report(error)
                self._content = b""
                self._recorded_from = None
        else:
            self._reload()
            before = self._content
        if self._recorded_from is None:
            self._recorded_from = len(self._content)
        if not isinstance(self._shelf, MemoryShelf):
            self.replaced.append((name, before))
        self._content += recorded
        self.position = self.length
        try:
            self._shelf.store(name, self._content)
        except OSError as error:
            self._unsaved[name] = self._content
            self._report(error)
        else:
            self._unsaved.pop(name, None)
            self.fault = None

    def _put_in(self, name: str) -> None:
        self._name = name
        self._content = b""
        self._reload()
        self.rewind()

    def _reload(self) -> None:
        """Look at the cassette itself; what cannot be read stays as it was heard last."""
        if self._name is None:
            return
        if self._name in self._unsaved:
            self._content = self._unsaved[self._name]
            return
        try:
            self._content = self._shelf.load(self._name)
        except OSError as error:
            self._report(error)
        else:
            self.fault = self._shelf.remark(self._name) or self.fault
        self.position = min(self.position, self.length)

    def _report(self, error: OSError) -> None:
        where = f"{error.filename}: " if error.filename else ""
        self.fault = f"{where}{reason(error)}"


def file_content(name: str, content: bytes) -> bytes:
    """What a cassette's file holds, by the file's name: `.wav` holds the sound of it."""
    return tape_files.write(content, Path(name).suffix)


def _program_cassette(code: int) -> str:
    """The cassette of a program by the code of its name; signs that no file should have as hex."""
    letter = chr(code).upper()
    return letter if re.fullmatch(r"[A-Z0-9]", letter) else f"program-{code:02X}"
