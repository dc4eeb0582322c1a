"""The functions and RND, to the bit."""

from __future__ import annotations

import pytest

from tests.basic.numbers.recorded_lines import number, recorded
from trs80arm.basic.errors import BasicError
from trs80arm.basic.numbers import convert, functions, rnd, single
from trs80arm.basic.numbers.decimal import number_text


@pytest.mark.parametrize("line", recorded("functions"))
def test_functions_have_the_roms_bits(line: str) -> None:
    question, answer = line.split(" = ")
    name, operands = question.split()
    shown, data = answer.split()
    arguments = [convert.to_single(number(text)) for text in operands.split(",")]
    result = getattr(functions, name.lower())(*arguments)
    assert number_text(result).strip() == shown
    assert result == single.unpack(bytes.fromhex(data))


@pytest.mark.parametrize(
    ("name", "arguments", "error"),
    [
        ("log", (0.0,), "FC"),
        ("log", (-1.0,), "FC"),
        ("sqr", (-4.0,), "FC"),
        ("power", (0.0, -1.0), "/0"),
        ("power", (-2.0, 0.5), "FC"),
        ("exp", (single.round_away(87.4),), "OV"),
        ("exp", (1e10,), "OV"),
        ("tan", (single.round_away(1.5707963),), "/0"),
    ],
)
def test_functions_refuse(name: str, arguments: tuple[float, ...], error: str) -> None:
    with pytest.raises(BasicError, match=error):
        getattr(functions, name)(*arguments)


def test_exp_reaches_further_down_than_up() -> None:
    """Cases numfn-exp-basic and numfn-exp-limits."""
    shown = [number_text(functions.exp(single.round_away(x))) for x in (87.3, -88.0, -89.0, -1e10)]
    assert shown == [" 8.20178E+37", " 6.05462E-39", " 0", " 0"]


def test_powers_of_negative_numbers_take_the_sign_of_the_exponent_bit() -> None:
    assert functions.power(-2.0, 3.0) == -functions.power(2.0, 3.0)
    assert functions.power(-2.0, 2.0) == functions.power(2.0, 2.0)
    assert functions.power(0.0, 0.0) == 1.0
    assert functions.power(0.0, 2.0) == 0.0


def test_three_squared_is_not_nine() -> None:
    """Case numfn-power-exactness."""
    squares = [n for n in range(1, 13) if functions.power(float(n), 2.0) == n * n]
    assert squares == [1, 2, 4, 8]


def sequence(seed: int, n: int, count: int) -> list[str]:
    shown = []
    for _ in range(count):
        seed, value = rnd.rnd(seed, n)
        shown.append(number_text(value).strip())
    return shown


def test_rnd_begins_as_after_power_on() -> None:
    """Cases rnd-rnd-0, rnd-rnd-6, rnd-rnd-32767."""
    assert sequence(0, 0, 5) == [".0222228", ".462841", ".262145", ".0680311", ".930171"]
    assert sequence(0, 6, 10) == ["1", "3", "2", "1", "6", "3", "1", "5", "6", "6"]
    assert sequence(0, 32767, 5) == ["729", "15166", "8590", "2230", "30479"]
    assert sequence(0, 0, 500)[-1] == ".416398"


def test_rnd_goes_on_from_any_seed() -> None:
    """Case rnd-rnd-seed-poke: the bytes 1, 2, 3 at 16554."""
    seed, value = rnd.rnd(int.from_bytes(b"\x01\x02\x03", "little"), 0)
    assert number_text(value) == " .977306"
    assert rnd.rnd(seed, 100)[1] == 53.0


def test_the_largest_fraction_rounds_up_past_the_range() -> None:
    """Recorded on the ROM with the seed 0FH, 2, E2H poked."""
    seed = int.from_bytes(bytes([0x02, 0x0F, 0xE2]), "little")
    assert rnd.advance(seed) == 0xFFFFFF
    assert [rnd.rnd(seed, n)[1] for n in (1, 2, 4, 16384, 3, 7)] == [2, 3, 5, 16385, 3, 7]


def test_rnd_of_a_negative_number_is_refused() -> None:
    with pytest.raises(BasicError, match="FC"):
        rnd.rnd(0, -1)
