"""The emulated Z-80 itself: the package `z80`, loaded when machine code first runs.

The package is an extra. Whoever never runs machine code neither needs nor loads it.
"""

from __future__ import annotations

from functools import cache
from importlib.util import find_spec
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from z80 import Z80Machine

HEAD = 44
"""Bytes of the state in front of the memory: registers, flip-flops and counters."""
NOT_INSTALLED = "machine code needs the extra z80: pip install 'trs80arm[z80]'"


class NoProcessorError(Exception):
    """The package `z80` is not installed, or is another one; one clear line."""


@cache
def available() -> bool:
    """Whether the package is there; it is not loaded to find out."""
    try:
        return find_spec("z80") is not None
    except ValueError:
        return False  # Somebody has shut it out.


def new_chip() -> tuple[Z80Machine, memoryview]:
    """A Z-80 as it comes out of its bag, and the bytes of its whole state, memory included.

    Raises:
        NoProcessorError: the package is not there.
    """
    try:
        from z80 import Z80Machine
    except ImportError:
        raise NoProcessorError(NOT_INSTALLED) from None
    chip = Z80Machine()
    state = chip.get_state_view()
    if len(state) != HEAD + 0x10000:
        raise NoProcessorError("the package z80 that is installed is not the one that is needed")
    return chip, state
