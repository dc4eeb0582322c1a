"""How long the machine takes, held against the T-states that the ROM needed.

Virtual time is a count, so this is a computation like any other: nothing here depends on how fast
the computer is.
"""

from __future__ import annotations

from pathlib import Path
from statistics import median

import pytest

from tests.conformance import case, player
from tests.conformance.timing import LONG, Segment
from tests.conformance.told_times import ToldTimes

KEY_ROWS = 250
"""T-states by which the time of a single key may differ with its place in the matrix."""
CASES = list(case.load(Path(__file__).parent / "cases"))


@pytest.fixture(scope="module")
def segments(told_times: ToldTimes) -> list[Segment]:
    """Every segment of every case, with the machine's time."""
    known = told_times.known()

    def times(one: case.Case) -> list[int]:
        return known[one.id] if one.id in known else player.play_once(one).times

    return [
        Segment(one.id, one.group, str(expected["in"]), expected["t"], here)
        for one in CASES
        for expected, here in zip(one.expected["segments"], times(one), strict=False)
    ]


def test_times_told_by_another_process_are_those_of_the_machine(tmp_path: Path) -> None:
    here, there = ToldTimes(tmp_path, "here"), ToldTimes(tmp_path, "there")
    played = {one.id: player.play(one).times for one in CASES[:3]}
    for case_id, times in played.items():
        there.tell(case_id, times)
    with (tmp_path / "case-times-there.jsonl").open("a") as file:
        file.write('["half a li')
    assert here.known() == played == {one.id: player.play(one).times for one in CASES[:3]}


def test_the_median_segment_takes_as_long_as_on_the_rom(segments: list[Segment]) -> None:
    assert 0.95 <= median(segment.ratio for segment in segments) <= 1.05


def test_nine_long_segments_of_ten_are_close_to_the_rom(segments: list[Segment]) -> None:
    long = [segment for segment in segments if segment.rom > LONG]
    far = [segment for segment in long if not segment.is_close]
    assert len(long) > 300
    assert len(far) <= len(long) / 10, "\n".join(map(str, far))


def test_no_group_of_cases_is_far_off(segments: list[Segment]) -> None:
    groups: dict[str, list[float]] = {}
    for segment in segments:
        groups.setdefault(segment.group, []).append(segment.ratio)
    off = {group: median(r) for group, r in groups.items() if not 0.9 <= median(r) <= 1.1}
    assert not off


def test_a_byte_on_tape_takes_the_roms_time(segments: list[Segment]) -> None:
    """The refused CSAVE records 255 zeros and a sync byte and nothing else: 0.01 per cent."""
    leaders = [segment for segment in segments if segment.case == "tape-csave-no-name"]
    assert len(leaders) == 2
    assert all(abs(segment.ratio - 1) < 1e-4 for segment in leaders)
    recorded = [s for s in segments if s.entry in ('CSAVE "A"', "CLOAD?")]
    assert recorded
    assert all(abs(segment.ratio - 1) < 1e-3 for segment in recorded)


def test_every_way_of_changing_a_program_takes_as_long_as_on_the_rom(
    segments: list[Segment],
) -> None:
    editing = [segment for segment in segments if segment.group == "editing"]
    # A key taken alone comes so soon that the debounce of its row of the matrix counts.
    off = [one for one in editing if abs(one.here - one.rom) > max(0.05 * one.rom, KEY_ROWS)]
    assert len(editing) > 200
    assert not off, "\n".join(map(str, off))
