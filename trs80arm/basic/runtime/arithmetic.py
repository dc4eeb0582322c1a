"""Arithmetic at run time whose time depends on the numbers.

Operations on doubles charge what their bits cost the Z-80. The functions have been charged as for
a usual argument; where the ROM has less to do some of it is given back.
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
        self._clock.now -= costs.EASY.get(("SIN", x), 0)
        return functions.sin(x)

    def cos(self, x: float) -> float:
        """COS."""
        self._clock.now -= costs.EASY.get(("COS", x), 0)
        return functions.cos(x)

    def tan(self, x: float) -> float:
        """TAN; division by zero."""
        self._clock.now -= costs.EASY.get(("TAN", x), 0)
        return functions.tan(x)

    def atn(self, x: float) -> float:
        """ATN."""
        self._clock.now -= costs.EASY.get(("ATN", x), 0)
        return functions.atn(x)

    def log(self, x: float) -> float:
        """LOG; FC."""
        self._clock.now -= costs.EASY.get(("LOG", x), 0)
        return functions.log(x)

    def exp(self, x: float) -> float:
        """EXP; OV."""
        self._clock.now -= costs.EASY.get(("EXP", x), 0)
        return functions.exp(x)

    def sqr(self, x: float) -> float:
        """SQR; FC."""
        self._clock.now -= costs.EASY.get(("SQR", x), 0)
        return functions.sqr(x)

    def power(self, base: float, exponent: float) -> float:
        """`base [ exponent`; division by zero, FC, OV."""
        if not exponent:
            self._clock.now -= costs.POWER_BY_ZERO
        elif base in (0.0, 1.0):
            self._clock.now -= costs.POWER_OF_ONE if base else costs.POWER_OF_ZERO
        return functions.power(base, exponent)

    # -- singles: generated code calls these only where the short way does not do ----------------

    def mul(self, a: float, b: float) -> float:
        """A product of singles; OV."""
        if not a or not b:
            self._clock.now -= costs.PRODUCT_OF_ZERO
        return single.mul(a, b)

    def div(self, a: float, b: float) -> float:
        """A quotient of singles; division by zero, OV."""
        if not a:
            self._clock.now -= costs.QUOTIENT_OF_ZERO
        return single.div(a, b)
