"""The cruncher: a typed line becomes the bytes that the ROM stores, and back again.

The dialogue hands it every line that was typed; LIST and EDIT have its lines spelled out again.
"""

from __future__ import annotations

from trs80arm.basic import tokens, words
from trs80arm.basic.errors import BasicError, Code

LAST_LINE = 65529
"""The largest line number; 65530 is ?SN (facts, Crunching)."""

_BLANK = 0x20
_COLON = 0x3A
_QUOTE = 0x22
_SEARCHED = tuple(enumerate(words.SPELLINGS, tokens.FIRST))
_BY_FIRST: dict[int, list[tuple[int, bytes]]] = {}
for _code, _word in _SEARCHED:
    _BY_FIRST.setdefault(_word[0], []).append((_code, _word))


def line_number(text: bytes, position: int = 0) -> tuple[int | None, int]:
    """A line number as the ROM reads it, blanks before and inside it skipped.

    Returns:
        The number, None where there is no digit, and the place of the first character behind it
        and the blanks that follow it.

    Raises:
        BasicError: SN above 65529.
    """
    size = len(text)
    number = 0
    digits = False
    while True:
        while position < size and text[position] in b" \t\n":
            position += 1
        if position >= size or not 0x30 <= text[position] <= 0x39:
            return (number if digits else None), position
        if number > LAST_LINE // 10:
            raise BasicError(Code.SN)
        number = number * 10 + text[position] - 0x30
        digits = True
        position += 1


def split_line(text: bytes) -> tuple[int | None, bytes]:
    """A typed line as its number (None for a direct line) and its text.

    The first blank behind the number is dropped, the others are kept.

    Raises:
        BasicError: SN for a number above 65529.
    """
    size = len(text)
    start = 0
    while start < size and text[start] in b" \t\n":
        start += 1
    if start >= size or not 0x30 <= text[start] <= 0x39:
        return None, text[start:]
    number, end = line_number(text, start)
    behind = end
    while behind > 0 and text[behind - 1] == _BLANK:
        behind -= 1
    if behind < size and text[behind] == _BLANK:
        behind += 1
    return number, text[behind:]


def _match(text: bytes, position: int) -> tuple[int, int] | None:
    """The token of the first word of the table that stands at `position`, and where it ends."""
    first = text[position]
    if 0x61 <= first <= 0x7A:
        first &= 0x5F
    for code, word in _BY_FIRST.get(first, ()):
        place = position + 1
        for wanted in word[1:]:
            if code == tokens.GOTO:
                while place < len(text) and text[place] == _BLANK:
                    place += 1
            if place >= len(text):
                break
            got = text[place]
            if 0x61 <= got <= 0x7A:
                got &= 0x5F
            if got != wanted:
                break
            place += 1
        else:
            return code, place
    return None


def crunch(text: bytes) -> bytes:
    """The text of a line, without its number, as it is stored.

    Words are found wherever they stand outside quotes, REM and DATA; `?` is PRINT, `'` is stored as
    colon, REM and its own token, ELSE as colon and token. Codes from 128 on that were typed in
    are dropped.
    """
    out = bytearray()
    position, size = 0, len(text)
    in_data = False
    while position < size:
        code = text[position]
        if code == _QUOTE:
            end = text.find(b'"', position + 1)
            end = size if end < 0 else end + 1
            out += text[position:end]
            position = end
            continue
        if code >= 0x80:
            position += 1
            continue
        if code == _COLON:
            in_data = False
        elif not in_data and code != _BLANK:
            if code == 0x3F:
                out.append(tokens.PRINT)
                position += 1
                continue
            if not 0x30 <= code < 0x3C:
                found = _match(text, position)
                if found is not None:
                    word, position = found
                    if word == tokens.ELSE:
                        out.append(_COLON)
                    elif word == tokens.APOSTROPHE:
                        out += bytes((_COLON, tokens.REM))
                    out.append(word)
                    if word in (tokens.REM, tokens.APOSTROPHE):
                        out += text[position:]
                        break
                    in_data = word == tokens.DATA
                    continue
                if 0x61 <= code <= 0x7A:
                    code &= 0x5F
        out.append(code)
        position += 1
    return bytes(out)


def spell(crunched: bytes) -> bytes:
    """A stored line spelled out as LIST shows it.

    The colon stored before ELSE and the colon and REM before an apostrophe are not shown.
    """
    out = bytearray()
    position, size = 0, len(crunched)
    while position < size:
        code = crunched[position]
        if code == _COLON and position + 1 < size:
            if crunched[position + 1] == tokens.ELSE:
                position += 1
                continue
            if crunched[position + 1 : position + 3] == bytes((tokens.REM, tokens.APOSTROPHE)):
                position += 2
                continue
        if code < tokens.FIRST:
            out.append(code)
        elif code <= tokens.APOSTROPHE:
            out += words.SPELLINGS[code - tokens.FIRST]
        position += 1
    return bytes(out)
