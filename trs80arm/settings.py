"""The settings: one TOML file, the environment, and flags, each stronger than the one before.

The file has one table a room: `[terminal]`, `[machine]`, `[card]`, `[driver]`, `[arm]`, `[plug]`.
What a key may be is what the room's own settings class says, so that there is one truth. The
command line and the terminal program both come here; nothing of it knows Textual.
"""

from __future__ import annotations

import os
import typing
from collections.abc import Callable, Iterable, Mapping, MutableMapping
from dataclasses import dataclass, fields
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from platformdirs import user_config_path

from trs80arm.machine.typist import check_answer
from trs80arm.options import TerminalOptions, TerminalSettings
from trs80arm.plain_values import SettingsError as SettingsError
from trs80arm.plain_values import fit, keys_of
from trs80arm.reasons import reason
from trs80arm.saving import write_whole
from trs80arm.serial.limits import PlugSettings
from trs80arm.toml_files import TomlError, read_text, tables_of, what_is_wrong, with_plain_ends

if TYPE_CHECKING:
    from trs80arm.machine.z80.rom import Rom
    from trs80arm.rig import RigSettings

PREFIX = "TRS80ARM"
"""Environment variables are `TRS80ARM_SPEED` for the tables `[terminal]` and `[machine]`, and
`TRS80ARM_CARD_BASE` for a key of another table."""
SHORT = ("terminal", "machine")
"""The tables whose keys need not name their table in the environment and in `--option`."""
FILE_NAME = "settings.toml"
_KIND = "settings file"
_SEARCHED = 10_000_000
"""Characters of a file times its lines up to which a key's line is looked for, half a second."""
Source = Callable[[], str]
"""Says where a value came from; asked only when it cannot be, for finding the line takes time."""


@dataclass(frozen=True)
class MachineSettings:
    """The table `[machine]`.

    Attributes:
        ram: K of RAM: 4, 16, 32 or 48.
        memory_size: what is typed at MEMORY SIZE?
        armbasic: whether ARMBASIC is loaded.
        blocks: whether BASIC is compiled in blocks, or statement by statement.
        native: whether hot loops of numbers are made native code, where the extra `fast` is
            installed.
        ghosting: whether three keys at the corners of a rectangle show a fourth.
        tapes: the folder of the cassettes.
        printer: the file for the printer's paper.
        rom: a file with a Level II ROM of one's own, which then runs the machine on the Z-80.
    """

    ram: int = 16
    memory_size: str = ""
    armbasic: bool = True
    blocks: bool = True
    native: bool = True
    ghosting: bool = False
    tapes: Path | None = None
    printer: Path | None = None
    rom: Path | None = None

    def __post_init__(self) -> None:
        if self.ram not in (4, 16, 32, 48):
            raise ValueError(f"ram must be 4, 16, 32 or 48, not {self.ram}")
        check_answer(self.memory_size)


@dataclass(frozen=True)
class Settings:
    """Everything that is set, table by table."""

    terminal: TerminalSettings
    machine: MachineSettings
    card: Any
    driver: Any
    arm: Any
    plug: PlugSettings

    def rom(self) -> Rom | None:
        """The user's own ROM, if one is set.

        Raises:
            SettingsError: the file holds none or cannot be read, nothing here can run it, or there
                is no ARMBASIC for such a machine.
        """
        if self.machine.rom is None:
            return None
        from trs80arm.machine.z80.chip import NOT_INSTALLED, available
        from trs80arm.machine.z80.rom import Rom, RomError
        from trs80arm.works import rom_driver

        if not available():
            raise SettingsError(f"machine.rom: {NOT_INSTALLED}")
        try:
            if self.machine.armbasic:
                rom_driver.check(self.machine.ram, self.card)
            return Rom.read(self.machine.rom)
        except (RomError, rom_driver.DriverError) as error:
            raise SettingsError(f"machine.rom: {error}") from None
        except OSError as error:
            raise SettingsError(f"machine.rom: {self.machine.rom}: {reason(error)}") from None

    def rig(self) -> RigSettings:
        """The machine's fittings.

        Raises:
            SettingsError: its ROM cannot be used; `load` has looked at it before.
        """
        from trs80arm.rig import RigSettings

        machine = self.machine
        return RigSettings(
            ram_kib=machine.ram,
            memory_size=machine.memory_size,
            armbasic=machine.armbasic,
            blocks=machine.blocks,
            native=machine.native,
            ghosting=machine.ghosting,
            rom=self.rom(),
            tape_folder=machine.tapes,
            printer_file=machine.printer,
            card=self.card,
            driver=self.driver,
            arm=self.arm,
        )

    def options(self, path: Path | None = None, **more: Any) -> TerminalOptions:
        """How the terminal program is to start.

        Args:
            path: the settings file, where choices made in the program are remembered.
            more: the other fields of `TerminalOptions`.
        """
        chosen = {field.name: getattr(self.terminal, field.name) for field in fields(self.terminal)}
        return TerminalOptions(**chosen, rig=self.rig(), settings_file=path, **more)


