"""The cruncher: a typed line becomes the bytes that the ROM stores, and back again.

The dialogue hands it every line that was typed; LIST and EDIT have its lines spelled out again.
"""

from __future__ import annotations

from typing import NamedTuple

from trs80arm.basic import tokens, words
from trs80arm.basic.characters import (
    BLANK,
    BLANKS,
    CAPITAL,
    COLON,
    QUESTION,
    QUOTE,
    ZERO,
    is_digit,
    is_small_letter,
)
from trs80arm.basic.errors import BasicError, Code

LAST_LINE = 65529
"""The largest line number; 65530 is ?SN (facts, Crunching)."""

_ABOVE = 0x3C
"""The first character above the digits and their neighbours."""

# T-states, observed on the ROM line by line; they meet every line tried to the T-state.
_T_LINE, _T_QUOTE, _T_COPIED = 226, 59, 64
_T_BLANK, _T_COLON, _T_DIGIT, _T_QUESTION = 97, 227, 228, 190
_T_DATA, _T_COLON_OF_DATA = 166, 165
"""A line; a text in quotes, beside each byte copied; a character that is no word's; one of DATA."""
_T_WORD, _T_LETTER = 39, 23
"""A word passed in the search, beside each of its letters."""
_T_BEGINS_ALIKE, _T_ALIKE = 38, 79
"""A word passed that begins like the text, beside each letter that is alike."""
_T_FOUND, _T_FOUND_LETTER, _T_NO_WORD = 422, 102, 449
_T_ABOVE, _T_SMALL_FIRST, _T_SMALL = 12, 23, 2
_T_GOTO_LETTER, _T_GOTO_BLANK, _T_GOTO_END = 63, 42, 71
_T_KEPT = {tokens.DATA: 8, tokens.REM: -32, tokens.APOSTROPHE: -23, tokens.ELSE: 5}
"""What these words take more or less when they are found."""
_PASSED = tuple(
    sum(_T_WORD + _T_LETTER * len(word) for word in words.SPELLINGS[:place])
    for place in range(len(words.SPELLINGS) + 1)
)
"""T-states to pass the words in front of each, and all of them."""
_T_SPELL, _T_SPELL_CHARACTER = 99, 54
_T_SPELL_TOKEN, _T_SPELL_WORD, _T_SPELL_LETTER = 174, 16, 27
"""Spelling a line out: the line, a character copied; a token, each word and letter passed."""
_SPELLED = tuple(
    _T_SPELL_TOKEN
    + _T_SPELL_WORD * place
    + _T_SPELL_LETTER * sum(map(len, words.SPELLINGS[:place]))
    + _T_SPELL_CHARACTER * len(word)
    for place, word in enumerate(words.SPELLINGS)
)

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
        while position < size and text[position] in BLANKS:
            position += 1
        if position >= size or not is_digit(text[position]):
            return (number if digits else None), position
        if number > LAST_LINE // 10:
            raise BasicError(Code.SN)
        number = number * 10 + text[position] - ZERO
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
    while start < size and text[start] in BLANKS:
        start += 1
    if start >= size or not is_digit(text[start]):
        return None, text[start:]
    number, end = line_number(text, start)
    behind = end
    while behind > 0 and text[behind - 1] == BLANK:
        behind -= 1
    if behind < size and text[behind] == BLANK:
        behind += 1
    return number, text[behind:]


class Crunched(NamedTuple):
    """A typed line as it is stored, and the T-states that crunching takes the ROM (1BC0H)."""

    text: bytes
    cost: int


class _Found(NamedTuple):
    """What the search of the table came to.

    Attributes:
        code: the token; None if no word stands there.
        end: the place behind the word.
        cost: T-states of the search.
    """

    code: int | None
    end: int
    cost: int


def _search(text: bytes, position: int) -> _Found:
    """The first word of the table that stands at `position`, found as the ROM does.

    It passes one word after the other; a word that begins alike is compared further. Between the
    letters of GOTO, blanks are passed over.
    """
    first = text[position]
    size = len(text)
    cost = _T_ABOVE * (first >= _ABOVE)
    if is_small_letter(first):
        first &= CAPITAL
        cost += _T_SMALL_FIRST
    for code, word in _BY_FIRST.get(first, ()):
        place = position + 1
        alike = 1
        for wanted in word[1:]:
            if code == tokens.GOTO:
                cost += _T_GOTO_LETTER
                while place < size and text[place] == BLANK:
                    place += 1
                    cost += _T_GOTO_BLANK
                if place >= size:
                    cost += _T_GOTO_END
            if place >= size:
                break
            got = text[place]
            if is_small_letter(got):
                got &= CAPITAL
                cost += _T_SMALL
            if got != wanted:
                break
            place += 1
            alike += 1
        else:
            cost += _PASSED[code - tokens.FIRST] + _T_FOUND + _T_FOUND_LETTER * len(word)
            return _Found(code, place, cost + _T_KEPT.get(code, 0))
        cost += _T_BEGINS_ALIKE + _T_ALIKE * alike
    return _Found(None, position, cost + _PASSED[-1] + _T_NO_WORD)


def crunch(text: bytes) -> Crunched:
    """The text of a line, without its number, as it is stored.

    Words are found wherever they stand outside quotes, REM and DATA; `?` is PRINT, `'` is stored as
    colon, REM and its own token, ELSE as colon and token. Codes from 128 on that were typed in
    are dropped.
    """
    out = bytearray()
    position, size = 0, len(text)
    cost = _T_LINE
    in_data = False
    while position < size:
        code = text[position]
        if code == QUOTE:
            end = text.find(b'"', position + 1)
            end = size if end < 0 else end + 1
            out += text[position:end]
            cost += _T_QUOTE + _T_COPIED * (end - position)
            position = end
            continue
        if code >= 0x80:
            position += 1
            continue
        if code == BLANK:
            cost += _T_BLANK
        elif code == COLON:
            cost += _T_COLON_OF_DATA if in_data else _T_COLON
            in_data = False
        elif in_data:
            cost += _T_DATA
        elif code == QUESTION:
            out.append(tokens.PRINT)
            cost += _T_QUESTION
            position += 1
            continue
        elif ZERO <= code < _ABOVE:
            cost += _T_DIGIT
        else:
            word, end, search = _search(text, position)
            cost += search
            if word is not None:
                position = end
                if word == tokens.ELSE:
                    out.append(COLON)
                elif word == tokens.APOSTROPHE:
                    out += bytes((COLON, tokens.REM))
                out.append(word)
                if word in (tokens.REM, tokens.APOSTROPHE):
                    out += text[position:]
                    cost += _T_COPIED * (size - position)
                    break
                in_data = word == tokens.DATA
                continue
            if is_small_letter(code):
                code &= CAPITAL
        out.append(code)
        position += 1
    return Crunched(bytes(out), cost)


def spell(crunched: bytes) -> bytes:
    """A stored line spelled out as LIST shows it.

    The colon stored before ELSE and the colon and REM before an apostrophe are not shown.
    """
    out = bytearray()
    position, size = 0, len(crunched)
    while position < size:
        code = crunched[position]
        if code == COLON and position + 1 < size:
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


def spelling_cost(crunched: bytes) -> int:
    """T-states in which the ROM spells a stored line out for LIST and EDIT (2B7EH)."""
    return _T_SPELL + sum(
        _T_SPELL_CHARACTER
        if code < tokens.FIRST
        else _SPELLED[min(code, tokens.APOSTROPHE) - tokens.FIRST]
        for code in crunched
    )
