"""Arithmetic at run time whose time depends on the numbers.

Operations on doubles charge what their bits cost the Z-80, functions what their argument costs.
Operations on singles have been charged as for usual operands; where the ROM leaves at once, some of
it is given back.
"""

from __future__ import annotations

from trs80arm.basic import costs, number_costs
from trs80arm.basic.numbers import double, functions, single
from trs80arm.basic.numbers.double import Double
from trs80arm.basic.runtime.part import Part


class Arithmetic(Part):
    """+ - * / of doubles, and the functions."""

    def double_add(self, a: Double, b: Double) -> Double:
        """The sum; OV."""
        self._clock.now += number_costs.double_sum(a, b)
        return double.add(a, b)

    def double_sub(self, a: Double, b: Double) -> Double:
        """The difference; OV."""
        self._clock.now += number_costs.double_sum(a, double.negate(b))
        return double.sub(a, b)

    def double_mul(self, a: Double, b: Double) -> Double:
        """The product; OV."""
        self._clock.now += number_costs.double_product(a, b)
        return double.mul(a, b)

    def double_div(self, a: Double, b: Double) -> Double:
        """The quotient; division by zero, OV."""
        self._clock.now += number_costs.double_quotient(a, b)
        return double.div(a, b)

    def sin(self, x: float) -> float:
        """SIN."""
        result = functions.sin(x)
        self._clock.now += costs.EASY_SIN.get(x, costs.SIN)
        return result

    def cos(self, x: float) -> float:
        """COS."""
        result = functions.cos(x)
        self._clock.now += costs.EASY_COS.get(x, costs.COS)
        return result

    def tan(self, x: float) -> float:
        """TAN; division by zero."""
        result = functions.tan(x)
        self._clock.now += costs.EASY_TAN.get(x, costs.TAN)
        return result

    def atn(self, x: float) -> float:
        """ATN."""
        result = functions.atn(x)
        self._clock.now += costs.EASY_ATN.get(x, costs.ATN)
        return result

    def log(self, x: float) -> float:
        """LOG; FC."""
        result = functions.log(x)
        self._clock.now += costs.EASY_LOG.get(x, costs.LOG)
        return result

    def exp(self, x: float) -> float:
        """EXP; OV."""
        result = functions.exp(x)
        self._clock.now += costs.EASY_EXP.get(x, costs.EXP)
        return result

    def sqr(self, x: float) -> float:
        """SQR; FC."""
        result = functions.sqr(x)
        self._clock.now += costs.EASY_SQR.get(x, costs.SQR)
        return result

    def power(self, base: float, exponent: float) -> float:
        """`base [ exponent`; division by zero, FC, OV."""
        result = functions.power(base, exponent)
        total = costs.POWER
        if not exponent:
            total -= costs.POWER_BY_ZERO
        elif base in (0.0, 1.0):
            total -= costs.POWER_OF_ONE if base else costs.POWER_OF_ZERO
        self._clock.now += total
        return result

    # -- singles: generated code calls these only where the short way does not do ----------------

    def mul(self, a: float, b: float) -> float:
        """A product of singles; OV."""
        if not a or not b:
            self._clock.now -= costs.PRODUCT_OF_ZERO
        return single.mul(a, b)

    def div(self, a: float, b: float) -> float:
        """A quotient of singles; division by zero, OV."""
        if not a or not b:
            self._clock.now -= costs.QUOTIENT_OF_ZERO
        return single.div(a, b)
