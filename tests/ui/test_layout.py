"""Every panel has its place in a terminal of any size, and none lies on another."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from textual.geometry import Region

from trs80arm.ui.layout import FURNITURE, Bottom, bottoms, plan


@settings(max_examples=300, deadline=None)
@given(st.integers(64, 250), st.integers(18, 90), st.sampled_from(list(Bottom)))
def test_panels_lie_inside_and_never_on_each_other(width: int, height: int, bottom: Bottom) -> None:
    places = list(plan(width, height, bottom).values())
    room = Region(0, 0, width, height - FURNITURE)
    for number, place in enumerate(places):
        assert room.contains_region(place)
        assert place.area > 0
        assert not any(place.overlaps(other) for other in places[number + 1 :])


@settings(max_examples=200, deadline=None)
@given(st.integers(64, 250), st.integers(18, 90), st.sampled_from(list(Bottom)))
def test_the_tube_is_always_whole(width: int, height: int, bottom: Bottom) -> None:
    tube = plan(width, height, bottom)["tube"]
    assert tube.width >= 64
    assert tube.height >= 16


@pytest.mark.parametrize(("width", "height"), [(63, 40), (120, 17), (1, 1)])
def test_too_small_is_too_small(width: int, height: int) -> None:
    assert plan(width, height, Bottom.ARM) == {}


def test_a_large_terminal_shows_everything() -> None:
    assert set(plan(120, 40, Bottom.ARM)) == {
        "tube",
        "side",
        "top",
        "registers",
        "pose",
        "coils",
        "events",
    }
    assert "matrix" in plan(120, 40, Bottom.KEYBOARD)


def test_80_columns_have_registers_beside_the_tube_and_a_switched_panel() -> None:
    shown = [
        set(plan(80, 24, bottom)) - {"tube", "registers", "pose"} for bottom in bottoms(80, 24)
    ]
    assert shown == [{"side", "top"}, {"coils"}, {"events"}, {"matrix"}]
    assert {"registers", "pose"} <= set(plan(80, 24, Bottom.ARM))


def test_64_columns_can_switch_to_the_registers() -> None:
    assert Bottom.NUMBERS in bottoms(64, 24)
    assert "registers" in plan(64, 24, Bottom.NUMBERS)


def test_a_zoomed_panel_has_it_all() -> None:
    assert plan(80, 24, Bottom.ARM, "events") == {"events": Region(0, 0, 80, 22)}
    assert set(plan(80, 24, Bottom.ARM, "arm")) == {"side", "top"}
