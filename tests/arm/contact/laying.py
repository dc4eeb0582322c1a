"""Scenes as text: what lies where, what a hand does, and how it ends.

A file of `scenes/` holds tables `[[scene]]` with the keys

- `name`; `why`, where the expected ends are not plain to see or the referee has them otherwise;
- `parts` and `fixed`: `name`, `shape` ("box" unless given, "cylinder", "prism", "tray", "holed",
  "pegs"), `size` (of a cylinder its diameter twice and its height), `at` (x, y of its middle),
  `bottom` (0), `turn`, `tilt`, `roll` (degrees, about z after y after x); of a part `weight`
  (2 oz) and `friction` (0.5);
- `hand`: `at` (x, y, z of the fingertips), `opening`, `turn`, `tilt`; it points straight down;
- `do`: what the hand does one after the other, in straight lines: `to`, `opening`, `turn`,
  `tilt`, in `seconds` (1); without a hand, only the time passes;
- `ends`: for each part that matters `x`, `y`, `z` of its centre of mass, `tilt` of its own z
  against the vertical (one or several), `turn` about the vertical, `held`;
- `within` (inches, 0.06) and `degrees` (3) by which ends may differ;
- `referee`: ends by the referee where they differ.
"""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tests.arm.contact.hand import SlidingHand
from trs80arm.arm.contact.bodies import Body, Fixed, Shape
from trs80arm.arm.contact.clock import TICK, TICK_STATES
from trs80arm.arm.contact.forms import holed, peg_board, standing, tray
from trs80arm.arm.contact.rotations import Matrix, Quaternion, apply, matrix, oriented
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.solids import Solid, box, cylinder, prism
from trs80arm.arm.shapes import Vector

SCENES = Path(__file__).parent / "scenes"
PIVOTS = 0.017453292519943295
AFTER = 1.0
"""Seconds that pass after the hand has done everything."""


@dataclass(frozen=True)
class Thing:
    """A part, or something fixed."""

    name: str
    solids: tuple[Solid, ...]
    shape: Shape
    friction: float
    place: Vector
    turn: Quaternion


@dataclass(frozen=True)
class End:
    """Where a part ends."""

    place: Vector
    turn: Matrix
    held: bool


@dataclass(frozen=True)
class Story:
    """One scene."""

    name: str
    parts: list[Thing]
    fixed: list[Thing]
    hand: tuple[float, ...] | None
    moves: list[tuple[float, tuple[float, ...]]]
    ends: dict[str, dict[str, Any]]
    referee: dict[str, dict[str, Any]]
    within: float
    degrees: float
    text: dict[str, Any] = field(repr=False)


def stories() -> list[Story]:
    """All scenes of all files."""
    return [
        _story(item)
        for path in sorted(SCENES.glob("*.toml"))
        for item in tomllib.loads(path.read_text(encoding="utf-8"))["scene"]
    ]


def _story(item: dict[str, Any]) -> Story:
    known = {
        "name", "why", "parts", "fixed", "hand", "do", "ends", "within", "degrees", "referee",
    }  # fmt: skip
    assert set(item) <= known, set(item) - known
    hand, moves = None, []
    if "hand" in item:
        hand = at = _joints(item["hand"], (0.0,) * 6)
        for step in item.get("do", []):
            at = _joints(step, at)
            moves.append((step.get("seconds", 1.0), at))
    else:
        moves = [(step["seconds"], ()) for step in item.get("do", [])]
    return Story(
        item["name"],
        [_thing(part, item.get("name", "")) for part in item.get("parts", [])],
        [_thing(part, item.get("name", "")) for part in item.get("fixed", [])],
        hand,
        moves,
        item["ends"],
        {**item["ends"], **item.get("referee", {})},
        item.get("within", 0.06),
        item.get("degrees", 3.0),
        item,
    )


def _joints(step: dict[str, Any], before: Sequence[float]) -> tuple[float, ...]:
    x, y, z = step.get("at", step.get("to", before[:3]))
    turn = step["turn"] * PIVOTS if "turn" in step else before[3]
    tilt = step["tilt"] * PIVOTS if "tilt" in step else before[4]
    return x, y, z, turn, tilt, step.get("opening", before[5])


