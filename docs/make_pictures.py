"""Makes the manual's pictures from the running program: python docs/make_pictures.py [NAME ...].

The program runs without a terminal, its clocks in this script's hands, so that the same version
makes the same pictures.
"""

from __future__ import annotations

import asyncio
import os
import sys
import tempfile
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

from trs80arm.basic.activity import Waiting
from trs80arm.options import ArmStyle, CursorStyle, TerminalOptions
from trs80arm.ui.app import Trs80Arm, open_session

HERE = Path(__file__).parent
PROGRAMS = HERE.parent / "programs"
PICTURES = HERE / "pictures"
FRAME = 1 / 30


class Photographer:
    """Someone at the desk with a camera.

    Args:
        width: columns of the terminal.
        height: rows of the terminal.
        options: how the program is started.
    """

    def __init__(self, width: int, height: int, **options: Any) -> None:
        self.size = (width, height)
        self.now = 1000.0
        chosen = TerminalOptions(**{"cursor": CursorStyle.STEADY, **options})
        self.app = Trs80Arm(
            open_session(chosen),
            chosen,
            Path(os.environ["TRS80ARM_STATE"]),
            wall=lambda: self.now,
            ticking=False,
        )
        self.app.animation_level = "none"
        self.pilot: Any = None

    @property
    def rig(self) -> Any:
        """The machine on the desk."""
        return self.app.session.rig

    async def wait(self, seconds: float) -> None:
        """Let time pass, on the wall and in the machine."""
        for _ in range(round(seconds / FRAME)):
            self.now += FRAME
            self.app.tick()
        self.app.draw()
        await self.pilot.pause()

    async def type(self, line: str) -> None:
        """Type a line into the machine and let it answer."""
        self.rig.type(line + "\r")
        await self.wait(1.5)

    async def press(self, *keys: str) -> None:
        """Press keys of the terminal."""
        await self.pilot.press(*keys)
        await self.wait(0.2)

    async def set_arm_and_go(self) -> None:
        """Begin Table 4's program: open the hand, say 0."""
        await self.type("RUN")
        self.rig.run_until(lambda rig: rig.waiting is Waiting.SET, 30)
        await self.wait(0.3)
        self.rig.hold(["6"], 1.0)
        await self.wait(1.2)
        self.rig.hold(["0"], 0.2)
        await self.wait(0.5)


Shot = Callable[[Photographer], Awaitable[None]]


async def start(desk: Photographer) -> None:
    """A first start."""
    await desk.wait(1)


async def table4(desk: Photographer) -> None:
    """Table 4 at work, the part on its way."""
    await desk.set_arm_and_go()
    await desk.wait(4.2)


async def slipped(desk: Photographer) -> None:
    """An arm that was driven too fast."""
    await desk.type("@STEP 50,300,-207,290,-100,100,300")
    await desk.wait(3)
    await desk.type("@STEP 0,-200,300,-250")
    await desk.wait(2)


async def keyboard(desk: Photographer) -> None:
    """The TRS-80's keyboard, two keys held in manual mode."""
    await desk.type("@SET")
    await desk.press("ctrl+k")
    desk.rig.press("1")
    desk.rig.press("W")
    await desk.wait(0.8)


async def by_hand(desk: Photographer) -> None:
    """The arm moved by hand."""
    await desk.press("ctrl+g")
    await desk.press(
        *"8",
        "space",
        *"0",
        "space",
        *"1.5",
        "space",
        *"-90",
        "space",
        *"0",
        "space",
        *"0.8",
        "enter",
    )
    await desk.wait(0.5)
    await asyncio.sleep(0.2)


async def teach(desk: Photographer) -> None:
    """Positions taught, and a program of them."""
    steps = (
        *("@STEP 50,0,-207,290,0,0,340", "@STEP 50,0,132,-36", "@CLOSE"),
        *("@STEP 100,0,-132,36,0,0,-30", "@STEP 50,651,-8,-13,-461,-462"),
        *("@STEP 50,0,135,-37", "@STEP 50,0,0,0,0,0,342"),
    )
    for line in steps:
        desk.rig.type(line + "\r")
        desk.rig.run_until_waiting(30)
        await desk.press("ctrl+t")
    await desk.press("f12")
    await desk.wait(0.2)


SHOTS: dict[str, tuple[Shot, int, int, dict[str, Any]]] = {
    "start": (start, 80, 24, {}),
    "table4": (table4, 120, 40, {"program": PROGRAMS / "table4.bas"}),
    "slipped": (slipped, 100, 30, {"arm_style": ArmStyle.BRAILLE, "theme": "amber"}),
    "keyboard": (keyboard, 100, 30, {"theme": "white"}),
    "by-hand": (by_hand, 100, 30, {}),
    "teach": (teach, 100, 36, {"bench": PROGRAMS / "table4.toml", "theme": "paper"}),
}


async def take(name: str) -> None:
    """Take one picture."""
    shot, width, height, options = SHOTS[name]
    desk = Photographer(width, height, **options)
    async with desk.app.run_test(size=desk.size) as pilot:
        desk.pilot = pilot
        await pilot.pause()
        await shot(desk)
        await pilot.pause()
        picture = desk.app.export_screenshot(title="trs80arm")
    PICTURES.mkdir(exist_ok=True)
    (PICTURES / f"{name}.svg").write_text(picture, encoding="utf-8")
    print(f"{name}.svg  {len(picture) // 1024} kB")


def main() -> None:
    """Take the pictures named, or all."""
    names = sys.argv[1:] or list(SHOTS)
    with tempfile.TemporaryDirectory() as folder:
        os.environ["TRS80ARM_STATE"] = folder
        os.environ["TRS80ARM_CONFIG"] = str(Path(folder) / "settings.toml")
        for name in names:
            asyncio.run(take(name))


if __name__ == "__main__":
    main()
