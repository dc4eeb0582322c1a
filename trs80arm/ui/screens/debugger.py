"""The dialog of the debugger: listing, variables, loops and subroutines, memory.

On a small screen it has all of it, and a key lets one look at the machine behind; on a large one it
stands beside the tube. What it does is the desk's `Debugger`'s.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import ClassVar

from rich.text import Text
from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.message import Message
from textual.widgets import OptionList, Static

from trs80arm import inspection
from trs80arm.desk.debugger import Condition, Debugger, Reason
from trs80arm.desk.memory_view import ROW, parse_address, poke_statement, row_text
from trs80arm.desk.states import QUICK, States
from trs80arm.inspection import line_text
from trs80arm.machine.video import COLUMNS
from trs80arm.shown import shown
from trs80arm.ui.screens.ask_line import AskLine
from trs80arm.ui.screens.dialog import Dialog
from trs80arm.ui.screens.keys_line import KeysLine
from trs80arm.ui.screens.lists import RowList
from trs80arm.ui.screens.states import StatesScreen

BESIDE = 116
"""Columns of a terminal from which on the debugger stands beside the tube."""
AHEAD = 6
"""Lines that are seen behind the one where the machine stands."""
MOST_ELEMENTS = 256
"""Elements of an array that are listed."""
VIDEO = 0x3C00
"""The address whose memory is shown first: the tube's."""
MEMORY_ROWS = 32
"""Rows of memory that are listed."""
WATCH, WATCH_HINT = "Stop behind a change of", "I, B$(2), latch base or 3C00H; again: no more."
_TUBE_FRAME = 2
_MARKS = 2
"""Cells before a line's number: for a breakpoint, and for the line that is next."""
_GUTTER = 4
"""Cells that a list leaves free on both sides and for its scroll bar, whether there is one."""
_LEAST_ROOM = 10
"""Cells below which statements do not stand beside their number."""


class Leaving(Enum):
    """How one leaves the debugger."""

    GO = "go"
    """The machine goes on."""
    STAND = "stand"
    """It goes on standing, if it stood."""


class Listing(RowList):
    """The lines of the program."""

    class Resized(Message):
        """There is more room for them, or less."""

    def on_resize(self) -> None:
        """Say so."""
        self.post_message(self.Resized())


class DebuggerScreen(Dialog[Leaving]):
    """Shows where the machine stands, and moves it.

    Args:
        debugger: what moves it.
        states: the saved states.
        quick_save: saves the machine under the quick name.
        load: loads a saved state.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "cancel", "Close", show=False),
        Binding("f7,s", "walk('into')", "Step", key_display="F7"),
        Binding("o,f8", "walk('over')", "Over", key_display="o"),
        Binding("u,f9", "walk('out')", "Out", key_display="u"),
        Binding("b,backspace", "back", "Back", key_display="b"),
        Binding("r", "rewind", "Rewind"),
        Binding("g,f6,f5", "go", "Go", key_display="g"),
        Binding("t", "run_to", "To"),
        Binding("space", "breakpoint", "Stop", key_display="Space"),
        Binding("i", "condition", "If", show=False),
        Binding("enter", "change", "Change", priority=True, show=False),
        Binding("l", "let", "Let"),
        Binding("m", "memory", "Mem"),
        Binding("a", "address", "Address", show=False),
        Binding("p", "poke", "Poke", show=False),
        Binding("c", "clear", "Clear all", show=False),
        Binding("e", "watch", "Watch", show=False),
        Binding("w", "states", "States", show=False),
        Binding("v", "behind", "View", show=False),
        Binding("shift+f3,ctrl+f3,f15", "quick_save", show=False),
        Binding("shift+f2,ctrl+f2,f14", "quick_load", show=False),
        Binding("f1,question_mark", "app.do('help')", "Help", key_display="F1"),
        Binding("right", "app.focus_next", show=False),
        Binding("left", "app.focus_previous", show=False),
    ]
    DEFAULT_CSS = """
    DebuggerScreen { align: right top; background: transparent; }
    DebuggerScreen > .dialog { width: 100%; max-width: 100%; max-height: 100%; height: 1fr; }
    DebuggerScreen > .beside { margin-bottom: 1; }
    DebuggerScreen #where { height: auto; max-height: 3; text-style: bold; }
    DebuggerScreen #parts { height: 1fr; }
    DebuggerScreen #parts.stacked { layout: vertical; }
    DebuggerScreen #listing {
        width: 1fr; height: 1fr; max-height: 100%; border-right: solid $frame;
    }
    DebuggerScreen #listing:focus { border-right: solid $title; }
    DebuggerScreen #looks { width: 34; height: 1fr; }
    DebuggerScreen .remembers #looks { width: 45; }
    DebuggerScreen .stacked #listing { width: 100%; height: 3fr; border-right: none; }
    DebuggerScreen .stacked #looks { width: 100%; height: 2fr; border-top: solid $frame; }
    DebuggerScreen #looks OptionList {
        height: 1fr; max-height: 100%; text-wrap: nowrap; text-overflow: ellipsis;
    }
    DebuggerScreen #memory { display: none; }
    DebuggerScreen .remembers #memory { display: block; }
    DebuggerScreen .remembers #variables { display: none; }
    DebuggerScreen #stack { height: auto; max-height: 6; color: $text-muted; }
    DebuggerScreen .wrong { max-height: 2; }
    """
    HELP = """
