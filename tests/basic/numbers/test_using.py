"""PRINT USING, field by field."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.basic.numbers.recorded_lines import number, recorded
from trs80arm.basic.errors import BasicError
from trs80arm.basic.numbers import decimal, double, single
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.numbers.using import UsingFormat

# Recorded on the ROM beside the conformance cases.
FURTHER = [
    ("#", "-.1", "%-0"),
    ("#.", "-.1", "%-0."),
    ("$$.##", "-.5", "-$.50"),
    ("**$.##", "-.5", "-$0.50"),
    ("**###-", "5", "****5*"),
    ("+#######", "-8805.86E15", "% 8.80586E+18"),
    ("###,###", "-1234567", "%-1,234,570"),
    ("#.##[[[[", "5", "0.50E+01"),
    (".##[[[[", "-5", "%-.05E+02"),
    ("#[[[[", "9.9", "1E+01"),
    ("##.##[[[[", "9.9999", "10.00E+00"),
    ("##[[[[-", "99.96", "%100E+00 "),
    ("+###[[[[", "606", "+606E+00"),
    ("+###[[[[", "0", "  +0E+00"),
    ("#######[[[[", "1.5", " 150000E-05"),
    ("########[[[[", "1.5", "%150000E-06"),
    ("########.[[[[", "1.5", "%1500000E-06"),
    ("########.##[[[[", "1.5", " 1500000.00E-06"),
    ("##################[[[[", "1.5#", "%1500000000000000D-16"),
    ("#", "9999999999999999.6#", "%10000000000000000"),
]


def filled(format_text: str, values: list[Number | str]) -> str:
    """What PRINT USING prints for a list of values, an error's letters last."""
    using = UsingFormat(format_text)
    printed = ""
    try:
        for value in values:
            printed += using.literal()
            using.demand_field()
            printed += using.field(value)
    except BasicError as error:
        return f"{printed} {error.code.letters}"
    return printed + using.rest()


def values_of(text: str) -> list[Number | str]:
    return [
        item.strip('"') if item.startswith('"') else number(item)
        for item in re.findall(r'"[^"]*"|[^;,]+', text)
    ]


@pytest.mark.parametrize("line", recorded("using"))
def test_formats_print_as_on_the_rom(line: str) -> None:
    match = re.fullmatch(r'"(.*?)" (.*) = "(.*)"( ..)?   \S+', line)
    assert match
    format_text, values, printed, error = match.groups()
    assert filled(format_text, values_of(values)) == printed + (error or "")


@pytest.mark.parametrize(("format_text", "value", "printed"), FURTHER)
def test_formats_at_their_limits(format_text: str, value: str, printed: str) -> None:
    assert filled(format_text, [number(value)]) == printed


def test_a_plus_sign_without_a_field_is_text() -> None:
    assert filled("+A#", [5]) == "+A5"
    assert filled("++#", [5]) == "++5"
    assert filled("+!", ["XY"]) == "+X"


def test_text_before_a_missing_field_is_printed_before_the_error() -> None:
    using = UsingFormat("NONE")
    assert using.literal() == "NONE"
    with pytest.raises(BasicError, match="FC"):
        using.demand_field()


def test_the_format_goes_on_where_it_stood_and_begins_again() -> None:
    assert filled("A=## B=## ", [1, 2, 3]) == "A= 1 B= 2 A= 3 B="


def test_a_field_of_more_than_twenty_four_places_is_refused() -> None:
    assert filled("#" * 24, [1]).strip() == "1"
    assert filled("#" * 25, [1]) == " FC"
    assert filled("#" * 23 + ".#", [1]) == " FC"


def test_fields_want_their_type() -> None:
    assert filled("##", ["A"]) == " TM"
    assert filled("!", [5]) == " TM"


@given(
    st.text("#,.+-$*[!% A", max_size=12),
    st.lists(
        st.one_of(
            st.integers(-32768, 32767),
            st.floats(-1e9, 1e9, allow_nan=False, width=32).map(single.round_away),
            st.integers(-(10**15), 10**15).map(double.from_int),
        ),
        max_size=3,
    ),
)
def test_any_format_takes_any_number(format_text: str, values: list[Number]) -> None:
    assert isinstance(filled(format_text, list(values)), str)


@given(st.integers(-999999, 999999), st.integers(7, 12))
def test_a_wide_field_shows_the_plain_number_to_the_right(n: int, width: int) -> None:
    value = float(n)
    assert filled("#" * width, [value]) == decimal.number_text(value).strip().rjust(width)
