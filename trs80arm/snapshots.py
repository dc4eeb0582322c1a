r"""Snapshots: the complete state of a rig as bytes that any program of this version can read back.

A snapshot is one line and one JSON text. The line is `trs80arm snapshot 1`, the length of the text
in bytes and its SHA-256. The text is an object:

- `settings`: the machine's fittings, as `as_table` gives them; no file or folder is named.
- `state`: pairs of a place and what is there, in order, as far as it differs from a machine that
  was just assembled from these settings. A place is the way to it from the works, as `clock`,
  `basic.control` or `memory.ram`. An object's entry holds its attributes by name, a container's
  its content.

Numbers, texts, true, false and null stand for themselves. Everything else is a list that begins
with its kind: `["bytes", base64]`, `["tuple", ...]`, `["list", ...]`, `["set", ...]`,
`["dict", [key, value], ...]`, `["named", kind, name]`, `["value", class, field, ...]` for a value
that never changes, `["new", class, state]` for an object that is made anew, `["same", n]` for the
n-th thing with an identity of its own that was made so far, and `["at", place]` for what stands at
a place.

The wiring of the machine is never read: the devices are assembled here, as at power-on, and are
then given their state. Only classes of `snapshot_classes` are made anew, by names that stand there.
Equal machines have equal bytes, in every process and on every Python.
"""

from __future__ import annotations

import base64
import binascii
import hashlib
import json
import math
import types
import typing
from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from enum import Enum
from functools import cache, lru_cache
from typing import Any, ClassVar

from trs80arm.machine.clock import END_OF_TIME
from trs80arm.machine.z80.rom import Rom
from trs80arm.plain_values import SettingsError, Table, as_table, from_table
from trs80arm.snapshot_classes import CHECKS, NAMED, OBJECTS, VALUES, WIRES, parts_of
from trs80arm.snapshot_error import SnapshotError
from trs80arm.works.beginnings import assembled
from trs80arm.works.devices import RigSettings, Works

FORMAT = "trs80arm snapshot 1"
LARGEST = 64 * 1024 * 1024
"""Bytes of a snapshot that is read; one of a machine at work has some hundred thousand."""
_DEEPEST = 60
"""How deep values may lie in one another."""
_LARGEST_INTEGER = 1 << 64
_LATEST = END_OF_TIME // 2
"""The last T-state that a machine may stand at, so that it can go on for as long again."""
_KEPT = 4
"""Kinds of machine of which one that was just assembled is kept, for others to be compared with."""
_MISSING = object()

_KINDS = {cls: name for name, (cls, _) in NAMED.items()}
_VALUE_NAMES = {cls: name for name, cls in VALUES.items()}
_OBJECT_NAMES = {cls: name for name, cls in OBJECTS.items()}
_MADE = _VALUE_NAMES.keys() | _OBJECT_NAMES.keys()
_PLAIN = (type(None), bool, int, float, str, bytes)
_CONTAINERS = (list, deque, dict, set, bytearray)
_COMPARED = frozenset({type(None), bool, int, float, str, bytes, bytearray})
"""Kinds of value of which two that are equal are written alike."""
_SHARED = _COMPARED.difference((bytearray,)) | _VALUE_NAMES.keys() | _KINDS.keys()
"""Kinds of what never changes: machines of one kind have the very same."""


def encode(works: Works) -> bytes:
    """The state of a rig's works.

    Raises:
        TypeError: something in it is of a class that `snapshot_classes` does not know: a mistake
            of the program and not of its user.
    """
    settings = replace(works.settings, tape_folder=None, printer_file=None)
    places = _Places(_as_assembled(settings), works)
    writer = _Writer(places.names)
    entries: list[list[Any]] = []
    for name, was, now in places.pairs:
        if isinstance(now, _CONTAINERS):
            state = writer.content(was, now)
        else:
            state = writer.attributes(places.fresh[name], places.states[name])
        if state is not None:
            entries.append([name, state])
    text = json.dumps(
        {"settings": as_table(settings), "state": entries}, separators=(",", ":"), allow_nan=False
    ).encode("ascii")
    head = f"{FORMAT} {len(text)} {hashlib.sha256(text).hexdigest()}\n"
    return head.encode("ascii") + text


