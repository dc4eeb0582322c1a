"""How an arm goes through a burst: in strides while nothing happens, else write by write."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trs80arm.arm.burst import LONGEST, run_free
from trs80arm.arm.cell.device import NEVER
from trs80arm.arm.contact.clock import PAUSE
from trs80arm.arm.model import HAND
from trs80arm.arm.stride import stride
from trs80arm.pulses import Burst

if TYPE_CHECKING:
    from trs80arm.arm.minimover import MiniMover

SHORT = 16
"""Writes in a burst below which they are done one by one."""
FEW = 4
"""Writes done one by one where something may happen, before it is looked at again."""


def follow_burst(arm: MiniMover, burst: Burst, stop: tuple[int, int] | None) -> int:
    """`MiniMover.follow`, without having the load be shown where it is."""
    count = len(burst)
    if count < SHORT or (stop is not None and stop[0] & 0b1110 and arm.bench.sensors):
        return _follow_singly(arm, burst, None, stop)[0]
    rest, size, patience = burst, count, FEW
    while size:
        if size >= SHORT:
            arm.let_pass(rest.begins)
            arm.world.begins(rest.begins)
        if size >= SHORT and arm.free:
            near = _uninterrupted(arm, rest)
            left, ended = _stride(arm, near, stop)
            done = len(near) - len(left)
            if ended:
                return count - size + done
            # Where something happens it goes on happening for a while.
            patience = FEW if done else min(2 * patience, 8 * SHORT)
            rest = left if near is rest else rest.split(done)[1]
            size -= done
            if not size:
                break
        few, rest = rest.first(min(size, patience if arm.free else FEW))
        then = rest.begins if stop is not None and rest else None
        done, ended = _follow_singly(arm, few, then, stop)
        if ended:
            return count - size + done
        size -= done
    return count


def _uninterrupted(arm: MiniMover, burst: Burst) -> Burst:
    """The writes before a device acts of itself, or the clock of contact may come to stand."""
    burst, alarm = burst.before_pause(PAUSE), arm.world.alarm
    if alarm == NEVER or alarm > burst.ends:
        return burst
    return burst.until(alarm)[0]


def _stride(arm: MiniMover, burst: Burst, stop: tuple[int, int] | None) -> tuple[Burst, bool]:
    """As much of a burst at once as can be; what is left, and whether it was stopped there."""
    ahead = _hand_ahead(arm, burst, stop)
    if ahead < len(burst):
        near = burst.split(ahead)[0]
        left = stride(arm, near, stop) if near else near
        done = 0 if left is None else len(near) - len(left)
        return burst.split(done)[1], False
    left = stride(arm, burst, stop)
    if left is not None:
        return left, False
    some, beyond = burst.split(min(len(burst), LONGEST))
    then = beyond.begins if beyond else None
    done, ended = run_free(arm, some.columns(), then, stop)
    return burst.split(done)[1], ended


def _hand_ahead(arm: MiniMover, burst: Burst, stop: tuple[int, int] | None) -> int:
    """Writes at the beginning of a burst up to which the hand alone cannot come to its end.

    Its end is where it is shut or wide open, squeezes as hard as it can, or closes the switch.
    """
    grip, model = arm.grip, arm.model
    if not burst.only(HAND):
        return len(burst)
    if grip.contact:
        hand = model.hand
        most = hand.most_squeeze if stop is None else hand.switch_steps
        room = most - 1 - int(grip.squeeze)
    elif grip.cable > 0:
        room = min(int(model.hand.range * model.hand_steps) - grip.cable, grip.cable)
    else:
        return len(burst)
    return max(0, min(len(burst), room - 2))


def _follow_singly(
    arm: MiniMover, burst: Burst, then: int | None, stop: tuple[int, int] | None
) -> tuple[int, bool]:
    """Do writes one by one.

    Args:
        arm: the arm.
        burst: the writes.
        then: T-state of the write after them, if they are the beginning of a burst that has a stop.
        stop: as for `MiniMover.follow`.

    Returns:
        How many were done, and whether they were stopped there.
    """
    writes, write = burst.columns(), arm.write
    times, latches, nibbles = writes.times, writes.latches, writes.nibbles
    if stop is None:
        for time, latch, nibble in zip(times, latches, nibbles, strict=True):
            write(int(time), int(latch), int(nibble))
        return len(times), False
    mask, value = stop
    for done, latch in enumerate(latches, start=1):
        time = int(times[done - 1])
        write(time, int(latch), int(nibbles[done - 1]))
        after = times[done] if done < len(times) else then
        if after != time and arm.inputs(time) & mask == value:
            return done, True
    return len(times), False
