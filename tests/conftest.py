"""What tests of every room use."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import settings

# A busy computer is slow, not wrong. Where `CI` is set hypothesis has such a profile of its own.
settings.register_profile("patient", deadline=None)
if "CI" not in os.environ:
    settings.load_profile("patient")

NOBODY = 65534
"""A user who owns nothing."""


@pytest.fixture
def unprivileged() -> Iterator[Path]:
    """A folder of a user without special rights, and that user at the keyboard.

    The superuser may write everywhere, so a test of what may not be written would prove nothing.
    """
    folder = Path(tempfile.mkdtemp(prefix="trs80arm-test-"))
    is_root = os.geteuid() == 0
    if is_root:
        os.chown(folder, NOBODY, NOBODY)
        os.seteuid(NOBODY)
    try:
        yield folder
    finally:
        if is_root:
            os.seteuid(0)
        shutil.rmtree(folder)