@lru_cache(_KEPT)
def _as_assembled(settings: RigSettings) -> Works:
    """Works that were just assembled, for looking at."""
    return assembled(settings)


def decode(data: bytes, rom: Rom | None = None) -> Works:
    """Works in the state of a snapshot, without tape folder and printer file.

    Args:
        data: the snapshot.
        rom: the ROM that is at hand; a snapshot of a machine with a ROM names it and has none of
            its bytes.

    Raises:
        SnapshotError: for any bytes that are no snapshot.
    """
    content = _content(data)
    try:
        content = Table("snapshot", "", content)
        settings = from_table(RigSettings, content.data.pop("settings", None), "settings")
        if settings.tape_folder is not None or settings.printer_file is not None:
            raise SnapshotError("no snapshot: it names a file or folder")
        if settings.rom is not None:
            settings = replace(settings, rom=_at_hand(settings.rom, rom))
        entries = content.data.pop("state", None)
        content.done("settings, state")
        works = assembled(settings)
        places = _Places(works, works)
        _Reader(places).read(entries)
        works.settings = settings
        times = works.clock.now, works.asked
        if not all(type(time) is int and 0 <= time <= _LATEST for time in times):
            raise SnapshotError("no snapshot: a time at which no machine was ever switched on")
    except SnapshotError:
        raise
    except SettingsError as error:
        raise SnapshotError(f"no snapshot: {error}") from None
    except (ValueError, TypeError, LookupError, AttributeError, ArithmeticError) as error:
        # What classes of the machine say to values that they never have.
        raise SnapshotError(f"no snapshot: a state that cannot be: {error}") from None
    return works


def _at_hand(wanted: Rom, rom: Rom | None) -> Rom:
    if rom != wanted:
        raise SnapshotError(
            f"the snapshot of a machine with the ROM {wanted.crc.upper()}, {wanted.name}: start "
            "with --rom and a file of it"
        )
    return wanted if rom is None else rom


def _content(data: bytes) -> Any:
    head, _, text = data[: LARGEST + 1].partition(b"\n")
    words = head.rsplit(b" ", 2)
    if len(data) > LARGEST or len(words) != 3 or words[0] != FORMAT.encode():
        kind = "of another version" if head.startswith(b"trs80arm snapshot") else "no snapshot"
        raise SnapshotError(f"{kind}: it does not begin with the words {FORMAT!r}")
    if words[1] != b"%d" % len(text) or words[2] != hashlib.sha256(text).hexdigest().encode():
        raise SnapshotError("a damaged snapshot: its length or checksum is wrong")
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        raise SnapshotError("no snapshot: its content is no JSON") from None


# -- places ----------------------------------------------------------------------------------------


