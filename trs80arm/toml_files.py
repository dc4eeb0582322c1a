"""Files that people write in TOML: the settings, benches, scripts of runs.

They are read up to a length that no such file has, waiting for nobody, and what is wrong with one
is said in words about the file. What its tables mean is for whoever asked for it.
"""

from __future__ import annotations

import codecs
import tomllib
from pathlib import Path
from typing import Any

from trs80arm.paths import open_to_read

LARGEST = 1024 * 1024
"""Bytes of a file that are read."""


class TomlError(ValueError):
    """A file is no TOML; one line without the file's name."""


def read_text(path: Path, what: str) -> str:
    """The text of a file, not looked at; its line ends are as they are.

    Args:
        path: the file.
        what: it is to be: `bench`, `script`, for errors.

    Raises:
        TomlError: it is longer than any, or no text.
        OSError: it cannot be read.
    """
    try:
        with open_to_read(path) as file:
            data = file.read(LARGEST + 1)
    except ValueError:
        # A zero in the name.
        raise TomlError("no file can be called that") from None
    if len(data) > LARGEST:
        raise TomlError(f"longer than {LARGEST >> 20} MB, which no {what} is")
    try:
        # Some editors begin a file with a mark that says it is UTF-8.
        return data.removeprefix(codecs.BOM_UTF8).decode("utf-8")
    except UnicodeDecodeError:
        raise TomlError("not a text file in UTF-8") from None


def with_plain_ends(text: str) -> str:
    r"""The same text with lines that end in `\n`, whatever computer it comes from."""
    return text.replace("\r\n", "\n").replace("\r", "\n")


def tables_of(text: str) -> dict[str, Any]:
    """The tables that a text says.

    Raises:
        TomlError: it is no TOML.
    """
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise TomlError(what_is_wrong(error)) from None


def what_is_wrong(error: Exception) -> str:
    """What is wrong with a text, in one line, whichever reader of TOML says so."""
    if isinstance(error, RecursionError):
        return "nested too deeply"
    if type(error) is ValueError:
        # Python's own, of a number with more digits than it reads.
        return "a number has too many digits"
    # A line of the text may be quoted in the message.
    return " ".join(str(error).split())