def tables() -> dict[str, type]:
    """The settings class of each table. The rooms are imported here, not before."""
    from trs80arm.arm.settings import ArmSettings
    from trs80arm.machine.card import CardSettings
    from trs80arm.machine.driver import DriverSettings

    return {
        "terminal": TerminalSettings,
        "machine": MachineSettings,
        "card": CardSettings,
        "driver": DriverSettings,
        "arm": ArmSettings,
        "plug": PlugSettings,
    }


def default_path() -> Path:
    """The settings file: that of `TRS80ARM_CONFIG`, or the one in the platform's folder."""
    named = os.environ.get(f"{PREFIX}_CONFIG")
    return Path(named) if named else user_config_path("trs80arm", appauthor=False) / FILE_NAME


def load(
    path: Path | None = None,
    options: Iterable[str] = (),
    environment: Mapping[str, str] | None = None,
    defaults: Iterable[str] = (),
) -> Settings:
    """Read the settings.

    Args:
        path: the file; None takes the default one, which need not exist.
        options: flags, as `speed=5` or `card.base=0x98`; the strongest.
        environment: the environment's variables; None for the process's own.
        defaults: settings in the form of flags that the file and everything else overrule.

    Raises:
        SettingsError: something is set that is unknown or cannot be.
    """
    content, where = _read(path)
    values: dict[str, dict[str, Any]] = {name: {} for name in tables()}
    sources: dict[tuple[str, str], Source] = {}
    for name, key, text, source in _from_flags(defaults):
        values[name][key] = plain_value(text, name, key)
        sources[name, key] = partial(str, source)
    for name, table in _tables_of(content, where).items():
        for key, value in table.items():
            values[name][key] = value
            sources[name, key] = partial(_place, where, content, name, key)
    for name, key, text, source in (*_from_environment(environment), *_from_flags(options)):
        values[name][key] = plain_value(text, name, key)
        sources[name, key] = partial(str, source)
    made = {name: _checked(name, cls, values[name], sources) for name, cls in tables().items()}
    settings = Settings(**made)
    settings.rom()
    return settings


def _read(path: Path | None) -> tuple[str, Path]:
    where = path or default_path()
    try:
        return with_plain_ends(read_text(where, _KIND)), where
    except FileNotFoundError:
        if path is None:
            return "", where
        raise SettingsError(f"{where}: no such file") from None
    except TomlError as error:
        raise SettingsError(f"{where}: {error}") from None
    except OSError as error:
        raise SettingsError(f"{where}: {reason(error)}") from None


def _tables_of(content: str, where: Path) -> dict[str, dict[str, Any]]:
    try:
        parsed = tables_of(content)
    except TomlError as error:
        raise SettingsError(f"{where}: {error}") from None
    for name, table in parsed.items():
        if name not in tables():
            place = _place(where, content, None, name)
            raise SettingsError(f"{place}: unknown table; there are {', '.join(tables())}")
        if not isinstance(table, dict):
            raise SettingsError(f"{_place(where, content, None, name)}: must be a table, [{name}]")
    return parsed


def _from_environment(
    environment: Mapping[str, str] | None,
) -> list[tuple[str, str, str, str]]:
    variables = os.environ if environment is None else environment
    if not any(name.startswith(PREFIX) for name in variables):
        return []
    found = []
    for table, cls in tables().items():
        for field in fields(cls):
            short = f"{PREFIX}_{field.name.upper()}"
            long = f"{PREFIX}_{table.upper()}_{field.name.upper()}"
            for name in (long, short) if table in SHORT else (long,):
                if name in variables:
                    found.append((table, field.name, variables[name], name))
                    break
    return found


