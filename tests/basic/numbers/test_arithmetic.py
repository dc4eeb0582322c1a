"""Arithmetic to the bit: against the ROM's results, and the quick paths against the registers."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.basic.numbers.recorded_lines import number, read_double, recorded
from trs80arm.basic.compiler import rounding
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import convert, double, integer, registers, single
from trs80arm.basic.numbers.decimal import number_text

OPERATIONS = {"+": "add", "-": "sub", "*": "mul", "/": "div"}


@pytest.mark.parametrize("line", recorded("arithmetic"))
def test_sums_products_and_quotients_have_the_roms_bits(line: str) -> None:
    a, op, b, _, text, data = line.split()
    if len(data) == 16:
        x = getattr(double, OPERATIONS[op])(read_double(a), read_double(b))
        assert double.pack(x).hex() == data
    else:
        x = getattr(single, OPERATIONS[op])(
            convert.to_single(number(a)), convert.to_single(number(b))
        )
        assert single.pack(x).hex() == data
    assert number_text(x).strip() == text


@pytest.mark.parametrize("line", recorded("registers"))
def test_the_ends_of_the_range_are_where_the_rom_has_them(line: str) -> None:
    a, op, b, _, answer = line.split()
    module = double if len(a) == 16 else single
    operands = [module.unpack(bytes.fromhex(text)) for text in (a, b)]
    try:
        result = module.pack(getattr(module, OPERATIONS[op])(*operands)).hex()
    except BasicError as error:
        result = error.code.letters
    assert result == answer


def outcome(operation: Callable[[float, float], float], a: float, b: float) -> float | Code:
    try:
        return operation(a, b)
    except BasicError as error:
        return error.code


def reference(
    operation: Callable[[registers.Register, registers.Register, int], registers.Register],
) -> Callable[[float, float], float]:
    return lambda a, b: single.from_register(
        operation(single.to_register(a), single.to_register(b), single.BITS)
    )


mantissas = st.one_of(
    st.integers(1 << 23, (1 << 24) - 1),
    st.sampled_from([1 << 23, (1 << 23) + 1, (1 << 24) - 1, (1 << 24) - 2, 3 << 22]),
    st.integers(0, 23).map(lambda n: (1 << 23) | (1 << n)),
)


@st.composite
def singles(draw: st.DrawFn, low: int = 1, high: int = 255) -> float:
    exponent = draw(st.integers(low, high))
    x = single.from_register((exponent, draw(mantissas)))
    return draw(st.sampled_from([x, -x]))


@st.composite
def neighbours(draw: st.DrawFn) -> tuple[float, float]:
    """Two singles whose exponents are so near that both count in a sum."""
    a = draw(singles())
    distance = draw(st.integers(-27, 27))
    b = draw(singles())
    fraction, _ = math.frexp(b)
    exponent = min(max(single.to_register(a)[0] + distance, 1), 255)
    return a, math.ldexp(fraction, exponent - 128)


@given(neighbours())
@example((1.0, -(2.0**-25) * 1.5))
@example((single.LARGEST, single.LARGEST))
@example((single.SMALLEST * 1.5, -single.SMALLEST))
@example((0.0, -1.0))
def test_adding_in_floats_is_adding_in_registers(pair: tuple[float, float]) -> None:
    a, b = pair
    expected = outcome(reference(registers.add), a, b)
    assert outcome(single.add, a, b) == expected
    assert outcome(single.add, b, a) == expected
    assert outcome(single.sub, a, -b) == expected


@given(st.integers(9, 24), mantissas, st.integers(-300, 300), st.booleans())
def test_a_sum_just_below_a_half_rounds_as_the_guard_byte_has_it(
    distance: int, large: int, nudge: int, negative: bool
) -> None:
    """The smaller operand is built so that its lost bits decide about the rounding."""
    half = 1 << (distance - 1)
    step = max(1 << max(distance - 8, 0), 1)
    small = ((1 << 23 >> distance) << distance) + half + nudge * step // 100 + (1 << 23)
    small = min(max(small, 1 << 23), (1 << 24) - 1)
    a, b = float(large), -math.ldexp(small, -distance)
    if negative:
        a, b = -a, -b
    assert single.add(a, b) == reference(registers.add)(a, b)
    assert single.sub(a, -b) == reference(registers.add)(a, b)


@given(singles(), singles())
def test_multiplying_and_dividing_in_floats_is_doing_it_in_registers(a: float, b: float) -> None:
    assert outcome(single.mul, a, b) == outcome(reference(registers.multiply), a, b)
    assert outcome(single.div, a, b) == outcome(reference(registers.divide), a, b)


@given(st.integers(1 << 24, (1 << 25) - 1).filter(lambda n: n % 2), st.integers(-140, 140))
def test_a_tie_rounds_away_from_zero(odd: int, exponent: int) -> None:
    tie = math.ldexp(odd, exponent - 25)
    up = math.ldexp((odd + 1) // 2, exponent - 24)
    if 2.0**-128 <= up < 2.0**127:
        assert single.round_away(tie) == up
        assert single.round_away(-tie) == -up


def test_subtracting_far_apart_keeps_no_bits_below_the_guard_byte() -> None:
    """16777215.49... rounds up: the machine has cut the small operand to 1/256."""
    a, b = 16777216.0 - 1.0, -(0.5 + 2.0**-10)
    assert a + b < 16777214.5
    assert single.add(a, b) == 16777215.0


def test_double_subtraction_appends_the_guard_byte_as_it_is() -> None:
    """Case numfmt-double-subtract-guard."""
    difference = double.sub(double.from_int(1), convert.to_double(number(".1#")))
    assert number_text(difference) == " .9000000000000001"


@pytest.mark.parametrize(
    ("dividend", "divisor", "shown"),
    [("1E38", ".5", " 0"), ("1E-38", "2", " 0"), ("1E-38", "4", " 0"), ("3E38", "1", None)],
)
def test_quotients_at_the_ends(dividend: str, divisor: str, shown: str | None) -> None:
    if shown is None:
        with pytest.raises(BasicError, match="OV"):
            number(dividend)
    else:
        assert number_text(convert.div(number(dividend), number(divisor))) == shown


@pytest.mark.parametrize("zero", [0, 0.0, double.ZERO])
def test_dividing_by_zero_is_an_error_of_its_own(zero: convert.Number) -> None:
    with pytest.raises(BasicError, match="/0"):
        convert.div(1, zero)
    with pytest.raises(BasicError, match="/0"):
        convert.div(0, zero)


@given(st.integers(-32768, 32767), st.integers(-32768, 32767))
def test_integers_stay_integers_only_while_they_fit(a: int, b: int) -> None:
    for operation, exact in ((integer.add, a + b), (integer.sub, a - b), (integer.mul, a * b)):
        result = operation(a, b)
        if -32768 <= exact <= 32767:
            assert type(result) is int
            assert result == exact
        else:
            assert type(result) is float
            assert result == single.round_away(float(exact))


@given(singles())
def test_a_single_survives_memory_and_double_precision(x: float) -> None:
    assert single.unpack(single.pack(x)) == x
    assert double.to_single(double.from_single(x)) == x


@given(st.binary(min_size=8, max_size=8))
def test_a_double_survives_memory(data: bytes) -> None:
    assert double.pack(double.unpack(data)) == (data if data[7] else bytes(8))


@given(singles(), singles())
def test_doubles_are_ordered_as_their_values(a: float, b: float) -> None:
    x, y = double.from_single(a), double.from_single(b)
    assert double.compare(x, y) == (a > b) - (a < b)
    assert double.compare(x, double.ZERO) == (a > 0) - (a < 0)
    assert double.compare(double.ZERO, x) == (a < 0) - (a > 0)


@given(neighbours(), st.sampled_from("+-"))
@example((single.SMALLEST * 1.5, single.SMALLEST), "-")
@example((single.LARGEST, single.LARGEST), "+")
@example((8388609.0, -0.00390625 * 8388609.0), "+")
def test_a_sum_in_line_is_the_one_called(pair: tuple[float, float], sign: str) -> None:
    a, b = pair
    call = single.add if sign == "+" else single.sub
    expected = outcome(call, a, b)
    near = rounding.is_near(a) or rounding.is_near(b)
    for known in {near, False}:
        text = rounding.rounded_sum("a", sign, "b", ("a", "b"), "call(a, b)", near=known)
        in_line = eval(f"lambda a, b: {text}", {"call": call})
        assert outcome(in_line, a, b) == expected
