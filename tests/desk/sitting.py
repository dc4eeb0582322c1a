"""A sitting without a screen: questions are answered by a list, and what is said is kept."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import Any

from trs80arm.desk.asking import (
    FileQuestion,
    Listing,
    ListQuestion,
    ProgramQuestion,
    Question,
    Take,
)
from trs80arm.desk.files import SessionFiles
from trs80arm.desk.leaving import Leaving
from trs80arm.desk.places import RecentFiles
from trs80arm.desk.recovery import Recovery
from trs80arm.desk.session import Session
from trs80arm.desk.teach import Lesson

NOTHING = object()
"""An answer that is never given: the question stands."""


class Person:
    """Answers questions in order, and listens.

    Attributes:
        answers: what is answered next; None goes back from the question.
        asked: the questions, in order.
        told: what was said.
        errors: what was said loudly.
        standing: the question that is not answered yet.
    """

    def __init__(self) -> None:
        self.answers: deque[Any] = deque()
        self.asked: list[Any] = []
        self.told: list[str] = []
        self.errors: list[str] = []
        self.standing: Any = None

    def say(self, text: str, *, error: bool = False) -> None:
        (self.errors if error else self.told).append(text)

    def _answer(self, question: Any, then: Callable[[Any], object]) -> None:
        self.asked.append(question)
        answer = self.answers.popleft()
        if answer is NOTHING:
            self.standing = question
        elif answer is not None:
            then(answer)

    def ask(self, question: Question, then: Take) -> None:
        self._answer(question, then)

    def choose(self, question: ListQuestion, then: Take, seen: Take | None = None) -> None:
        for choice in question.choices if seen is not None else ():
            seen(choice.value)
        self._answer(question, then)

    def ask_file(self, question: FileQuestion, then: Callable[[Path], object]) -> None:
        self._answer(question, then)

    def ask_program(self, question: ProgramQuestion, then: Callable[[Path], object]) -> None:
        self._answer(question, then)

    def ask_listing(self, then: Callable[[Listing], object]) -> None:
        self._answer(Listing, then)

    def is_asking(self, question: Question) -> bool:
        return bool(self.standing == question)


class Sitting:
    """Session, files and leaving with a person who answers."""

    def __init__(self, folder: Path, session: Session | None = None) -> None:
        self.folder = folder
        self.state = folder / "state"
        self.person = Person()
        self.session = session or Session()
        self.lesson = Lesson()
        say = self.person.say
        self.recovery = Recovery(self.session, self.lesson, self.state, "20260101-120000-1", say)
        self.recent = RecentFiles(self.state / "recent.json")
        self.files = SessionFiles(self.session, self.recovery, self.recent, self.person, say)
        self.ended: list[str] = []
        self.leaving = Leaving(
            self.session,
            self.lesson,
            self.recovery,
            self.files,
            self.person,
            lambda: self.ended.append("taught"),
            lambda: self.ended.append("left"),
        )

    def type(self, *lines: str) -> None:
        """Type lines, and wait until the machine has taken them."""
        for line in lines:
            self.session.rig.type(line + "\r")
        self.session.rig.run_until_waiting(30)

    def answer(self, *answers: Any) -> None:
        """What the person will answer."""
        self.person.answers.extend(answers)

    def write(self, name: str, text: str) -> Path:
        """A file in the folder."""
        path = self.folder / name
        path.write_text(text)
        return path

    @property
    def lines(self) -> list[int]:
        """The numbers of the program's lines."""
        return [number for number, _ in self.session.program]
