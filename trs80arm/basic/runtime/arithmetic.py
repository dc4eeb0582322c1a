"""Double precision at run time: every operation charges what its bits cost the Z-80."""

from __future__ import annotations

from trs80arm.basic import number_costs
from trs80arm.basic.numbers import double
from trs80arm.basic.numbers.double import Double
from trs80arm.basic.runtime.part import Part


class Arithmetic(Part):
    """+ - * / of doubles."""

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
