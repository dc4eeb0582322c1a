"""Home switches: closed on one side of a mark, with play, by where the joint truly is."""

from __future__ import annotations

import math

import pytest

from tests.arm.cell.cells import arm_at, stepping_at
from tests.arm.refusals import refusal
from trs80arm.arm import MiniMover, Pose
from trs80arm.arm.motors import PHASES
from trs80arm.arm.stepping import delay_period

SLOW = delay_period(100)

ALL = """
[arm]
at = [8, 0, 3]
[selector]
bits = [0, 1]
[[home]]
joint = "base"
at = 5
play = 0
bit = 1
[[home]]
joint = "shoulder"
at = 40
play = 1
bit = 2
[[home]]
joint = "elbow"
at = -60
bit = 3
[[home]]
joint = "left wrist"
at = -88
play = 3
bit = 1
bank = 1
[[home]]
joint = "right wrist"
at = -92
bit = 2
bank = 1
"""


def closed(arm: MiniMover) -> list[bool]:
    return [switch.closed for switch in arm.bench.homes]


def test_a_switch_without_play_is_closed_at_its_mark_and_beyond() -> None:
    generator = stepping_at(ALL)
    arm = generator.arm
    for way in (1, -1, 1):
        for _ in range(100):
            generator.step((way,), SLOW)
            assert closed(arm)[0] == (arm.state().angles.base >= math.radians(5))


@pytest.mark.parametrize(
    ("joint", "mark", "play"),
    [
        ("shoulder", 42, 1.0),
        ("elbow", -64, 0.25),
        ("left wrist", -88, 3.0),
        ("right wrist", -92, 0),
    ],
)
def test_a_switch_opens_only_where_its_joint_has_gone_back_by_its_play(
    joint: str, mark: float, play: float
) -> None:
    head = "[arm]\nat = [8, 0, 3]\n[[home]]\n"
    generator = stepping_at(f"{head}joint = '{joint}'\nat = {mark}\nplay = {play}\nbit = 1")
    arm, (switch,) = generator.arm, generator.arm.bench.homes
    drive = arm.model.drives[switch.motor]
    step = math.degrees(1 / drive.steps)
    there = round(8 / step)
    changes: dict[bool, list[float]] = {True: [], False: []}
    for way in (there, -2 * there, 2 * there, -2 * there, 2 * there):
        for _ in range(abs(way)):
            before = switch.closed
            generator.turn(switch.motor, drive.sign if way > 0 else -drive.sign, SLOW)
            if switch.closed != before:
                angle = math.degrees(arm.drive.driven(arm.rotors)[switch.motor])
                changes[switch.closed].append(angle)
    shut, opened = changes[True], changes[False]
    # It repeats to the half-step.
    assert len(shut) >= 2
    assert len(opened) == 2
    assert len(set(shut)) == len(set(opened)) == 1
    assert mark <= shut[0] < mark + step
    assert mark - play - step <= opened[0] < mark - play


def test_turning_back_within_the_play_changes_nothing() -> None:
    generator = stepping_at(ALL)
    arm = generator.arm
    switch = arm.bench.homes[1]
    while switch.closed:
        generator.step((0, 1), SLOW)
    generator.step((0, -10), SLOW)
    assert not switch.closed
    generator.step((0, 5), SLOW)
    generator.step((0, -5), SLOW)
    assert not switch.closed
    generator.step((0, -10), SLOW)
    assert switch.closed


def test_a_joint_that_has_slipped_closes_its_switch_where_it_truly_is() -> None:
    generator = stepping_at(ALL)
    arm = generator.arm
    # Much too fast: the base drops out of step.
    generator.step((400,), delay_period(0))
    state = arm.state()
    assert state.slipped[0] != 0
    assert closed(arm)[0] == (state.angles.base >= math.radians(5))
    while not closed(arm)[0]:
        generator.step((1,), SLOW)
    assert math.degrees(arm.state().angles.base) == pytest.approx(5, abs=0.07)


def test_moving_the_arm_by_hand_moves_the_cams() -> None:
    arm = arm_at(ALL)
    arm.move_to(Pose(8, 1, 3, -90, 0))
    assert closed(arm)[0]
    arm.move_to(Pose(8, -1, 3, -90, 0))
    assert not closed(arm)[0]


def there_and_back(on: int, back: int) -> tuple[list[int], list[int], list[int]]:
    """Writes of a shoulder that goes up, and turns back, in one burst."""
    turns = [-1] * on + [1] * back
    rows, row = [], 0
    for turn in turns:
        row += turn
        rows.append(row)
    count = len(turns)
    times = [SLOW * (k + 1) for k in range(count)]
    return times, [1] * count, [PHASES[row % 8] for row in rows]


@pytest.mark.parametrize("back", [5, 15, 30])
@pytest.mark.parametrize("more", [0, 1])
def test_a_burst_that_turns_back_does_to_a_switch_what_its_writes_do_one_by_one(
    back: int, more: int
) -> None:
    text = ALL.replace("at = 40", "at = 45")
    times, latches, nibbles = there_and_back(45, back)
    # Another motor may be in it as well, and half-steps that are none.
    times, latches, nibbles = times * (1 + more), latches + [2] * more * len(latches), nibbles * 2
    order = sorted(range(len(times)), key=lambda k: times[k])
    times, latches, nibbles = ([which[k] for k in order] for which in (times, latches, nibbles))
    whole, sliced = (arm_at(text) for _ in range(2))
    whole.apply(times, latches, nibbles)
    for each in zip(times, latches, nibbles, strict=True):
        sliced.apply(*([value] for value in each))
    assert whole.rotors == sliced.rotors
    assert closed(whole) == closed(sliced)
    # The mark is two degrees up, which are 32 half-steps; the play is 16.
    assert closed(whole)[1] == (back < 45 - 32 + 16)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (
            "[[home]]\nat=0\nbit=1",
            "home[1].joint: expected one of base, shoulder, elbow, left wrist, right wrist",
        ),
        ("[[home]]\njoint='hand'\nat=0\nbit=1", "home[1].joint: expected one of base"),
        (
            "[[home]]\njoint='shoulder'\nat=-40\nbit=1",
            "home[1].at: expected a number from -35 to 144",
        ),
        ("[[home]]\njoint='base'\nbit=1", "home[1].at: expected a number from -90 to 90"),
        (
            "[[home]]\njoint='elbow'\nat=150\nbit=1",
            "home[1].at: expected a number from -184 to 144",
        ),
        (
            "[[home]]\njoint='base'\nat=0\nplay=11\nbit=1",
            "home[1].play: expected a number from 0 to 10",
        ),
        (
            "[[home]]\njoint='base'\nat=0\nbit=1\nbank=1",
            "home[1].bank: expected a [selector] in the file, whose bits choose a bank",
        ),
    ],
)
def test_a_home_switch_that_cannot_be_gets_one_line(text: str, line: str) -> None:
    assert refusal(text).startswith(f"b.toml: {line}")


def test_a_switch_is_closed_from_the_t_state_of_the_write_that_turns_its_joint_there() -> None:
    arm = arm_at("[[home]]\njoint = 'base'\nat = 0.03\nbit = 3")
    arm.apply([1000], [0], [PHASES[0]])
    assert arm.inputs(99_999) == 0b1111
    arm.apply([100_000], [0], [PHASES[1]])
    assert arm.inputs(100_000) == 0b0111
