"""Golden pictures of the arm at work: the layouts, the view in space, the scope, strip charts.

As text at all sizes, and where colours and blocks say more as SVG, to be opened in a browser.
"""

from __future__ import annotations

from typing import Any

import pytest

from tests.goldens import check_golden
from tests.own_places import PROGRAMS
from tests.ui.piloted import piloted
from tests.ui.sitting import Opener, Sitting
from tests.ui.test_screens import screen_text, shape
from trs80arm.film.frames import Film
from trs80arm.film.svg import svg
from trs80arm.options import ArmStyle
from trs80arm.ui.filming import picture

SIZES = [(80, 24), (100, 30), (120, 40), (200, 60)]
AT_WORK = {"program": PROGRAMS / "table4.bas", "arm": ArmStyle.ASCII}
BELOW = 2
"""Rows below the panels: the status, and the keys."""
SHOWN_BY = {"side": "zoom", "space": "fill_space", "scope": "fill_scope"}
"""The commands that bring views to all of the screen."""
STYLES = [ArmStyle.HALF, ArmStyle.SEXTANT, ArmStyle.BRAILLE]
"""Those whose characters are shapes; the others are in the pictures at all sizes."""


async def carry_a_part(sitting: Sitting) -> None:
    """Let the program of Table 4 carry its first part halfway to the tray."""
    rig = sitting.app.session.rig
    rig.type("RUN\r")
    rig.run_until_waiting(10)
    rig.hold(["0"], 0.1)
    rig.run_for(12)
    sitting.app.pacer.forgive()
    await sitting.pass_time(0.1)


def check_panels(name: str, app: Any) -> None:
    """Compare the panels with the golden text of that name; what is below is tested elsewhere."""
    lines = screen_text(app).splitlines()[:-BELOW]
    check_golden(name, "\n".join(lines) + "\n")


def check_picture(name: str, app: Any) -> None:
    """Compare the panels with the SVG of that name."""
    still = Film(app.size.width, app.size.height - BELOW, name)
    still.add(0.0, picture(app)[:-BELOW])
    check_golden(name, svg(still).decode(), "svg")


@pytest.mark.parametrize(("width", "height"), [*SIZES, (200, 24), (60, 60)])
@piloted
async def test_layouts_while_the_arm_works(sit_down: Opener, width: int, height: int) -> None:
    async with sit_down(width, height, **AT_WORK) as sitting:
        await carry_a_part(sitting)
        check_panels(f"work-{shape(width, height)}", sitting.app)
        if (width, height) in SIZES:
            sitting.app.desk.use_arm_style(ArmStyle.SEXTANT)
            await sitting.settle()
            check_picture(f"work-{shape(width, height)}", sitting.app)


@pytest.mark.parametrize(("width", "height"), SIZES)
@piloted
async def test_the_views_that_fill_the_screen(sit_down: Opener, width: int, height: int) -> None:
    async with sit_down(width, height, **AT_WORK) as sitting:
        await carry_a_part(sitting)
        for name in ("side", "space", "scope", "strips"):
            if name == "strips":
                await sitting.press("alt+down", "alt+down")
            else:
                await sitting.app.run_action(f"do('{SHOWN_BY[name]}')")
            await sitting.settle()
            check_panels(f"large-{name}-{shape(width, height)}", sitting.app)
            check_picture(f"large-{name}-{shape(width, height)}", sitting.app)


@piloted
async def test_the_arm_in_space_in_all_styles(sit_down: Opener) -> None:
    async with sit_down(100, 30, **AT_WORK) as sitting:
        await carry_a_part(sitting)
        await sitting.app.run_action("do('fill_space')")
        for style in STYLES:
            sitting.app.desk.use_arm_style(style)
            await sitting.settle()
            check_picture(f"large-space-{style}", sitting.app)
