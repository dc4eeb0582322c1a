"""Cells that changed, as a terminal is told of them: no code more than it takes."""

from __future__ import annotations

import re

import pytest
from rich.console import Console
from rich.style import Style

from trs80arm.drawing.rows import Ink, Row, changed_part
from trs80arm.ui.terminal.changes import CellsUpdate, Change

GREEN, RED = Style.parse("#00ff00 on #000000"), Style.parse("#ff0000 on #000000")
BOLD = Style.parse("bold #00ff00 on #000000")
ON_BLUE = Style.parse("#00ff00 on #0000ff")
LINE = Style.parse("underline #00ff00 on #000000")
A, B = Ink.ARM, Ink.HAND


def written(*runs: tuple[str, Style], system: str = "truecolor") -> str:
    console = Console(color_system=system)  # type: ignore[arg-type]
    return CellsUpdate([Change(4, 2, runs)]).render_segments(console)


def test_cells_are_written_at_their_place_and_leave_no_colour_behind() -> None:
    assert written(("ab", GREEN)) == "\x1b[3;5H\x1b[38;2;0;255;0;48;2;0;0;0mab\x1b[0m"


def test_only_what_differs_from_one_run_to_the_next_is_written() -> None:
    text = written(("a", GREEN), ("b", RED), ("c", RED), ("d", BOLD), ("e", BOLD), ("f", GREEN))
    assert re.findall(r"\x1b\[([0-9;]*)m", text) == [
        "38;2;0;255;0;48;2;0;0;0",
        "38;2;255;0;0",
        "0;1;38;2;0;255;0;48;2;0;0;0",
        "0;38;2;0;255;0;48;2;0;0;0",
        "0",
    ]


def test_a_blank_needs_no_ink() -> None:
    text = written(("a", GREEN), (" ", RED), ("b", GREEN), (" ", ON_BLUE), ("c", GREEN))
    assert re.findall(r"\x1b\[([0-9;]*)m", text) == [
        "38;2;0;255;0;48;2;0;0;0",
        "48;2;0;0;255",
        "48;2;0;0;0",
        "0",
    ]


def test_a_blank_is_underlined_where_it_has_to_be_and_nowhere_else() -> None:
    text = written(("a", LINE), (" ", GREEN), (" ", LINE))
    assert re.findall(r"\x1b\[([0-9;]*)m", text) == [
        "0;4;38;2;0;255;0;48;2;0;0;0",
        "0;38;2;0;255;0;48;2;0;0;0",
        "0;4;38;2;0;255;0;48;2;0;0;0",
        "0",
    ]


def test_a_terminal_of_few_colours_gets_the_nearest() -> None:
    assert "\x1b[31;40m" in written(("a", RED), system="standard")


@pytest.mark.parametrize(
    ("before", "now", "part"),
    [
        ((("abc", A),), (("abc", A),), (3, ())),
        ((("abc", A),), (("axc", A),), (1, (("x", A),))),
        ((("aaa", A),), (("aa", A), ("b", B)), (2, (("b", B),))),
        ((("ab", A), ("cd", B)), (("ab", A), ("cx", B)), (3, (("x", B),))),
        ((("ab", A), ("cd", B)), (("xb", A), ("cd", B)), (0, (("x", A),))),
        ((("abcd", A),), (("ab", B), ("cd", A)), (0, (("ab", B),))),
        ((("ab", A), ("c", B), ("de", A)), (("a", A), ("bc", B), ("de", A)), (1, (("b", B),))),
        ((("aaaa", A),), (("aa", A), ("b", B), ("a", A)), (2, (("b", B),))),
    ],
)
def test_the_part_of_a_row_that_differs(before: Row, now: Row, part: tuple[int, Row]) -> None:
    assert changed_part(before, now) == part
