"""The article's figures, computed from the running arm."""

from __future__ import annotations

import builtins
from pathlib import Path
from typing import Any

import pytest

from tests.arm.writes import Recorder
from trs80arm.arm import MiniMover, benchfile
from trs80arm.arm.figures import NAMES, Chart, FigureError, Table, figure
from trs80arm.arm.figures.chart import Figure, Series
from trs80arm.arm.motors import PHASES
from trs80arm.arm.stepping import PulseGenerator, delay_period

PROGRAMS = Path(__file__).parents[2] / "programs"


def chart(drawn: Figure, index: int = 0) -> Chart:
    part = drawn.parts[index]
    assert isinstance(part, Chart)
    return part


@pytest.fixture(scope="module")
def figure_6() -> Figure:
    return figure("6")


def test_figure_8_is_found_by_trying_all_patterns() -> None:
    (table,) = figure("8").parts
    assert isinstance(table, Table)
    assert [int("".join(row[1:5]), 2) for row in table.rows] == list(PHASES)


def test_figure_6_opens_618_steps_to_the_inch_and_squeezes_52_to_the_pound(
    figure_6: Figure,
) -> None:
    for index, width in enumerate((0.0, 1.0)):
        opening, force = chart(figure_6, index).series
        contact = next(x for x, y in zip(force.xs, force.ys, strict=True) if y > 0)
        assert contact == pytest.approx((3 - width) * 618, abs=2)
        assert max(force.ys) == pytest.approx(3.0)
        assert force.xs[-1] - contact == pytest.approx(155, abs=1)
        assert min(opening.ys) == pytest.approx(width, abs=0.002)


def test_figure_2_reaches_seventeen_and_a_half_inches() -> None:
    drawn = figure("2")
    edge = chart(drawn, 0).series[1]
    far = [(x**2 + (z - 8.1) ** 2) ** 0.5 for x, z in zip(edge.xs, edge.ys, strict=True)]
    assert max(far) == pytest.approx(17.5, abs=0.02)
    assert min(edge.ys) > -0.05
    assert min(chart(drawn, 1).series[0].xs) == pytest.approx(0, abs=0.1)


def test_figure_10_shows_21_steps_against_3() -> None:
    recorder = Recorder()
    PulseGenerator(recorder).step((21, 3), delay_period(50))  # type: ignore[arg-type]
    base, shoulder = chart(figure("10", writes=recorder.writes)).series
    assert len(base.xs) == 21
    assert len(shoulder.xs) == 3
    gaps = [b - a for a, b in zip(shoulder.xs, shoulder.xs[1:], strict=False)]
    assert gaps == pytest.approx([7 * 2.7] * 2, abs=0.01)


def test_figure_12_marks_a_to_d() -> None:
    generator = PulseGenerator(MiniMover(bench=benchfile.load(PROGRAMS / "table4.toml")))
    path = []
    for counts in (
        (0, 0, 0, 0, 0, 370),
        (0, -207, 290),
        (0, 132, -36),
        (0, 0, 0, 0, 0, -110),
        (0, -132, 36),
        (651, -8, -13, -461, -462),
        (0, 135, -37),
        (0, 0, 0, 0, 0, 300),
        (0, -135, 37),
    ):
        generator.step(counts, delay_period(50))
        path.append((generator.time, generator.arm.state()))
    notes = {name: (x, z) for x, z, name in chart(figure("12", path=path)).notes}
    assert notes["A"] == pytest.approx((0, 0.5), abs=0.02)
    assert notes["B"] == pytest.approx((0, 1.5), abs=0.02)
    assert notes["C"][1] == pytest.approx(1.5, abs=0.02)
    assert notes["D"] == pytest.approx((29**0.5, 0.5), abs=0.02)


@pytest.mark.parametrize("name", ["10", "12"])
def test_figures_of_a_motion_need_the_motion(name: str) -> None:
    with pytest.raises(FigureError, match="needs"):
        figure(name)


def test_an_unknown_figure_is_refused_with_the_known_ones() -> None:
    with pytest.raises(FigureError, match=", ".join(NAMES)):
        figure("7")


def test_a_figure_is_plain_text_of_the_width_asked_for(figure_6: Figure) -> None:
    for width in (60, 100):
        text = figure_6.text(width)
        assert text.isascii()
        assert max(len(line) for line in text.split("\n")) <= width


def test_a_tables_notes_are_wrapped_below_it() -> None:
    table = Table(("a", "b"), (("1", "see 1"),), ("a word " * 30,))
    lines = Figure("t", "Title", (table,)).text(60).split("\n")
    assert max(len(line) for line in lines) <= 60
    assert "1. a word a word" in "\n".join(lines)


SMALL = Figure("8", "Title", (Chart("", "x", "y", (Series("a", (0.0, 1.0), (0.0, 2.0)),)),))


@pytest.mark.parametrize(("suffix", "begin"), [(".svg", b"<?xml"), (".png", b"\x89PNG")])
def test_a_figure_is_saved(tmp_path: Path, suffix: str, begin: bytes) -> None:
    path = tmp_path / f"figure{suffix}"
    SMALL.save(path)
    assert path.read_bytes().startswith(begin)


def test_an_unknown_suffix_or_folder_gets_one_line(tmp_path: Path) -> None:
    with pytest.raises(FigureError, match=r"\.svg, \.png, \.pdf"):
        SMALL.save(tmp_path / "figure.doc")
    with pytest.raises(FigureError, match="cannot be written"):
        SMALL.save(tmp_path / "none" / "figure.svg")


def test_without_matplotlib_saving_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = builtins.__import__

    def without(name: str, *args: Any, **more: Any) -> Any:
        if name.startswith("matplotlib"):
            raise ImportError(name)
        return real(name, *args, **more)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(FigureError, match=r"trs80arm\[plot\]"):
        SMALL.save(tmp_path / "figure.svg")
