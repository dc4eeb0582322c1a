"""The teach pendant in lines: jogs, the hand, the way from point to point, listings read back."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from trs80arm.bundled import PROGRAM_SUFFIX, named
from trs80arm.desk.jogging import HAND, Coordinates
from trs80arm.desk.teach import MOST_DELAY
from trs80arm.plain.command import Group, LineCommand, Sitting
from trs80arm.plain.machine import at_file
from trs80arm.plain.teaching import at_position, show_positions

WAYS = {
    Coordinates.WORLD: ("x", "y", "z", "pitch", "roll", "hand"),
    Coordinates.TOOL: ("along", "across", "off"),
}
"""What the pendant goes along, by the words for it; joints have their own names."""
MEMORY = "memory"
ROUND = "round"


def _jog(sitting: Sitting, words: str) -> None:
    *name, amount = words.casefold().split() or [""]
    try:
        by = float(amount)
    except ValueError:
        by = 0.0
    found = _way(sitting, " ".join(name))
    if found is None or not 0 < abs(by) <= MOST_DELAY:
        joints = ", ".join(sitting.session.rig.joint_names[:HAND])
        ways = ", ".join(way for ways in WAYS.values() for way in ways)
        sitting.tell(f"Which way, and how far? {ways} in inches or degrees; {joints} in steps.")
        return
    sitting.pendant.coordinates, axis = found
    sitting.pendant.move_by(axis, by)


def _way(sitting: Sitting, name: str) -> tuple[Coordinates, int] | None:
    """The coordinates that have a way of that name, and which of theirs it is."""
    for coordinates, ways in WAYS.items():
        if name in ways:
            return coordinates, ways.index(name)
    joints = sitting.session.rig.joint_names
    return (Coordinates.JOINT, joints.index(name)) if name in joints else None


def _width(sitting: Sitting, words: str) -> None:
    try:
        sitting.pendant.open_to(float(words))
    except ValueError:
        sitting.tell("How wide, in inches?")


def _go(sitting: Sitting, words: str) -> None:
    names = [position.name for position in sitting.lesson.positions]
    if words.upper() in names:
        sitting.pendant.go_to(names.index(words.upper()))
    elif words.isdecimal() and 1 <= int(words) <= len(names):
        sitting.pendant.go_to(int(words) - 1)
    else:
        sitting.tell("To which position? .positions lists them.")


def _through(sitting: Sitting, words: str) -> None:
    pendant = sitting.pendant
    pendant.manner = replace(pendant.manner, repeats=words.casefold() == ROUND)
    pendant.run()


def _delay(sitting: Sitting, words: str) -> None:
    pendant = sitting.pendant
    if words.isdecimal() and int(words) <= MOST_DELAY:
        pendant.use_delay(int(words))
    elif words:
        sitting.tell(f"D is a number from 0 to {MOST_DELAY}.")
        return
    sitting.tell(f"D {pendant.manner.speed}")


def _comment(sitting: Sitting, words: str) -> None:
    at_position(sitting, words, sitting.lesson.comment)


def _holds(sitting: Sitting, words: str) -> None:
    def switch(place: int, _: str) -> None:
        sitting.pendant.mark(place)
        sitting.pendant.switch_grip()

    at_position(sitting, words, switch)


def _read(sitting: Sitting, words: str) -> None:
    pendant = sitting.pendant

    def told(problem: str) -> None:
        if problem:
            sitting.tell(problem)
        else:
            show_positions(sitting, "")

    def read(path: Path) -> None:
        told(pendant.read_file(named(path, PROGRAM_SUFFIX)))

    if words.casefold() == MEMORY:
        told(pendant.read_memory())
    else:
        at_file(sitting, words, read, to_write=False)


_SEEN = "What it does is typed into the TRS-80, and shown. Ctrl+C stops it."
GROUP = Group(
    "Teach pendant",
    (
        LineCommand(
            "jog",
            "move the arm along a way",
            _jog,
            "WAY HOW-FAR",
            "x, y and z in inches, pitch, roll in degrees, hand in inches; along, across and off "
            f"the hand in inches; a joint by its name in half-steps. As .jog z 1.5. {_SEEN}",
        ),
        LineCommand("grip", "close the hand until it grips", lambda on, _: on.pendant.close()),
        LineCommand("width", "open the hand so wide", _width, "INCHES"),
        LineCommand("to", "go to a position", _go, "NUMBER or NAME"),
        LineCommand("forward", "on to the next position", lambda on, _: on.pendant.step(1)),
        LineCommand(
            "backward",
            "back to the position before",
            lambda on, _: on.pendant.step(-1),
            "",
            "What the hand did on the way is undone, too.",
        ),
        LineCommand("through", "go through all positions", _through, "[round]"),
        LineCommand("delay", "the D of the pendant's @STEPs", _delay, "[D]"),
        LineCommand("comment", "a word on a position", _comment, "NUMBER WORDS"),
        LineCommand("holds", "the hand holds at a position, or not", _holds, "NUMBER"),
        LineCommand(
            "read",
            "positions of a listing",
            _read,
            "FILE|memory",
            "A listing in the style of Table 3 or 4, edited or not; those there are now go.",
        ),
    ),
)
