"""Every panel has its place in a terminal of any size, and none lies on another."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from textual.geometry import Region

from trs80arm.ui.layout import ARM, FURNITURE, KEYBOARD, NUMBERS, bottoms, plan
from trs80arm.ui.panels.registry import PANELS, groups

GROUPS = groups(PANELS)


@settings(max_examples=300, deadline=None)
@given(st.integers(64, 250), st.integers(18, 90), st.integers(0, 9))
def test_panels_lie_inside_and_never_on_each_other(width: int, height: int, turn: int) -> None:
    choices = bottoms(GROUPS, width, height)
    places = list(plan(GROUPS, width, height, choices[turn % len(choices)]).values())
    room = Region(0, 0, width, height - FURNITURE)
    for number, place in enumerate(places):
        assert room.contains_region(place)
        assert place.area > 0
        assert not any(place.overlaps(other) for other in places[number + 1 :])


@settings(max_examples=200, deadline=None)
@given(st.integers(64, 250), st.integers(18, 90), st.integers(0, 9))
def test_the_tube_is_always_whole(width: int, height: int, turn: int) -> None:
    choices = bottoms(GROUPS, width, height)
    tube = plan(GROUPS, width, height, choices[turn % len(choices)])["tube"]
    assert tube.width >= 64
    assert tube.height >= 16


@pytest.mark.parametrize(("width", "height"), [(63, 40), (120, 17), (1, 1)])
def test_too_small_is_too_small(width: int, height: int) -> None:
    assert plan(GROUPS, width, height, ARM) == {}


def test_a_large_terminal_shows_everything() -> None:
    assert set(plan(GROUPS, 120, 40, ARM)) == {
        "tube",
        "side",
        "top",
        "registers",
        "pose",
        "coils",
        "events",
    }
    assert "matrix" in plan(GROUPS, 120, 40, KEYBOARD)


def test_80_columns_have_registers_beside_the_tube_and_a_switched_panel() -> None:
    shown = [
        set(plan(GROUPS, 80, 24, bottom)) - {"tube", "registers", "pose"}
        for bottom in bottoms(GROUPS, 80, 24)
    ]
    assert shown == [{"side", "top"}, {"space"}, {"coils"}, {"scope"}, {"events"}, {"matrix"}]
    assert {"registers", "pose"} <= set(plan(GROUPS, 80, 24, ARM))


def test_64_columns_can_switch_to_the_registers() -> None:
    assert NUMBERS in bottoms(GROUPS, 64, 24)
    assert "registers" in plan(GROUPS, 64, 24, NUMBERS)


def test_a_zoomed_panel_has_it_all() -> None:
    assert plan(GROUPS, 80, 24, ARM, "events") == {"events": Region(0, 0, 80, 22)}
    assert set(plan(GROUPS, 80, 24, ARM, "arm")) == {"side", "top"}
