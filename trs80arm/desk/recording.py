"""A session on paper: everything the operator did, one JSON value a line.

The first line says which machine it was; each other line is one `Input` of the rig with its virtual
time in T-states. Played into the same machine it gives the same run, to the last bit.

A recording may come from a stranger. It names no file and no folder: a machine that plays one has
its cassettes and its printer's paper in memory. Every line is looked at while it is loaded, so that
what plays can be done by somebody at the keyboard.
"""

from __future__ import annotations

import contextlib
import io
import json
from collections.abc import Callable, Sequence
from dataclasses import astuple, dataclass, replace
from functools import partial
from pathlib import Path
from typing import Annotated, Any

from trs80arm import __version__
from trs80arm.arm import benchfile
from trs80arm.arm.bench import Bench, BenchError
from trs80arm.desk.greeting import greet
from trs80arm.files import MAX_LINE_NUMBER
from trs80arm.machine.clock import END_OF_TIME
from trs80arm.machine.tape import LONGEST as LONGEST_TAPE
from trs80arm.machine.tape import is_cassette_name
from trs80arm.paths import open_to_read
from trs80arm.plain_values import Range, SettingsError, Table, as_table, fit, from_table
from trs80arm.reasons import reason
from trs80arm.rig import LONGEST_HOLD, TURNED_BY_HAND, Input, Key, Pose, Rig, RigSettings
from trs80arm.saving import open_to_write, write_whole
from trs80arm.serial.pendant_keys import key_named

FORMAT = "trs80arm session 1"
LARGEST = 64 * 1024 * 1024
"""Bytes of a recording that is read: some days of somebody at the keyboard."""
END = "end"
"""The last line: nothing is done, but time passes up to it."""


class RecordingError(Exception):
    """A recording that cannot be played; one line that names the file and its line."""


@dataclass(frozen=True)
class Recording:
    """A session that can be played.

    Attributes:
        settings: the machine's fittings.
        bench: the text of the bench file, None for the standard bench.
        greeting: whether the tube showed the greeting.
        inputs: what the operator did.
        end: the T-state at which the recording ends.
    """

    settings: RigSettings
    bench: str | None
    greeting: bool
    inputs: tuple[Input, ...]
    end: int

    def rig(self) -> Rig:
        """A machine like the one that it was recorded on, switched on, with tapes in memory."""
        rig = Rig(self.settings, _bench(self.bench))
        if self.greeting:
            greet(rig.console)
        return rig


def _bench(text: str | None) -> Bench | None:
    return None if text is None else benchfile.parse(text, "the recording's bench")


