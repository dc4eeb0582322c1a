"""Clients of the serial line that hang up at once."""

from __future__ import annotations

import importlib.util
from types import SimpleNamespace

import pytest


@pytest.fixture(autouse=True)
def hang_up_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the 0.3 s that pyserial waits at the end of each socket.

    It wants to spare servers those who come again too soon; this one is there for them at once.
    """
    if importlib.util.find_spec("serial") is not None:
        unhurried = "serial.urlhandler.protocol_socket.time"
        monkeypatch.setattr(unhurried, SimpleNamespace(sleep=lambda seconds: None))
