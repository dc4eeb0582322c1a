"""Events tell a story: one for one happening, however long."""

from __future__ import annotations

from trs80arm.arm import Bench, EventKind, JointAngles, MiniMover, Pose, Reason
from trs80arm.arm.motors import T_STATES_PER_SECOND
from trs80arm.arm.stepping import PulseGenerator, delay_period


def test_a_joint_at_its_stop_is_one_event_with_its_end() -> None:
    generator = PulseGenerator(MiniMover(bench=Bench("empty")))
    generator.arm.move_joints(JointAngles(0.0, 1.0, 0.9, 0.0, 0.0))
    generator.align()
    generator.turn(2, 400, delay_period(100))
    (event,) = generator.arm.events
    assert (event.kind, event.reason) == (EventKind.SLIP, Reason.STOP)
    assert abs(event.steps - generator.arm.state().slipped[2]) < 8
    assert event.count == -event.steps // 8
    assert event.time < event.until <= generator.time
    assert event.text == f"elbow slipped {-event.steps} steps: at its stop"


def test_pressing_on_something_says_how_hard() -> None:
    generator = PulseGenerator(MiniMover(bench=Bench("empty")))
    generator.arm.move_to(Pose(8.0, 0.0, 0.5, -90.0, 0.0))
    generator.align()
    generator.turn(1, 250, delay_period(200))
    kinds = [event.kind for event in generator.arm.events]
    assert kinds == [EventKind.CONTACT, EventKind.SLIP]
    contact = generator.arm.events[0]
    assert contact.force > 50
    assert contact.text == f"shoulder blocked by the table, at {contact.force:.0f} oz"


def test_the_same_again_after_a_pause_is_another_event() -> None:
    generator = PulseGenerator(MiniMover(bench=Bench("empty")))
    generator.arm.move_joints(JointAngles(0.0, 1.0, 0.95, 0.0, 0.0))
    generator.align()
    for _ in range(2):
        generator.turn(2, 200, delay_period(100))
        generator.turn(2, -50, delay_period(100))
        generator.time += 2 * T_STATES_PER_SECOND
    losses = [event for event in generator.arm.events if event.steps < 0]
    assert len(losses) == 2


def test_a_sweep_through_a_stack_is_a_handful_of_lines() -> None:
    bench = Bench("stack")
    for place in range(4):
        bench.add_part(f"block {place + 1}", (1.0, 1.0, 1.0), 2.0, 8.0, 2.0, bottom=float(place))
    generator = PulseGenerator(MiniMover(bench=bench))
    generator.arm.move_to(Pose(8.0, 0.0, 1.5, -90.0, 0.0))
    generator.align()
    generator.turn(0, 500, delay_period(100))
    assert 1 <= len(generator.arm.events) <= 12
