"""The referee: the same scenes laid before MuJoCo, a general physics engine.

For developers: `pip install -e '.[referee]'`, then `python -m tests.arm.contact.referee` plays all
scenes before both and prints where they differ; the test of the same name runs where MuJoCo is.
"""

from __future__ import annotations

import math
import sys

import mujoco

from tests.arm.contact.hand import FINGER, PALM, PER_INCH, SlidingHand
from tests.arm.contact.laying import End, Story, Thing, commands, differences, ends, played, stories
from trs80arm.arm.contact.driven import GRAVITY
from trs80arm.arm.contact.solids import CYLINDER_SIDES, Solid
from trs80arm.arm.contact.table import TABLE

STEP = 0.002
_TABLE = 0.5


def _geom(name: str, solid: Solid, mass: float, meshes: list[str]) -> str:
    """One solid: a box, a true cylinder, or a mesh."""
    low = [min(v[k] for v in solid.vertices) for k in range(3)]
    high = [max(v[k] for v in solid.vertices) for k in range(3)]
    middle = " ".join(repr((a + b) / 2) for a, b in zip(low, high, strict=True))
    half = [(b - a) / 2 for a, b in zip(low, high, strict=True)]
    weight = f' mass="{mass!r}"' if mass else ""
    if len(solid.vertices) == 8 and all(
        abs(abs(v[k] - (low[k] + high[k]) / 2) - half[k]) < 1e-9
        for v in solid.vertices
        for k in range(3)
    ):
        size = " ".join(map(repr, half))
        return f'<geom name="{name}" type="box" size="{size}" pos="{middle}"{weight}/>'
    if len(solid.vertices) == 2 * CYLINDER_SIDES:
        size = f"{(half[0] + half[1]) / 2!r} {half[2]!r}"
        return f'<geom name="{name}" type="cylinder" size="{size}" pos="{middle}"{weight}/>'
    corners = " ".join(repr(c) for v in solid.vertices for c in v)
    meshes.append(f'<mesh name="{name}" vertex="{corners}"/>')
    return f'<geom name="{name}" type="mesh" mesh="{name}"{weight}/>'


def _shares(thing: Thing) -> list[float]:
    """Mass of each solid."""
    from trs80arm.arm.contact.solids import moments

    volumes = [moments((solid,)).volume for solid in thing.solids]
    return [thing.shape.mass * volume / sum(volumes) for volume in volumes]


def model(story: Story) -> str:
    """A scene in MuJoCo's own format."""
    meshes: list[str] = []
    bodies, groups = [], [("table", _TABLE, "world")]
    for kind, things in (("fixed", story.fixed), ("part", story.parts)):
        for thing in things:
            place, turn = (" ".join(map(repr, v)) for v in (thing.place, thing.turn))
            geoms = ""
            for i, (solid, mass) in enumerate(zip(thing.solids, _shares(thing), strict=True)):
                name = f"{thing.name}:{i}"
                geoms += _geom(name, solid, mass if kind == "part" else 0.0, meshes)
                groups.append((name, thing.friction, thing.name if kind == "part" else "world"))
            free = f'<freejoint name="{thing.name}"/>' if kind == "part" else ""
            bodies.append(
                f'<body name="{thing.name}" pos="{place}" quat="{turn}">{free}{geoms}</body>'
            )
    actuators = extras = ""
    if story.hand is not None:
        bodies.append(_hand())
        for name, rough in zip(SlidingHand.names, SlidingHand.frictions, strict=True):
            groups.append((name, rough, "hand"))
        for joint, k in zip(("x", "y", "z", "turn", "tilt"), SlidingHand.stiffness, strict=False):
            inert = k * GRAVITY / 1e4
            kp, kv = k * GRAVITY, 2 * math.sqrt(k * GRAVITY * inert)
            actuators += f'<position joint="{joint}" kp="{kp!r}" kv="{kv!r}"/>'
        kp = PER_INCH * GRAVITY
        actuators += f'<position tendon="open" kp="{kp!r}" kv="{2 * math.sqrt(kp * 0.5)!r}"/>'
        extras = (
            '<tendon><fixed name="open"><joint joint="jl" coef="1"/><joint joint="jr" coef="1"/>'
            '</fixed></tendon><equality><joint joint1="jl" joint2="jr" solref="0.004 1" '
            'solimp="0.999 0.9999 0.001"/></equality>'
        )
    pairs = ""
    for i, (one, a, body) in enumerate(groups):
        for other, b, their in groups[:i]:
            if body != their:
                mu = math.sqrt(a * b)
                pairs += (
                    f'<pair geom1="{other}" geom2="{one}" condim="3" friction="{mu!r} {mu!r}" '
                    'solref="0.004 1" solimp="0.99 0.999 0.001"/>'
                )
    return f"""<mujoco><compiler angle="radian"/>
<option gravity="0 0 {-GRAVITY}" timestep="{STEP}" integrator="implicitfast" cone="elliptic"
 impratio="10" iterations="50"/>
<default><geom contype="0" conaffinity="0"/></default>
<asset>{"".join(meshes)}</asset>
<worldbody><geom name="table" type="plane" size="60 60 1"/>{"".join(bodies)}</worldbody>
<contact>{pairs}</contact>{extras}<actuator>{actuators}</actuator></mujoco>"""


