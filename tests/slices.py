"""Runs cut into slices, and gone on with in another machine."""

from __future__ import annotations

from collections.abc import Container, Iterable

from trs80arm import Rig


def elsewhere(rig: Rig) -> Rig:
    """Another machine, that a snapshot has brought to where this one is."""
    other = Rig()
    other.restore(rig.snapshot())
    return other


def sliced(rig: Rig, slices: Iterable[float], moves: Container[int]) -> Rig:
    """The machine after some slices of time.

    Args:
        rig: the machine.
        slices: seconds of each.
        moves: after which of them it goes on elsewhere.
    """
    for k, seconds in enumerate(slices):
        rig.run_for(seconds)
        if k in moves:
            rig = elsewhere(rig)
    return rig
