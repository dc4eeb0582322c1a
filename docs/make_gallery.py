"""Makes the gallery: a picture of each task that comes along, and the page that shows them.

    python docs/make_gallery.py [NAME ...]

Writes docs/gallery.md and docs/gallery/*.svg, or of the pictures only those named. What the page
says of a program is its line in programs/README.md. The machine's clock is held, so the pictures
are the same every time.
"""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from make_screenshots import PROGRAMS, Scene, Sitting, drawn, filling, in_any_terminal, shoot

from trs80arm.bundled import described
from trs80arm.options import ArmStyle
from trs80arm.rig import Waiting

PAGE = Path(__file__).parent / "gallery.md"
FOLDER = Path(__file__).parent / "gallery"
SIZE = 96, 30
VIEW = ("space_left",) * 3 + ("space_higher",) * 2
"""How one walks around the arm first."""

HEAD = """# Gallery

The tasks that come along, each at a moment of its run, as the terminal draws them. Each opens by
its name from anywhere, `trs80arm NAME`, and F5 runs it; F11 is the arm large. `trs80arm run NAME`
runs it without a screen and ends with its score. How they are made is in
[programs/README.md](../programs/README.md).
"""


@dataclass(frozen=True)
class Shown:
    """A program of the gallery.

    Attributes:
        name: of the program.
        seconds: virtual ones from RUN to the moment that is shown.
    """

    name: str
    seconds: float


GALLERY = (
    Shown("draughts", 34.0),
    Shown("pegs", 39.0),
    Shown("pallet", 178.5),
    Shown("bridge", 102.5),
    Shown("carousel", 33.0),
    Shown("conveyor", 44.5),
    Shown("tending", 23.2),
    Shown("dominoes", 159.1),
    Shown("sort", 92.0),
    Shown("hanoi", 66.0),
    Shown("tower", 66.0),
    Shown("homing", 36.2),
    Shown("guarded", 76.5),
)


def at_work(shown: Shown) -> Scene:
    """A program some time after RUN."""

    async def scene(sitting: Sitting) -> None:
        rig = sitting.app.session.rig
        for command in VIEW:
            await sitting.app.run_action(f"do('{command}')")
        rig.type("RUN\r")
        begun = rig.time
        rig.run_until_waiting(shown.seconds)
        if rig.waiting is Waiting.SET:
            rig.hold(["0"], 0.1)
        rig.run_for(max(0.0, shown.seconds - (rig.time - begun)))
        sitting.app.pacer.forgive()
        sitting.app.say("")
        await sitting.pass_time(0.1)

    return scene


def page() -> str:
    """The page."""
    words = dict(described())
    parts = [HEAD]
    for shown in GALLERY:
        sentence = words[shown.name]
        parts.append(
            f"## {shown.name}\n\n{sentence[0].upper()}{sentence[1:].rstrip('.')}.\n\n"
            f"`trs80arm {shown.name}` · `trs80arm run {shown.name}`\n\n"
            f"![{shown.name} at work](gallery/{shown.name}.svg)\n"
        )
    return "\n".join(parts)


async def main(names: Sequence[str]) -> None:
    """Make all of it, or the pictures of some programs."""
    FOLDER.mkdir(exist_ok=True)
    for shown in GALLERY:
        if names and shown.name not in names:
            continue
        scene = filling("space", at_work(shown))
        program = PROGRAMS / f"{shown.name}.bas"
        await shoot(
            shown.name, SIZE, scene, drawn, folder=FOLDER, program=program, arm=ArmStyle.SEXTANT
        )
    PAGE.write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    in_any_terminal()
    asyncio.run(main(sys.argv[1:]))
