"""A game of our own from a SYSTEM tape: it polls the keyboard and draws in the video memory."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest

from trs80arm.rig import Key, Rig, Waiting

pytest.importorskip("z80", reason="the extra z80 is not installed")

ROOT = Path(__file__).parents[3]
TAPE = ROOT / "programs" / "catch.cas"


@pytest.fixture
def rig() -> Rig:
    """A machine on which the game has been begun."""
    rig = Rig()
    rig.insert_cassette("CATCH", TAPE.read_bytes())
    for line in ("SYSTEM", "CATCH"):
        rig.type(f"{line}\n")
        rig.run_until_waiting(60)
    rig.type("/\n")
    rig.run_for(0.5)
    return rig


def bat(rig: Rig) -> int:
    return rig.screen()[15].index("¿")


def test_the_tape_is_what_the_source_assembles_to() -> None:
    make = runpy.run_path(str(ROOT / "docs" / "make_catch.py"))
    assert TAPE.read_bytes() == make["tape"](), "run docs/make_catch.py"


def test_the_arrows_move_the_bat_and_the_base(rig: Rig) -> None:
    start, base = bat(rig), rig.joints[0]
    rig.hold([Key.RIGHT], 0.5)
    rig.run_for(0.6)
    moved = bat(rig) - start
    assert 20 < moved < 30
    assert abs(rig.joints[0] - base - 4 * moved) <= 8
    rig.hold([Key.LEFT], 0.5)
    rig.run_for(0.6)
    assert abs(bat(rig) - start) <= 2


def test_a_ball_falls_in_a_second_and_is_counted(rig: Rig) -> None:
    rig.run_for(1.2)
    first = rig.screen()[0]
    assert first.startswith("CATCH  CAUGHT 0")
    assert "1" in first


def test_five_balls_missed_end_it(rig: Rig) -> None:
    rig.hold([Key.LEFT], 12)
    rig.run_for(12)
    while rig.waiting is not Waiting.INPUT and rig.time < 120:
        rig.run_for(1)
    assert "GAME OVER" in rig.screen()[7]
    rig.type("X")
    assert rig.run_until_waiting(5) is Waiting.COMMAND


def test_break_is_the_games_own(rig: Rig) -> None:
    rig.hold([Key.BREAK], 0.1)
    rig.run_for(0.5)
    assert rig.waiting is Waiting.COMMAND
    assert not any(rig.card.latches)
