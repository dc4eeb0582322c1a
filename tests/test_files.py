from __future__ import annotations

import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm import converting, files
from trs80arm.basic.cruncher import crunch
from trs80arm.files import FileFormatError, Kind
from trs80arm.machine import cassette

PROGRAMS = sorted((Path(__file__).parent.parent / "programs").glob("*.bas"))

statements = st.sampled_from(
    [
        'PRINT "HELLO \x84\xbf"',
        "A=A+1:GOTO 10",
        "IF A=1 THEN 20 ELSE PRINT:ELSE",
        "REM any text \x81, \"quoted'",
        "X=5'remark",
        'DATA one, TWO,"three:"',
        "@STEP D,J1,J2:@READ A",
        '  PRINT"open quote',
        "FOR I=1 TO 3\n:NEXT",
    ]
)
listings = st.dictionaries(
    st.integers(0, 65529),
    statements.map(lambda text: crunch(text.encode("latin-1")).text),
    max_size=6,
).map(lambda lines: sorted(lines.items()))
any_lines = st.dictionaries(
    st.integers(0, 65529),
    st.binary(max_size=20).map(lambda body: body.replace(b"\0", b"")),
    max_size=5,
).map(lambda lines: sorted(lines.items()))


def text(lines: list[tuple[int, bytes]]) -> str:
    return files.encode_program(lines, Kind.TEXT).decode()


@given(listings, st.sampled_from(Kind))
def test_a_program_comes_back_from_every_kind_of_file(
    lines: list[tuple[int, bytes]], kind: Kind
) -> None:
    data = files.encode_program(lines, kind)
    assert files.parse_program(data) == lines
    assert not lines or files.kind_of(data) is kind


@given(any_lines)
def test_any_bytes_come_back_or_text_refuses_them(lines: list[tuple[int, bytes]]) -> None:
    for kind in Kind:
        try:
            data = files.encode_program(lines, kind)
        except FileFormatError:
            assert kind is Kind.TEXT
        else:
            assert files.parse_program(data) == lines


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.name)
def test_the_programs_that_come_along_are_listings_as_list_would_print_them(path: Path) -> None:
    assert files.encode_program(files.load_program(path), Kind.TEXT) == path.read_bytes()


@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_text_may_have_any_line_ends(line_end: str) -> None:
    data = line_end.join(["10 print 5", "", "20 goto 10", ""]).encode()
    assert text(files.parse_program(data)) == "10 PRINT 5\n20 GOTO 10\n"


def test_text_may_come_from_a_word_processor() -> None:
    data = "\ufeff20 PRINT “HI”\n10 A=2↑3\n\x1a\x1a".encode()
    assert text(files.parse_program(data)) == '10 A=2[3\n20 PRINT "HI"\n'


def test_one_byte_a_character_is_read_too() -> None:
    assert files.parse_program(b'10 PRINT "\xbf\x80"\n') == [(10, b'\xb2 "\xbf\x80"')]


def test_a_line_feed_belongs_to_the_line_where_lines_end_in_cr() -> None:
    lines = files.parse_program(b"10 PRINT 1\n:PRINT 2\r20 END\r")
    assert [number for number, _ in lines] == [10, 20]
    assert files.encode_program(lines, Kind.TEXT) == b"10 PRINT 1\n:PRINT 2\r20 END\r"


def test_lines_of_a_text_count_as_if_typed() -> None:
    data = b"30 END\n10 A=1\n10 A=2\n20 B=1\n20\n"
    assert text(files.parse_program(data)) == "10 A=2\n30 END\n"


def test_graphics_in_strings_and_remarks_are_not_taken_for_words() -> None:
    lines = [(10, b'\xb2"\x81\x95"'), (20, b"\x93\x81"), (30, b":\x93\xfb\x81\x95")]
    assert files.parse_program(files.encode_program(lines, Kind.TEXT)) == lines


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"10 A=1\nHELLO\n", "line 2 has no line number at byte 7"),
        (b"65530 A=1\n", "line 1 has a number above 65529 at byte 0"),
        ("10 é\n20 ☺\n".encode(), "line 2 has a sign that the machine lacks, '☺' at byte 6"),
        (b"10 A=1\n\0\0\0", "neither text nor a crunched program nor a cassette: a zero at byte 7"),
        (b"\xff\xe9\x42\x0a\0\xb2", "line 10 has no end at byte 1"),
        (b"\xff", "the program breaks off at byte 1"),
        (bytes(256) + b"\xa5HELLO\r", "no BASIC program on the cassette, only data"),
        (
            cassette.encode_system(cassette.SystemRecording(b"ALIEN ", ((1, b"2"),), 1)),
            "no BASIC program on the cassette, only machine code, 'ALIEN'",
        ),
    ],
)
def test_a_bad_file_is_told_in_one_clear_line(data: bytes, message: str) -> None:
    with pytest.raises(FileFormatError) as error:
        files.parse_program(data)
    assert str(error.value) == message


