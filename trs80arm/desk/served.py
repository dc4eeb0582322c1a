"""The arm's serial line at a sitting: somebody else's program moves the arm that is seen."""

from __future__ import annotations

from trs80arm.desk.asking import Asking, Choice, ListQuestion, Say
from trs80arm.desk.session import Session
from trs80arm.options import TerminalOptions
from trs80arm.rig import Input, Key, Rig
from trs80arm.serial.attendant import Attendant
from trs80arm.serial.endpoints import Port, open_port

NO_LINE = "Nobody drives this arm over a line: `trs80arm terminal --serial` opens one."
LONGEST = 40
"""Characters of a line that the status has room for."""


def open_line(options: TerminalOptions) -> Port | None:
    """The port that the options want the arm's serial line on; None for no line.

    Raises:
        EndpointError: it cannot be had.
    """
    return open_port(options.serial_tcp) if options.serves_line else None


class Served:
    """The arm's serial line, if it is open to programs.

    Args:
        session: the machine; its arm must have a computer of its own if there is a port.
        port: where clients are; None for an arm that nobody drives over a line.
        ask: a way to ask.
        say: a way to say something.
    """

    def __init__(self, session: Session, port: Port | None, ask: Asking, say: Say) -> None:
        self._session = session
        self._ask = ask
        self._say = say
        self._port = port
        self._attendant: Attendant | None = None
        self._break_pressed = False
        if port is not None:
            self._attendant = Attendant(port, session.rig)
            self._watched = session.rig
            self._unwatch = session.rig.record(self._done)

    def _done(self, done: Input) -> None:
        """What the operator does: BREAK is the arm's stop key too."""
        if done.action in ("press", "hold") and Key.BREAK in done.arguments[0]:
            self._break_pressed = True

    def _use(self, rig: Rig, attendant: Attendant) -> None:
        """Go on with another machine, if there is one."""
        attendant.use(rig)
        if rig is not self._watched:
            self._unwatch()
            self._watched = rig
            self._unwatch = rig.record(self._done)

    def begin(self) -> None:
        """Say where the line is."""
        if self._port is not None:
            self._say(f"The arm's serial line is {self._port.name}. Escape is its stop key.")

    def go_on(self) -> bool:
        """Attend to the line; whether anything came.

        What was done once, and is being done again, answers nobody.
        """
        attendant, session = self._attendant, self._session
        if attendant is None:
            return False
        self._use(session.rig, attendant)
        attendant.muted = session.playing or session.timeline.behind
        if attendant.muted:
            self._break_pressed = False
            return False
        if self._break_pressed:
            self._break_pressed = False
            self.stop()
        return attendant.attend()

    @property
    def moves(self) -> bool:
        """Whether a client's command is under way."""
        controller = self._session.rig.controller
        return controller is not None and controller.busy

    @property
    def text(self) -> str:
        """What the status says of the line: where it is, and what went over it last."""
        if self._port is None or self._attendant is None:
            return ""
        lines = self._attendant.lines
        last = f"{'<' if lines[-1].sent else '>'} {lines[-1].text}" if lines else "nobody yet"
        short = last if len(last) <= LONGEST else last[: LONGEST - 3] + "..."
        return f"{self._port.name} {short}"

    def stop(self) -> None:
        """Press the stop key of the arm's pendant."""
        if self._attendant is None or self._session.rig.controller is None:
            self._say(NO_LINE)
            return
        moved = self.moves
        self._session.rig.press_pendant("STOP")
        if moved:
            self._say("The arm is stopped, and its client is told so.")

    def show_lines(self) -> None:
        """Show what went over the line lately, the latest first."""
        if self._port is None or self._attendant is None:
            self._say(NO_LINE)
            return
        lines = reversed(self._attendant.lines)
        rows = tuple(Choice(str(number), str(line)) for number, line in enumerate(lines))
        if rows:
            self._ask.choose(ListQuestion(self._port.name, rows), lambda _: None)
        else:
            self._say(f"Nothing has come over {self._port.name} yet.")

    def close(self) -> None:
        """End the line."""
        if self._port is not None:
            self._port.close()
        self._port = self._attendant = None
