"""The dialog of the processor: registers, instructions, stack and memory; steps and breakpoints.

It is the debugger's page for machine code, as large and in the same place. What it does is the
desk's `CodeDebugger`'s.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from rich.text import Text
from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.widgets import OptionList, Static

from trs80arm.desk.code_debugger import CodeDebugger
from trs80arm.desk.debugger import Reason
from trs80arm.desk.memory_view import ROW, parse_address, row_text
from trs80arm.machine.video import COLUMNS
from trs80arm.shown import shown
from trs80arm.ui.screens.ask_line import AskLine
from trs80arm.ui.screens.debugger import BESIDE, Leaving
from trs80arm.ui.screens.dialog import Dialog
from trs80arm.ui.screens.keys_line import KeysLine
from trs80arm.ui.screens.lists import RowList

INSTRUCTIONS = 64
"""Instructions that are listed."""
MEMORY_ROWS = 32
"""Rows of memory that are listed."""
STACK_WORDS = 6
_FRAME = 2


class ProcessorScreen(Dialog[Leaving]):
    """Shows where the processor stands, and moves it.

    Args:
        code: what moves it.
    """

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "cancel", "Close", show=False),
        Binding("f7,s", "walk('into')", "Step", key_display="F7"),
        Binding("o,f8", "walk('over')", "Over", key_display="o"),
        Binding("u,f9", "walk('out')", "Out", key_display="u"),
        Binding("t", "run_to", "To"),
        Binding("g,f6,f5", "go", "Go", key_display="g"),
        Binding("space", "breakpoint", "Stop", key_display="Space"),
        Binding("c", "clear", "Clear all", show=False),
        Binding("a", "address", "Address"),
        Binding("m", "memory", "Mem"),
        Binding("p", "here", "PC"),
        Binding("f1,question_mark", "app.do('help')", "Help", key_display="F1"),
        Binding("right", "app.focus_next", show=False),
        Binding("left", "app.focus_previous", show=False),
    ]
    DEFAULT_CSS = """
    ProcessorScreen { align: right top; background: transparent; }
    ProcessorScreen > .dialog { width: 100%; max-width: 100%; max-height: 100%; height: 1fr; }
    ProcessorScreen > .beside { margin-bottom: 1; }
    ProcessorScreen #where { height: auto; max-height: 3; text-style: bold; }
    ProcessorScreen #registers { height: 4; }
    ProcessorScreen #stack { height: 1; color: $text-muted; }
    ProcessorScreen #parts { height: 1fr; }
    ProcessorScreen #parts.stacked { layout: vertical; }
    ProcessorScreen #code { width: 1fr; height: 1fr; max-height: 100%; text-wrap: nowrap; }
    ProcessorScreen #memory { width: 43; height: 1fr; max-height: 100%; text-wrap: nowrap; }
    ProcessorScreen .stacked #code { width: 100%; height: 3fr; }
    ProcessorScreen .stacked #memory { width: 100%; height: 2fr; border-top: solid $frame; }
    """
    HELP = """
## The processor