def _thing(part: dict[str, Any], scene: str) -> Thing:
    known = {
        "name", "shape", "size", "at", "bottom", "turn", "tilt", "roll", "weight", "friction",
        "outline", "wall", "hole", "pegs", "radius", "height",
    }  # fmt: skip
    assert set(part) <= known, (scene, set(part) - known)
    kind = part.get("shape", "box")
    size = tuple(part.get("size", (1.0, 1.0, 1.0)))
    solids: tuple[Solid, ...]
    if kind == "box":
        solids = (box((size[0], size[1], size[2])),)
    elif kind == "cylinder":
        solids = (cylinder(size[0] / 2, size[2]),)
    elif kind == "prism":
        solids = (prism([(x, y) for x, y in part["outline"]], part["height"]),)
    elif kind == "tray":
        solids = tray((size[0], size[1], size[2]), part["wall"])
    elif kind == "holed":
        solids = holed((size[0], size[1], size[2]), tuple(part["hole"]))
    else:
        assert kind == "pegs", kind
        pegs = [(x, y) for x, y in part["pegs"]]
        solids = peg_board((size[0], size[1], size[2]), pegs, part["radius"], part["height"])
    shape = Shape.of(solids, part.get("weight", 2.0))
    turn = oriented(part.get("turn", 0.0), part.get("tilt", 0.0), part.get("roll", 0.0))
    place, turn = standing(shape, *part["at"], part.get("bottom", 0.0), turn)
    return Thing(part["name"], shape.solids, shape, part.get("friction", 0.5), place, turn)


def laid(story: Story) -> Scene:
    """A scene as it begins."""
    scene = Scene(0.5, SlidingHand() if story.hand is not None else None)
    for thing in story.fixed:
        solids = tuple(solid.moved(thing.place, thing.turn) for solid in thing.solids)
        scene.fixed[thing.name] = Fixed(thing.name, solids, thing.friction)
    for part in story.parts:
        scene.add(Body(part.name, part.shape, part.friction, part.place, part.turn))
    if story.hand is not None:
        scene.put_arm(story.hand)
    return scene


def commands(story: Story, step: float) -> list[tuple[float, ...]]:
    """Where the hand is commanded to, at the end of each time step (seconds)."""
    out: list[tuple[float, ...]] = []
    at = story.hand or ()
    for seconds, to in story.moves:
        count = max(1, round(seconds / step))
        out += [
            tuple(a + (b - a) * i / count for a, b in zip(at, to, strict=True))
            for i in range(1, count + 1)
        ]
        at = to
    return out + [at] * round(AFTER / step)


def played(story: Story) -> Scene:
    """A scene as it ends."""
    scene = laid(story)
    for number, joints in enumerate(commands(story, TICK), 1):
        if joints:
            scene.command(joints)
        scene.advance(number * TICK_STATES)
    return scene


def ends(scene: Scene) -> dict[str, End]:
    """Where the parts of a scene are."""
    carried = {body.name for body in scene.carried}
    return {
        body.name: End(body.place, matrix(body.turn), body.name in carried)
        for body in scene.bodies.values()
    }


def differences(
    story: Story, found: dict[str, End], expected: dict[str, dict[str, Any]]
) -> list[str]:
    """What of the ends found is not as expected, a line each."""
    import math

    out = []
    for name, wanted in expected.items():
        assert set(wanted) <= {"x", "y", "z", "tilt", "turn", "held"}, wanted
        end = found[name]
        for axis, value in zip("xyz", end.place, strict=True):
            if axis in wanted and abs(value - wanted[axis]) > story.within:
                out.append(f"{name}: {axis} is {value:.3f}, not {wanted[axis]}")
        if "tilt" in wanted:
            tilt = math.degrees(math.acos(max(-1.0, min(1.0, end.turn[8]))))
            tilts = wanted["tilt"] if isinstance(wanted["tilt"], list) else [wanted["tilt"]]
            if all(abs(tilt - each) > story.degrees for each in tilts):
                out.append(f"{name}: tilt is {tilt:.2f}, not {wanted['tilt']}")
        if "turn" in wanted:
            x, y, _ = apply(end.turn, (1.0, 0.0, 0.0))
            turn = math.degrees(math.atan2(y, x))
            if abs((turn - wanted["turn"] + 180) % 360 - 180) > story.degrees:
                out.append(f"{name}: turn is {turn:.2f}, not {wanted['turn']}")
        if "held" in wanted and end.held != wanted["held"]:
            out.append(f"{name}: {'held' if end.held else 'not held'}")
    return out
