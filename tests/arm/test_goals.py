"""Goals of a bench: the score says where parts are, and how far from where they belong."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from tests.arm.refusals import refusal
from tests.slices import elsewhere
from tests.statements import done
from trs80arm import Rig
from trs80arm.arm import BenchError, benchfile
from trs80arm.arm.goals import Mark, Score

BLOCK = "[[part]]\nname = 'block'\nat = [8, 2]\nsize = [1, 0.5, 1]\nturn = 30\n"
TILE = "[[part]]\nname = 'tile'\nat = [8, -2]\nsize = [0.2, 1, 1]\n"
LYING = "[[part]]\nname = 'lying'\nat = [10, -4]\nsize = [0.2, 1, 1]\ntilt = 90\n"
RIDER = "[[part]]\nname = 'rider'\nat = [8, 2]\nbottom = 1\nsize = [0.4, 0.4, 0.4]\n"
TRAY = "[[tray]]\nname = 'done'\nat = [6, 5]\nsize = [2, 2]\n"


def scored(goal: str, *things: str) -> Score:
    return Rig(bench=benchfile.parse("".join(things) + "[[goal]]\n" + goal)).score()


def only(goal: str, *things: str) -> Mark:
    (mark,) = scored(goal, *things).marks
    return mark


def test_a_place_is_met_within_its_tolerance_as_seen_from_above() -> None:
    near = only("part = 'block'\nat = [8.03, 2.04]", BLOCK)
    assert near.met
    assert near.error == pytest.approx(0.05, abs=1e-6)
    assert not only("part = 'block'\nat = [8.03, 2.04]\ntolerance = 0.04", BLOCK).met


def test_a_place_with_a_height_is_that_of_the_middle() -> None:
    assert only("part = 'block'\nat = [8, 2, 0.5]\ntolerance = 0.01", BLOCK).met
    high = only("part = 'block'\nat = [8, 2, 1.5]", BLOCK)
    assert (high.met, high.error) == (False, pytest.approx(1.0, abs=0.01))


def test_a_turn_counts_as_far_as_it_can_be_seen() -> None:
    # A block half as wide as long looks the same after half a turn; a square one after a quarter.
    assert only("part = 'block'\nturn = 210", BLOCK).met
    off = only("part = 'block'\nturn = 120", BLOCK)
    assert (off.met, off.turned) == (False, pytest.approx(90.0))
    square = BLOCK.replace("[1, 0.5, 1]", "[1, 1, 1]")
    assert only("part = 'block'\nturn = 117\nturn_tolerance = 4", square).turned == pytest.approx(3)
    disc = "[[part]]\nname = 'disc'\nshape = 'disc'\nat = [8, 2]\ndiameter = 1\nheight = 0.3\n"
    assert only("part = 'disc'\nturn = 47.3", disc).turned == 0.0


def test_an_area_is_met_by_every_part_whose_middle_is_in_it() -> None:
    score = scored("part = '*e*'\narea = [8, -2, 2, 1]", TILE, RIDER.replace("[8, 2]", "[8, 3]"))
    assert [(mark.part, mark.met) for mark in score.marks] == [("tile", True), ("rider", False)]
    assert score.marks[1].error == pytest.approx(4.5, abs=0.01)


def test_a_posture_is_upright_or_fallen() -> None:
    assert only("part = 'tile'\nposture = 'upright'", TILE).met
    assert only("part = 'lying'\nposture = 'fallen'", LYING).met
    wrong = only("part = 'tile'\nposture = 'fallen'", TILE)
    assert (wrong.met, wrong.found) == (False, "is upright")


def test_what_a_part_stands_on_may_matter() -> None:
    assert only("part = 'rider'\non = 'block'", BLOCK, RIDER).met
    assert only("part = 'block'\non = 'table'", BLOCK, RIDER).met
    assert only("part = 'rider'\non = 'table'", BLOCK, RIDER).found == "not on it"
    assert not only("part = 'block'\non = 'rider'", BLOCK, RIDER).met
    shelf = "[[obstacle]]\nname = 'shelf'\nat = [8, 2]\nsize = [2, 2, 1]\n"
    assert only("part = 'rider'\non = 'shelf'", shelf, RIDER).met


def test_several_places_share_the_parts_out_nearest_first() -> None:
    row = "".join(
        f"[[part]]\nname = 'm {n}'\nat = [{x}, 0]\nsize = [0.4, 0.4, 0.4]\n"
        for n, x in enumerate((7.0, 8.02, 9.0), 1)
    )
    score = scored("part = 'm *'\nat = [[8, 0], [7, 0], [10, 0], [12, 4]]", row)
    assert [(mark.part, mark.met) for mark in score.marks] == [
        ("m 2", True),
        ("m 1", True),
        ("m 3", False),
        ("", False),
    ]
    assert score.marks[3].found == "there is none"
    assert (score.met, score.total, score.perfect) == (2, 4, False)
    assert max(score.errors) == pytest.approx(1.0, abs=0.001)


def test_a_tray_is_to_take_so_many() -> None:
    bench = benchfile.parse(TRAY + "[[goal]]\ntray = 'done'\ncount = 2")
    rig = Rig(bench=bench)
    assert rig.score().marks == (Mark("2 in done", "", False, found="it took 0"),)
    rig.arm.bench.trays[0].taken = 2
    assert rig.score().perfect


def test_what_the_hand_holds_is_not_where_it_belongs_yet() -> None:
    bench = "[arm]\nat = [8, 0, 0.6]\nopening = 0.8\n" + BLOCK.replace("[8, 2]", "[8, 0]").replace(
        "turn = 30", ""
    )
    rig = Rig(bench=benchfile.parse(bench + "[[goal]]\npart = 'block'\nat = [8, 0]"))
    assert rig.score().perfect
    done(rig, "@CLOSE", "@STEP 100,0,0,0,0,0,-30")
    (mark,) = rig.score().marks
    assert (mark.met, mark.found) == (False, "in the hand")
    assert mark.error == pytest.approx(0.0, abs=0.02)


def test_the_score_agrees_with_where_a_pushed_part_is() -> None:
    bench = "[arm]\nat = [8, -2, 0.5]\n" + BLOCK.replace("[8, 2]", "[8, 0]")
    rig = Rig(bench=benchfile.parse(bench + "[[goal]]\npart = 'block'\nat = [8, 1]\ntolerance=0.5"))
    done(rig, "@STEP 100,250")
    x, y, _ = rig.arm.bench.parts["block"].origin
    (mark,) = rig.score().marks
    assert mark.error == pytest.approx(math.dist((x, y), (8, 1)))
    assert y > 0.3


def test_goals_are_in_a_snapshot() -> None:
    bench = benchfile.parse(BLOCK + TRAY + "[[goal]]\npart='block'\nat=[8, 2]\n[[goal]]\n"
                            "tray='done'\ncount=1")  # fmt: skip
    rig = Rig(bench=bench)
    other = elsewhere(rig)
    assert other.score() == rig.score()
    assert other.score().total == 2


def test_the_table_and_the_headline_are_to_be_read() -> None:
    score = scored("part = 'block'\nat = [8.03, 2.04]\nturn = 30", BLOCK, TILE)
    assert score.text().splitlines() == [
        "met  block at (8.03, 2.04) turned 30   0.050 in    0.0 deg",
        "1 of 1 goal met; error 0.050 in on average, 0.050 in at most",
    ]
    assert Rig().score().text() == "This bench has no goals."


def test_json_has_the_same() -> None:
    plain = scored("part = 'block'\nat = [8, 2]", BLOCK).plain()
    assert (plain["met"], plain["total"]) == (1, 1)
    assert plain["marks"][0]["part"] == "block"
    assert plain["largest_error"] == plain["marks"][0]["error"]


@pytest.mark.parametrize(
    ("goal", "line"),
    [
        ("at = [8, 2]", "part: expected a name"),
        (
            "part = 'blok'\nat = [8, 2]",
            "part: expected the name of a part or a pattern as 'block *'; there is none such",
        ),
        ("part = 'block'", "part: expected one of at, area, turn, posture and on beside it"),
        (
            "part = 'block'\nat = [8]",
            "at: expected a place [x, y] or [x, y, z], or up to 100 of them in a list",
        ),
        (
            "part = 'block'\nat = [[8, 2], 3]",
            "at: expected a place [x, y] or [x, y, z], or up to 100 of them in a list",
        ),
        (
            "part = 'block'\nat = [8, 200]",
            "at: expected a place [x, y] or [x, y, z], or up to 100 of them in a list; "
            "from -60 to 60",
        ),
        ("part = 'block'\nat = [8, 2]\narea = [1, 1, 1, 1]", "area: expected either at or area"),
        (
            "part = 'block'\narea = [1, 1, 0, 1]",
            "area: expected x, y, width and depth, both more than 0",
        ),
        ("part = 'block'\nposture = 'flat'", "posture: expected upright or fallen"),
        ("part = 'block'\nposture = ['fallen']", "posture: expected upright or fallen"),
        ("part = 'block'\nturn=2\ntolerance=0", "tolerance: expected a number from 0.001 to 60"),
        ("part = 'block'\non = 'moon'", "on: expected the name of a part, an obstacle or 'table'"),
        ("tray = 'dun'\ncount = 1", "tray: expected the name of a tray of this bench"),
        ("tray = 'done'\ncount = 0", "count: expected a whole number from 1 to 1000000"),
        (
            "tray = 'done'\ncount = 1\nat = [1, 2]",
            "at: expected nothing by that name; the keys here are tray, count",
        ),
    ],
)  # fmt: skip
def test_an_impossible_goal_is_told_in_one_line(goal: str, line: str) -> None:
    assert refusal(BLOCK + TRAY + "[[goal]]\n" + goal) == f"b.toml: goal[1].{line}"


@pytest.mark.parametrize(
    ("part", "is_there"), [("blank 3", True), ("blank *", True), ("blank 4", False), ("b", False)]
)
def test_parts_that_a_feeder_will_give_can_have_goals(part: str, is_there: bool) -> None:
    feeder = "[[feeder]]\nname='blank'\nat=[8, -2]\nsize=[0.5, 0.5, 1]\ncount=3\n"
    text = feeder + f"[[goal]]\npart = '{part}'\nat = [8, 2]"
    if is_there:
        assert benchfile.parse(text).goals
    else:
        with pytest.raises(BenchError, match="there is none such"):
            benchfile.parse(text)


def test_a_run_ends_with_the_score(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from trs80arm.batch import BatchOptions, run_program

    (tmp_path / "one.bas").write_text("10 PRINT 1\n")
    (tmp_path / "one.toml").write_text(BLOCK + "[[goal]]\npart = 'block'\nat = [8, 2]\n")
    assert run_program(BatchOptions(tmp_path / "one.bas")) == 0
    assert capsys.readouterr().out.splitlines() == [
        " 1 ",
        "met  block at (8, 2)   0.000 in",
        "1 of 1 goal met; error 0.000 in on average, 0.000 in at most",
    ]
