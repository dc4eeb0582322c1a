"""Recorder and printer under their operator's hands: cassettes put in, paper torn off."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from trs80arm.deck import Deck, cassettes_of, contents_text
from trs80arm.desk.asking import Asking, Choice, FileQuestion, ListQuestion, Question, Say
from trs80arm.desk.keepsakes import PAPER
from trs80arm.desk.session import Session
from trs80arm.machine.tape import BadCassetteName
from trs80arm.reasons import reason
from trs80arm.saving import write_whole

_CASSETTE = "cassette "
"""What the value of a choice begins with that stands for a cassette; its name follows."""


class Peripherals:
    """Works recorder and printer.

    Args:
        session: whose they are.
        ask: a way to ask.
        say: a way to say something.
    """

    def __init__(self, session: Session, ask: Asking, say: Say) -> None:
        self._session = session
        self._ask = ask
        self._say = say

    # -- the recorder -----------------------------------------------------------------------------

    def shelf(self) -> list[tuple[str, str]]:
        """The cassettes, by name, and what is on each."""
        found = []
        for name in cassettes_of(self._session.rig):
            try:
                found.append((name, self._holds(name)))
            except OSError as error:
                found.append((name, reason(error)))
        return found

    def _holds(self, name: str) -> str:
        """What is on a cassette; a sound is listened to only when it is put in."""
        tape = self._session.rig.tape
        if name == tape.cassette:
            return contents_text(tape.content)
        seconds = tape.sound_length(name)
        if seconds is not None:
            return f"sound of {round(seconds) // 60}:{round(seconds) % 60:02d}"
        return contents_text(tape.look_at(name))

    def tapes(self) -> None:
        """The shelf, and what can be done at the recorder; one of it is chosen."""
        tape = self._session.rig.tape
        choices = [
            Choice(_CASSETTE + name, f"Insert {name}", content) for name, content in self.shelf()
        ]
        choices.append(Choice("new", "Insert a new one", "blank; you are asked for its name"))
        if tape.cassette is not None:
            choices.append(Choice("rewind", "Rewind", Deck.of(self._session.rig).counter))
            choices.append(Choice("eject", "Eject", tape.cassette))
        now = _CASSETTE + tape.cassette if tape.cassette and tape.by_hand else ""
        self._ask.choose(ListQuestion("Cassettes", tuple(choices), now), self._chosen)

    def _chosen(self, value: str) -> None:
        if value == "new":
            self.new_cassette()
        elif value == "rewind":
            self.rewind()
        elif value == "eject":
            self.eject()
        else:
            self.insert(value.removeprefix(_CASSETTE))

    def new_cassette(self) -> None:
        """Ask for a name, and put a blank cassette in."""
        folder = self._session.rig.settings.tape_folder
        where = f"its file will be in {folder}" if folder else "it is in memory until it is saved"
        question = FileQuestion(
            "A new cassette",
            f"A plain name, as TASK1; {where}.",
            self._free_name(),
            to_write=True,
            plain=True,
        )
        self._ask.ask_file(question, lambda path: self.insert(path.name))

    def _free_name(self) -> str:
        names = set(self._session.rig.tape.cassettes)
        number = 1
        while (name := f"TAPE{number}") in names:
            number += 1
        return name

    def insert(self, name: str) -> None:
        """Put a cassette in, rewound, or say why not."""
        rig = self._session.rig
        try:
            rig.insert_cassette(name)
        except BadCassetteName as error:
            self._say(str(error), error=True)
            return
        content = rig.tape.content
        if not content and rig.tape.fault is not None:
            # A sound without a recording; the sitting tells what is wrong with it.
            return
        self._say(f"Cassette {rig.tape.cassette} is in, rewound: {contents_text(content)}.")

    def rewind(self) -> None:
        """Rewind the cassette that is in."""
        if (cassette := self._inserted()) is not None:
            self._session.rig.rewind_cassette()
            self._say(f"Cassette {cassette} is rewound.")

    def eject(self) -> None:
        """Take the cassette out."""
        if (cassette := self._inserted()) is not None:
            self._session.rig.eject_cassette()
            self._say(f"Cassette {cassette} is out: CSAVE and CLOAD help themselves now.")

    def _inserted(self) -> str | None:
        """The cassette that is in; without one it is said that there is none."""
        cassette = self._session.rig.tape.cassette
        if cassette is None:
            self._say("There is no cassette in the recorder.")
        return cassette

    # -- the printer ------------------------------------------------------------------------------

    @property
    def _paper(self) -> str:
        return self._session.rig.printer.text

    def paper(self) -> None:
        """What can be done with the paper."""
        lines = len(self._paper.splitlines())
        if not lines:
            self._say("Nothing is printed: LPRINT and LLIST print.")
            return
        choices = (Choice("save", "Save", f"{lines} lines"), Choice("tear", "Tear off"))
        chosen = {"save": self.save_paper, "tear": self.tear_off}
        self._ask.choose(ListQuestion("Paper", choices), lambda value: chosen[value]())

    def save_paper(self) -> None:
        """Ask for a name, and save what is printed."""
        if not self._paper:
            self._say("Nothing is printed: LPRINT and LLIST print.")
            return
        self._ask_for_file(self.save_paper_as)

    def _ask_for_file(self, then: Callable[[Path], object]) -> None:
        question = FileQuestion("Save the paper", "What is on it, as text.", PAPER, to_write=True)
        self._ask.ask_file(question, then)

    def save_paper_as(self, path: Path) -> bool:
        """Save what is printed, or say why not.

        Returns:
            Whether it is saved.
        """
        try:
            write_whole(path, self._paper.encode("latin-1"))
        except OSError as error:
            self._say(f"{path}: {reason(error)}", error=True)
            return False
        self._say(f"The paper is saved as {path.name}.")
        return True

    def tear_off(self) -> None:
        """Take the paper away; what no file holds is asked about."""
        printer = self._session.rig.printer
        if not self._paper:
            self._say("Nothing is printed: LPRINT and LLIST print.")
        elif printer.in_memory:
            answers = (
                Choice("save", "Save it first"),
                Choice("go", "Throw it away"),
                Choice("stay", "Back"),
            )
            question = Question("Tear off", "The paper is in no file.", answers)
            self._ask.ask(question, self._answered)
        else:
            self._tear_off()

    def _answered(self, answer: str) -> None:
        def save(path: Path) -> None:
            if self.save_paper_as(path):
                self._tear_off()

        if answer == "save":
            self._ask_for_file(save)
        elif answer == "go":
            self._tear_off()

    def _tear_off(self) -> None:
        self._session.rig.tear_off_paper()
        self._say("The paper is torn off.")
