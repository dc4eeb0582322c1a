"""What plays by itself on the desk, the demonstration or a recording, until a key is pressed."""

from __future__ import annotations

from trs80arm.arm.bench import BenchError
from trs80arm.desk.asking import Say
from trs80arm.desk.demo import Demo
from trs80arm.desk.session import Session
from trs80arm.files import FileFormatError
from trs80arm.reasons import one_line


class Stage:
    """Plays, and gives the machine back at the first key.

    Args:
        session: the machine.
        say: says the captions.
    """

    def __init__(self, session: Session, say: Say) -> None:
        self._session = session
        self._say = say
        self._demo: Demo | None = None

    @property
    def plays(self) -> bool:
        """Whether the demonstration is under way."""
        return self._demo is not None

    def begin_demo(self) -> None:
        """Begin the demonstration, or say why not."""
        try:
            self._demo = Demo(self._session)
        except (OSError, BenchError, FileFormatError) as error:
            self._say(f"No demonstration: {one_line(error)}", error=True)

    def go_on(self) -> None:
        """Do the demonstration's next thing if its time has come."""
        if self._demo is None:
            return
        self._demo.go_on()
        self._say(self._demo.caption)
        if self._demo.over:
            self._demo = None

    def operator_came(self) -> bool:
        """A key was pressed.

        Returns:
            Whether it only ended what was playing.
        """
        if self._demo is not None:
            self._demo.stop()
            self._demo = None
        elif self._session.playing:
            self._session.stop_playing()
        else:
            return False
        self._say("The machine is yours.")
        return True
