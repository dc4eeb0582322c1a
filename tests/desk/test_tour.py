"""The tour waits until one has done it, and keeps what is one's own."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.desk.sitting import Sitting
from trs80arm.desk.tour import STEPS, Tour


@pytest.fixture
def tour(sitting: Sitting) -> Tour:
    return touring(sitting)


def touring(sitting: Sitting) -> Tour:
    place = sitting.state / "tour.json"
    person = sitting.person
    return Tour(sitting.session, sitting.lesson, sitting.files, place, person, person.say)


def to(tour: Tour, number: int) -> None:
    """Go to a step by skipping those before it."""
    tour.begin()
    for _ in range(number):
        tour.skip()


def test_a_step_waits_until_it_is_done(sitting: Sitting, tour: Tour) -> None:
    tour.begin()
    tour.go_on()
    assert tour.step is STEPS[0]
    sitting.type("@SET")
    tour.go_on()
    assert tour.step is STEPS[1]


def test_whoever_skips_finds_what_the_next_step_needs(sitting: Sitting, tour: Tour) -> None:
    session = sitting.session
    to(tour, 4)
    session.rig.run_until_waiting(20)
    assert session.rig.state.held is not None
    tour.skip()
    tour.skip()
    assert session.path is not None
    assert session.path.stem == "table4"
    tour.back()
    assert tour.place == "6/13"


def test_a_program_of_ones_own_is_not_replaced(sitting: Sitting, tour: Tour) -> None:
    sitting.type("10 REM MINE")
    sitting.answer("stay")
    tour.begin()
    assert tour.step is None
    sitting.answer("go")
    to(tour, 6)
    assert sitting.session.path is None
    assert sitting.lines == [10]


def test_it_goes_on_another_day_where_it_was_left(sitting: Sitting, tour: Tour) -> None:
    to(tour, 8)
    tour.leave()
    again = touring(sitting)
    again.begin()
    assert again.step is STEPS[8]
    for _ in range(5):
        again.skip()
    assert again.step is None
    afresh = touring(sitting)
    afresh.begin()
    assert afresh.step is STEPS[0]


@pytest.mark.parametrize("content", ["", "[]", '{"step": 99}', '{"step": "a"}', "\x00", "[" * 9999])
def test_an_odd_file_begins_it_at_its_start(sitting: Sitting, tour: Tour, content: str) -> None:
    sitting.state.mkdir(exist_ok=True)
    (sitting.state / "tour.json").write_text(content)
    tour.begin()
    assert tour.step is STEPS[0]


def test_it_is_offered_once(sitting: Sitting, tour: Tour) -> None:
    tour.offer()
    assert tour.offered
    tour.decline()
    again = touring(sitting)
    again.offer()
    assert not tour.offered
    assert not again.offered


def test_without_its_bench_it_says_so(
    sitting: Sitting, tour: Tour, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("trs80arm.bundled.programs_folder", lambda: tmp_path)
    to(tour, 3)
    assert "The tour lacks something" in sitting.person.errors[0]


def test_what_is_said_fits_a_small_window() -> None:
    for step in STEPS:
        first, second = (line.replace("`", "") for line in step.words)
        assert len(f"12/13  {first}") <= 80
        assert len(second) + len("Ctrl+N: skip, back, leave") < 80
