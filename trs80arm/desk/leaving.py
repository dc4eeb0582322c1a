"""Leaving the desk: nothing that is unsaved goes without a question."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from trs80arm.desk.asking import Asking, Choice, Question
from trs80arm.desk.files import SessionFiles
from trs80arm.desk.recovery import Recovery
from trs80arm.desk.session import Session
from trs80arm.desk.teach import Lesson

BACK = (Choice("go", "Leave without saving"), Choice("stay", "Back"))
AGAIN = "Ctrl+C again leaves and keeps a recovery copy."
PROGRAM_UNSAVED = Question(
    "Leave", "The program in memory is not saved.", (Choice("save", "Save"), *BACK), AGAIN
)
LESSON_UNWRITTEN = Question(
    "Leave",
    "Positions were taught, and no program of them is written.",
    (Choice("teach", "Look at them"), *BACK),
    AGAIN,
)
KEEPSAKES_UNSAVED = Question(
    "Leave",
    "What was recorded on cassettes or printed is in memory only.",
    (Choice("keep", "Save it"), *BACK),
    AGAIN,
)
NOTHING_UNSAVED = Question(
    "Leave",
    "Leave trs80arm?",
    (Choice("go", "Leave"), Choice("stay", "Back")),
    "Ctrl+C again leaves.",
)
"""What is asked when the key that leaves may have been meant for the machine."""
QUESTIONS = (PROGRAM_UNSAVED, LESSON_UNWRITTEN, KEEPSAKES_UNSAVED, NOTHING_UNSAVED)


class Leaving:
    """Asks what is to become of what is unsaved, and ends the sitting.

    Args:
        session: the machine and its program.
        lesson: the positions taught.
        recovery: the copies of both.
        files: saves the program.
        ask: a way to ask.
        teach: shows the positions taught.
        end: ends the program.
    """

    def __init__(
        self,
        session: Session,
        lesson: Lesson,
        recovery: Recovery,
        files: SessionFiles,
        ask: Asking,
        teach: Callable[[], object],
        end: Callable[[], object],
    ) -> None:
        self._session = session
        self._lesson = lesson
        self._recovery = recovery
        self._files = files
        self._ask = ask
        self._teach = teach
        self._end = end
        self._given_up: set[Question] = set()

    @property
    def asked(self) -> bool:
        """Whether a question before leaving stands unanswered."""
        return any(map(self._ask.is_asking, QUESTIONS))

    def _unsaved(self) -> Iterator[Question]:
        """What to ask about, in order."""
        if self._session.unsaved:
            yield PROGRAM_UNSAVED
        if self._lesson.unwritten:
            yield LESSON_UNWRITTEN
        if self._session.keepsakes.unsaved:
            yield KEEPSAKES_UNSAVED

    def ask_first(self) -> None:
        """Leave, but not without a question, whatever is saved."""
        if self.asked or any(self._unsaved()):
            self.leave()
        else:
            self._ask.ask(NOTHING_UNSAVED, lambda answer: self._answered(NOTHING_UNSAVED, answer))

    def leave(self) -> None:
        """Leave; ask if something is unsaved, but when asked while asking, leave at once."""
        if self.asked:
            self._recovery.tell_again()
            if self._recovery.keep():
                self._session.close()
                self._end()
        else:
            self._given_up = set()
            self._go_on()

    def _go_on(self) -> None:
        """Ask about what is unsaved and not given up; leave when there is no more of it."""
        question = next((q for q in self._unsaved() if q not in self._given_up), None)
        if question is None:
            self._go()
        else:
            self._ask.ask(question, lambda answer: self._answered(question, answer))

    def _answered(self, question: Question, answer: str) -> None:
        if answer == "save":
            self._files.save(self._go_on)
        elif answer == "teach":
            self._teach()
        elif answer == "keep":
            self._files.save_keepsakes(self._go_on)
        elif answer == "go":
            self._given_up.add(question)
            self._go_on()

    def _go(self) -> None:
        self._recovery.drop()
        self._session.close()
        self._end()
