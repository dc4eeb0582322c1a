"""Pictures in pixels, decoded as a terminal would from what is written to it."""

from __future__ import annotations

import base64
import io
import os
import pty
import re
import select
import sys
import termios
import time
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from rich.style import Style
from textual.notifications import Notification
from textual.strip import Strip
from textual.widgets._toast import Toast
from textual_image.renderable import SixelImage, TGPImage

from tests import warm_start
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.drawing.picture import FROM_THE_SIDE, Picture
from trs80arm.drawing.pixels import Colours, Pixels
from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import Ink
from trs80arm.options import ArmStyle
from trs80arm.rig import Rig
from trs80arm.ui.screens import desk as desk_module
from trs80arm.ui.terminal import pixels as under_test
from trs80arm.ui.terminal.pixels import (
    NOT_HERE,
    NOT_INSTALLED,
    NoPixelsError,
    PixelScreen,
    find_pixels,
    has_placeholders,
    may_have_pixels,
)

COLOURS = Colours((7, 19, 10), {ink: (200, 100 + 5 * n, 40) for n, ink in enumerate(Ink)})
SIZE = (24, 9)


def picture() -> Pixels:
    return Picture(FROM_THE_SIDE).pixels(Readings.of(Rig()), *SIZE, (10, 20))


def written(strips: list[Strip]) -> str:
    return "".join(segment.text for strip in strips for segment in strip)


def sixels(text: str) -> np.ndarray:
    """What a terminal shows of sixels: a colour that is defined has to be chosen too."""
    head, body = re.findall(r"\x1bP[\d;]*q\"1;1;(\d+;\d+)(.*?)\x1b\\", text)[0]
    width, height = map(int, head.split(";"))
    sheet = np.full((height + 6, width, 3), 255, dtype=np.uint8)
    colours: dict[int, tuple[int, ...]] = {}
    x = y = 0
    colour: tuple[int, ...] = (255, 255, 255)
    words = r"#(\d+;2;\d+;\d+;\d+)|#(\d+)(?!;)|(?:!(\d+))?([$\-?-~])"
    for define, chosen, repeat, sign in re.findall(words, body):
        if define:
            number, _, *parts = map(int, define.split(";"))
            colours[number] = tuple(round(part * 2.55) for part in parts)
        elif chosen:
            colour = colours[int(chosen)]
        elif sign == "$":
            x = 0
        elif sign == "-":
            x, y = 0, y + 6
        else:
            count = int(repeat or 1)
            for bit in range(6):
                if (ord(sign) - 63) >> bit & 1:
                    sheet[y + bit, x : x + count] = colour
            x += count
    return sheet[:height]


def kitty(text: str) -> tuple[int, np.ndarray]:
    """The number of a picture sent in Kitty's way, and the picture."""
    messages = re.findall(r"\x1b_G([^;\x1b]*);?([^\x1b]*)\x1b\\", text)
    sent = [(dict(pair.split("=") for pair in keys.split(",")), data) for keys, data in messages]
    data = "".join(data for keys, data in sent if keys.get("f") == "100")
    placed = next(keys for keys, _ in sent if keys.get("a") == "p")
    assert placed["U"] == "1"
    assert (int(placed["c"]), int(placed["r"])) == SIZE
    image = Image.open(io.BytesIO(base64.b64decode(data)))
    return int(placed["i"]), np.asarray(image.convert("RGB"))


def test_sixels_show_the_picture() -> None:
    pixels, screen = picture(), PixelScreen(SixelImage)
    strips = screen.picture(pixels, COLOURS).strips(5, 3)
    text = written(strips)
    assert "\x1b[4;6H\x1bP" in text
    assert text.count("\x1b7") == text.count("\x1b8") == 1
    assert [strip.cell_length for strip in strips] == [SIZE[0]] * SIZE[1]
    shown, meant = sixels(text), pixels.coloured(COLOURS)
    width, height = screen.cell
    assert shown.shape == (height * SIZE[1], width * SIZE[0], 3)
    assert np.abs(shown.astype(int) - meant).mean() < 6


