"""The tapes are what the source says, and fit the machines that they are for."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path

import pytest

from tests.machine.armbasic_z80.assembled import PAGE, assembled, blocks, driver, maker
from trs80arm.machine import cassette

SIZES = (16, 32, 48)
RAM_START = 0x4000


@pytest.mark.parametrize("size", SIZES)
def test_a_tape_is_what_its_source_assembles_to(size: int) -> None:
    kept = maker().tape_file(size).read_bytes()
    assert kept == maker().tape(size), "run docs/make_armbasic_z80.py"


@pytest.mark.parametrize("size", SIZES)
def test_a_tape_has_one_recording_for_system_without_gaps(size: int) -> None:
    (recording,) = cassette.parse(maker().tape_file(size).read_bytes())
    assert isinstance(recording, cassette.SystemRecording)
    assert recording.name == b"ARM%d " % size
    address = recording.entry
    for begins, block in recording.blocks:
        assert begins == address
        address += len(block)
    assert b"".join(block for _, block in recording.blocks) == driver(size).image


@pytest.mark.parametrize("size", SIZES)
def test_a_driver_ends_with_the_memory_of_its_machine(size: int) -> None:
    done = driver(size)
    free = RAM_START + size * 1024 - (done.origin + len(done.image))
    assert 0 <= free < 32
    assert done.origin % 32 == 0


def test_the_sizes_differ_in_addresses_only() -> None:
    images = [driver(size).image for size in SIZES]
    places = [at for at, values in enumerate(zip(*images, strict=True)) if len(set(values)) > 1]
    assert len(places) > 100
    for lower, higher in pairwise(images):
        assert {(higher[at] - lower[at]) % 256 for at in places} == {0x40}


def test_the_listing_is_of_the_source() -> None:
    assert maker().page() == PAGE.read_text(encoding="utf-8"), "run docs/make_armbasic_z80.py"


def test_the_listing_shows_every_byte_but_the_repeated_ones() -> None:
    done = driver()
    shown = 0
    for line in maker().listing(16):
        code = re.match(r"([0-9A-F]{4}) ((?:[0-9A-F]{2} ?){1,4})(?: |$)", line)
        if code:
            at, values = int(code[1], 16) - done.origin, bytes.fromhex(code[2])
            assert done.image[at : at + len(values)] == values
            shown += len(values)
    names = done.symbols
    repeated = 5 * (names["R1"] - names["R0"]) + 5 * (names["SLOT0"] - 11 - names["PULSE"]) // 6
    assert shown == len(done.image) - repeated


@pytest.mark.parametrize(
    ("offset", "name"),
    [
        *[(0, "INIT"), (3, "MOVE"), (6, "CLOSE"), (9, "MANUAL"), (12, "OFF"), (15, "READ")],
        *[(18, "PACE"), (21, "PULSE"), (24, "WAIT"), (27, "UMOVE"), (30, "UCLOSE")],
        *[(33, "UMANUA"), (36, "UREAD")],
    ],
)
def test_an_entry_is_where_the_page_says(offset: int, name: str) -> None:
    done = driver()
    jump = done.image[offset : offset + 3]
    assert jump == b"\xc3" + done.symbols[name].to_bytes(2, "little")
    told = f"| +{offset} | {done.origin + offset} | "
    assert told in PAGE.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("offset", "name"), [(39, "BASE"), (40, "GRIP"), (41, "SHUT"), (42, "WAYS"), (64, "RING")]
)
def test_what_may_be_changed_is_where_the_page_says(offset: int, name: str) -> None:
    assert driver().symbols[name] == driver().origin + offset
    assert f"+{offset}" in PAGE.read_text(encoding="utf-8")


def test_the_page_pokes_the_addresses_that_it_names() -> None:
    rows = re.findall(r"\| \+\d+ \| (\d+) \| (\d+), (\d+) \|", PAGE.read_text(encoding="utf-8"))
    assert len(rows) == 5
    assert all(int(address) == int(low) + 256 * int(high) for address, low, high in rows)


def test_the_page_tells_sizes_and_places() -> None:
    text = PAGE.read_text(encoding="utf-8")
    for size in SIZES:
        begins, length = driver(size).origin, len(driver(size).image)
        assert f"| {begins} | {begins} to {begins + length - 1} |" in text
    assert f"has {len(driver().image):,} bytes" in text


def test_the_pages_own_program_is_its_data(tmp_path: Path) -> None:
    (source,), (_, basic) = blocks("z80"), blocks("usr")
    data = [int(value) for row in re.findall(r"DATA (.*)", basic) for value in row.split(",")]
    assert assembled(source, tmp_path) == bytes(data)
    assert f"31100 TO {31100 + len(data) - 1}" in basic
