"""The functions in straight lines have the bits of the same step by step."""

from __future__ import annotations

import math
import random
from collections.abc import Callable

import numpy as np
import pytest

from trs80arm.basic.errors import BasicError
from trs80arm.basic.numbers import functions, step_by_step, together
from trs80arm.basic.numbers.single import mul, round_away

NAMES = ("sin", "cos", "tan", "atn", "log", "exp")
EDGES = (math.pi / 4, math.log(2.0) / 2, math.sqrt(0.5), 0.25, 1.0)
"""Near multiples of these, and times powers of two, the ways part."""


def arguments(seed: int, count: int) -> list[float]:
    """Singles: of all magnitudes, of the usual ones, round ones, and those near an edge."""
    chance = random.Random(seed)
    found = [0.0]
    for _ in range(count):
        sign = chance.choice((1.0, 1.0, -1.0))
        mantissa = chance.getrandbits(23) | 0x800000
        edge = chance.choice(EDGES) * chance.randint(1, 40) * 2.0 ** chance.randint(-4, 4)
        near = round_away(edge) * (1.0 + chance.randint(-6, 6) * 2.0**-23)
        found += [
            sign * math.ldexp(mantissa, chance.randint(-126, 126) - 24),
            sign * math.ldexp(mantissa, chance.randint(-12, 10) - 24),
            sign * round_away(chance.randint(0, 1000) / chance.choice((1, 2, 4, 8, 10, 100))),
            sign * round_away(near),
        ]
    return found


def answer(function: Callable[..., float], *operands: float) -> float | str:
    """The result, or the error's name."""
    try:
        return function(*operands)
    except BasicError as error:
        return str(error)


@pytest.mark.parametrize("name", NAMES)
def test_a_function_in_straight_lines_has_the_bits_of_its_steps(name: str) -> None:
    straight, steps = getattr(functions, name), getattr(step_by_step, name)
    for x in arguments(1, 2500):
        assert answer(straight, x) == answer(steps, x), x


def test_a_power_is_the_exponential_of_a_logarithm_step_by_step() -> None:
    def steps(base: float, exponent: float) -> float:
        return step_by_step.exp(mul(exponent, step_by_step.log(base)))

    bases = [x for x in arguments(2, 2000) if x > 0.0]
    exponents = [x for x in arguments(3, 2000) if x]
    for base, exponent in zip(bases, exponents, strict=False):
        assert answer(functions.power, base, exponent) == answer(steps, base, exponent)
        assert answer(functions.sqr, base) == answer(steps, base, 0.5)


def test_nearly_all_usual_arguments_take_the_straight_lines(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    fallen: list[float] = []

    def count(x: float) -> float:
        fallen.append(x)
        return 1.0

    for name in NAMES:
        monkeypatch.setattr(step_by_step, name, count)
    chance = random.Random(4)
    for _ in range(1000):
        functions.sin(round_away(chance.uniform(-20.0, 20.0)))
        functions.atn(round_away(chance.uniform(-4.0, 4.0)))
        functions.exp(round_away(chance.uniform(-20.0, 20.0)))
        functions.log(round_away(chance.uniform(0.01, 100.0)))
    assert len(fallen) < 120


@pytest.mark.parametrize("name", ["sin", "cos", "atn", "log", "exp", "sqr"])
def test_a_function_of_an_array_has_the_bits_of_one_argument_after_the_other(name: str) -> None:
    straight = getattr(functions, name)
    given = arguments(4, 1500)
    _compared(together.FUNCTIONS[name], straight, given)


@pytest.mark.parametrize("exponent", [2.0, 3.0, 0.5, -1.5, 1.7])
def test_a_power_of_an_array_has_the_bits_of_one_base_after_the_other(exponent: float) -> None:
    given = [x for x in arguments(5, 1500) if 2.0**-20 < abs(x) < 2.0**20]
    _compared(together.power(exponent), lambda base: functions.power(base, exponent), given)


def _compared(
    function: together.Function, straight: Callable[[float], float], given: list[float]
) -> None:
    with np.errstate(all="ignore"):
        results, certain = function(np.array(given))
    for x, result, sure in zip(given, results.tolist(), certain.tolist(), strict=True):
        if sure:
            assert result == answer(straight, x), x
    assert certain.mean() > 0.2
