"""What happens to parts that the arm closes on, lifts, pushes and knocks over, from BASIC."""

from __future__ import annotations

import math

import pytest

from tests import statements
from tests.slices import elsewhere
from trs80arm import Rig
from trs80arm.arm import ArmSettings, EventKind, Pose, Reason, benchfile
from trs80arm.arm.bench import deep
from trs80arm.arm.contact.rotations import matrix
from trs80arm.arm.fixtures import Part
from trs80arm.arm.models import MODELS
from trs80arm.works.devices import RigSettings


def done(bench: str, *lines: str, after: float = 1.5, model: str = "minimover5") -> Rig:
    """A machine at a bench, when it has done some statements and all has come to rest."""
    settings = RigSettings(arm=ArmSettings(model=model))
    rig = statements.done(Rig(settings, benchfile.parse(bench)), *lines)
    rig.run_for(after)
    return rig


def part(rig: Rig, name: str) -> Part:
    return rig.arm.bench.parts[name]


def turned(thing: Part) -> float:
    """Degrees about the vertical, counter-clockwise."""
    m = matrix(thing.turn)
    return math.degrees(math.atan2(m[3], m[0]))


def leaning(thing: Part) -> float:
    """Degrees of its own vertical against the vertical."""
    return math.degrees(math.acos(max(-1.0, min(1.0, thing.upwards[2]))))


def arm_at(x: float, y: float, z: float, opening: float = 1.0) -> str:
    return f"[arm]\nat = [{x}, {y}, {z}]\nopening = {opening}\n"


def test_a_slender_part_a_hair_off_centre_is_taken_upright() -> None:
    rig = done(
        arm_at(8, 0, 0.6, 0.6)
        + "[[part]]\nname = 'peg'\nat = [8, 0.001]\nsize = [0.25, 0.25, 1.0]\nweight = 0.5",
        "@CLOSE 100",
        "@STEP 100,0,0,0,0,0,-20",
        "@STEP 100,0,-100,27",
    )
    assert rig.state.held == "peg"
    assert leaning(part(rig, "peg")) < 1
    assert part(rig, "peg").bottom > 0.5


@pytest.mark.parametrize(
    ("width", "height", "away", "weight"),
    [(0.25, 1.0, 0.14, 0.5), (0.3, 1.8, 0.1, 2.0), (0.2, 1.5, -0.14, 0.3)],
)
def test_a_slender_part_well_off_centre_is_pushed_tilts_and_is_set_upright_by_the_jaws(
    width: float, height: float, away: float, weight: float
) -> None:
    # One finger pushes it high up, so that it leans over to the other one.
    rig = done(
        arm_at(8, 0, 0.6, 0.6)
        + f"[[part]]\nname = 'peg'\nat = [8, {away}]\nsize = [{width}, {width}, {height}]\n"
        + f"weight = {weight}",
        "@CLOSE 100",
        "@STEP 100,0,0,0,0,0,-20",
        "@STEP 100,0,-100,27",
    )
    assert rig.state.held == "peg"
    assert leaning(part(rig, "peg")) < 1
    assert rig.pose.opening == pytest.approx(width, abs=0.01)


def test_a_plank_beyond_an_edge_falls_and_does_not_stand_on_its_end() -> None:
    rig = done(
        "[[obstacle]]\nat = [8, 0]\nsize = [2, 2, 1]\n"
        "[[part]]\nname = 'plank'\nat = [9.1, 0]\nbottom = 1\nsize = [4, 1, 0.5]"
    )
    plank = part(rig, "plank")
    assert plank.top < 2.5, "one end leans on the edge"
    assert leaning(plank) < 45
    assert plank.bottom < 0.01


def test_a_flat_part_that_loses_its_balance_lies_down() -> None:
    rig = done(
        "[[obstacle]]\nat = [8, 0]\nsize = [2, 2, 3]\n"
        "[[part]]\nname = 'tile'\nat = [9.3, 0]\nbottom = 3\nsize = [1.5, 1, 0.3]"
    )
    assert part(rig, "tile").top < 0.5


STACK = """
[[part]]
name = "lower"
at = [8, 0]
size = [0.75, 0.75, 1.0]
weight = 1
[[part]]
name = "upper"
at = [8, 0]
bottom = 1.0
size = [0.5, 0.5, 0.5]
weight = 1
"""


