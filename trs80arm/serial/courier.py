"""Takes orders to the arm on the wire, one after the other, while the machine goes on.

A line is answered when it is done, so that whoever sends it waits; the courier has a thread of its
own for that. The machine may be a leg ahead and no more. What is on the wire cannot be called
back: a stop takes effect at the end of that line, and nothing else is sent until the operator has
the arm moved again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import contextmanager

from trs80arm.rig import Rig, Waiting
from trs80arm.serial.far_arm import FarArm
from trs80arm.serial.gathering import LONGEST
from trs80arm.serial.limits import Plugging, PlugSettings
from trs80arm.serial.plug import Plug
from trs80arm.serial.port import Port
from trs80arm.serial.wire import Wire, WireError

AHEAD = 1
"""Orders that may wait while one is being done."""
GLANCE = 0.1
"""Seconds between two looks for Ctrl+C while an answer is waited for."""


class Courier:
    """Keeps an arm on a wire where the twin is.

    Args:
        rig: the machine with the twin.
        wire: to the arm.
        settings: how fast and far it may go.

    Raises:
        WireError: the twin is no TeachMover, or nothing at the end of the wire answers as one.
    """

    def __init__(self, rig: Rig, wire: Wire, settings: PlugSettings) -> None:
        self._rig = rig
        self._wire = wire
        self._plug = Plug(rig, settings)
        self._arm = FarArm(wire, rig.arm.model.motor_names, settings.play)
        self._held = False
        self._stood: int | None = None
        self._thread = ThreadPoolExecutor(1, "wire")
        self._answer: Future[None] | None = None
        try:
            self._arm.meet()
        except WireError:
            self.close()
            raise

    @property
    def rig(self) -> Rig:
        """The machine with the twin."""
        return self._rig

    @property
    def fault(self) -> str:
        """Why nothing is sent any more, in one sentence; empty while all is well."""
        return self._plug.fault

    @property
    def held(self) -> bool:
        """Whether nothing is sent until the operator has the arm moved again."""
        return self._held

    @property
    def busy(self) -> bool:
        """Whether anything is on the wire, or is to be sent."""
        return self._answer is not None or (not self._held and bool(self._plug.orders))

    @property
    def behind(self) -> bool:
        """Whether the machine has to wait for the arm."""
        return not self._held and len(self._plug.orders) > AHEAD

    def go_on(self) -> None:
        """Send what is next, if what was sent before is done; never waits."""
        self._take_answer()
        self._plug.look()
        if self._held:
            self._look_for_more()
        if self._answer is None and self._plug.orders and not self._held:
            self._answer = self._thread.submit(self._arm.do, self._plug.orders.popleft())

    def stop(self) -> None:
        """Send nothing more; what is on the wire comes to its end.

        When the machine is at its prompt, and then moves the arm again, that ends: what was left is
        sent first, so that the arm goes the twin's way.
        """
        self._held, self._stood = True, None

    def deliver(self) -> None:
        """Wait until everything that is to be sent is done; Ctrl+C breaks that off."""
        self.go_on()
        while self._answer is not None:
            wait([self._answer], GLANCE)
            self.go_on()

    def finish(self) -> None:
        """`deliver`, with what the machine is in the middle of as well."""
        self._plug.finish()
        self.deliver()

    def close(self) -> None:
        """Unplug the wire, when what is on it has come to its end."""
        self._plug.unplug()
        if self._answer is not None:
            wait([self._answer], LONGEST + GLANCE)
        self._wire.close()
        self._thread.shutdown(wait=False)

    def _take_answer(self) -> None:
        if self._answer is None or not self._answer.done():
            return
        answer, self._answer = self._answer, None
        try:
            answer.result()
        except WireError as error:
            self._plug.fail(str(error))

    def _look_for_more(self) -> None:
        """Whether the operator, whose program was broken off, has the arm moved again."""
        if self._stood is None and self._rig.waiting is Waiting.COMMAND:
            self._stood = self._plug.half_steps
        elif self._stood is not None and self._plug.half_steps != self._stood:
            self._held = False


@contextmanager
def plugged(rig: Rig, plugging: Plugging) -> Iterator[Callable[[Rig], None]]:
    """Have an arm on a wire do what the twin does while a block runs.

    Args:
        rig: the machine with the twin.
        plugging: by which wire.

    Yields:
        What has to be called now and then: it returns when the arm has caught up.

    Raises:
        WireError: nobody has said that the arm may move; or, from what is yielded too, the arm
            cannot be reached, or may not or did not follow.
    """
    if not plugging.allowed:
        raise WireError(f"nothing moves at {plugging.path} without --yes")
    courier = Courier(rig, Port(plugging.path), plugging.settings)

    def follow(_: Rig) -> None:
        courier.deliver()
        if courier.fault:
            raise WireError(courier.fault)

    try:
        yield follow
        courier.finish()
        if courier.fault:
            raise WireError(courier.fault)
    finally:
        courier.close()
