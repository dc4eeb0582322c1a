"""The terminal shows the arm that a client moves over its serial line."""

from __future__ import annotations

import sys

import pytest

from tests.desk.test_served import Client
from tests.serial.lab import SETTINGS
from tests.ui.piloted import piloted
from tests.ui.screen_text import screen_text
from tests.ui.sitting import Opener, Sitting
from trs80arm.serial.endpoints import PseudoTerminal


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


@pytest.mark.skipif(sys.platform == "win32", reason="no pseudo-terminals")
@piloted
async def test_a_client_of_pyserial_teaches_reads_steps_and_grips_and_the_screen_shows_it(
    sit_down: Opener,
) -> None:
    serial = pytest.importorskip("serial")
    port = PseudoTerminal()
    async with sit_down(120, 40, rig=SETTINGS, port=port) as sitting:
        with serial.Serial(port.name, 9600, timeout=0) as line:

            async def ask(command: bytes, seconds: float = 2.0) -> bytes:
                line.write(command)
                await sitting.pass_time(seconds)
                return line.read(1000)

            assert await ask(b"@STEP 230,200,-100\r") == b"1\r"
            assert "J1 base           200    200" in screen_text(sitting.app)
            assert await ask(b"@QWRITE 1,6401,0,0,0,0,0,0\r") == b"1\r"
            assert await ask(b"@RUN\r") == b"1\r"
            assert "J1 base             0      0" in screen_text(sitting.app)
            assert await ask(b"@CLOSE\r") == b"1\r"
            assert "grip closed" in screen_text(sitting.app)
            assert (await ask(b"@READ\r")).startswith(b"1\r0,0,0,0,0,-")
            line.write(b"@STEP 200,900\r")
            await sitting.pass_time(0.5)
            assert sitting.app.busy
        await sitting.pass_time(0.2)
        assert not sitting.app.served.moves
        assert f"{port.name} > (hung up)" in status(sitting)
    port.close()