def test_the_lower_of_two_is_lifted_and_turned_with_what_stands_on_it() -> None:
    rig = done(
        arm_at(8, 0, 0.4) + STACK,
        "@CLOSE 100",
        "@STEP 100,0,0,0,0,0,-60",
        "@STEP 150,0,-60,16",
        "@STEP 150,164",
    )
    lower, upper = part(rig, "lower"), part(rig, "upper")
    assert rig.state.held == "lower"
    assert lower.bottom > 0.3
    assert upper.bottom == pytest.approx(lower.top, abs=0.02)
    assert turned(lower) == pytest.approx(10, abs=1)
    assert turned(upper) == pytest.approx(10, abs=2)
    assert not any(event.kind is EventKind.SLIP for event in rig.arm.events)


def test_a_stack_that_steps_out_too_far_falls_as_a_whole() -> None:
    rig = done(
        "".join(
            f"[[part]]\nname = 'block {k}'\nat = [{7 + 0.45 * k}, 0]\nbottom = {k}\n"
            "size = [1, 1, 1]\n"
            for k in range(5)
        )
    )
    assert max(each.top for each in rig.arm.bench.parts.values()) < 4.5
    assert part(rig, "block 4").bottom < 1.5


def test_a_stack_that_steps_out_a_little_stands() -> None:
    rig = done(
        "".join(
            f"[[part]]\nname = 'block {k}'\nat = [{7 + 0.1 * k}, 0]\nbottom = {k}\n"
            "size = [1, 1, 1]\n"
            for k in range(5)
        )
    )
    assert [each.bottom for each in rig.arm.bench.parts.values()] == pytest.approx(
        [0, 1, 2, 3, 4], abs=0.01
    )


def test_two_thin_parts_are_held_against_each_other() -> None:
    rig = done(
        arm_at(8, 0, 0.1, 1.2)
        + "[[part]]\nname = 'left'\nat = [8, 0.3]\nsize = [0.6, 0.2, 0.8]\nweight = 0.5\n"
        + "[[part]]\nname = 'right'\nat = [8, -0.3]\nsize = [0.6, 0.2, 0.8]\nweight = 0.5",
        "@CLOSE 100",
        "@STEP 100,0,0,0,0,0,-60",
        "@STEP 150,0,-100,27",
    )
    left, right = part(rig, "left"), part(rig, "right")
    assert left.held
    assert right.held
    assert left.place[1] - right.place[1] == pytest.approx(0.2, abs=0.02)
    assert min(left.bottom, right.bottom) > 0.3
    assert rig.pose.opening == pytest.approx(0.4, abs=0.02)


def test_a_finger_does_not_enter_a_gap_narrower_than_itself() -> None:
    rig = done(
        arm_at(8, 0, 2.0, 1.0)
        + "[[obstacle]]\nat = [8, 1.05]\nsize = [1, 1, 1]\n"
        + "[[obstacle]]\nat = [8, 0]\nsize = [1, 1, 1]\n"
        + "[[obstacle]]\nat = [8, -1.05]\nsize = [1, 1, 1]",
        "@STEP 150,0,300",
    )
    assert rig.pose.z > 0.9
    assert any(event.kind is EventKind.CONTACT for event in rig.arm.events)


def test_a_part_pushed_off_centre_turns() -> None:
    bench = arm_at(8, -1.2, 0.3, 0.0) + (
        "[[part]]\nname = 'block'\nat = [{}, 0]\nsize = [2, 0.5, 0.6]\nweight = 1"
    )
    push = "@STEP 100,200"
    off = part(done(bench.format(8.7), push), "block")
    middle = part(done(bench.format(8.0), push), "block")
    assert off.place[1] > 0.15
    assert middle.place[1] > 0.15
    assert turned(off) < -10
    assert abs(turned(middle)) < abs(turned(off)) / 2


def test_jaws_square_a_part_that_lies_askew() -> None:
    rig = done(
        arm_at(8, 0, 0.4, 1.5)
        + "[[part]]\nname = 'block'\nat = [8, 0]\nturn = 10\nsize = [0.9, 0.4, 0.8]\nweight = 1",
        "@CLOSE 100",
        "@STEP 100,0,0,0,0,0,-80",
    )
    assert rig.state.held == "block"
    assert abs(turned(part(rig, "block"))) < 1.5
    assert rig.pose.opening == pytest.approx(0.4, abs=0.02)


