"""Films: what they show is what the terminal shows, and each kind of file is one of its kind."""

from __future__ import annotations

import io
import json
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from click.testing import CliRunner
from PIL import Image, ImageChops

from tests.goldens import check_golden
from tests.monospaced import FONT
from tests.own_places import own_places
from trs80arm.cli.commands import cli
from trs80arm.film.blocks import blocks_of
from trs80arm.film.cast import cast
from trs80arm.film.frames import Film, Look
from trs80arm.film.gif import gif
from trs80arm.film.svg import svg
from trs80arm.options import ArmStyle, TerminalOptions
from trs80arm.ui.filming import FilmError, Shooting, make_film

__all__ = ["own_places"]

PLAIN = Look("#00ff00", "#000000")
LOUD = Look("#ffffff", "#202020", bold=True)


def short_film() -> Film:
    """Three pictures of two lines; the upper line changes once, the lower never."""
    film = Film(6, 2, "a <short> film")
    below = (("<&> ", PLAIN), ("▀⣿", LOUD))
    film.add(0.0, ((("ONE   ", PLAIN),), below))
    film.add(0.5, ((("ONE   ", PLAIN),), below))
    film.add(1.0, ((("TWO   ", PLAIN),), below))
    film.add(2.0, ((("TWO   ", PLAIN),), below))
    return film


def test_pictures_that_are_alike_are_one() -> None:
    film = short_film()
    assert [frame.time for frame in film.frames] == [0.0, 1.0]
    assert film.seconds == 2.0


def test_an_svg_has_every_run_once_and_the_times_of_those_that_change() -> None:
    tree = ET.fromstring(svg(short_film()))
    space = {"s": "http://www.w3.org/2000/svg"}
    texts = [text.text for text in tree.iterfind(".//s:text", space)]
    assert sorted(filter(None, texts)) == ["<&>", "ONE", "TWO"]
    shown = {
        group.findtext("s:text", namespaces=space): [
            (each.get("to"), each.get("begin")) for each in group.iterfind("s:set", space)
        ]
        for group in tree.iterfind("s:g", space)
    }
    assert shown == {
        "ONE": [("none", "f.begin+1s")],
        "TWO": [("inline", "f.begin+1s")],
    }


def test_what_is_in_every_picture_of_an_svg_is_never_hidden() -> None:
    film = Film(6, 2, "the last picture differs from the one before")
    for time, text in ((0.0, "ONE   "), (1.0, "TWO   "), (2.0, "THREE ")):
        film.add(time, (((text, PLAIN),), (("STAYS ", LOUD),)))
    made = svg(film).decode()
    assert 'dur="0s"' not in made
    [line] = [line for line in made.splitlines() if "STAYS" in line]
    assert "<set" not in line


def test_in_a_long_film_each_run_ends_where_the_next_one_begins() -> None:
    film = Film(6, 1, "fifteen pictures a second")
    times = [number / 15 for number in range(4000, 4020)]
    film.add(0.0, ((("before", PLAIN),),))
    for number, time in enumerate(times):
        film.add(time, (((f"{number:<6}", PLAIN),),))
    made = svg(film).decode()
    spells = sorted(
        (float(begin), float(length))
        for begin, length in re.findall(
            r'"inline" begin="f\.begin\+([\d.]+)s" dur="([\d.]+)s"', made
        )
    )
    assert len(spells) == len(times)
    ends = [begin + length for begin, length in spells]
    assert [begin for begin, _ in spells[1:]] == pytest.approx(ends[:-1], abs=1e-6)


def test_the_svg_of_a_short_film() -> None:
    check_golden("film-svg", svg(short_film()).decode())


def test_a_cast_sends_the_lines_that_differ() -> None:
    header, *events = [json.loads(line) for line in cast(short_film()).decode().splitlines()]
    assert (header["version"], header["width"], header["height"]) == (2, 6, 2)
    assert [time for time, _, _ in events] == [0.0, 1.0, 2.0]
    first, second, _ = (text for _, _, text in events)
    assert "ONE" in first
    assert "<&>" in first
    assert "TWO" in second
    assert "<&>" not in second
    assert "\x1b[1;1H" in second


def test_a_gif_has_a_picture_for_each_and_their_times() -> None:
    with Image.open(io.BytesIO(gif(short_film(), FONT))) as picture:
        assert getattr(picture, "n_frames") == 2  # noqa: B009
        assert picture.info["duration"] == 1000
        first = picture.convert("RGB")
        picture.seek(1)
        second = picture.convert("RGB")
        left, top, right, bottom = ImageChops.difference(first, second).getbbox() or (0, 0, 0, 0)
        assert 0 <= left < right <= first.width / 2
        assert 0 <= top < bottom <= first.height / 2


def test_blocks_are_as_large_as_they_look() -> None:
    def area(sign: str) -> float:
        return sum(width * height for _, _, width, height in blocks_of(sign))

    assert area("█") == 1
    assert area("▀") == area("▄") == area("🬋") * 1.5 == 0.5
    assert blocks_of("A") == ()
    assert len(blocks_of("⣿")) == 8


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "turn.bas"
    path.write_text('10 PRINT "HERE":INPUT A\n20 @STEP 50,100\n30 PRINT "DONE"\n')
    return path


@pytest.mark.usefixtures("own_places")
def test_a_run_is_filmed_with_its_answers_until_it_has_ended(tmp_path: Path, program: Path) -> None:
    target = tmp_path / "film.cast"
    options = TerminalOptions(program=program)
    make_film(options, Shooting(80, 24, fps=4, speed=2, seconds=30, inputs=("7",)), target)
    events = [json.loads(line) for line in target.read_text("utf-8").splitlines()[1:]]
    everything = "".join(text for _, _, text in events)
    assert "HERE" in everything
    assert "DONE" in everything
    assert 1 < events[-1][0] < 10
    again = tmp_path / "again.cast"
    make_film(options, Shooting(80, 24, fps=4, speed=2, seconds=30, inputs=("7",)), again)
    assert again.read_bytes() == target.read_bytes()


@pytest.mark.usefixtures("own_places")
def test_who_has_pixels_is_filmed_in_half_blocks(tmp_path: Path, program: Path) -> None:
    films = []
    for style in (ArmStyle.PIXELS, ArmStyle.HALF):
        target = tmp_path / f"{style}.cast"
        options = TerminalOptions(program=program, arm=style)
        make_film(options, Shooting(80, 24, fps=1, seconds=0.5), target)
        films.append(target.read_bytes())
    assert films[0] == films[1]


@pytest.mark.usefixtures("own_places")
@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("-o", "film.mp4"), "a film is a"),
        (("-o", "film.svg", "--size", "wide"), "COLUMNSxROWS"),
        (("-o", "film.svg", "--size", "20x5"), "needs 40 columns"),
        (("-o", "film.svg", "--do", "dance"), "no such command"),
        (("-o", "film.svg", "--set", "6:fast"), "6:fast"),
        (("-o", "film.svg", "--font", "x.ttf"), "--font is for a GIF"),
        (("-o", "film.gif", "--seconds", "0.1", "--font", "x.ttf"), "no font"),
    ],
)
def test_what_cannot_be_filmed_is_told_in_a_line(
    program: Path, arguments: tuple[str, ...], said: str
) -> None:
    result = CliRunner().invoke(cli, ["film", str(program), *arguments])
    assert result.exit_code == 2
    assert said in result.output
    with pytest.raises(FilmError):
        make_film(TerminalOptions(program=program), Shooting(), program)
