"""The commands that work machine and arm: run, BREAK, speed, steps, bench, hands, teaching."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from trs80arm.arm.bench import BenchError
from trs80arm.arm.geometry import OutOfReach
from trs80arm.arm.minimover import InTheWay, MotorsOn
from trs80arm.bundled import programs_folder
from trs80arm.machine.keys import Key
from trs80arm.options import KeyMode, Speed
from trs80arm.ui.commands.files import FileCommands
from trs80arm.ui.screens.dialog import Choice, Choose
from trs80arm.ui.screens.hand_move import HandMoveScreen, MoveJoint, MoveTo
from trs80arm.ui.screens.key_test import KeyTest
from trs80arm.ui.screens.teach import TeachResult, TeachScreen
from trs80arm.ui.terminal.messages import KeyWentDown, KeyWentUp

SPEED_NOTES = {
    Speed.ONE: "as the machine was",
    Speed.TWO: "twice as fast",
    Speed.FIVE: "five times as fast",
    Speed.TWENTY: "twenty times as fast",
    Speed.FLAT_OUT: "as fast as this computer can; it waits for you at speed 1",
}
STANDARD_BENCH = "table"


class MachineCommands(FileCommands):
    """Run, BREAK, pause, steps, speed, reset; bench, hands and teaching; the keys' mode."""

    def action_run_program(self) -> None:
        """Type RUN, stopping what runs first."""
        self.session.ready()
        self.session.rig.type("RUN\r")
        self._go_on()

    def action_break_program(self) -> None:
        """Press BREAK."""
        self._go_on()
        self.keyboard.tap(Key.BREAK)

    def _go_on(self) -> None:
        if self.pacer.paused:
            self.pacer.pause(False)
            self.say("Going on.")

    def action_pause(self) -> None:
        """Stop the machine's clock, or let it go on."""
        self.pacer.pause(not self.pacer.paused)
        paused = self.pacer.paused
        self.say("Paused: F6 goes on, F7 does one statement." if paused else "Going on.")

    def action_step_statement(self) -> None:
        """Pause, and do one statement of BASIC."""
        self.pacer.pause(True)
        number = self.session.step_statement()
        self.say("No program runs." if number is None else f"Next: line {number}")
        self.pacer.forgive()

    def action_step_motor(self) -> None:
        """Pause, and let the motors do one step."""
        self.pacer.pause(True)
        moved = self.session.step_motor()
        self.say("One motor step." if moved else "No motor moved within a second.")
        self.pacer.forgive()

    def action_speed(self) -> None:
        """Choose the speed."""
        choices = [Choice(speed.value, _speed_word(speed), SPEED_NOTES[speed]) for speed in Speed]
        now = next(speed for speed in Speed if speed.factor == self.pacer.speed)
        self.push_screen(Choose("Speed", choices, now.value), self._chosen_speed)

    def _chosen_speed(self, value: str | None) -> None:
        if value is not None:
            self.action_set_speed(value)

    def action_set_speed(self, value: str) -> None:
        """Go at a speed."""
        speed = Speed(value)
        self.pacer.set_speed(speed.factor)
        self.say(f"Speed {_speed_word(speed)}.")

    def action_reset(self) -> None:
        """Switch the machine off and on, asking when a program would be lost."""
        self.if_program_may_go("Off and on", self._reset)

    def _reset(self) -> None:
        self.session.reset()
        self.keyboard.held.start_afresh()
        self.pacer.pause(False)
        self.say("Switched off and on.")

    # -- bench and arm ----------------------------------------------------------------------------

    def action_bench(self) -> None:
        """Choose a bench."""
        choices = [Choice("", STANDARD_BENCH, "a table and one part at (8, 0)")]
        for path in self._benches():
            choices.append(Choice(str(path), path.stem, str(path.parent)))
        standing = self.session.bench_path
        now = str(standing.resolve()) if standing else ""
        self.push_screen(Choose("Bench", choices, now), self._chosen_bench)

    def _benches(self) -> list[Path]:
        folders = {Path.cwd(), programs_folder()}
        if self.session.path is not None:
            folders.add(self.session.path.resolve().parent)
        found = {
            path.resolve()
            for folder in folders
            if folder is not None
            for path in (*folder.glob("*.toml"), *folder.glob("benches/*.toml"))
            if path.name != "pyproject.toml"
        }
        return sorted(found)

    def _chosen_bench(self, value: str | None) -> None:
        if value is not None:
            self.set_up_bench(Path(value) if value else None)

    def set_up_bench(self, path: Path | None) -> None:
        """Clear the table and set up a bench, or say why not."""
        try:
            self.session.set_bench(path)
        except BenchError as error:
            self.say(str(error), error=True)
        else:
            self.say(f"Bench: {path.stem if path else STANDARD_BENCH}.")

    def action_refill(self) -> None:
        """Put the parts back."""
        self.session.rig.refill()
        self.say("The parts are back where they were at the start.")

    def action_hand_move(self) -> None:
        """Move the arm by hand."""
        self.push_screen(HandMoveScreen(self.look, braille=self.side.braille))

    def on_move_joint(self, message: MoveJoint) -> None:
        """Turn a joint by hand, or say why not."""
        self._by_hand(lambda: self.session.move_joint(message.joint, message.value))

    def on_move_to(self, message: MoveTo) -> None:
        """Put the hand somewhere, or say why not."""
        self._by_hand(lambda: self.session.move_to(message.pose))

    def _by_hand(self, move: Callable[[], None]) -> None:
        try:
            move()
        except (MotorsOn, InTheWay, OutOfReach, ValueError) as error:
            text = str(error)
        else:
            text = ""
        if isinstance(self.screen, HandMoveScreen):
            self.screen.say(text)

    def action_teach(self) -> None:
        """The list of positions."""
        folder = self.session.path.parent if self.session.path else Path.cwd()
        self.push_screen(TeachScreen(self.lesson, self.look, folder), self._taught)

    def _taught(self, result: TeachResult | None) -> None:
        if result is not None and result.listing is not None:
            listing = result.listing

            def load() -> None:
                self.load_listing(listing)
                self.lesson.written()

            self.if_program_may_go("Load the lesson", load)

    def action_teach_here(self) -> None:
        """Add where the arm is to the lesson."""
        self.lesson.add(self.look())
        self.say(f"Position {len(self.lesson)} is taught: F12 lists them.")

    # -- keys -------------------------------------------------------------------------------------

    def action_latch(self) -> None:
        """Latch mode on, or back to what the terminal can do."""
        self.keyboard.let_go()
        latch = self.keyboard.mode is not KeyMode.LATCH
        usual = self.options.keys if self.options.keys is not KeyMode.LATCH else KeyMode.AUTO
        self.keyboard.mode = KeyMode.LATCH if latch else usual
        self.say(
            "Latch: in @SET a press turns a key on, the next one off; Space lets all go."
            if latch
            else f"Keys: {self.keyboard.in_use.value}."
        )

    def action_key_test(self) -> None:
        """What the terminal tells."""
        keyboard = self.keyboard
        self.push_screen(KeyTest(keyboard.in_use, reports=keyboard.reports_releases))

    def on_key_went_down(self, message: KeyWentDown) -> None:
        """A press: the key test sees it, too."""
        if isinstance(self.screen, KeyTest):
            self.screen.went_down(message.base, message.name, message.text)

    def on_key_went_up(self, message: KeyWentUp) -> None:
        """A release."""
        if isinstance(self.screen, KeyTest):
            self.screen.went_up(message.base)


def _speed_word(speed: Speed) -> str:
    return "flat out" if speed is Speed.FLAT_OUT else speed.value
