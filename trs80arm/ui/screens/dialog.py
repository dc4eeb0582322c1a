"""What all dialogs have in common, and the plain ones: a question, a choice, a file's name."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar, Generic, Literal, TypeVar

from textual import events
from textual.app import App, ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.markup import escape
from textual.screen import ModalScreen
from textual.widgets import Button, Input, OptionList, Static
from textual.widgets.option_list import Option

from trs80arm.desk.asking import FileQuestion, ListQuestion, Question
from trs80arm.desk.reach import Reach, file_problem, proposed, replaces
from trs80arm.shown import shown
from trs80arm.ui.screens.lists import MarkingList
from trs80arm.ui.terminal.layers import SeenThrough

Answer = TypeVar("Answer")
Other = TypeVar("Other")


class Dialog(ModalScreen[Answer | None], SeenThrough, Generic[Answer]):
    """A dialog: Escape leaves it without an answer."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "cancel", "Back")]
    # Textual has it as an attribute of each screen.
    HORIZONTAL_BREAKPOINTS = [(0, "-narrow"), (60, "-wide")]  # noqa: RUF012
    DEFAULT_CSS = """
    Dialog { align: center middle; background: $background 60%; }
    Dialog > .dialog {
        width: 76; max-width: 96%; height: auto; max-height: 96%;
        border: round $title; border-title-color: $text-accent; border-subtitle-color: $text-muted;
        background: $surface; padding: 0 1;
    }
    Dialog .hint { color: $text-muted; }
    Dialog .wrong { color: $text-error; height: auto; }
    Dialog OptionList {
        height: auto; max-height: 20; min-width: 8; border: none; background: $surface;
    }
    Dialog OptionList:focus { border: none; }
    Dialog Input { border: none; height: 1; background: $panel; padding: 0 1; }
    Dialog Input:focus { border: none; }
    Dialog .buttons { height: auto; align-horizontal: right; margin-top: 1; }
    Dialog.-narrow .buttons { layout: vertical; }
    Dialog Button { margin-left: 2; padding: 0 1; background: $panel; }
    Dialog Button:focus {
        background: $primary; color: $on-primary; text-style: bold !important;
        background-tint: transparent;
    }
    """

    def action_cancel(self) -> None:
        """Leave without an answer."""
        self.dismiss(None)

    def open(self, dialog: Dialog[Other], then: Callable[[Other], object] | None = None) -> None:
        """Show another dialog over this one; `then` gets its answer, if it ends with one."""
        show(self.app, dialog, then)

    def went_down(self, base: str, name: str, text: str | None) -> None:
        """A key went down, where the terminal tells so; for who looks at keys themselves.

        Args:
            base: tells the key from all others.
            name: as Textual calls it.
            text: what it types.
        """

    def went_up(self, base: str) -> None:
        """The same key was let go."""


def show(
    app: App[Any], dialog: Dialog[Answer], then: Callable[[Answer], object] | None = None
) -> None:
    """Show a dialog of an application; `then` gets its answer, if it ends with one."""

    def ended(answer: Answer | None) -> None:
        if answer is not None and then is not None:
            then(answer)

    app.push_screen(dialog, ended)