def _from_flags(options: Iterable[str]) -> list[tuple[str, str, str, str]]:
    found = []
    for option in options:
        name, equals, text = option.partition("=")
        if not equals:
            raise SettingsError(f"--option {option}: must be KEY=VALUE")
        table, dot, key = name.strip().rpartition(".")
        if not dot:
            holders = [table for table in SHORT if key in keys_of(tables()[table])]
            table = holders[0] if holders else SHORT[0]
        if table not in tables():
            raise SettingsError(
                f"--option {option}: unknown table {table}; there are {', '.join(tables())}"
            )
        found.append((table, key, text, f"--option {option}"))
    return found


def plain_value(text: str, table: str, key: str) -> Any:
    """What a flag or variable says: a TOML value if it is one, else the text itself.

    Of a key that wants a text or a path it is the text, whatever else it may look like: a folder
    can be called `1980`.
    """
    try:
        value = tables_of(f"value = {text}")["value"]
    except TomlError:
        return text
    hint = _hints(tables()[table]).get(key)
    wants_text = not {str, Path}.isdisjoint((hint, *typing.get_args(hint)))
    return text if wants_text and not isinstance(value, str) else value


_hints = cache(typing.get_type_hints)


def _checked(
    name: str, cls: type, values: dict[str, Any], sources: Mapping[tuple[str, str], Source]
) -> Any:
    built = {}
    for key, value in values.items():
        try:
            if key not in keys_of(cls):
                raise SettingsError(f"unknown key; there are {', '.join(sorted(keys_of(cls)))}")
            built[key] = fit(_hints(cls)[key], value)
            cls(**{key: built[key]})
        except (SettingsError, ValueError) as error:
            raise SettingsError(f"{sources[name, key]()}: {error}") from None
    try:
        return cls(**built)
    except ValueError as error:
        raise SettingsError(f"[{name}]: {error}") from None


def _place(where: Path, content: str, table: str | None, key: str) -> str:
    """`file: line N: table.key`: the line on which the key, or the table of that name, begins."""
    named = f"{table}.{key}" if table else key
    begin = 1
    lines = content.splitlines(keepends=True)
    if len(content) * len(lines) > _SEARCHED:
        return f"{where}: {named}"
    for end in range(1, len(lines) + 1):
        try:
            sofar: Any = tables_of("".join(lines[:end]))
        except TomlError:
            continue  # In the middle of a value of several lines.
        if table is not None:
            sofar = sofar.get(table)
        if isinstance(sofar, dict) and key in sofar:
            return f"{where}: line {begin}: {named}"
        begin = end + 1
    return f"{where}: {named}"


# -- remembering -----------------------------------------------------------------------------------


def remember(path: Path, key: str, value: Any, table: str = "terminal") -> None:
    """Set one key in the settings file; everything else in it stays as it is, comments too.

    Raises:
        SettingsError: the file is no settings file as it stands; it is then as before.
        OSError: the file cannot be read or written; it is then as before.
    """
    content = _content(path)
    changed = _with_entry(path, content, table, key, value)
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, changed.encode())


def forget(path: Path, key: str, table: str = "terminal") -> None:
    """Take one key out of the settings file, so that it has its default; the rest stays as it is.

    Raises:
        SettingsError: the file is no settings file as it stands; it is then as before.
        OSError: the file cannot be read or written; it is then as before.
    """
    content = _content(path)
    changed = _with_entry(path, content, table, key, None)
    if changed != content:
        write_whole(path, changed.encode())


def _content(path: Path) -> str:
    try:
        return read_text(path, _KIND)
    except FileNotFoundError:
        return ""
    except TomlError as error:
        raise SettingsError(f"{path}: {error}") from None


def _with_entry(path: Path, content: str, table: str, key: str, value: Any) -> str:
    """The content with the key set, or without it where the value is None."""
    # Nothing is written before the first frame.
    import tomlkit
    from tomlkit.exceptions import TOMLKitError

    try:
        document = tomlkit.parse(content)
        if not isinstance(document.get(table, {}), Mapping):
            raise SettingsError(f"{path}: {table} must be a table, [{table}]")
        if value is None:
            if table in document:
                cast(MutableMapping[str, Any], document[table]).pop(key, None)
        else:
            if table not in document:
                document[table] = tomlkit.table()
            cast(MutableMapping[str, Any], document[table])[key] = value
        changed = tomlkit.dumps(document)
    except (TOMLKitError, ValueError, RecursionError) as error:
        raise SettingsError(f"{path}: {what_is_wrong(error)}") from None
    if "\r\n" in content and "\n" not in content.replace("\r\n", ""):
        changed = changed.replace("\r\n", "\n").replace("\n", "\r\n")
    return changed
