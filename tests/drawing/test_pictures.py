"""The drawings themselves are in golden/side-*.txt and golden/top-*.txt: look at them."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.drawing import samples
from tests.goldens import check_golden
from trs80arm.arm.shapes import upright
from trs80arm.drawing.canvas_ascii import AsciiCanvas
from trs80arm.drawing.picture import (
    FROM_ABOVE,
    FROM_THE_SIDE,
    IN_SPACE,
    Picture,
    Subject,
    angles_text,
)
from trs80arm.drawing.readings import Kind, Posture, Readings, Thing
from trs80arm.drawing.rows import Ink, text_of
from trs80arm.drawing.scene import Extras, Joint, skeleton
from trs80arm.drawing.top_scene import top_scene
from trs80arm.options import ArmStyle

SIZES = [(76, 28), (50, 18), (40, 12), (16, 8), (46, 6)]


def outlined(subject: Subject) -> Picture:
    """A picture in bare lines."""
    picture = Picture(subject)
    picture.style = ArmStyle.OUTLINE
    return picture


def drawing(view: Picture, readings: Readings, width: int, height: int) -> str:
    return samples.picture(view.draw(readings, width, height), width, height)


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_side_view_at_its_sizes(width: int, height: int) -> None:
    check_golden(
        f"side-{width}x{height}",
        drawing(outlined(FROM_THE_SIDE), samples.readings(), width, height),
    )


@pytest.mark.parametrize(("width", "height"), [(46, 18), (30, 18), (34, 6), (16, 8)])
def test_top_view_at_its_sizes(width: int, height: int) -> None:
    check_golden(
        f"top-{width}x{height}",
        drawing(outlined(FROM_ABOVE), samples.readings(samples.TO_THE_LEFT), width, height),
    )


@pytest.mark.parametrize(
    ("name", "stands"),
    [("left", samples.TO_THE_LEFT), ("out", samples.STRETCHED_OUT)],
)
def test_side_view_of_other_postures(name: str, stands: Posture) -> None:
    check_golden(f"side-{name}", drawing(outlined(FROM_THE_SIDE), samples.readings(stands), 50, 18))


def test_a_slipped_arm_has_a_dotted_twin_where_it_was_told_to_be() -> None:
    check_golden("side-slipped", drawing(outlined(FROM_THE_SIDE), samples.slipped(), 50, 18))
    check_golden("top-slipped", drawing(outlined(FROM_ABOVE), samples.slipped(), 30, 18))


def test_envelope_and_trail_on_request() -> None:
    side = outlined(FROM_THE_SIDE)
    side.envelope = True
    side.trail = True
    for shoulder in range(0, 90, 3):
        side.follow(samples.readings(samples.posture(0, shoulder, -70, -90, 0, 1)))
    check_golden("side-envelope-trail", drawing(side, samples.readings(), 60, 24))
    top = outlined(FROM_ABOVE)
    top.envelope = True
    check_golden("top-envelope", drawing(top, samples.readings(), 44, 20))


def test_the_window_grows_when_the_arm_leaves_it_and_stays() -> None:
    side = outlined(FROM_THE_SIDE)
    before = drawing(side, samples.readings(), 50, 18)
    raised = samples.readings(samples.posture(0, 90, 80, 60, 0, 1))
    assert drawing(side, raised, 50, 18).count("o") >= 2
    assert drawing(side, samples.readings(), 50, 18) != before
    side.zoom_fit()
    assert drawing(side, samples.readings(), 50, 18) == before


def test_a_closer_look_keeps_the_hand_in_the_picture() -> None:
    side = outlined(FROM_THE_SIDE)
    for _ in range(9):
        side.zoom_in()
    for shoulder in range(20, 60):
        stands = samples.posture(0, shoulder, -70, -90, 0, 1)
        rows = side.draw(samples.readings(stands), 40, 12)
        assert any(ink is Ink.HAND for row in rows for _, ink in row)


def test_parts_beside_the_plane_are_marked() -> None:
    rows = outlined(FROM_THE_SIDE).draw(samples.readings(), 50, 18)
    inks = {ink for row in rows for text, ink in row if "#" in text}
    assert inks == {Ink.PART}
    assert any(":" in text for row in rows for text, ink in row if ink is Ink.FAINT)


def test_turning_the_base_brings_the_other_part_into_the_plane() -> None:
    stands = samples.posture(39.8, 60, -60, -60, 0, 1)
    rows = outlined(FROM_THE_SIDE).draw(samples.readings(stands), 50, 18)
    row = text_of(rows[15])
    assert row.index(":") < row.rindex("#")


def test_roll_turns_the_fingers_seen_from_above() -> None:
    def bars(roll: float) -> str:
        scene = top_scene(samples.readings(samples.posture(0, 31, -73, -90, roll, 0)), Extras())
        return next(s.glyph for s in reversed(scene.shapes) if isinstance(s, Joint))

    assert [bars(roll) for roll in (0, 45, 90, 135)] == ["|", "/", "-", "\\"]


def test_the_drawn_links_have_their_true_lengths() -> None:
    shoulder, elbow, wrist, tip = skeleton(samples.TO_THE_LEFT)
    assert abs(complex(elbow[0] - shoulder[0], elbow[1] - shoulder[1])) == pytest.approx(7.0)
    assert abs(complex(wrist[0] - elbow[0], wrist[1] - elbow[1])) == pytest.approx(7.0)
    assert abs(complex(tip[0] - wrist[0], tip[1] - wrist[1])) == pytest.approx(3.5)


@pytest.mark.parametrize("width", [26, 36, 48, 80])
def test_angles_are_named_as_far_as_there_is_room(width: int) -> None:
    text = angles_text(samples.readings(), width)
    assert len(text) <= width
    assert "-73" in text


ANGLE = st.floats(-300, 300)
THING = st.builds(
    lambda kind, place, size, turn, held: Thing(kind, "it", upright(*place, size, turn), held),
    st.sampled_from(Kind),
    st.tuples(st.floats(-40, 40), st.floats(-40, 40), st.floats(0, 20)),
    st.tuples(st.floats(0.1, 30), st.floats(0.1, 30), st.floats(0.1, 30)),
    st.floats(-7, 7),
    st.booleans(),
)


@settings(max_examples=60, deadline=None)
@given(
    st.builds(samples.posture, ANGLE, ANGLE, ANGLE, ANGLE, ANGLE, st.floats(0, 3)),
    st.lists(THING, max_size=4),
    st.integers(0, 6),
    st.sampled_from(ArmStyle),
)
def test_every_posture_on_every_bench_can_be_drawn(
    stands: Posture, things: list[Thing], closer: int, style: ArmStyle
) -> None:
    readings = samples.readings(stands, things=tuple(things), believed=samples.STRETCHED_OUT)
    for view in (Picture(FROM_THE_SIDE), Picture(FROM_ABOVE), Picture(IN_SPACE)):
        view.style = style
        view.envelope = view.trail = True
        for _ in range(closer):
            view.zoom_in()
        view.follow(readings)
        rows = view.draw(readings, 50, 18)
        assert [len(text_of(row)) for row in rows] == [50] * 18


@pytest.mark.parametrize("style", ArmStyle)
@pytest.mark.parametrize("subject", [FROM_THE_SIDE, FROM_ABOVE, IN_SPACE])
def test_views_can_be_drawn_at_any_size(subject: Subject, style: ArmStyle) -> None:
    for width in (1, 3, 16, 33, 120):
        for height in (1, 2, 5, 9, 40):
            picture = Picture(subject)
            picture.style = style
            rows = picture.draw(samples.slipped(), width, height)
            assert len(rows) == height
            assert all(len(text_of(row)) == width for row in rows)


@pytest.mark.parametrize(("width", "height"), [(48, 6), (40, 6), (50, 9), (46, 8), (60, 12)])
def test_a_part_is_on_the_table_while_it_lies_and_above_it_when_lifted(
    width: int, height: int
) -> None:
    def rows_of_the_part(bottom: float) -> set[int]:
        part = Thing(Kind.PART, "it", upright(8.0, 0.0, bottom, (1.0, 1.0, 1.0), 0.0))
        readings = samples.readings(samples.STRETCHED_OUT, things=(part,))
        picture = outlined(FROM_THE_SIDE)
        picture.labels = False
        rows = picture.draw(readings, width, height)
        return {y for y, row in enumerate(rows) if any(ink is Ink.PART for _, ink in row)}

    table = height - 1
    assert max(rows_of_the_part(0.0)) == table
    assert max(rows_of_the_part(1.0)) < table


@settings(max_examples=200, deadline=None)
@given(st.floats(0, 30), st.floats(0, 12), st.floats(0, 0.49), st.floats(0, 0.24))
def test_a_small_box_is_where_a_joint_at_its_middle_is(
    x: float, y: float, high: float, wide: float
) -> None:
    boxed, marked = AsciiCanvas(32, 14), AsciiCanvas(32, 14)
    boxed.box((x - wide, y - high), (x + wide, y + high), Ink.PART, "#")
    marked.joint((x, y), Ink.PART, "#", round_it=False)
    assert boxed.rows() == marked.rows()
