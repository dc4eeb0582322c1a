"""The interface card: addresses, latches, the input nibble, the two jumpers."""

from __future__ import annotations

import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.machine.bench_top import Analyser, ClosingHand
from trs80arm.machine.card import GRIP_CLOSED, Card, CardSettings, Jumper, Latch
from trs80arm.machine.clock import Clock
from trs80arm.pulses import Columns


class Sensors:
    """A plug whose input nibble is given."""

    def __init__(self, nibble: int) -> None:
        self.nibble = nibble

    def follow(self, burst, stop=None) -> int:
        return len(burst)

    def inputs(self, time: int) -> int:
        return self.nibble


def test_eight_ports_from_98h_select_the_latches_in_joint_order():
    card = Card(Clock())
    for place in range(8):
        card.write(0x98 + place, place + 1)
    assert card.latches == [1, 2, 3, 4, 5, 6, 7]
    assert [port for port in range(256) if card.owns(port)] == list(range(0x98, 0xA0))


def test_a_latch_keeps_its_nibble_until_the_next_write():
    card = Card(Clock())
    card.write(0x98, 0xF5)
    card.write(0x99, 0x0A)
    assert card.latches[:2] == [0x5, 0xA]
    card.write(0x98, 0x04)
    assert card.latches[:2] == [0x4, 0xA]


def test_a_single_out_is_a_burst_of_one_at_the_time_of_the_clock():
    clock, analyser = Clock(), Analyser()
    card = Card(clock)
    card.observers.append(analyser)
    clock.now = 1234
    card.write(0x9E, 0x0C)
    assert analyser.writes == [(1234, Latch.AUXILIARY, 0xC)]


def test_the_input_nibble_is_read_at_every_port_below_four_ones():
    card = Card(Clock(), plug=Sensors(0b0110))
    assert [card.read(port) for port in range(0x98, 0xA0)] == [0xF6] * 8


def test_nothing_plugged_reads_as_an_open_switch():
    assert Card(Clock()).read(0x98) == 0xFF


def test_the_parallel_jumper_takes_the_latch_from_the_high_nibble():
    card = Card(Clock(), CardSettings(jumper=Jumper.PARALLEL, base=4), Sensors(0b1110))
    assert [port for port in range(256) if card.owns(port)] == [4]
    for latch in range(16):
        card.write(4, latch << 4 | (9 - latch) & 15)
    assert card.latches == [9, 8, 7, 6, 5, 4, 3]
    assert card.read(4) == 0xFE


def test_another_port_order_and_another_base():
    order = (None, *reversed(Latch))
    card = Card(Clock(), CardSettings(base=0xB8, order=order))
    card.write(0xB8, 1)
    card.write(0xB9, 2)
    card.write(0xBF, 3)
    assert card.latches == [3, 0, 0, 0, 0, 0, 2]


def test_another_order_of_coil_bits_reaches_the_same_coils():
    card = Card(Clock(), CardSettings(coil_bits=(0, 1, 2, 3)))
    card.write(0x98, 0b0001)
    assert card.latches[0] == 0b1000


@given(st.permutations([0, 1, 2, 3]), st.integers(0, 15))
def test_coil_bits_translate_both_ways(bits, nibble):
    settings = CardSettings(coil_bits=tuple(bits))
    assert settings.coils(settings.data(nibble)) == nibble
    assert settings.data(settings.coils(nibble)) == nibble


@pytest.mark.parametrize(
    ("settings", "plug", "read"),
    [
        (CardSettings(), 0b1110, 0b1110),
        (CardSettings(switch_closed=1), 0b1110, 0b1111),
        (CardSettings(switch_bit=2), 0b1110, 0b1011),
        (CardSettings(switch_bit=2), 0b1011, 0b1110),
        (CardSettings(switch_bit=3, switch_closed=1), 0b0110, 0b1110),
    ],
)
def test_the_grip_switch_can_be_wired_to_any_bit_and_level(settings, plug, read):
    assert Card(Clock(), settings, Sensors(plug)).read(0x98) == 0xF0 | read


@pytest.mark.parametrize(
    "wrong",
    [
        {"base": 0xF8},
        {"base": -1},
        {"order": tuple(Latch)},
        {"coil_bits": (0, 1, 2, 2)},
        {"switch_bit": 4},
        {"switch_closed": 2},
    ],
)
def test_wiring_that_cannot_be_is_refused(wrong):
    with pytest.raises(ValueError):
        CardSettings(**wrong)


def test_a_burst_stops_with_the_write_that_closes_the_switch():
    card = Card(Clock(), plug=ClosingHand(3))
    done = card.burst(Columns([1, 2, 3, 4], [5, 5, 5, 5], [1, 9, 8, 10]), GRIP_CLOSED)
    assert done == 3
    assert card.latches[Latch.HAND] == 8


@given(st.integers(0, 6), st.lists(st.integers(1, 3), min_size=1, max_size=6))
def test_looking_at_each_step_changes_nothing(closes_after, sizes):
    """The same writes are done, with the same end, when the burst is cut at every instant."""
    times = [instant for instant, size in enumerate(sizes) for _ in range(size)]
    latches = [5 if place % 2 == 0 else 0 for place in range(len(times))]
    nibbles = [place % 16 for place in range(len(times))]
    results = []
    for each_step in (False, True):
        card, analyser = Card(Clock(), plug=ClosingHand(closes_after)), Analyser(each_step)
        card.observers.append(analyser)
        done = card.burst(Columns(times, latches, nibbles), GRIP_CLOSED)
        results.append((done, card.latches, analyser.writes))
        if each_step:
            assert sum(analyser.bursts) == done
            assert len(analyser.bursts) == len({time for time, _, _ in analyser.writes})
    assert results[0] == results[1]


def test_a_snapshot_of_the_card_leaves_the_analysers_behind():
    card = Card(Clock())
    card.observers.append(Analyser())
    card.write(0x9D, 6)
    copy = pickle.loads(pickle.dumps(card))
    assert copy.latches[Latch.HAND] == 6
    assert copy.observers == []
    assert len(card.observers) == 1
