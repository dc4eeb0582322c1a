"""Who attends to a rig's serial line: bytes both ways between it and a port, and who hangs up.

The rig's owner lets time pass; the line is attended to between. Little is held: what a client sends
beyond what the arm's computer has room for stays where it is, and the client waits.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

from trs80arm.rig import Rig
from trs80arm.serial.endpoints import Port
from trs80arm.serial.lines import END, Lines
from trs80arm.shown import shown

READ = 4096
"""Bytes that are taken at once."""
UNSENT = 65536
"""Bytes of answers that nobody reads, up to which the line is read on."""
HUNG_UP = b"(hung up)"
"""What the log says when a client has left."""
KEPT = 100
"""Lines of the log that are kept."""


@dataclass(frozen=True)
class Logged:
    """One line that went over the serial line.

    Attributes:
        time: virtual seconds.
        sent: whether the arm sent it.
        text: the line without its CR, fit to be shown.
    """

    time: float
    sent: bool
    text: str

    def __str__(self) -> str:
        return f"{self.time:10.3f} {'<' if self.sent else '>'} {self.text}"


class Attendant:
    """Connects the computer in the base of an arm with a port.

    Args:
        port: where clients are.
        rig: the machine; it must have a controller.
        log: told every line.

    Attributes:
        port: where clients are.
        lines: the latest lines, both ways.
        muted: whether answers go nowhere, for they were given before.
    """

    def __init__(self, port: Port, rig: Rig, log: Callable[[Logged], None] | None = None) -> None:
        self.port = port
        self.lines: deque[Logged] = deque(maxlen=KEPT)
        self.muted = False
        self._log = log
        self._coming = bytearray()
        self._going = bytearray()
        self._heard = Lines()
        self._rig = rig
        self._deaf = rig.watch_answers(self._answered)

    def use(self, rig: Rig) -> None:
        """Connect another machine from now on, if it is another one."""
        if rig is not self._rig:
            self._deaf()
            self._rig = rig
            self._deaf = rig.watch_answers(self._answered)

    @property
    def unsent(self) -> bool:
        """Whether answers are still to be sent."""
        return bool(self._going)

    def _answered(self, answer: bytes) -> None:
        if self.muted:
            return
        self._going += answer
        for line in answer.split(b"\r")[:-1]:
            self._tell(sent=True, line=line)

    def _tell(self, line: bytes, *, sent: bool) -> None:
        logged = Logged(self._rig.time, sent, shown(line.decode("latin-1").strip()))
        self.lines.append(logged)
        if self._log is not None:
            self._log(logged)

    def attend(self) -> bool:
        """Send what was answered, and take what has come.

        Returns:
            Whether anything came, or somebody left.
        """
        self._send()
        rig, controller = self._rig, self._rig.controller
        if controller is None:
            return False
        if self.port.left():
            self._hung_up()
            return True
        if len(self._going) >= UNSENT:
            return False
        if not self._coming:
            self._coming += self.port.receive(READ)
        ready = self._fitting(controller.room)
        if ready:
            rig.receive(ready)
            for line in self._heard.feed(ready):
                self._tell(line, sent=False)
        return bool(ready)

    def _send(self) -> None:
        if self._going:
            del self._going[: self.port.send(bytes(self._going))]

    def _hung_up(self) -> None:
        self._rig.hang_up()
        self._tell(HUNG_UP, sent=False)
        self._coming.clear()
        self._going.clear()
        self._heard.clear()

    def _fitting(self, room: int) -> bytes:
        """Take what has come, up to as many lines as there is room for."""
        end = -1
        for _ in range(room):
            found = self._coming.find(END, end + 1)
            if found < 0:
                end = len(self._coming) - 1
                break
            end = found
        taken = bytes(self._coming[: end + 1])
        del self._coming[: end + 1]
        return taken
