"""Assembles programs/catch.asm to programs/catch.cas, a tape for SYSTEM.

    python docs/make_catch.py

The assembler is pyz80, of the extra `test`.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

from trs80arm.machine.cassette import SystemRecording, encode_system

ROOT = Path(__file__).parents[1]
SOURCE = ROOT / "programs" / "catch.asm"
TAPE = ROOT / "programs" / "catch.cas"
ORIGIN = 0x7000
BLOCK = 128
"""Bytes of a block on the tape."""


def tape() -> bytes:
    """The cassette."""
    with tempfile.TemporaryDirectory() as folder:
        image = Path(folder) / "image"
        command = [sys.executable, "-m", "pyz80.pyz80", f"--obj={image}", str(SOURCE)]
        subprocess.run(command, check=True, capture_output=True)
        code = image.read_bytes()
    blocks = tuple((ORIGIN + at, code[at : at + BLOCK]) for at in range(0, len(code), BLOCK))
    return encode_system(SystemRecording(b"CATCH", blocks, ORIGIN))


if __name__ == "__main__":
    TAPE.write_bytes(tape())
