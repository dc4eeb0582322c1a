"""The TeachMover's own teach pendant on the screen: arm, memory, joint and function keys."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.widgets import Static

from trs80arm.desk.base_pendant import BasePendant
from trs80arm.drawing.readings import Readings
from trs80arm.options import ArmStyle
from trs80arm.serial.pendant_keys import FunctionKey
from trs80arm.ui.keys.jog_keyboard import JogKeyboard
from trs80arm.ui.panels.joint_pad import JointPad
from trs80arm.ui.panels.key_line import KeyHint, KeyLine
from trs80arm.ui.panels.side_view import SideView
from trs80arm.ui.panels.top_view import TopView
from trs80arm.ui.screens.jog_dialog import JogDialog

KEYS = {
    FunctionKey.TRAIN: "a",
    FunctionKey.MOVE: "m",
    FunctionKey.FREE: "f",
    FunctionKey.GRIP: "g",
    FunctionKey.OUT: "o",
    FunctionKey.PAUSE: "p",
    FunctionKey.JUMP: "j",
    FunctionKey.POINT: "i",
    FunctionKey.STEP: "s",
    FunctionKey.RUN: "u",
    FunctionKey.SPEED: "v",
    FunctionKey.ZERO: "z",
    FunctionKey.CLEAR: "x",
    FunctionKey.STOP: "space",
}
"""Which of today's keys is which function key; 1 to 6 and Q to Y are the joint keys."""
HINTS = (
    *(
        KeyHint(key.capitalize(), function.name, f"screen.push('{function.name}')")
        for function, key in KEYS.items()
    ),
    KeyHint("0-9 Enter", "a number", "screen.answer('RUN')"),
    KeyHint("Esc", "leave", "screen.cancel"),
)


@dataclass(frozen=True)
class Means:
    """What the screen is given to work with.

    Attributes:
        pendant: what it shows.
        keyboard: its joint keys.
        look: reads the rig.
        style: how the arm is drawn.
    """

    pendant: BasePendant
    keyboard: JogKeyboard
    look: Callable[[], Readings]
    style: ArmStyle = ArmStyle.ASCII


class BasePendantScreen(JogDialog[None]):
    """The pendant.

    Args:
        means: what it works with.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        *(
            Binding(key, f"push('{function.name}')", function.name, priority=key == "space")
            for function, key in KEYS.items()
        ),
        Binding("enter", "answer('RUN')", "Take the number", priority=True),
        Binding("backspace", "answer('CLEAR')", "Forget the digits"),
        Binding("f1", "app.do('help')", "Help"),
    ]
    DEFAULT_CSS = """
    BasePendantScreen .program {
        width: 38; height: 100%; border-left: solid $frame; text-wrap: nowrap;
        text-overflow: clip;
    }
    BasePendantScreen JointPad { height: 4; }
    BasePendantScreen .state { height: 1; color: $text-muted; text-wrap: nowrap; }
    BasePendantScreen .message { height: 1; color: $text-accent; text-wrap: nowrap; }
    BasePendantScreen KeyLine { height: 2; }
    """
    HELP = """
## The TeachMover's teach pendant

`M` (MOVE) and `A` (TRAIN) have the joint keys move the arm: `1` to `6` and `Q` to `Y`, or the mouse
on the buttons, as long as they are held. In TRAIN, `A` again records where the arm is as the next
step, and GRIP, OUT, PAUSE and JUMP are recorded, too. `S` does the step at the pointer, `U` (RUN)
runs the program round and round; Space is STOP. `I` (POINT) sets the pointer, `V` the speed.

A key that wants a number says which: type it, Enter takes it, Backspace forgets it, Space leaves
it. A jump wants a step and a condition: 0 always, 1 to 3 an input that answers, 4 the grip switch.

`F` takes the current from the motors, `Z` makes here the place that registers count from, `X` and
Enter clear the memory. What is in it `@QDUMP` gives and `@RUN` runs.
"""

    def __init__(self, means: Means) -> None:
        super().__init__(means)
        self._pendant = means.pendant

    def compose(self) -> ComposeResult:
        """Views and memory, buttons, and what the pendant says."""
        with Vertical(classes="dialog") as box:
            box.border_title = "TeachMover's teach pendant"
            with Horizontal(classes="views"):
                yield SideView()
                yield TopView()
                yield Static("", classes="program", markup=False)
            yield JointPad(lambda: self._pendant.down)
            yield Static("", classes="state", markup=False)
            yield Static("", classes="message", markup=False)
            yield KeyLine(HINTS)

    def on_unmount(self) -> None:
        """Left: all hands off."""
        self.hands_off()

    def hands_off(self) -> None:
        """Let every key go, those of the pendant too."""
        super().hands_off()
        self._pendant.let_go()

    def show_rest(self, readings: Readings) -> None:
        """Buttons, memory, and what the pendant says."""
        self.query_one(JointPad).show(readings)
        program = self.query_one(".program", Static)
        lines = self._pendant.program(max(1, program.size.height))
        self.say(".program", "\n".join(lines))
        self.say(".state", self._pendant.state)
        self.say(".message", self._pendant.message)

    # -- keys and buttons -------------------------------------------------------------------------

    def on_key(self, event: events.Key) -> None:
        """A digit of a number."""
        if self._takes(event.character):
            event.stop()
            event.prevent_default()

    def _takes(self, character: str | None) -> bool:
        """Whether a key is a digit that the pendant asks for; it has it then."""
        if not (self._pendant.asks and character and character in "0123456789"):
            return False
        self._pendant.type_digit(character)
        self.show()
        return True

    def went_down(self, base: str, name: str, text: str | None) -> None:
        """A key went down; while digits are asked for it moves nothing."""
        if not self._pendant.asks:
            super().went_down(base, name, text)

    def action_push(self, name: str) -> None:
        """A function key."""
        self._pendant.push(FunctionKey[name])
        self.show()

    def action_answer(self, name: str) -> None:
        """A function key that answers what the pendant asks for, and does nothing else."""
        if self._pendant.asks:
            self.action_push(name)

    def action_cancel(self) -> None:
        """Stop what moves; else leave."""
        if self._pendant.busy or self._pendant.asks:
            self.action_push(FunctionKey.STOP.name)
        else:
            self.dismiss(None)
