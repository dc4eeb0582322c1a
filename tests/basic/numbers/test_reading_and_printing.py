"""Literals and the printed form of numbers, against the ROM's."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.basic.numbers.recorded_lines import number, recorded
from trs80arm.basic.errors import BasicError
from trs80arm.basic.numbers import convert, double, literal, single
from trs80arm.basic.numbers.decimal import number_text
from trs80arm.basic.numbers.double import Double


@pytest.mark.parametrize("line", recorded("literals"))
def test_literals_have_the_roms_bits(line: str) -> None:
    text, answer = line.split(" = ")
    shown, data = answer.split()
    if len(data) == 16:
        x = convert.to_double(literal.scan(text.encode(), 0, double.ZERO).value)
        assert double.pack(x).hex() == data
        assert number_text(x).strip() == shown
    else:
        y = convert.to_single(number(text))
        assert single.pack(y).hex() == data
        assert number_text(y).strip() == shown


@pytest.mark.parametrize("line", recorded("printing"))
def test_numbers_print_as_on_the_rom(line: str) -> None:
    source, shown = line.split(" = ")
    if re.fullmatch("[0-9a-f]{8}|[0-9a-f]{16}", source):
        data = bytes.fromhex(source)
        value = double.unpack(data) if len(data) == 8 else single.unpack(data)
    else:
        value = number(source)
    assert number_text(value).strip() == shown


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("32767", int),
        ("32768", float),
        ("1234567", float),
        ("12345678", Double),
        ("1.000000", float),
        ("1.0000000", Double),
        ("0.00000001", float),
        ("000012345", int),
        ("1.23456789E0", float),
        ("1D0", Double),
        ("5#", Double),
        ("5!", float),
        ("5%", int),
        (".", float),
        ("", int),
        ("X", int),
    ],
)
def test_the_type_of_a_literal_follows_from_its_spelling(text: str, kind: type) -> None:
    assert type(number(text)) is kind


@pytest.mark.parametrize(
    ("text", "value", "end"),
    [
        (b"1 2 3 :", 123, 6),
        (b"1.5.5", 1.5, 3),
        (b"1E", 1.0, 2),
        (b"1E+X", 1.0, 3),
        (b"25\xce3", 25, 2),
        (b"25E\xce2", 0.25, 5),
        (b"25E\xcd2", 2500.0, 5),
        (b"- 5,", -5, 3),
        (b"+5", 5, 2),
        (b"--5", 0, 1),
        (b"7%X", 7, 2),
        (b"12 ", 12, 3),
    ],
)
def test_the_scanner_stops_where_the_number_does(text: bytes, value: int | float, end: int) -> None:
    assert literal.scan(text) == (single.round_away(value) if value == 0.25 else value, end)


def test_scanning_begins_anywhere_in_a_line() -> None:
    assert literal.scan(b"A=12:", 2) == (12, 4)


@pytest.mark.parametrize("text", ["1.5%", "32768%", "12345678%"])
def test_a_percent_sign_wants_an_integer(text: str) -> None:
    with pytest.raises(BasicError, match="SN"):
        number(text)


@pytest.mark.parametrize("text", ["1E39", "1.7014119E38", "1E256", "1D39", "9" * 40])
def test_a_literal_may_be_too_large(text: str) -> None:
    with pytest.raises(BasicError, match="OV"):
        number(text)


@pytest.mark.parametrize("text", ["1E-40", "1E-256", "1D-40", "0E99", "3E-39", "2.93874E-39"])
def test_a_literal_may_be_too_small(text: str) -> None:
    """Cases numfmt-exponent-limits and numfmt-min-values."""
    assert number_text(number(text)) == " 0"


def test_a_double_that_rounds_past_sixteen_digits_prints_a_colon() -> None:
    """Case numfmt-colon-digit."""
    for data, text in (("fcff9f31a95f63b2", ":00000000000000"), ("fdffffffff3f1c8e", ":000")):
        assert number_text(double.unpack(bytes.fromhex(data))).strip() == text


@given(st.integers(-32768, 32767))
def test_integers_print_plainly_in_every_type(n: int) -> None:
    text = f" {n}" if n >= 0 else str(n)
    assert number_text(n) == number_text(float(n)) == number_text(double.from_int(n)) == text


@given(st.integers(1, 255), st.integers(1 << 23, (1 << 24) - 1))
def test_six_digits_are_near_the_number(exponent: int, mantissa: int) -> None:
    x = single.from_register((exponent, mantissa))
    text = number_text(x)
    assert text[0] == " "
    assert abs(float(text.replace("D", "E")) - x) <= 0.6e-5 * x


@given(st.binary(max_size=40))
def test_the_scanner_reads_anything(text: bytes) -> None:
    try:
        value, end = literal.scan(text)
    except BasicError:
        return
    assert isinstance(value, (int, float, Double))
    assert 0 <= end <= len(text)
