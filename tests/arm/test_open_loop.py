"""Table 4's motions on its bench, two hundred times, and what happens when they fail."""

from __future__ import annotations

from pathlib import Path

import pytest

from trs80arm.arm import Bench, EventKind, MiniMover, benchfile
from trs80arm.arm.models import MINIMOVER5
from trs80arm.arm.stepping import PulseGenerator, delay_period

PROGRAMS = Path(__file__).parents[2] / "programs"

CYCLES = 200
MOVES = (
    # @STEP of Table 4's data lines, the grip that follows, the delay (fact sheet, worked values)
    ((0, -207, 290, 0, 0), 0, 50),
    ((0, 132, -36, 0, 0), -30, 50),
    ((0, -132, 36, 0, 0), 0, 100),
    ((651, -8, -13, -461, -462), 0, 50),
    ((0, 135, -37, 0, 0), 300, 50),
    ((0, -135, 37, 0, 0), 0, 50),
    ((-651, 8, 13, 461, 462), 0, 50),
)


def move(generator: PulseGenerator, line: int, delay: int | None = None) -> None:
    counts, grip, own = MOVES[line]
    speed = delay_period(own if delay is None else delay)
    generator.step(counts, speed)
    if grip < 0:
        generator.close(delay_period(50), -grip)
    elif grip > 0:
        generator.step((0, 0, 0, 0, 0, grip), speed)


def table4(opening: int = 370) -> PulseGenerator:
    """The arm at the initialization point, its hand opened in @SET."""
    generator = PulseGenerator(MiniMover(bench=benchfile.load(PROGRAMS / "table4.toml")))
    generator.step((0, 0, 0, 0, 0, opening), delay_period(50))
    return generator


def test_table_4_runs_200_cycles_without_losing_a_step() -> None:
    generator = table4()
    arm = generator.arm
    move(generator, 0)
    above_pickup = arm.state().angles
    for _ in range(CYCLES):
        for line in range(1, 7):
            move(generator, line)
    state = arm.state()
    assert state.slipped == (0,) * 6
    assert state.angles == above_pickup
    assert arm.bench.trays[0].taken == CYCLES
    assert not any(event.kind is EventKind.SLIP for event in arm.events)
    assert [part.name for part in arm.bench.parts.values()] == [f"part {CYCLES + 1}"]


def test_at_full_speed_it_slips_and_misses_the_part() -> None:
    generator = table4()
    arm = generator.arm
    for line in range(7):
        move(generator, line, 0)
    assert arm.bench.trays[0].taken == 0
    assert any(event.kind is EventKind.SLIP for event in arm.events)
    registers = generator.counts
    assert registers[1] == -207
    assert abs(arm.rotors[1] - registers[1]) > 100
    assert all(
        (rotor - field) % 8 == 0
        for rotor, field in zip(arm.state().rotors, arm.state().fields, strict=True)
    )


def test_a_closed_hand_comes_down_on_the_part() -> None:
    # The data print the hand closed at the start: unless the operator opens it, the first pick
    # fails, and the arm says so.
    generator = table4(opening=0)
    arm = generator.arm
    for line in range(2):
        move(generator, line)
    assert arm.state().held is None
    assert any(event.kind is EventKind.CONTACT for event in arm.events)
    assert arm.state().slipped[1] != 0


def test_all_movements_are_made_open_loop() -> None:
    # "all arm movements are made 'open loop,' or without position feedback. Therefore, a
    # re-initialization is necessary if the arm is unable to successfully perform a movement due
    # to overloading or collision."
    generator = table4()
    arm = generator.arm
    move(generator, 0)
    right = arm.state().angles
    generator.step((0, 500, 0), delay_period(50))
    generator.step((0, -500, 0), delay_period(50))
    assert generator.counts[1] == -207
    wrong = arm.state().angles
    assert wrong.shoulder - right.shoulder == pytest.approx(
        -arm.state().slipped[1] / 937.8, abs=1e-9
    )
    assert arm.state().slipped[1] < -8
    # @RESET and a move by hand make register and arm agree again.
    generator.off()
    arm.move_joints(right)
    generator.align()
    assert arm.state().slipped == (0,) * 6
    generator.step(MOVES[1][0], delay_period(50))
    assert arm.state().slipped == (0,) * 6
    assert arm.state().pose.z == pytest.approx(0.5, abs=0.02)


def block_tower(moved: float = 0.0) -> PulseGenerator:
    """Four one-inch blocks side by side, the hand open above the table."""
    bench = Bench("blocks")
    for k in range(4):
        y = -4.5 + 2.25 * k + (moved if k == 2 else 0.0)
        bench.add_part(f"block {k + 1}", (1.0, 1.0, 1.0), 2.0, 9.0, y)
    return PulseGenerator(MiniMover(bench=bench))


def carry(generator: PulseGenerator, source: tuple[float, ...], target: tuple[float, ...]) -> None:
    """Pick up at one place and set down at another, both (x, y, z), the hand straight down."""
    from trs80arm.arm.geometry import inverse

    period = delay_period(60)
    for (x, y, z), squeeze in ((source, 40), (target, 0)):
        high = max(source[2], target[2]) + 1.6
        generator.go(inverse(MINIMOVER5, x, y, high, -90, 0), period)
        if squeeze:
            generator.step((0, 0, 0, 0, 0, 300), period)
        generator.go(inverse(MINIMOVER5, x, y, z, -90, 0), delay_period(100))
        if squeeze:
            generator.close(delay_period(50), squeeze)
        else:
            generator.step((0, 0, 0, 0, 0, 200), period)
        generator.go(inverse(MINIMOVER5, x, y, high, -90, 0), delay_period(100))


def build(generator: PulseGenerator) -> None:
    generator.step((0, 0, 0, 0, 0, 640), delay_period(50))
    for k in range(4):
        carry(generator, (9.0, -4.5 + 2.25 * k, 0.6), (6.5, 4.0, k + 0.62))


def test_a_tower_of_four_blocks_is_built_and_taken_down() -> None:
    generator = block_tower()
    arm = generator.arm
    build(generator)
    parts = arm.bench.parts
    heights = [parts[f"block {k + 1}"].bottom for k in range(4)]
    assert heights == pytest.approx([0, 1, 2, 3], abs=1e-4)
    assert arm.state().slipped == (0,) * 6
    for k in (3, 2, 1, 0):
        carry(generator, (6.5, 4.0, k + 0.6), (9.0, -4.5 + 2.25 * k, 0.62))
    heights = [parts[f"block {k + 1}"].bottom for k in range(4)]
    assert heights == pytest.approx([0, 0, 0, 0], abs=1e-4)
    assert arm.state().slipped == (0,) * 6


def test_a_block_moved_by_an_inch_spoils_the_tower() -> None:
    generator = block_tower(moved=1.0)
    arm = generator.arm
    build(generator)
    heights = sorted(part.bottom for part in arm.bench.parts.values())
    assert heights[-1] < 2.9
