"""What `--vary` understands."""

from __future__ import annotations

import pytest

from trs80arm.sweep.axes import SweepError, grid, parse_axis


def test_a_range_has_both_its_ends_in_it() -> None:
    assert parse_axis("D=10:200:10").values == tuple(range(10, 201, 10))
    assert parse_axis("noise=0.1:0.3:0.1").values == (0.1, 0.2, 0.3)
    assert parse_axis("D=1:10:4").values == (1, 5, 9)


def test_a_list_keeps_its_order() -> None:
    assert parse_axis("weight=8, 1,-4").values == (8, 1, -4)


@pytest.mark.parametrize(
    "text",
    [
        *("D", "D=", "D=1:2", "D=2:1:1", "D=1:2:0", "D=1:2:-1", "D=A", "D=1,,2", "D=nan", "D=inf"),
        *("D=1e99", "D=0:1e9:1e-9", "=1", "size=1", "d=1", "A$=1", "D=1,1", "terminal.fps=1"),
        "D=0:1e999999999:1e-9",
    ],
)
def test_what_cannot_be_varied_is_told_in_one_line(text: str) -> None:
    with pytest.raises(SweepError) as error:
        parse_axis(text)
    assert "\n" not in str(error.value)


def test_the_grid_has_every_combination_and_an_end() -> None:
    axes = [parse_axis("D=1,2"), parse_axis("weight=3,4")]
    assert grid(axes) == [(1, 3), (1, 4), (2, 3), (2, 4)]
    with pytest.raises(SweepError, match="twice"):
        grid([axes[0], axes[0]])
    with pytest.raises(SweepError, match="10000"):
        grid([parse_axis("A=1:200:1"), parse_axis("B=1:200:1")])
