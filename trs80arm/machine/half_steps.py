"""Figure 8 of the article: the ring of eight coil patterns that turns a motor by half steps.

Software writes these patterns to the latches; the motors know nothing of them but the coils. The
driver steps through the ring, the trace reads it backwards.
"""

from __future__ import annotations

HALF_STEPS: tuple[int, ...] = (0b0101, 0b0100, 0b0110, 0b0010, 0b1010, 0b1000, 0b1001, 0b0001)
"""The rows of Figure 8 from top to bottom, phi1 as bit 3 and phi4 as bit 0, 1 = coil energised.

Down the table is clockwise and a positive count (arm facts, sections 1 and 4); it wraps around.
"""

RING = len(HALF_STEPS)
"""Half-steps after which the pattern, and with it the pull on the rotor, comes again."""

COILS_OFF = 0
"""The pattern without current: the motor can be turned by hand."""
