"""CINT, CSNG, CDBL, INT, FIX, SGN, ABS, and operands of different types."""

from __future__ import annotations

import math
import pickle

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.basic.numbers.recorded_lines import number
from trs80arm.basic.errors import BasicError
from trs80arm.basic.numbers import convert, double, single
from trs80arm.basic.numbers.decimal import number_text
from trs80arm.basic.numbers.double import Double

wide = st.floats(-1e9, 1e9, allow_nan=False, width=32).map(single.round_away)


@pytest.mark.parametrize(
    ("value", "whole"),
    [("2.9", 2), ("-1.5", -2), ("32767.9", 32767), ("-32768", -32768), ("32767.99#", 32767)],
)
def test_everything_that_becomes_an_integer_is_rounded_down(value: str, whole: int) -> None:
    assert convert.to_integer(number(value)) == whole


@pytest.mark.parametrize("value", ["32768", "-32768.4", "1E38", "-1D20", "32768#"])
def test_no_integer_beyond_sixteen_bits(value: str) -> None:
    with pytest.raises(BasicError, match="OV"):
        convert.to_integer(number(value))


@given(wide)
@example(-32768.0)
@example(-65536.0)
def test_int_and_fix_are_whole_and_singles_stay_singles(x: float) -> None:
    down, cut = convert.int_(x), convert.fix(x)
    assert type(down) is float
    assert down == math.floor(x)
    assert cut == math.trunc(x)
    y = double.from_single(x)
    # Where nothing is set below the top byte, the ROM does not give back what it borrows (case
    # conv-int-whole-double).
    top = 2 ** max(0, math.frexp(x)[1] - 8)
    borrowed = top if x < -32768 and x % top == 0 else 0
    # FIX makes a negative number positive first, and 32768 is no integer.
    for found, expected, least in (
        (convert.int_(y), math.floor(x) - borrowed, -32768),
        (convert.fix(y), math.trunc(x), -32767),
    ):
        if least <= expected <= 32767:
            assert type(found) is int
            assert found == expected
        else:
            assert found == double.from_int(expected)


@pytest.mark.parametrize(
    ("value", "down", "cut"),
    [
        ("-7.441717064D9", "-7441717064", "-7441717064"),
        ("-511924.41056", "-511925", "-511924"),
        ("1.78831739153442D8", " 178831739", " 178831739"),
        (".009746505918", " 0", " 0"),
    ],
)
def test_int_and_fix_of_doubles(value: str, down: str, cut: str) -> None:
    """Cases conv-double-1 and conv-double-2."""
    assert number_text(convert.int_(number(value))) == down
    assert number_text(convert.fix(number(value))) == cut


def test_the_lowest_integer_has_no_positive_twin() -> None:
    assert convert.negate(-32768) == 32768.0
    assert type(convert.absolute(-32768)) is float


@pytest.mark.parametrize("zero", [0, 0.0, double.ZERO])
def test_zero_has_no_sign(zero: convert.Number) -> None:
    negated = convert.negate(zero)
    assert number_text(negated) == " 0"
    assert convert.sign(negated) == 0
    assert math.copysign(1.0, convert.to_single(negated)) == 1.0


@pytest.mark.parametrize(
    ("a", "b", "kind"),
    [("1%", "2%", int), ("1%", "2!", float), ("1#", "2%", Double), ("1!", "2#", Double)],
)
def test_the_wider_type_wins(a: str, b: str, kind: type) -> None:
    for operation in (convert.add, convert.sub, convert.mul):
        assert type(operation(number(a), number(b))) is kind


def test_a_quotient_is_never_an_integer() -> None:
    assert convert.div(4, 2) == 2.0
    assert type(convert.div(4, 2)) is float


def test_types_compare_by_value() -> None:
    assert convert.compare(1, 1.0) == 0
    assert convert.compare(number(".1"), number(".1#")) == 1
    assert convert.compare(-1, number("1D20")) == -1


def test_a_string_is_no_number() -> None:
    for operation in (convert.add, convert.sub, convert.mul, convert.div, convert.compare):
        with pytest.raises(BasicError, match="TM"):
            operation("A", 1)  # type: ignore[arg-type]
    for function in (convert.negate, convert.sign, convert.int_, convert.to_integer):
        with pytest.raises(BasicError, match="TM"):
            function("A")  # type: ignore[arg-type]


def test_a_double_becomes_the_nearest_single_or_overflows() -> None:
    assert convert.to_single(number("1.99999999#")) == 2.0
    with pytest.raises(BasicError, match="OV"):
        double.to_single(Double(255, (1 << 56) - 1))


def test_a_double_is_a_value() -> None:
    x = number("1.5#")
    assert pickle.loads(pickle.dumps(x)) == x
    assert len({x, number("1.5#"), number("2#")}) == 2
