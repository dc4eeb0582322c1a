from __future__ import annotations

from textual.command import CommandPalette

from tests.ui.conftest import Opener
from tests.ui.piloted import piloted


@piloted
async def test_the_palette_is_not_opened_twice_below_a_dialog(sit_down: Opener) -> None:
    async with sit_down() as sitting:
        await sitting.press("ctrl+p")
        await sitting.app.run_action("do('help')")
        await sitting.press("ctrl+p")
        await sitting.settle()
        opened = [s for s in sitting.app.screen_stack if isinstance(s, CommandPalette)]
        assert len(opened) == 1
