"""Golden files: what was drawn, as text to be read in a diff, or as SVG to be looked at.

`TRS80ARM_UPDATE_GOLDEN=1` writes the files instead of comparing.
"""

from __future__ import annotations

import os
from pathlib import Path

FOLDER = Path(__file__).parent / "golden"
UPDATE = "TRS80ARM_UPDATE_GOLDEN"


def check_golden(name: str, text: str, kind: str = "txt") -> None:
    """Compare with the golden file of that name and kind, or write it."""
    path = FOLDER / f"{name}.{kind}"
    if os.environ.get(UPDATE):
        FOLDER.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    assert text == path.read_text(encoding="utf-8")
