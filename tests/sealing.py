"""Snapshots of a content that somebody made up."""

from __future__ import annotations

import hashlib
import json
from typing import Any

from trs80arm.snapshots import FORMAT


def sealed(content: Any) -> bytes:
    """A snapshot with the right length and checksum, whatever is in it."""
    text = json.dumps(content).encode()
    return f"{FORMAT} {len(text)} {hashlib.sha256(text).hexdigest()}\n".encode() + text
