"""Settings: one file, the environment and flags; what cannot be is told with its place."""

from __future__ import annotations

import os
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
        (
            "[terminal]\nfps = 30\nspeed = 3\n",
            "line 3: terminal.speed: expected one of 0.05, 0.1",
        ),
        ("[terminal]\ncolour = 1\n", "line 2: terminal.colour: unknown key"),
        ("[terminal]\nfps = true\n", "line 2: terminal.fps: expected a whole number"),
        ("[terminal]\nfps = 600\n", "line 2: terminal.fps: fps must be 1 to 60, not 600"),
        ("\n[motor]\nx = 1\n", "line 2: motor: unknown table"),
        ("[machine]\nram = 20\n", "line 2: machine.ram: ram must be 4, 16, 32 or 48"),
        ("[card]\nbase = 300\n", "line 2: card.base: card base port 300"),
        ("[card]\norder = 5\n", "line 2: card.order: expected a list"),
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
        ("keys=never", "--option keys=never: expected one of auto, events, repeat, latch"),
    ],
)
def test_a_mistake_in_a_flag_names_the_flag(tmp_path: Path, option: str, told: str) -> None:
    with pytest.raises(SettingsError, match="--option") as caught:
        load(write(tmp_path / "s.toml", ""), [option], {})
    assert told in str(caught.value)


def test_a_mistake_in_the_environment_names_the_variable(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="TRS80ARM_FPS: expected a whole number"):
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
        '# mine\n[terminal]\ntheme = "amber"  # old\nglyphs = "ascii"\n[card]\nbase = 64\n'
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


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ('terminal.theme = "amber"\n', 'terminal.theme = "paper"\n'),
        ('terminal = {theme = "amber"} # mine\n', 'terminal = {theme = "paper"} # mine\n'),
        ('"terminal"."theme" = "amber"\n', '"terminal"."theme" = "paper"\n'),
        ("['terminal']\n'theme' = 'amber'\n", "['terminal']\n'theme' = \"paper\"\n"),
        (
            '[machine]\nmemory_size = """\n[terminal]\ntheme = 1\n"""\n[terminal]\ntheme="amber"\n',
            '[machine]\nmemory_size = """\n[terminal]\ntheme = 1\n"""\n[terminal]\ntheme="paper"\n',
        ),
        (
            "[card]\r\nbase = 64 # a\r\n[terminal]\r\nfps = 10\r\n",
            '[card]\r\nbase = 64 # a\r\n[terminal]\r\nfps = 10\r\ntheme = "paper"\r\n',
        ),
        ("[card]\nbase = 64\n", '[card]\nbase = 64\n\n[terminal]\ntheme = "paper"\n'),
        ("# nothing yet\n", '# nothing yet\n\n[terminal]\ntheme = "paper"\n'),
        ("", '[terminal]\ntheme = "paper"\n'),
    ],
)
def test_remembering_keeps_the_form_of_the_file(tmp_path: Path, before: str, after: str) -> None:
    path = tmp_path / "s.toml"
    path.write_bytes(before.encode())
    remember(path, "theme", "paper")
    assert path.read_bytes() == after.encode()
    if "memory_size" not in before:
        assert load(path, environment={}).terminal.theme == "paper"


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (b"[[terminal]]\ntheme = 'amber'\n", "terminal must be a table"),
        (b"terminal = 3\n", "terminal must be a table"),
        (b"terminal = \n", "line 1"),
        (b"theme = '\xff'\n", "not a text file"),
        (b"x = " + b"[" * 5000, "s.toml"),
    ],
)
def test_a_file_that_is_no_settings_file_is_left_as_it_is(
    tmp_path: Path, content: bytes, told: str
) -> None:
    path = tmp_path / "s.toml"
    path.write_bytes(content)
    with pytest.raises(SettingsError) as caught:
        remember(path, "theme", "paper")
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)
    assert path.read_bytes() == content


def test_a_file_that_may_not_be_written_is_left_as_it_is(unprivileged: Path) -> None:
    path = unprivileged / "s.toml"
    path.write_text("[terminal]\ntheme = 'amber'\n", encoding="utf-8")
    path.chmod(0o444)
    with pytest.raises(PermissionError):
        remember(path, "theme", "paper")
    assert path.read_text(encoding="utf-8") == "[terminal]\ntheme = 'amber'\n"


def test_the_line_of_a_mistake_is_found_behind_strings_of_several_lines(tmp_path: Path) -> None:
    text = '[machine]\nmemory_size = """\n[terminal]\nfps = 1\n"""\n[terminal]\nfps = 600\n'
    with pytest.raises(SettingsError, match=r"line 7: terminal\.fps"):
        load(write(tmp_path / "s.toml", text), environment={})


def test_what_is_a_text_may_look_like_a_number() -> None:
    flags = ["tapes=1980", "printer=1979-05-27", "memory_size=20000"]
    machine = load(Path(os.devnull), flags, {}).machine
    assert machine.tapes == Path("1980")
    assert machine.printer == Path("1979-05-27")
    assert machine.memory_size == "20000"


def test_a_file_may_begin_with_the_mark_of_utf_8(tmp_path: Path) -> None:
    path = tmp_path / "settings.toml"
    path.write_text("[machine]\nram = 32\n", encoding="utf-8-sig")
    assert load(path, (), {}).machine.ram == 32


@pytest.mark.parametrize(
    ("content", "told"),
    [
        ("[terminal]\n" + "# no end\n" * 50_000 + "nonsense = 1\n", "terminal.nonsense: unknown"),
        ("[machine]\nram = " + "9" * 5000, "a number has too many digits"),
        ("# no end\n" * 200_000, "longer than 1 MB, which no settings file is"),
    ],
    ids=["lines", "digits", "length"],
)
def test_a_file_that_is_too_long_is_told_of_at_once(
    tmp_path: Path, content: str, told: str
) -> None:
    path = tmp_path / "settings.toml"
    path.write_text(content)
    with pytest.raises(SettingsError, match=told) as error:
        load(path, (), {})
    assert str(error.value).startswith(f"{path}: ")


@pytest.mark.parametrize("text", ["9" * 5000, "[" * 5000, "nan", "inf", "1e999"])
@pytest.mark.parametrize("key", ["fps", "speed", "arm.speed_margin", "card.order"])
def test_no_flag_is_too_odd_for_one_line(tmp_path: Path, key: str, text: str) -> None:
    with pytest.raises(SettingsError) as caught:
        load(write(tmp_path / "s.toml", ""), [f"{key}={text}"], {})
    assert len(str(caught.value)) < 6000
    assert "\n" not in str(caught.value)
