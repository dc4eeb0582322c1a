"""The commands of arm and bench: another bench, parts put back, hands on the arm, teaching."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from trs80arm.arm.events import Reason
from trs80arm.benches import bench_files
from trs80arm.bundled import programs_folder
from trs80arm.desk.asking import Asking, Choice, ListQuestion, Question, Say
from trs80arm.desk.files import SessionFiles
from trs80arm.desk.hands import move_by_hand
from trs80arm.desk.session import Session
from trs80arm.desk.teach import Lesson
from trs80arm.drawing.readings import RING, Readings
from trs80arm.drawing.rows import clock_text
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.options import ArmStyle
from trs80arm.ui.asking import Screens
from trs80arm.ui.screens.hand_move import HandMoveScreen
from trs80arm.ui.screens.teach import TeachResult, TeachScreen

STANDARD_BENCH = "table"
ADVICE = {
    Reason.RATE: "A larger D in @STEP is slower, and a slower motor is stronger.",
    Reason.LOAD: "Go slower, keep the arm closer in, or lift less.",
    Reason.STOP: "The joint ends there.",
    Reason.CONTACT: "Something was in the way; the log says what.",
}
"""What helps against each way of losing steps."""


class ArmCommands:
    """Works the arm and what stands around it.

    Args:
        session: the machine with its arm.
        lesson: the positions taught.
        files: loads a program of them, and sets benches up.
        ask: a way to ask.
        say: a way to say something.
        screens: shows the dialogs of hands and teaching.
        style: how the arm is drawn now.
    """

    def __init__(
        self,
        session: Session,
        lesson: Lesson,
        files: SessionFiles,
        ask: Asking,
        say: Say,
        screens: Screens,
        style: Callable[[], ArmStyle],
    ) -> None:
        self._session = session
        self._lesson = lesson
        self._files = files
        self._ask = ask
        self._say = say
        self._screens = screens
        self._style = style

    def look(self) -> Readings:
        """What there is to see of arm and machine now."""
        return Readings.of(self._session.rig)

    # -- the bench --------------------------------------------------------------------------------

    def choose_bench(self) -> None:
        """Choose a bench."""
        choices = [Choice("", STANDARD_BENCH, "a table and one part at (8, 0)")]
        for path in self._benches():
            choices.append(Choice(str(path), path.stem, str(path.parent)))
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
        """Put the parts back."""
        self._session.rig.refill()
        self._say("The parts are back where they were at the start.")

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
            when = clock_text(slip.time / T_STATES_PER_SECOND)
            told = (
                f"At {when}: {slip.text}. {ADVICE[slip.reason or Reason.CONTACT]}\n"
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

    # -- the arm ----------------------------------------------------------------------------------

    def move_by_hand(self) -> None:
        """Move the arm by hand."""
        self._screens.open(
            HandMoveScreen(
                self.look,
                lambda move: move_by_hand(self._session, move),
                style=self._style(),
            )
        )

    def teach(self) -> None:
        """The list of positions."""
        reach = self._files.reach
        folder = self._session.path.parent if self._session.path else reach.home
        self._screens.open(TeachScreen(self._lesson, self.look, folder, reach), self._taught)

    def _taught(self, result: TeachResult) -> None:
        def load() -> None:
            if self._files.load_listing(result.listing):
                self._lesson.written()

        self._files.if_program_may_go("Load the lesson", load)

    def teach_here(self) -> None:
        """Add where the arm is to the lesson."""
        self._lesson.add(self.look())
        self._say(f"Position {len(self._lesson)} is taught: F12 lists them.")
