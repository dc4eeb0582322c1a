"""Pictures in pixels, for terminals that show them: Kitty's graphics, or sixels.

What a terminal can and how a picture is written for it is known by the library textual-image
(extra `pixels`). It asks the terminal once, when it is loaded, with a bound on how long it waits;
that must be before Textual reads the terminal. Its widgets lay the whole screen out anew for each
picture, so that its renderables are used, and what they write goes the way of everything that
Textual writes.
The hooks that this leans on are pinned by `tests/ui/test_pixels.py`.
"""

from __future__ import annotations

import io
import logging
import re
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any, Final

from rich.console import Console
from rich.segment import ControlType, Segment
from textual.geometry import Size
from textual.strip import Strip

from trs80arm.drawing.pixels import Colours, Pixels

if TYPE_CHECKING:
    from PIL.Image import Image

NOT_INSTALLED = "Pixels need one thing more: pip install 'trs80arm[pixels]'"
NOT_HERE = "This terminal tells of no pixels: neither Kitty's graphics nor sixels."
NOT_ASKED = (
    "Start with --arm-style pixels to ask this terminal for pixels: it is not known to have any."
)
ANSWERS = 0.1
"""Seconds within which a terminal answers."""
_FIRST_WITH_PLACEHOLDERS = {"kitty": (0, 28), "ghostty": (1, 0)}
"""From which version on a terminal has pictures in the place of characters."""
_NAMES = re.compile("kitty|ghostty|foot|contour|mlterm|sixel|rio|iterm|wezterm|vscode|mintty", re.I)
"""In the names of terminals that show pixels, or can be told to."""
_OF_THEIRS = ("KITTY_WINDOW_ID", "WEZTERM_PANE", "KONSOLE_VERSION", "WT_SESSION")
"""Variables that such terminals set."""
_TRUE_COLOUR: Final = "truecolor"
_SIXELS = "\x1bP"
_DEFINED = re.compile(r"#(\d+);2;\d+;\d+;\d+")
"""A colour of sixels as it is defined; xterm wants it to be chosen after that."""
_SAVE, _RESTORE = "\x1b7", "\x1b8"
_NO_TEXT = ((ControlType.CURSOR_FORWARD, 0),)
"""Marks what is written for the terminal alone, and has no width."""


class NoPixelsError(Exception):
    """There are no pixels here: one clear line."""


class PixelScreen:
    """A terminal that shows pixels.

    Args:
        renderable: the library's class of pictures for it.

    Attributes:
        cell: width and height of a character cell in pixels.
    """

    def __init__(self, renderable: Any) -> None:
        from textual_image._terminal import get_cell_size

        self._renderable = renderable
        width, height = get_cell_size()
        self.cell = (width, height)

    def picture(self, pixels: Pixels, colours: Colours) -> PixelPicture:
        """A picture in the colours of a theme, ready to be written."""
        height, width = pixels.words.glyphs.shape
        image = image_of(pixels, colours, (width * self.cell[0], height * self.cell[1]))
        return PixelPicture(self._renderable(image, width, height), width, height)


class PixelPicture:
    """A picture for one terminal.

    Args:
        image: the library's.
        width: cells.
        height: cells.

    Attributes:
        size: its width and height.
    """

    def __init__(self, image: Any, width: int, height: int) -> None:
        self.size = Size(width, height)
        self._image = image
        console = Console(width=width, height=height, color_system=_TRUE_COLOUR)
        with _written() as text:
            self._segments = list(console.render(image, console.options.update(height=height)))
        self._sent = text.getvalue()

    def strips(self, x: int, y: int) -> list[Strip]:
        """The picture's rows on the screen.

        Args:
            x: its left column on the screen.
            y: its upper row.
        """
        sixels = next((s.text for s in self._segments if s.text.startswith(_SIXELS)), None)
        if sixels is not None:
            # The cells stay as they are, or the terminal would blank what is drawn there.
            skip = Segment(f"\x1b[{self.size.width}C", None, _NO_TEXT)
            sixels = _DEFINED.sub(r"\g<0>#\1", sixels)
            draw = f"{_SAVE}\x1b[{y + 1};{x + 1}H{sixels}{_RESTORE}"
            rows = [[skip] for _ in range(self.size.height)]
            rows[-1] = [Segment(draw, None, _NO_TEXT), skip]
            return [Strip(row, self.size.width) for row in rows]
        rows = [
            [Segment(line, segment.style)]
            for segment in self._segments
            for line in segment.text.splitlines()
        ]
        rows[0].insert(0, Segment(self._sent, None, _NO_TEXT))
        return [Strip(row, self.size.width) for row in rows]

    @property
    def farewell(self) -> Segment:
        """Tells the terminal that the picture is not needed any more; it has no width."""
        number = getattr(self._image, "terminal_image_id", None)
        # The library's own message has no number that Kitty knows.
        return Segment(f"\x1b_Ga=d,d=I,i={number},q=2\x1b\\" if number else "", None, _NO_TEXT)


