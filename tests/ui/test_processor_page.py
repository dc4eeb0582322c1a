"""The debugger's page for machine code, by keyboard alone."""

from __future__ import annotations

import pytest
from textual.widgets import Input, OptionList, Static

from tests.desk.test_code_debugger import PROGRAM
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.ui.screens.ask_line import AskLine
from trs80arm.ui.screens.processor import ProcessorScreen

pytest.importorskip("z80", reason="the extra z80 is not installed")


def page(sitting: Sitting) -> ProcessorScreen:
    screen = sitting.app.screen
    assert isinstance(screen, ProcessorScreen)
    return screen


def said(sitting: Sitting, part: str = "where") -> str:
    return str(page(sitting).query_one(f"#{part}", Static).visual)


def marked(sitting: Sitting) -> str:
    options = page(sitting).query_one("#code", OptionList)
    return str(options.get_option_at_index(options.highlighted or 0).prompt)


async def answered(sitting: Sitting, key: str, text: str) -> None:
    await sitting.press(key)
    await sitting.settle()
    asked = sitting.app.screen
    assert isinstance(asked, AskLine)
    asked.query_one(Input).value = text
    await sitting.press("enter")
    await sitting.settle()


@pytest.mark.parametrize(("width", "height"), [(80, 24), (120, 40)])
def test_code_is_stopped_and_stepped_by_keys(sit_down: Opener, width: int, height: int) -> None:
    @piloted
    async def step() -> None:
        async with sit_down(width, height) as sitting:
            sitting.app.session.rig.load_text(PROGRAM)
            await sitting.app.run_action("do('processor')")
            await sitting.settle()
            assert said(sitting).startswith("No code stands here")
            await answered(sitting, "a", "7002H")
            await sitting.press("space")
            assert marked(sitting).startswith("* 7002")
            await sitting.press("escape", "f5")
            for _ in range(80):
                await sitting.pass_time(0.1)
                if isinstance(sitting.app.screen, ProcessorScreen):
                    break
            assert said(sitting) == "Breakpoint at 7002H: CALL 700AH"
            assert said(sitting, "registers").startswith("PC 7002  SP ")
            assert marked(sitting) == "*>7002 CD0A70   CALL 700AH"
            await sitting.press("f7")
            assert marked(sitting) == " >700A C5       PUSH BC"
            await sitting.press("u")
            assert marked(sitting) == " >7005 3D       DEC A"
            await answered(sitting, "m", "7000H")
            lines = screen_text(sitting.app)
            assert "7000  3E 05 CD 0A 70 3D 20 FA" in lines
            assert " >7005 3D       DEC A" in lines
            assert max(map(len, lines.splitlines())) <= width
            await sitting.press("c", "g")
            await sitting.settle()
            assert not isinstance(sitting.app.screen, ProcessorScreen)

    step()
