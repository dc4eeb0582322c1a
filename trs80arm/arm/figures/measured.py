"""Data of Figures 2, 6 and 8 and of Table 1, taken from an arm that is made to move.

Each function builds an arm on a bench of its own, handles it as a person would, and writes down
what it does.
"""

from __future__ import annotations

import math
from dataclasses import replace

from trs80arm.arm.bench import Bench
from trs80arm.arm.by_hand import InTheWay
from trs80arm.arm.events import EventKind
from trs80arm.arm.experiments import Verdict, table1
from trs80arm.arm.figures.chart import Chart, Series, Style, Table
from trs80arm.arm.geometry import JointAngles, forward
from trs80arm.arm.minimover import MiniMover
from trs80arm.arm.model import Motor, Pose
from trs80arm.arm.settings import ArmSettings
from trs80arm.arm.stepping import PulseGenerator, delay_period


def envelope(settings: ArmSettings) -> tuple[Chart, Chart]:
    """Figure 2: where the fingertip can be taken, from the side and from above.

    The arm is moved by hand to every combination of angles, a few degrees apart; stops, table
    and its own base refuse the others.
    """
    arm = MiniMover(settings, Bench("empty"))
    shoulder_height = forward(arm.model, arm.state().angles).shoulder[2]
    cloud: set[tuple[float, float]] = set()
    outer: dict[int, tuple[float, float, float]] = {}
    on_table = []
    for shoulder in range(-36, 150, 4):
        for elbow in range(shoulder - 152, shoulder + 1, 8):
            for pitch in range(elbow - 90, elbow + 91, 30):
                if not _goes(arm, 0, shoulder, elbow, pitch):
                    continue
                x, _, z = forward(arm.model, arm.state().angles).fingertip
                cloud.add((round(x * 2) / 2, round(z * 2) / 2))
                bearing = round(math.degrees(math.atan2(z - shoulder_height, x)) / 6)
                far = math.hypot(x, z - shoulder_height)
                outer[bearing] = max(outer.get(bearing, (0.0, 0.0, 0.0)), (far, x, z))
                if z < 1 and x > 0:
                    on_table.append(x)
    edge = [outer[bearing][1:] for bearing in sorted(outer)]
    bearings = [base for base in range(-105, 106, 5) if _goes(arm, base, 90, 0, 0)]
    farthest = max(x for _, x, _ in outer.values())
    drawn = _links(arm)
    points = sorted(cloud)
    reached = Series("reached by the fingertip", *_split(points), style=Style.DOTS, mark=".")
    side = Chart(
        "side view",
        "inches forward of the base axis",
        "inches above the table",
        (reached, Series("edge", *_split(edge), mark="o"), drawn),
        to_scale=True,
    )
    rings = [
        Series(label, *_split([_polar(radius, base) for base in bearings]), mark=mark)
        for label, radius, mark in (
            ("farthest", farthest, "o"),
            ("farthest on the table", max(on_table), "+"),
            ("nearest on the table", min(on_table), "."),
        )
    ]
    top = Chart(
        "top view",
        "inches forward of the base axis",
        "inches to the left",
        tuple(rings),
        to_scale=True,
    )
    return side, top


def _links(arm: MiniMover) -> Series:
    """The arm in a posture that shows its links."""
    arm.move_joints(JointAngles(0.0, math.radians(60), math.radians(-30), math.radians(-60), 0.0))
    points = forward(arm.model, arm.state().angles)
    places = (points.shoulder, points.elbow, points.wrist, points.fingertip)
    xs = (0.0, *(p[0] for p in places))
    return Series("arm", xs, (0.0, *(p[2] for p in places)), mark="#")