def _hand() -> str:
    """The sliding hand."""
    joints = ""
    axes = {"x": "1 0 0", "y": "0 1 0", "z": "0 0 1", "turn": "0 0 1", "tilt": "0 -1 0"}
    for (name, axis), k in zip(axes.items(), SlidingHand.stiffness, strict=False):
        kind = "hinge" if name in ("turn", "tilt") else "slide"
        inert = k * GRAVITY / 1e4
        joints += f'<joint name="{name}" type="{kind}" axis="{axis}" armature="{inert!r}"/>'
    # The hand's frame, a quarter turn about y: along is down, across is y, up is x.
    frame = 'quat="0.7071067811865476 0 0.7071067811865476 0"'
    half = " ".join(repr(v / 2) for v in FINGER)
    palm = " ".join(repr(v / 2) for v in PALM)
    light = '<inertial pos="0 0 0" mass="0.001" diaginertia="1 1 1"/>'
    fingers = ""
    for name, joint, sign in (("left finger", "jl", 1), ("right finger", "jr", -1)):
        middle = f"{-FINGER[0] / 2} {sign * FINGER[1] / 2} 0"
        fingers += (
            f'<body name="{name}" gravcomp="1"><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
            f'<joint name="{joint}" type="slide" axis="0 {sign} 0"/>'
            f'<geom name="{name}" type="box" size="{half}" pos="{middle}"/></body>'
        )
    return (
        f'<body name="slides" gravcomp="1">{light}{joints}<body {frame} gravcomp="1">{light}'
        f'<geom name="palm" type="box" size="{palm}" pos="-2.9 0 0"/>{fingers}</body></body>'
    )


def judged(story: Story) -> dict[str, End]:
    """Where the parts of a scene end by MuJoCo."""
    machine = mujoco.MjModel.from_xml_string(model(story))
    data = mujoco.MjData(machine)
    if story.hand is not None:
        for name, value in zip(("x", "y", "z", "turn", "tilt"), story.hand, strict=False):
            data.joint(name).qpos[0] = value
        for name in ("jl", "jr"):
            data.joint(name).qpos[0] = story.hand[5] / 2
        data.ctrl[:] = story.hand
    mujoco.mj_forward(machine, data)
    for joints in commands(story, STEP):
        if joints:
            data.ctrl[:] = joints
        mujoco.mj_step(machine, data)
    touched: dict[str, set[str]] = {}
    for k in range(data.ncon):
        geoms = (machine.geom(int(g)).name.split(":")[0] for g in data.contact[k].geom)
        one, other = geoms
        touched.setdefault(one, set()).add(other)
        touched.setdefault(other, set()).add(one)
    out = {}
    for thing in story.parts:
        q = data.joint(thing.name).qpos
        m = data.body(thing.name).xmat.tolist()
        out[thing.name] = End(
            (float(q[0]), float(q[1]), float(q[2])), tuple(m), _held(thing.name, touched, story)
        )
    return out


def _held(name: str, touched: dict[str, set[str]], story: Story) -> bool:
    """Whether a part rests in the hand and on nothing else."""
    seen, waiting, outside = set(), [name], set()
    parts = {part.name for part in story.parts}
    while waiting:
        one = waiting.pop()
        if one in seen:
            continue
        if one not in parts:
            outside.add(one)
            continue
        seen.add(one)
        waiting += touched.get(one, ())
    return bool(outside) and outside <= set(SlidingHand.names)


def main(words: list[str]) -> None:
    """Play scenes before both and print where they end."""
    print(f"MuJoCo {mujoco.__version__}; {TABLE} at friction {_TABLE}")
    for story in stories():
        if words and not any(word in story.name for word in words):
            continue
        mine, theirs = ends(played(story)), judged(story)
        print(story.name)
        for name in mine if words else story.ends:
            print("    ours", _line(name, mine[name]))
            print("  theirs", _line(name, theirs[name]))
        for line in differences(story, mine, story.ends):
            print("   !ours:", line)
        for line in differences(story, theirs, story.referee):
            print("   !theirs:", line)


def _line(name: str, end: End) -> str:
    tilt = math.degrees(math.acos(max(-1.0, min(1.0, end.turn[8]))))
    turn = math.degrees(math.atan2(end.turn[3], end.turn[0]))
    place = " ".join(f"{v:7.3f}" for v in end.place)
    return f"{name:8} {place} tilt {tilt:6.2f} turn {turn:7.2f} {'held' if end.held else ''}"


if __name__ == "__main__":
    main(sys.argv[1:])
