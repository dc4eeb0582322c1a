"""The TeachMover's teach pendant: keys that move the arm, teach it a program, and have it run.

Known are the keys and their codes (`FunctionKey`), that there are pairs of keys for base, shoulder,
elbow, pitch, roll and grip, and that speed 3 makes 141 half-steps a second. What each key does in
which mode is what its name says and what the memory can hold; it is chosen, as no manual was at
hand, and `docs/teachmover-pendant.md` says so key by key.

Some keys want numbers. Meanwhile the keys are digits (`DIGITS`), CLEAR forgets what was typed, RUN
takes the number, STOP leaves it.
"""

from __future__ import annotations

from enum import Enum
from typing import Protocol

from trs80arm.progress import Progress
from trs80arm.serial.instructions import Close, Condition, Instruction, Jump, PutOut, Rest
from trs80arm.serial.memory import STEPS, Move
from trs80arm.serial.pendant_keys import FunctionKey, JointKey
from trs80arm.serial.speeds import delay_of, speed_of
from trs80arm.serial.tasks import At, Motion, Playing, Task

STEPS_A_SECOND = 47
"""Half-steps a second of speed 1; speed 3 is known to make 141."""
FASTEST = 9
"""The greatest speed, chosen: one digit."""
AT_WORK = "the arm is at work: wait, or STOP"
"""Said of a key that does nothing for now."""
_BASE, _PER_UNIT = 1.2, 0.03
"""A tick takes 1.2 + 0.03 D milliseconds."""
_LONGEST = 3
DIGITS: dict[FunctionKey, int] = {
    FunctionKey.ZERO: 0,
    FunctionKey.TRAIN: 1,
    FunctionKey.PAUSE: 2,
    FunctionKey.GRIP: 3,
    FunctionKey.OUT: 4,
    FunctionKey.FREE: 5,
    FunctionKey.MOVE: 6,
    FunctionKey.STEP: 7,
    FunctionKey.POINT: 8,
    FunctionKey.JUMP: 9,
}
"""What keys are digits while a number is asked for: ZERO, and the others in the order of their
codes, without the stop key, which always stops."""


class PendantMode(Enum):
    """What the joint keys do."""

    OFF = "off"
    """Nothing."""
    TRAIN = "train"
    """They move the arm, and what is done is taught."""
    MOVE = "move"
    """They move the arm, and nothing is taught."""


class Base(At, Protocol):
    """The computer in the arm's base, as its pendant has it."""

    held: set[JointKey]

    def begin_manual(self) -> None:
        """Let the joint keys that are held move the arm."""

    def free(self) -> None:
        """Take the current from the motors."""


_ASKED: dict[FunctionKey, tuple[tuple[str, int, int], ...]] = {
    FunctionKey.SPEED: (("speed", 0, FASTEST),),
    FunctionKey.PAUSE: (("seconds", 0, 255),),
    FunctionKey.OUT: (("output bits", 0, 15),),
    FunctionKey.POINT: (("step", 1, STEPS),),
    FunctionKey.JUMP: (("step", 1, STEPS), ("condition", 0, max(Condition))),
    FunctionKey.CLEAR: (),
}
"""What keys ask for before they do anything: numbers, each with the least and the greatest."""


