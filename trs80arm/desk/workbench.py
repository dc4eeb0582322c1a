"""The bench and what stands on it: another one, the parts put back, the way back after a slip."""

from __future__ import annotations

from pathlib import Path

from trs80arm.arm.by_hand import InTheWay
from trs80arm.arm.events import Reason
from trs80arm.arm.motors import RING
from trs80arm.benches import bench_files
from trs80arm.bundled import comes_along, programs_folder
from trs80arm.desk.asking import Asking, Choice, ListQuestion, Question, Say
from trs80arm.desk.files import SessionFiles
from trs80arm.desk.session import Session
from trs80arm.machine.clock import T_STATES_PER_SECOND

STANDARD_BENCH = "table"
ALONG = "comes along"
"""Said of a bench instead of its folder."""
ADVICE = {
    Reason.RATE: "A larger D in @STEP is slower, and a slower motor is stronger.",
    Reason.LOAD: "Go slower, keep the arm closer in, or lift less.",
    Reason.STOP: "The joint ends there.",
    Reason.CONTACT: "Something was in the way; the log says what.",
}
"""What helps against each way of losing steps."""


class Workbench:
    """Sets benches up, and helps after a slip.

    Args:
        session: the machine with its arm.
        files: sets benches up.
        ask: a way to ask.
        say: a way to say something.
    """

    def __init__(self, session: Session, files: SessionFiles, ask: Asking, say: Say) -> None:
        self._session = session
        self._files = files
        self._ask = ask
        self._say = say

    def choose_bench(self) -> None:
        """Choose a bench."""
        choices = [Choice("", STANDARD_BENCH, "a table and one part at (8, 0)")]
        for path in self._benches():
            where = ALONG if comes_along(path) else str(path.parent)
            choices.append(Choice(str(path), path.stem, where))
        standing = self._session.bench_path
        question = ListQuestion(
            "Bench", tuple(choices), str(standing.resolve()) if standing else ""
        )
        self._ask.choose(question, lambda name: self.set_up_bench(Path(name) if name else None))

    def _benches(self) -> list[Path]:
        folders = {self._files.reach.home, programs_folder()}
        if self._session.path is not None:
            folders.add(self._session.path.resolve().parent)
        found = {
            path.resolve()
            for folder in folders
            if folder is not None
            for path in bench_files(folder)
        }
        return sorted(found)

    def set_up_bench(self, path: Path | None) -> None:
        """Clear the table and set up a bench, None for the standard one; or say why not."""
        if self._files.set_up_bench(path):
            self._say(f"Bench: {path.stem if path else STANDARD_BENCH}.")

    def refill(self) -> None:
        """Put the parts back, or say what is in the way."""
        try:
            self._session.rig.refill()
        except InTheWay as error:
            self._say(f"The parts stay where they are: {error}.", error=True)
        else:
            self._say("The parts are back where they were at the start.")

    def score(self) -> None:
        """Show how well the goals of the bench are met."""
        score = self._session.rig.score()
        if not score.marks:
            self._say(score.headline)
            return
        rows = tuple(Choice(str(number), row) for number, row in enumerate(score.rows))
        self._ask.choose(ListQuestion(score.headline, rows), lambda _: None)

    # -- after a slip -----------------------------------------------------------------------------

    def come_back(self) -> None:
        """Say what became of the arm, and offer to begin again with arm, parts and registers."""
        answers = (
            Choice("home", "All back"),
            Choice("parts", "Only the parts"),
            Choice("stay", "Leave it"),
        )
        self._ask.ask(Question("Come back", self._what_happened(), answers), self._come_back)

    def _what_happened(self) -> str:
        slip = self._session.slip
        names = self._session.rig.joint_names
        lost = ", ".join(
            f"{name} {steps:+d}"
            for name, steps in zip(names, self._session.rig.state.slipped, strict=True)
            if abs(steps) >= RING
        )
        if slip is None:
            told = "No motor has lost steps: the arm is where its registers say."
        else:
            minutes, seconds = divmod(slip.time / T_STATES_PER_SECOND, 60)
            told = (
                f"At {minutes:.0f}:{seconds:05.2f}: {slip.text}. "
                f"{ADVICE[slip.reason or Reason.CONTACT]}\n"
                f"Steps lost: {lost}. The registers do not know, so nothing fits any more."
            )
        return (
            f"{told}\n\nAll back: BREAK, the arm and the parts to where the bench has them, and "
            "registers at zero as after @RESET. The program stays; F5 runs it again."
        )

    def _come_back(self, answer: str) -> None:
        if answer == "home":
            self._session.go_home()
            self._say("Arm, parts and registers are as at the start: F5 runs the program.")
        elif answer == "parts":
            self.refill()
