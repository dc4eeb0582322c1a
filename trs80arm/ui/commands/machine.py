"""The commands of the machine: run, BREAK, pause, steps, speed, off and on, demonstration."""

from __future__ import annotations

from trs80arm.desk.asking import Asking, Choice, ListQuestion, Say
from trs80arm.desk.debugger import Debugger
from trs80arm.desk.files import SessionFiles
from trs80arm.desk.pacing import Pacer
from trs80arm.desk.session import Session
from trs80arm.desk.stage import Stage
from trs80arm.options import Speed
from trs80arm.rig import Key
from trs80arm.ui.keys.keyboard import Keyboard

SPEED_NOTES = {
    Speed.TWENTIETH: "slow motion, a twentieth",
    Speed.TENTH: "slow motion, a tenth",
    Speed.QUARTER: "slow motion, a quarter",
    Speed.HALF: "slow motion, half as fast",
    Speed.ONE: "as the machine was",
    Speed.TWO: "twice as fast",
    Speed.FIVE: "five times as fast",
    Speed.TWENTY: "twenty times as fast",
    Speed.FLAT_OUT: "as fast as this computer can; it waits for you at speed 1",
}


class MachineCommands:
    """Works the TRS-80.

    Args:
        session: the machine.
        debugger: what may have stopped it.
        pacer: how fast its time goes.
        keyboard: the operator's hands.
        files: asks before a program goes.
        stage: plays the demonstration.
        ask: a way to ask.
        say: a way to say something.
    """

    def __init__(
        self,
        session: Session,
        debugger: Debugger,
        pacer: Pacer,
        keyboard: Keyboard,
        files: SessionFiles,
        stage: Stage,
        ask: Asking,
        say: Say,
    ) -> None:
        self._session = session
        self._debugger = debugger
        self._pacer = pacer
        self._keyboard = keyboard
        self._files = files
        self._stage = stage
        self._ask = ask
        self._say = say

    def run(self) -> None:
        """Type RUN, stopping what runs first."""
        self._session.ready()
        self._session.rig.type("RUN\r")
        self.go_on()

    def press_break(self) -> None:
        """Press BREAK."""
        self.go_on()
        self._keyboard.tap(Key.BREAK)

    def go_on(self) -> None:
        """End a pause."""
        if self._debugger.stop is not None:
            self._debugger.go()
        if self._pacer.paused:
            self._pacer.pause(False)
            self._say("Going on.")

    def pause(self) -> None:
        """Stop the machine's clock, or let it go on."""
        if self._pacer.paused:
            self.go_on()
        else:
            self._pacer.pause(True)
            self._say("Paused: F6 goes on, F7 opens the debugger.")

    def step_motor(self) -> None:
        """Pause, and let the motors do one step."""
        self._pacer.pause(True)
        moved = self._session.step_motor()
        self._say("One motor step." if moved else "No motor moved within a second.")

    def choose_speed(self) -> None:
        """Choose the speed."""
        choices = tuple(
            Choice(speed.value, _speed_word(speed), SPEED_NOTES[speed]) for speed in Speed
        )
        question = ListQuestion("Speed", choices, self._speed.value)
        self._ask.choose(question, lambda value: self.set_speed(Speed(value)))

    @property
    def _speed(self) -> Speed:
        return next(speed for speed in Speed if speed.factor == self._pacer.speed)

    @property
    def speed_text(self) -> str:
        """The speed as the pendant's override says it."""
        return "paused" if self._pacer.paused else self._speed.percent

    def other_speed(self, by: int) -> None:
        """Go faster, or slower, by so many of the speeds that there are."""
        self.set_speed(self._speed.other(by))

    def set_speed(self, speed: Speed) -> None:
        """Go at a speed."""
        self._pacer.set_speed(speed.factor)
        self._say(f"Speed {_speed_word(speed)}.")

    def reset(self) -> None:
        """Switch the machine off and on, asking when a program would be lost."""
        self._files.if_program_may_go("Off and on", self._reset)

    def push_reset(self) -> None:
        """Push the button at the machine's back."""
        self._session.rig.push_reset()

    def _reset(self) -> None:
        self._session.reset()
        self._pacer.pause(False)
        self._say("Switched off and on.")

    def demo(self) -> None:
        """Play the demonstration."""
        self._files.if_program_may_go("Demonstration", self._stage.begin_demo)


def _speed_word(speed: Speed) -> str:
    return "flat out" if speed is Speed.FLAT_OUT else speed.value
