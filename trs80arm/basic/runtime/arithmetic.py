"""Arithmetic at run time whose time depends on the numbers.

Operations on doubles charge what their bits cost the Z-80. Operations on singles have been charged
as for usual operands; where the ROM leaves at once, some of it is given back.
"""

from __future__ import annotations

from trs80arm.basic import costs, number_costs
from trs80arm.basic.numbers import double, single
from trs80arm.basic.numbers.double import Double
from trs80arm.basic.runtime.part import Part


class Arithmetic(Part):
    """+ - * / of numbers."""

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