class Journal:
    """Keeps everything that is done to a rig since it was switched on.

    Args:
        rig: the machine, freshly switched on.
        bench: the text of the bench file that it was built with, None for the standard bench.
        path: a file that is kept up to date as things happen.
        greeting: whether the tube shows the greeting.

    Attributes:
        bench_text: the text of the bench that is about to be set up, for a `Bench` has none.
        fault: why the file that is kept up to date is so no more, in one line; None if all is well.

    Raises:
        OSError: the file cannot be written from the start.
    """

    def __init__(
        self, rig: Rig, bench: str | None, path: Path | None = None, *, greeting: bool = False
    ) -> None:
        self._rig = rig
        self.bench_text: str | None = bench
        self._first_bench = bench
        self._benches: list[tuple[Bench, str | None]] = []
        head = {
            "format": FORMAT,
            "version": __version__,
            "machine": as_table(replace(rig.settings, tape_folder=None, printer_file=None)),
            "bench": bench,
            "greeting": greeting,
        }
        self._lines = [json.dumps(head)]
        self.fault: str | None = None
        self._file = io.TextIOWrapper(open_to_write(path), "utf-8") if path else None
        self._path = path
        self._begin()
        self._stop = rig.record(self._take)

    def _begin(self) -> None:
        """Write the head; a file that cannot take it is closed."""
        if self._file is None:
            return
        try:
            self._file.write(self._lines[0] + "\n")
            self._file.flush()
        except OSError as error:
            self._shut()
            raise OSError(error.errno, error.strerror, str(self._path)) from None

    def _take(self, done: Input) -> None:
        arguments = [self._plain(value) for value in done.arguments]
        line = json.dumps({"t": done.time, "do": done.action, "with": arguments})
        self._lines.append(line)
        self._write(line)

    def _write(self, line: str) -> None:
        """Add a line to the file; what has become of the disk is no fault of the machine's."""
        if self._file is None:
            return
        try:
            self._file.write(line + "\n")
            self._file.flush()
        except OSError as error:
            self._failed(error)

    def _failed(self, error: OSError) -> None:
        self.fault = f"{self._path}: {reason(error)}; recording to it has ended"
        self._shut()

    def _shut(self) -> None:
        if self._file is not None:
            # Closing writes what is left, which may fail again.
            with contextlib.suppress(OSError):
                self._file.close()
            self._file = None

    def _plain(self, value: Any) -> Any:
        if isinstance(value, Pose):
            return {"pose": list(astuple(value))}
        if isinstance(value, Bench):
            return {"bench": self._text_of(value)}
        if isinstance(value, bytes):
            return {"hex": value.hex()}
        if isinstance(value, list | tuple):
            return [self._plain(item) for item in value]
        return value

    def _text_of(self, bench: Bench) -> str | None:
        """The text of a bench that is set up: the one at hand, or its own if it was up before."""
        for known, text in self._benches:
            if known is bench:
                return text
        self._benches.append((bench, self.bench_text))
        return self.bench_text

    def cut(self, count: int) -> None:
        """Only so many things were done, the first ones; what came later was not."""
        self._become(self._lines[: 1 + count])

    def take_up(self, lines: Sequence[str]) -> None:
        """Another machine is on the desk, with the lines of its recording, the head first."""
        self._first_bench = json.loads(lines[0]).get("bench")
        self._become(lines)
        # It is told of what is done after everybody else, as it was from the start.
        self._stop()
        self._stop = self._rig.record(self._take)

    def _become(self, lines: Sequence[str]) -> None:
        self._lines[:] = lines
        setups = [entry for entry in map(json.loads, self._lines) if entry.get("do") == "set_bench"]
        self.bench_text = setups[-1]["with"][0]["bench"] if setups else self._first_bench
        if self._file is None:
            return
        try:
            self._file.seek(0)
            self._file.truncate()
            self._file.write("\n".join([*self._lines, ""]))
            self._file.flush()
        except OSError as error:
            self._failed(error)

    @property
    def lines(self) -> Sequence[str]:
        """What was done, as lines of a recording, its head first."""
        return tuple(self._lines)

    def _end(self) -> str:
        return json.dumps({"t": self._rig.clock.now, "do": END, "with": []})

    def save(self, path: Path) -> None:
        """Write what was done so far, whole or not at all.

        Raises:
            OSError: the file cannot be written.
        """
        write_whole(path, "\n".join([*self._lines, self._end(), ""]).encode())

    def close(self) -> None:
        """End the journal and the file that it keeps."""
        self._stop()
        self._write(self._end())
        self._shut()


def load(path: Path) -> Recording:
    """Read a recording from a file.

    Raises:
        RecordingError: it is no recording.
        OSError: it cannot be read.
    """
    with open_to_read(path) as file:
        data = file.read(LARGEST + 1)
    return parse(data, str(path))


def parse(data: bytes, source: str = "recording") -> Recording:
    """Read a recording, looking at everything in it.

    Args:
        data: the content of the file.
        source: what errors call it.

    Raises:
        RecordingError: for any bytes that are no recording; one line that names the line.
    """
    if len(data) > LARGEST:
        raise RecordingError(f"{source}: longer than {LARGEST >> 20} MB")
    try:
        lines = data.decode("utf-8").splitlines()
    except UnicodeDecodeError:
        raise RecordingError(f"{source}: not a recording: it is no text") from None
    number = 1
    try:
        settings, bench, greeting = _head(_object(lines[0] if lines else "", "line 1"))
        inputs: list[Input] = []
        time = 0
        for number, line in enumerate(lines[1:], start=2):
            done = _input(_object(line, f"line {number}"), earliest=time)
            time = done.time
            if done.action != END:
                inputs.append(done)
    except (SettingsError, BenchError) as error:
        raise RecordingError(f"{source}: {error}") from None
    except ValueError as error:
        raise RecordingError(f"{source}: line {number}: {error}") from None
    return Recording(settings, bench, greeting, tuple(inputs), time)


def _object(line: str, where: str) -> Table:
    try:
        return Table(where, "", json.loads(line))
    except (ValueError, RecursionError):
        raise SettingsError(f"{where}: no JSON object") from None


def _head(head: Table) -> tuple[RigSettings, str | None, bool]:
    if head.data.pop("format", None) != FORMAT:
        raise head.fail("format", f"the words {FORMAT!r}, with which a recording begins")
    head.take("version", str, "")
    machine = head.data.pop("machine", None)
    if not isinstance(machine, dict):
        raise head.fail("machine", "a table of settings")
    for place in ("tape_folder", "printer_file"):
        if machine.pop(place, None) is not None:
            raise head.fail(f"machine.{place}", "nothing: a recording names no files")
    settings = from_table(RigSettings, machine, "line 1: machine")
    if settings.rom is not None:
        raise head.fail("machine.rom", "nothing: a machine that runs its owner's ROM is not played")
    bench = head.take("bench", str | None, None)
    _bench(bench)
    greeting = head.take("greeting", bool, False)
    head.done("format, version, machine, bench, greeting")
    return settings, bench, greeting


