"""A session on paper: everything the operator did, one JSON value a line.

The first line says which machine it was; each other line is one `Input` of the rig with its virtual
time in T-states. Played into the same machine it gives the same run, to the last bit.
"""

from __future__ import annotations

import json
from dataclasses import astuple, dataclass
from pathlib import Path
from typing import Any

from trs80arm import __version__
from trs80arm.arm.bench import Bench, BenchError
from trs80arm.desk.greeting import greet
from trs80arm.plain_values import SettingsError, as_table, from_table
from trs80arm.rig import Input, Pose, Rig, RigSettings
from trs80arm.saving import write_whole

FORMAT = "trs80arm session 1"
ACTIONS = frozenset(
    (
        "press",
        "release",
        "release_all",
        "hold",
        "type",
        "stop_typing",
        "load_lines",
        "reset",
        "set_bench",
        "refill",
        "move_joint",
        "move_to",
        "step_statement",
    )
)
"""What may stand in a recording: the methods of `Rig` that it records."""
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
        """The machine that it was recorded on, switched on."""
        rig = Rig(self.settings, _bench(self.bench))
        if self.greeting:
            greet(rig.console)
        return rig


def _bench(text: str | None) -> Bench | None:
    return None if text is None else Bench.from_toml(text, "the recording's bench")


class Journal:
    """Keeps everything that is done to a rig since it was switched on.

    Args:
        rig: the machine, freshly switched on.
        bench: the text of the bench file that it was built with, None for the standard bench.
        path: a file that is kept up to date as things happen.
        greeting: whether the tube shows the greeting.

    Attributes:
        bench_text: the text of the bench that is about to be set up, for a `Bench` has none.

    Raises:
        OSError: the file cannot be written.
    """

    def __init__(
        self, rig: Rig, bench: str | None, path: Path | None = None, *, greeting: bool = False
    ) -> None:
        self._rig = rig
        self.bench_text: str | None = bench
        head = {
            "format": FORMAT,
            "version": __version__,
            "machine": as_table(rig.settings),
            "bench": bench,
            "greeting": greeting,
        }
        self._lines = [json.dumps(head)]
        self._file = path.open("w", encoding="utf-8") if path else None
        self._write(self._lines[0])
        self._stop = rig.record(self._take)

    def _take(self, done: Input) -> None:
        arguments = [self._plain(value) for value in done.arguments]
        line = json.dumps({"t": done.time, "do": done.action, "with": arguments})
        self._lines.append(line)
        self._write(line)

    def _write(self, line: str) -> None:
        if self._file is not None:
            self._file.write(line + "\n")
            self._file.flush()

    def _plain(self, value: Any) -> Any:
        if isinstance(value, Pose):
            return {"pose": list(astuple(value))}
        if isinstance(value, Bench):
            return {"bench": self.bench_text}
        if isinstance(value, bytes):
            return {"hex": value.hex()}
        if isinstance(value, list | tuple):
            return [self._plain(item) for item in value]
        return value

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
        if self._file is not None:
            self._write(self._end())
            self._file.close()
            self._file = None


def load(path: Path) -> Recording:
    """Read a recording.

    Raises:
        RecordingError: a line of it is no part of a recording.
        OSError: it cannot be read.
    """
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except UnicodeDecodeError:
        raise RecordingError(f"{path}: not a recording: it is no text") from None
    settings, bench, greeting = _head(path, lines[0] if lines else "")
    inputs: list[Input] = []
    time = 0
    for number, line in enumerate(lines[1:], start=2):
        try:
            done = _input(line)
        except (ValueError, TypeError, KeyError, BenchError) as error:
            raise RecordingError(f"{path}: line {number}: {error}") from None
        if done.time < time:
            raise RecordingError(f"{path}: line {number}: goes back in time")
        time = done.time
        if done.action != END:
            inputs.append(done)
    return Recording(settings, bench, greeting, tuple(inputs), time)


def _head(path: Path, line: str) -> tuple[RigSettings, str | None, bool]:
    try:
        head = json.loads(line)
        if head["format"] != FORMAT:
            raise ValueError("of another format")
        settings = from_table(RigSettings, head["machine"], "machine")
        _bench(head["bench"])
        return settings, head["bench"], bool(head.get("greeting"))
    except (ValueError, TypeError, KeyError, SettingsError, BenchError) as error:
        raise RecordingError(f"{path}: line 1: no head of a recording ({error})") from None


def _input(line: str) -> Input:
    entry = json.loads(line)
    action = entry["do"]
    if action not in ACTIONS and action != END:
        raise ValueError(f"nothing is called {action!r}")
    return Input(int(entry["t"]), action, tuple(_rich(value) for value in entry["with"]))


def _rich(value: Any) -> Any:
    if isinstance(value, list):
        return [_rich(item) for item in value]
    if not isinstance(value, dict):
        return value
    [(kind, content)] = value.items()
    if kind == "pose":
        return Pose(*content)
    if kind == "hex":
        return bytes.fromhex(content)
    if kind == "bench":
        return _bench(content) or Bench.standard()
    raise ValueError(f"nothing is called {kind!r}")
