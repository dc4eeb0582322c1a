"""The driver as its source says it is, and what is shipped of it."""

from __future__ import annotations

import re
import runpy
import subprocess
import sys
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

DOCS = Path(__file__).parents[3] / "docs"
PAGE = DOCS / "armbasic-z80.md"


@cache
def maker() -> Any:
    """What docs/make_armbasic_z80.py defines."""
    return SimpleNamespace(**runpy.run_path(str(DOCS / "make_armbasic_z80.py")))


@cache
def driver(kilobytes: int = 16) -> Any:
    """The driver assembled for a machine with so much RAM."""
    return maker().assemble(maker().ORIGINS[kilobytes])


def blocks(kind: str) -> list[str]:
    """The examples of a kind in docs/armbasic-z80.md."""
    return re.findall(rf"```{kind}\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)


def assembled(source: str, folder: Path) -> bytes:
    """What the assembler makes of a source."""
    text, image = folder / "source.asm", folder / "image"
    text.write_text(source)
    command = [sys.executable, "-m", "pyz80.pyz80", f"--obj={image}", str(text)]
    subprocess.run(command, check=True, capture_output=True)
    return image.read_bytes()