def test_sixels_leave_the_cells_and_the_cursor_alone() -> None:
    strips = PixelScreen(SixelImage).picture(picture(), COLOURS).strips(0, 0)
    assert {written([strip]) for strip in strips[:-1]} == {"\x1b[24C"}
    assert written(strips[-1:]).endswith("\x1b8\x1b[24C")


def test_kitty_shows_the_picture_in_the_place_of_characters() -> None:
    pixels, screen = picture(), PixelScreen(TGPImage)
    made = screen.picture(pixels, COLOURS)
    strips = made.strips(5, 3)
    number, shown = kitty(written(strips))
    assert np.abs(shown.astype(int) - pixels.coloured(COLOURS)).mean() < 6
    for strip in strips:
        style = next(segment.style for segment in strip if "\U0010eeee" in segment.text)
        assert isinstance(style, Style)
        assert style.color is not None
        assert style.color.triplet is not None
        red, green, blue = style.color.triplet
        assert (red << 16 | green << 8 | blue) == number & 0xFFFFFF
    assert made.farewell.text == f"\x1b_Ga=d,d=I,i={number},q=2\x1b\\"


def test_nothing_is_written_past_textual(capfd: pytest.CaptureFixture[str]) -> None:
    for renderable in (SixelImage, TGPImage):
        PixelScreen(renderable).picture(picture(), COLOURS).strips(0, 0)
    assert capfd.readouterr().out == ""


def test_words_are_written_over_the_picture() -> None:
    bare = picture()
    bare.words.glyphs[:] = 32
    labelled = picture()
    images = [
        kitty(written(PixelScreen(TGPImage).picture(pixels, COLOURS).strips(0, 0)))[1]
        for pixels in (bare, labelled)
    ]
    assert (images[0] != images[1]).any(2).sum() > 50


@pytest.mark.parametrize(
    ("name", "has"),
    [
        ("kitty(0.26.5)", False),
        ("kitty(0.28.0)", True),
        ("kitty(0.42.1)", True),
        ("ghostty 1.1.3", True),
        ("WezTerm 20240203-110809", False),
        ("Konsole 23.08", False),
        ("", False),
    ],
)
def test_kittys_graphics_are_not_enough(name: str, has: bool) -> None:
    assert has_placeholders(name) is has


@pytest.mark.parametrize(
    ("environment", "asked"),
    [
        ({"TERM": "xterm-kitty"}, True),
        ({"TERM": "foot"}, True),
        ({"TERM": "xterm-256color", "TERM_PROGRAM": "iTerm.app"}, True),
        ({"TERM": "xterm-256color", "KONSOLE_VERSION": "240800"}, True),
        ({"TERM": "xterm-256color"}, False),
        ({"TERM": "tmux-256color", "TERM_PROGRAM": "tmux", "KITTY_WINDOW_ID": "1"}, False),
        ({}, False),
    ],
)
def test_only_terminals_that_may_have_pixels_are_asked_by_the_way(
    environment: dict[str, str], asked: bool
) -> None:
    assert may_have_pixels(environment) is asked


def test_without_the_library_one_line_says_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "textual_image.renderable", None)
    with pytest.raises(NoPixelsError, match=r"pip install 'trs80arm\[pixels\]'"):
        find_pixels("truecolor")
    assert "\n" not in NOT_INSTALLED


ASKED = """
from trs80arm.ui.terminal.pixels import NoPixelsError, find_pixels
try:
    print("PIXELS", find_pixels("truecolor").picture is not None)
except NoPixelsError as error:
    print("NONE", error)
"""


