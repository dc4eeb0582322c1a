"""Films as asciinema casts, version 2: what a terminal would have been sent, with times."""

from __future__ import annotations

import json

from trs80arm.film.frames import Film, Line, Look


def cast(film: Film) -> bytes:
    """The film as a `.cast` file; of each picture the lines that differ."""
    header = {"version": 2, "width": film.width, "height": film.height, "title": film.title}
    events = [json.dumps(header, ensure_ascii=False)]
    shown: list[Line | None] = [None] * film.height
    for frame in film.frames:
        changed = "".join(
            f"\x1b[{row + 1};1H{_sent(line)}"
            for row, (line, old) in enumerate(zip(frame.lines, shown, strict=True))
            if line != old
        )
        shown = list(frame.lines)
        text = changed if frame.time else f"\x1b[?25l\x1b[2J{changed}"
        events.append(json.dumps([round(frame.time, 3), "o", text], ensure_ascii=False))
    events.append(json.dumps([round(film.seconds, 3), "o", "\x1b[0m\x1b[?25h"]))
    return ("\n".join(events) + "\n").encode("utf-8")


def _sent(line: Line) -> str:
    return "".join(f"{_style(look)}{text}" for text, look in line)


def _style(look: Look) -> str:
    parts = ["0", *(["1"] if look.bold else [])]
    for code, colour in (("38", look.ink), ("48", look.ground)):
        red, green, blue = (int(colour[place : place + 2], 16) for place in (1, 3, 5))
        parts.append(f"{code};2;{red};{green};{blue}")
    return f"\x1b[{';'.join(parts)}m"
