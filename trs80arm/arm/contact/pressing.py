"""What presses on a link of the arm, which way and how hard, as it was found on the last tick.

Nothing is solved again: the scene remembers with how much things press on each other, also of what
has fallen asleep since. Which way they do follows from where they are.
"""

from __future__ import annotations

from trs80arm.arm.contact.bounds import met
from trs80arm.arm.contact.driven import GRAVITY
from trs80arm.arm.contact.manifold import Manifold, on_table
from trs80arm.arm.contact.meeting import MARGIN
from trs80arm.arm.contact.scene import Scene
from trs80arm.arm.contact.table import TABLE
from trs80arm.arm.shapes import Vector


def pressing(scene: Scene, link: int) -> list[tuple[Vector, float]]:
    """What presses on a link: the way in which it pushes the link, and ounces.

    What rests in the hand alone, or between its fingers, is left out: how hard the fingers press on
    that is a matter of the hand's cable.

    Args:
        scene: the parts in contact.
        link: of the arm, by its place in the scene's list of them.
    """
    name = scene.driven.names[link]
    held = {body.name for body in scene.carried} | set(scene.carrying.gripped)
    found = []
    for key, impulse in scene.pressed(name):
        first, second, number = key
        other = second if first == name else first
        if other in held:
            continue
        manifold = _manifold(scene, link, other, number)
        if manifold is not None:
            x, y, z = manifold.normal
            way = (x, y, z) if second == name else (-x, -y, -z)
            found.append((way, impulse / GRAVITY))
    return found


def _manifold(scene: Scene, link: int, other: str, number: int) -> Manifold | None:
    """How a solid of something touches a link now; None where it does not any more."""
    mine = scene.link_solids[link]
    if other == TABLE:
        return on_table(mine, MARGIN)
    if other in scene.fixed:
        return met(scene.fixed[other].placed[number], mine, MARGIN)
    if other in scene.bodies:
        return met(mine, scene.bodies[other].placed[number], MARGIN)
    return None
