"""A command of the line mode, and what commands are given to work with."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from trs80arm.desk.code_debugger import CodeDebugger
from trs80arm.desk.debugger import Debugger
from trs80arm.desk.files import SessionFiles
from trs80arm.desk.pendant import Pendant
from trs80arm.desk.peripherals import Peripherals
from trs80arm.desk.proof import Proof
from trs80arm.desk.reach import Reach
from trs80arm.desk.session import Session
from trs80arm.desk.states import States
from trs80arm.desk.teach import Lesson
from trs80arm.desk.tour import Tour
from trs80arm.desk.workbench import Workbench
from trs80arm.plain.asking import LineAsking


class Tell(Protocol):
    """Says something on a line of its own."""

    def __call__(self, text: object) -> None:
        """Say it."""


@dataclass(frozen=True)
class Sitting:
    """The desk, for commands in lines.

    Attributes:
        session: the machine and what belongs to it.
        files: opens and saves.
        proof: reads the program.
        workbench: the bench and the arm on it.
        peripherals: recorder and printer.
        lesson: the positions taught.
        tour: the first five minutes, step by step.
        pendant: teaches them.
        debugger: stops the machine, and moves it on and back.
        code: stops machine code, and moves it on.
        states: the saved states.
        ask: asks its user; the next line is the answer.
        tell: says something.
        reach: which files can be named.
        leave: ends the sitting, asking first about what is unsaved.
    """

    session: Session
    files: SessionFiles
    proof: Proof
    workbench: Workbench
    peripherals: Peripherals
    lesson: Lesson
    tour: Tour
    pendant: Pendant
    debugger: Debugger
    code: CodeDebugger
    states: States
    ask: LineAsking
    tell: Tell
    reach: Reach
    leave: Callable[[], None]


@dataclass(frozen=True)
class LineCommand:
    """A command.

    Attributes:
        name: the word behind the point.
        help: what it does, in a few words.
        do: does it, with the words that stand behind its name.
        takes: what these are, as the help has it.
        more: how it is used, for who asks about it alone.
    """

    name: str
    help: str
    do: Callable[[Sitting, str], object]
    takes: str = ""
    more: str = ""

    @property
    def usage(self) -> str:
        """How it is typed, without the point."""
        return f"{self.name} {self.takes}".rstrip()


@dataclass(frozen=True)
class Group:
    """Commands that belong together, under a title in the help."""

    title: str
    commands: tuple[LineCommand, ...]
