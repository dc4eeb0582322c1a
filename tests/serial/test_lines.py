"""A stream of bytes cut into lines."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from trs80arm.serial.lines import LONGEST, NO_LINE, Lines

pieces = st.lists(st.binary(max_size=40) | st.sampled_from([b"\r", b"\n", b"x" * 200]), max_size=20)


@given(pieces)
def test_lines_are_the_same_however_the_bytes_come(parts: list[bytes]) -> None:
    whole, split = Lines(), Lines()
    together = list(whole.feed(b"".join(parts)))
    assert together == [line for part in parts for line in split.feed(part)]
    assert together == [
        line if len(line) <= LONGEST else NO_LINE for line in b"".join(parts).split(b"\r")[:-1]
    ]


def test_what_has_no_end_is_not_held() -> None:
    lines = Lines()
    assert list(lines.feed(b"@" * 10_000_000)) == []
    assert len(lines) <= LONGEST
    assert list(lines.feed(b"\r@READ\r")) == [NO_LINE, b"@READ"]


def test_a_line_begun_can_be_forgotten() -> None:
    lines = Lines()
    list(lines.feed(b"@STEP 240,1"))
    lines.clear()
    assert list(lines.feed(b"@READ\r")) == [b"@READ"]
