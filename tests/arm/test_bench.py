"""The bench: parts fall, stack, are pushed and carried; feeders, trays, sensors, turntable."""

from __future__ import annotations

import math

import pytest

from trs80arm import Rig
from trs80arm.arm import (
    ArmEvent,
    ArmSettings,
    Bench,
    BenchError,
    EventKind,
    InTheWay,
    MiniMover,
    Pose,
    Reason,
    benchfile,
)
from trs80arm.arm.bench import deep
from trs80arm.arm.cell.turntable import Turntable
from trs80arm.arm.motors import PHASES
from trs80arm.arm.stepping import PulseGenerator, delay_period
from trs80arm.works.devices import RigSettings

D50 = delay_period(50)
EASY = delay_period(200)
CUBE = (1.0, 1.0, 1.0)
CLOSE = 0.002
"""Inches to which things at rest are known where they should be."""


def ready(bench: Bench, pose: Pose) -> PulseGenerator:
    arm = MiniMover(bench=bench)
    arm.move_to(pose)
    generator = PulseGenerator(arm)
    generator.align()
    return generator


def texts(arm: MiniMover, kind: EventKind) -> list[ArmEvent]:
    return [event for event in arm.events if event.kind is kind]


def test_a_part_in_the_air_falls_when_the_bench_is_set_up() -> None:
    bench = Bench("air")
    bench.add_part("cube", CUBE, 2.0, 8.0, 0.0, bottom=3.0)
    MiniMover(bench=bench)
    assert bench.parts["cube"].bottom == pytest.approx(0, abs=CLOSE)


def test_parts_stack() -> None:
    bench = Bench("stack")
    for k in range(3):
        bench.add_part(f"cube {k}", CUBE, 2.0, 8.0 + 0.1 * k, 0.0, bottom=2.0 * k)
    bench.settle()
    assert [p.bottom for p in bench.parts.values()] == pytest.approx([0, 1, 2], abs=CLOSE)


def test_a_part_over_an_edge_falls_beside() -> None:
    bench = Bench("edge")
    bench.add_part("low", CUBE, 2.0, 8.0, 0.0)
    bench.add_part("high", (1.0, 1.0, 2.0), 2.0, 8.7, 0.0, bottom=1.0)
    bench.settle()
    high, low = bench.parts["high"], bench.parts["low"]
    assert high.bottom == pytest.approx(0, abs=CLOSE)
    assert not any(deep(a, b, CLOSE) for a in high.placed for b in low.placed)
    assert high.top == pytest.approx(1.0, abs=CLOSE)
    assert high.place[0] > 9.0


def test_a_bridge_holds() -> None:
    bench = Bench("bridge")
    bench.add_part("left", CUBE, 2.0, 8.0, -1.5)
    bench.add_part("right", CUBE, 2.0, 8.0, 1.5)
    bench.add_part("deck", (1.0, 4.0, 0.5), 2.0, 8.0, 0.0, bottom=1.0)
    bench.settle()
    assert bench.parts["deck"].bottom == pytest.approx(1.0, abs=CLOSE)


def test_taking_the_lowest_away_lets_the_others_down() -> None:
    bench = Bench("stack")
    for k in range(3):
        bench.add_part(f"cube {k}", CUBE, 2.0, 8.0, 0.0, bottom=float(k))
    bench.scene.remove("cube 0")
    bench.settle()
    assert [p.bottom for p in bench.parts.values()] == pytest.approx([0, 1], abs=CLOSE)


def test_the_hand_pushes_a_part_aside() -> None:
    bench = Bench("one")
    bench.add_part("cube", CUBE, 2.0, 8.0, 1.0)
    generator = ready(bench, Pose(8.0, -0.5, 0.3, -90.0, 0.0))
    generator.turn(0, 150, D50)
    generator.wait(1.0)
    assert generator.arm.state().slipped == (0,) * 6
    assert bench.parts["cube"].place[1] > 1.2
    assert texts(generator.arm, EventKind.PUSHED)


