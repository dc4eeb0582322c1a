"""Which keys of the TRS-80 today's keys are."""

from __future__ import annotations

import pytest

from trs80arm.machine.keys import Key
from trs80arm.ui.commands.table import COMMANDS
from trs80arm.ui.keys.host_keys import trs80_keys


@pytest.mark.parametrize(
    ("name", "text", "keys"),
    [
        ("a", "a", (Key.A,)),
        ("A", "A", (Key.A,)),
        ("quotation_mark", '"', (Key.SHIFT, Key.N2)),
        ("circumflex_accent", "^", (Key.UP,)),
        ("left_square_bracket", "[", (Key.UP,)),
        ("at", "@", (Key.AT,)),
        ("equals_sign", "=", (Key.SHIFT, Key.MINUS)),
        ("escape", "\x1b", (Key.BREAK,)),
        ("backspace", "\x7f", (Key.LEFT,)),
        ("shift+left", None, (Key.SHIFT, Key.LEFT)),
        ("tab", "\t", (Key.RIGHT,)),
        ("home", None, (Key.CLEAR,)),
        ("ctrl+l", None, (Key.CLEAR,)),
        ("space", None, (Key.SPACE,)),
        ("enter", "\r", (Key.ENTER,)),
        ("ctrl+h", "\x08", (Key.LEFT,)),
        ("7", None, (Key.N7,)),
    ],
)
def test_a_key_is_what_it_means(name: str, text: str | None, keys: tuple[Key, ...]) -> None:
    assert trs80_keys(name, text) == keys


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("f1", None),
        ("ctrl+p", None),
        ("left_shift", None),
        ("alt+a", "a"),
        ("é", "é"),
        ("ctrl+c", "\x03"),
    ],
)
def test_the_rest_is_not_the_machines(name: str, text: str | None) -> None:
    assert trs80_keys(name, text) is None


def test_no_key_of_a_command_is_one_of_the_machines() -> None:
    keys = [key for command in COMMANDS for key in command.keys.split(",") if key]
    assert [key for key in keys if trs80_keys(key, None)] == []
    assert sorted(keys) == sorted(set(keys))
