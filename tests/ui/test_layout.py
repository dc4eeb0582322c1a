"""Every panel has its place in a terminal of any size, and none lies on another."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from textual.geometry import Region

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.rows import text_of
from trs80arm.ui.layout import (
    ARM,
    FURNITURE,
    KEYBOARD,
    NUMBERS,
    SCOPE,
    SPACE,
    TUBE_LINES,
    Arrangement,
    Lead,
    arrangement,
    bottoms,
    plan,
)
from trs80arm.ui.panels.pose import PosePanel
from trs80arm.ui.panels.registry import PANELS, groups

GROUPS = groups(PANELS)


@settings(max_examples=300, deadline=None)
@given(st.integers(40, 250), st.integers(12, 90), st.integers(0, 9), st.sampled_from(Lead))
def test_panels_lie_inside_and_never_on_each_other(
    width: int, height: int, turn: int, lead: Lead
) -> None:
    choices = bottoms(GROUPS, width, height)
    bottom = choices[turn % len(choices)]
    places = list(plan(GROUPS, width, height, bottom, lead=lead).values())
    room = Region(0, 0, width, height - FURNITURE)
    for number, place in enumerate(places):
        assert room.contains_region(place)
        assert place.area > 0
        assert not any(place.overlaps(other) for other in places[number + 1 :])


@settings(max_examples=200, deadline=None)
@given(st.integers(64, 250), st.integers(18, 90), st.integers(0, 9))
def test_the_tube_is_whole_while_it_leads(width: int, height: int, turn: int) -> None:
    choices = bottoms(GROUPS, width, height)
    tube = plan(GROUPS, width, height, choices[turn % len(choices)])["tube"]
    assert tube.width >= 64
    assert tube.height >= 16


@pytest.mark.parametrize(("width", "height"), [(39, 40), (120, 11), (1, 1)])
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


@pytest.mark.parametrize("size", [(100, 30), (120, 40), (200, 60)])
def test_no_number_of_the_pose_is_left_out_whatever_is_switched_in(size: tuple[int, int]) -> None:
    plans = [plan(GROUPS, *size, bottom) for bottom in bottoms(GROUPS, *size)]
    regions = [places["pose"] for places in plans if "pose" in places]
    assert regions
    for region in regions:
        rows = PosePanel().draw(Readings(), region.width - 2, region.height - 2)
        seen = " ".join(text_of(row) for row in rows[: region.height - 2])
        assert all(name in seen for name in ("roll", "hand", "force", "T1", "T2", "T3"))


def test_a_huge_terminal_shows_memory_and_paper_too() -> None:
    assert {"listing", "variables", "paper"} < set(plan(GROUPS, 200, 60, ARM))


@pytest.mark.parametrize(
    ("size", "shape"),
    [
        ((80, 24), Arrangement.COMPACT),
        ((100, 30), Arrangement.MIDDLE),
        ((120, 40), Arrangement.LARGE),
        ((200, 60), Arrangement.HUGE),
        ((200, 24), Arrangement.WIDE),
        ((60, 60), Arrangement.TALL),
    ],
)
def test_each_shape_of_window_has_its_arrangement(
    size: tuple[int, int], shape: Arrangement
) -> None:
    assert arrangement(*size) is shape


@pytest.mark.parametrize("size", [(100, 30), (120, 40), (200, 60), (200, 24), (60, 60), (100, 50)])
def test_everything_that_is_seen_fills_the_window(size: tuple[int, int]) -> None:
    places = plan(GROUPS, *size, ARM).values()
    assert sum(place.area for place in places) == size[0] * (size[1] - FURNITURE)


@pytest.mark.parametrize("size", [(80, 24), (100, 30)])
def test_where_the_arm_leads_it_has_most_of_the_room(size: tuple[int, int]) -> None:
    behind, ahead = (plan(GROUPS, *size, ARM, lead=lead) for lead in (Lead.TUBE, Lead.ARM))
    assert ahead["side"].area > 1.8 * behind["side"].area
    assert ahead["tube"].height >= TUBE_LINES
    assert ahead["tube"].width == behind["tube"].width
    assert "registers" in ahead


@pytest.mark.parametrize("group", [SPACE, SCOPE])
def test_a_picture_that_is_asked_for_is_never_a_few_rows(group: str) -> None:
    for size in [(80, 24), (100, 30), (120, 40)]:
        assert plan(GROUPS, *size, group, lead=Lead.ARM)[group].height >= 14


def test_what_is_switched_in_is_seen_whatever_leads() -> None:
    assert "matrix" in plan(GROUPS, 80, 24, KEYBOARD, lead=Lead.ARM)


def test_80_columns_have_registers_beside_the_tube_and_a_switched_panel() -> None:
    shown = [
        set(plan(GROUPS, 80, 24, bottom)) - {"tube", "registers", "pose"}
        for bottom in bottoms(GROUPS, 80, 24)
    ]
    switched = [name for group, names in GROUPS.items() if group != ARM for name in names]
    alone = [{name} for name in switched if name not in {"tube", "registers", "pose"}]
    assert shown == [{"side", "top"}, *alone]
    assert {"registers", "pose"} <= set(plan(GROUPS, 80, 24, ARM))


def test_64_columns_can_switch_to_the_registers() -> None:
    assert NUMBERS in bottoms(GROUPS, 64, 24)
    assert "registers" in plan(GROUPS, 64, 24, NUMBERS)


def test_a_zoomed_panel_has_it_all() -> None:
    assert plan(GROUPS, 80, 24, ARM, "events") == {"events": Region(0, 0, 80, 22)}
    assert set(plan(GROUPS, 80, 24, ARM, "arm")) == {"side", "top"}