class _Places:
    """What has a place in works: devices, and containers that belong to them.

    Works that were just assembled and works in use are gone through side by side, so that one
    place names the same thing in both.

    Attributes:
        names: the place of each thing, by its `id`.
        pairs: place, the thing in the assembled works, the thing in the works in use.
        fresh: the attributes of each object of the assembled works, by place.
        states: the same of the works in use.
    """

    def __init__(self, fresh: Works, used: Works) -> None:
        self.names: dict[int, str] = {}
        self.pairs: list[tuple[str, Any, Any]] = []
        # States may be made up for the occasion: kept, so that no other gets their `id`.
        self.fresh: dict[str, Any] = {}
        self.states: dict[str, Any] = {}
        level = [("works", fresh, used)]
        while level:
            # The shortest way is the name, and a public one before a private.
            level.sort(key=lambda found: ("_" in found[0].rpartition(".")[2][:1], found[0]))
            level = [part for found in level for part in self._take(*found)]

    def _take(self, place: str, was: Any, now: Any) -> list[tuple[str, Any, Any]]:
        """Note what stands at a place; what stands below it."""
        if type(now) is not tuple:
            if id(was) in self.names or id(now) in self.names:
                return []
            self.names[id(was)] = self.names[id(now)] = place
            self.pairs.append((place, was, now))
        return list(self._parts(place, was, now))

    def _parts(self, place: str, was: Any, now: Any) -> Iterator[tuple[str, Any, Any]]:
        """What stands below a place and is no value."""
        if isinstance(now, list | deque | tuple):
            for index, (one, other) in enumerate(zip(was, now, strict=False)):
                if _in_both(one, other):
                    yield f"{place}[{index}]", one, other
        elif isinstance(now, dict):
            for key, other in now.items():
                if _in_both(was.get(key), other) and type(key) in (int, str):
                    yield f"{place}[{key}]", was[key], other
        elif not isinstance(now, _CONTAINERS):
            state = _state(now)
            before = state if was is now else _state(was)
            self.fresh[place], self.states[place] = before, state
            if isinstance(state, dict):
                prefix = "" if place == "works" else f"{place}."
                for name, other in state.items():
                    if _in_both(before.get(name), other):
                        yield f"{prefix}{name}", before[name], other


def _in_both(was: Any, now: Any) -> bool:
    """Whether there is something at a place in both works that is no value."""
    cls: Any = type(now)
    return _has_place(cls) and type(was) is cls


@cache
def _has_place(cls: type) -> bool:
    """Whether what is of a class may have a place, or parts that have one; not so values."""
    return not (issubclass(cls, (*_PLAIN, Enum)) or cls in _KINDS or cls in _MADE)


def _state(thing: Any) -> Any:
    """The attributes of an object by name, or what its class calls its state."""
    cls: Any = type(thing)
    if _says_its_state(cls):
        state = thing.__getstate__()
        match state:
            case (None, dict(slots)):
                return slots
            case dict(attributes):
                # A class among them is how the machine is wired, not what it holds.
                wires = WIRES.get(cls, ())
                return {
                    name: value
                    for name, value in attributes.items()
                    if not isinstance(value, type) and name not in wires
                }
        return state
    if is_dataclass(cls):
        return {field.name: getattr(thing, field.name) for field in fields(cls)}
    names = [name for base in cls.__mro__ for name in getattr(base, "__slots__", ())]
    return {name: getattr(thing, name) for name in names if hasattr(thing, name)} | getattr(
        thing, "__dict__", {}
    )


@cache
def _says_its_state(cls: type) -> bool:
    return any("__getstate__" in vars(base) for base in cls.__mro__[:-1])


# -- writing ---------------------------------------------------------------------------------------


