"""The runs of a sweep that are done, kept beside its CSV until all are: broken off, it goes on.

A file `runs.csv.part`: the first line says which sweep it is of, each further one is a run, in the
order in which they are done. It goes away when the CSV is there.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import asdict
from hashlib import sha256
from pathlib import Path
from typing import get_type_hints

from trs80arm import __version__
from trs80arm.locks import hold
from trs80arm.paths import is_file, open_to_read
from trs80arm.plain_values import SettingsError, fit
from trs80arm.saving import open_to_write
from trs80arm.sweep.axes import Axis, SweepError
from trs80arm.sweep.running import Case, Plan, Result

SUFFIX = ".part"
LARGEST = 1024 * 1024 * 1024
"""Bytes of a journal that is read: that of the longest sweep has a third of it."""


def mark(plan: Plan, axes: Sequence[Axis], each: Sequence[Case]) -> str:
    """What tells a sweep from every other: all that its results depend on."""
    settings = {case.values: case.settings for case in each}
    return sha256(repr((__version__, plan, axes, len(each), settings)).encode()).hexdigest()


class Journal:
    """The file of one sweep.

    Args:
        output: the CSV that is to be written.
        mark: of the sweep.
        each: its runs.

    Attributes:
        path: of the file.
        results: of the first runs, done before.
    """

    def __init__(self, output: Path, mark: str, each: Sequence[Case]) -> None:
        self.path = output.with_name(output.name + SUFFIX)
        self._mark = mark
        self.results: list[Result] = []
        if is_file(self.path):
            with open_to_read(self.path) as file:
                lines = file.read(LARGEST).decode("utf-8", "replace").splitlines()
            if lines and lines[0] == mark:
                self.results.extend(_read(lines[1:], each))

    @contextmanager
    def keep(self, results: Iterable[Result]) -> Iterator[Iterator[Result]]:
        """Pass on the results of the other runs, each kept until the block has ended well.

        Raises:
            SweepError: another process is at the same sweep.
            OSError: the file cannot be written.
        """
        with open_to_write(self.path, append=True) as file:
            try:
                hold(file)
            except BlockingIOError:
                raise SweepError(f"{self.path}: another sweep is writing to it") from None
            file.truncate(0)

            def kept() -> Iterator[Result]:
                file.write(f"{self._mark}\n".encode())
                for result in self.results:
                    file.write(_line(result))
                file.flush()
                for result in results:
                    file.write(_line(result))
                    file.flush()
                    yield result

            yield kept()
        with suppress(OSError):
            self.path.unlink()


def _line(result: Result) -> bytes:
    return (json.dumps(asdict(result)) + "\n").encode()


def _read(lines: Sequence[str], each: Sequence[Case]) -> Iterator[Result]:
    """The results, as far as they are whole and those of the runs in their order."""
    for line, case in zip(lines, each, strict=False):
        try:
            told = json.loads(line)
            fields = get_type_hints(Result).items()
            result = Result(**{name: fit(kind, told[name]) for name, kind in fields})
        except (ValueError, TypeError, KeyError, SettingsError, RecursionError):
            return
        if (result.values, result.run) != (case.values, case.run):
            return
        yield result
