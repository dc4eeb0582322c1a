from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm.machine import cassette
from trs80arm.machine.cassette import (
    DataRecording,
    FileFormatError,
    ProgramRecording,
    SystemRecording,
)

numbers = st.integers(0, 65529)
bodies = st.binary(max_size=40).map(lambda body: body.replace(b"\0", b" "))
listings = st.dictionaries(numbers, bodies, max_size=8).map(lambda d: tuple(sorted(d.items())))
systems = st.builds(
    SystemRecording,
    st.text("ABC ", max_size=6).map(lambda name: name.ljust(6).encode()),
    st.lists(
        st.tuples(st.integers(0, 0xFFFF), st.binary(min_size=1, max_size=256)), max_size=3
    ).map(tuple),
    st.integers(0, 0xFFFF),
)


def test_a_saved_program_is_leader_mark_name_and_lines() -> None:
    content = cassette.encode_program(ord("A"), [(10, b"\x84")])
    assert content[:255] == bytes(255)
    assert content[255:260] == b"\xa5\xd3\xd3\xd3A"
    # Line 10 lies at 17129, the next would at 17135: case memory-peek-line-link.
    assert content[260:] == (17135).to_bytes(2, "little") + b"\x0a\0\x84\0" + b"\0\0"


@given(st.integers(0, 255), listings)
def test_a_program_comes_back_as_it_was_saved(
    name: int, lines: tuple[tuple[int, bytes], ...]
) -> None:
    content = cassette.encode_program(name, lines)
    assert cassette.parse(content) == [ProgramRecording(name, lines)]
    assert cassette.program_name(content) == name


@given(systems)
def test_machine_code_comes_back_as_it_was_saved(recording: SystemRecording) -> None:
    assert cassette.parse(cassette.encode_system(recording)) == [recording]


def test_a_cassette_holds_one_recording_after_the_other() -> None:
    content = (
        cassette.encode_program(65, [(10, b"A")])
        + cassette.encode_data(b" 1 ,HELLO\r")
        + cassette.encode_system(SystemRecording(b"CODE  ", ((0x7000, b"\xc9"),), 0x7000))
        + cassette.encode_program(66, [])
    )
    kinds = [type(recording) for recording in cassette.parse(content)]
    assert kinds == [ProgramRecording, DataRecording, SystemRecording, ProgramRecording]


def test_the_links_of_a_program_are_not_believed() -> None:
    lines = cassette.parse_lines(b"\xff\xff\x0a\0AB\0\x01\x01\x14\0C\0\0\0", 0)
    assert lines.lines == ((10, b"AB"), (20, b"C"))
    assert lines.fault is None


@pytest.mark.parametrize(
    ("content", "message", "offset"),
    [
        (b"", "no recording: no sync byte A5H at byte 0", 0),
        (b"\0\0\xa5\xd3\xd3\xd3", "the program breaks off at byte 6", 6),
        (b"\xa5\xd3\xd3\xd3A\xe9\x42\x0a\0PRINT", "line 10 has no end at byte 5", 5),
        (b"\xa5\xd3\xd3\xd3A\xe9\x42\xff\xffX\0\0\0", "65535 is no line number at byte 7", 7),
        (
            b"\xa5\xd3\xd3\xd3A\xe9\x42\x14\0X\0\xe9\x42\x0a\0X\0\0\0",
            "line 10 comes behind line 20 at byte 13",
            13,
        ),
        (b"\xa5\x55CODE  \x3c\x01\0\0\x05\x06", "a block of machine code has a wrong checksum", 8),
        (b"\xa5HELLO", "the data have no end at byte 1", 1),
    ],
)
def test_damage_is_told_with_its_place(content: bytes, message: str, offset: int) -> None:
    with pytest.raises(FileFormatError) as error:
        cassette.parse(content)
    assert str(error.value).startswith(message)
    assert error.value.offset == offset


def test_the_good_part_of_a_damaged_program_can_be_kept() -> None:
    content = cassette.encode_program(65, [(10, b"A"), (20, b"B"), (30, b"C")])[:-5]
    with pytest.raises(FileFormatError):
        cassette.parse(content)
    assert cassette.parse(content, keep_good=True) == [
        ProgramRecording(65, ((10, b"A"), (20, b"B")))
    ]


@given(st.binary(max_size=300), st.booleans())
def test_noise_never_raises_anything_else(content: bytes, keep_good: bool) -> None:
    fault = None
    try:
        cassette.parse(b"\xa5" + content, keep_good=keep_good)
    except FileFormatError as error:
        fault = str(error)
    assert fault is None or ("\n" not in fault and not keep_good)


@given(listings, st.data())
def test_what_is_good_of_a_cassette_with_a_wrong_byte_is_a_whole_program(
    lines: tuple[tuple[int, bytes], ...], data: st.DataObject
) -> None:
    content = bytearray(cassette.encode_program(65, lines))
    content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    for found in cassette.parse(bytes(content), keep_good=True):
        if isinstance(found, ProgramRecording):
            again = cassette.encode_program(found.name, found.lines)
            assert cassette.parse(again) == [found]
