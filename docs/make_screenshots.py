"""Makes the manual's screenshots from the running program, in docs/screenshots.

    python docs/make_screenshots.py

The machine's clock is held and let go by the script, so the pictures are the same every time.
"""

from __future__ import annotations

import asyncio
import os
import tempfile
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

from PIL.Image import Image

from trs80arm.arm.geometry import Pose
from trs80arm.arm.settings import ArmSettings
from trs80arm.desk.opening import open_session
from trs80arm.drawing.readings import Readings
from trs80arm.film.frames import Film
from trs80arm.film.svg import svg
from trs80arm.options import ArmStyle, TerminalOptions
from trs80arm.rig import RigSettings
from trs80arm.ui.app import Trs80Arm
from trs80arm.ui.filming import Wall, picture
from trs80arm.ui.terminal.pixels import image_of

FOLDER = Path(__file__).parent / "screenshots"
PROGRAMS = Path(__file__).parents[1] / "programs"
TICK = 1 / 60


def in_any_terminal() -> None:
    """Have the pictures be the same whatever terminal they are made in."""
    os.environ["LANG"] = "C.UTF-8"
    os.environ.pop("NO_COLOR", None)


class Sitting:
    """The program with its clocks held."""

    def __init__(self, app: Any, pilot: Any, wall: Wall) -> None:
        self.app = app
        self.pilot = pilot
        self._wall = wall

    async def pass_time(self, seconds: float) -> None:
        """Let time pass."""
        for _ in range(round(seconds / TICK)):
            self._wall.now += TICK
            self.app.tick()
        await self.pilot.pause()
        self.app.draw()
        await self.pilot.pause()

    async def type(self, text: str) -> None:
        """Type, and wait until the machine waits again."""
        self.app.session.rig.type(text)
        self.app.session.rig.run_until_waiting(60)
        self.app.pacer.forgive()
        await self.pass_time(0.2)


Scene = Callable[[Sitting], Awaitable[None]]


async def start(sitting: Sitting) -> None:
    """The first start."""
    await sitting.pass_time(0.2)


async def manual(sitting: Sitting) -> None:
    """Manual mode with two keys held and the keyboard shown."""
    await sitting.type("@SET\r")
    await sitting.app.run_action("do('show_keyboard')")
    sitting.app.keyboard.held.latch(("1", "W"))
    await sitting.pass_time(0.6)


async def table4(sitting: Sitting) -> None:
    """Table 4 at work."""
    await sitting.type("RUN\r")
    sitting.app.session.rig.hold(["0"], 0.1)
    await sitting.pass_time(14.5)


async def jogged(sitting: Sitting) -> None:
    """Manual mode in a small window, with a key held."""
    await sitting.type("@SET\r")
    sitting.app.keyboard.held.latch(("1",))
    await sitting.pass_time(0.6)


async def slipped(sitting: Sitting) -> None:
    """A shoulder driven into its stop: register and arm differ."""
    await sitting.type("CLS\r")
    await sitting.type("@STEP 50,0,-3000,0,0,0,200\r")
    await sitting.pass_time(0.5)


async def by_hand(sitting: Sitting) -> None:
    """The arm moved by hand, above the part."""
    await sitting.app.run_action("do('hand_move')")
    sitting.app.session.rig.move_to(Pose(8.0, 0.0, 1.5, -90.0, 0.0, 0.8))
    await sitting.pass_time(0.1)
    await sitting.pass_time(0.1)


async def pendant(sitting: Sitting) -> None:
    """Positions taught, and the pendant with them."""
    for line in (
        *("@STEP 50,0,-207,290,0,0,340", "@STEP 50,0,132,-36", "@CLOSE"),
        *("@STEP 100,0,-132,36", "@STEP 50,651,-8,-13,-461,-462"),
        *("@STEP 50,0,135,-37", "@STEP 50,0,0,0,0,0,312"),
    ):
        await sitting.type(line + "\r")
        await sitting.app.run_action("do('teach_here')")
    await sitting.app.run_action("do('teach')")
    await sitting.pilot.pause()
    sitting.app.pendant.press(2, 1)
    for _ in range(2):
        await sitting.pass_time(0.8)
        sitting.app.screen.show()


async def taught_program(sitting: Sitting) -> None:
    """The program of the positions."""
    await pendant(sitting)
    await sitting.pilot.press("l")
    await sitting.pass_time(0.1)


async def base_pendant(sitting: Sitting) -> None:
    """The TeachMover's own pendant: a pick taught, a number being typed, a joint key held."""
    sitting.app.session.rig.move_to(Pose(8.0, 0.0, 0.5, -90.0, 0.0, 0.8))
    await sitting.app.run_action("do('teach')")
    await sitting.pilot.pause()
    screen, base = sitting.app.screen, sitting.app.base_pendant

    async def push(*keys: str) -> None:
        for key in keys:
            await sitting.pilot.press(key)
            await sitting.pass_time(0.2)

    async def hold(axis: int, way: int, seconds: float) -> None:
        base.press(axis, way)
        await sitting.pass_time(seconds)
        base.release(axis, way)
        await sitting.pass_time(0.1)

    await push("v", "7", "enter", "a", "a", "p", "2", "enter", "g")
    await sitting.pass_time(1.5)
    await hold(1, 1, 0.8)
    await push("a")
    await hold(0, 1, 1.2)
    await push("a", "j", "1", "enter", "4")
    base.press(0, 1)
    screen.show()
    await sitting.pilot.pause()


