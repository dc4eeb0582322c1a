"""Functions that remember what they gave: SIN and so on, the power, the text of a number.

Programs ask for the same angles and roots again and again: an arm goes round between the same
places, a picture is symmetrical. What a function gave for the last few thousand arguments is found
here as fast as a variable: generated text says `sin[x]`, and a miss is computed.

The compiler has charged what a function usually takes. Where the ROM multiplies by zero or leaves
at once, some of it is given back here, each time: such arguments are not remembered.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from trs80arm.basic import costs
from trs80arm.basic.errors import BasicError
from trs80arm.basic.host import Clock
from trs80arm.basic.numbers import decimal, functions

MOST: Final = 4096
"""Arguments that a function remembers; then it begins anew."""


def _known(
    clock: Clock, usual: int, function: Callable[[float], float], easy: dict[float, int]
) -> dict[float, float]:
    """A function's results by its arguments.

    Args:
        clock: where time is given back.
        usual: T-states that were charged.
        function: what computes a result; `BasicError` where there is none.
        easy: T-states for the arguments that take another time.
    """

    class Known(dict[float, float]):
        def __missing__(self, argument: float) -> float:
            # Names of the function around it are found faster than attributes.
            try:
                result = function(argument)
            except BasicError:
                clock.now -= usual
                raise
            if argument in easy:
                clock.now += easy[argument] - usual
                return result
            if len(self) >= MOST:
                self.clear()
            self[argument] = result
            return result

    return Known()


def _known_powers(clock: Clock) -> dict[tuple[float, float], float]:
    """The same of the power, by base and exponent."""

    class Known(dict[tuple[float, float], float]):
        def __missing__(self, pair: tuple[float, float]) -> float:
            base, exponent = pair
            try:
                result = functions.power(base, exponent)
            except BasicError:
                clock.now -= costs.POWER
                raise
            if not exponent:
                clock.now -= costs.POWER_BY_ZERO
            elif base in (0.0, 1.0):
                clock.now -= costs.POWER_OF_ONE if base else costs.POWER_OF_ZERO
            else:
                if len(self) >= MOST:
                    self.clear()
                self[pair] = result
            return result

    return Known()


def _known_texts() -> dict[Any, tuple[bytes, int]]:
    """What STR$ gives, and T-states beside those of moving its bytes."""

    class Known(dict[Any, tuple[bytes, int]]):
        def __missing__(self, value: int | float) -> tuple[bytes, int]:
            text = decimal.number_text(value)
            time = costs.number_text(value, text) - costs.STRING_BYTE * len(text)
            if len(self) >= MOST:
                self.clear()
            result = self[value] = text.encode("ascii"), time
            return result

    return Known()


def known_functions(clock: Clock) -> dict[str, dict[Any, Any]]:
    """The functions of one machine by their names."""
    return {
        "sin": _known(clock, costs.SIN, functions.sin, costs.EASY_SIN),
        "cos": _known(clock, costs.COS, functions.cos, costs.EASY_COS),
        "tan": _known(clock, costs.TAN, functions.tan, costs.EASY_TAN),
        "atn": _known(clock, costs.ATN, functions.atn, costs.EASY_ATN),
        "log": _known(clock, costs.LOG, functions.log, costs.EASY_LOG),
        "exp": _known(clock, costs.EXP, functions.exp, costs.EASY_EXP),
        "sqr": _known(clock, costs.SQR, functions.sqr, costs.EASY_SQR),
        "power": _known_powers(clock),
        # 7 and 7.0 are the same key, but not the same time.
        "shown_integers": _known_texts(),
        "shown_singles": _known_texts(),
    }
