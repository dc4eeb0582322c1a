"""The clock of contact: ticks on a grid of T-states."""

from __future__ import annotations

T_STATES_PER_SECOND = 1_774_080
"""The unit of all times of the arm, and of those on latch writes."""
TICK_STATES = 8192
"""T-states from tick to tick."""
TICK = TICK_STATES / T_STATES_PER_SECOND
"""The same in seconds: 4.6 milliseconds."""