class Choose(Dialog[str]):
    """Asks for one of a list.

    Args:
        question: the list.
        seen: is given the value that is marked, and the present one when none is chosen.
    """

    def __init__(self, question: ListQuestion, seen: Callable[[str], object] | None = None) -> None:
        super().__init__()
        self.question = question
        self._seen = seen

    def compose(self) -> ComposeResult:
        """The list."""
        width = max(len(choice.label) for choice in self.question.choices) + 2
        with Vertical(classes="dialog") as box:
            box.border_title = self.question.title
            box.border_subtitle = "Enter chooses, Escape goes back"
            yield MarkingList(
                *(
                    Option(
                        f"{'*' if choice.value == self.question.now else ' '} "
                        f"{choice.label.ljust(width)}{choice.note}",
                        id=f"choice-{number}",
                    )
                    for number, choice in enumerate(self.question.choices)
                ),
                markup=False,
            )

    def on_mount(self) -> None:
        """Begin at what is chosen now."""
        values = [choice.value for choice in self.question.choices]
        options = self.query_one(OptionList)
        options.highlighted = values.index(self.question.now) if self.question.now in values else 0
        options.focus()

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        """Let what is marked be seen."""
        if self._seen is not None:
            self._seen(self.question.choices[event.option_index].value)

    def action_cancel(self) -> None:
        """Leave it as it is."""
        if self._seen is not None:
            self._seen(self.question.now)
        super().action_cancel()

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Answer."""
        self.dismiss(self.question.choices[event.option_index].value)


class Ask(Dialog[str]):
    """Asks a question with a few answers."""

    DEFAULT_CSS = """
    Ask.-narrow > .dialog {
        overflow-y: auto; scrollbar-gutter: stable; scrollbar-size-vertical: 1; padding: 0 0 0 1;
    }
    """
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("left,up", "app.focus_previous", show=False),
        Binding("right,down", "app.focus_next", show=False),
    ]

    def __init__(self, question: Question) -> None:
        super().__init__()
        self.question = question

    def compose(self) -> ComposeResult:
        """Question and buttons."""
        with Vertical(classes="dialog") as box:
            box.border_title = self.question.title
            text = f"{self.question.text} {self.question.again}".rstrip()
            yield Static(text, markup=False)
            with Horizontal(classes="buttons"):
                for number, answer in enumerate(self.question.answers):
                    yield Button(answer.label, id=f"answer-{number}", compact=True)

    def on_key(self, event: events.Key) -> None:
        """A letter goes to the answer that begins with it; Enter gives it."""
        letter = event.character or ""
        for answer, button in zip(self.question.answers, self.query(Button), strict=True):
            if letter.isalpha() and answer.label.casefold().startswith(letter.casefold()):
                button.focus()
                event.stop()
                return

    def on_button_pressed(self, event: Button.Pressed) -> None:
        """Answer."""
        number = int((event.button.id or "answer-0").rpartition("-")[2])
        self.dismiss(self.question.answers[number].value)


class LineDialog(Dialog[Answer]):
    """Asks for one line, and says at once what is wrong with it; subclasses say what it means.

    Args:
        title: of the dialog.
        hint: what is to be typed.
        proposal: what stands there at first.
        kind: what can be typed; a number that is proposed goes when another one is typed.
    """

    def __init__(
        self,
        title: str,
        hint: str,
        proposal: str,
        kind: Literal["text", "integer", "number"] = "text",
    ) -> None:
        super().__init__()
        self._title = title
        self._hint = hint
        self._proposal = proposal
        self._kind = kind

    def compose(self) -> ComposeResult:
        """The line."""
        with Vertical(classes="dialog") as box:
            box.border_title = escape(self._title)
            box.border_subtitle = "Enter does it, Escape goes back"
            yield Static(self._hint, classes="hint", markup=False)
            yield Input(self._proposal, type=self._kind, select_on_focus=self._kind != "text")
            yield Static("", classes="wrong", markup=False)

    def answer(self, text: str) -> Answer:
        """What was typed; a `ValueError` or `LookupError` is shown, and the question stays."""
        raise TypeError(f"{type(self).__name__} does not say what a line means")

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Answer, or say why the line cannot be used."""
        try:
            answer = self.answer(event.value)
        except (ValueError, LookupError) as error:
            self.query_one(".wrong", Static).update(shown(str(error.args[0])))
        else:
            self.dismiss(answer)


class AskPath(LineDialog[Path]):
    """Asks for the name of a file.

    Args:
        question: what kind of file.
        reach: which files can be named.
    """

    def __init__(self, question: FileQuestion, reach: Reach) -> None:
        super().__init__(question.title, question.hint, proposed(reach, question))
        self.question = question
        self._reach = reach
        self._warned = ""

    def answer(self, text: str) -> Path:
        """The file, if the name can be used."""
        text = text.strip()
        problem = file_problem(self._reach, self.question, text)
        path = self._reach.typed(text)
        if not problem and replaces(self.question, path) and text != self._warned:
            self._warned = text
            problem = f"{path.name} exists. Enter again replaces it."
        if problem:
            raise ValueError(problem)
        return path
