"""Who looks at a rig from outside."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeVar

from trs80arm.basic.state import Listener as StatementListener
from trs80arm.basic.state import Stops
from trs80arm.machine.card import Observer
from trs80arm.machine.console import Listener
from trs80arm.machine.ports import LineListener
from trs80arm.works.devices import Works
from trs80arm.works.inputs import Input
from trs80arm.works.rom_language import RomLanguage

if TYPE_CHECKING:
    from trs80arm.serial.controller import Listener as SerialListener

T = TypeVar("T")


@dataclass(frozen=True)
class Observers:
    """Everybody who looks at a rig from outside, by what they look at.

    They belong to the rig and not to its works: the machine may be switched off and on, another
    state restored, another bench set up, and they go on looking. `connect` is the one place where
    devices learn of them.
    """

    codes: list[Listener] = field(default_factory=list)
    """Told every code sent to the display."""
    statements: list[StatementListener] = field(default_factory=list)
    """Told every statement before it is executed."""
    latches: list[Observer] = field(default_factory=list)
    """Told every write to the card's latches."""
    resets: list[Callable[[], None]] = field(default_factory=list)
    """Told every `@RESET`."""
    line: list[LineListener] = field(default_factory=list)
    """Told every change of the level on the recorder's line."""
    answers: list[SerialListener] = field(default_factory=list)
    """Told every answer that the computer in the arm's base gives over its serial line."""
    inputs: list[Callable[[Input], None]] = field(default_factory=list)
    """Told everything that the operator does; the rig itself tells them."""
    stops: Stops = field(default_factory=Stops)
    """Asked before every statement whether the machine is to stop there."""
    code_stops: Stops = field(default_factory=Stops)
    """Asked before every instruction of machine code whether the machine is to stop there."""
    replaced: list[tuple[str, bytes]] = field(default_factory=list)
    """What was on cassettes of the tape folder before they were recorded on, in order."""

    def connect(self, works: Works) -> None:
        """Let the devices of other works be looked at from now on."""
        works.console.listeners = self.codes
        works.basic.listeners = self.statements
        works.basic.stops = self.stops
        works.processor.stops = self.code_stops
        works.tape.replaced = self.replaced
        works.card.observers = self.latches
        works.driver.reset_observers = self.resets
        if isinstance(works.basic, RomLanguage):
            works.basic.reset_observers = self.resets
        works.system_port.listeners = self.line
        if works.controller is not None:
            works.controller.listeners = self.answers


def attach(attached: list[T], observer: T) -> Callable[[], None]:
    """Put somebody among the others; the function that is returned ends it, once and for all."""
    attached.append(observer)

    def end() -> None:
        attached[:] = [other for other in attached if other is not observer]

    return end