def grip_curves(settings: ArmSettings) -> tuple[Chart, Chart]:
    """Figure 6: opening and force while the hand closes, empty and on a part 1 inch wide."""
    charts = []
    for title, bench in (("empty", Bench("empty")), ("on a part 1 in wide", _one_part())):
        arm = MiniMover(settings, bench)
        arm.move_to(Pose(8.0, 0.0, 0.5, -90.0, 0.0, 3.0))
        generator = PulseGenerator(arm)
        generator.align()
        period = delay_period(200)
        steps, openings, forces = [0.0], [3.0], [0.0]
        while not any(event.kind is EventKind.SLIP for event in arm.events):
            generator.turn(Motor.HAND, -1, period)
            state = arm.state()
            if state.slipped[Motor.HAND] == 0 and state.force >= forces[-1]:
                steps.append(float(-generator.counts[Motor.HAND]))
                openings.append(state.pose.opening)
                forces.append(state.force)
        charts.append(
            Chart(
                title,
                "steps of cable taken up",
                "opening (inches), force (pounds)",
                (
                    Series("opening", tuple(steps), tuple(openings), mark="*"),
                    Series("force", tuple(steps), tuple(forces), mark="+"),
                ),
            )
        )
    return charts[0], charts[1]


def phase_table() -> Table:
    """Figure 8: the patterns in the order in which they turn a motor, found by trying all."""
    patterns: dict[int, list[int]] = {}
    arm = MiniMover(bench=Bench("empty"))
    home = arm.state().angles
    places = [
        replace(home, base=home.base + start / arm.model.drives[Motor.BASE].steps)
        for start in range(3)
    ]
    for nibble in range(16):
        # Where a pattern holds the rotor shows in where it pulls it from several places; one
        # may be its dead point.
        ends = [_pulled(arm, place, nibble) % 8 for place in places]
        held = [end for end in ends if ends.count(end) > 1]
        if held:
            patterns.setdefault(held[0], []).append(nibble)
    rows = []
    for position, found in sorted(patterns.items()):
        # Of two that hold it alike the table has the one that wastes no current.
        best = min(found, key=int.bit_count)
        bits = (str(best >> bit & 1) for bit in (3, 2, 1, 0))
        rows.append((str(position), *bits, f"{best:X}"))
    return Table(("half-step", "phi1", "phi2", "phi3", "phi4", "nibble"), tuple(rows))


def _pulled(arm: MiniMover, place: JointAngles, nibble: int) -> int:
    """Where a pattern takes the base motor's rotor from a place to which it was turned by hand."""
    arm.move_joints(place)
    arm.apply([0], [Motor.BASE], [nibble])
    pulled = arm.rotors[Motor.BASE]
    arm.apply([0], [Motor.BASE], [0])
    return pulled


def table1_rows() -> Table:
    """Table 1 with what the arm does beside what the article lists."""
    measured = table1()
    notes = tuple(
        dict.fromkeys(row.contradiction for row in measured if row.verdict is Verdict.CONTRADICTED)
    )
    rows = tuple(
        (
            row.name,
            f"{row.listed} {row.unit}",
            f"{row.measured:.3f}".rstrip("0").rstrip(".") + f" {row.unit}",
            f"no: note {notes.index(row.contradiction) + 1}"
            if row.verdict is Verdict.CONTRADICTED
            else row.verdict.value,
        )
        for row in measured
    )
    return Table(("", "article", "measured", "kept"), rows, notes)


def _one_part() -> Bench:
    """A bench with a part an inch wide where the hand closes."""
    bench = Bench("one part")
    bench.add_part("part", (1.0, 1.0, 1.0), 2.0, 8.0, 0.0)
    return bench


def _goes(arm: MiniMover, *degrees: float) -> bool:
    """Whether the joints can be put there by hand: base, upper arm, forearm, hand."""
    base, shoulder, elbow, pitch = (math.radians(value) for value in degrees)
    try:
        arm.move_joints(JointAngles(base, shoulder, elbow, pitch, 0.0))
    except (InTheWay, ValueError):
        return False
    return True


def _split(points: list[tuple[float, float]]) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Points as xs and ys."""
    return tuple(x for x, _ in points), tuple(y for _, y in points)


def _polar(radius: float, degrees: float) -> tuple[float, float]:
    """A point from the base axis."""
    angle = math.radians(degrees)
    return radius * math.cos(angle), radius * math.sin(angle)