def _input(entry: Table, earliest: int) -> Input:
    time = entry.integer("t", 0, END_OF_TIME)
    if time < earliest:
        raise entry.fail("t", f"a time from {earliest} on, for it cannot go back")
    action = entry.take("do", str)
    values = entry.data.pop("with", None)
    if not isinstance(values, list):
        raise entry.fail("with", "a list")
    entry.done("t, do, with")
    if action == END:
        wanted: tuple[Callable[[Any], Any], ...] = ()
    elif action in ACTIONS:
        wanted = ACTIONS[action]
    else:
        raise entry.fail("do", f"one of {', '.join(ACTIONS)}, {END}")
    if len(values) != len(wanted):
        raise entry.fail("with", f"a list of {len(wanted)}")
    arguments = []
    for read, value in zip(wanted, values, strict=True):
        try:
            arguments.append(read(value))
        except SettingsError as error:
            raise SettingsError(f"{entry.source}: {action}: {error}") from None
    return Input(time, action, tuple(arguments))


def _key(value: Any) -> str:
    return str(fit(Key, value))


def _keys(value: Any) -> list[str]:
    return list(map(str, fit(tuple[Key, ...], value)))


def _joint(value: Any) -> str:
    if value not in TURNED_BY_HAND:
        raise SettingsError(f"expected one of {', '.join(TURNED_BY_HAND)}")
    return str(value)


def _program(value: Any) -> list[tuple[int, bytes]]:
    if not isinstance(value, list):
        raise SettingsError("expected a list of lines")
    return [_line(item) for item in value]


def _line(value: Any) -> tuple[int, bytes]:
    if not isinstance(value, list) or len(value) != 2:
        raise SettingsError("expected lines of a number and a text")
    number = fit(Annotated[int, Range(0, MAX_LINE_NUMBER)], value[0])
    text = bytes.fromhex(fit(str, _named(value[1], "hex")))
    if 0 in text:
        raise SettingsError("expected a line without a zero in it, which would end it")
    return number, text


def _cassette_name(value: Any) -> str:
    name: str = fit(str, value)
    if not is_cassette_name(name):
        raise SettingsError("expected the plain name of a cassette")
    return name


def _cassette_content(value: Any) -> bytes:
    content = bytes.fromhex(fit(str, _named(value, "hex")))
    if len(content) > LONGEST_TAPE:
        raise SettingsError("expected no more than a cassette holds")
    return content


def _received(value: Any) -> bytes:
    return bytes.fromhex(fit(str, _named(value, "hex")))


def _pendant_key(value: Any) -> str:
    name: str = fit(str, value)
    try:
        key_named(name)
    except ValueError:
        raise SettingsError("expected a key of the teach pendant") from None
    return name


def _pose(value: Any) -> Pose:
    x, y, z, pitch, roll, opening = fit(_SIX_NUMBERS, _named(value, "pose"))
    return Pose(x, y, z, pitch, roll, opening)


def _bench_again(value: Any) -> Bench:
    return _bench(fit(str | None, _named(value, "bench"))) or Bench.standard()


def _named(value: Any, kind: str) -> Any:
    """What stands in an object of one key, which says what it is."""
    if not isinstance(value, dict) or list(value) != [kind]:
        raise SettingsError(f'expected {{"{kind}": ...}}')
    return value[kind]


_Number = Annotated[float, Range(-1000, 1000)]
_SIX_NUMBERS = tuple[_Number, _Number, _Number, _Number, _Number, _Number]

ACTIONS: dict[str, tuple[Callable[[Any], Any], ...]] = {
    "press": (_key,),
    "release": (_key,),
    "release_all": (),
    "push_reset": (),
    "hold": (_keys, partial(fit, Annotated[float, Range(0, LONGEST_HOLD)])),
    "type": (partial(fit, str),),
    "stop_typing": (),
    "load_lines": (_program,),
    "reset": (),
    "set_bench": (_bench_again,),
    "refill": (),
    "move_joint": (_joint, partial(fit, _Number)),
    "move_to": (_pose,),
    "pull": (partial(fit, _Number),) * 3,
    "let_go": (),
    "receive": (_received,),
    "hang_up": (),
    "press_pendant": (_pendant_key,),
    "release_pendant": (_pendant_key,),
    "change": (partial(fit, str),),
    "step_statement": (),
    "insert_cassette": (_cassette_name, _cassette_content),
    "rewind_cassette": (),
    "eject_cassette": (),
    "tear_off_paper": (),
}
"""What may stand in a recording: the methods of `Rig` that it records, and what each is given."""
