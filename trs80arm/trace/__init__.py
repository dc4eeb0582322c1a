"""Traces: a logic analyser on the card's latches and an eye on the arm, both attached from outside.

`--trace` and `--trace-pose` of the command line and tests use them; the rig knows nothing of them.
"""

from __future__ import annotations

from trs80arm.trace.files import TraceError
from trs80arm.trace.latches import Trace
from trs80arm.trace.pose import PoseTrace

__all__ = ["PoseTrace", "Trace", "TraceError"]
