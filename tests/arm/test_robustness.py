"""No state of arm or bench raises an exception or puts a part where no part can be."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass

from hypothesis import given, settings
from hypothesis import strategies as st

from trs80arm.arm import Bench, InTheWay, MiniMover, MotorsOn, OutOfReach, Pose
from trs80arm.arm.bench import deep
from trs80arm.arm.cell.home import JOINTS, HomeSwitch
from trs80arm.arm.cell.inputs import Answering, Selector
from trs80arm.arm.cell.mounted import Face, ForceSensor, PalmProximity, TactilePad, Tension
from trs80arm.arm.cell.sensors import LightBeam, Proximity, Tactile
from trs80arm.arm.cell.turntable import Turntable
from trs80arm.arm.contact.table import Plate
from trs80arm.arm.fixtures import Feeder, Obstacle, Tray
from trs80arm.arm.linkage import FINGERS
from trs80arm.arm.model import Link
from trs80arm.arm.motors import PHASES
from trs80arm.arm.shapes import upright
from trs80arm.arm.stepping import PulseGenerator

RESTING, TUMBLING = 0.03, 0.15
"""Inches to which parts may be found in each other at rest, and when something tumbles or jams."""


def random_bench(chance: random.Random) -> Bench:
    """Up to eight parts of all sizes around the place where the arm works, and fixtures."""
    bench = Bench("random")
    for k in range(chance.randrange(3)):
        size = tuple(chance.uniform(0.2, 4) for _ in range(3))
        x, y, turn = chance.uniform(3, 14), chance.uniform(-10, 10), chance.uniform(0, 3)
        box = upright(x, y, 0.0, (size[0], size[1], size[2]), turn)
        obstacle = Obstacle(f"obstacle {k}", box)
        if bench.room_for(obstacle.placed):
            bench.obstacles.append(obstacle)
    for k in range(chance.randrange(9)):
        x, y, turn = chance.uniform(4, 10), chance.uniform(-4, 4), chance.uniform(0, 3)
        bottom = chance.choice([0.0, 0.0, 1.0, 3.0])
        size = tuple(chance.uniform(0.2, 1.8) for _ in range(3))
        sizes = (size[0], size[1], size[2])
        if bench.room_for(Obstacle("part", upright(x, y, bottom, sizes, turn)).placed):
            weight = chance.choice([0.5, 2.0, 8.0, 30.0, 200.0])
            bench.add_part(f"part {k}", sizes, weight, x, y, bottom, turn)
    feeder = Feeder("feeder", 8.0, 0.0, 0.0, (0.5, 0.5, 1.0), 2.0)
    if chance.random() < 0.5 and bench.room_for(feeder.placed):
        bench.feeders.append(feeder)
    if chance.random() < 0.5:
        bench.trays.append(Tray("tray", 6.0, 5.0, 2.0, 2.0))
    if chance.random() < 0.5:
        bench.cell.devices.append(Turntable("turntable", Plate(6.0, -2.0, 3.0)))
    bench.selector = Selector((0, 1, 2, 3))
    for k in range(chance.randrange(13)):
        bench.sensors.append(random_sensor(chance, f"sensor {k}", chance.randrange(1, 4), k))
    return bench


def random_sensor(chance: random.Random, name: str, bit: int, bank: int) -> Answering:
    """Any sensor that there is, anywhere."""
    place = chance.uniform(4, 10), chance.uniform(-4, 4), chance.uniform(0, 2)
    wired, ounces = (name, bit, bank), chance.choice([0.1, 1.0, 10.0])
    link = chance.choice(list(Link))
    face = chance.choice(list(Face)) if link in FINGERS else None
    mark = chance.uniform(-1, 1)
    joint = chance.choice(list(JOINTS.values()))
    return chance.choice(
        [
            Proximity(bit, place, chance.uniform(0.1, 4), name, bank),
            Tactile(bit, upright(*place, (1.0, 1.0, 0.1), 0.0), name, bank),
            LightBeam(bit, place, (8.0, 5.0, 1.0), name, bank),
            TactilePad(*wired, link, face, ounces),
            PalmProximity(*wired, chance.uniform(0.1, 4)),
            ForceSensor(*wired, chance.choice(list(Tension)), ounces),
            HomeSwitch(*wired, joint, mark, chance.uniform(0, 0.1)),
        ]
    )


def assert_possible(arm: MiniMover) -> None:
    """Every part is on or above the table, inside nothing, and within the room."""
    parts = list(arm.bench.parts.values())
    for i, part in enumerate(parts):
        assert all(math.isfinite(value) for value in part.place)
        assert max(abs(value) for value in part.place) < 200
        assert part.bottom > -TUMBLING
        for other in parts[:i]:
            depth = RESTING if part.asleep and other.asleep else TUMBLING
            assert not any(deep(a, b, depth) for a in part.placed for b in other.placed)
        for obstacle in (*arm.bench.obstacles, *arm.bench.cell.obstacles):
            for box in obstacle.placed:
                assert not any(deep(solid, box, TUMBLING) for solid in part.placed)
    state = arm.state()
    assert state.pose.z > -0.2
    assert 0 <= state.pose.opening <= 3
    assert 0 <= state.force <= 3 + 4 / 52
    time = arm.world.due - 1
    selector, nibble = arm.bench.selector, arm.bench.cell.nibble
    bank = 0 if selector is None else selector.bank(nibble)
    shown = 0
    for answer in arm.answers(time):
        shown |= (answer.given and answer.bank == bank) << answer.bit
    assert arm.inputs(time) & 0b1110 == 0b1110 & ~shown
    held = [part.name for part in parts if part.held]
    assert (state.held in held) if held else state.held is None


@dataclass
class Operator:
    """Someone who does anything that can be done to an arm."""

    chance: random.Random
    generator: PulseGenerator

    def act(self) -> None:
        chance, generator = self.chance, self.generator
        arm = generator.arm
        choice = chance.randrange(8)
        period = chance.choice([2100, 4800, 4800, 9000])
        if choice == 0:
            generator.close(3600, chance.randrange(160))
        elif choice == 1:
            generator.off()
            self.place(chance.uniform(3, 12), chance.uniform(-5, 5), chance.uniform(0, 4))
        elif choice == 2 and arm.bench.parts:
            generator.off()
            x, y, z = chance.choice(list(arm.bench.parts.values())).place
            self.place(x, y, max(z, 0.3), opening=3.0)
            generator.align()
            generator.close(3600, chance.randrange(120))
        elif choice == 3:
            generator.turn(5, chance.randrange(-900, 900), period)
        elif choice == 4:
            self.write([6] * 60, [PHASES[i * chance.choice([1, -1]) % 8] for i in range(60)])
        elif choice == 5:
            latches = [chance.randrange(7) for _ in range(60)]
            self.write(latches, [chance.randrange(16) for _ in range(60)])
        else:
            counts = [chance.randrange(-250, 250) * chance.randrange(2) for _ in range(6)]
            generator.step(counts, period, compensate=chance.randrange(2))

    def write(self, latches: list[int], nibbles: list[int]) -> None:
        wait = self.chance.choice([300, 5000])
        times = [self.generator.time + wait * i for i in range(len(latches))]
        self.generator.arm.apply(times, latches, nibbles)
        self.generator.time = times[-1] + wait

    def place(self, x: float, y: float, z: float, opening: float | None = None) -> None:
        chance = self.chance
        pitch, roll = chance.choice([-90.0, -90.0, -60.0, 0.0]), chance.uniform(-90, 90)
        opening = chance.uniform(0, 3) if opening is None else opening
        try:
            self.generator.arm.move_to(Pose(x, y, z, pitch, roll, opening))
        except (MotorsOn, InTheWay, OutOfReach, ValueError):
            return


@settings(max_examples=5, deadline=None, derandomize=True)
@given(st.integers(0, 10**9))
def test_whatever_is_done_every_part_stays_where_a_part_can_be(seed: int) -> None:
    chance = random.Random(seed)
    arm = MiniMover(bench=random_bench(chance))
    operator = Operator(chance, PulseGenerator(arm))
    assert_possible(arm)
    for _ in range(10):
        operator.act()
        assert_possible(arm)


@settings(max_examples=10, deadline=None, derandomize=True)
@given(st.integers(0, 10**9))
def test_whatever_stands_on_a_bench_comes_to_rest(seed: int) -> None:
    chance = random.Random(seed)
    arm = MiniMover(bench=random_bench(chance))
    for _ in range(3):
        if arm.bench.parts:
            arm.bench.scene.remove(chance.choice(list(arm.bench.parts)))
        arm.bench.settle()
        assert_possible(arm)
    before = {part.name: part.place for part in arm.bench.parts.values()}
    arm.bench.settle()
    for part in arm.bench.parts.values():
        assert math.dist(part.place, before[part.name]) < 0.02


@settings(max_examples=3, deadline=None, derandomize=True)
@given(st.integers(0, 10**9))
def test_rummaging_in_a_heap_leaves_every_part_where_a_part_can_be(seed: int) -> None:
    chance = random.Random(seed)
    bench = Bench("heap")
    for k in range(7):
        size = (
            chance.choice([0.5, 1.0, 1.5]),
            chance.choice([0.5, 1.0]),
            chance.choice([0.5, 2.0]),
        )
        x, y = 8 + chance.uniform(-0.6, 0.6), chance.uniform(-0.6, 0.6)
        bottom, turn = chance.uniform(0, 5), chance.choice([0.0, chance.uniform(0, 3)])
        if bench.room_for(Obstacle("part", upright(x, y, bottom, size, turn)).placed):
            bench.add_part(f"part {k}", size, chance.choice([1.0, 4.0, 10.0]), x, y, bottom, turn)
    generator = PulseGenerator(MiniMover(bench=bench))
    operator = Operator(chance, generator)
    for _ in range(6):
        generator.off()
        x, y, z = chance.choice(list(bench.parts.values())).place
        operator.place(x + chance.uniform(-0.1, 0.1), y, z, opening=chance.uniform(0.6, 2))
        generator.align()
        generator.close(3600, chance.randrange(150))
        assert_possible(generator.arm)
        for _ in range(3):
            counts = [chance.randrange(-150, 150) * chance.randrange(2) for _ in range(5)]
            generator.step(counts, chance.choice([4800, 9000]))
            assert_possible(generator.arm)
        generator.turn(5, chance.randrange(300), 4800)
        assert_possible(generator.arm)
