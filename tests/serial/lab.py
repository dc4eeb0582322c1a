"""A TeachMover with its computer, and somebody at the other end of its line."""

from __future__ import annotations

from trs80arm import Rig, RigSettings
from trs80arm.arm import benchfile
from trs80arm.arm.settings import ArmSettings
from trs80arm.serial.controller import Controller

SETTINGS = RigSettings(controller=True, arm=ArmSettings(model="teachmover"))
HIGH = "[arm]\nat = [9, 0, 9]\npitch = 0\nopening = 2\n"
"""A bare table, with the arm well above it."""
LONGEST = 600.0


class Line:
    """The other end of an arm's serial line.

    Attributes:
        rig: the machine; the arm stands high above a bare table.
        heard: every answer, with the T-state at which it was out.
    """

    def __init__(self, rig: Rig | None = None, bench: str = HIGH) -> None:
        self.rig = rig or Rig(SETTINGS, benchfile.parse(bench, "bench"))
        self.heard: list[tuple[int, bytes]] = []
        self.rig.watch_answers(
            lambda answer: self.heard.append((self.controller.clock.now, answer))
        )

    @property
    def controller(self) -> Controller:
        controller = self.rig.controller
        assert controller is not None
        return controller

    @property
    def answers(self) -> bytes:
        return b"".join(answer for _, answer in self.heard)

    def send(self, *lines: bytes) -> bytes:
        """Lines, each with its CR, sent at once; all that is answered to them."""
        before = len(self.heard)
        for line in lines:
            self.rig.receive(line)
        self.wait()
        return b"".join(answer for _, answer in self.heard[before:])

    def wait(self) -> None:
        """Until nothing is left to do."""
        done = self.rig.run_until(lambda rig: not self.controller.busy, LONGEST)
        assert done, "the arm is still at work"

    def read(self) -> list[int]:
        """The seven numbers of `@READ`."""
        status, numbers, rest = self.send(b"@READ\r").split(b"\r")
        assert (status, rest) == (b"1", b"")
        return [int(number) for number in numbers.split(b",")]