def test_the_line_names_the_file(tmp_path: Path) -> None:
    path = tmp_path / "bad.bas"
    path.write_bytes(b"HELLO")
    with pytest.raises(FileFormatError) as error:
        files.load_program(path)
    assert str(error.value) == f"{path}: line 1 has no line number at byte 0"
    assert error.value.offset == 0


@pytest.mark.parametrize("kind", Kind)
def test_what_is_good_of_a_damaged_file_can_be_kept(kind: Kind) -> None:
    lines = [(10, b"A"), (20, b"B"), (30, b"C")]
    data = files.encode_program(lines, kind)
    damaged = data.replace(b"30 C", b"\xe2\x98\xba C") if kind is Kind.TEXT else data[:-5]
    with pytest.raises(FileFormatError):
        files.parse_program(damaged)
    assert files.parse_program(damaged, keep_good=True) == lines[:2]


def test_good_lines_of_a_text_with_zeros_can_be_kept() -> None:
    damaged = b"10 A=1\n20 B\0=2\n30 C=3\n\0\0"
    with pytest.raises(FileFormatError, match="a zero at byte 11"):
        files.parse_program(damaged)
    assert files.parse_program(damaged, keep_good=True) == files.parse_program(b"10 A=1\n30 C=3\n")


def test_of_a_file_that_is_no_program_at_all_nothing_is_kept() -> None:
    with pytest.raises(FileFormatError, match="a zero at byte 6"):
        files.parse_program(b"\x7fELF\x02\x01\0\0\n", keep_good=True)


def test_a_cassettes_first_program_is_the_one_that_loads() -> None:
    data = (
        cassette.encode_data(b"5\r")
        + cassette.encode_program(66, [(10, b"B")])
        + b"\x7f\x00\xa5 trailing noise"
    )
    assert files.parse_program(data) == [(10, b"B")]


@given(st.binary(max_size=200), st.sampled_from([b"", b"\xff", b"\0\xa5", b"\0\xa5\xd3\xd3\xd3A"]))
def test_noise_is_a_program_or_a_file_format_error(noise: bytes, head: bytes) -> None:
    for keep_good in (False, True):
        try:
            lines = files.parse_program(head + noise, keep_good=keep_good)
        except FileFormatError as error:
            message = str(error)
        else:
            message = ""
            numbers = [number for number, _ in lines]
            assert numbers == sorted(set(numbers))
        assert "\n" not in message


@given(listings, st.sampled_from([Kind.CRUNCHED, Kind.CASSETTE]), st.data())
def test_a_damaged_byte_raises_nothing_else(
    lines: list[tuple[int, bytes]], kind: Kind, data: st.DataObject
) -> None:
    content = bytearray(files.encode_program(lines, kind))
    content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    offset = None
    try:
        files.parse_program(bytes(content))
    except FileFormatError as error:
        offset = error.offset
    assert offset is None or 0 <= offset <= len(content)


def test_a_save_takes_the_kind_of_the_suffix(tmp_path: Path) -> None:
    for name, kind in [("a.txt", Kind.TEXT), ("a.bas", Kind.CRUNCHED), ("A.CAS", Kind.CASSETTE)]:
        files.save_program(tmp_path / name, [(10, b"A")])
        assert files.kind_of((tmp_path / name).read_bytes()) is kind


def test_a_bas_file_that_is_text_stays_text(tmp_path: Path) -> None:
    path = tmp_path / "a.bas"
    path.write_text("10 PRINT 1\n")
    files.save_program(path, [(20, b"\xb2 2")])
    assert path.read_text() == "20 PRINT 2\n"


def test_a_program_on_a_cassette_is_named_after_its_file(tmp_path: Path) -> None:
    files.save_program(tmp_path / "_blocks.cas", [(10, b"A")])
    assert cassette.program_name((tmp_path / "_blocks.cas").read_bytes()) == ord("B")


def test_a_save_that_text_refuses_leaves_the_old_file(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_text("10 OLD\n")
    with pytest.raises(FileFormatError, match="line 10 cannot be written as text"):
        files.save_program(path, [(10, b"A\rB")])
    assert path.read_text() == "10 OLD\n"
    assert os.listdir(tmp_path) == ["a.txt"]


def test_convert_writes_the_kind_of_the_target(tmp_path: Path) -> None:
    source, target = tmp_path / "a.txt", tmp_path / "a.bas"
    source.write_text("10 print 1\n20 end\n")
    target.write_text("text that was there before")
    assert converting.convert(source, target).words == "2 lines"
    assert files.kind_of(target.read_bytes()) is Kind.CRUNCHED
    converting.convert(target, tmp_path / "b.txt")
    assert (tmp_path / "b.txt").read_text() == "10 PRINT 1\n20 END\n"


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
def test_a_listing_in_utf_16_is_told_as_what_it_is(encoding: str) -> None:
    # One of its marks is also that of a crunched program.
    with pytest.raises(FileFormatError, match="text in UTF-16"):
        files.parse_program('\ufeff10 PRINT "HELLO"\r\n'.encode(encoding))
