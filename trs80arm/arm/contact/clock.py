"""The clock of contact: ticks, so many T-states apart.

It stands while everything rests, and goes on with the first latch write after a pause. So the same
motions meet the same things on the same ticks, whenever they begin.
"""

from __future__ import annotations

T_STATES_PER_SECOND = 1_774_080
"""The unit of all times of the arm, and of those on latch writes."""
TICK_STATES = 8192
"""T-states from tick to tick."""
PAUSE = 2 * TICK_STATES
"""T-states for which all has to have been at rest, at least: longer than any two half-steps of
ARMBASIC's are apart (8.85 ms at D = 255)."""
TICK = TICK_STATES / T_STATES_PER_SECOND
"""The same in seconds: 4.6 milliseconds."""