async def effort(sitting: Sitting) -> None:
    """A stretched arm that lifts itself: the shoulder is near what it can."""
    rig = sitting.app.session.rig
    for joint, degrees in (("elbow", 0.0), ("pitch", 0.0), ("shoulder", 8.0)):
        rig.move_joint(joint, degrees)
    await sitting.type("@RESET:CLS\r")
    await sitting.app.run_action("do('show_effort')")
    sitting.app.pacer.hurries = False
    rig.type("@STEP 80,150,-240,0,0,0,100\r")
    await sitting.pass_time(3.0)


async def tapes(sitting: Sitting) -> None:
    """The recorder at work: a search that came by another program."""
    rig = sitting.app.session.rig
    rig.insert_cassette("TASKS")
    for name in "AB":
        await sitting.type(f'CSAVE "{name}"\r')
    rig.rewind_cassette()
    await sitting.app.run_action("do('show_tapes')")
    sitting.app.pacer.hurries = False
    rig.type('CLOAD "B"\r')
    await sitting.pass_time(2.5)


async def tour(sitting: Sitting) -> None:
    """The tour, at the part that is to be lifted."""
    tour = sitting.app.tour
    for _ in range(4):
        tour.skip()
    await sitting.type("")
    await sitting.type("@STEP 60,0,-60,-60\r")


async def debugged(sitting: Sitting) -> None:
    """A program at a breakpoint, in the debugger."""
    app = sitting.app
    app.debugger.set(5000, "U>2")
    await sitting.type("RUN\r")
    app.session.rig.hold(["0"], 0.1)
    for _ in range(40):
        await sitting.pass_time(0.5)
        if app.debugger.stop is not None:
            break


async def remembered(sitting: Sitting) -> None:
    """Two statements before the breakpoint, with memory."""
    await debugged(sitting)
    await sitting.pilot.press("b", "b", "m")
    await sitting.pass_time(0.1)


def action(name: str) -> Scene:
    """A dialog."""

    async def scene(sitting: Sitting) -> None:
        await sitting.app.run_action(f"do('{name}')")
        await sitting.pass_time(0.1)

    return scene


def filling(panel: str, scene: Scene) -> Scene:
    """A scene, seen in one panel on all of the screen."""

    async def large(sitting: Sitting) -> None:
        await scene(sitting)
        await sitting.app.run_action(f"do('fill_{panel}')")
        await sitting.pass_time(0.1)

    return large


def framed(app: Any) -> str:
    """The window as Textual has it, with a frame around."""
    return str(app.export_screenshot(title="trs80arm"))


def drawn(app: Any) -> str:
    """The window with blocks drawn as shapes, which few fonts have without gaps."""
    still = Film(app.size.width, app.size.height, "trs80arm")
    still.add(0.0, picture(app))
    return svg(still).decode("utf-8")


def in_pixels(app: Any) -> Image:
    """What a terminal with pixels is sent of the arm in space."""
    view = app.desk.panels["space"]
    width, height = view.size
    cell = (10, 20)
    pixels = view.picture.pixels(Readings.of(app.session.rig), width, height - 1, (20, 40))
    return image_of(pixels, view.colours, (width * cell[0], (height - 1) * cell[1]))


async def shoot(
    name: str,
    size: tuple[int, int],
    scene: Scene,
    take: Callable[[Any], str | Image] = framed,
    folder: Path = FOLDER,
    **options: Any,
) -> None:
    """Make one picture, in a folder."""
    wall = Wall()
    chosen = TerminalOptions(**options)
    with tempfile.TemporaryDirectory() as state:
        session = open_session(chosen)
        app = Trs80Arm(session, chosen, Path(state), wall=wall, ticking=False)
        async with app.run_test(size=size) as pilot:
            await pilot.pause()
            await scene(Sitting(app, pilot, wall))
            taken = take(app)
    if isinstance(taken, str):
        (folder / f"{name}.svg").write_text(taken, encoding="utf-8")
    else:
        taken.quantize(128).save(folder / f"{name}.png", optimize=True)
    print(name)


async def main() -> None:
    """Make all of them."""
    FOLDER.mkdir(exist_ok=True)
    program = PROGRAMS / "table4.bas"
    await shoot("start", (120, 40), start)
    await shoot("small", (80, 24), jogged)
    await shoot("huge", (200, 60), table4, program=program)
    await shoot("settings", (100, 30), action("settings"))
    await shoot("table4", (120, 40), table4, program=program)
    await shoot("braille", (120, 40), table4, program=program, arm=ArmStyle.BRAILLE)
    space = filling("space", table4)
    await shoot("space", (100, 32), space, drawn, program=program)
    await shoot("space-blocks", (100, 32), space, drawn, program=program, arm=ArmStyle.SEXTANT)
    await shoot("pixels", (90, 32), space, in_pixels, program=program)
    await shoot("scope", (110, 34), filling("scope", table4), drawn, program=program)
    await shoot("debugger", (120, 40), debugged, program=program)
    await shoot("debugger-memory", (80, 24), remembered, program=program)
    await shoot("manual", (120, 40), manual)
    await shoot("slipped", (120, 40), slipped, theme="amber")
    await shoot("effort", (80, 24), effort, program=program)
    await shoot("by-hand", (100, 30), by_hand)
    bench = PROGRAMS / "table4.toml"
    await shoot("pendant", (120, 40), pendant, bench=bench)
    await shoot("taught-program", (100, 36), taught_program, bench=bench, theme="paper")
    arm = ArmSettings(model="teachmover")
    rig = RigSettings(controller=True, arm=arm)
    await shoot("base-pendant", (120, 36), base_pendant, rig=rig, bench=bench)
    await shoot("tour", (100, 30), tour, tour=True)
    await shoot("tapes", (80, 24), tapes, program=PROGRAMS / "table2.bas")
    await shoot("open", (100, 30), action("open"), theme="white")
    await shoot("help", (100, 30), action("help"))


if __name__ == "__main__":
    in_any_terminal()
    asyncio.run(main())
