"""The files of a sitting: programs, listings and recordings, opened and saved, and never lost.

Whatever clears the program in memory comes through `if_program_may_go`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from trs80arm.arm.bench import BenchError
from trs80arm.benches import bench_beside
from trs80arm.bundled import comes_along, programs_folder
from trs80arm.desk import recording
from trs80arm.desk.asking import (
    Asking,
    Choice,
    FileQuestion,
    Listing,
    ProgramQuestion,
    Question,
    Say,
    Shelf,
)
from trs80arm.desk.places import RecentFiles, program_files
from trs80arm.desk.reach import ALL_FILES, Reach
from trs80arm.desk.recovery import Recovery, copy_label
from trs80arm.desk.session import Session
from trs80arm.files import LARGEST, FileFormatError, Kind
from trs80arm.machine.tape import SUFFIX
from trs80arm.paths import read_beginning
from trs80arm.reasons import reason
from trs80arm.rig import Waiting
from trs80arm.saving import write_whole

_IN_LISTING = re.compile(r"\s*(\d|$)")
"""A line of a listing, or between two of them."""
RECOVERED_SHOWN = 3
"""Recovered copies that are shown before the other programs."""
_PLAY = "Play a recording"
PLAYING = "Playing; any key ends it and gives you the machine."


class SessionFiles:
    """Opens and saves what belongs to a sitting, asking and telling its user.

    Args:
        session: the machine and its program.
        recovery: the copies of what is unsaved.
        recent: the programs opened lately.
        ask: a way to ask.
        say: a way to say something.
        reach: which files its user can name.
        runs: what runs a program, as its user is told.

    Attributes:
        reach: which files its user can name.
    """

    def __init__(
        self,
        session: Session,
        recovery: Recovery,
        recent: RecentFiles,
        ask: Asking,
        say: Say,
        reach: Reach = ALL_FILES,
        runs: str = "F5 or RUN",
    ) -> None:
        self._session = session
        self._recovery = recovery
        self._recent = recent
        self._ask = ask
        self._say = say
        self.reach = reach
        self._runs = runs

    # -- open -------------------------------------------------------------------------------------

    def open(self) -> None:
        """Let a program be chosen, and load it."""
        along = programs_folder()
        shelves = (self._recovered(), Shelf("Recent", self._recent.all()))
        coming = program_files(along) if along else ()
        below = (
            Shelf("Coming along", [path for path in coming if path.suffix != SUFFIX]),
            Shelf("Machine code, on cassettes", [path for path in coming if path.suffix == SUFFIX]),
        )

        def chosen(path: Path) -> None:
            self.if_program_may_go("Open", lambda: self.load_file(path))

        self._ask.ask_program(ProgramQuestion(shelves, self.reach.home, below), chosen)

    def _recovered(self) -> Shelf:
        """What sittings that ended badly have left: the newest few, unless they are asked for."""
        left = self._recovery.left_over()
        title = "Recovered"
        if len(left) > RECOVERED_SHOWN:
            title = f"Recovered, the newest of {len(left)}"
        labels = [copy_label(path) for path in left]
        return Shelf(title, left, labels, RECOVERED_SHOWN, self._recovery.discard)

    def discard_recovered(self) -> None:
        """Remove all that was left by sittings that ended badly, if its owner says so."""
        left = self._recovery.left_over()
        if not left:
            self._say("There are no recovered programs.")
            return

        def answered(answer: str) -> None:
            if answer == "go":
                for path in left:
                    self._recovery.discard(path)
                self._say("The recovered programs are gone.")

        oldest = copy_label(left[-1]).partition("  ")[0]
        text = f"{len(left)} recovered programs, the oldest of {oldest}, are removed for ever."
        answers = (Choice("stay", "Back"), Choice("go", "Remove them"))
        self._ask.ask(Question("Recovered programs", text, answers), answered)

    def load_file(self, path: Path) -> None:
        """Load a program and the bench beside it, or put machine code in; or say why not."""
        if path in self._recovery.left_over():
            self._load_recovered(path)
            return
        try:
            self._session.load(path)
        except FileFormatError as error:
            self._say(str(error), error=True)
            return
        except OSError as error:
            self._say(f"{path}: {reason(error)}", error=True)
            return
        if self._session.system_name is not None:
            self._recent.add(path)
            self.tell_of_machine_code(self._session.system_name)
            return
        bench = bench_beside(path)
        if bench is None or bench == self._session.bench_path or self.set_up_bench(bench):
            self.loaded(path)

    def loaded(self, path: Path) -> None:
        """Remember that a program was loaded, and say so."""
        self._recent.add(path)
        with_bench = " and its bench are" if bench_beside(path) else " is"
        self._say(f"{path.name}{with_bench} loaded: {self._runs} runs it.")

    def tell_of_machine_code(self, name: str) -> None:
        """Say how the machine code is loaded whose cassette was put in."""
        cassette = self._session.rig.tape.cassette
        self._say(f"Cassette {cassette} is in: SYSTEM, then {name}, loads it, and / starts it.")

    def set_up_bench(self, path: Path | None) -> bool:
        """Clear the table and set up a bench, None for the standard one; or say why not.

        Returns:
            Whether it stands.
        """
        try:
            self._session.set_bench(path)
        except BenchError as error:
            self._say(str(error), error=True)
            return False
        return True

    def _load_recovered(self, path: Path) -> None:
        """Load a copy that a bad end has left; it goes when this sitting has a copy of its own."""
        try:
            self._session.load_bytes(read_beginning(path, LARGEST))
        except FileFormatError as error:
            self._say(f"{path.name}: {error}", error=True)
        except OSError as error:
            self._say(f"{path}: {reason(error)}", error=True)
        else:
            self._recovery.take_over(path)
            self._say("The recovered program is loaded: F3 saves it.")

    def load_listing(self, text: str) -> bool:
        """Load a listing that no file holds yet, or say why not.

        Returns:
            Whether it is loaded.
        """
        try:
            self._session.load_bytes(text.encode("latin-1", errors="replace"))
        except FileFormatError as error:
            self._say(f"No program: {error}", error=True)
            return False
        self._say(f"The listing is loaded: {self._runs} runs it.")
        return True

    # -- save -------------------------------------------------------------------------------------

    def save(self, afterwards: Callable[[], object] = lambda: None) -> None:
        """Ask for a name, save the program under it, and then do something."""
        if not self._session.program:
            self._say("There is no program in memory.")
            return
        path = self._session.path
        # What comes along stays as it is, unless somebody says otherwise.
        along = path is not None and comes_along(path)
        question = FileQuestion(
            "Save the program",
            "Text as LIST shows it, .cas for a cassette; a crunched .bas stays crunched.",
            "program.bas" if path is None else path.name if along else path,
            to_write=True,
            own=None if along else path,
        )

        def save(path: Path) -> None:
            if self.save_as(path):
                afterwards()

        self._ask.ask_file(question, save)

    def save_as(self, path: Path) -> bool:
        """Save the program, or say why not.

        Returns:
            Whether it is saved.
        """
        try:
            new_text = path.suffix.lower() == ".bas" and not path.exists()
            self._session.save(path, Kind.TEXT if new_text else None)
        except FileFormatError as error:
            self._say(f"{path.name}: {error}", error=True)
        except OSError as error:
            self._say(f"{path}: {reason(error)}", error=True)
        else:
            self._recent.add(path)
            self._recovery.keep()
            self._say(f"Saved as {path.name}.")
            return True
        return False

    def if_program_may_go(self, title: str, do: Callable[[], object]) -> None:
        """Do something that clears the program, asking first if it is unsaved."""
        if self._session.unsaved:
            self._ask_first(title, "The program in memory is not saved.", self.save, do)
        else:
            do()

    def _ask_first(
        self,
        title: str,
        text: str,
        save: Callable[[Callable[[], object]], object],
        do: Callable[[], object],
    ) -> None:
        """Ask about what is unsaved; then `do`, or first `save`, which does it afterwards."""

        def answered(answer: str) -> None:
            if answer == "save":
                save(do)
            elif answer == "go":
                do()

        answers = (Choice("save", "Save"), Choice("go", "Do not save"), Choice("stay", "Back"))
        self._ask.ask(Question(title, text, answers), answered)

    # -- cassettes and paper ----------------------------------------------------------------------

    def save_keepsakes(self, afterwards: Callable[[], object] = lambda: None) -> None:
        """Ask for a folder, save the cassettes and the paper that are in memory, do something."""
        keepsakes = self._session.keepsakes
        if not keepsakes.files:
            self._say("No cassette and no paper is in memory only.")
            return

        def save(folder: Path) -> None:
            try:
                written = keepsakes.save(folder)
            except OSError as error:
                self._say(f"{error.filename or folder}: {reason(error)}", error=True)
            else:
                self._recovery.keep()
                self._say(f"Saved in {folder}: {', '.join(path.name for path in written)}.")
                afterwards()

        hint = f"A folder for {keepsakes}; with --tapes and --printer they are files at once."
        self._ask.ask_file(
            FileQuestion("Save cassettes and paper", hint, "tapes", to_write=True, folder=True),
            save,
        )

    def _if_keepsakes_may_go(self, title: str, do: Callable[[], object]) -> None:
        """Do something that puts the machine away, asking first about its cassettes and paper."""
        keepsakes = self._session.keepsakes
        if keepsakes.unsaved:
            self._ask_first(title, f"Only in memory: {keepsakes}.", self.save_keepsakes, do)
        else:
            do()

    # -- listings ---------------------------------------------------------------------------------

    def paste(self) -> None:
        """Take a listing from the clipboard, to be loaded at once or typed."""

        def pasted(listing: Listing) -> None:
            text = listing.text
            if listing.at_once:
                self.if_program_may_go("Load at once", lambda: self.load_listing(text))
            else:
                self.type_in(text if text.endswith("\n") else text + "\n")

        self._ask.ask_listing(pasted)

    def take_paste(self, text: str) -> None:
        """Take what was pasted at the prompt: lines of a program at once, anything else is typed.

        A single line without its end is typed too, for its owner may want to change it.
        """
        lines = _lines(text)
        count = next((n for n, line in enumerate(lines) if not _IN_LISTING.match(line)), len(lines))
        at_prompt = self._session.waiting is Waiting.COMMAND and not self._session.typing
        if not at_prompt or not count or (len(lines) == 1 and not text.endswith(("\r", "\n"))):
            self.type_in(text)
            return
        try:
            entered = self._session.enter("\n".join(lines[:count]) + "\n")
        except FileFormatError:
            # The machine has its own words for what is wrong.
            self.type_in(text)
            return
        rest = "\n".join(lines[count:])
        if rest:
            self.type_in(rest + "\n")
        self._say(f"{entered} lines are entered at once; Ctrl+V can have them typed.")

    def type_in(self, text: str) -> None:
        """Type a text; BREAK ends it."""
        self._session.paste(text.replace("\r\n", "\r").replace("\n", "\r"))
        self._say(f"Typing {self._session.rig.to_type} characters; Escape stops it.")

    # -- recordings and other files ---------------------------------------------------------------

    def save_recording(self) -> None:
        """Ask for a name, and save what was done since power-on."""
        hint = "Everything done since the machine was switched on, to be played again."
        question = FileQuestion("Save a recording", hint, "session.jsonl", to_write=True)
        self._ask.ask_file(question, self.save_recording_as)

    def save_recording_as(self, path: Path) -> None:
        """Save what was done since power-on, or say why not."""
        self._write(path, lambda: self._session.save_recording(path))

    def play(self) -> None:
        """Ask for a recorded session, and play it."""
        hint = "The machine on the desk is put away for the recorded one."
        question = FileQuestion(_PLAY, hint, "session.jsonl", to_write=False)
        self._ask.ask_file(question, self.play_if_may_go)

    def play_if_may_go(self, path: Path) -> None:
        """Play a recording, asking first about what is unsaved on the machine that is put away."""
        self.if_program_may_go(
            _PLAY, lambda: self._if_keepsakes_may_go(_PLAY, lambda: self.play_file(path))
        )

    def play_file(self, path: Path) -> None:
        """Play a recording, or say why not."""
        try:
            played = recording.load(path)
        except recording.RecordingError as error:
            self._say(str(error), error=True)
        except OSError as error:
            self._say(f"{path}: {reason(error)}", error=True)
        else:
            self._session.play(played)
            self._say(PLAYING)

    def save_content(self, question: FileQuestion, content: bytes) -> None:
        """Ask for a name and write a file that is made already, a picture say."""

        def save(path: Path) -> None:
            self._write(path, lambda: write_whole(path, content))

        self._ask.ask_file(question, save)

    def _write(self, path: Path, write: Callable[[], None]) -> None:
        try:
            write()
        except OSError as error:
            self._say(f"{path}: {reason(error)}", error=True)
        else:
            self._say(f"Saved as {path.name}.")


def _lines(text: str) -> list[str]:
    """The lines of a text with any line ends, blank ones at its end left out."""
    return text.replace("\r\n", "\n").replace("\r", "\n").rstrip("\n").split("\n")
