"""The cases that cannot pass, each with its reason.

A single or double of exponent 0 is zero whatever its other bytes; on the ROM they are what the
last computation left in the accumulator. Numbers here are values, not accumulators, so the other
bytes of a zero that was computed are 0. And machine code that USR calls is
run only where the extra `z80` is installed.
"""

from __future__ import annotations

from importlib.util import find_spec

ZERO = "reads the meaningless bytes of a computed zero"
MACHINE_CODE = "calls machine code with USR, and the extra z80 is not installed"

EXCEPTIONS: dict[str, str] = {
    "memory-varptr-single": ZERO,
    "memory-varptr-double": ZERO,
    "memory-varptr-poke": ZERO,
    "trans-sin-special": ZERO,
    "trans-log-special": ZERO,
}
"""Case id to reason."""
if find_spec("z80") is None:
    EXCEPTIONS |= dict.fromkeys(("memory-usr-double-it", "memory-usr-string"), MACHINE_CODE)

ROM_EXCEPTIONS: dict[str, str] = {
    "more-keys-e18-0": "which look at the keyboard sees BREAK hangs on some hundred T-states",
}
"""The cases that differ on a ROM: keys at times that the recording kept to a frame only."""
