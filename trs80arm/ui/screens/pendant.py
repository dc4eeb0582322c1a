"""The teach pendant on the screen: arm, points, buttons, and what is typed into the machine."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import hypot
from pathlib import Path
from typing import ClassVar, Protocol

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.widgets import OptionList, Static

from trs80arm.desk.jogging import Coordinates
from trs80arm.desk.pendant import Pendant
from trs80arm.desk.reach import Reach
from trs80arm.desk.teach import Position
from trs80arm.drawing.readings import Kind, Readings, Thing
from trs80arm.options import ArmStyle
from trs80arm.ui.keys.jog_keyboard import JogKeyboard
from trs80arm.ui.panels.jog_pad import JogPad
from trs80arm.ui.panels.key_line import KeyHint, KeyLine
from trs80arm.ui.panels.side_view import SideView
from trs80arm.ui.panels.top_view import TopView
from trs80arm.ui.screens.dialog import LineDialog
from trs80arm.ui.screens.edit_point import AskSpeed, EditPoint
from trs80arm.ui.screens.jog_dialog import JogDialog
from trs80arm.ui.screens.lists import RowList
from trs80arm.ui.screens.taught_program import ProgramScreen, TeachResult

TALL = 34
"""Rows from which on more of what was typed is seen."""
PARTS_SHOWN = 2
"""How many parts are told of, the nearest first."""
_HEADING = " point    hand    x    y    z"
HINTS = (
    KeyHint("A", "add point", "screen.add"),
    KeyHint("Enter", "go there", "screen.go"),
    KeyHint("F", "next", "screen.step(1)"),
    KeyHint("B", "back", "screen.step(-1)"),
    KeyHint("P", "play all", "screen.play"),
    KeyHint("C", "close", "screen.close_hand"),
    KeyHint("O", "open", "screen.open_hand"),
    KeyHint("J", "axes", "screen.coordinates"),
    KeyHint(", .", "step", "screen.size(1)"),
    KeyHint("- +", "speed", "screen.speed(1)"),
    KeyHint("L", "listing", "screen.program"),
    KeyHint("K", "parts back", "screen.parts"),
    KeyHint("Space", "stop", "screen.stop"),
    KeyHint("Esc", "leave", "screen.cancel"),
    KeyHint("S", "set again", "screen.again"),
    KeyHint("N", "name", "screen.edit"),
    KeyHint("H", "hold", "screen.grip"),
    KeyHint("X", "delete", "screen.remove"),
    KeyHint("[ ]", "order", "screen.shift(1)"),
    KeyHint("D", "delay", "screen.delay"),
    KeyHint("U", "round", "screen.round"),
    KeyHint("0", "end @SET", "screen.end_set"),
)
"""The pendant's keys, those that one needs first before the others."""


class Override(Protocol):
    """The speed override: how fast the machine's time goes."""

    @property
    def speed_text(self) -> str:
        """As it is now."""

    def other_speed(self, by: int) -> None:
        """Faster or slower."""


@dataclass(frozen=True)
class Means:
    """What the pendant is given to work with.

    Attributes:
        pendant: what it shows.
        keyboard: its keys.
        look: reads the rig.
        override: how fast time goes.
        refill: puts the parts back.
        folder: where programs are written unless the user names another folder.
        reach: which files can be named.
        style: how the arm is drawn.
    """

    pendant: Pendant
    keyboard: JogKeyboard
    look: Callable[[], Readings]
    override: Override
    refill: Callable[[], None]
    folder: Path
    reach: Reach
    style: ArmStyle = ArmStyle.ASCII


