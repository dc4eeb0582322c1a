"""The dialog with which the operator moves the arm by hand, while its motors are off.

It shows both views of the arm, and says why the arm does not go where it is wanted.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.events import Key
from textual.widgets import Input, Static

from trs80arm.desk.hands import MoveJoint, MoveTo, joint_values, typed_move
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import signed
from trs80arm.options import ArmStyle
from trs80arm.rig import TURNED_BY_HAND
from trs80arm.ui.panels.arm_view import ArmView
from trs80arm.ui.panels.side_view import SideView
from trs80arm.ui.panels.top_view import TopView
from trs80arm.ui.screens.dialog import Dialog

FRAMES_PER_SECOND = 15
_SHOWN = {"roll": "roll on arm"}
"""The wrist's own roll; the captions and poses count it with the base's turn taken out."""
NUDGE = {"hand": 0.1}
"""How far an arrow key moves, inches; all others go by one degree."""
_FIGURES = "0123456789.-"


class HandMoveScreen(Dialog[None]):
    """Moves the arm by hand, joint by joint or to a pose.

    Args:
        look: reads the rig.
        move: does a move, and says why not; an empty text is that it was made.
        style: how the arm is drawn.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "choose(-1)", "Joint", show=False),
        Binding("down", "choose(1)", "Joint", show=False),
        Binding("left", "nudge(-1)", "Less"),
        Binding("right", "nudge(1)", "More"),
        Binding("shift+left,pageup", "nudge(-10)", "Less x10", show=False),
        Binding("shift+right,pagedown", "nudge(10)", "More x10", show=False),
        Binding("home", "home", "Start"),
        Binding("tab", "to_entry", show=False),
        Binding("f1", "app.do('help')", "Help"),
    ]
    AUTO_FOCUS = ""
    DEFAULT_CSS = """
    HandMoveScreen > .dialog { width: 96; height: 26; max-height: 96%; }
    HandMoveScreen Horizontal { height: 1fr; }
    HandMoveScreen SideView { width: 3fr; height: 100%; }
    HandMoveScreen TopView { width: 2fr; height: 100%; }
    HandMoveScreen .below { height: 6; }
    HandMoveScreen .joints { height: 6; width: 25; }
    HandMoveScreen .entry { height: 6; width: 1fr; }
    """
    HELP = """
## Moving the arm by hand

With the motors off, before the first step or after `@RESET`, the arm turns freely. Choose a joint
with Up and Down and turn it with Left and Right, with Shift ten times as far; or type a value, or
a whole pose, and press Enter. Tab goes to the line to type in and back. Angles of upper arm,
forearm and hand are to the horizontal. With the motors on the arm does not give way; `@RESET` turns
them off.
"""

    def __init__(
        self,
        look: Callable[[], Readings],
        move: Callable[[MoveJoint | MoveTo], str],
        *,
        style: ArmStyle = ArmStyle.ASCII,
    ) -> None:
        super().__init__()
        self._look = look
        self._move = move
        self._style = style
        self._joint = 0

    def compose(self) -> ComposeResult:
        """The views, the joints, a line to type in, an answer."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Move the arm by hand"
            box.border_subtitle = "Arrows turn, Shift ten times as far, Escape goes back"
            with Horizontal():
                yield SideView()
                yield TopView()
            with Horizontal(classes="below"):
                yield Static("", classes="joints", markup=False)
                with Vertical(classes="entry"):
                    yield Static(
                        "Type a value for the joint marked, or a pose:\nx y z pitch roll hand",
                        classes="hint",
                        markup=False,
                    )
                    yield Input(placeholder="8 0 1.5 -90 0 0.5", select_on_focus=False)
                    yield Static("", classes="wrong", markup=False)

    def on_mount(self) -> None:
        """Look at the arm, again and again."""
        for view in self.query(ArmView):
            view.picture.style = self._style
        self.set_interval(1 / FRAMES_PER_SECOND, self._show)
        self.call_after_refresh(self._show)

    def on_key(self, event: Key) -> None:
        """Begin to type a value: a figure goes to the line at once."""
        entry = self.query_one(Input)
        # More keys may come before the line has the focus.
        expected = _FIGURES + " ," if entry.value else _FIGURES
        if not entry.has_focus and event.character and event.character in expected:
            entry.focus()
            entry.insert_text_at_cursor(event.character)
            event.stop()

    def action_to_entry(self) -> None:
        """To the line to type in, or back to the arrows."""
        entry = self.query_one(Input)
        self.set_focus(None if entry.has_focus else entry)

    def _do(self, move: MoveJoint | MoveTo) -> None:
        self._say(self._move(move))

    def _say(self, text: str) -> None:
        """Tell the operator what became of a move; an empty text is that it was made."""
        self.query_one(".wrong", Static).update(text)
        self._show()

    def _show(self) -> None:
        readings = self._look()
        self.query_one(SideView).show(readings)
        self.query_one(TopView).show(readings)
        lines = []
        for place, (joint, value) in enumerate(zip(TURNED_BY_HAND, _values(readings), strict=True)):
            mark = ">" if place == self._joint else " "
            unit = "in" if joint == "hand" else "°"
            digits = 2 if joint == "hand" else 1
            lines.append(f"{mark} {_SHOWN.get(joint, joint):11}{signed(value, digits):>7} {unit}")
        self.query_one(".joints", Static).update("\n".join(lines))
        if readings.motors_on:
            self.query_one(".wrong", Static).update("The motors are on: @RESET turns them off.")

    def action_choose(self, by: int) -> None:
        """Another joint."""
        self._joint = (self._joint + by) % len(TURNED_BY_HAND)
        self._show()

    def action_nudge(self, times: int) -> None:
        """Turn the joint a little."""
        joint = TURNED_BY_HAND[self._joint]
        readings = self._look()
        value = _values(readings)[self._joint] + times * NUDGE.get(joint, 1.0)
        if joint == "hand":
            value = min(max(value, 0.0), readings.model.hand.range)
        self._do(MoveJoint(joint, value))

    def action_home(self) -> None:
        """Put the arm where Table 4 wants it to begin."""
        self._do(MoveTo(self._look().model.start))

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Do what was typed."""
        event.stop()
        try:
            move = typed_move(event.value, TURNED_BY_HAND[self._joint], self._look().pose)
        except ValueError as error:
            self._say(str(error))
            return
        self._do(move)
        event.input.value = ""
        self.set_focus(None)


def _values(readings: Readings) -> tuple[float, ...]:
    return joint_values(readings.posture.angles, readings.posture.opening)
