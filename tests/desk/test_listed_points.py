"""Listings are read back into the points that they were written from, edited ones too."""

from __future__ import annotations

import pytest

from tests.desk.test_pendant import Bench
from tests.own_places import PROGRAMS
from trs80arm.arm.models import MINIMOVER5
from trs80arm.desk.jogging import Stance
from trs80arm.desk.listed_points import ListingError, Points, read_points
from trs80arm.desk.taught_programs import Manner, in_data, in_steps
from trs80arm.desk.teach import Lesson
from trs80arm.rig import Rig


@pytest.fixture(scope="module")
def lesson() -> Lesson:
    """The task taught, with a comment, a squeeze, and a move that is slower than the others."""
    bench = Bench()
    bench.taught()
    found = bench.pendant.lesson
    found.rename(2, "at the part")
    found.comment(2, "around the part: open")
    found.set_delay(4, 80)
    found.set_grip(4, grips=True, squeeze=30)
    return found


@pytest.fixture(scope="module")
def stance() -> Stance:
    return Stance.of(Rig())


@pytest.mark.parametrize("manner", [Manner(), Manner(60, repeats=True)])
def test_what_is_written_in_steps_is_read_back(
    lesson: Lesson, stance: Stance, manner: Manner
) -> None:
    listing = in_steps(lesson.positions, manner)
    points = read_points(listing, stance)
    assert points.manner == manner
    assert in_steps(points.positions, points.manner) == listing
    for found, taught in zip(points.positions, lesson.positions, strict=True):
        assert (found.name, found.comment, found.delay) == (
            taught.name,
            taught.comment,
            taught.delay,
        )
        assert (found.grips, found.squeeze) == (taught.grips, taught.squeeze)
        assert found.registers[:5] == taught.registers[:5]
        assert found.pose.z == pytest.approx(taught.pose.z, abs=0.01)


@pytest.mark.parametrize("manner", [Manner(), Manner(60, repeats=True)])
def test_what_is_written_in_coordinates_is_read_back(
    lesson: Lesson, stance: Stance, manner: Manner
) -> None:
    listing = in_data(lesson.positions, manner, MINIMOVER5)
    points = read_points(listing, stance)
    assert points.manner == manner
    assert in_data(points.positions, points.manner, MINIMOVER5) == listing
    assert [p.name for p in points.positions] == [p.name for p in lesson.positions]
    assert points.positions[2].comment == "AROUND THE PART OPEN"


def test_numbers_that_were_edited_are_taken(lesson: Lesson, stance: Stance) -> None:
    listing = in_steps(lesson.positions, Manner())
    edited = listing.replace("S=50", "S=40+5*4").replace("@STEP S,0,-194,57", "@STEP 99,0,-180,57")
    assert edited.count("99,0,-180") <= 1
    assert read_points(edited, stance).manner.speed == 60
    data = in_data(lesson.positions, Manner(), MINIMOVER5)
    points = read_points(data.replace("DATA 8, 4, 2,", "DATA 7.5, 3, 2.25,"), stance)
    moved = next(p for p in points.positions if abs(p.pose.y - 3) < 0.01)
    assert (moved.pose.x, moved.pose.z) == (
        pytest.approx(7.5, abs=0.02),
        pytest.approx(2.25, abs=0.02),
    )


def test_the_articles_table_4_is_read(stance: Stance) -> None:
    points = read_points((PROGRAMS / "table4.bas").read_text(), stance)
    assert points.manner.repeats
    places = [tuple(round(v, 1) for v in (p.pose.x, p.pose.y, p.pose.z)) for p in points.positions]
    assert places == [(8, 0, 1.5), (8, 0, 0.5), (8, 0, 1.5), (6, 5, 1.5), (6, 5, 0.5), (6, 5, 1.5)]
    assert [p.squeeze for p in points.positions] == [0, 30, 30, 30, 0, 0]
    hold, free = points.positions[3].registers[5], points.positions[4].registers[5]
    assert free - hold == 300


def test_a_list_of_the_users_own_in_table_2s_way_is_read(stance: Stance) -> None:
    points = read_points((PROGRAMS / "table2-demo.bas").read_text(), stance)
    assert points.manner == Manner(50, repeats=True)
    assert [p.grips for p in points.positions] == [False, True, True, True, False, False]
    assert points.positions[0].registers == (0, -207, 290, 0, 0, 370)


def test_a_list_that_does_not_say_where_it_begins_begins_where_the_arm_is(stance: Stance) -> None:
    points = read_points("10 @STEP 50,100\n20 @STEP 50,0,-50:@CLOSE\n", stance)
    assert [(p.name, p.registers[:2]) for p in points.positions] == [
        ("START", (0, 0)),
        ("A", (100, 0)),
        ("B", (100, -50)),
    ]
    assert points.positions[2].grips


@pytest.mark.parametrize(
    ("listing", "said"),
    [
        ("10 FOR I=1 TO 5\n", "Line 10: FORI=1TO5 cannot be read back"),
        ("10 @STEP 50,X\n", "Line 10: X is given no number before"),
        ("10 @STEP 50,1.5\n", "Line 10: 1.5 is no whole number"),
        ("10 @STEP\n", "Line 10: @STEP is followed by D"),
        ("10 @STEP 50,1,2,3,4,5,6,7\n", "Line 10: @STEP is followed by D"),
        ("10 @READ A,B\n20 @STEP 50,B\n", "Line 20: the steps of J1 hang on the registers"),
        ("10 @READ A\n20 @STEP 50,A*2\n", "Line 20: A*2 multiplies a register"),
        ("10 @STEP 50,5\n20 GOTO 10\n", "Line 20: GOTO goes back, but the arm does not"),
        ("10 GOTO 20\n20 END\n", "Line 10: GOTO can only go back"),
        ("10 REM NOTHING\n", "There is no @STEP"),
        ("@STEP 50,1\n", "No line number: @STEP 50,1"),
        ("", "There is no @STEP"),
        ("10 READ A,B\n20 DATA 1,2\n", "Line 10: READ takes X, Y, Z"),
        ("10 READ X,Y,Z,P,R,G,S\n20 DATA 5,0,0,-90,0,0,A\n", "Line 20: 'A' is no number"),
        ("10 READ X,Y,Z,P,R,G,S\n20 DATA 5,0,0\n", "Line 20: 7 numbers are wanted, 3 are there"),
        ("10 READ X,Y,Z,P,R,G,S\n20 DATA -999\n", "There is no point in the DATA"),
        (
            "10 READ X,Y,Z,P,R,G,S\n20 DATA 5,0,0,-90,0,0,50\n30 DATA 30,0,0,-90,0,0,50\n",
            "Line 30: out of reach: the wrist is farther",
        ),
        ("10 READ X,Y,Z,P,R,G,S\n20 DATA 5,0,0,-90,0,0,50\n", "There is one point only"),
    ],
)
def test_what_cannot_be_read_is_said_with_its_line(listing: str, said: str, stance: Stance) -> None:
    with pytest.raises(ListingError) as refused:
        read_points(listing, stance)
    assert str(refused.value).startswith(said)


@pytest.mark.parametrize("style", ["steps", "data"])
def test_points_that_were_read_are_gone_through(style: str, lesson: Lesson) -> None:
    bench = Bench()
    write = in_steps if style == "steps" else lambda p, m: in_data(p, m, MINIMOVER5)
    points: Points = read_points(write(lesson.positions, Manner()), bench.pendant.stance)
    bench.pendant.lesson.replace(points.positions)
    bench.pendant.run()
    bench.finish()
    assert bench.block == (8.0, 4.0, 0.5)