def test_a_tall_part_pushed_high_up_falls_over() -> None:
    bench = Bench("one")
    bench.add_part("column", (0.5, 0.5, 3.0), 2.0, 8.0, 1.0)
    generator = ready(bench, Pose(8.0, -0.5, 2.5, -90.0, 0.0))
    generator.turn(0, 200, D50)
    generator.wait(2.0)
    column = bench.parts["column"]
    assert column.top == pytest.approx(0.5, abs=CLOSE)
    assert column.bottom == pytest.approx(0, abs=CLOSE)
    assert texts(generator.arm, EventKind.TOPPLED)


def test_a_heavy_part_blocks_the_arm() -> None:
    bench = Bench("one")
    bench.add_part("anvil", CUBE, 200.0, 8.0, 1.0)
    generator = ready(bench, Pose(8.0, -0.5, 0.3, -90.0, 0.0))
    generator.turn(0, 150, D50)
    assert generator.arm.state().slipped[0] < 0
    assert bench.parts["anvil"].place[1] == pytest.approx(1.0, abs=CLOSE)


def test_a_pushed_part_pushes_the_next_until_something_fixed() -> None:
    bench = benchfile.parse(
        """
        [[part]]
        at = [8, 1]
        size = [1, 1, 1]
        [[part]]
        at = [8, 2.1]
        size = [1, 1, 1]
        [[obstacle]]
        at = [8, 3.5]
        size = [3, 1, 1]
        """
    )
    generator = ready(bench, Pose(8.0, -0.5, 0.3, -90.0, 0.0))
    generator.turn(0, 350, D50)
    first, second = bench.parts.values()
    assert second.place[1] == pytest.approx(2.5, abs=0.1)
    assert not any(deep(a, b, 0.01) for a in first.placed for b in second.placed)
    assert generator.arm.state().slipped[0] < 0


@pytest.mark.parametrize("pose", [Pose(8.0, 0.0, 0.2, -90.0, 0.0), Pose(8.0, 0.0, 0.2, -45.0, 0.0)])
def test_the_table_blocks_the_arm(pose: Pose) -> None:
    generator = ready(Bench("empty"), pose)
    generator.turn(1, 120, EASY)
    arm = generator.arm
    assert -0.04 < arm.state().pose.z < 0.25
    assert texts(arm, EventKind.SLIP)[0].reason is Reason.CONTACT
    assert "the table" in texts(arm, EventKind.CONTACT)[0].text


def test_its_own_base_blocks_the_arm() -> None:
    generator = ready(Bench("empty"), Pose(0.3, 3.6, 0.5, -90.0, 0.0))
    generator.turn(2, -100, EASY)
    assert "base" in texts(generator.arm, EventKind.CONTACT)[0].text
    assert generator.arm.state().pose.y > 2.9


def test_a_stack_blocks_what_is_carried_down_on_it() -> None:
    bench = Bench("stack")
    bench.add_part("top", CUBE, 2.0, 8.0, 0.0, bottom=0.0)
    bench.add_part("pile", (1.0, 1.0, 2.0), 30.0, 8.0, 3.0)
    generator = ready(bench, Pose(8.0, 0.0, 0.5, -90.0, 0.0, 1.5))
    arm = generator.arm
    generator.close(D50, 60)
    generator.off()
    arm.move_to(Pose(8.0, 3.0, 3.0, -90.0, 0.0, 0.9))
    generator.align()
    assert arm.state().held == "top"
    generator.turn(1, 200, EASY)
    generator.wait(0.5)
    # What friction holds slides up between the fingers before anything else gives way.
    assert arm.state().held == "top"
    assert bench.parts["top"].top > 2.7
    assert arm.state().pose.z < 2.2
    top, pile = bench.parts["top"], bench.parts["pile"]
    assert not any(deep(a, b, 0.01) for a in top.placed for b in pile.placed)


