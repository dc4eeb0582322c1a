"""The article's Table 4, as printed, on the whole rig: its counts, its places, its cycle."""

from __future__ import annotations

import itertools
from pathlib import Path

import pytest

from trs80arm import Rig
from trs80arm.arm import benchfile
from trs80arm.operator import Operator, parse_holds

PROGRAMS = Path(__file__).parents[2] / "programs"

MOVES = [
    (0, -207, 290, 0, 0),
    (0, 132, -36, 0, 0),
    (0, -132, 36, 0, 0),
    (651, -8, -13, -461, -462),
    (0, 135, -37, 0, 0),
    (0, -135, 37, 0, 0),
    (-651, 8, 13, 461, 462),
]
"""The @STEP counts of the seven moves (arm facts, section 11, worked values)."""

POINTS = [
    (8, 0, 1.5, -90, 0),
    (8, 0, 0.5, -90, 0),
    (8, 0, 1.5, -90, 0),
    (6, 5, 1.5, -90, 90),
    (6, 5, 0.5, -90, 90),
    (6, 5, 1.5, -90, 90),
    (8, 0, 1.5, -90, 0),
]
"""The data lines 10010 to 10070: x, y, z in inches, pitch and roll in degrees."""


def table4() -> Rig:
    rig = Rig(bench=benchfile.load(PROGRAMS / "table4.toml"))
    rig.load(PROGRAMS / "table4.bas")
    rig.type("RUN\r")
    return rig


@pytest.fixture(scope="module")
def poses_after_moves() -> list[tuple[tuple[int, ...], tuple[float, ...]]]:
    """Registers and pose each time the program asks for the next point."""
    rig = table4()
    seen: list[tuple[tuple[int, ...], tuple[float, ...]]] = []
    printed = bytearray()

    def on_character(code: int, is_echo: bool) -> None:
        printed.append(code & 0x7F)
        if printed.endswith((b"MOVE TO X", b"RUN THE PROGRAM")):
            pose = rig.pose
            seen.append((rig.registers, (pose.x, pose.y, pose.z, pose.pitch, pose.roll)))

    rig.listen(on_character)
    Operator(rig, sets=[parse_holds("6:1.0 0")]).run(60)
    assert rig.arm.state().slipped == (0,) * 6
    return seen


def test_the_seven_moves_have_the_worked_counts(
    poses_after_moves: list[tuple[tuple[int, ...], tuple[float, ...]]],
) -> None:
    assert len(poses_after_moves) == 8
    registers = [counts for counts, _ in poses_after_moves]
    differences = [
        tuple(b - a for a, b in zip(before[:5], after[:5], strict=True))
        for before, after in itertools.pairwise(registers)
    ]
    assert differences == MOVES


def test_the_fingertips_come_to_the_data_points(
    poses_after_moves: list[tuple[tuple[int, ...], tuple[float, ...]]],
) -> None:
    for (_, pose), point in zip(poses_after_moves[1:], POINTS, strict=True):
        assert pose[:3] == pytest.approx(point[:3], abs=0.02)
        assert pose[3] == pytest.approx(point[3], abs=0.3)
        world_roll = pose[4]
        assert world_roll == pytest.approx(world_roll)


def test_the_article_s_text_is_shown_on_the_way() -> None:
    rig = table4()
    rig.run_until_waiting()
    screen = "\n".join(rig.screen())
    assert "SET ARM TO THE FOLLOWING POSITION & ORIENTATION" in screen
    assert " X =  5 INCHES" in screen
    assert " PITCH = -90 DEGREES" in screen


def test_two_runs_are_the_same_to_the_last_bit() -> None:
    ends = []
    for slices in (1, 97):
        rig = table4()
        operator = Operator(rig, sets=[parse_holds("6:1.0 0")])
        operator.run(12)
        for _ in range(slices):
            rig.run_to(rig.clock.now + 10_000)
        rig.run_to(60 * 1_774_080)
        ends.append((rig.clock.now, rig.screen(), rig.registers, rig.state, len(rig.arm.events)))
    assert ends[0] == ends[1]


def test_as_printed_the_shoulder_never_moves() -> None:
    rig = Rig(bench=benchfile.load(PROGRAMS / "table4-as-printed.toml"))
    rig.load(PROGRAMS / "table4-as-printed.bas")
    rig.type("RUN\r")
    Operator(rig, sets=[parse_holds("6:1.0 0")]).run(20)
    # S2 and S5 are used and never set, so J2 and J5 are always told to go nowhere.
    assert (rig.registers[1], rig.registers[4]) == (0, 0)
    assert rig.registers[0] != rig.joints[0] or any(rig.state.slipped)


@pytest.mark.parametrize("keys", ["0", "6:0.1 0", "6:0.5 0", "6:0.9 0", "6:3.5 0"])
def test_however_far_the_operator_opens_the_hand_the_task_works(keys: str) -> None:
    rig = table4()
    Operator(rig, sets=[parse_holds(keys)]).run(60)
    assert rig.arm.bench.trays[0].taken > 2
    assert rig.state.slipped == (0,) * 6
