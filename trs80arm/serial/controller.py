"""The TeachMover's own computer: what comes over the serial line moves the arm.

It stands in the base of the arm, where the interface card is on its bus: it alone drives the card,
with ARMBASIC's routines for coordinated motion, and keeps the registers. It takes one command after
the other. Nothing here knows a wall clock or a port: bytes come in at a T-state, and answers go out
at one.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any, TypeAlias

from trs80arm.machine.card import MOTORS, Card, Latch
from trs80arm.machine.clock import T_STATES_PER_SECOND, Clock
from trs80arm.machine.coordination import Pace
from trs80arm.machine.driver import Driver, DriverSettings, Mode
from trs80arm.machine.half_steps import COILS_OFF
from trs80arm.machine.keyboard import Matrix
from trs80arm.progress import Progress
from trs80arm.pulses import Columns
from trs80arm.serial import protocol
from trs80arm.serial.instructions import Condition
from trs80arm.serial.lines import LONGEST, Lines
from trs80arm.serial.memory import TeachMemory
from trs80arm.serial.pendant import Pendant
from trs80arm.serial.pendant_keys import FunctionKey, JointKey, PendantKey, directions
from trs80arm.serial.protocol import (
    DONE,
    FASTEST,
    LONGEST_DELAY,
    REFUSED,
    STOPPED,
    Command,
    can_delimit,
)
from trs80arm.serial.speeds import delay_of
from trs80arm.serial.tasks import Manual, Motion, Playing, Task

Listener: TypeAlias = Callable[[bytes], None]
"""Told each answer when its last character has gone out."""

WAITING = 64
"""Lines that wait at most; what comes beyond is refused, each line in its turn. Chosen."""
CHARACTER = 10 * T_STATES_PER_SECOND // 9600
"""T-states of a character at 9600 baud, 8 bits, a start and a stop bit."""
_MILLISECOND = T_STATES_PER_SECOND / 1000
_ANSWERED = {Progress.DONE: DONE, Progress.BREAK: STOPPED}


class Controller:
    """A computer in the base of an arm, at the end of a serial line.

    Args:
        now: T-states at which it is switched on.
        card: the interface card that it drives.
        settings: of the routines that move the arm.
        hand_per_elbow: half-steps that the hand is given with each one of the elbow's.

    Attributes:
        clock: how far it has come; never beyond the rig's clock.
        card: the card that it drives.
        driver: the routines that move the arm, and the six registers K1 to K6.
        memory: the program that the pendant teaches.
        delimiter: what commands begin with.
        delay: milliseconds of rest after each character of an answer.
        speed: SP of the pendant's motions.
        last_key: code of the function key that was pressed last, 0 for none.
        held: the pendant's joint keys that are down.
        pendant: what its function keys do.
        listeners: told every answer; they are not part of a snapshot.
    """

    def __init__(self, now: int, card: Card, settings: DriverSettings, hand_per_elbow: int) -> None:
        self.clock = Clock()
        self.clock.now = now
        self.card = card
        self.driver = Driver(self.clock, card, Matrix(), settings, hand_per_elbow)
        self.memory = TeachMemory()
        self.delimiter = protocol.DELIMITER
        self.delay = 0
        self.speed = protocol.USUAL_SPEED
        self.last_key = 0
        self.held: set[JointKey] = set()
        self.pendant = Pendant()
        self.listeners: list[Listener] = []
        self._stream = Lines()
        self._lines: deque[bytes] = deque()
        self._stopped = 0
        self._refused = 0
        self._task: Task | None = None
        self._answer = b""
        self._answered = 0

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "listeners": []}

    @property
    def possible(self) -> bool:
        """Whether it is as it can be: one from outside may not."""
        lines = all(type(line) is bytes and len(line) <= LONGEST for line in self._lines)
        return (
            lines
            and len(self._lines) <= WAITING
            and 0 <= self._stopped <= len(self._lines) + self._refused
            and self._refused >= 0
            and self._stream.possible
            and self.memory.possible
            and self.pendant.possible
            and can_delimit(self.delimiter)
            and 0 <= self.delay <= LONGEST_DELAY
            and 0 <= self.speed <= FASTEST
            and 0 <= self.last_key <= max(FunctionKey)
            and all(isinstance(key, JointKey) for key in self.held)
            and (self._task is None or isinstance(self._task, Motion | Playing))
        )

    # -- the line -----------------------------------------------------------------------------

    def receive(self, data: bytes) -> None:
        """Bytes have come over the line, now."""
        for line in self._stream.feed(data):
            if self._refused or len(self._lines) >= WAITING:
                self._refused += 1
            else:
                self._lines.append(line)

    def hang_up(self) -> None:
        """Nobody is at the other end any more: the arm stops, and what was asked is forgotten."""
        if self._task is not None:
            self._break_off()
        self._stream.clear()
        self._lines.clear()
        self._stopped = self._refused = 0
        self._answer = b""

    @property
    def room(self) -> int:
        """How many lines more can wait without being refused."""
        return 0 if self._refused else WAITING - len(self._lines)

    @property
    def busy(self) -> bool:
        """Whether it is at work: on a command, on an answer, or a line waits."""
        at_work = self._task or self.pendant.task
        return bool(at_work or self._answer or self._lines or self._refused)

    @property
    def works_alone(self) -> bool:
        """Whether it is at work, and nobody's hands are needed for it as in `@SET`."""
        return self.busy and self.driver.mode is not Mode.SET

    @property
    def doing(self) -> str:
        """The command under way, as `STEP`; empty for none."""
        task = self._task or self.pendant.task
        return task.word if task else ""

    # -- the pendant --------------------------------------------------------------------------

    def press(self, key: PendantKey) -> None:
        """A key of the pendant goes down.

        A function key ends `@SET`; the stop key breaks off whatever the arm does, and what waits on
        the line is answered as stopped. While the arm is at work on another command of the line
        the other keys do nothing; while it is not they are the `Pendant`'s.
        """
        if isinstance(key, JointKey):
            self.held.add(key)
            self._steer()
            if self._task is None:
                self.pendant.steer(self)
            return
        self.last_key = int(key)
        if key is FunctionKey.STOP:
            self.stop()
        elif self._task is None:
            self.pendant.press(key, self)
        elif isinstance(self.driver.motion, Manual):
            self._break_off()
            self._say(DONE)

    def release(self, key: PendantKey) -> None:
        """A key of the pendant goes up."""
        if isinstance(key, JointKey):
            self.held.discard(key)
            self._steer()
            if self._task is None:
                self.pendant.steer(self)

    def stop(self) -> None:
        """Break off what the arm does, with its coils left on, and all that waits."""
        self.pendant.stop(self)
        if self._task is not None:
            self._break_off()
            self._say(STOPPED)
        self._stopped = len(self._lines) + self._refused

    def _steer(self) -> None:
        motion = self.driver.motion
        if isinstance(motion, Manual):
            motion.directions = directions(self.held)

    def _break_off(self) -> None:
        self.driver.stop()
        self._task = None

    # -- its work -----------------------------------------------------------------------------

    def advance(self, time: int) -> None:
        """Work up to a T-state."""
        self.clock.limit = time
        while self._go_on():
            pass
        self.clock.now = max(self.clock.now, time)

    def _go_on(self) -> bool:
        """Carry on; whether there may be more to do before the limit."""
        if self._answer:
            return self._send()
        if self._task is not None:
            progress = self._task.advance(self)
            if progress is Progress.BUSY:
                return False
            self._task = None
            self._say(_ANSWERED[progress])
            return True
        if self.pendant.task is not None:
            return self.pendant.advance(self)
        if not (self._lines or self._refused):
            return False
        self._take()
        return True

    def _send(self) -> bool:
        """Let the answer go out; whether it has, before the limit."""
        if self._answered > self.clock.limit:
            return False
        self.clock.now = max(self.clock.now, self._answered)
        answer, self._answer = self._answer, b""
        for listener in self.listeners:
            listener(answer)
        return True

    def _say(self, answer: bytes) -> None:
        """Begin to send an answer; a character takes as long as its bits, and `@DELAY`."""
        each = CHARACTER + round(self.delay * _MILLISECOND)
        self._answer = answer
        self._answered = self.clock.now + len(answer) * each

    def _take(self) -> None:
        """Take the next line."""
        stopped = self._stopped > 0
        self._stopped = max(0, self._stopped - 1)
        if not self._lines:
            self._refused -= 1
            self._say(STOPPED if stopped else REFUSED)
            return
        line = self._lines.popleft()
        if stopped:
            self._say(STOPPED)
            return
        command = protocol.parse(line, self.delimiter)
        if command is None:
            self._say(REFUSED)
        else:
            self._begin(command)

    def _begin(self, command: Command) -> None:
        """Carry a command out, or begin to."""
        driver = self.driver
        match command:
            case protocol.Step(speed, steps, output):
                if output is not None:
                    self.put_out(output)
                driver.step(delay_of(speed), steps)
                self._task = Motion("STEP")
                return
            case protocol.Close(speed):
                driver.close(delay_of(speed))
                self._task = Motion("CLOSE")
                return
            case protocol.ByHand(speed):
                self.speed = speed
                self.begin_manual()
                self._task = Motion("SET")
                return
            case protocol.Run():
                self._task = Playing()
                return
            case protocol.Reset():
                driver.reset()
            case protocol.Read():
                self._say(protocol.reading(driver.read(), self.last_key, self.inputs))
                return
            case protocol.Dump():
                self._say(protocol.dump(self.memory))
                return
            case protocol.Write(row):
                self._say(DONE if self.memory.write(row) else REFUSED)
                return
            case protocol.Arm(delimiter):
                self.delimiter = delimiter
            case protocol.Delay(milliseconds):
                self.delay = milliseconds
        self._say(DONE)

    def begin_manual(self) -> None:
        """Let the pendant's joint keys move the arm, at `speed`, until the motion is stopped."""
        pace = Pace(self.clock.now, delay_of(self.speed))
        self.driver.begin(Manual(pace, directions(self.held)))

    def put_out(self, value: int) -> None:
        """OUT: the low four bits into the auxiliary latch, phi1 the highest."""
        self.card.burst(Columns((self.clock.now,), (Latch.AUXILIARY,), (value & 0xF,)))

    def free(self) -> None:
        """Take the current from the motors; the registers stay."""
        count = len(MOTORS)
        self.card.burst(Columns([self.clock.now] * count, MOTORS, [COILS_OFF] * count))

    def holds(self, condition: int) -> bool:
        """Whether a `Condition` holds now; an input is on when it is 0, as the switch closes it."""
        match condition:
            case Condition.ALWAYS:
                return True
            case Condition.GRIP:
                return self.card.grip_closed(self.clock.now)
            case Condition.INPUT_1 | Condition.INPUT_2 | Condition.INPUT_3:
                return not self.inputs >> condition & 1
        return False

    @property
    def inputs(self) -> int:
        """The input byte: the plug's nibble below four ones, bit 0 the grip switch, 0 closed."""
        return 0xF0 | self.card.plug.inputs(self.clock.now)
