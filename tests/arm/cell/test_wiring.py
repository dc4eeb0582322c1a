"""The auxiliary latch's four bits: each has one listener, and the bench file says who."""

from __future__ import annotations

import pytest

from tests.arm.refusals import refusal
from trs80arm.arm import benchfile

COILS = "[[turntable]]\nat = [6, 4]\nradius = 1\n"
PULSED = COILS + 'drive = "pulse"\n'


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (
            COILS + COILS.replace("4", "-4"),
            "b.toml: turntable[2].drive: expected a free bit; "
            "bit 0 of the auxiliary latch is already that of turntable",
        ),
        (
            'name = "b"\n' + PULSED + "name = 'dial'\npulse = 2\n" + COILS.replace("4", "-4"),
            "b.toml: turntable[2].drive: expected a free bit; "
            "bit 2 of the auxiliary latch is already that of turntable 'dial'",
        ),
        (
            PULSED + "pulse = 1\n" + PULSED.replace("4", "-4") + "pulse = 0\ndirection = 1\n",
            "b.toml: turntable[2].direction: expected a free bit; "
            "bit 1 of the auxiliary latch is already that of turntable",
        ),
        (
            PULSED + "pulse = 3\ndirection = 3\n",
            "b.toml: turntable[1].direction: expected a free bit; "
            "bit 3 of the auxiliary latch is already named by pulse",
        ),
        (
            COILS + "[selector]\nbits = [3, 1]\n",
            "b.toml: turntable[1].drive: expected a free bit; "
            "bit 1 of the auxiliary latch is already that of the selector",
        ),
        (PULSED, "b.toml: turntable[1].pulse: expected a whole number from 0 to 3"),
        (
            PULSED + "pulse = 4\n",
            "b.toml: turntable[1].pulse: expected a whole number from 0 to 3",
        ),
        (
            COILS + "pulse = 1\n",
            "b.toml: turntable[1].pulse: expected nothing by that name; "
            "the keys here are name, at, radius, steps, drive",
        ),
        (
            COILS + 'drive = "belt"\n',
            "b.toml: turntable[1].drive: expected one of coils, pulse",
        ),
        (
            PULSED + "pulse = 0\n" + PULSED + "pulse = 1\n",
            "b.toml: turntable[2].at: expected a free place; it overlaps turntable",
        ),
        (
            PULSED + "name = 'a'\npulse = 0\n" + PULSED + "name = 'a'\npulse = 1\n",
            "b.toml: turntable[2].name: expected a name that no other turntable has",
        ),
    ],
)
def test_a_wrong_wiring_is_one_line_that_names_table_and_key(text: str, line: str) -> None:
    assert refusal(text) == line


def test_one_turntable_may_be_written_as_a_table_and_several_as_tables() -> None:
    alone = benchfile.parse("[turntable]\nat = [6, 4]\nradius = 1\n")
    both = benchfile.parse(
        PULSED + "pulse = 0\n" + PULSED.replace("4", "-4") + 'name = "dial"\npulse = 1\n'
    )
    assert [device.title for device in alone.cell.devices] == ["turntable"]
    assert [device.title for device in both.cell.devices] == ["turntable", "turntable 'dial'"]
    assert [dict(device.wires) for device in both.cell.devices] == [{"pulse": 0}, {"pulse": 1}]
