"""Films as GIF, drawn with Pillow (extra `film`)."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING

from trs80arm.film.blocks import blocks_of
from trs80arm.film.frames import Film, Line

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
    try:
        from PIL import Image, ImageDraw
    except ModuleNotFoundError:
        raise GifError("a GIF needs Pillow: pip install 'trs80arm[film]'") from None
    letters = _font(font)
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


def _font(path: Path | None) -> FreeTypeFont:
    from PIL import ImageFont

    names = FONTS if path is None else (str(path),)
    for name in names:
        try:
            return ImageFont.truetype(name, SIZE)
        except OSError:
            continue
    if path is not None:
        raise GifError(f"{path}: this is no font that can be read")
    raise GifError("no monospaced font is found here; --font FILE names one")


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
