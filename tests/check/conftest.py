"""What the tests of `trs80arm check` share."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from trs80arm.check.findings import Finding
from trs80arm.check.program import check_program

Check = Callable[[str], list[Finding]]


@pytest.fixture
def check(tmp_path: Path) -> Check:
    """Reads the program of a text."""

    def read(text: str) -> list[Finding]:
        path = tmp_path / "p.bas"
        path.write_text(text)
        return check_program(path)

    return read
