from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from tests.drawing.samples import picture
from tests.goldens import check_golden
from trs80arm.drawing.canvas_ascii import AsciiCanvas
from trs80arm.drawing.rows import Ink, text_of
from trs80arm.drawing.scene import along

COORDINATE = st.floats(-60, 120, allow_nan=False)


def texts(canvas: AsciiCanvas) -> list[str]:
    return [text_of(row).rstrip() for row in canvas.rows()]


def test_a_level_line_is_drawn_with_dashes() -> None:
    canvas = AsciiCanvas(10, 1)
    canvas.line((0, 0.5), (9, 0.5), Ink.ARM)
    assert texts(canvas) == ["----------"]


def test_an_upright_line_is_drawn_with_bars() -> None:
    canvas = AsciiCanvas(3, 3)
    canvas.line((1.5, 0), (1.5, 2.9), Ink.ARM)
    assert texts(canvas) == [" |", " |", " |"]


def test_a_steep_line_leans_the_way_it_goes() -> None:
    canvas = AsciiCanvas(4, 4)
    canvas.line((0.5, 0.5), (3.5, 3.5), Ink.ARM)
    assert texts(canvas) == ["\\", " \\", "  \\", "   \\"]
    canvas = AsciiCanvas(4, 4)
    canvas.line((0.5, 3.5), (3.5, 0.5), Ink.ARM)
    assert texts(canvas) == ["   /", "  /", " /", "/"]


def test_a_flat_line_climbs_through_the_levels_of_a_cell() -> None:
    canvas = AsciiCanvas(8, 1)
    canvas.line((0, 1.0), (8, 0.0), Ink.ARM)
    assert texts(canvas) == ["__..--''"]


def test_lines_of_all_directions_can_be_told_apart() -> None:
    canvas = AsciiCanvas(50, 25)
    for degrees in range(0, 360, 15):
        angle = degrees * 3.14159 / 180
        start, end = along((0, 0), angle, 3), along((0, 0), angle, 12)
        canvas.line((25 + 2 * start[0], 12.5 + start[1]), (25 + 2 * end[0], 12.5 + end[1]), Ink.ARM)
    check_golden("canvas-directions", picture(canvas.rows(), 50, 25))


def test_a_box_of_one_cell_is_its_fill() -> None:
    canvas = AsciiCanvas(3, 1)
    canvas.box((1, 0), (2, 1), Ink.PART, "#")
    assert texts(canvas) == [" #"]


def test_dots_never_cover_what_is_drawn() -> None:
    canvas = AsciiCanvas(3, 1)
    canvas.write(1, 0, "o", Ink.ARM)
    canvas.dots([(0.5, 0.2), (1.5, 0.2), (2.5, 0.7)], Ink.TRAIL, "'.")
    assert texts(canvas) == ["'o."]


@given(COORDINATE, COORDINATE, COORDINATE, COORDINATE)
def test_nothing_drawn_outside_disturbs_a_canvas(
    x0: float, y0: float, x1: float, y1: float
) -> None:
    canvas = AsciiCanvas(20, 6)
    canvas.line((x0, y0), (x1, y1), Ink.ARM)
    canvas.box((x0, y0), (x1, y1), Ink.PART, "#")
    canvas.box((x0, y0), (x1, y1), Ink.FURNITURE, "_")
    canvas.dots([(x0, y0), (x1, y1)], Ink.TRAIL, "'.")
    canvas.joint((x0, y0), Ink.ARM, "o", round_it=True)
    canvas.write(int(x0), int(y0), "text", Ink.LABEL)
    rows = canvas.rows()
    assert len(rows) == 6
    assert all(len(text_of(row)) == 20 for row in rows)