class PendantScreen(JogDialog[TeachResult]):
    """The pendant.

    Args:
        means: what it works with.
    """

    AUTO_FOCUS = "OptionList"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("a", "add", "Add a point"),
        Binding("s", "again", "Set the point again"),
        Binding("n", "edit", "Name, comment, registers"),
        Binding("h", "grip", "The hand holds here, or not"),
        Binding("x,delete", "remove", "Delete the point"),
        Binding("left_square_bracket", "shift(-1)", "Earlier"),
        Binding("right_square_bracket", "shift(1)", "Later"),
        Binding("enter,g", "go", "Go to the point", priority=True),
        Binding("f", "step(1)", "Next point"),
        Binding("b", "step(-1)", "Point before"),
        Binding("p", "play", "Play all points"),
        Binding("u", "round", "Once, or round and round"),
        Binding("c", "close_hand", "Close the hand"),
        Binding("o", "open_hand", "Open the hand"),
        Binding("j", "coordinates", "World, tool, joint"),
        Binding("comma", "size(-1)", "Finer steps"),
        Binding("full_stop", "size(1)", "Coarser steps"),
        Binding("minus", "speed(-1)", "Slower"),
        Binding("plus,equals_sign", "speed(1)", "Faster"),
        Binding("d", "delay", "D of @STEP"),
        Binding("l", "program", "Listing"),
        Binding("k", "parts", "Parts back"),
        Binding("space", "stop", "Stop", priority=True),
        Binding("0", "end_set", "End @SET"),
        Binding("f1", "app.do('help')", "Help"),
    ]
    DEFAULT_CSS = """
    PendantScreen .points { width: 35; height: 100%; border-left: solid $frame; }
    PendantScreen .points OptionList {
        height: 1fr; text-wrap: nowrap; text-overflow: clip; padding: 0;
    }
    PendantScreen .parts { height: auto; max-height: 3; color: $text-warning; }
    PendantScreen JogPad { height: 4; }
    PendantScreen .state { height: 1; color: $text-muted; text-wrap: nowrap; }
    PendantScreen .sent { height: 2; }
    PendantScreen .message { height: 2; color: $text-accent; }
    PendantScreen KeyLine { height: 3; }
    PendantScreen.tall .sent { height: 8; }
    """
    HELP = """
## The teach pendant

Move the arm with the keys of manual mode, `1` to `6` and `Q` to `Y`, or with the mouse on the
buttons: a press is a step, and as long as it is held steps follow. `J` chooses what they go along:
the world (X, Y, Z, pitch, roll), the tool (along the hand, across it, off its back) or the joints.
`,` and `.` choose how far a step goes, `-` and `+` how fast time passes, from 5 % to flat out; `D`
is the D of each `@STEP`. `C` closes the hand until it grips, `O` opens it to a width.

`A` adds a point where the arm is. Enter goes to the one that is marked, `F` to the next, `B` back
to the one before, hand and all; `P` plays them all once (`U`: round and round), and says first if
one cannot be reached. `S` sets a point again, `N` names it and has room for a comment, `H` says
whether the hand holds there, `X` deletes it, `[` and `]` put it elsewhere. `L` is the program of
them, in the style of Table 3 or 4, to be written, loaded, or read back.

All that the pendant does it types into the TRS-80, and shows it. Space stops; a program that runs
gets BREAK.
"""

    def __init__(self, means: Means) -> None:
        super().__init__(means)
        self._means = means
        self._pendant = means.pendant
        self._shown: tuple[tuple[Position, ...], int | None] | None = None
        self._width = 1.5

    def compose(self) -> ComposeResult:
        """Views and points, buttons, and what is said and typed."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Teach pendant"
            with Horizontal(classes="views"):
                yield SideView()
                yield TopView()
                with Vertical(classes="points"):
                    yield Static(_HEADING, classes="hint", markup=False)
                    yield RowList(markup=False)
                    yield Static("", classes="parts", markup=False)
            yield JogPad(lambda: self._pendant.coordinates, lambda: self._means.keyboard.down)
            yield Static("", classes="state", markup=False)
            yield Static("", classes="sent", markup=False)
            yield Static("", classes="message", markup=False)
            yield KeyLine(HINTS)

    def on_resize(self, event: events.Resize) -> None:
        """More of what was typed in a taller window."""
        self.set_class(event.size.height >= TALL, "tall")

    def hands_off(self) -> None:
        """Let every key go, those of the pendant too."""
        super().hands_off()
        self._pendant.let_go()

    def show_rest(self, readings: Readings) -> None:
        """Buttons, points, parts, and what is said and typed."""
        self.query_one(JogPad).show(readings)
        self._show_points()
        self._show_words()
        self.say(".parts", "\n".join(part_texts(readings)), layout=True)

    def _show_points(self) -> None:
        pendant, options = self._pendant, self.query_one(OptionList)
        positions = tuple(pendant.lesson.positions)
        if pendant.place is None or pendant.place >= len(positions):
            pendant.mark(len(positions) - 1)
        if (positions, pendant.place) == self._shown:
            return
        self._shown = positions, pendant.place
        texts = [
            point_text(position, marked=place == pendant.place)
            for place, position in enumerate(positions)
        ]
        if len(texts) == options.option_count:
            for place, text in enumerate(texts):
                options.replace_option_prompt_at_index(place, text)
        else:
            options.clear_options()
            options.add_options(texts)
        options.highlighted = pendant.place

    def _show_words(self) -> None:
        pendant = self._pendant
        size = pendant.size
        if pendant.coordinates is Coordinates.JOINT:
            step = f"{size.half_steps} half-steps"
        else:
            step = f"{size.inches:g} in, {size.degrees:g}°"
        manner = pendant.manner
        once = "round and round" if manner.repeats else "once"
        self.say(
            ".state",
            f"Step {step}   Speed {self._means.override.speed_text}   D {manner.speed}   "
            f"Plays {once}   Keys: {self._means.keyboard.keyboard.in_use.value}",
        )
        sent = self.query_one(".sent", Static)
        lines = [f">{line}" for line in list(pendant.sent)[-max(1, sent.size.height) :]]
        self.say(".sent", "\n".join(lines) or "What the pendant types into the TRS-80 stands here.")
        self.say(".message", " ".join(filter(None, (pendant.message, pendant.hint))))

    # -- points -----------------------------------------------------------------------------------

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        """Another point is marked."""
        if event.option_list.highlighted is not None:
            self._pendant.mark(event.option_list.highlighted)
            self._show_points()

    def action_add(self) -> None:
        """Add a point where the arm is, behind the marked one."""
        self._pendant.teach()
        self.show()

    def action_again(self) -> None:
        """Have the marked point be where the arm is."""
        self._pendant.teach_again()
        self.show()

    def action_grip(self) -> None:
        """The hand holds at the marked point, or not."""
        self._pendant.switch_grip()
        self.show()

    def action_remove(self) -> None:
        """Delete the marked point."""
        self._pendant.remove()
        self.show()

    def action_shift(self, by: int) -> None:
        """Put the marked point earlier or later."""
        self._pendant.shift(by)
        self.show()

    def action_edit(self) -> None:
        """Name, comment, registers, hand and speed of the marked point."""
        place = self._pendant.place
        if place is None:
            return
        lesson = self._pendant.lesson

        def edited(position: Position) -> None:
            if place < len(lesson):
                lesson.put(place, position)
                self.show()

        hand = self._means.look().model.hand
        self.open(EditPoint(lesson.positions[place], hand.pound_steps), edited)

    # -- what moves -------------------------------------------------------------------------------

    def action_go(self) -> None:
        """Go to the marked point."""
        if self._pendant.place is not None:
            self._pendant.go_to(self._pendant.place)

    def action_step(self, by: int) -> None:
        """Go to the next point, or back to the one before."""
        self._pendant.step(by)

    def action_play(self) -> None:
        """Go through all points."""
        self._pendant.run()

    def action_close_hand(self) -> None:
        """Close the hand until it grips."""
        self._pendant.close()

    def action_open_hand(self) -> None:
        """Open the hand to a width."""

        def chosen(width: float) -> None:
            self._width = width
            self._pendant.open_to(width)

        self.open(AskWidth(self._width, self._means.look().model.hand.range), chosen)

    def action_stop(self) -> None:
        """Stop."""
        self._means.keyboard.keyboard.let_go()
        self._pendant.stop()
        self.show()

    def action_cancel(self) -> None:
        """Stop what moves; else leave."""
        self._means.keyboard.keyboard.let_go()
        if self._pendant.busy:
            self._pendant.stop()
        else:
            self.dismiss(None)

    def action_end_set(self) -> None:
        """Press the key that ends `@SET`."""
        self._pendant.end_set()

    # -- how it moves -----------------------------------------------------------------------------

    def action_coordinates(self) -> None:
        """World, tool, joint."""
        self._pendant.next_coordinates()
        self.show()

    def action_size(self, by: int) -> None:
        """Coarser steps, or finer ones."""
        self._pendant.other_size(by)
        self.show()

    def action_speed(self, by: int) -> None:
        """Faster or slower."""
        self._means.override.other_speed(by)
        self.show()

    def action_round(self) -> None:
        """Once, or round and round."""
        self._pendant.switch_repeats()
        self.show()

    def action_delay(self) -> None:
        """Ask for the D of the steps."""

        def chosen(speed: int) -> None:
            self._pendant.use_delay(speed)
            self.show()

        self.open(AskSpeed(self._pendant.manner.speed), chosen)

    def action_parts(self) -> None:
        """Put the parts back to where they were at the start."""
        self._means.refill()
        self._pendant.message = "The parts are back where they were at the start."
        self.show()

    def action_program(self) -> None:
        """The program of the points."""
        self.open(ProgramScreen(self._pendant, self._means.folder, self._means.reach), self.dismiss)


class AskWidth(LineDialog[float]):
    """Asks how wide the hand shall be.

    Args:
        width: proposed, inches.
        most: the widest.
    """

    def __init__(self, width: float, most: float) -> None:
        super().__init__("Open the hand", f"Inches, 0 to {most:g}.", f"{width:g}", "number")
        self._most = most

    def answer(self, text: str) -> float:
        """The width, if the hand opens so wide."""
        try:
            width = float(text)
        except ValueError:
            width = -1.0
        if not 0 <= width <= self._most:
            raise ValueError(f"A number from 0 to {self._most:g}.")
        return width


def part_texts(readings: Readings) -> list[str]:
    """Where the parts are that are nearest to the fingertip; none of them while one is held."""
    if readings.held is not None:
        return [f"{readings.held:14.14} in the hand"]
    pose = readings.pose

    def distance(part: Thing) -> float:
        x, y, z = part.box.center
        return hypot(x - pose.x, y - pose.y, z - pose.z)

    parts = sorted((t for t in readings.things if t.kind is Kind.PART), key=distance)
    return [_line(part.name, part.box.center) for part in parts[:PARTS_SHOWN]]


def _line(what: str, place: Sequence[float]) -> str:
    return f"{what:14.14}{''.join(f'{round(value, 1) + 0.0:5.1f}' for value in place)}"


def point_text(position: Position, *, marked: bool = False) -> str:
    """A line of the list; the one that is marked says so without colour, too."""
    hand = "hold" if position.grips else "open"
    pose = position.pose
    mark = ">" if marked else " "
    where = _line(f"{mark}{position.name:8.8} {hand}", (pose.x, pose.y, pose.z))
    return f"{where}  {position.comment}"