class Pendant:
    """What the function keys do.

    Attributes:
        mode: what the joint keys do.
        pointer: the step that is next, 1 to 53; 54 behind the last one.
        asks: the key whose numbers are being typed; None while none are.
        numbers: those that were taken.
        digits: of the one that is being typed.
        task: what the pendant has the arm do, if anything.
        note: what there is to say of the last key, in a few words.
    """

    def __init__(self) -> None:
        self.mode = PendantMode.OFF
        self.pointer = 1
        self.asks: FunctionKey | None = None
        self.numbers: list[int] = []
        self.digits = ""
        self.task: Task | None = None
        self.note = ""

    @property
    def possible(self) -> bool:
        """Whether it is as it can be: one from outside may not."""
        asked = () if self.asks is None else _ASKED.get(self.asks)
        return (
            asked is not None
            and 1 <= self.pointer <= STEPS + 1
            and all(type(number) is int for number in self.numbers)
            and (self.asks is None or len(self.numbers) <= len(asked))
            and (not self.digits or (self.digits.isdecimal() and self.digits.isascii()))
            and len(self.digits) <= _LONGEST
            and (self.task is None or isinstance(self.task, Motion | Playing))
        )

    @property
    def wanted(self) -> str:
        """What is asked for now, as `step, 1 to 53`; empty if nothing is."""
        if self.asks is None:
            return ""
        wanted = _ASKED[self.asks][len(self.numbers) :]
        if not wanted:
            return "RUN clears the memory"
        name, least, most = wanted[0]
        return f"{name}, {least} to {most}"

    # -- keys ---------------------------------------------------------------------------------

    def steer(self, base: Base) -> None:
        """Joint keys went down or up."""
        if self.mode is PendantMode.OFF:
            return
        if base.held and self.task is None and self.asks is None:
            base.begin_manual()
            self.task = Motion("MOVE")
        elif not base.held and self._by_hand:
            base.driver.stop()
            self.task = None

    @property
    def _by_hand(self) -> bool:
        """Whether the joint keys move the arm now."""
        return isinstance(self.task, Motion) and self.task.word == "MOVE"

    def press(self, key: FunctionKey, base: Base) -> None:
        """A function key went down.

        Joint keys that are still held move nothing any more. While the arm is at work numbers can
        be typed, and nothing is done.
        """
        self.note = ""
        if self._by_hand:
            base.driver.stop()
            self.task = None
        if self.asks is not None:
            self._type(key, base)
        elif key in _ASKED and not isinstance(self.task, Playing):
            self.asks, self.numbers, self.digits = key, [], ""
        elif self.task is not None:
            self.note = AT_WORK
        else:
            self._do(key, base)

    def stop(self, base: At) -> None:
        """The stop key: the arm stands, no number is asked for, the joint keys move nothing."""
        if isinstance(self.task, Playing):
            self.pointer = max(1, self.task.number)
        if self.task is not None:
            base.driver.stop()
        self.task = self.asks = None
        self.mode = PendantMode.OFF
        self.note = ""

    def _do(self, key: FunctionKey, base: Base) -> None:
        """What a key does that asks for nothing."""
        match key:
            case FunctionKey.TRAIN if self.mode is PendantMode.TRAIN:
                self._teach(Move(base.speed, base.driver.registers), base)
            case FunctionKey.TRAIN:
                self.mode = PendantMode.TRAIN
            case FunctionKey.MOVE:
                self.mode = PendantMode.MOVE
            case FunctionKey.FREE:
                self.mode = PendantMode.OFF
                base.free()
            case FunctionKey.ZERO:
                base.driver.zero()
            case FunctionKey.GRIP:
                if self._learns(Close(), base):
                    base.driver.close(delay_of(base.speed))
                    self.task = Motion("GRIP")
            case FunctionKey.STEP:
                self._play(base, once=True)
            case FunctionKey.RUN:
                self.mode = PendantMode.OFF
                self._play(base, once=False)

    def _play(self, base: Base, *, once: bool) -> None:
        if not len(base.memory):
            self.note = "the memory is empty"
            return
        last = max(base.memory.rows)
        self.pointer = 1 if self.pointer > last else self.pointer
        self.task = Playing(self.pointer - 1, once=once, again=not once)

    # -- numbers ------------------------------------------------------------------------------

    def _type(self, key: FunctionKey, base: Base) -> None:
        """A key while numbers are asked for."""
        asked = self.asks
        if asked is None:
            return
        if key is FunctionKey.RUN:
            self._take(asked, base)
        elif key is FunctionKey.CLEAR:
            self.digits = ""
        elif key in DIGITS:
            self.digits = f"{self.digits}{DIGITS[key]}"[-_LONGEST:]

    def _take(self, asked: FunctionKey, base: Base) -> None:
        """The number is typed."""
        if self.task is not None:
            self.note = AT_WORK
            return
        wanted = _ASKED[asked][len(self.numbers) :]
        if wanted:
            name, least, most = wanted[0]
            number = int(self.digits or 0)
            self.digits = ""
            if not least <= number <= most:
                self.asks = None
                self.note = f"{name}: {least} to {most}, not {number}"
                return
            self.numbers.append(number)
        if len(self.numbers) == len(_ASKED[asked]):
            self.asks = None
            self._do_with(asked, self.numbers, base)

    def _do_with(self, key: FunctionKey, numbers: list[int], base: Base) -> None:
        """What a key does with the numbers that it asked for."""
        match key, numbers:
            case FunctionKey.SPEED, [speed]:
                base.speed = sp_of(speed)
            case FunctionKey.PAUSE, [seconds]:
                self._learns(Rest(seconds), base)
            case FunctionKey.OUT, [value]:
                if self._learns(PutOut(value), base):
                    base.put_out(value)
            case FunctionKey.POINT, [step]:
                self.pointer = step
            case FunctionKey.JUMP, [step, condition]:
                self._learns(Jump(step, condition), base)
            case FunctionKey.CLEAR, []:
                base.memory.clear()
                self.pointer = 1

    # -- teaching -----------------------------------------------------------------------------

    def _learns(self, instruction: Instruction, base: Base) -> bool:
        """Teach something if that is the mode; whether it may be done now."""
        return self.mode is not PendantMode.TRAIN or self._teach(instruction, base)

    def _teach(self, instruction: Instruction, base: Base) -> bool:
        """Put an instruction at the pointer; whether there is room."""
        if self.pointer > STEPS:
            self.note = "the memory is full"
            return False
        base.memory.write(instruction.row(self.pointer))
        self.note = f"step {self.pointer}"
        self.pointer += 1
        return True

    # -- its work -----------------------------------------------------------------------------

    def advance(self, base: Base) -> bool:
        """Carry on with what it has the arm do; whether it came to an end before the limit."""
        task = self.task
        if task is None:
            return False
        progress = task.advance(base)
        if isinstance(task, Playing):
            self.pointer = max(1, task.number)
        if progress is Progress.BUSY:
            return False
        if isinstance(task, Playing):
            self.pointer = task.number + 1
        self.task = None
        return True


def sp_of(speed: int) -> int:
    """SP of a speed of the pendant, 0 to 9: so many times 47 half-steps a second."""
    if speed == 0:
        return 0
    return speed_of(round((1000 / (STEPS_A_SECOND * speed) - _BASE) / _PER_UNIT))
