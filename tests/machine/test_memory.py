from __future__ import annotations

import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm.machine.memory import Memory


class Shouting:
    """A region that answers 7 and remembers what it was told."""

    def __init__(self) -> None:
        self.told: list[tuple[int, int]] = []

    def peek(self, address: int) -> int:
        return 7

    def poke(self, address: int, value: int) -> None:
        self.told.append((address, value))


def test_a_byte_stored_in_ram_stays_there() -> None:
    memory = Memory(16)
    memory.poke(0x4000, 1)
    memory.poke(0x7FFF, 255)
    assert (memory.peek(0x4000), memory.peek(0x7FFF)) == (1, 255)


@pytest.mark.parametrize(("kib", "top"), [(4, 0x5000), (16, 0x8000), (32, 0xC000), (48, 0x10000)])
def test_ram_ends_at_the_top_of_its_size(kib: int, top: int) -> None:
    assert Memory(kib).top == top


def test_other_sizes_of_ram_were_not_sold() -> None:
    with pytest.raises(ValueError, match="not 64"):
        Memory(64)


@given(st.integers(0, 0xFFFF), st.integers(0, 255))
def test_only_ram_keeps_what_is_stored(address: int, value: int) -> None:
    memory = Memory(16)
    memory.poke(address, value)
    assert memory.peek(address) == (value if 0x4000 <= address < 0x8000 else 255)


@given(
    st.integers(0, 0xFFFF),
    st.integers(1, 0x900),
    st.integers(-1, 0x901),
)
def test_a_region_answers_for_its_addresses_and_no_others(
    start: int, length: int, offset: int
) -> None:
    stop = min(start + length, 0x10000)
    memory = Memory(48)
    region = Shouting()
    memory.attach(start, stop, region)
    address = min(max(start + offset, 0), 0xFFFF)
    before = memory.peek(address)
    memory.poke(address, 5)
    if start <= address < stop:
        assert before == 7
        assert region.told == [(address, 5)]
    else:
        assert memory.peek(address) == (5 if address >= 0x4000 else 255)
        assert not region.told


def test_a_later_region_takes_addresses_from_an_earlier_one() -> None:
    memory = Memory(16)
    first, second = Shouting(), Shouting()
    memory.attach(0x4010, 0x4020, first)
    memory.attach(0x4018, 0x401A, second)
    for address in range(0x400F, 0x4021):
        memory.poke(address, 1)
    assert [address for address, _ in second.told] == [0x4018, 0x4019]
    assert len(first.told) == 14


def test_a_pickled_memory_still_guards_its_rom() -> None:
    memory = Memory(16)
    memory.poke(0x5000, 42)
    copy = pickle.loads(pickle.dumps(memory))
    copy.poke(0, 1)
    copy.poke(0x9000, 1)
    copy.poke(0x5001, 43)
    assert (copy.peek(0), copy.peek(0x9000), copy.peek(0x5000), copy.peek(0x5001)) == (
        255,
        255,
        42,
        43,
    )


def test_memory_cannot_grow_or_shrink() -> None:
    memory = Memory(48)
    for content in (b"", b"AB", b"ABCDE"):
        with pytest.raises(BufferError):
            memory.ram[0x5000:0x5003] = content
    with pytest.raises(BufferError):
        del memory.ram[0x5000]
    with pytest.raises(BufferError):
        memory.ram.append(1)
    assert len(memory.ram) == 65536
    copy = pickle.loads(pickle.dumps(memory))
    with pytest.raises(BufferError):
        copy.ram.clear()


def test_reading_and_writing_go_around_the_end_of_memory() -> None:
    memory = Memory(48)
    memory.write(0xFFFE, b"ABCD")
    assert memory.read(0xFFFE, 4) == b"AB\xff\xff", "there is ROM at 0"
    memory.write(0x5000, b"XYZ")
    assert memory.read(0x5001, 2) == b"YZ"
    small = Memory(4)
    small.write(small.top - 1, b"AB")
    assert small.read(small.top - 1, 2) == b"A\xff"