def test_a_feeder_gives_the_next_part_when_the_hand_is_clear() -> None:
    bench = benchfile.parse(
        """
        [[feeder]]
        name = "screw"
        at = [8, 0]
        size = [0.5, 0.5, 1.0]
        count = 2
        """
    )
    generator = ready(bench, Pose(8.0, 0.0, 0.5, -90.0, 0.0, 0.8))
    arm = generator.arm
    assert list(bench.parts) == ["screw 1"]
    generator.close(D50, 20)
    generator.step((0, -132, 36), EASY)
    assert list(bench.parts) == ["screw 1"]
    generator.turn(0, 500, D50)
    assert list(bench.parts) == ["screw 1", "screw 2"]
    assert texts(arm, EventKind.FED)


def test_a_tray_takes_only_what_is_let_go() -> None:
    bench = benchfile.parse(
        """
        [[tray]]
        at = [8, 0]
        size = [2, 2]
        [[part]]
        at = [8, 3]
        size = [0.5, 0.5, 1]
        """
    )
    generator = ready(bench, Pose(8.0, 3.0, 0.5, -90.0, 0.0, 0.8))
    generator.close(D50, 30)
    angle = math.atan2(3, 8)
    generator.step((-round(angle * 937.8), -30, 0), EASY)
    assert generator.arm.state().held == "part 1"
    assert bench.trays[0].taken == 0
    generator.turn(5, 200, D50)
    generator.wait(0.5)
    assert bench.trays[0].taken == 1
    assert not bench.parts
    assert generator.arm.state().held is None


def test_sensors_answer_on_their_bits() -> None:
    bench = benchfile.parse(
        """
        [[proximity]]
        bit = 1
        at = [8, 0, 0]
        range = 1.0
        [[tactile]]
        bit = 2
        at = [4, 6]
        size = [1, 1]
        [[beam]]
        bit = 3
        from = [2, -6, 0.5]
        to = [12, -6, 0.5]
        """
    )
    arm = MiniMover(bench=bench)
    assert arm.inputs(0) == 0b1111
    arm.move_to(Pose(8, 0, 0.5, -90, 0))
    assert arm.inputs(0) == 0b1101
    arm.move_to(Pose(6, 0, 3, -90, 0))
    bench.add_part("on the pad", CUBE, 2.0, 4.0, 6.0)
    arm.advance(0)
    assert arm.inputs(0) == 0b1011
    bench.add_part("in the beam", CUBE, 2.0, 6.0, -6.0)
    assert arm.inputs(0) == 0b0011
    arm.bench.scene.clear()
    arm.move_to(Pose(6, -6, 0.2, -90, 0))
    assert arm.inputs(0) == 0b0111


def test_a_tactile_pad_answers_to_what_stands_on_it_not_to_the_box_around_that() -> None:
    bench = benchfile.parse(
        """
        [[tactile]]
        bit = 2
        at = [4, 5]
        size = [1, 1]
        """
    )
    arm = MiniMover(bench=bench)
    bar = bench.add_part("bar", (3.0, 0.2, 0.5), 1.0, 5.2, 3.8, turn=math.pi / 4)
    assert arm.inputs(0) == 0b1111
    bar.put((bar.place[0] - 0.9, bar.place[1] + 0.9, bar.place[2]), bar.turn)
    assert arm.inputs(0) == 0b1011


def test_the_auxiliary_latch_turns_the_turntable_and_what_stands_on_it() -> None:
    bench = benchfile.parse(
        """
        [turntable]
        at = [6, 4]
        radius = 2
        steps = 96
        [[part]]
        at = [7, 4]
        size = [0.5, 0.5, 0.5]
        [[part]]
        at = [9, 4]
        size = [0.5, 0.5, 0.5]
        """
    )
    generator = PulseGenerator(MiniMover(bench=bench))
    turn_table(generator, 24)
    on, off = (part.place for part in bench.parts.values())
    assert on[:2] == pytest.approx((6, 5), abs=0.1)
    assert off[:2] == pytest.approx((9, 4), abs=CLOSE)


