"""The programs that come with trs80arm: the article's tables and their benches.

In a checkout they stand beside the package, in an installed one in its environment's shared folder.
"""

from __future__ import annotations

import sys
from pathlib import Path

_PLACES = (
    Path(__file__).parents[1] / "programs",
    Path(sys.prefix) / "share" / "trs80arm" / "programs",
)


def programs_folder() -> Path | None:
    """The folder with `table4.bas` and the others; None where they were not installed."""
    for folder in _PLACES:
        if (folder / "table4.bas").is_file():
            return folder
    return None