class _Writer:
    """Turns what is in the works into JSON values."""

    def __init__(
        self, places: dict[int, str], values: dict[int, tuple[Any, Any]] | None = None
    ) -> None:
        self._places = places
        self._values = {} if values is None else values
        self._numbers: dict[int, int] = {}
        self._kept: list[Any] = []
        self._met = 0

    def content(self, was: Any, now: Any) -> Any:
        """What is to be said of a container that has a place; None if nothing."""
        return self._differing(was, now, _Writer._inside)

    def attributes(self, was: Any, now: Any) -> Any:
        """What is to be said of an object that has a place; None if nothing."""
        if not isinstance(now, dict):
            return self._differing(was, now, _Writer.value)
        said = {}
        for name in sorted(now):
            value = self._differing(was.get(name), now[name], _Writer.value)
            if value is not None or (now[name] is None and was.get(name) is not None):
                said[name] = value
        return said or None

    def _differing(self, was: Any, now: Any, write: Any) -> Any:
        """What is written of `now`; None if a machine just assembled has the same there."""
        cls = type(now)
        if was is now and cls in _SHARED:
            return None
        plain = cls in _COMPARED or (cls in _CONTAINERS and not now)
        if plain and type(was) is cls and was == now:
            return None
        met = self._met
        written = write(self, now)
        if self._met != met:
            # Who has an identity is written always, for somebody else may refer to it.
            return written
        return None if written == write(_Writer(self._places, self._values), was) else written

    def value(self, value: Any, depth: int = 0) -> Any:
        """A value inside of something else."""
        cls = type(value)
        if cls is float:
            return value if math.isfinite(value) else ["float", repr(value)]
        if value is None or cls is bool or cls is str:
            return value
        if cls is int and -_LARGEST_INTEGER < value < _LARGEST_INTEGER:
            return value
        if cls is bytes:
            return ["bytes", base64.b64encode(value).decode("ascii")]
        if cls in _KINDS:
            return ["named", _KINDS[cls], value.name]
        if depth > _DEEPEST:
            raise TypeError("values nested too deeply for a snapshot")
        if cls is tuple:
            # Most are numbers: places and directions.
            return ["tuple"] + [
                item if type(item) is float and math.isfinite(item) else self.value(item, depth + 1)
                for item in value
            ]
        if cls in _VALUE_NAMES:
            return self._unchanging(value, depth)
        if id(value) in self._places:
            return ["at", self._places[id(value)]]
        self._met += 1
        if id(value) in self._numbers:
            return ["same", self._numbers[id(value)]]
        self._numbers[id(value)] = len(self._numbers)
        self._kept.append(value)
        if cls in _OBJECT_NAMES:
            state = _state(value)
            self._kept.append(state)
            if isinstance(state, dict):
                written: Any = {name: self.value(state[name], depth + 1) for name in sorted(state)}
            else:
                written = self.value(state, depth + 1)
            return ["new", _OBJECT_NAMES[cls], written]
        if cls in _CONTAINERS:
            return self._inside(value, depth)
        raise TypeError(f"a snapshot knows nothing of {cls.__module__}.{cls.__qualname__}")

    def _unchanging(self, value: Any, depth: int) -> Any:
        """A value that never changes; many stand at several places, and are written once."""
        known = self._values.get(id(value))
        if known is not None:
            return known[1]
        met = self._met
        cls = type(value)
        parts = (self.value(getattr(value, name), depth + 1) for name in parts_of(cls))
        written = ["value", _VALUE_NAMES[cls], *parts]
        if self._met == met:
            self._values[id(value)] = value, written
        return written

    def _inside(self, value: Any, depth: int = 0) -> list[Any]:
        """A container with its content."""
        if isinstance(value, bytearray):
            return ["bytearray", base64.b64encode(value).decode("ascii")]
        if isinstance(value, dict):
            pairs = (
                [self.value(key, depth + 1), self.value(item, depth + 1)]
                for key, item in value.items()
            )
            return ["dict", *pairs]
        items = [self.value(item, depth + 1) for item in value]
        if isinstance(value, set):
            items.sort(key=json.dumps)
        return [type(value).__name__, *items]


# -- reading ---------------------------------------------------------------------------------------


