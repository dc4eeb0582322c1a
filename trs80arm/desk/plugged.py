"""A real arm beside the model, at a sitting: asked about before it moves, and stopped by BREAK."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from trs80arm.desk.asking import Asking, Choice, Question, Say
from trs80arm.desk.session import Session
from trs80arm.rig import Input, Key, Waiting

if TYPE_CHECKING:
    from trs80arm.serial.courier import Courier
    from trs80arm.serial.limits import Plugging

OTHER_MACHINE = "The machine is another one, and the arm on the wire is not where its model is."
STOPPED = "The arm is stopped; what is left of its motion goes first when it is moved again."
MOVE = "move"
"""The answer that lets the arm move."""


def plug_in(session: Session, plugging: Plugging | None) -> Courier | None:
    """Look for the arm at the end of a wire; nothing moves.

    Raises:
        WireError: there is none.
    """
    if plugging is None:
        return None
    # Threads and ports: few sittings have them.
    from trs80arm.serial.courier import Courier
    from trs80arm.serial.port import Port

    return Courier(session.rig, Port(plugging.path), plugging.settings)


class Plugged:
    """The arm on the wire, if one is plugged in.

    Until its user has said that it may move no time passes at the machine.

    Args:
        session: the machine with the model.
        courier: takes orders to the arm; None if nothing is plugged in.
        plugging: the wire.
        ask: a way to ask.
        say: a way to say something.
    """

    def __init__(
        self,
        session: Session,
        courier: Courier | None,
        plugging: Plugging | None,
        ask: Asking,
        say: Say,
    ) -> None:
        self._session = session
        self._courier = courier
        self._ask = ask
        self._say = say
        path = plugging.path if plugging else ""
        self._may_move = plugging is None or plugging.allowed
        self._asked = False
        self._question = Question(
            "A real arm",
            f"At {path} is a TeachMover, and it will do what the model does. It must stand as the "
            "model stands, with nobody in its reach. Escape stops it at the end of what it is "
            "doing, half a second at most, and closing the hand takes longer. May it move?",
            (
                Choice("no", "No", "the model moves alone"),
                Choice(MOVE, "Yes, move", "the arm follows the model"),
            ),
        )
        self._unwatch: Callable[[], None] = lambda: None
        if courier is not None:
            session.held_back = self._must_wait
            # A machine that has to wait for the arm sees no key: BREAK is seen on its way.
            self._unwatch = session.rig.record(self._did)

    def _did(self, done: Input) -> None:
        """The operator did something: BREAK stops the arm."""
        if done.action in ("press", "hold") and Key.BREAK in done.arguments[0]:
            self.stop()

    def begin(self) -> None:
        """Ask whether the arm may move, unless that is said already."""
        if self._courier is None:
            return
        if self._may_move:
            self._say("The arm on the wire follows the model.")
        else:
            self._ask.ask(self._question, self._answered)

    def _answered(self, answer: str) -> None:
        if self._courier is None:
            return
        if answer == MOVE:
            self._may_move = True
            self._say("The arm on the wire follows the model. Escape stops it.")
        else:
            self._leave_alone()

    def _leave_alone(self) -> None:
        self.close()
        self._say("The wire is unplugged: the model moves alone.")

    def _must_wait(self) -> bool:
        return self._courier is not None and (not self._may_move or self._courier.behind)

    @property
    def asks(self) -> bool:
        """Whether its user has still to say that the arm may move."""
        return self._courier is not None and not self._may_move

    @property
    def busy(self) -> bool:
        """Whether the arm has something to do yet."""
        return self._courier is not None and self._courier.busy

    def go_on(self) -> None:
        """Send what is next; never waits."""
        courier = self._courier
        if courier is None:
            return
        if not self._may_move:
            asking = self._ask.is_asking(self._question)
            if self._asked and not asking:
                self._leave_alone()
            self._asked = asking
            return
        courier.go_on()
        self._mind_faults()

    def deliver(self) -> None:
        """Send what is next, and wait until it is done."""
        if self._courier is not None and self._may_move:
            self._courier.deliver()
            self._mind_faults()

    def finish(self) -> None:
        """`deliver`, with what the machine is in the middle of: it waits for its user now."""
        if self._courier is not None and self._may_move:
            self._courier.finish()
            self._mind_faults()

    def stop(self) -> None:
        """Send nothing more; what the arm is doing comes to its end."""
        courier = self._courier
        if courier is None:
            return
        moved = courier.busy and not courier.held
        courier.stop()
        if moved:
            self._say(STOPPED)

    def _mind_faults(self) -> None:
        """Tell why the arm does not follow any more, and stop what moves the model."""
        courier, session = self._courier, self._session
        if courier is None:
            return
        fault = courier.fault if session.rig is courier.rig else OTHER_MACHINE
        if not fault:
            return
        self.close()
        if session.waiting in (Waiting.NOTHING, Waiting.SET):
            session.ready()
        self._say(f"{fault} The wire is unplugged.", error=True)

    def close(self) -> None:
        """Unplug the wire."""
        courier, self._courier = self._courier, None
        self._unwatch()
        if courier is not None:
            courier.close()