def test_jaws_jam_on_the_diagonal_of_a_part_that_lies_across() -> None:
    rig = done(
        arm_at(8, 0, 0.4, 2.0)
        + "[[part]]\nname = 'block'\nat = [8, 0]\nturn = 45\nsize = [0.8, 0.8, 0.8]\nweight = 1",
        "@CLOSE 100",
        "@STEP 100,0,0,0,0,0,-40",
    )
    assert rig.state.held == "block"
    assert abs(turned(part(rig, "block"))) == pytest.approx(45, abs=3)
    assert rig.pose.opening == pytest.approx(0.8 * math.sqrt(2), abs=0.03)


def test_a_bar_held_by_its_end_droops() -> None:
    rig = done(
        arm_at(6, 0, 0.25, 1.0)
        + "[[part]]\nname = 'bar'\nat = [8.8, 0]\nsize = [6, 0.5, 0.5]\nweight = 6",
        "@CLOSE 100",
        "@STEP 150,0,0,0,0,0,-40",
        "@STEP 200,0,-200,54",
    )
    assert leaning(part(rig, "bar")) > 10


def gripped_by(in_along: float, in_down: float, weight: float) -> Part:
    """A block an inch long, half an inch wide and high, that the pads meet so far in, lifted."""
    rig = done(
        arm_at(8, 0, 0.5 - in_down, 1.0)
        + f"[[part]]\nname = 'block'\nat = [{8.3 - in_along + 0.5}, 0]\nsize = [1, 0.5, 0.5]\n"
        + f"weight = {weight}",
        "@CLOSE 100",
        "@STEP 100,0,0,0,0,0,-30",
        "@STEP 150,0,-100,27",
    )
    assert rig.pose.z > 0.9
    return part(rig, "block")


def test_a_part_gripped_by_a_hair_at_its_corner_slips_away() -> None:
    block = gripped_by(0.005, 0.005, 0.5)
    assert not block.held
    assert block.bottom < 0.01


def test_a_part_gripped_by_a_hair_along_a_whole_edge_is_held_if_it_is_light() -> None:
    # Friction at both ends of the edge, 0.25 in from its middle, against weight at half an inch.
    light, heavy = gripped_by(0.005, 0.25, 0.5), gripped_by(0.005, 0.25, 6.0)
    assert light.held
    assert leaning(light) < 0.5
    assert light.bottom > 0.5
    assert not heavy.held or leaning(heavy) > 30


def test_the_farther_in_a_part_is_gripped_the_less_it_droops() -> None:
    droop = [leaning(gripped_by(far, 0.25, 6.0)) for far in (0.05, 0.2, 0.4)]
    assert droop[0] > 30 > droop[1] > 3 > droop[2]


def test_a_sweep_into_a_stack_leaves_a_heap_and_a_handful_of_events() -> None:
    rig = done(
        arm_at(8, -2, 1.5, 0.0)
        + "".join(
            f"[[part]]\nname = 'block {k}'\nat = [8, 0]\nbottom = {k}\nsize = [1, 1, 1]\n"
            for k in range(4)
        ),
        "@STEP 50,400",
        after=3.0,
    )
    blocks = list(rig.arm.bench.parts.values())
    assert all(block.asleep for block in blocks)
    assert max(block.top for block in blocks) < 3.5
    assert len({(round(b.place[0], 1), round(b.place[1], 1)) for b in blocks}) > 1
    assert 1 <= len(rig.arm.events) <= 12
    for k, block in enumerate(blocks):
        for other in blocks[:k]:
            assert not deep(block.placed[0], other.placed[0], 0.03)


EITHER = pytest.mark.parametrize("model", sorted(MODELS))


@EITHER
@pytest.mark.parametrize(
    ("weight", "delay", "pushed"),
    [(48, 150, True), (48, 50, False), (8, 60, True), (127, 60, False), (127, 300, False)],
)
def test_pushing_costs_torque(model: str, weight: float, delay: int, pushed: bool) -> None:
    rig = done(
        arm_at(8.5, -1.3, 0.4, 0.0)
        + f"[[part]]\nname = 'lead'\nat = [8.5, 0]\nsize = [1.2, 1.2, 1.5]\nweight = {weight}",
        f"@STEP {delay},200",
        model=model,
    )
    assert (part(rig, "lead").place[1] > 0.8) is pushed
    assert (rig.state.slipped[0] == 0) is pushed
    losses = {event.reason for event in rig.arm.events if event.kind is EventKind.SLIP}
    assert losses == (set() if pushed else {Reason.CONTACT})