@pytest.mark.parametrize(
    ("answers", "found"),
    [
        ({}, "NONE"),
        ({b"\x1b[c": b"\x1b[?62;4;22c"}, "PIXELS"),
        ({b"\x1b[c": b"\x1b[?62;4;22c"}, "NONE"),
        ({b"\x1b[c": b"\x1b[?62;22c"}, "NONE"),
        (
            {
                b"\x1b[c": b"\x1b[?62c",
                b"a=q": b"\x1b_Gi=1;OK\x1b\\",
                b"\x1b[>0q": b"\x1bP>|kitty(0.35.1)\x1b\\",
            },
            "PIXELS",
        ),
        (
            {
                b"\x1b[c": b"\x1b[?62c",
                b"a=q": b"\x1b_Gi=1;OK\x1b\\",
                b"\x1b[>0q": b"\x1bP>|kitty(0.26.5)\x1b\\",
            },
            "NONE",
        ),
    ],
    ids=["silent", "sixel", "sixel without a size", "neither", "kitty", "old kitty"],
)
def test_the_terminal_is_asked_and_not_waited_for(answers: dict[bytes, bytes], found: str) -> None:
    master, slave = pty.openpty()
    termios.tcsetwinsize(slave, (0, 0) if found == "NONE" else (24, 80))
    process = warm_start.start(ASKED, [], slave, Path.cwd(), dict(os.environ))
    left, output, until = dict(answers), b"", time.monotonic() + 40
    while b"PIXELS" not in output and b"NONE" not in output:
        assert time.monotonic() < until, output
        if select.select([master], [], [], 0.1)[0]:
            output += os.read(master, 4096)
        for question in [question for question in left if question in output]:
            os.write(master, left.pop(question))
    assert process.wait(20) == 0
    os.close(slave)
    os.close(master)
    assert found.encode() in output
    assert b"Traceback" not in output


async def show_pixels(sitting: Sitting, renderable: type) -> None:
    sitting.app.desk.use_pixels(PixelScreen(renderable))
    sitting.app.desk.use_arm_style(ArmStyle.PIXELS)
    await sitting.settle()


@piloted
async def test_the_panels_show_the_arm_in_pixels(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await show_pixels(sitting, SixelImage)
        assert screen_text(sitting.app).count("\x1bP") == 2


@piloted
async def test_nothing_lies_over_pixels(sit_down: Opener) -> None:
    async with sit_down(120, 40) as sitting:
        await show_pixels(sitting, TGPImage)
        assert "\U0010eeee" in screen_text(sitting.app)
        await sitting.press("f8")
        await sitting.settle()
        assert "\U0010eeee" not in screen_text(sitting.app)
        await sitting.press("escape")
        await sitting.settle()
        assert "\U0010eeee" in screen_text(sitting.app)
        await sitting.app.screen.mount(Toast(Notification("The printer is on fire.")))
        await sitting.settle()
        assert "\U0010eeee" not in screen_text(sitting.app)


@piloted
async def test_a_terminal_without_pixels_says_so_and_has_half_blocks(sit_down: Opener) -> None:
    async with sit_down(120, 40, arm=ArmStyle.PIXELS) as sitting:
        await sitting.pass_time(0.2)
        assert NOT_HERE[:40] in screen_text(sitting.app)
        assert sitting.app.desk.arm_style is ArmStyle.HALF


@piloted
async def test_pixels_leave_time_for_the_machine(
    sit_down: Opener, monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = iter(range(10**6))
    monkeypatch.setattr(desk_module.time, "thread_time", lambda: next(clock) * 0.05)
    made = []
    real = under_test.PixelScreen.picture

    def counted(self: PixelScreen, pixels: Pixels, colours: Colours) -> object:
        made.append(pixels)
        return real(self, pixels, colours)

    monkeypatch.setattr(under_test.PixelScreen, "picture", counted)
    async with sit_down(120, 40) as sitting:
        await show_pixels(sitting, SixelImage)
        sitting.app.session.rig.type("@STEP 50,2000\r")
        sitting.app.session.rig.run_for(1.5)
        await sitting.pass_time(0.3)
        made.clear()
        await sitting.pass_time(1.0)
        # Two views that took 0.05 s: at a quarter of the time five looks a second.
        assert 6 <= len(made) <= 12
