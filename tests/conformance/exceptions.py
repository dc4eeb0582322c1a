"""The cases that cannot pass, each with its reason.

A single or double of exponent 0 is zero whatever its other bytes; on the ROM they are what the
last computation left in the accumulator. Numbers here are values, not accumulators, so the other
bytes of a zero that was computed are 0. And there is no Z-80: machine code that USR would call is
not run.
"""

from __future__ import annotations

ZERO = "reads the meaningless bytes of a computed zero"
MACHINE_CODE = "calls machine code with USR"

EXCEPTIONS: dict[str, str] = {
    "memory-varptr-single": ZERO,
    "memory-varptr-double": ZERO,
    "memory-varptr-poke": ZERO,
    "trans-sin-special": ZERO,
    "trans-log-special": ZERO,
    "memory-usr-double-it": MACHINE_CODE,
    "memory-usr-string": MACHINE_CODE,
}
"""Case id to reason."""
