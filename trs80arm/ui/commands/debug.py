"""The commands of the debugger and of saved states: stop, step, back, save, load.

Dialogs are imported when they are opened: the first frame needs none.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from trs80arm.desk.asking import Say
from trs80arm.desk.debugger import Debugger, Reason, Stop
from trs80arm.desk.pacing import Pacer
from trs80arm.desk.session import Session
from trs80arm.desk.states import QUICK, StateError, States
from trs80arm.ui.asking import Screens

if TYPE_CHECKING:
    from trs80arm.desk.code_debugger import CodeDebugger
    from trs80arm.ui.screens.debugger import Leaving

STANDS = "Stopped: F7 does a statement, F6 goes on, Ctrl+X opens the debugger."


class DebugCommands:
    """Stops the machine and shows where it stands.

    Args:
        session: the machine.
        debugger: what stops it.
        states: the saved states.
        pacer: how its time goes.
        screens: shows dialogs.
        say: a way to say something.
        at_desk: whether no dialog is open.
    """

    def __init__(
        self,
        session: Session,
        debugger: Debugger,
        states: States,
        pacer: Pacer,
        screens: Screens,
        say: Say,
        at_desk: Callable[[], bool],
    ) -> None:
        self._session = session
        self._debugger = debugger
        self._states = states
        self._pacer = pacer
        self._screens = screens
        self._say = say
        self._at_desk = at_desk
        self._is_open = False
        self._was_paused = False
        self._code: CodeDebugger | None = None

    def look(self) -> None:
        """Show where the machine has come to stand, if it has since the last look."""
        stop = self._debugger.new_stop()
        if stop is None:
            return
        self._pacer.pause(True)
        if self._at_desk():
            self._open_page(stop)
        else:
            self._say(stop.text)

    def open(self) -> None:
        """Stop time, and open the debugger."""
        from trs80arm.ui.screens.debugger import DebuggerScreen

        self._was_paused = self._pacer.paused
        self._pacer.pause(True)
        self._debugger.new_stop()
        self._is_open = True
        screen = DebuggerScreen(self._debugger, self._states, self.quick_save, self._load)
        self._screens.open(screen, self._left)

    def open_processor(self) -> None:
        """Stop time, and open the debugger's page for machine code."""
        from trs80arm.ui.screens.processor import ProcessorScreen

        self._was_paused = self._pacer.paused
        self._pacer.pause(True)
        self._debugger.new_stop()
        self._is_open = True
        self._screens.open(ProcessorScreen(self.code), self._left)

    def _open_page(self, stop: Stop) -> None:
        """Open the page for what the machine stands in."""
        if stop.reason is Reason.CODE:
            self.open_processor()
        else:
            self.open()

    @property
    def code(self) -> CodeDebugger:
        """What stops machine code; made when it is wanted first."""
        if self._code is None:
            from trs80arm.desk.code_debugger import CodeDebugger

            self._code = CodeDebugger(self._debugger)
        return self._code

    def _left(self, leaving: Leaving) -> None:
        """The debugger was closed."""
        from trs80arm.ui.screens.debugger import Leaving

        self._is_open = False
        if leaving is Leaving.GO:
            self._pacer.pause(False)
            if self._debugger.waits_to_stop:
                self._say("It stops before the next statement; the debugger comes back then.")
        elif self._debugger.stop is not None and self._session.rig.basic.next_address is not None:
            self._say(STANDS)
        else:
            self._debugger.go()
            self._pacer.pause(self._was_paused)

    def step(self) -> None:
        """Stop before the next statement and open the debugger; once stopped, do one."""
        stood = self._debugger.stop is not None
        if not stood and self._session.rig.basic.next_address is None and not self._session.busy:
            self.open()
            return
        self._pacer.pause(True)
        self._debugger.into()
        stop = self._debugger.new_stop()
        if stop is None:
            self._pacer.pause(False)
            self._say("It stops before the next statement.")
        elif stood:
            self._say(stop.text)
        else:
            self.open()

    def watch(self) -> None:
        """Ask what the machine is to stop behind a change of."""
        from trs80arm.ui.screens.ask_line import AskLine
        from trs80arm.ui.screens.debugger import WATCH, WATCH_HINT

        def take(text: str) -> None:
            watched = self._debugger.toggle_watch(text)
            self._say(f"{'Watched' if watched else 'Not watched any more'}: {text.strip()}.")

        watched = ", ".join(self._debugger.watches)
        hint = f"{WATCH_HINT} Watched: {watched}." if watched else WATCH_HINT
        self._screens.open(AskLine(WATCH, hint, "", take), lambda _: None)

    def back(self) -> None:
        """One statement back in time."""
        self._back(self._debugger.back(), "statement")

    def back_to_stop(self) -> None:
        """Back to the breakpoint before."""
        self._back(self._debugger.back_to_stop(), "breakpoint")

    def _back(self, found: bool, what: str) -> None:
        stop = self._debugger.new_stop()
        if found and stop is not None:
            self._pacer.pause(True)
            self._say(stop.text)
        else:
            self._say(f"Nothing is known of an earlier {what}.")

    # -- saved states -----------------------------------------------------------------------------

    def states(self) -> None:
        """The saved states."""
        from trs80arm.ui.screens.states import StatesScreen

        self._screens.open(StatesScreen(self._states, self._session), self._load)

    def quick_save(self) -> None:
        """Save the machine under the quick name."""
        try:
            self._states.save(QUICK, self._session)
        except StateError as error:
            self._say(str(error), error=True)
        else:
            self._say("Saved; Shift+F2 comes back to here.")

    def quick_load(self) -> None:
        """Load the machine that was saved quickly."""
        self._load(QUICK)

    def _load(self, name: str) -> None:
        stood = self._debugger.stop is not None
        try:
            self._states.load(name, self._session)
        except StateError as error:
            self._say(str(error), error=True)
            return
        if stood or self._is_open:
            self._debugger.stand_here()
            self._debugger.new_stop()
        self._say(f"State {name} is loaded.")
