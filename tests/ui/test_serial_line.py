"""The terminal shows the arm that a client moves over its serial line."""

from __future__ import annotations

from tests.desk.test_served import Client
from tests.serial.lab import SETTINGS
from tests.ui.conftest import Opener, Sitting
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text


def status(sitting: Sitting) -> str:
    return screen_text(sitting.app).splitlines()[-2]


@piloted
async def test_the_arm_moves_and_the_status_says_what_goes_over_the_line(sit_down: Opener) -> None:
    client = Client()
    async with sit_down(120, 40, rig=SETTINGS, port=client) as sitting:
        await sitting.pass_time(0.2)
        assert "/dev/pts/80 nobody yet" in status(sitting)
        client.sending = b"@STEP 240,300\r"
        await sitting.pass_time(0.3)
        assert "/dev/pts/80 > @STEP 240,300" in status(sitting)
        assert 0 < sitting.app.session.rig.registers[0] < 300
        await sitting.pass_time(1.0)
        assert client.heard == b"1\r"
        assert "/dev/pts/80 < 1" in status(sitting)
        assert "300" in screen_text(sitting.app)


@piloted
async def test_escape_and_the_palette_have_its_stop_key(sit_down: Opener) -> None:
    client = Client()
    async with sit_down(rig=SETTINGS, port=client) as sitting:
        for way in ("escape", "ctrl+c", "command"):
            client.heard, client.sending = b"", b"@STEP 200,900\r"
            await sitting.pass_time(0.3)
            assert sitting.app.busy
            if way == "command":
                sitting.app.action_do("stop_arm")
            else:
                await sitting.press(way)
            await sitting.pass_time(0.3)
            assert client.heard == b"2\r", way
            assert "stopped" in status(sitting)


@piloted
async def test_the_lines_can_be_looked_at(sit_down: Opener) -> None:
    client = Client()
    async with sit_down(rig=SETTINGS, port=client) as sitting:
        client.sending = b"@READ\r"
        await sitting.pass_time(0.3)
        sitting.app.action_do("serial_line")
        await sitting.settle()
        assert sitting.app.dialog_is_open
        await sitting.press("escape")
        assert not sitting.app.dialog_is_open