class _Reader:
    """Gives works that were just assembled the state that JSON values say."""

    def __init__(self, places: _Places) -> None:
        self._things = {name: now for name, _, now in places.pairs}
        self._states = places.states
        self._made: list[Any] = []

    def read(self, entries: Any) -> None:
        """Take all entries, then give every object its attributes."""
        if not isinstance(entries, list):
            raise SnapshotError("no snapshot: its state is no list")
        seen = set()
        for entry in entries:
            name, written = entry
            if name in seen or name not in self._things:
                raise SnapshotError("no snapshot: its state has a place that no machine has")
            seen.add(name)
            self._entry(name, written)
        for name, state in self._states.items():
            _give(self._things[name], state)

    def _entry(self, name: str, written: Any) -> None:
        thing = self._things[name]
        if isinstance(thing, _CONTAINERS):
            content = self.value(written, thing)
            if type(content) is not type(thing) or (
                _sorts(thing) and not _sorts(content) <= _sorts(thing)
            ):
                raise SnapshotError("no snapshot: another kind of content than the machine's")
            _refill(thing, content)
            return
        state = self._states[name]
        if not isinstance(state, dict):
            self._states[name] = self.value(written)
            return
        for attribute, value in written.items():
            # What an object has not got yet may have a beginning in its class.
            was = state.get(attribute, getattr(type(thing), attribute, _MISSING))
            if was is _MISSING or (attribute not in state and not isinstance(was, _PLAIN)):
                raise SnapshotError("no snapshot: an attribute that no machine has")
            state[attribute] = _like(was, self.value(value))

    def value(self, written: Any, container: Any = None, depth: int = 0) -> Any:
        """What a JSON value says; the content of `container`, if one is given."""
        if not isinstance(written, list):
            if isinstance(written, dict):
                raise SnapshotError("no snapshot: an object where a value should be")
            if isinstance(written, int) and not -_LARGEST_INTEGER < written < _LARGEST_INTEGER:
                raise SnapshotError("no snapshot: a number larger than any of a machine")
            return written
        if depth > _DEEPEST:
            raise SnapshotError("no snapshot: values nested too deeply")
        kind, *rest = written
        match kind, rest:
            case "float", [text]:
                return float(text)
            case "bytes", [str(text)]:
                return _bytes(text)
            case "tuple", _:
                return tuple(
                    [
                        item if type(item) is float else self.value(item, depth=depth + 1)
                        for item in rest
                    ]
                )
            case "named", [kind, name]:
                return NAMED[kind][1][name]
            case "value", [name, *parts]:
                made = VALUES[name](*(self.value(part, depth=depth + 1) for part in parts))
                _check(made)
                return made
            case "at", [place]:
                return self._things[place]
            case "same", [int(number)] if number >= 0:
                return self._made[number]
            case "new", [name, state]:
                return self._new(OBJECTS[name], state, depth)
        return self._container(kind, rest, container, depth)

    def _container(self, kind: Any, rest: list[Any], container: Any, depth: int) -> Any:
        made: Any = {
            "list": list,
            "deque": deque,
            "set": set,
            "dict": dict,
            "bytearray": bytearray,
        }[kind]()
        if container is None:
            self._made.append(made)
        elif type(container) is not type(made):
            raise SnapshotError("no snapshot: another kind of content than the machine's")
        if isinstance(made, bytearray):
            [text] = rest
            made += _bytes(text)
        elif isinstance(made, dict):
            for key, value in rest:
                made[self.value(key, depth=depth + 1)] = self.value(value, depth=depth + 1)
        elif isinstance(made, set):
            made.update(self.value(item, depth=depth + 1) for item in rest)
        else:
            for item in rest:
                made.append(self.value(item, depth=depth + 1))
        return made

    def _new(self, cls: type, written: Any, depth: int) -> Any:
        made: Any = object.__new__(cls)
        self._made.append(made)
        if isinstance(written, dict):
            state: Any = {
                name: self.value(value, depth=depth + 1) for name, value in written.items()
            }
            if state.keys() != _types(cls).keys():
                raise SnapshotError("no snapshot: an object with other attributes than its class")
        else:
            state = self.value(written, depth=depth + 1)
        _give(made, state)
        _check(made)
        return made


def _bytes(text: Any) -> bytes:
    try:
        return base64.b64decode(text, validate=True)
    except binascii.Error:
        raise SnapshotError("no snapshot: bytes that are not base64") from None


