"""The arm on the whole machine: the inverse against Table 4's subroutine, and a tower of blocks."""

from __future__ import annotations

import itertools
from pathlib import Path

import pytest

from trs80arm import Rig
from trs80arm.arm import EventKind, OutOfReach, benchfile
from trs80arm.arm.geometry import inverse
from trs80arm.arm.models import MINIMOVER5
from trs80arm.operator import Operator, parse_holds

PROGRAMS = Path(__file__).parents[2] / "programs"

GRID = list(
    itertools.product(
        (0.0, 1.5, 4.0, 8.0, 12.0, 17.0),
        (-6.0, 0.0, 5.0),
        (0.5, 6.0, 14.0),
        (-90.0, -30.0, 45.0),
        (0.0, 90.0),
    )
)

ASK = """
1 GOTO 100
130 FOR N=1 TO {count}
131 READ X,Y,Z,P,R
132 GOSUB 5000
133 LPRINT T1*C;T2*C;T3*C;T4*C;T5*C
134 NEXT N
135 END
"""


def subroutine(places: list[tuple[float, ...]]) -> list[list[float] | None]:
    """What the article's lines 5000 to 6000 print for places; None where out of reach."""
    lines = {}
    for line in (PROGRAMS / "table4.bas").read_text(encoding="ascii").splitlines():
        number, text = line.split(" ", 1)
        if 100 <= int(number) < 130 or 5000 <= int(number) <= 5230:
            lines[int(number)] = text
    for line in ASK.format(count=len(places)).strip().splitlines():
        number, text = line.split(" ", 1)
        lines[int(number)] = text
    # Only what it does about a place out of reach is changed: it says so and goes on.
    lines[6000] = "T1=9:T2=0:T3=0:T4=0:T5=0:RETURN"
    for i, place in enumerate(places):
        lines[9000 + i] = "DATA " + ",".join(f"{value:g}" for value in place)
    rig = Rig()
    rig.load_text("".join(f"{number} {lines[number]}\n" for number in sorted(lines)))
    rig.type("RUN\r")
    rig.run_until_waiting(3600)
    rows = [[float(cell) for cell in row.split()] for row in rig.printer.text.splitlines()]
    return [None if row[0] > 400 else row for row in rows]


def test_inverse_agrees_with_the_articles_subroutine_over_a_grid_of_poses() -> None:
    found = subroutine(GRID)
    assert len(found) == len(GRID)
    assert 50 < sum(row is not None for row in found) < len(GRID) - 50
    for place, row in zip(GRID, found, strict=True):
        try:
            angles = inverse(MINIMOVER5, *place)
        except OutOfReach:
            assert row is None, place
            continue
        assert row is not None, place
        ours = (angles.base, angles.shoulder, angles.elbow, angles.left_gear, angles.right_gear)
        assert row == pytest.approx([value * 57.29578 for value in ours], abs=0.02), place


def tower(moved: float = 0.0) -> Rig:
    """The rig after tower.bas, with its third block moved along y by some inches."""
    bench = benchfile.load(PROGRAMS / "tower.toml")
    block = bench.parts.pop("block 3").box
    x, y, _ = block.center
    bench.add_part("block 3", (1.0, 1.0, 1.0), 2.0, x, y + moved)
    rig = Rig(bench=bench)
    rig.load(PROGRAMS / "tower.bas")
    rig.type("RUN\r")
    Operator(rig, sets=[parse_holds("6:0.05 0")]).run(600)
    assert "TAKEN DOWN" in "\n".join(rig.screen())
    return rig


def test_a_program_builds_a_tower_of_four_blocks_and_takes_it_down() -> None:
    rig = tower()
    assert rig.arm.state().slipped == (0,) * 6
    placed = [event for event in rig.arm.events if event.kind is EventKind.PLACED]
    assert [event.text for event in placed] == [
        f"block {k} set down" for k in (1, 2, 3, 4, 4, 3, 2, 1)
    ]
    for k in range(4):
        center = rig.arm.bench.parts[f"block {k + 1}"].box.center
        assert center == pytest.approx((9, -4.5 + 2.25 * k, 0.5), abs=0.06)


def test_the_tower_fails_when_a_block_is_moved_by_an_inch() -> None:
    rig = tower(moved=1.0)
    losses = [event for event in rig.arm.events if event.kind is EventKind.SLIP]
    assert losses
    assert rig.arm.state().slipped != (0,) * 6
    placed = [event.text for event in rig.arm.events if event.kind is EventKind.PLACED]
    assert len(placed) < 8
