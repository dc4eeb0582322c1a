"""Questions of the desk, asked in lines: the next line that is typed is the answer."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from trs80arm.bundled import PROGRAM_SUFFIX, named
from trs80arm.desk.asking import (
    Choice,
    FileQuestion,
    Listing,
    ListQuestion,
    ProgramQuestion,
    Question,
    Say,
    Take,
)
from trs80arm.desk.reach import Reach, file_problem, proposed, replaces

BACK = "."
"""The line that goes back from a question."""


class LineAsking:
    """Asks in lines.

    Args:
        say: prints a question.
        reach: which files can be named.
        careful: whether it is asked before something is lost. Lines that come from a pipe were
            written without such questions in mind: there, whatever may go goes.
    """

    def __init__(self, say: Say, reach: Reach, *, careful: bool) -> None:
        self._say = say
        self._reach = reach
        self._careful = careful
        self._question: object = None
        self._take: Take | None = None

    @property
    def waits(self) -> bool:
        """Whether a question stands, so that the next line is its answer."""
        return self._take is not None

    def drop(self) -> None:
        """Forget the question: its user does something else instead."""
        self._take = self._question = None

    def answer(self, line: str) -> None:
        """Take a line as the answer; an empty one, or `.`, goes back from a list or a question."""
        take = self._take
        self.drop()
        if take is not None:
            if line.strip() == BACK:
                self._say("Left as it is.")
            else:
                take(line.strip())

    def _stand(self, question: object, text: str, take: Take) -> None:
        self._question, self._take = question, take
        self._say(text)

    def ask(self, question: Question, then: Take) -> None:
        """Ask; the answer is a number or the first letters of what it says."""
        if not self._careful and any(answer.value == "go" for answer in question.answers):
            then("go")
            return
        self._pick(question, question.text, question.answers, then)

    def choose(self, question: ListQuestion, then: Take, seen: Take | None = None) -> None:
        """Let one of a list be chosen; nobody looks at each on the way."""
        self._pick(question, question.title, question.choices, then)

    def _pick(self, question: object, text: str, choices: tuple[Choice, ...], then: Take) -> None:
        lines = [
            f"  {number} {choice.label}{f', {choice.note}' if choice.note else ''}"
            for number, choice in enumerate(choices, 1)
        ]

        def take(line: str) -> None:
            wanted = line.casefold()
            for number, choice in enumerate(choices, 1):
                if wanted in (str(number), choice.value.casefold()) or (
                    wanted and choice.label.casefold().startswith(wanted)
                ):
                    then(choice.value)
                    return
            self._say("Left as it is.")

        self._stand(question, "\n".join([text, *lines, f"Which? {BACK} goes back."]), take)

    def ask_file(self, question: FileQuestion, then: Callable[[Path], object]) -> None:
        """Ask for a file's name; an empty line takes what is proposed."""
        proposal = proposed(self._reach, question)
        warned = ""

        def take(line: str) -> None:
            nonlocal warned
            text = line or proposal
            path = self._reach.typed(text)
            if problem := file_problem(self._reach, question, text):
                self._say(problem)
            elif replaces(question, path) and text != warned:
                warned = text
                again = f"{path.name} exists: the same name again replaces it, {BACK} goes back."
                self._stand(question, again, take)
            else:
                then(path)

        self._stand(
            question,
            f"{question.title}: {question.hint}\n"
            f"Which name? An empty line takes {proposal}, {BACK} goes back.",
            take,
        )

    def ask_program(self, question: ProgramQuestion, then: Callable[[Path], object]) -> None:
        """Ask for a program: one of those that stand there, or any other by its name."""
        lines, paths = [], []
        for shelf in question.shelves:
            for path, label in shelf.entries(""):
                paths.append(path)
                lines.append(f"  {len(paths)} {label}")

        def take(line: str) -> None:
            if line.isdecimal() and 1 <= int(line) <= len(paths):
                then(paths[int(line) - 1])
                return
            if not line:
                return
            path = named(self._reach.typed(line), PROGRAM_SUFFIX)
            if outside := self._reach.refusal(path, to_write=False):
                self._say(outside)
            else:
                then(path)

        ask = f"Which? A number or a name; {BACK} goes back."
        self._stand(question, "\n".join([*lines, ask]), take)

    def ask_listing(self, then: Callable[[Listing], object]) -> None:
        """There is nothing to ask: a listing is typed, or pasted into the terminal."""
        self._say("Type or paste the lines: each goes to the machine.")

    def is_asking(self, question: Question) -> bool:
        """Whether that question stands unanswered."""
        return self.waits and self._question == question