def _check(made: Any) -> None:
    """See that an object has what its class says: types of attributes, and what must hold."""
    cls: Any = type(made)
    right = all(
        hasattr(made, name) and _is_of(hint, getattr(made, name))
        for name, hint in _types(cls).items()
    )
    if not right or (cls in CHECKS and not CHECKS[cls](made)):
        raise SnapshotError("no snapshot: another kind of value than the machine's")


@cache
def _types(cls: type) -> dict[str, Any]:
    """The types of the attributes of a class that may be made anew."""
    hints = typing.get_type_hints(cls)
    if is_dataclass(cls):
        return {field.name: hints[field.name] for field in fields(cls)}
    return {name: hint for name, hint in hints.items() if typing.get_origin(hint) is not ClassVar}


@cache
def _read_hint(hint: Any) -> tuple[Any, tuple[Any, ...]]:
    """What a type is made of."""
    return typing.get_origin(hint), typing.get_args(hint)


def _is_of(hint: Any, value: Any) -> bool:
    """Whether a value is of a type; what is in tuples, lists, dictionaries and sets, too."""
    origin, inner = _read_hint(hint)
    if hint is Any:
        return True
    if hint is None:
        return value is None
    if origin in (typing.Union, types.UnionType):
        return any(_is_of(one, value) for one in inner)
    if origin is tuple:
        if not isinstance(value, tuple):
            return False
        if inner[1:] == (...,):
            return all(_is_of(inner[0], item) for item in value)
        return len(inner) == len(value) and all(map(_is_of, inner, value))
    if origin in (dict, Mapping):
        return isinstance(value, dict) and all(
            _is_of(inner[0], key) and _is_of(inner[1], item) for key, item in value.items()
        )
    if origin in (list, set, deque, Sequence):
        kinds = list | tuple if origin is Sequence else origin
        return isinstance(value, kinds) and all(_is_of(inner[0], item) for item in value)
    cls = origin or hint
    if getattr(cls, "_is_protocol", False):
        return type(value) in _OBJECT_NAMES
    if isinstance(value, bool):
        return cls in (bool, object)
    return isinstance(value, (int, float) if cls is float else cls)


def _give(thing: Any, state: Any) -> None:
    """Give an object its attributes."""
    if hasattr(type(thing), "__setstate__") and not is_dataclass(thing):
        thing.__setstate__(state)
    elif state is not None:
        for name, value in state.items():
            if getattr(thing, name, _MISSING) is not value:
                object.__setattr__(thing, name, value)


def _like(was: Any, now: Any) -> Any:
    """A new value of an attribute, which must be of the kind that the machine has there.

    What a machine just assembled has is never taken away; what it has not yet may come.
    """
    if isinstance(was, tuple) and isinstance(now, tuple) and was and not _sorts(now) <= _sorts(was):
        raise SnapshotError("no snapshot: another kind of value than the machine's")
    both = {type(was), type(now)}
    if was is None or len(both) == 1 or both == {int, float}:
        return now
    if type(was) in _OBJECT_NAMES and type(now) in _OBJECT_NAMES:
        return now
    raise SnapshotError("no snapshot: another kind of value than the machine's")


def _sorts(container: Any) -> set[type | None]:
    """What sorts of thing are in a container: types, None for all that may be made anew."""
    if isinstance(container, bytearray):
        return {float}
    items = container.values() if isinstance(container, dict) else container
    return {_sort(type(item)) for item in items}


def _sort(cls: type) -> type | None:
    """The sort of things of a class; a number may be whole or not."""
    if cls in _MADE:
        return None
    return float if cls is int else cls


def _refill(thing: Any, content: Any) -> None:
    """Let a container of the machine hold other things; it stays the same container."""
    if isinstance(thing, bytearray):
        if thing and len(thing) != len(content):
            raise SnapshotError("no snapshot: memory of another size than the machine's")
        thing[:] = content
    elif isinstance(thing, dict | set):
        thing.clear()
        thing.update(content)
    else:
        thing.clear()
        thing.extend(content)
