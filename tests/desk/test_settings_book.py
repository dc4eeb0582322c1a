"""Every setting has a meaning; it is changed for now and saved when asked."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from trs80arm.desk.settings_book import SettingsBook
from trs80arm.settings_catalogue import Setting, catalogue, meanings_of


def setting(name: str) -> Setting:
    return next(each for each in catalogue() if each.name == name)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "settings.toml"


def book(file: Path | None, **at_once: Any) -> SettingsBook:
    return SettingsBook(file, dict, {f"terminal.{key}": do for key, do in at_once.items()})


@pytest.mark.parametrize("name", [each.name for each in catalogue()])
def test_every_setting_has_a_meaning(name: str) -> None:
    assert len(setting(name).meaning) > 10


def test_meanings_are_those_of_the_docstring() -> None:
    class Some:
        """Some class.

        Attributes:
            one: the first,
                in two lines.
            two, three: both of them.

        Raises:
            ValueError: never.
        """

    assert meanings_of(Some) == {
        "one": "the first, in two lines.",
        "two": "both of them.",
        "three": "both of them.",
    }


def test_a_setting_with_few_values_has_them_as_choices() -> None:
    assert setting("machine.armbasic").choices == ("true", "false")
    assert "latch" in setting("terminal.keys").choices
    assert setting("card.base").choices == ()


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("terminal.fps", "0"),
        ("terminal.fps", "many"),
        ("machine.ram", "17"),
        ("terminal.keys", "toes"),
        ("card.order", "1"),
        ("arm.model", "octopus"),
        ("arm.pad_friction", "nan"),
    ],
)
def test_what_cannot_be_is_refused_with_a_reason(name: str, text: str, file: Path) -> None:
    pages = book(file)
    assert pages.change(setting(name), text)
    assert not any(entry.changed for entry in pages.entries())


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("terminal.fps", "25"),
        ("terminal.theme", "nord"),
        ("machine.tapes", "tapes"),
        ("machine.armbasic", "false"),
        ("card.base", "0x80"),
        ("card.coil_bits", "[0, 1, 2, 3]"),
        ("driver.break_now", "true"),
        ("arm.pad_friction", "0.5"),
    ],
)
def test_what_was_changed_is_saved_when_asked_and_read_again(
    name: str, text: str, file: Path
) -> None:
    from trs80arm import settings

    pages = book(file)
    assert pages.change(setting(name), text) == ""
    assert not file.exists()
    assert pages.save() == f"Saved in {file}."
    table, _, key = name.partition(".")
    assert list(tomllib.loads(file.read_text())[table]) == [key]
    settings.load(file, environment={})
    assert pages.save() == "Nothing was changed that is not saved."


def test_who_can_takes_a_value_at_once(file: Path) -> None:
    taken: list[Any] = []
    assert book(file, speed=taken.append).change(setting("terminal.speed"), "5") == ""
    assert taken == [5]


def test_whoever_refuses_a_value_is_heard(file: Path) -> None:
    def refuse(value: str) -> None:
        raise ValueError(f"there is no theme {value}")

    pages = book(file, theme=refuse)
    assert pages.change(setting("terminal.theme"), "plaid") == "there is no theme plaid"
    assert not any(entry.changed for entry in pages.entries())


def test_words_are_searched_in_names_values_and_meanings(file: Path) -> None:
    names = [entry.setting.name for entry in book(file).entries("frames second")]
    assert names == ["terminal.fps"]


def test_without_a_file_nothing_is_saved(file: Path) -> None:
    pages = book(None)
    pages.change(setting("terminal.fps"), "25")
    assert "no settings file" in pages.save()


def test_a_file_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    pages = book(tmp_path)
    pages.change(setting("terminal.fps"), "25")
    assert pages.save().startswith("Not saved")
