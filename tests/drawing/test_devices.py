"""Devices of the work cell as they are seen: what they do is in the picture."""

from __future__ import annotations

import numpy as np
import pytest

from trs80arm.arm import benchfile
from trs80arm.drawing.bench_solids import FIRST_THING, solids_of
from trs80arm.drawing.picture import IN_SPACE
from trs80arm.drawing.readings import Kind, Readings, Thing
from trs80arm.drawing.scene import Block, Extras
from trs80arm.drawing.side_scene import side_scene
from trs80arm.drawing.studio import Orbit, take
from trs80arm.drawing.top_scene import top_scene
from trs80arm.drawing.viewport import Viewport
from trs80arm.rig import Rig

BELT = """
[[conveyor]]
name = "belt"
at = [11.0, 0.0]
length = 4.0
width = 1.0
turn = 0.0
speed = 1.0
run = 0
reverse = 1
photocell = { bit = 2 }
[[part]]
name = "block"
at = [10.0, 0.0]
bottom = 1.0
size = [0.5, 0.5, 0.5]
"""


DEVICES = {Kind.TURNTABLE, Kind.MACHINE, Kind.CONVEYOR}


def seen(bench: str, statement: str, seconds: float) -> Readings:
    """What is seen after a statement at the prompt, and some time."""
    rig = Rig(bench=benchfile.parse(bench))
    rig.type(f"{statement}\r")
    rig.run_until_waiting()
    rig.run_for(seconds)
    return Readings.of(rig)


def thing(readings: Readings, name: str) -> Thing:
    return next(thing for thing in readings.things if thing.name == name)


def fills(readings: Readings) -> tuple[set[str], set[str]]:
    """The glyphs of boxes in the bare lines from the side and from above."""
    side, top = (
        {shape.fill for shape in scene(readings).shapes if isinstance(shape, Block)}
        for scene in (side_scene, top_scene)
    )
    return side, top


@pytest.mark.parametrize(
    ("turn", "statement", "state", "side", "top"),
    [
        (0, "OUT 158,0", "stands", ":", ":"),
        (0, "OUT 158,1", "runs", ">", ">"),
        (0, "OUT 158,3", "runs back", "<", "<"),
        (90, "OUT 158,1", "runs", ">", "^"),
        (180, "OUT 158,1", "runs", "<", "<"),
        (-90, "OUT 158,1", "runs", ">", "v"),
    ],
)
def test_a_belt_shows_whether_it_runs_and_which_way(
    turn: float, statement: str, state: str, side: str, top: str
) -> None:
    readings = seen(BELT.replace("turn = 0.0", f"turn = {turn}"), statement, 0.3)
    assert thing(readings, "belt").kind is Kind.CONVEYOR
    assert thing(readings, "belt").state == state
    from_the_side, from_above = fills(readings)
    assert side in from_the_side
    assert top in from_above


def test_the_slats_of_a_belt_go_along_with_it() -> None:
    standing = thing(seen(BELT, "OUT 158,0", 0.5), "belt")
    running = thing(seen(BELT, "OUT 158,1", 0.5), "belt")
    assert 0.2 < running.gone < 0.9
    # Frame and belt stay, and the slats after them are on by as much.
    before, after = (solids_of(each, 1).corners[16:] for each in (standing, running))
    assert np.ptp((after - before)[: len(after) // 2, 0]) < 1e-9
    assert (after - before)[0] == pytest.approx((running.gone, 0, 0))


def test_a_photocell_is_seen_to_answer() -> None:
    readings = seen(BELT, "OUT 158,1", 0.9)
    assert thing(readings, "belt photocell").on
    assert "!" in fills(readings)[1]
    assert not thing(seen(BELT, "OUT 158,0", 0.9), "belt photocell").on


@pytest.mark.parametrize(
    "device",
    [
        "[turntable]\nat = [9.0, 0.0]\nradius = 3.0\n",
        "[[machine]]\nat = [9.0, 0.0]\nsize = [3, 3, 0.5]\nseconds = 9\nstart = 0\ndone = 3\n",
        BELT,
    ],
    ids=["turntable", "machine", "belt"],
)
def test_a_small_picture_leaves_out_details_but_no_device(device: str) -> None:
    readings = seen(device, "OUT 158,0", 0.1)
    body = FIRST_THING + [each.kind in DEVICES for each in readings.things].index(True)
    shot = IN_SPACE.shot(readings, Orbit(), Extras())
    for width, height in ((30, 10), (60, 18), (160, 60)):
        window = Viewport().window(shot, width, height).aligned()
        found = take(shot, width, height, (2, 3), window).body == body
        assert found.mean() > 0.005


MACHINE = """
[[machine]]
name = "press"
at = [11.0, 0.0]
size = [1.5, 1.5, 2.0]
height = 0.5
seconds = 2
start = 2
busy = 1
done = 2
[[part]]
at = [11.0, 0.0]
bottom = 0.5
size = [0.5, 0.5, 0.5]
"""


def test_a_machine_is_seen_with_its_hood_while_that_is_closed_and_its_lamps() -> None:
    idle, busy, done = (
        seen(MACHINE, statement, seconds)
        for statement, seconds in (("OUT 158,0", 0.1), ("OUT 158,4", 0.1), ("OUT 158,4", 2.5))
    )
    for readings, state in ((idle, "idle"), (busy, "busy"), (done, "done")):
        assert readings.devices == (("press", state),)
        machines = {each.name for each in readings.things if each.kind is Kind.MACHINE}
        assert machines == ({"press", "press hood"} if state == "busy" else {"press"})
        lit = {each.name for each in readings.things if each.kind is Kind.SENSOR and each.on}
        assert lit == ({f"press {state}"} if state != "idle" else set())
        assert all("%" in glyphs for glyphs in fills(readings))
    hood = solids_of(thing(busy, "press hood"), 1)
    assert len(hood.corners) == 5 * 8, "four walls and a roof"
