"""Another process that takes snapshots, goes on from them and gives snapshots back.

Each message is its length in eight bytes, and then so many bytes. Python's hashes are others there.
"""

from __future__ import annotations

import atexit
import os
import struct
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import BinaryIO

_LENGTH = struct.Struct("<Q")


class Elsewhere:
    """The other process, which ends with this one."""

    def __init__(self) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tests.fuzz.elsewhere"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            cwd=Path(__file__).parents[2],
            env={**os.environ, "PYTHONHASHSEED": "random"},
        )
        atexit.register(self.end)

    def gone_on(self, snapshot: bytes) -> tuple[bytes, bytes]:
        """What a rig there gives as a snapshot: just restored, and after half a second."""
        to, back = self._process.stdin, self._process.stdout
        assert to is not None
        assert back is not None
        _send(to, snapshot)
        return _receive(back), _receive(back)

    def end(self) -> None:
        """Let it end."""
        self._process.kill()
        self._process.communicate()


@cache
def elsewhere() -> Elsewhere:
    """The one other process of this one."""
    return Elsewhere()


def _send(to: BinaryIO, data: bytes) -> None:
    to.write(_LENGTH.pack(len(data)) + data)
    to.flush()


def _receive(back: BinaryIO) -> bytes:
    length = back.read(_LENGTH.size)
    if len(length) < _LENGTH.size:
        raise EOFError("the other process has ended")
    return back.read(*_LENGTH.unpack(length))


def _serve() -> None:
    from trs80arm import Rig

    while True:
        try:
            snapshot = _receive(sys.stdin.buffer)
        except EOFError:
            return
        rig = Rig()
        rig.restore(snapshot)
        _send(sys.stdout.buffer, rig.snapshot())
        rig.run_for(0.5)
        _send(sys.stdout.buffer, rig.snapshot())


if __name__ == "__main__":
    _serve()
