"""Solid drawings are in golden/solid-*.txt, one for each style and view: look at them."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from tests.drawing import samples
from tests.goldens import check_golden
from trs80arm.arm.shapes import upright
from trs80arm.drawing.arm_solids import LEFT_FINGER, RIGHT_FINGER
from trs80arm.drawing.picture import FROM_ABOVE, FROM_THE_SIDE, IN_SPACE, Picture, Subject
from trs80arm.drawing.readings import Kind, Readings, Thing
from trs80arm.drawing.rows import Ink, Paint, Row, text_of
from trs80arm.drawing.scene import Extras
from trs80arm.drawing.studio import Orbit, take
from trs80arm.drawing.style_blocks import HALVES, SEXTANTS
from trs80arm.drawing.viewport import Viewport
from trs80arm.options import ArmStyle

VIEWS = {"side": FROM_THE_SIDE, "top": FROM_ABOVE, "space": IN_SPACE}
SOLID = [style for style in ArmStyle if style not in (ArmStyle.OUTLINE, ArmStyle.PIXELS)]


def picture(subject: Subject, style: ArmStyle = ArmStyle.ASCII) -> Picture:
    drawn = Picture(subject)
    drawn.style = style
    return drawn


def inks(rows: list[Row]) -> set[Ink]:
    """Every ink that some character of the rows has."""
    return {
        ink.ink if isinstance(ink, Paint) else ink
        for row in rows
        for text, ink in row
        if text.strip()
    }


def at(rows: list[Row], ink: Ink) -> set[int]:
    """The rows in which something of an ink is seen."""
    return {
        place
        for place, row in enumerate(rows)
        if any(text.strip() and ink in (of, getattr(of, "ink", None)) for text, of in row)
    }


@pytest.mark.parametrize("style", SOLID)
@pytest.mark.parametrize("view", VIEWS)
def test_every_view_in_every_style(view: str, style: ArmStyle) -> None:
    readings = samples.readings(samples.posture(20, 50, -50, -70, 60, 1.3))
    rows = picture(VIEWS[view], style).draw(readings, 60, 22)
    check_golden(f"solid-{view}-{style}", samples.picture(rows, 60, 22))


@pytest.mark.parametrize(("width", "height"), [(30, 10), (48, 14), (100, 30), (160, 48)])
def test_the_arm_in_space_at_its_sizes(width: int, height: int) -> None:
    rows = picture(IN_SPACE).draw(samples.readings(), width, height)
    check_golden(f"space-{width}x{height}", samples.picture(rows, width, height))


@pytest.mark.parametrize("view", VIEWS)
def test_a_slipped_arm_has_a_dim_twin_where_it_was_told_to_be(view: str) -> None:
    rows = picture(VIEWS[view]).draw(samples.slipped(), 60, 22)
    # From above it is straight below the arm here.
    assert (Ink.GHOST in inks(rows)) is (view != "top")
    check_golden(f"solid-{view}-slipped", samples.picture(rows, 60, 22))


def test_only_what_a_picture_shows_elsewhere_has_a_twin() -> None:
    stands = samples.posture(0, 31, -73, -90, 0, 1)
    turned = replace(samples.readings(stands), believed=samples.posture(30, 31, -73, -90, 0, 1))
    rolled = replace(samples.readings(stands), believed=samples.posture(0, 31, -73, -90, 90, 1))
    for readings, shown_by in ((turned, {"top", "space"}), (rolled, {"top", "space"})):
        for name, subject in VIEWS.items():
            rows = picture(subject).draw(readings, 100, 40)
            assert (Ink.GHOST in inks(rows)) is (name in shown_by)


def test_ascii_is_ascii() -> None:
    for subject in VIEWS.values():
        rows = picture(subject).draw(samples.slipped(), 80, 30)
        assert all(text_of(row).isascii() for row in rows)


def test_a_part_is_seen_before_the_arm_that_is_behind_it_and_not_the_other_way_round() -> None:
    def inks_of_the_wrist(y: float) -> set[Ink]:
        wall = Thing(Kind.OBSTACLE, "wall", upright(8.0, y, 0.0, (30.0, 0.5, 30.0), 0.0))
        readings = samples.readings(samples.posture(0, 60, 10, 0, 0, 1), things=(wall,))
        return inks(picture(FROM_THE_SIDE).draw(readings, 60, 22))

    assert Ink.HAND not in inks_of_the_wrist(-5.0)
    assert Ink.HAND in inks_of_the_wrist(5.0)


def test_parts_have_colours_of_their_own() -> None:
    things = tuple(
        Thing(Kind.PART, f"it {n}", upright(4.0 + 2 * n, -4.0, 0.0, (1.0, 1.0, 1.0), 0.0), colour=n)
        for n in range(3)
    )
    readings = samples.readings(samples.STRETCHED_OUT, things=things)
    assert {Ink.PART, Ink.PART_2, Ink.PART_3} <= inks(picture(FROM_ABOVE).draw(readings, 60, 22))


@pytest.mark.parametrize("style", SOLID)
@pytest.mark.parametrize(("width", "height"), [(48, 6), (50, 9), (60, 12), (76, 28)])
def test_a_part_stands_on_the_table_and_leaves_it_when_lifted(
    width: int, height: int, style: ArmStyle
) -> None:
    def bottom(lifted: float) -> int:
        part = Thing(Kind.PART, "it", upright(8.0, 0.0, lifted, (1.0, 1.0, 1.0), 0.0))
        readings = samples.readings(samples.STRETCHED_OUT, things=(part,))
        view = picture(FROM_THE_SIDE, style)
        view.labels = False
        return max(at(view.draw(readings, width, height), Ink.PART))

    table = height - 1
    assert bottom(0.0) == table - 1
    assert bottom(3.0) < table - 1


def test_a_part_seen_from_above_is_where_the_fingers_are_that_hold_it() -> None:
    stands = samples.posture(20, 31, -73, -90, 20, 1.0)
    x, y, z = stands.points.fingertip
    part = Thing(Kind.PART, "it", upright(x, y, z - 0.5, (1.0, 1.0, 1.0), 0.0), held=True)
    for style in SOLID:
        rows = picture(FROM_ABOVE, style).draw(samples.readings(stands, things=(part,)), 100, 30)
        fingers = at(rows, Ink.HAND) | at(rows, Ink.METAL)
        assert at(rows, Ink.PART) <= fingers


def test_the_shadow_of_a_part_is_on_the_table_beside_it() -> None:
    def shadow(readings: Readings) -> int:
        rows = picture(FROM_ABOVE).draw(readings, 60, 22)
        return sum(
            len(text) for row in rows for text, ink in row if getattr(ink, "ink", 0) is Ink.SHADOW
        )

    part = Thing(Kind.PART, "it", upright(9.0, 4.0, 0.0, (1.0, 1.0, 4.0), 0.0))
    bare = samples.readings(samples.STRETCHED_OUT, things=())
    assert shadow(replace(bare, things=(part,))) > shadow(bare) + 4


def test_the_side_view_has_a_scale_in_inches() -> None:
    rows = [
        text_of(row) for row in picture(FROM_THE_SIDE).draw(samples.readings(things=()), 100, 30)
    ]
    [table] = [row for row in rows if "0" in row and "5" in row and "-+-" in row]
    inches = re.search(r"0([^0-9]*)5", table)
    assert inches is not None
    assert inches[1].count("+") == 4
    assert any(row.startswith("5-") for row in rows)


@pytest.mark.parametrize("view", VIEWS)
def test_figures_do_not_run_into_one_another_in_small_pictures(view: str) -> None:
    drawn, bare = picture(VIEWS[view]), samples.readings(things=())
    figures: set[str] = set()
    for _ in range(18):
        drawn.turn(math.radians(20), 0.0)
        for width, height in ((66, 8), (30, 8), (20, 5)):
            rows = drawn.draw(bare, width, height)
            figures |= {figure for row in rows for figure in re.findall(r"\d+", text_of(row))}
    assert figures
    assert figures <= {"0", "5", "10", "15", "20", "25", "30"}


@pytest.mark.parametrize("style", SOLID)
@pytest.mark.parametrize("view", ["side", "top", "space"])
def test_a_figure_is_whole_or_is_not_drawn(view: str, style: ArmStyle) -> None:
    for width in (40, 47, 54):
        for base in range(-60, 61, 12):
            readings = samples.readings(samples.posture(base, 35, -60, -80, 0, 1.3))
            rows = picture(VIEWS[view], style).draw(readings, width, 16)[:-1]
            labels = [text if ink is Ink.LABEL else " " for row in rows for text, ink in row]
            figures = set(re.findall(r"\d+", "".join(labels)))
            assert figures <= {"0", "5", "10", "15", "20", "25"}


def test_walking_round_the_arm_shows_it_from_elsewhere_and_all_round_is_where_one_began() -> None:
    view = picture(IN_SPACE)
    before = view.draw(samples.readings(), 60, 22)
    view.turn(1.0, 0.2)
    assert view.draw(samples.readings(), 60, 22) != before
    view.turn(-1.0, -0.2)
    assert view.draw(samples.readings(), 60, 22) == before
    view.turn(0.0, 99.0)
    assert view.orbit.tilt < 1.6


def test_a_closer_look_in_space_follows_the_hand() -> None:
    view = picture(IN_SPACE)
    for _ in range(3):
        view.zoom_in()
    for base in range(-20, 81, 20):
        rows = view.draw(samples.readings(samples.posture(base, 31, -73, -90, 0, 1)), 60, 22)
        assert Ink.HAND in inks(rows)


def test_dots_in_a_shadow_of_dots_have_no_ground() -> None:
    stands = samples.posture(30.9, 31.4, -74.5, -90, 70, 0.5)
    rows = picture(IN_SPACE, ArmStyle.BRAILLE).draw(samples.readings(stands), 100, 28)
    assert Ink.SHADOW in inks(rows)
    assert not [ink for row in rows for _, ink in row if isinstance(ink, Paint) and ink.under]


@pytest.mark.parametrize("grain", [HALVES.samples, SEXTANTS.samples])
@pytest.mark.parametrize("finger", [LEFT_FINGER, RIGHT_FINGER])
def test_no_finger_has_gaps_between_the_samples(grain: tuple[int, int], finger: int) -> None:
    for place in range(12):
        stands = samples.posture(0, 31 + place / 4, -73.4 - place / 4, -90, 0, 1.6)
        shot = FROM_THE_SIDE.shot(samples.readings(stands), Orbit(), Extras())
        window = Viewport().window(shot, 40, 12).aligned()
        taken = take(shot, 40, 12, grain, window).body.reshape(grain[1], grain[0], 12, 40)
        rows = np.flatnonzero((taken == finger).any((1, 3)).T)
        assert np.diff(rows).tolist() == [1] * (len(rows) - 1)
        assert len(rows) > 2


@pytest.mark.parametrize("style", [*SOLID, ArmStyle.OUTLINE])
@pytest.mark.parametrize("view", VIEWS)
def test_lines_of_a_picture_that_stand_are_not_made_again(view: str, style: ArmStyle) -> None:
    subject, stands = VIEWS[view], samples.posture(20, 50, -50, -70, 60, 1.3)
    moved, readings = samples.posture(20, 50, -52, -70, 60, 1.3), samples.readings(stands)
    drawn = picture(subject, style)
    before = drawn.draw(readings, 100, 40)
    now = drawn.draw(samples.readings(moved), 100, 40)
    other = picture(subject, style)
    for width in (100, 99):
        other.draw(readings, width, 40)
    assert now == other.draw(samples.readings(moved), 100, 40) != before
    if style is not ArmStyle.OUTLINE:
        same = [one for one, other in zip(before[:-1], now[:-1], strict=True) if one == other]
        assert same
        assert {id(row) for row in same} <= {id(row) for row in now}


@pytest.mark.parametrize("view", VIEWS)
def test_what_moves_by_less_than_a_sample_is_drawn_where_it_comes_to_stand(view: str) -> None:
    drawn = picture(VIEWS[view])
    before = drawn.draw(samples.readings(samples.posture(20, 50, -50, -70, 60, 1.3)), 100, 40)
    steps = [samples.posture(20, 50 - step / 50, -50, -70, 60, 1.3) for step in range(1, 21)]
    pictures = [drawn.draw(samples.readings(stands), 100, 40)[:-1] for stands in steps]
    assert pictures[0] == before[:-1]
    assert sum(one != other for one, other in pairwise(pictures)) < len(steps) - 1
    stands = samples.readings(steps[-1])
    exact = picture(VIEWS[view]).draw(stands, 100, 40)
    assert drawn.draw(stands, 100, 40) == exact


def test_what_does_not_hang_on_the_arm_is_drawn_at_once() -> None:
    drawn = picture(FROM_ABOVE)
    before = drawn.draw(samples.readings(), 100, 40)
    tiny = samples.posture(0.0, 31.001, -73.4, -90.0, 0.0, 1.3)
    lying = upright(5.0, -4.0, 0.0, (1.0, 1.0, 1.0), 0.0)
    pushed = samples.readings(tiny, things=(Thing(Kind.PART, "other", lying),))
    assert drawn.draw(pushed, 100, 40)[:-1] != before[:-1]
    for change in (drawn.zoom_in, drawn.zoom_fit, lambda: setattr(drawn, "envelope", True)):
        before = drawn.draw(pushed, 100, 40)
        change()
        assert drawn.draw(pushed, 100, 40) != before
