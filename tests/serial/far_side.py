"""A TeachMover's registers at the other end of a wire, for tests: it believes all it is told."""

from __future__ import annotations

from collections.abc import Callable

from trs80arm import Rig, RigSettings
from trs80arm.arm import ArmSettings, benchfile
from trs80arm.serial.courier import Courier
from trs80arm.serial.limits import PlugSettings
from trs80arm.serial.wire import WireError

HIGH = "[arm]\nat = [9, 0, 9]\npitch = 0\nopening = 2\n"
"""A bare table, with the arm well above it."""
SLICE = 0.01
"""Virtual seconds between two looks of whoever takes the orders."""


class FarSide:
    """A wire with registers behind it.

    Attributes:
        heard: every line, without its CR.
        registers: that the lines add up to.
        closing: what a closing hand adds to its register.
        answer: gives the answer to a line instead, or None for the usual one.
        closed: whether the wire was let go of.
    """

    def __init__(self, registers: tuple[int, ...] = (0,) * 6) -> None:
        self.heard: list[str] = []
        self.registers = list(registers)
        self.closing = 0
        self.answer: Callable[[str], list[str] | None] = lambda line: None
        self.closed = False

    def send(self, line: bytes, answers: int, seconds: float) -> list[str]:
        text = line.decode("ascii")
        assert text.endswith("\r"), text
        text = text.strip()
        self.heard.append(text)
        own = self.answer(text)
        if own is not None:
            return own
        word, _, arguments = text.partition(" ")
        if word == "@STEP":
            counts = list(map(int, arguments.split(",")))[1:]
            self.registers = [old + new for old, new in zip(self.registers, counts, strict=True)]
        elif word == "@CLOSE":
            self.registers[5] += self.closing
        elif word == "@RESET":
            self.registers = [0] * 6
        elif word == "@READ":
            return ["1", ",".join(map(str, [*self.registers, 0]))]
        return ["1"]

    def close(self) -> None:
        self.closed = True

    @property
    def words(self) -> list[str]:
        return [line.split()[0] for line in self.heard]

    @property
    def steps(self) -> list[list[int]]:
        """The counts of each `@STEP`."""
        told = [line for line in self.heard if line.startswith("@STEP")]
        return [list(map(int, line.split()[1].split(",")))[1:] for line in told]


def nobody(line: str) -> list[str]:
    """The answer of a wire that is cut."""
    raise WireError("The wire to the arm is dead: cut.")


class Plugged:
    """A machine with a TeachMover, and another one on the wire."""

    def __init__(self, bench: str = HIGH, **settings: int) -> None:
        self.rig = Rig(RigSettings(arm=ArmSettings(model="teachmover")), benchfile.parse(bench))
        self.far = FarSide()
        self.courier = Courier(self.rig, self.far, PlugSettings(**settings))

    def do(self, *statements: str, seconds: float = 60.0) -> None:
        """Type statements, and have the arm on the wire follow until the machine has done them."""
        for statement in statements:
            self.rig.type(statement + "\r")
            self.wait(seconds)

    def wait(self, seconds: float = 60.0) -> None:
        """Until everything typed is done and the wire is quiet."""
        rig, end = self.rig, self.rig.time + seconds
        while rig.time < end and (rig.typing or rig.waiting.name != "COMMAND"):
            rig.run_for(SLICE)
            self.courier.deliver()
        self.courier.finish()
