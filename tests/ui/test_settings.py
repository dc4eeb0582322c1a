"""Settings: one file, the environment and flags; what cannot be is told with its place."""

from __future__ import annotations

from pathlib import Path

import pytest

from trs80arm import settings
from trs80arm.machine.card import CardSettings, Jumper, Latch
from trs80arm.options import GlyphSet, KeyMode
from trs80arm.plain_values import as_table, from_table
from trs80arm.settings import SettingsError, load, remember


def write(path: Path, text: str) -> Path:
    path.write_text(text, encoding="utf-8")
    return path


def test_without_anything_set_everything_has_its_default(tmp_path: Path) -> None:
    made = load(write(tmp_path / "s.toml", ""), environment={})
    assert made.terminal == settings.TerminalSettings()
    assert made.machine.ram == 16
    assert made.card == CardSettings()


def test_flags_are_stronger_than_the_environment_and_that_than_the_file(tmp_path: Path) -> None:
    path = write(tmp_path / "s.toml", '[terminal]\nspeed = 2\nkeys = "latch"\nglyphs = "ascii"\n')
    made = load(path, ["speed=20"], {"TRS80ARM_SPEED": "5", "TRS80ARM_KEYS": "repeat"})
    assert made.terminal.speed.factor == 20
    assert made.terminal.keys is KeyMode.REPEAT
    assert made.terminal.glyphs is GlyphSet.ASCII


def test_the_rooms_settings_are_reached_by_table_and_key(tmp_path: Path) -> None:
    path = write(
        tmp_path / "s.toml",
        '[card]\njumper = "parallel"\ncoil_bits = [0, 1, 2, 3]\n[driver]\nset_delay = 20\n',
    )
    made = load(path, ["card.base=0x40"], {"TRS80ARM_ARM_SPEED_MARGIN": "2"})
    assert made.card.jumper is Jumper.PARALLEL
    assert made.card.base == 0x40
    assert made.card.coil_bits == (0, 1, 2, 3)
    assert made.driver.set_delay == 20
    assert made.arm.speed_margin == 2.0
    assert made.rig().card is made.card


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("[terminal]\nfps = 30\nspeed = 3\n", "line 3: terminal.speed: must be one of 1, 2, 5, 20"),
        ("[terminal]\ncolour = 1\n", "line 2: terminal.colour: unknown key"),
        ("[terminal]\nfps = true\n", "line 2: terminal.fps: must be a whole number, not True"),
        ("[terminal]\nfps = 600\n", "line 2: terminal.fps: fps must be 1 to 60, not 600"),
        ("\n[motor]\nx = 1\n", "line 2: motor: unknown table"),
        ("[machine]\nram = 20\n", "line 2: machine.ram: ram must be 4, 16, 32 or 48"),
        ("[card]\nbase = 300\n", "line 2: card.base: card base port 300"),
        ("[card]\norder = 5\n", "line 2: card.order: must be a list"),
        ("speed 3\n", "line 1"),
    ],
)
def test_a_mistake_is_told_with_file_line_and_key(tmp_path: Path, text: str, told: str) -> None:
    path = write(tmp_path / "s.toml", text)
    with pytest.raises(SettingsError) as caught:
        load(path, environment={})
    message = str(caught.value)
    assert message.startswith(str(path))
    assert told in message
    assert "\n" not in message


@pytest.mark.parametrize(
    ("option", "told"),
    [
        ("speed", "--option speed: must be KEY=VALUE"),
        ("tube.speed=1", "--option tube.speed=1: unknown table tube"),
        ("speeed=1", "--option speeed=1: unknown key"),
        ("keys=never", "--option keys=never: must be one of auto, events, repeat, latch"),
    ],
)
def test_a_mistake_in_a_flag_names_the_flag(tmp_path: Path, option: str, told: str) -> None:
    with pytest.raises(SettingsError, match="--option") as caught:
        load(write(tmp_path / "s.toml", ""), [option], {})
    assert told in str(caught.value)


def test_a_mistake_in_the_environment_names_the_variable(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="TRS80ARM_FPS: must be a whole number"):
        load(write(tmp_path / "s.toml", ""), environment={"TRS80ARM_FPS": "fast"})


def test_a_named_file_must_be_there(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="no such file"):
        load(tmp_path / "none.toml", environment={})


def test_remembering_leaves_the_rest_of_the_file_alone(tmp_path: Path) -> None:
    path = write(
        tmp_path / "s.toml", '# mine\n[terminal]\ntheme = "green"  # old\n[card]\nbase = 64\n'
    )
    remember(path, "theme", "amber")
    remember(path, "glyphs", "ascii")
    assert path.read_text(encoding="utf-8") == (
        '# mine\n[terminal]\nglyphs = "ascii"\ntheme = "amber"\n[card]\nbase = 64\n'
    )
    made = load(path, environment={})
    assert (made.terminal.theme, made.terminal.glyphs) == ("amber", GlyphSet.ASCII)


def test_remembering_makes_the_file(tmp_path: Path) -> None:
    path = tmp_path / "deep" / "s.toml"
    remember(path, "cursor", "steady")
    assert load(path, environment={}).terminal.cursor.value == "steady"


def test_settings_survive_the_way_through_plain_values() -> None:
    card = CardSettings(order=(Latch.HAND, *tuple(Latch)[:5], None, None), switch_bit=2)
    assert from_table(CardSettings, as_table(card), "card") == card
