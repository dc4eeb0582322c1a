"""Who is awake and what lies near: what is asleep elsewhere is not asked."""

from __future__ import annotations

import pickle
import random
from dataclasses import replace

import pytest

from tests.arm.contact.hand import SlidingHand
from trs80arm.arm.contact.bodies import Body, Shape
from trs80arm.arm.contact.clock import TICK_STATES
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.solids import box

CUBE = Shape.of([box((1.0, 1.0, 1.0))], 2.0)


def field(scene: Scene, side: int) -> None:
    """Cubes at rest, two inches apart."""
    for k in range(side * side):
        body = Body(str(k), CUBE, 0.5, (2.0 * (k % side), 2.0 * (k // side), 0.5))
        scene.add(body)
        body.asleep = True


def test_only_what_is_near_is_found_as_it_came() -> None:
    scene = Scene()
    field(scene, 45)
    found = scene._roster.near((3.9, 3.9, 0.0), (4.1, 6.1, 1.0))
    assert {"92", "137"} <= {body.name for body in found}
    assert len(found) <= 12
    assert [int(body.name) for body in found] == sorted(int(body.name) for body in found)


@pytest.mark.parametrize("wide", [0.5, 3.0, 40.0])
@pytest.mark.parametrize("count", [1, 4, 60])
def test_who_reaches_into_a_box_is_found_however_wide_it_is(count: int, wide: float) -> None:
    chance, scene = random.Random(count), Scene()
    for number in range(count):
        place = chance.uniform(-20, 20), chance.uniform(-20, 20), 0.5
        scene.add(Body(str(number), CUBE, 0.5, place)).asleep = True
    for _ in range(30):
        x, y, r = chance.uniform(-20, 20), chance.uniform(-20, 20), CUBE.radius
        found = [body.name for body in scene._roster.near((x, y, 0.0), (x + wide, y + wide, 1.0))]
        reaching = {
            body.name
            for body in scene.bodies.values()
            if x - r <= body.place[0] <= x + wide + r and y - r <= body.place[1] <= y + wide + r
        }
        assert reaching <= set(found)
        assert found == sorted(found, key=int)


def test_what_is_woken_moved_or_taken_away_is_found_where_it_is() -> None:
    scene = Scene()
    field(scene, 3)
    here = (-0.1, -0.1, 0.0), (0.1, 0.1, 1.0)
    first = scene.bodies["0"]
    assert first in scene._roster.near(*here)
    first.put((40.0, 40.0, 0.5), first.turn)
    assert first not in scene._roster.near(*here)
    assert scene._roster.near((40.0, 40.0, 0.0), (40.0, 40.0, 1.0)) == [first]
    scene.wake("0")
    assert not scene.quiet
    first.asleep = True
    assert scene.quiet
    scene.remove("0")
    assert scene._roster.near((40.0, 40.0, 0.0), (40.0, 40.0, 1.0)) == []
    # A copy is nobody's until it is put into a scene; a pickled scene knows its own bodies.
    replace(first).asleep = False
    assert scene.quiet
    copy = pickle.loads(pickle.dumps(scene))
    copy.wake("8")
    assert not copy.quiet
    assert scene.quiet


def test_an_arm_over_a_few_of_two_thousand_parts_wakes_what_it_touches_alone() -> None:
    scene = Scene(arm=SlidingHand())
    field(scene, 45)
    scene.put_arm((8.6, 8.0, 3.0, 0.0, 0.0, 0.3))
    woken: set[str] = set()
    for k in range(1, 151):
        scene.command((8.6, 8.0, 3.0 - 0.02 * k, 0.0, 0.0, 0.3))
        scene.advance(k * TICK_STATES)
        woken |= {body.name for body in scene.bodies.values() if not body.asleep}
    assert woken == {"184"}
