"""Nothing from outside reaches a terminal raw."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm.reasons import one_line
from trs80arm.shown import shown


@pytest.mark.parametrize(
    ("text", "seen"),
    [
        ("table 4.bas", "table 4.bas"),
        ("Übung ↑ [/x].bas", "Übung ↑ [/x].bas"),
        ("n\x1b]0;X\x07.bas", "n\\x1b]0;X\\x07.bas"),
        ("a\nb\r\tc\0", "a\\nb\\r\\tc\\x00"),
        ("\x9b31m\x7f", "\\x9b31m\\x7f"),
        ("safe\u202etxt.exe", "safe\\u202etxt.exe"),
        ("\udce9.bas", "\\udce9.bas"),
        ("\u2028", "\\u2028"),
    ],
)
def test_control_codes_stand_for_themselves(text: str, seen: str) -> None:
    assert shown(text) == seen


@given(st.text())
def test_whatever_is_shown_is_one_printable_line(text: str) -> None:
    assert shown(text).isprintable()
    assert one_line(OSError(2, "No such file", text)).isprintable()
    assert one_line(ValueError(text)).isprintable()