Registers, instructions from where the processor stands, the words on top of the stack, memory.
`F7` does one instruction, `O` one with all of a CALL or a repetition, `U` goes on until the
subroutine has returned, `T` to the instruction that is marked, `G` lets it go. `Space` sets a
breakpoint at the marked instruction or takes it off, `C` clears all. `A` lists from another
address, `P` from where the processor stands, `M` shows memory from an address on. Code runs where
USR and SYSTEM lead to it; a step waits for its first instruction. `Escape` closes the page; the
machine goes on standing.
"""

    def __init__(self, code: CodeDebugger) -> None:
        super().__init__()
        self._code = code
        self._first = code.pc
        self._addresses: list[int] = []
        self._memory_from = code.rig.processor.registers.hl

    def compose(self) -> ComposeResult:
        """Where it stands, registers, stack, instructions, memory, the keys."""
        with Vertical(classes="dialog") as box:
            box.border_title = "Processor"
            yield Static("", id="where", markup=False)
            yield Static("", id="registers", markup=False)
            yield Static("", id="stack", markup=False)
            with Horizontal(id="parts"):
                yield RowList(id="code", markup=False)
                yield RowList(id="memory", markup=False)
        yield KeysLine()

    def on_mount(self) -> None:
        """Show where the processor stands."""
        self._arrange(self.app.size.width)
        self.show_all()
        self._list.focus()

    def on_resize(self, event: events.Resize) -> None:
        """Beside the tube where there is room for both."""
        self._arrange(event.size.width)

    def _arrange(self, width: int) -> None:
        beside = width >= BESIDE
        room = width - COLUMNS - _FRAME
        box = self.query_one(".dialog")
        box.styles.width = room if beside else "100%"
        box.set_class(beside, "beside")
        self.query_one("#parts").set_class(beside and room < 90, "stacked")

    @property
    def _list(self) -> OptionList:
        return self.query_one("#code", OptionList)

    # -- what is shown ----------------------------------------------------------------------------

    def show_all(self, wrong: str = "") -> None:
        """Show everything as it is now."""
        code, debugger = self._code, self._code.debugger
        debugger.new_stop()
        stop = debugger.stop
        if wrong:
            said = wrong
        elif missing := code.rig.processor.missing:
            said = f"{missing[:1].upper()}{missing[1:]}."
        elif stop is not None and stop.reason is Reason.CODE:
            said = stop.text
        else:
            said = "No code stands here: F7 stops before the next instruction that is executed."
        self.query_one("#where", Static).update(shown(said))
        self.query_one("#registers", Static).update("\n".join(code.registers()))
        words = "  ".join(f"{word:04X}" for word in code.stack(STACK_WORDS))
        self.query_one("#stack", Static).update(f"stack  {words}")
        self.query_one(".dialog").border_subtitle = f"T-state {code.rig.clock.now}"
        if code.pc not in self._addresses[:-8]:
            self._first = code.pc
        self._show_code(code.pc)
        self._show_memory()

    def _show_code(self, mark: int) -> None:
        found = self._code.listing(self._first, INSTRUCTIONS)
        self._addresses = [each.address for each in found]
        options = self._list
        options.clear_options()
        options.add_options([self._row(self._code.row(each)) for each in found])
        options.highlighted = self._addresses.index(mark) if mark in self._addresses else 0

    def _row(self, row: str) -> Text:
        text = Text(row)
        text.stylize("bold red", 0, 1)
        if row[1] == ">":
            text.stylize("bold reverse", 2)
        return text

    def _show_memory(self) -> None:
        peek = self._code.rig.memory.peek
        options = self.query_one("#memory", OptionList)
        rows = [row_text(peek, self._memory_from + ROW * row) for row in range(MEMORY_ROWS)]
        place = options.highlighted or 0
        options.clear_options()
        options.add_options([Text(row) for row in rows])
        options.highlighted = place

    # -- moving -----------------------------------------------------------------------------------

    def action_walk(self, how: str) -> None:
        """One instruction, over, or out."""
        self._walk(getattr(self._code, how))

    def action_run_to(self) -> None:
        """On to the marked instruction."""
        marked = self._marked
        self._walk(lambda: self._code.run_to(marked))

    def _walk(self, step: Callable[[], None]) -> None:
        """Go on; while that takes longer the machine is to be seen."""
        if self._code.rig.processor.missing:
            self.show_all()
            return
        step()
        if self._code.debugger.stop is None:
            self.dismiss(Leaving.GO)
        else:
            self.show_all()

    def action_go(self) -> None:
        """Let the machine go on."""
        self._code.go()
        self.dismiss(Leaving.GO)

    def action_cancel(self) -> None:
        """Close the page; the machine goes on standing."""
        self.dismiss(Leaving.STAND)

    @property
    def _marked(self) -> int:
        return self._addresses[self._list.highlighted or 0]

    # -- breakpoints and places -------------------------------------------------------------------

    def action_breakpoint(self) -> None:
        """A breakpoint at the marked instruction, or none any more."""
        marked = self._marked
        self._code.toggle(marked)
        self._show_code(marked)

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """An instruction was clicked, or Enter pressed: a breakpoint."""
        if event.option_list is self._list:
            self.action_breakpoint()

    def action_clear(self) -> None:
        """No breakpoints any more."""
        self._code.clear()
        self._show_code(self._marked)

    def action_here(self) -> None:
        """List from where the processor stands."""
        self._first = self._code.pc
        self._show_code(self._first)

    def action_address(self) -> None:
        """Ask for the address that is listed from."""

        def take(text: str) -> None:
            self._first = parse_address(text)
            self._show_code(self._first)
            self._list.focus()

        self.open(AskLine("Instructions from", "As 28672 or 7000H.", "", take))

    def action_memory(self) -> None:
        """Ask for the address that memory is shown from."""

        def take(text: str) -> None:
            self._memory_from = parse_address(text)
            self._show_memory()

        self.open(AskLine("Memory from", "As 15360 or 3C00H.", "", take))
