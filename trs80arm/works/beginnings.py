"""Machines as they begin: assembled, and switched on; the second of its kind is a copy.

A machine begins the same each time: an arm stands at a bench, the parts there come to rest,
MEMORY SIZE? is answered. That takes milliseconds, and whoever tries many programs, or looks what
of a machine is not as it began, wants many. So a machine that is asked for a second time is kept as
bytes, of which the third and all others are made anew: they share with it, and with one another,
only what never changes (`VALUES` and `NAMED` of `snapshot_classes`). Benches are known again by
what they are, as bytes.
"""

from __future__ import annotations

import io
import pickle
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any, Generic, TypeVar

from trs80arm.arm.bench import Bench
from trs80arm.arm.minimover import MiniMover
from trs80arm.basic.activity import Waiting
from trs80arm.works import rom_driver
from trs80arm.works.devices import RigSettings, Works, assemble
from trs80arm.works.key_events import KeyEvents
from trs80arm.works.observers import Observers
from trs80arm.works.running import Running

MOST = 8
"""Kinds of machine that are kept."""
LONGEST = 30
"""Virtual seconds within which a machine that is switched on is at READY."""


@cache
def _shared() -> frozenset[type]:
    """The classes of what never changes."""
    # All of them take a while to load, and one machine alone asks for none.
    from trs80arm.snapshot_classes import NAMED, VALUES

    return frozenset(VALUES.values()) | {cls for cls, _ in NAMED.values()}


class _Pickler(pickle.Pickler):
    """Leaves out what never changes, and keeps it."""

    def __init__(self, file: io.BytesIO) -> None:
        super().__init__(file, pickle.HIGHEST_PROTOCOL)
        self.kept: list[Any] = []
        self._shared = _shared()
        self._numbers: dict[int, int] = {}

    def persistent_id(self, thing: Any) -> int | None:
        """The number of a value; None for what is written."""
        if type(thing) not in self._shared:
            return None
        if id(thing) not in self._numbers:
            self._numbers[id(thing)] = len(self.kept)
            self.kept.append(thing)
        return self._numbers[id(thing)]


class _Unpickler(pickle.Unpickler):
    """Puts what was kept where it was."""

    def __init__(self, file: io.BytesIO, kept: list[Any]) -> None:
        super().__init__(file)
        self._kept = kept

    def persistent_load(self, number: int) -> Any:
        """What `_Pickler.persistent_id` gave the number."""
        return self._kept[number]


_Thing = TypeVar("_Thing")


class _Mould(Generic[_Thing]):
    """A machine, or a bench, as bytes."""

    def __init__(self, thing: _Thing) -> None:
        file = io.BytesIO()
        pickler = _Pickler(file)
        pickler.dump(thing)
        self._bytes = file.getvalue()
        self._kept = pickler.kept

    def cast(self) -> _Thing:
        """One more such."""
        thing: _Thing = _Unpickler(io.BytesIO(self._bytes), self._kept).load()
        return thing


def copied(bench: Bench) -> Bench:
    """A bench for one machine alone, with all as it is on another."""
    return _Mould(bench).cast()


class _Beginning:
    """What `make` makes, or a copy of what it made before."""

    def __init__(self, make: Callable[[RigSettings, Bench | None], Works]) -> None:
        self._make = make
        self._moulds: OrderedDict[tuple[RigSettings, bytes], _Mould[Works] | None] = OrderedDict()

    def __call__(self, settings: RigSettings, bench: Bench | None = None) -> Works:
        """Works of their own, with tape folder and printer file as the settings have them.

        Args:
            settings: the machine's fittings.
            bench: what stands on the table, None for the standard bench.
        """
        nowhere = replace(settings, tape_folder=None, printer_file=None)
        kind = nowhere, b"" if bench is None else pickle.dumps(bench, pickle.HIGHEST_PROTOCOL)
        if settings.rom is not None:
            # Its processor is a chip with a state of its own.
            works = self._make(nowhere, bench)
        elif (mould := self._moulds.get(kind)) is not None:
            self._moulds.move_to_end(kind)
            works = mould.cast()
        else:
            works = self._make(nowhere, bench)
            # Most who make one make no other: bytes are worth it from the second on.
            self._moulds[kind] = _Mould(works) if kind in self._moulds else None
            self._moulds.move_to_end(kind)
            if len(self._moulds) > MOST:
                self._moulds.popitem(last=False)
        works.use_places(settings)
        works.settings = settings
        return works


def _assembled(settings: RigSettings, bench: Bench | None = None) -> Works:
    return assemble(settings, MiniMover(settings.arm, None if bench is None else copied(bench)))


def _switched_on(settings: RigSettings, bench: Bench | None = None) -> Works:
    works = _assembled(settings, bench)
    observers = Observers()
    observers.connect(works)
    switch_on(works, Running(works, KeyEvents(works), observers))
    return works


def switch_on(works: Works, running: Running) -> None:
    """Answer MEMORY SIZE? as the settings say, and let the machine come to READY.

    Under a ROM of one's own ARMBASIC is then put into memory and started.
    """
    basic, settings = works.basic, works.settings

    def type_until(waiting: Waiting, text: str) -> None:
        works.typist.add(text + "\r")
        running.run_until(
            lambda: basic.waiting is waiting and not (works.typist.pending or works.events),
            LONGEST,
        )

    if settings.rom is not None:
        # A ROM of its own tests the memory before it looks at the keyboard.
        running.run_until(lambda: basic.waiting is Waiting.MEMORY_SIZE, LONGEST)
    type_until(Waiting.COMMAND, settings.memory_size)
    if settings.rom is not None and settings.has_armbasic and basic.waiting is Waiting.COMMAND:
        # SYSTEM takes its stack out of the way of what it loads.
        type_until(Waiting.SYSTEM, "SYSTEM")
        start = rom_driver.put_in(works.memory, settings.ram_kib, settings.card)
        type_until(Waiting.COMMAND, f"/{start}")


assembled = _Beginning(_assembled)
"""A machine just assembled."""
switched_on = _Beginning(_switched_on)
"""A machine just switched on."""
