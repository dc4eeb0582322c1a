"""The scope draws a history; the drawings are in golden/scope-*.txt."""

from __future__ import annotations

import numpy as np
import pytest

from tests.drawing import samples
from tests.goldens import check_golden
from trs80arm.arm.bench import Bench
from trs80arm.drawing.rows import Ink, text_of
from trs80arm.drawing.scope import LABEL, Scope
from trs80arm.drawing.strips import strip
from trs80arm.machine.card import Latch
from trs80arm.rig import Rig
from trs80arm.trace.history import History

NAMES = Rig().arm.model.motor_names


@pytest.fixture(scope="module")
def history() -> History:
    """Figure 10's motion, 21 steps of the base and 3 of the shoulder, and some more."""
    rig = Rig(bench=Bench())
    watched = History(rig)
    rig.type("@STEP 50,21,3:@STEP 100,0,-40,60,0,0,100\r")
    for _ in range(600):
        rig.run_for(1 / 60)
    return watched


def drawing(scope: Scope, history: History, width: int, height: int) -> str:
    return samples.picture(scope.draw(history, NAMES, width, height), width, height)


@pytest.mark.parametrize(("width", "height"), [(160, 44), (100, 37), (80, 10), (48, 6)])
def test_all_latches(history: History, width: int, height: int) -> None:
    check_golden(f"scope-{width}x{height}", drawing(Scope(), history, width, height))


def test_one_joint_in_ascii(history: History) -> None:
    scope = Scope()
    scope.ascii = True
    for _ in range(3):
        scope.next_joint(1)
    text = drawing(scope, history, 90, 22)
    assert text.isascii()
    check_golden("scope-joint", text)


@pytest.mark.parametrize("height", [10, 30, 37])
def test_names_of_motors_are_whole_words_beside_rows_and_phases(
    history: History, height: int
) -> None:
    rows = Scope().draw(history, NAMES, 80, height)
    labels = [text_of(row)[: LABEL - 1].rstrip(" 1") for row in rows]
    assert [label for label in labels if label[:1] == "J"] == [
        "J1 base",
        "J2 shoulder",
        "J3 elbow",
        "J4 l wrist",
        "J5 r wrist",
        "J6 hand",
    ]


def test_a_strip_has_a_rule_above_it_and_tells_most_now_and_least(history: History) -> None:
    scope = Scope()
    scope.joint = 3
    rows = scope.draw(history, NAMES, 80, 22)
    labels = [text_of(row)[:LABEL].split() for row in rows]
    begin = labels.index(["angle,", "deg"])
    assert rows[begin][1] == ("─" * (80 - LABEL), Ink.FAINT)
    words, figures = zip(*labels[begin + 1 : begin + 4], strict=True)
    assert words == ("most", "now", "least")
    most, now, least = map(float, figures)
    assert most >= now > least
    scope.put_cursor(LABEL + 1)
    at_cursor = [text_of(row)[:LABEL].split() for row in scope.draw(history, NAMES, 80, 22)]
    word, figure = at_cursor[begin + 2]
    assert word == "here"
    assert float(figure) < now


def ending_at(scope: Scope, time: int, history: History) -> Scope:
    """The scope with a T-state just before its right edge."""
    scope.scroll(-1_000_000, history)
    scope.scroll((time - history.begin) // scope.step + 4, history)
    return scope


def test_figure_10_as_it_happens(history: History) -> None:
    scope = Scope()
    scope.zoom(2)
    base, _ = history.changes(Latch.BASE)
    ending_at(scope, int(base[20]), history)
    check_golden("scope-figure-10", drawing(scope, history, 60, 37))


def test_a_row_of_figure_8_after_the_other(history: History) -> None:
    scope = Scope()
    scope.zoom(4)
    base, _ = history.changes(Latch.BASE)
    ending_at(scope, int(base[20]), history)
    steps = text_of(scope.draw(history, NAMES, 160 + LABEL, 10)[1])[LABEL:].strip("· ")
    once = [row for row, before in zip(steps, " " + steps, strict=False) if row != before]
    assert "".join(once) == "234567812345678123456"


def test_it_follows_what_happens_until_one_scrolls_back(history: History) -> None:
    scope = Scope()
    live = drawing(scope, history, 80, 10)
    scope.scroll(-30, history)
    assert "looking back" in drawing(scope, history, 80, 10)
    scope.scroll(40, history)
    assert drawing(scope, history, 80, 10) == live


def test_two_cursors_measure_time(history: History) -> None:
    scope = Scope()
    scope.draw(history, NAMES, 80, 10)
    scope.put_cursor(LABEL + 20, mark=True)
    scope.put_cursor(LABEL + 25)
    rows = scope.draw(history, NAMES, 120, 10)
    assert "+50.00 ms from the mark" in text_of(rows[0])
    assert any(text == "|" and ink is Ink.STRONG for row in rows for text, ink in row)


def test_closer_looks_stay_where_the_cursor_is(history: History) -> None:
    scope = Scope()
    scope.draw(history, NAMES, 80, 10)
    scope.put_cursor(LABEL + 10)
    at = scope.cursor
    for _ in range(4):
        scope.zoom(1)
        head = text_of(scope.draw(history, NAMES, 80, 10)[0])
        assert scope.cursor == at
        assert "looking back" in head


@pytest.mark.parametrize("ascii", [True, False])
def test_a_scope_can_be_drawn_at_any_size(history: History, ascii: bool) -> None:
    for joint in (None, 1, 6):
        scope = Scope()
        scope.joint, scope.ascii = joint, ascii
        for width in (1, 12, 13, 40, 200):
            for height in (1, 2, 3, 7, 40):
                rows = scope.draw(history, NAMES, width, height)
                assert len(rows) == height
                assert all(len(text_of(row)) == width for row in rows)


def test_a_strip_joins_its_points_and_leaves_gaps_where_nothing_is_known() -> None:
    values = np.array([0.0, 0.0, 3.0, 3.0, np.nan, 3.0])
    upper, lower = strip(values, 0.0, 3.0, 2, ascii=True)
    assert upper[4] == lower[4] == " "
    assert upper[3] == upper[5] == "'"
    assert lower[0] == lower[1] == "."
