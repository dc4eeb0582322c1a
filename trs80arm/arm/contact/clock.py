"""The clock of contact: ticks, so many T-states apart.

It stands while everything rests, and goes on with the first latch write after a pause. So the same
motions meet the same things on the same ticks, whenever they begin.
"""

from __future__ import annotations

T_STATES_PER_SECOND = 1_774_080
"""The unit of all times of the arm, and of those on latch writes."""
TICK_STATES = 8192
"""T-states from tick to tick."""
TICK = TICK_STATES / T_STATES_PER_SECOND
"""The same in seconds: 4.6 milliseconds."""
PAUSE = 4 * TICK_STATES
"""T-states for which all has to have been at rest, at least: longer than half-steps of ARMBASIC's
are apart up to D = 575. Motions that are slower are done write by write."""
