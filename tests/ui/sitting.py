"""A desk whose clocks the test holds: no time passes but what the test lets pass."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable, Sequence
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from functools import partial
from pathlib import Path
from typing import Any

from trs80arm.desk.opening import open_session
from trs80arm.options import ArmStyle, TerminalOptions
from trs80arm.rig import Waiting
from trs80arm.serial.endpoints import Port
from trs80arm.ui.app import Trs80Arm
from trs80arm.ui.panels.registry import PANELS, PanelRow

FRAME = 1 / 60


class Wall:
    """The wall's clock, in the test's hands.

    Attributes:
        now: what it says.
        look: seconds that pass while somebody looks at it.
    """

    def __init__(self) -> None:
        self.now = 1000.0
        self.look = 0.0

    def __call__(self) -> float:
        self.now += self.look
        return self.now


class Sitting:
    """A person at a desk in a test.

    Attributes:
        app: the program.
        pilot: Textual's own pilot, for sizes and mouse.
        wall: the wall's clock.
    """

    def __init__(self, app: Trs80Arm, pilot: Any, wall: Wall) -> None:
        self.app = app
        self.pilot = pilot
        self.wall = wall

    async def pass_time(self, seconds: float) -> None:
        """Let time pass, on the wall and in the machine, and draw."""
        for _ in range(round(seconds / FRAME)):
            self.wall.now += FRAME
            self.app.tick()
        await self.settle()

    async def settle(self) -> None:
        """Let Textual do what it was asked to, and draw what there is."""
        await self.pilot.pause()
        self.app.draw()
        await self.pilot.pause()

    async def press(self, *keys: str) -> None:
        """Press keys of the terminal, one after the other."""
        await self.pilot.press(*keys)

    async def type_line(self, text: str) -> None:
        """Type a line into the machine, through the typist."""
        self.app.session.rig.type(text + "\r")
        self.app.session.rig.run_until_waiting(60)
        self.app.pacer.forgive()
        await self.settle()

    async def begin_manual_mode(self) -> None:
        """Type @SET, and see what comes of it."""
        await self.type_line("@SET")
        assert self.app.session.rig.waiting is Waiting.SET
        await self.settle()

    async def run_program(self, listing: str, seconds: float) -> None:
        """Put a program into the machine, run it by its key, and let time pass."""
        self.app.session.rig.load_text(listing)
        await self.press("f5")
        await self.pass_time(seconds)

    @property
    def tube(self) -> str:
        """What the tube shows."""
        return self.app.desk.tube.text


Opener = Callable[..., AbstractAsyncContextManager[Sitting]]


def opener_in(folder: Path) -> Opener:
    """Opens the program at a size, with options; its state is kept in the folder."""
    return partial(_sitting, folder)


@asynccontextmanager
async def _sitting(
    folder: Path,
    width: int = 80,
    height: int = 24,
    panels: Sequence[PanelRow] = PANELS,
    *,
    first_time: bool = False,
    port: Port | None = None,
    **options: Any,
) -> AsyncIterator[Sitting]:
    wall = Wall()
    state = folder / "state"
    if not first_time and not state.is_file():
        state.mkdir(exist_ok=True)
        (state / "tour.json").write_text("{}")
    # Screens are compared as text: in bare lines they hang on nothing but themselves.
    chosen = TerminalOptions(**{"arm": ArmStyle.OUTLINE, **options})
    app = Trs80Arm(
        open_session(chosen), chosen, state, wall=wall, ticking=False, panels=panels, port=port
    )
    app.animation_level = "none"
    async with app.run_test(size=(width, height)) as pilot:
        await pilot.pause()
        sitting = Sitting(app, pilot, wall)
        await sitting.settle()
        yield sitting
