"""Films as GIF, drawn with Pillow (extra `film`)."""

from __future__ import annotations

import io
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from trs80arm.film.blocks import blocks_of
from trs80arm.film.frames import Film, Line
from trs80arm.paths import read_beginning

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw
    from PIL.ImageFont import FreeTypeFont

SIZE = 14
"""Height of the letters, pixels."""
FONTS = (
    *("DejaVuSansMono.ttf", "LiberationMono-Regular.ttf", "Menlo.ttc", "consola.ttf"),
    *("Consolas.ttf", "UbuntuMono-R.ttf", "NotoSansMono-Regular.ttf", "cour.ttf"),
)
"""Monospaced fonts by the names of their files; Pillow looks where the system keeps fonts."""
LARGEST_FONT = 64 * 1024 * 1024
"""Bytes of a font that are read."""
_COLOURS = 256
_PAUSE = 1500
"""Milliseconds for which the last picture stays before the film begins again."""


class GifError(Exception):
    """A GIF cannot be made here: one clear line."""


def gif(film: Film, font: Path | None = None) -> bytes:
    """The film as a GIF file.

    Args:
        film: what is to be shown.
        font: a file with a monospaced font; None looks for one.

    Raises:
        GifError: Pillow is not installed, or there is no font.
    """
    letters = find_letters(font)
    from PIL import Image, ImageDraw

    width, height = round(letters.getlength("M")), sum(letters.getmetrics())
    sheet = Image.new("RGB", (film.width * width, film.height * height))
    pen = ImageDraw.Draw(sheet)
    shown: list[Line | None] = [None] * film.height
    pictures: list[Image.Image] = []
    times = []
    palette = _palette(film)
    for start, end, frame in film.spells():
        for row, (line, old) in enumerate(zip(frame.lines, shown, strict=True)):
            if line != old:
                _draw(pen, letters, line, row, width, height)
        shown = list(frame.lines)
        pictures.append(sheet.quantize(palette=palette, dither=Image.Dither.NONE))
        times.append(max(20, round(100 * (end - start)) * 10))
    times[-1] += _PAUSE
    out = io.BytesIO()
    pictures[0].save(
        out,
        "GIF",
        save_all=True,
        append_images=pictures[1:],
        duration=times,
        loop=0,
        optimize=False,
    )
    return out.getvalue()


def _palette(film: Film) -> Image:
    """A picture with the colours that take up most of the film."""
    from PIL import Image

    counts: dict[str, int] = {}
    for frame in film.frames:
        for line in frame.lines:
            for text, look in line:
                for colour in (look.ink, look.ground):
                    counts[colour] = counts.get(colour, 0) + len(text)
    chosen = sorted(counts, key=lambda colour: -counts[colour])[:_COLOURS]
    palette = Image.new("P", (1, 1))
    palette.putpalette(bytes.fromhex("".join(colour[1:] for colour in chosen)))
    return palette


def find_letters(path: Path | None) -> FreeTypeFont:
    """The letters that a film is to be drawn with, from a font's file or one of the system's.

    Raises:
        GifError: Pillow is not installed, or there is no font.
    """
    try:
        from PIL import ImageFont
    except ModuleNotFoundError:
        raise GifError("a GIF needs Pillow: pip install 'trs80arm[film]'") from None
    if path is not None:
        return _letters_in(path)
    for name in FONTS:
        with suppress(OSError):
            return ImageFont.truetype(name, SIZE)
    raise GifError("no monospaced font is found here; --font FILE names one")


def _letters_in(path: Path) -> FreeTypeFont:
    """The letters of a font's file, or of a font that the system has under that name."""
    from PIL import ImageFont

    try:
        # Read here: a pipe would be waited for, and a file without end be read to it.
        source = io.BytesIO(read_beginning(path, LARGEST_FONT)) if path.exists() else path
        return ImageFont.truetype(source, SIZE)
    except OSError:
        raise GifError(f"{path}: this is no font that can be read") from None


def _draw(
    pen: ImageDraw, letters: FreeTypeFont, line: Line, row: int, width: int, height: int
) -> None:
    x, y = 0, row * height
    for text, look in line:
        end = x + len(text) * width
        pen.rectangle((x, y, end - 1, y + height - 1), fill=look.ground)
        for sign in text:
            for left, top, across, down in blocks_of(sign):
                pen.rectangle(
                    (
                        x + round(left * width),
                        y + round(top * height),
                        x + round((left + across) * width) - 1,
                        y + round((top + down) * height) - 1,
                    ),
                    fill=look.ink,
                )
            if sign != " " and not blocks_of(sign):
                pen.text((x, y), sign, font=letters, fill=look.ink)
            x += width
