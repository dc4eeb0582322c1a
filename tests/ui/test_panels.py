from __future__ import annotations

from dataclasses import replace

import pytest
from textual.events import MouseScrollDown, MouseScrollUp

from tests.drawing import samples
from tests.goldens import check_golden
from trs80arm.arm.events import ArmEvent, EventKind, Reason
from trs80arm.basic.activity import Waiting
from trs80arm.drawing.rows import Ink, clock_text, text_of
from trs80arm.machine.driver import Mode
from trs80arm.ui.panels.cell import CellPanel
from trs80arm.ui.panels.coils import CoilsPanel
from trs80arm.ui.panels.effort import EffortPanel
from trs80arm.ui.panels.events import EventsLog, collapsed
from trs80arm.ui.panels.panel import Panel
from trs80arm.ui.panels.pose import PosePanel
from trs80arm.ui.panels.registers import RegistersPanel
from trs80arm.ui.panels.side_view import SideView
from trs80arm.ui.panels.status import Pace, StatusLine, doing_text
from trs80arm.ui.panels.top_view import TopView

PANELS = [RegistersPanel, PosePanel, CoilsPanel, CellPanel, EventsLog, EffortPanel]


def drawing(panel: Panel, width: int, height: int) -> str:
    return samples.picture(panel.draw(samples.slipped(), width, height), width, height)


@pytest.mark.parametrize("panel", PANELS)
@pytest.mark.parametrize(("width", "height"), [(16, 9), (14, 7), (38, 8), (80, 6)])
def test_panels_at_their_sizes(panel: type[Panel], width: int, height: int) -> None:
    name = panel.__name__.removesuffix("Panel").lower()
    check_golden(f"{name}-{width}x{height}", drawing(panel(), width, height))


@pytest.mark.parametrize("panel", [*PANELS, SideView, TopView, StatusLine])
def test_every_panel_explains_itself(panel: type[Panel]) -> None:
    assert panel.HELP.strip().startswith("##")


@pytest.mark.parametrize("panel", PANELS)
def test_panels_can_be_drawn_at_any_size(panel: type[Panel]) -> None:
    for width in (1, 10, 33, 100):
        for height in (1, 4, 30):
            rows = panel().draw(samples.slipped(), width, height)
            assert any(text_of(row).strip() for row in rows)


def test_a_slipped_joint_is_marked_by_glyph_and_ink() -> None:
    rows = RegistersPanel().draw(samples.slipped(), 16, 6)
    assert text_of(rows[1]).endswith("!")
    assert rows[1][1][1] is Ink.ALARM
    assert rows[0][1][1] is Ink.PLAIN


def test_a_joint_moved_without_a_command_is_not_called_slipped() -> None:
    rows = RegistersPanel().draw(samples.readings(joints=(5, 0, 0, 0, 0, 0)), 16, 6)
    assert text_of(rows[0]).endswith("~")


def test_a_motor_near_its_limit_is_told_by_glyph_and_ink_and_so_is_one_beyond() -> None:
    rows = EffortPanel().draw(samples.slipped(), 80, 7)
    told = {text_of(row)[:11].strip(): row[1] for row in rows}
    assert told["J1 base"] == (" 89 % ! ", Ink.WARNING)
    assert told["J2 shoulder"] == ("101 % !!", Ink.ALARM)
    assert told["J3 elbow"] == ("  4 %   ", Ink.PLAIN)
    assert "0.58 lb, holding takes 0.50" in text_of(rows[5])


def test_bars_are_of_plain_characters_where_everything_is() -> None:
    panel = EffortPanel()
    panel.ascii = True
    assert all(text_of(row).isascii() for row in panel.draw(samples.slipped(), 100, 7))


def test_the_registers_name_the_motor_that_is_near_its_limit() -> None:
    safe = replace(samples.slipped(), slipped=(0,) * 6)
    assert text_of(RegistersPanel().draw(safe, 16, 9)[-1]) == "shoulder 101 %"
    assert RegistersPanel().draw(safe, 16, 9)[-1][0][1] is Ink.ALARM
    narrow = RegistersPanel().draw(safe, 10, 9)[-1]
    assert text_of(narrow) == "J2 101 %"


def test_an_input_that_the_selector_does_not_show_is_dim_and_still_told() -> None:
    heading, *rows = CellPanel().draw(samples.slipped(), 40, 9)
    assert text_of(heading) == "the selector shows bank 1"
    assert [(text_of(row), row[1][1], row[2][1]) for row in rows] == [
        ("bank 0 bit 1 ○ left tip", Ink.LAMP_OFF, Ink.LABEL),
        ("bank 0 bit 3 ● palm", Ink.LAMP_ON, Ink.LABEL),
        ("bank 1 bit 2 ● shoulder", Ink.LAMP_ON, Ink.STRONG),
    ]


def test_devices_are_told_with_what_they_do() -> None:
    rows = CellPanel().draw(samples.readings(things=(samples.BELT,)), 40, 9)
    assert [text_of(row) for row in rows] == ["belt runs"]
    nothing = CellPanel().draw(samples.readings(), 40, 9)
    assert text_of(nothing[0]) == "no sensors, no devices"


