"""SP and the pace that it stands for."""

from __future__ import annotations

from itertools import pairwise

import pytest

from trs80arm.serial.protocol import FASTEST
from trs80arm.serial.speeds import delay_of, speed_of


def rate(speed: int) -> float:
    return 1000 / (1.2 + 0.03 * delay_of(speed))


def test_the_one_rate_that_is_known() -> None:
    assert rate(183) == pytest.approx(141, abs=0.5)


def test_a_greater_speed_is_faster() -> None:
    rates = [rate(speed) for speed in range(FASTEST + 1)]
    assert all(slower < faster for slower, faster in pairwise(rates))
    assert rate(0) == pytest.approx(45, abs=1)
    assert rate(FASTEST) == pytest.approx(497, abs=1)


def test_the_speed_of_a_delay_is_the_greatest_that_is_not_faster() -> None:
    for delay in range(800):
        speed = speed_of(delay)
        assert speed == 0 or delay_of(speed) >= delay
        assert delay_of(speed + 1) < delay or speed == 255
    assert [speed_of(delay_of(speed)) for speed in range(256)] == list(range(256))