def turn_table(generator: PulseGenerator, steps: int) -> None:
    generator.arm.apply(
        [EASY * i for i in range(steps + 1)],
        [6] * (steps + 1),
        [PHASES[i % 8] for i in range(steps + 1)],
    )
    generator.time = EASY * steps
    generator.wait(1.0)


def test_what_stands_in_the_way_of_a_part_on_the_turntable_lets_it_slide() -> None:
    bench = benchfile.parse(
        """
        [turntable]
        at = [6, 4]
        radius = 2
        steps = 96
        [[part]]
        at = [7.5, 4]
        size = [0.5, 0.5, 0.5]
        [[obstacle]]
        at = [6, 5.5]
        size = [0.5, 0.5, 1]
        """
    )
    turn_table(PulseGenerator(MiniMover(bench=bench)), 40)
    (part,) = bench.parts.values()
    (table,) = bench.cell.devices
    assert isinstance(table, Turntable)
    assert table.rotor == 40
    assert part.place[0] > 6.2, "the obstacle holds it back"
    assert math.dist(part.place[:2], (6, 4)) > 0.5


def test_the_hand_in_the_way_of_a_part_on_the_turntable_lets_it_slide() -> None:
    bench = benchfile.parse(
        """
        [turntable]
        at = [7, 0]
        radius = 2
        steps = 96
        [[part]]
        at = [8.5, 0]
        size = [0.5, 0.5, 2]
        """
    )
    generator = PulseGenerator(MiniMover(bench=bench))
    generator.arm.move_to(Pose(7, 1.5, 0.5, -90, 0))
    turn_table(generator, 40)
    (part,) = bench.parts.values()
    assert part.place[0] > 7.2
    assert not deep(part.placed[0], generator.arm.world.bench.scene.link_solids[3], 0.01)


def test_refilling_puts_everything_back() -> None:
    bench = Bench.standard()
    generator = ready(bench, Pose(8.0, 0.0, 0.5, -90.0, 0.0, 0.8))
    generator.close(D50, 30)
    generator.step((100, -100, 0), EASY)
    generator.arm.refill()
    assert generator.arm.state().held is None
    assert bench.parts["block"].place == pytest.approx((8, 0, 0.5), abs=CLOSE)


def test_parts_are_not_put_back_into_the_arm() -> None:
    bench = Bench.standard()
    generator = ready(bench, Pose(8.0, 1.5, 0.3, -90.0, 0.0, 0.0))
    generator.turn(0, -170, EASY)
    pushed = bench.parts["block"].place
    assert pushed[1] < -0.1
    with pytest.raises(InTheWay, match="it stands where block was"):
        generator.arm.refill()
    assert bench.parts["block"].place == pushed
    generator.turn(0, 170, EASY)
    generator.arm.refill()
    assert bench.parts["block"].place == pytest.approx((8, 0, 0.5), abs=CLOSE)


def test_what_falls_while_the_bench_is_set_up_does_not_fall_through_the_arm() -> None:
    bench = benchfile.parse(
        """
        [arm]
        at = [8, 0, 0.5]
        [[part]]
        name = "board"
        at = [8, 0]
        bottom = 12
        size = [2, 2, 0.5]
        """
    )
    arm = MiniMover(bench=bench)
    board = bench.parts["board"]
    assert board.asleep
    for link in arm.world.bench.scene.link_solids:
        assert not any(deep(link, solid, 0.01) for solid in board.placed)


def test_a_bench_that_the_arm_cannot_stand_at_changes_nothing() -> None:
    rig = Rig(RigSettings(arm=ArmSettings(model="teachmover")))
    rig.type("@STEP 100,50\r")
    rig.run_until_waiting()
    before = rig.snapshot()
    with pytest.raises(BenchError, match="that the TeachMover can reach"):
        rig.set_bench(benchfile.parse("[arm]\nat = [3.9, 0, 16]\npitch = 0\n"))
    assert rig.snapshot() == before
