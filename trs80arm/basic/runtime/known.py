"""Functions that remember what they gave: SIN and so on, the power, the text of a number.

Programs ask for the same angles and roots again and again: an arm goes round between the same
places, a picture is symmetrical. What a function gave for the last few thousand arguments is found
here as fast as a variable: generated text says `sin[x]`, and a miss is computed.

The compiler has charged what a function usually takes. Where the ROM multiplies by zero or leaves
at once, some of it is given back here, each time: such arguments are not remembered.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, Final

from trs80arm.basic import costs
from trs80arm.basic.errors import BasicError
from trs80arm.basic.host import Clock
from trs80arm.basic.numbers import decimal, functions

MOST: Final = 4096
"""Arguments that a function remembers; then it begins anew."""
_TOGETHER: Final = {"sin", "cos", "atn", "log", "exp", "sqr", *functions.OF_ONE_EXPONENT.values()}
"""Functions that `numbers.together` has."""
_IN_STEPS: Final = 64
"""Arguments one equal step behind the other after which more are computed ahead."""
_OTHERS_AHEAD: Final = 32
"""How many are computed one by one among them, where arrays are not certain."""
_FIRST_AHEAD, _MOST_AHEAD = 256, 2048
"""How many: they take as long as these first ones took, or less; then up to so many."""


class _Ahead:
    """Sees arguments that come in equal steps, and computes the next ones all at once.

    What stands in a table, a sum or a plot is a function of 1, 2, 3 or of 0, .1, .2. Arrays of
    numbers (`numbers.together`) take a tenth of the time of one number after the other. How many
    are computed ahead grows with how many were asked for, so what is computed in vain is never much
    more than what was not.

    Args:
        name: what generated text calls the function.
        function: computes it for one argument.
    """

    def __init__(self, name: str, function: Callable[[float], float]) -> None:
        self._name = name
        self._function = function
        self._last = self._step = 0.0
        self._run = 0
        self._many = _FIRST_AHEAD

    def seen(self, argument: float) -> bool:
        """An argument that is not known; whether it is time to look ahead."""
        step = argument - self._last
        self._last = argument
        if step != self._step:
            self._step = step
            self._run = 0
            self._many = _FIRST_AHEAD
            return False
        self._run += 1
        return self._run >= _IN_STEPS and bool(step)

    def results(self) -> Iterable[tuple[float, float]]:
        """The arguments behind the last one, and what the function gives for them."""
        import numpy as np  # It takes long to load, and few programs come here.

        from trs80arm.basic.numbers import together

        arguments = self._last + self._step * np.arange(1.0, self._many + 1.0)
        inexact = together.nearest(arguments) != arguments
        if inexact.any():
            # From here on steps are rounded, and become other steps.
            arguments = arguments[: inexact.argmax()]
        with np.errstate(all="ignore"):
            values, certain = together.FUNCTIONS[self._name](arguments)
        given, results = arguments.tolist(), values.tolist()
        for count, place in enumerate((~certain).nonzero()[0].tolist()):
            try:
                results[place] = self._function(given[place])
            except BasicError:
                # The program finds out when it comes there, if it does.
                count = _OTHERS_AHEAD
            if count >= _OTHERS_AHEAD:
                del given[place:], results[place:]
                break
        if given:
            self._last = given[-1]
            self._run = _IN_STEPS
            self._many = min(2 * self._many, _MOST_AHEAD)
        return zip(given, results, strict=True)


class _Known(dict[float, float]):
    """A function's results by its arguments.

    Args:
        clock: where time is given back.
        usual: T-states that were charged.
        name: what generated text calls it.
        function: what computes a result; `BasicError` where there is none.
        easy: T-states for the arguments that take another time.
    """

    __slots__ = ("_ahead", "_clock", "_easy", "_function", "_usual")

    def __init__(
        self,
        clock: Clock,
        usual: int,
        name: str,
        function: Callable[[float], float],
        easy: dict[float, int],
    ) -> None:
        self._clock = clock
        self._usual = usual
        self._function = function
        self._easy = easy
        self._ahead = _Ahead(name, function) if name in _TOGETHER else None

    def __missing__(self, argument: float) -> float:
        try:
            result = self._function(argument)
        except BasicError:
            self._clock.now -= self._usual
            raise
        if argument in self._easy:
            self._clock.now += self._easy[argument] - self._usual
            return result
        if len(self) >= MOST:
            self.clear()
        self[argument] = result
        ahead = self._ahead
        if ahead is not None and ahead.seen(argument):
            if len(self) > MOST - _MOST_AHEAD:
                self.clear()
            self.update(ahead.results())
            for each in self._easy:
                self.pop(each, None)
        return result


class _KnownPowers(dict[tuple[float, float], float]):
    """The same of the power, by base and exponent."""

    __slots__ = ("_clock",)

    def __init__(self, clock: Clock) -> None:
        self._clock = clock

    def __missing__(self, pair: tuple[float, float]) -> float:
        base, exponent = pair
        try:
            result = functions.power(base, exponent)
        except BasicError:
            self._clock.now -= costs.POWER
            raise
        if not exponent:
            self._clock.now -= costs.POWER_BY_ZERO
        elif base in (0.0, 1.0):
            self._clock.now -= costs.POWER_OF_ONE if base else costs.POWER_OF_ZERO
        else:
            if len(self) >= MOST:
                self.clear()
            self[pair] = result
        return result


def _powers_of_one_exponent(clock: Clock) -> dict[str, dict[float, float]]:
    """The power with each of the usual exponents, by the base."""
    usual = costs.POWER
    easy = {0.0: usual - costs.POWER_OF_ZERO, 1.0: usual - costs.POWER_OF_ONE}

    def power(exponent: float) -> Callable[[float], float]:
        return lambda base: functions.power(base, exponent)

    return {
        name: _Known(clock, usual, name, power(exponent), easy)
        for exponent, name in functions.OF_ONE_EXPONENT.items()
    }


class _KnownTexts(dict[Any, tuple[bytes, int]]):
    """What STR$ gives, and T-states beside those of moving its bytes."""

    __slots__ = ()

    def __missing__(self, value: int | float) -> tuple[bytes, int]:
        text = decimal.number_text(value)
        time = costs.number_text(value, text) - costs.STRING_BYTE * len(text)
        if len(self) >= MOST:
            self.clear()
        result = self[value] = text.encode("ascii"), time
        return result


def known_functions(clock: Clock) -> dict[str, dict[Any, Any]]:
    """The functions of one machine by their names."""
    return {
        "sin": _Known(clock, costs.SIN, "sin", functions.sin, costs.EASY_SIN),
        "cos": _Known(clock, costs.COS, "cos", functions.cos, costs.EASY_COS),
        "tan": _Known(clock, costs.TAN, "tan", functions.tan, costs.EASY_TAN),
        "atn": _Known(clock, costs.ATN, "atn", functions.atn, costs.EASY_ATN),
        "log": _Known(clock, costs.LOG, "log", functions.log, costs.EASY_LOG),
        "exp": _Known(clock, costs.EXP, "exp", functions.exp, costs.EASY_EXP),
        "sqr": _Known(clock, costs.SQR, "sqr", functions.sqr, costs.EASY_SQR),
        "power": _KnownPowers(clock),
        **_powers_of_one_exponent(clock),
        # 7 and 7.0 are the same key, but not the same time.
        "shown_integers": _KnownTexts(),
        "shown_singles": _KnownTexts(),
    }