## The debugger

It stops a program before a statement. `F7` does one statement, `O` one with all of a GOSUB, `U`
goes on until the subroutine has returned, `T` to the line that is marked, `G` lets it go. `B` goes
one statement back in time, `R` back to the breakpoint before: arm, bench, tube and clock as they
were. Forward again is the same run, until something is done differently.

`Space` sets a breakpoint at the marked line or takes it off, `I` gives it a condition. `E` keeps an
eye on a variable, a latch or an address, and stops behind each change; again, and no more. `C`
clears all. Left and Right go from the listing to the variables; `Enter` changes the marked one, `L`
any, by an assignment that the machine checks as it does a typed one. `M` shows memory instead, `A`
goes to an address, `Enter` or `P` POKEs. `W` lists the saved states, `Shift+F3` saves one quickly,
`Shift+F2` loads it. `V` shows the machine behind, `Escape` closes the debugger; the machine goes
on standing.
"""

    def __init__(
        self,
        debugger: Debugger,
        states: States,
        quick_save: Callable[[], None],
        load: Callable[[str], None],
    ) -> None:
        super().__init__()
        self._debugger = debugger
        self._states = states
        self._quick_save = quick_save
        self._load = load
        self._lines: list[int] = []
        self._names: list[str] = []
        self._rows: dict[OptionList, list[Text]] = {}
        self._wide = 0
        self._address = VIDEO

    def compose(self) -> ComposeResult:
        """Where it stands, the listing, what is in memory, the keys."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Debugger"
            yield Static("", id="where", markup=False)
            with Horizontal(id="parts"):
                yield Listing(id="listing", markup=False)
                with Vertical(id="looks"):
                    yield RowList(id="variables", markup=False)
                    yield RowList(id="memory", markup=False)
                    yield Static("", id="stack", markup=False)
            yield Static("", classes="wrong", markup=False)
        yield KeysLine()

    def on_mount(self) -> None:
        """Show where the machine stands."""
        self._arrange(self.app.size.width)
        self.show_all()
        self._listing.focus()

    def on_resize(self, event: events.Resize) -> None:
        """Beside the tube where there is room for both."""
        self._arrange(event.size.width)

    def on_listing_resized(self) -> None:
        """Break its lines anew."""
        width = self._listing.size.width
        if width != self._wide:
            self._wide = width
            self._show_listing()

    def _arrange(self, width: int) -> None:
        beside = width >= BESIDE
        room = width - COLUMNS - _TUBE_FRAME
        box = self.query_one(".dialog")
        box.styles.width = room if beside else "100%"
        box.set_class(beside, "beside")
        self.query_one("#parts").set_class(beside and room < 90, "stacked")

    @property
    def _listing(self) -> OptionList:
        return self.query_one("#listing", OptionList)

    @property
    def _variables(self) -> OptionList:
        return self.query_one("#variables", OptionList)

    @property
    def _memory(self) -> OptionList:
        return self.query_one("#memory", OptionList)

    # -- what is shown ----------------------------------------------------------------------------

    def show_all(self, wrong: str = "") -> None:
        """Show everything as it is now."""
        self._debugger.new_stop()
        self.query_one(".wrong", Static).update(shown(wrong))
        self._show_where()
        self._show_listing()
        self._show_variables()
        self._show_memory()
        frames = inspection.open_frames(self._debugger.rig)
        self.query_one("#stack", Static).update(
            "\n".join(["Open loops and subroutines:", *frames[:4]]) if frames else ""
        )

    def _show_where(self) -> None:
        debugger = self._debugger
        stop, rig = debugger.stop, debugger.rig
        if stop is not None:
            said = stop.text
        elif (spot := debugger.spot) is not None:
            said = f"Under way: {spot}"
        else:
            said = "No program runs. Space: a breakpoint. F7: stop before the first statement."
        self.query_one("#where", Static).update(shown(said))
        past = "in the past, " if debugger.session.timeline.behind else ""
        box = self.query_one(".dialog")
        box.border_subtitle = f"{past}T-state {rig.clock.now}, {rig.time:.3f} s"

    def _show_listing(self) -> None:
        rig, debugger = self._debugger.rig, self._debugger
        spot = debugger.spot
        lines = rig.basic.program.lines()
        old, self._lines = self._lines, [number for number, _ in lines]
        marked = self._marked_line(old)
        prompts = [self._row(line, spot) for line in lines]
        listing = self._listing
        self._fill(listing, prompts or [Text("No program in memory.")])
        if debugger.stop is not None and spot is not None and spot.line in self._lines:
            listing.highlighted = self._lines.index(spot.line)
        elif marked in self._lines:
            listing.highlighted = self._lines.index(marked)
        elif prompts:
            listing.highlighted = 0
        self.call_after_refresh(self._scroll_listing)

    def _scroll_listing(self) -> None:
        """Let the marked line be seen, with some lines behind it."""
        listing = self._listing
        place = listing.highlighted
        if place is not None:
            with self.prevent(OptionList.OptionHighlighted):
                listing.highlighted = min(place + AHEAD, listing.option_count - 1)
                listing.highlighted = place

    def _row(self, line: inspection.Line, spot: inspection.Spot | None) -> Text:
        """A line of the listing: its breakpoint, whether it is next, and which statement is."""
        number, _ = line
        text = Text(shown(line_text(line)))
        here = spot is not None and spot.line == number
        if here and spot is not None:
            ended = self._debugger.stop and self._debugger.stop.reason is Reason.ENDED
            text.stylize("bold" if ended else "bold reverse", spot.start, spot.stop)
        breakpoints = self._debugger.breakpoints
        mark = " "
        if number in breakpoints:
            mark = "*" if breakpoints[number] is None else "?"
        marks = Text.assemble((mark, "bold red"), (">" if here else " ", "bold"))
        return marks + self._hanging(text, len(str(number)) + 1)

    def _hanging(self, text: Text, begin: int) -> Text:
        """A line whose statements go on below themselves where they do not fit beside it."""
        margin = begin + _MARKS
        room = self._listing.size.width - margin - _GUTTER
        if room < _LEAST_ROOM:
            return text
        number, statements = text.divide([begin])
        lines = statements.wrap(self.app.console, room)
        return number + Text("\n" + " " * margin).join(lines)

    def _marked_line(self, lines: list[int]) -> int | None:
        place = self._listing.highlighted
        return None if place is None or place >= len(lines) else lines[place]

    def _show_variables(self) -> None:
        watched = self._debugger.watches
        found = list(inspection.elements(self._debugger.rig, MOST_ELEMENTS))
        held = {variable.name for variable in found}
        others = [each for name, each in watched.items() if name not in held]
        names = [*(each.name for each in others), *(variable.name for variable in found)]
        rows = [f"* {each.name} {each.value}" for each in others]
        rows += [
            f"{'*' if each.name in watched else ' '} {each.name:<8}{shown(each.value)}"
            for each in found
        ]
        options = self._variables
        self._fill(options, [Text(row) for row in rows] or [Text("No variables.")])
        self._names = names

    def _show_memory(self) -> None:
        peek = self._debugger.rig.memory.peek
        options = self._memory
        if not self.query_one("#parts").has_class("remembers"):
            return
        rows = [row_text(peek, self._address + ROW * row) for row in range(MEMORY_ROWS)]
        self._fill(options, [Text(row) for row in rows])

    def _fill(self, options: OptionList, rows: list[Text]) -> None:
        """Show these rows; of as many as before only those that differ, and the mark stays."""
        before = self._rows.get(options, [])
        self._rows[options] = rows
        if len(before) == len(rows):
            for place, row in enumerate(rows):
                if row != before[place]:
                    options.replace_option_prompt_at_index(place, row)
            return
        place = options.highlighted or 0
        options.clear_options()
        options.add_options(rows)
        options.highlighted = min(place, len(rows) - 1)

    # -- moving -----------------------------------------------------------------------------------

    def action_walk(self, how: str) -> None:
        """One statement, over, or out."""
        self._walk(getattr(self._debugger, how))

    def action_run_to(self) -> None:
        """On to the marked line."""
        line = self._marked_line(self._lines)
        if line is not None:
            self._walk(lambda: self._debugger.run_to(line))

    def _walk(self, step: Callable[[], None]) -> None:
        """Go on; while that takes longer, or the operator is wanted, the machine is to be seen."""
        try:
            step()
        except ValueError as error:
            self.show_all(str(error.args[0]).capitalize() + ".")
            return
        if self._debugger.stop is None:
            self.dismiss(Leaving.GO)
        else:
            self.show_all()

    def action_back(self) -> None:
        """One statement back."""
        found = self._debugger.back()
        self.show_all("" if found else "Nothing is known of an earlier statement.")

    def action_rewind(self) -> None:
        """Back to the breakpoint before."""
        found = self._debugger.back_to_stop()
        self.show_all("" if found else "Nothing is known of an earlier breakpoint.")

    def action_go(self) -> None:
        """Let the machine go on."""
        self._debugger.go()
        self.dismiss(Leaving.GO)

    def action_cancel(self) -> None:
        """Close the debugger; the machine goes on standing."""
        self.dismiss(Leaving.STAND)

    # -- breakpoints ------------------------------------------------------------------------------

    def action_breakpoint(self) -> None:
        """A breakpoint at the marked line, or none any more."""
        line = self._marked_line(self._lines)
        if line is not None:
            self._debugger.toggle(line)
            self.show_listing_again(line)

    def show_listing_again(self, line: int) -> None:
        """Show the listing, and leave the mark at a line."""
        self._show_listing()
        if line in self._lines:
            self._listing.highlighted = self._lines.index(line)

    def action_condition(self) -> None:
        """Ask when to stop at the marked line."""
        line = self._marked_line(self._lines)
        if line is None:
            return
        breakpoints = self._debugger.breakpoints
        now = breakpoints.get(line)

        def take(text: str) -> None:
            self._debugger.set(line, text)
            self.show_listing_again(line)

        hint = 'As I>10, A$="X" or B(2)<=C; nothing stops always.'
        text = now.text if isinstance(now, Condition) else ""
        self.open(AskLine(f"Stop before {line} if", hint, text, take))

    def action_watch(self) -> None:
        """Ask what to keep an eye on, or to let alone."""

        def take(text: str) -> None:
            self._debugger.toggle_watch(text)
            self._show_variables()

        place = self._variables.highlighted or 0
        marked = self.focused is self._variables and place < len(self._names)
        self.open(AskLine(WATCH, WATCH_HINT, self._names[place] if marked else "", take))

    def action_clear(self) -> None:
        """No breakpoints and no watches any more."""
        self._debugger.clear()
        self._show_variables()
        line = self._marked_line(self._lines)
        self.show_listing_again(line if line is not None else -1)

    # -- changing ---------------------------------------------------------------------------------

    def action_change(self) -> None:
        """Change the marked variable, or memory; in the listing: a breakpoint."""
        if self.focused is self._variables:
            place = self._variables.highlighted
            if place is not None and place < len(self._names):
                name = self._names[place]
                if not inspection.is_name(name):
                    return
                self._ask_change(f"{name}={inspection.value_text(self._debugger.rig, name)}")
        elif self.focused is self._memory:
            self.action_poke()
        else:
            self.action_breakpoint()

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """A row was clicked: what Enter does there."""
        self.action_change()

    def action_let(self) -> None:
        """Ask for an assignment."""
        self._ask_change("")

    def _ask_change(self, proposal: str) -> None:
        def take(text: str) -> None:
            self._debugger.rig.change(text)
            self.show_all()

        hint = 'An assignment, as A=5 or B$(2)="X"; checked as the machine does.'
        self.open(AskLine("Change", hint, proposal, take))

    def action_memory(self) -> None:
        """Memory instead of the variables, and back."""
        parts = self.query_one("#parts")
        parts.toggle_class("remembers")
        self._show_memory()
        # The listing has another width now, and so other rows.
        self.call_after_refresh(self.call_after_refresh, self._scroll_listing)
        (self._memory if parts.has_class("remembers") else self._variables).focus()

    def action_address(self) -> None:
        """Ask for the address that is shown."""

        def take(text: str) -> None:
            self._address = parse_address(text)
            self.query_one("#parts").add_class("remembers")
            self._show_memory()
            self._memory.highlighted = 0
            self._memory.focus()

        self.open(AskLine("Address", "As 15360 or 3C00H.", "", take))

    def action_poke(self) -> None:
        """Ask for an address and a value."""

        def take(text: str) -> None:
            self._debugger.rig.change(poke_statement(text))
            self.show_all()

        address = self._address + ROW * (self._memory.highlighted or 0)
        hint = "An address and a value, as 3C00H,65."
        self.open(AskLine("POKE", hint, f"{address % 0x10000:04X}H,", take))

    # -- the rest ---------------------------------------------------------------------------------

    def action_states(self) -> None:
        """Save, load, remove saved states."""

        def chosen(name: str | None) -> None:
            if name is not None:
                self._load(name)
            self.show_all()

        self.app.push_screen(StatesScreen(self._states, self._debugger.session), chosen)

    def action_quick_save(self) -> None:
        """Save the machine quickly."""
        self._quick_save()

    def action_quick_load(self) -> None:
        """Load the machine that was saved quickly."""
        self._load(QUICK)
        self.show_all()

    def action_behind(self) -> None:
        """Look at the machine behind, until a key is pressed."""
        self.query_one(".dialog").display = False

    def on_key(self, event: events.Key) -> None:
        """The key after a look at the machine brings the debugger back."""
        box = self.query_one(".dialog")
        if not box.display:
            event.stop()
            event.prevent_default()
            box.display = True
            self._listing.focus()
