"""What a debugger keeps an eye on: a variable, a latch of the card, a byte of memory.

A watch tells before each statement whether its value has changed since the one before. A latch
changes many times within one statement, an `@STEP`, and may hold at its end what it held before;
so its writes are listened to.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from trs80arm import inspection
from trs80arm.desk.memory_view import parse_address
from trs80arm.machine.card import Latch
from trs80arm.pulses import Series
from trs80arm.rig import Rig

LATCH_NAMES = tuple(latch.name.lower().replace("_", " ") for latch in Latch)
"""What the latches are called behind the word `latch`."""
_HINT = "a watch is on a variable, as I or B$(2), on `latch base`, or on an address, as 3C00H"


class Watch(Protocol):
    """Something that an eye is kept on."""

    name: str
    """As people write it."""

    @property
    def value(self) -> str:
        """What it holds now."""

    def changed(self) -> str:
        """What has changed since the last time this was asked; empty if nothing has."""

    def look_again(self) -> None:
        """Take what it holds now for unchanged: the machine is another one, or at another time."""

    def end(self) -> None:
        """Stop watching."""


def watch(rig: Callable[[], Rig], text: str) -> Watch:
    """Begin to watch what is named.

    Args:
        rig: gives the machine.
        text: `I`, `B$(2)`, `latch base`, `3C00H`.

    Raises:
        ValueError: it names nothing that can be watched; one line that says what can.
    """
    words = " ".join(text.split())
    if words[:6].casefold() == "latch ":
        name = words[6:].casefold()
        if name not in LATCH_NAMES:
            raise ValueError(f"the latches are {', '.join(LATCH_NAMES)}")
        return _LatchWatch(rig(), LATCH_NAMES.index(name))
    if words[:1].isdigit() or words[:1] == "&":
        return _Watched(_byte_name(parse_address(words)), _byte(rig, parse_address(words)))
    name = words.upper().replace(" ", "")
    if not inspection.is_name(name):
        raise ValueError(_HINT)
    return _Watched(name, lambda: _variable(rig(), name))


def _variable(rig: Rig, name: str) -> str:
    try:
        return inspection.value_text(rig, name)
    except LookupError:
        return "none"


def _byte_name(address: int) -> str:
    return f"{address:04X}H"


def _byte(rig: Callable[[], Rig], address: int) -> Callable[[], str]:
    return lambda: str(rig().memory.peek(address))


class _Watched:
    """A value that is read when it is asked for."""

    def __init__(self, name: str, read: Callable[[], str]) -> None:
        self.name = name
        self._read = read
        self._last = read()

    @property
    def value(self) -> str:
        """What it holds now."""
        return self._read()

    def changed(self) -> str:
        """From what to what it has changed."""
        before, self._last = self._last, self._read()
        return "" if before == self._last else f"{self.name} {before} -> {self._last}"

    def look_again(self) -> None:
        """Take what it holds now for unchanged."""
        self._last = self._read()

    def end(self) -> None:
        """Nothing is to be done."""


class _LatchWatch:
    """A latch, whose writes are listened to."""

    each_step = False

    def __init__(self, rig: Rig, latch: int) -> None:
        self.name = f"latch {LATCH_NAMES[latch]}"
        self._rig = rig
        self._latch = latch
        self._changes = self._held = 0
        self._end = rig.watch_latches(self)
        self.look_again()

    @property
    def value(self) -> str:
        """The coils phi 1 to phi 4, 1 with current."""
        return f"{self._rig.card.latches[self._latch]:04b}"

    def wrote(self, times: Series, latches: Series, nibbles: Series) -> None:
        """Count how often it held something else than before."""
        for latch, nibble in zip(latches, nibbles, strict=True):
            if latch == self._latch and nibble != self._held:
                self._held = int(nibble)
                self._changes += 1

    def changed(self) -> str:
        """From what to what it has changed, and how often if not once."""
        if not self._changes:
            return ""
        often = "" if self._changes == 1 else f", {self._changes} times changed"
        told = f"{self.name} {self._last} -> {self.value}{often}"
        self.look_again()
        return told

    def look_again(self) -> None:
        """Take what it holds now for unchanged."""
        self._held = int(self._rig.card.latches[self._latch])
        self._last = self.value
        self._changes = 0

    def end(self) -> None:
        """Listen no more."""
        self._end()
