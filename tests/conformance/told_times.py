"""Times of cases, told by the process that played them to the others of a run of the tests.

A case takes the same T-states wherever it is played, so that whoever wants the times of all of them
need not play again what another process has.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path


class ToldTimes:
    """The times, a line a case, in a file of each process.

    Args:
        folder: of all processes of the run.
        process: the name of this one.
    """

    def __init__(self, folder: Path, process: str) -> None:
        self._folder = folder
        self._own = folder / f"case-times-{process}.jsonl"

    def tell(self, case: str, times: Sequence[int]) -> None:
        """Tell the T-states of a case's segments."""
        with self._own.open("a", encoding="utf-8") as file:
            file.write(json.dumps([case, list(times)]) + "\n")

    def known(self) -> dict[str, list[int]]:
        """What was told by now, by case."""
        found: dict[str, list[int]] = {}
        for path in self._folder.glob("case-times-*.jsonl"):
            # The last line may be on its way still.
            *lines, _ = path.read_text("utf-8").split("\n")
            found.update(map(json.loads, lines))
        return found