@EITHER
@pytest.mark.parametrize(("low", "slips"), [(0.1, False), (0.2, False), (0.8, True)])
def test_pressing_on_the_table_strains_the_cables_before_it_costs_steps(
    model: str, low: float, slips: bool
) -> None:
    arm = MODELS[model]
    steps = round((0.5 + low) / arm.link * arm.drives[1].steps)
    rig = done(arm_at(10, 0, 0.5, 0.0), f"@STEP 100,0,{steps}", model=model)
    assert abs(rig.pose.z) < 0.02
    assert (rig.state.slipped[1] != 0) is slips
    pressing = [event.text for event in rig.arm.events]
    assert len(pressing) == (2 if slips else 0)
    rig = statements.done(rig, f"@STEP 100,0,-{steps}")
    assert (rig.pose.z == pytest.approx(0.5, abs=1e-3)) is not slips


@EITHER
@pytest.mark.parametrize(
    ("degrees", "aside", "answers"), [(45, 0.89, False), (45, 0.3, True), (30, 0.5, False)]
)
def test_a_tactile_pad_beside_a_slanting_bar(
    model: str, degrees: float, aside: float, answers: bool
) -> None:
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    rig = done(
        f"[[part]]\nname = 'bar'\nat = [8, 2]\nsize = [4, 0.5, 0.5]\nturn = {degrees}\n"
        + f"[[tactile]]\nbit = 2\nat = [{8 + c - aside * s}, {2 + s + aside * c}]\n"
        + "size = [0.2, 0.2]\nheight = 0",
        "LPRINT INP(152) AND 4",
        model=model,
    )
    assert int(rig.printer.text) == (0 if answers else 4)


@EITHER
@pytest.mark.parametrize("aside", [0.0, 0.11, 0.23, 0.31])
def test_switched_on_after_it_was_moved_by_hand_the_arm_is_off_by_five_at_most(
    model: str, aside: float
) -> None:
    rig = done("", "@STEP 100,8,-8,8,8,8,8", "@RESET", model=model)
    rig.move_to(Pose(6 + aside, aside, 1 + aside, -85, 3, 1 + aside))
    before = rig.arm.rotors
    statements.done(rig, "@STEP 100,1,1,1,1,1", "@STEP 100,1,1,1,1,1")
    moved = [now - then for now, then in zip(rig.arm.rotors, before, strict=True)]
    assert rig.registers[:5] == (2,) * 5
    assert max(abs(count - 2) for count in moved[:5]) <= 5
    assert len(set(moved)) > 1, "the registers know nothing of that"


@EITHER
def test_a_forearm_at_its_stop_is_one_event(model: str) -> None:
    way = MODELS[model].drives[2].sign
    rig = done("", f"@STEP 100,0,0,{-900 * way}", model=model)
    (event,) = [event for event in rig.arm.events if event.motor == 2]
    assert (event.kind, event.reason) == (EventKind.SLIP, Reason.STOP)
    assert event.count > 30


def test_a_fall_takes_its_time_on_the_clock() -> None:
    rig = done(
        arm_at(8, 0, 0.5, 1.0) + "[[part]]\nname = 'block'\nat = [8, 0]\nsize = [0.5, 0.5, 1]",
        "@CLOSE 100",
        "@STEP 100,0,0,0,0,0,-30",
        "@STEP 100,0,-264,72",
        after=0.5,
    )
    rig.type("@STEP 50,0,0,0,0,0,60\r")
    heights = []
    while len(heights) < 400 and (not heights or part(rig, "block").bottom > 0.01):
        rig.run_for(1 / 60)
        heights.append(part(rig, "block").bottom)
    falling = [height for height in heights if 0.05 < height < heights[0] - 0.05]
    assert 3 <= len(falling) <= 12, "two inches take a tenth of a second"


def test_a_snapshot_in_the_middle_of_a_fall_and_of_a_push_goes_on_as_if_there_were_none() -> None:
    bench = arm_at(8, -2, 1.5, 0.0) + "".join(
        f"[[part]]\nname = 'block {k}'\nat = [8, 0]\nbottom = {k}\nsize = [1, 1, 1]\n"
        for k in range(3)
    )
    rig = Rig(bench=benchfile.parse(bench))
    rig.type("@STEP 50,400\r")
    middles = 0
    for _ in range(8):
        rig.run_for(12 / 60)
        other = elsewhere(rig)
        middles += any(not each.asleep for each in rig.arm.bench.parts.values())
        rig.run_for(3 / 60)
        for _ in range(3):
            other.run_for(1 / 60)
        assert other.snapshot() == rig.snapshot()
    assert middles >= 2, "something was moving"
