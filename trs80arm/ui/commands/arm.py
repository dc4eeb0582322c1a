"""The commands of arm and bench: another bench, parts put back, hands on the arm, teaching.

Dialogs are imported when they are opened: the first frame needs none.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from trs80arm.desk.asking import Asking, Say
from trs80arm.desk.base_pendant import BasePendant
from trs80arm.desk.files import SessionFiles
from trs80arm.desk.hands import move_by_hand
from trs80arm.desk.pendant import Pendant
from trs80arm.desk.session import Session
from trs80arm.desk.workbench import Workbench
from trs80arm.drawing.readings import Readings
from trs80arm.options import ArmStyle
from trs80arm.ui.asking import Screens
from trs80arm.ui.keys.jog_keyboard import JogKeyboard

if TYPE_CHECKING:
    from trs80arm.ui.screens.pendant import Override
    from trs80arm.ui.screens.taught_program import TeachResult


class ArmCommands:
    """Works the arm and what stands around it.

    Args:
        session: the machine with its arm.
        pendant: the teach pendant, with the points taught.
        jog_keyboard: its keys.
        base_pendant: the pendant of an arm that has one of its own.
        base_keyboard: its joint keys.
        override: its speed override.
        files: loads a program of them, and sets benches up.
        ask: a way to ask.
        say: a way to say something.
        screens: shows the dialogs of hands and pendant.
        style: how the arm is drawn now.
    """

    def __init__(
        self,
        session: Session,
        pendant: Pendant,
        jog_keyboard: JogKeyboard,
        base_pendant: BasePendant,
        base_keyboard: JogKeyboard,
        override: Override,
        files: SessionFiles,
        ask: Asking,
        say: Say,
        screens: Screens,
        style: Callable[[], ArmStyle],
    ) -> None:
        self._session = session
        self._pendant = pendant
        self._jog_keyboard = jog_keyboard
        self._base_pendant = base_pendant
        self._base_keyboard = base_keyboard
        self._override = override
        self._files = files
        self._ask = ask
        self._say = say
        self._screens = screens
        self._style = style
        self._workbench = Workbench(session, files, ask, say)

    def look(self) -> Readings:
        """What there is to see of arm and machine now."""
        return Readings.of(self._session.rig)

    # -- the bench --------------------------------------------------------------------------------

    def choose_bench(self) -> None:
        """Choose a bench."""
        self._workbench.choose_bench()

    def refill(self) -> None:
        """Put the parts back."""
        self._workbench.refill()

    def score(self) -> None:
        """Show how well the goals of the bench are met."""
        self._workbench.score()

    def come_back(self) -> None:
        """Say what became of the arm, and offer to begin again with arm, parts and registers."""
        self._workbench.come_back()

    # -- the arm ----------------------------------------------------------------------------------

    def move_by_hand(self) -> None:
        """Move the arm by hand."""
        from trs80arm.ui.screens.hand_move import HandMoveScreen

        self._screens.open(
            HandMoveScreen(
                self.look,
                lambda move: move_by_hand(self._session, move),
                style=self._style(),
            )
        )

    def teach(self) -> None:
        """The teach pendant, or the arm's own where it has one."""
        if self._base_pendant.there:
            self._teach_at_the_base()
            return
        from trs80arm.ui.screens.pendant import Means, PendantScreen

        reach = self._files.reach
        means = Means(
            self._pendant,
            self._jog_keyboard,
            self.look,
            self._override,
            self._session.rig.refill,
            self._session.path.parent if self._session.path else reach.home,
            reach,
            self._style(),
        )
        self._screens.open(PendantScreen(means), self._taught)

    def _teach_at_the_base(self) -> None:
        from trs80arm.ui.screens.base_pendant import BasePendantScreen, Means

        means = Means(self._base_pendant, self._base_keyboard, self.look, self._style())
        self._screens.open(BasePendantScreen(means))

    def _taught(self, result: TeachResult) -> None:
        def load() -> None:
            if self._files.load_listing(result.listing):
                self._pendant.lesson.written()

        self._files.if_program_may_go("Load the lesson", load)

    def teach_here(self) -> None:
        """Add where the arm is to the points."""
        self._pendant.teach()
        self._say(f"Position {len(self._pendant.lesson)} is taught: F12 lists them.")
