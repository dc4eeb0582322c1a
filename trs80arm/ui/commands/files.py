"""The commands that read and write files: open, save, paste, copies, recordings, leaving."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from trs80arm.arm.bench import BenchError
from trs80arm.benches import bench_beside
from trs80arm.bundled import programs_folder
from trs80arm.desk import recording
from trs80arm.desk.places import program_files, recovered_copies
from trs80arm.desk.taught_programs import Manner, in_steps
from trs80arm.files import FileFormatError, Kind
from trs80arm.saving import write_whole
from trs80arm.ui.commands.view import ViewCommands
from trs80arm.ui.screens.dialog import Ask, AskPath, Choice
from trs80arm.ui.screens.open import OpenScreen, Shelf
from trs80arm.ui.screens.paste import Listing, PasteScreen

PLAYING = "Playing; any key ends it and gives you the machine."
COPY_EVERY = 5.0
"""Seconds of the wall between two looks at whether a recovery copy is due."""


class AskToLeave(Ask):
    """The question before leaving; asked to leave again, the program leaves."""


class FileCommands(ViewCommands):
    """Open, save, paste, copy, record, replay, leave."""

    _told_of_no_copy = False

    def on_ready(self) -> None:
        """Keep a recovery copy from time to time, and tell of one that is left over."""
        if self._ticking:
            self.set_interval(COPY_EVERY, self.keep_copy)
        if recovered_copies(self.copy_path.parent, self.copy_path):
            self.say("A program of a session that ended badly is kept: see F2.")

    # -- open -------------------------------------------------------------------------------------

    def action_open(self) -> None:
        """Choose a program and load it."""
        along = programs_folder()
        shelves = [
            Shelf("Recovered", recovered_copies(self.copy_path.parent, self.copy_path)),
            Shelf("Recent", self.recent.all()),
            Shelf("Coming along", program_files(along) if along else ()),
        ]
        self.push_screen(OpenScreen(shelves, Path.cwd()), self._chosen)

    def _chosen(self, path: Path | None) -> None:
        if path is not None:
            self.if_program_may_go("Open", lambda: self.load_file(path))

    def load_file(self, path: Path) -> None:
        """Load a program, and the bench that stands beside it; or say why not."""
        if path in recovered_copies(self.copy_path.parent, self.copy_path):
            self._load_recovered(path)
            return
        try:
            self.session.load(path)
        except FileFormatError as error:
            self.say(str(error), error=True)
            return
        except OSError as error:
            self.say(f"{path}: {error.strerror or error}", error=True)
            return
        self.pacer.forgive()
        if (bench := bench_beside(path)) and bench != self.session.bench_path:
            try:
                self.session.set_bench(bench)
            except BenchError as error:
                self.say(str(error), error=True)
                return
        self.loaded(path)

    def loaded(self, path: Path) -> None:
        """Remember that a program was loaded, and say so."""
        self.recent.add(path)
        with_bench = " and its bench are" if bench_beside(path) else " is"
        self.say(f"{path.name}{with_bench} loaded: F5 or RUN runs it.")

    def _load_recovered(self, path: Path) -> None:
        """Load a copy that a bad end has left; it goes when this run has a copy of its own."""
        try:
            self.session.load_bytes(path.read_bytes())
        except (FileFormatError, OSError) as error:
            self.say(f"{path.name}: {error}", error=True)
            return
        self.keep_copy()
        if self.copy_path.is_file():
            self.session.drop_copy(path)
        self.say("The recovered program is loaded: F3 saves it.")

    def load_listing(self, text: str) -> None:
        """Load a listing that no file holds yet, or say why not."""
        try:
            self.session.load_bytes(text.encode("latin-1", errors="replace"))
        except FileFormatError as error:
            self.say(f"No program: {error}", error=True)
        else:
            self.say("The listing is loaded: F5 or RUN runs it.")

    # -- save -------------------------------------------------------------------------------------

    def action_save(self) -> None:
        """Save the program under a name."""
        self._ask_where_to_save(lambda: None)

    def _ask_where_to_save(self, afterwards: Callable[[], object]) -> None:
        if not self.session.program:
            self.say("There is no program in memory.")
            return
        hint = "Text as LIST shows it, .cas for a cassette; a crunched .bas stays crunched."
        proposal = self.session.path or "program.bas"

        def save(path: Path | None) -> None:
            if path is not None and self._save(path):
                afterwards()

        own = self.session.path
        self.push_screen(AskPath("Save the program", hint, proposal, to_write=True, own=own), save)

    def _save(self, path: Path) -> bool:
        try:
            new_text = path.suffix.lower() == ".bas" and not path.exists()
            self.session.save(path, Kind.TEXT if new_text else None)
        except FileFormatError as error:
            self.say(f"{path.name}: {error}", error=True)
        except OSError as error:
            self.say(f"{path}: {error.strerror or error}", error=True)
        else:
            self.recent.add(path)
            self.keep_copy()
            self.say(f"Saved as {path.name}.")
            return True
        return False

    def if_program_may_go(self, title: str, do: Callable[[], object]) -> None:
        """Do something that clears the program, asking first if it is unsaved."""
        if not self.session.unsaved:
            do()
            return

        def answered(answer: str | None) -> None:
            if answer == "save":
                self._ask_where_to_save(do)
            elif answer == "go":
                do()

        self.push_screen(
            Ask(
                title,
                "The program in memory is not saved.",
                [
                    Choice("save", "Save"),
                    Choice("go", "Do not save"),
                    Choice("stay", "Back"),
                ],
            ),
            answered,
        )

    # -- paste and copy ---------------------------------------------------------------------------

    def action_paste_listing(self) -> None:
        """Take a listing from the clipboard."""
        self.push_screen(PasteScreen(), self._pasted)

    def _pasted(self, listing: Listing | None) -> None:
        if listing is None:
            return
        if listing.at_once:
            self.if_program_may_go("Load at once", lambda: self.load_listing(listing.text))
        else:
            self.type_in(listing.text if listing.text.endswith("\n") else listing.text + "\n")

    def action_copy_screen(self) -> None:
        """Copy the tube's text."""
        self.copy_to_clipboard(self.tube.text)
        self.say("The tube's text is copied (some terminals do not allow it).")

    def action_save_screen(self, kind: str) -> None:
        """Save the tube as text, or the window as a picture."""
        content = self.export_screenshot() if kind == "svg" else self.tube.text + "\n"

        def save(path: Path | None) -> None:
            if path is not None:
                self._write(path, content.encode("utf-8"))

        hint = "The whole window as SVG." if kind == "svg" else "The tube's sixteen lines."
        self.push_screen(AskPath("Save the screen", hint, f"screen.{kind}", to_write=True), save)

    def _write(self, path: Path, content: bytes) -> None:
        try:
            write_whole(path, content)
        except OSError as error:
            self.say(f"{path}: {error.strerror or error}", error=True)
        else:
            self.say(f"Saved as {path.name}.")

    # -- recordings -------------------------------------------------------------------------------

    def action_save_recording(self) -> None:
        """Save what was done since power-on."""

        def save(path: Path | None) -> None:
            if path is None:
                return
            try:
                self.session.save_recording(path)
            except OSError as error:
                self.say(f"{path}: {error.strerror or error}", error=True)
            else:
                self.say(f"Saved as {path.name}.")

        hint = "Everything done since the machine was switched on, to be played again."
        self.push_screen(AskPath("Save a recording", hint, "session.jsonl", to_write=True), save)

    def action_replay(self) -> None:
        """Play a recorded session."""

        def play(path: Path | None) -> None:
            if path is not None:
                self.if_program_may_go("Play a recording", lambda: self.play_file(path))

        hint = "The machine on the desk is put away for the recorded one."
        self.push_screen(AskPath("Play a recording", hint, "session.jsonl", to_write=False), play)

    def play_file(self, path: Path) -> None:
        """Play a recording, or say why not."""
        try:
            played = recording.load(path)
        except recording.RecordingError as error:
            self.say(str(error), error=True)
        except OSError as error:
            self.say(f"{path}: {error.strerror or error}", error=True)
        else:
            self.session.play(played)
            self.another_machine()
            self.say(PLAYING)

    # -- leaving ----------------------------------------------------------------------------------

    def keep_copy(self) -> bool:
        """Keep a copy of what is unsaved for the case of a crash; say so once if that cannot be.

        Returns:
            Whether all is kept that is unsaved.
        """
        try:
            self.session.keep_copy(self.copy_path)
            self._keep_lesson()
        except (OSError, FileFormatError) as error:
            if not self._told_of_no_copy and self.is_running:
                self._told_of_no_copy = True
                why = getattr(error, "strerror", None) or error
                self.say(f"No recovery copy in {self.copy_path.parent}: {why}", error=True)
            return False
        self._told_of_no_copy = False
        return True

    @property
    def lesson_copy_path(self) -> Path:
        """Where a program of the positions taught is kept while none is written."""
        return self.copy_path.with_name(f"{self.copy_path.stem}-taught.bas")

    def _keep_lesson(self) -> None:
        path = self.lesson_copy_path
        if self.lesson.unwritten:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_whole(path, in_steps(self.lesson.positions, Manner()).encode("ascii"))
        else:
            path.unlink(missing_ok=True)

    def action_leave(self) -> None:
        """Leave; ask if something is unsaved, but when asked while asking, leave at once."""
        if isinstance(self.screen, AskToLeave):
            self._told_of_no_copy = False
            if self.keep_copy():
                self.session.close()
                self.exit(0)
            return
        if self.session.unsaved:
            loss, rescue = "The program in memory is not saved.", Choice("save", "Save")
        elif self.lesson.unwritten:
            loss = "Positions were taught, and no program of them is written."
            rescue = Choice("teach", "Look at them")
        else:
            self._leave()
            return
        question = AskToLeave(
            "Leave",
            f"{loss} Ctrl+C again leaves and keeps a recovery copy.",
            [rescue, Choice("go", "Leave without saving"), Choice("stay", "Back")],
        )

        def answered(answer: str | None) -> None:
            if answer == "save":
                self._ask_where_to_save(self.action_leave)
            elif answer == "teach":
                self.call_next(self.run_action, "teach")
            elif answer == "go":
                self._leave()

        self.push_screen(question, answered)

    def _leave(self) -> None:
        self.session.drop_copy(self.copy_path)
        self.session.drop_copy(self.lesson_copy_path)
        self.session.close()
        self.exit(0)