def test_lamps_change_glyph_as_well_as_ink() -> None:
    panel = CoilsPanel()
    panel.ascii = True
    row = panel.draw(samples.readings(coils=(0b1010, 0, 0, 0, 0, 0, 0)), 16, 9)[0]
    assert text_of(row) == "J1  * . * . "
    assert {ink for text, ink in row if "*" in text} == {Ink.LAMP_ON}


def test_an_input_that_answers_is_lit() -> None:
    panel = CoilsPanel()
    panel.ascii = True
    rows = panel.draw(samples.readings(inputs=0b0110), 16, 9)
    assert text_of(rows[7]) == "in  * . . * "


def test_repeated_events_are_one_line_with_a_count() -> None:
    entries = collapsed(samples.EVENTS, 10)
    assert [(entry.event.number, entry.count) for entry in entries] == [(0, 1), (2, 2), (3, 1)]
    assert entries[1].steps == 40
    assert [entry.event.number for entry in collapsed(samples.EVENTS, 1)] == [3]


def test_the_wheel_looks_back_and_no_further_than_the_beginning() -> None:
    log, readings = EventsLog(), samples.slipped()
    turn = {"widget": log, "x": 0, "y": 0, "delta_x": 0, "delta_y": 0, "button": 0}
    turn |= {"shift": False, "meta": False, "ctrl": False}

    def newest() -> str:
        return text_of(log.draw(readings, 60, 1)[0])

    assert "in the hand" in newest()
    log.on_mouse_scroll_up(MouseScrollUp(**turn))
    assert "slipped" in newest()
    for _ in range(5):
        log.on_mouse_scroll_up(MouseScrollUp(**turn))
    assert "blocked" in newest()
    for _ in range(2):
        log.on_mouse_scroll_down(MouseScrollDown(**turn))
    assert "in the hand" in newest()


def test_the_log_is_drawn_anew_only_when_something_happened() -> None:
    log = EventsLog()
    first = log.draw(samples.slipped(), 40, 5)
    assert log.draw(samples.slipped(), 40, 5) is first


def test_times_are_minutes_seconds_and_hundredths() -> None:
    assert clock_text(0) == "0:00.00"
    assert clock_text(83.456) == "1:23.45"


def status(width: int, pace: Pace, keys: str = "", notice: str = "") -> str:
    line = StatusLine()
    line.show(samples.slipped(), pace, keys, notice)
    return text_of(line.draw(samples.slipped(), width, 1)[0])


def test_status_line_says_clock_speed_keys_and_what_the_machine_does() -> None:
    text = status(80, Pace(2.0, 1.9), "repeat")
    assert text == "1:23.4  x2 95%  keys: repeat  motors ON  ! steps lost  running"


def test_status_line_leaves_out_what_matters_less() -> None:
    assert status(30, Pace(), "events") == "1:23.4  ! steps lost  running"
    assert status(8, Pace()) == "running"


def test_a_notice_stands_last() -> None:
    assert status(80, Pace(), notice="saved").endswith("  saved")


def test_paces_in_words() -> None:
    assert Pace(None, 41.3).text() == "flat out x41"
    assert Pace(1.0, 0.82).text() == "x1 82%"
    assert Pace(paused=True).text() == "PAUSED"


def test_every_wait_has_its_words() -> None:
    for waiting in Waiting:
        assert doing_text(samples.readings(waiting=waiting))
    assert doing_text(samples.readings(mode=Mode.CLOSE)) == "running @CLOSE"


def test_fingers_on_a_part_are_no_alarm_and_a_blocked_motor_is() -> None:
    fingers = ArmEvent(0, 0, EventKind.CONTACT, None, 0, None, "fingers on part 1")
    blocked = ArmEvent(1, 0, EventKind.CONTACT, 1, 0, Reason.CONTACT, "shoulder blocked by table")
    rows = EventsLog().draw(samples.readings(events=(fingers, blocked)), 60, 4)
    assert [row[1][1] for row in rows] == [Ink.PLAIN, Ink.ALARM]


@pytest.mark.parametrize("width", [64, 80, 120])
def test_the_machines_state_is_seen_beside_a_notice(width: int) -> None:
    line = StatusLine()
    line.show(samples.readings(waiting=Waiting.SET), Pace(), "repeat", "Position 1 is taught: F12.")
    [row] = line.draw(samples.readings(waiting=Waiting.SET), width, 1)
    text = text_of(row)
    assert "@SET" in text
    assert "0 ends" in text
    assert "Position 1 is taught: F12." in text
    assert len(text) <= width


LONG = "The registers are read back from the listing, and line 120 names a point that is not there."


@pytest.mark.parametrize("width", [40, 60, 64, 80, 100])
@pytest.mark.parametrize("paused", [False, True])
def test_a_notice_is_never_cut_and_state_and_pause_stay(width: int, paused: bool) -> None:
    line = StatusLine()
    readings = samples.readings(waiting=Waiting.SET)
    for notice in (LONG, LONG.partition(",")[0], "Speed 2."):
        line.show(readings, Pace(paused=paused), "repeat", notice)
        rows = [text_of(row) for row in line.draw(readings, width, 3)]
        assert " ".join(rows).count(notice) == 1
        assert all(len(row) <= width for row in rows)
        assert "0 ends" in rows[-1]
        assert ("PAUSED" in rows[-1]) or not paused
        assert len(rows) == 1 or notice not in rows[-1]