def may_have_pixels(environment: Mapping[str, str]) -> bool:
    """Whether the environment speaks of a terminal that may show pixels.

    One that does not is not asked by the way: most do not answer such questions at all, and to find
    that out takes as long as half of the rest of the start.
    """
    names = " ".join(environment.get(name, "") for name in ("TERM", "TERM_PROGRAM"))
    if "tmux" in names or "screen" in names:
        return False
    return bool(_NAMES.search(names)) or any(name in environment for name in _OF_THEIRS)


def find_pixels(colours: str | None) -> PixelScreen:
    """Ask the terminal what pictures it shows; before Textual reads it, and once in a process.

    Args:
        colours: the colours that the terminal is taken to have, as Rich calls them.

    Raises:
        NoPixelsError: it shows none, or the library is not installed.
    """
    # What the library finds out is told in a line, and not by it.
    logging.getLogger("textual_image").addHandler(logging.NullHandler())
    try:
        from textual_image.renderable import Image, SixelImage, TGPImage
    except ModuleNotFoundError:
        raise NoPixelsError(NOT_INSTALLED) from None
    # Kitty's pictures are named by a colour, which must arrive as it is.
    kitty = Image is TGPImage and colours == _TRUE_COLOUR
    if Image is SixelImage or (kitty and has_placeholders(_terminal_name())):
        # The library divides by the number of columns, which some do not tell.
        with suppress(ZeroDivisionError):
            return PixelScreen(Image)
    raise NoPixelsError(NOT_HERE)


def _terminal_name() -> str:
    """What the terminal calls itself and its version (XTVERSION), or nothing."""
    from textual_image._terminal import TerminalError, capture_terminal_response

    try:
        with capture_terminal_response("\x1bP>|", "\x1b\\", timeout=ANSWERS) as answer:
            if sys.__stdout__ is not None:
                sys.__stdout__.write("\x1b[>0q")
                sys.__stdout__.flush()
    except (TerminalError, TimeoutError):
        return ""
    return str(answer.sequence[4:-2])


def has_placeholders(name: str) -> bool:
    """Whether a terminal of Kitty's graphics has pictures in the place of characters.

    The library has no other, and terminals without them show boxes.

    Args:
        name: what the terminal calls itself: `kitty(0.28.0)`, `ghostty 1.1.3`.
    """
    known = re.match(r"(\w+)[ (]v?(\d+)\.(\d+)", name)
    if known is None:
        return False
    terminal, *version = known.groups()
    first = _FIRST_WITH_PLACEHOLDERS.get(terminal.lower())
    return first is not None and tuple(map(int, version)) >= first


def image_of(pixels: Pixels, colours: Colours, size: tuple[int, int]) -> Image:
    """The picture with what is written over it.

    Args:
        pixels: it.
        colours: a theme's.
        size: width and height in pixels.
    """
    from PIL import Image, ImageDraw

    image = Image.fromarray(pixels.coloured(colours))
    if image.size != size:
        image = image.resize(size, Image.Resampling.BOX)
    height, width = pixels.words.glyphs.shape
    across, down = size[0] / width, size[1] / height
    pen, letters = ImageDraw.Draw(image), _letters(down)
    for x, y, sign, ink in pixels.written():
        middle = ((x + 0.5) * across, (y + 0.5) * down)
        pen.text(middle, sign, fill=colours.inks[ink], font=letters, anchor="mm")
    return image


def _letters(height: float) -> Any:
    """Pillow's own letters for cells so high."""
    from PIL import ImageFont

    return ImageFont.load_default(max(8, round(height * 0.7)))


@contextmanager
def _written() -> Iterator[io.StringIO]:
    """Takes up what the library writes past Textual, to the terminal's standard output."""
    text, kept = io.StringIO(), sys.__stdout__
    vars(sys)["__stdout__"] = text
    try:
        yield text
    finally:
        vars(sys)["__stdout__"] = kept
